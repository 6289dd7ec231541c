// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PROGRAM_FIXTURE_H
#define PROGRAM_FIXTURE_H

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

// For tests of the program as a whole: a folder of its own for each test, and meshes that are checked by hand.
namespace program_fixture {

namespace fs = std::filesystem;

typedef std::array<int, 3> Grid_point;

// The boundary of a set of unit cubes as OFF, each square cut into two triangles. The cubes that share a vertex must
// share faces around it.
class Cubes
{
public:
  void add_box(const Grid_point& low, const Grid_point& high)
  {
    for(int x = low[0]; x < high[0]; ++x)
      for(int y = low[1]; y < high[1]; ++y)
        for(int z = low[2]; z < high[2]; ++z)
          m_cubes.insert({x, y, z});
  }

  std::string off()
  {
    return off([](const Grid_point& p) { return p; });
  }

  // With the points that place(p) says.
  template <class Place>
  std::string off(const Place& place)
  {
    for(const Grid_point& cube : m_cubes)
      for(int axis = 0; axis < 3; ++axis)
        for(int direction : {-1, 1})
          add_side(cube, axis, direction);
    std::ostringstream out;
    out << "OFF\n" << m_points.size() << ' ' << m_triangles.size() << " 0\n";
    out.precision(17);
    for(const Grid_point& p : m_points)
    {
      const auto q = place(p);
      out << q[0] << ' ' << q[1] << ' ' << q[2] << '\n';
    }
    for(const Grid_point& t : m_triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    return out.str();
  }

  int vertex(const Grid_point& p)
  {
    const auto inserted = m_numbers.insert({p, static_cast<int>(m_points.size())});
    if(inserted.second)
      m_points.push_back(p);
    return inserted.first->second;
  }

private:
  static Grid_point moved(Grid_point p, int axis, int by)
  {
    p[static_cast<std::size_t>(axis % 3)] += by;
    return p;
  }

  void add_side(const Grid_point& cube, int axis, int direction)
  {
    if(m_cubes.count(moved(cube, axis, direction)) != 0)
      return;
    // counterclockwise seen from outside
    const int u = direction == 1 ? axis + 1 : axis + 2, v = direction == 1 ? axis + 2 : axis + 1;
    const Grid_point p = direction == 1 ? moved(cube, axis, 1) : cube;
    const int a = vertex(p), b = vertex(moved(p, u, 1)), c = vertex(moved(moved(p, u, 1), v, 1)),
              d = vertex(moved(p, v, 1));
    m_triangles.push_back({a, b, c});
    m_triangles.push_back({a, c, d});
  }

  std::set<Grid_point> m_cubes;
  std::map<Grid_point, int> m_numbers;
  std::vector<Grid_point> m_points, m_triangles;
};

// Two cubes of edge length 3 joined by a tube of width 1 and length 2: one constriction, of length 4.
inline Cubes dumbbell()
{
  Cubes cubes;
  cubes.add_box({0, 0, 0}, {3, 3, 3});
  cubes.add_box({3, 1, 1}, {5, 2, 2});
  cubes.add_box({5, 0, 0}, {8, 3, 3});
  return cubes;
}

const char* const tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

struct Result
{
  int exit_code;
  std::string out, err;
};

class Program : public testing::Test
{
protected:
  Program()
  {
    std::string name = testing::TempDir() + "program_XXXXXX";
    folder = mkdtemp(&name[0]);
    write("dumbbell.off", dumbbell().off());
    write("tetrahedron.off", tetrahedron);
  }

  ~Program() override
  {
    std::error_code error;
    fs::permissions(folder / "closed", fs::perms::owner_all, error);
    fs::remove_all(folder, error);
  }

  void write(const std::string& name, const std::string& content) const
  {
    std::ofstream(folder / name, std::ios::binary) << content;
  }

  std::string content(const fs::path& name) const
  {
    std::ostringstream result;
    result << std::ifstream(folder / name, std::ios::binary).rdbuf();
    return result.str();
  }

  // Runs the program in the folder; the standard output goes to `out_file`.
  Result run(const std::string& arguments, const std::string& out_file = "stdout.txt") const
  {
    const std::string command = "cd '" + folder.string() + "' && '" CONSTRICTIONS_PROGRAM "' " + arguments + " > " +
                                out_file + " 2> stderr.txt < /dev/null";
    const int status = std::system(command.c_str());
    Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content("stdout.txt"), content("stderr.txt")};
    fs::remove(folder / "stdout.txt");
    fs::remove(folder / "stderr.txt");
    return result;
  }

  // As above, but the standard error output is a terminal.
  Result run_in_terminal(const std::string& arguments) const
  {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_TRUE(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    const std::string name = ptsname(terminal);
    const int other_end = open(name.c_str(), O_RDWR | O_NOCTTY); // without one that is open reading fails
    std::string shown;
    std::thread reader([&] {
      char c;
      while(read(terminal, &c, 1) == 1)
        if(c != '\r')
          shown += c;
    });
    const std::string command = "cd '" + folder.string() + "' && '" CONSTRICTIONS_PROGRAM "' " + arguments +
                                " > stdout.txt 2> " + name + " < /dev/null";
    const int status = std::system(command.c_str());
    close(other_end);
    reader.join();
    close(terminal);
    const Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content("stdout.txt"), shown};
    fs::remove(folder / "stdout.txt");
    return result;
  }

  // The program ends with this code, one line on the standard error output that holds `parts`, and leaves no file.
  void expect_failure(int exit_code, const std::string& arguments, const std::vector<std::string>& parts) const
  {
    SCOPED_TRACE(arguments);
    const std::set<fs::path> before = files();
    const Result r = run(arguments);
    EXPECT_EQ(r.exit_code, exit_code);
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(r.err.rfind("constrictions: ", 0), 0u) << r.err;
    for(const std::string& part : parts)
      EXPECT_NE(r.err.find(part), std::string::npos) << part << " in: " << r.err;
    EXPECT_EQ(files(), before);
  }

  void expect_wrong_usage(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    const std::set<fs::path> before = files();
    const Result r = run(arguments);
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(r.err.rfind("constrictions: ", 0), 0u) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
    EXPECT_EQ(files(), before);
  }

  std::set<fs::path> files() const
  {
    std::set<fs::path> result;
    for(const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      result.insert(entry.path().lexically_relative(folder));
    return result;
  }

  fs::path folder;
};

} // namespace program_fixture

#endif // PROGRAM_FIXTURE_H
