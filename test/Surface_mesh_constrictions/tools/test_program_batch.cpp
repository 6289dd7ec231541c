// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"
#include "include/sanitizers.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test_program_batch {

namespace fs = std::filesystem;
using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Program;
using program_fixture::Result;
using program_fixture::tetrahedron;

// What depends on the machine is taken out.
json without_costs(json line)
{
  EXPECT_GE(line.at("seconds").get<double>(), 0);
  EXPECT_GT(line.at("peak_rss_bytes").get<double>(), 0);
  line.erase("seconds");
  line.erase("peak_rss_bytes");
  return line;
}

class Batch : public Program
{
protected:
  // Good and broken meshes in the folder `meshes`.
  Batch()
  {
    fs::create_directory(folder / "meshes");
    write("meshes/a dumbbell.off", dumbbell().off());
    write("meshes/tetrahedron.OFF", tetrahedron);
    write("meshes/touching.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
    write("meshes/not a mesh.ply", "no mesh");
    write("meshes/empty.stl", "");
    write("meshes/readme.txt", "not a mesh, and not meant as one");
    fs::create_directory(folder / "meshes" / "folder.off");
  }

  // The lines of a text by file; there is one for each.
  std::map<std::string, json> lines_of(const std::string& text) const
  {
    std::map<std::string, json> result;
    EXPECT_TRUE(text.empty() || text.back() == '\n') << text;
    std::istringstream in(text);
    for(std::string line; std::getline(in, line);)
    {
      const json j = json::parse(line);
      EXPECT_EQ(j.at("format"), "constrictions-batch/1");
      EXPECT_TRUE(result.emplace(j.at("file"), without_costs(j)).second) << line;
    }
    return result;
  }

  std::map<std::string, json> lines(const std::string& file = "out/results.jsonl") const
  {
    return lines_of(content(file));
  }

  // Whether the table at the end has a row that begins with a number after these words.
  static bool has_row(const std::string& table, const std::string& words, int number)
  {
    return std::regex_search(table, std::regex("(^|\n)" + words + " +" + std::to_string(number) + "(\n| )"));
  }

  // Meshes of a line each, the second of which waits until somebody writes into a pipe.
  void make_waiting_list()
  {
    write("first.off", dumbbell().off());
    write("third.off", tetrahedron);
    ASSERT_EQ(mkfifo((folder / "second.off").c_str(), 0600), 0);
    write("list.txt", "first.off\nsecond.off\nthird.off\n");
  }

  // Starts the program in the folder.
  pid_t start(const std::vector<std::string>& arguments) const
  {
    const pid_t process = fork();
    if(process == 0)
    {
      std::vector<char*> argv = {const_cast<char*>(CONSTRICTIONS_PROGRAM)};
      for(const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
      argv.push_back(nullptr);
      // these tests may run where SIGINT is ignored, in the background of a shell, and the program would keep to that
      for(int signal : {SIGINT, SIGTERM})
        std::signal(signal, SIG_DFL);
      if(chdir(folder.c_str()) == 0)
        execv(CONSTRICTIONS_PROGRAM, argv.data());
      _exit(127);
    }
    return process;
  }

  // Polls, for half a minute at most.
  static bool becomes_true(const std::function<bool()>& condition)
  {
    for(int i = 0; i < 3000; ++i)
    {
      if(condition())
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  static int status_of(pid_t process)
  {
    int status = 0;
    EXPECT_EQ(waitpid(process, &status, 0), process);
    return status;
  }

  static std::vector<pid_t> children_of(pid_t process)
  {
    std::ifstream in("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
    return std::vector<pid_t>(std::istream_iterator<pid_t>(in), {});
  }

  // Whoever takes over the children of a process that was killed need not ask for their ends at once.
  static bool has_ended(pid_t process)
  {
    std::ifstream in("/proc/" + std::to_string(process) + "/stat");
    std::string stat;
    std::getline(in, stat);
    return stat.empty() || stat.find(") Z ") != std::string::npos;
  }

  // The only child of a batch that has got as far as the pipe of the list.
  pid_t waiting_child(pid_t batch) const
  {
    pid_t child = 0;
    EXPECT_TRUE(becomes_true([&] {
      if(content("out/results.jsonl").find('\n') == std::string::npos)
        return false; // the first mesh is not done
      const std::vector<pid_t> children = children_of(batch);
      if(children.size() == 1)
        child = children.front();
      return child != 0;
    }));
    return child;
  }

  void expect_resumed() const
  {
    fs::remove(folder / "second.off");
    write("second.off", dumbbell().off());
    const Result r = run("batch list.txt -o out");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    ASSERT_EQ(run("batch list.txt -o whole").exit_code, 0);
    const auto whole = lines("whole/results.jsonl");
    EXPECT_EQ(whole.size(), 3u);
    EXPECT_EQ(lines(), whole);
  }
};

TEST_F(Batch, each_mesh_of_a_folder_has_a_line)
{
  const Result r = run("batch meshes -o out");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, "");
  const auto found = lines();
  ASSERT_EQ(found.size(), 5u);

  const json& good = found.at("meshes/a dumbbell.off");
  EXPECT_EQ(good.at("status"), "ok");
  json expected = json::parse(run("detect 'meshes/a dumbbell.off' --json -").out);
  expected["mesh"].erase("file");
  for(json& c : expected["constrictions"])
    for(const char* member : {"points", "locations", "pivots", "seed"})
      c.erase(member);
  EXPECT_EQ(expected["constrictions"].size(), 1u);
  for(const char* member : {"mesh", "constrictions", "statistics"})
    EXPECT_EQ(good.at(member), expected.at(member)) << member;
  EXPECT_EQ(found.at("meshes/tetrahedron.OFF").at("constrictions"), json::array());

  EXPECT_EQ(found.at("meshes/touching.off").at("status"), "ok"); // the vertex is split
  for(const char* file : {"meshes/not a mesh.ply", "meshes/empty.stl"})
  {
    const json& failed = found.at(file);
    EXPECT_EQ(failed.at("status"), "failed");
    EXPECT_EQ(failed.at("kind"), "input");
    EXPECT_EQ("constrictions: " + failed.at("error").get<std::string>() + '\n',
              run("detect '" + std::string(file) + "'").err);
  }
  EXPECT_TRUE(has_row(r.out, "meshes", 5)) << r.out;
  EXPECT_TRUE(has_row(r.out, "ok", 3)) << r.out;
  EXPECT_TRUE(has_row(r.out, "failed", 2)) << r.out;
  EXPECT_TRUE(has_row(r.out, "  input", 2)) << r.out;
  EXPECT_NE(r.out.find("1 constriction, 1 certified"), std::string::npos) << r.out;
}

TEST_F(Batch, lines_do_not_depend_on_the_order)
{
  run("batch meshes -o out -j 1");
  const auto expected = lines();
  EXPECT_EQ(expected.size(), 5u);
  EXPECT_EQ(run("batch meshes -o many -j 8").exit_code, 0);
  EXPECT_EQ(lines("many/results.jsonl"), expected);
  const Result printed = run("batch meshes/empty.stl meshes -j 2");
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(lines_of(printed.out), expected);
}

TEST_F(Batch, names_in_a_list)
{
  const std::string awkward = "'\"$HOME\" `;\\ \xc3\xa4\t*.off", not_utf8 = "b\xff.off", also_not_utf8 = "b\xfe.off";
  for(const std::string& name : {awkward, not_utf8, also_not_utf8})
    write(name, tetrahedron);
  write("a\nb.off", tetrahedron);
  write("list", awkward + "\r\n\n" + not_utf8 + "\nmissing.off\nmeshes\n" + also_not_utf8 + '\n' + awkward);
  EXPECT_EQ(run("batch list 'a\nb.off' -o out").exit_code, 0);
  const std::string text = content("out/results.jsonl");
  std::multiset<std::string> kinds;
  std::set<std::string> files;
  std::istringstream in(text);
  for(std::string line; std::getline(in, line);)
  {
    const json j = json::parse(line);
    kinds.insert(j.at("status") == "ok" ? "ok" : j.at("kind").get<std::string>());
    std::string file = j.at("file").get<std::string>();
    if(j.contains("file_bytes"))
    {
      const auto bytes = j.at("file_bytes").get<std::vector<unsigned char>>();
      file.assign(bytes.begin(), bytes.end());
    }
    files.insert(file);
    if(file == "missing.off")
    {
      EXPECT_EQ(j.at("error"), "missing.off: no such file");
    }
  }
  EXPECT_EQ(files, (std::set<std::string>{awkward, not_utf8, also_not_utf8, "a\nb.off", "missing.off", "meshes"}));
  EXPECT_EQ(kinds, (std::multiset<std::string>{"ok", "ok", "ok", "ok", "input", "input"}));
  // all are known again
  EXPECT_EQ(run("batch list 'a\nb.off' -o out").exit_code, 0);
  EXPECT_EQ(content("out/results.jsonl"), text);
}

TEST_F(Batch, list_from_standard_input)
{
  write("list.txt", "tetrahedron.off\ndumbbell.off\n");
  const std::string command =
      "cd '" + folder.string() + "' && '" CONSTRICTIONS_PROGRAM "' batch - -o out < list.txt > printed.txt";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(lines().size(), 2u);
}

TEST_F(Batch, options_of_the_detection)
{
  write("list.txt", "dumbbell.off\n");
  const auto constrictions = [&](const std::string& options) {
    return lines_of(run("batch list.txt " + options).out).at("dumbbell.off").at("constrictions");
  };
  EXPECT_EQ(constrictions("--max 0").size(), 0u);
  EXPECT_EQ(constrictions("--min-prominence 100").size(), 0u);
  EXPECT_EQ(constrictions("--max-ratio 0.0001").size(), 0u);
  EXPECT_EQ(constrictions("--seeds triangles --policy lt").size(), 1u);
  EXPECT_EQ(constrictions("--all --no-certify")[0].at("certificate").get<std::string>().rfind("not_certified", 0), 0u);
}

TEST_F(Batch, limit_of_time)
{
  make_waiting_list();
  // and one that computes for long
  Cubes large;
  large.add_box({0, 0, 0}, {300, 300, 1});
  write("large.off", large.off());
  const Result r = run("batch list.txt large.off -o out -j 4 --time-limit 0.5");
  EXPECT_EQ(r.exit_code, 0);
  const auto found = lines();
  ASSERT_EQ(found.size(), 4u);
  for(const char* file : {"second.off", "large.off"})
  {
    const json& late = found.at(file);
    EXPECT_EQ(late.at("kind"), "time") << late;
    EXPECT_EQ(late.at("error"), file + std::string(": not finished within 0.5 seconds"));
  }
  EXPECT_NE(r.out.find("\n  time "), std::string::npos) << r.out;
}

TEST_F(Batch, limit_of_memory)
{
  if(sanitizers::are_on)
    GTEST_SKIP() << "AddressSanitizer needs more memory than the limit";
  Cubes large;
  large.add_box({0, 0, 0}, {300, 300, 1});
  write("large.off", large.off());
  EXPECT_EQ(run("batch large.off dumbbell.off -o out --memory-limit 100MB").exit_code, 0);
  const auto found = lines();
  EXPECT_EQ(found.at("large.off").at("kind"), "memory") << found.at("large.off");
  EXPECT_EQ(found.at("large.off").at("error"), "large.off: not enough memory");
  EXPECT_EQ(found.at("dumbbell.off").at("status"), "ok") << found.at("dumbbell.off");
}

TEST_F(Batch, crash_of_a_process)
{
  make_waiting_list();
  const pid_t batch = start({"batch", "list.txt", "-o", "out", "-j", "1", "--quiet", "--time-limit", "60"});
  const pid_t child = waiting_child(batch);
  ASSERT_NE(child, 0);
  kill(child, SIGABRT); // not SIGSEGV, which AddressSanitizer catches
  const int status = status_of(batch);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  const auto found = lines();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found.at("second.off").at("kind"), "crash");
  EXPECT_NE(found.at("second.off").at("error").get<std::string>().find("signal 6"), std::string::npos);
  EXPECT_EQ(found.at("third.off").at("status"), "ok");
}

TEST_F(Batch, killed_and_resumed)
{
  make_waiting_list();
  const pid_t batch = start({"batch", "list.txt", "-o", "out", "-j", "1", "--quiet", "--time-limit", "60"});
  const pid_t child = waiting_child(batch);
  ASSERT_NE(child, 0);
  // nobody writes to the same file meanwhile
  const Result second = run("batch list.txt -o out");
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_EQ(second.err, "constrictions: out/results.jsonl: another process is writing to it\n");

  kill(batch, SIGKILL);
  EXPECT_EQ(WTERMSIG(status_of(batch)), SIGKILL);
  EXPECT_EQ(lines().size(), 1u);
  expect_resumed(); // at once
  EXPECT_TRUE(becomes_true([&] { return has_ended(child); }));
}

TEST_F(Batch, interrupted_and_resumed)
{
  for(int signal : {SIGINT, SIGTERM})
  {
    for(const char* name : {"out", "whole", "second.off"})
      fs::remove_all(folder / name);
    make_waiting_list();
    const pid_t batch = start({"batch", "list.txt", "-o", "out", "-j", "1", "--quiet", "--time-limit", "60"});
    const pid_t child = waiting_child(batch);
    ASSERT_NE(child, 0);
    // as from a terminal, to both
    kill(child, signal);
    kill(batch, signal);
    const int status = status_of(batch);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    EXPECT_TRUE(has_ended(child));
    EXPECT_EQ(lines().size(), 1u);
    expect_resumed();
  }
}

TEST_F(Batch, half_written_line)
{
  ASSERT_EQ(run("batch meshes -o out -j 1").exit_code, 0);
  const std::string whole = content("out/results.jsonl");
  const auto expected = lines();
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for(std::size_t length : {whole.size() - 1, (last + whole.size()) / 2, last + 1, last, std::size_t(10)})
  {
    write("out/results.jsonl", whole.substr(0, length));
    EXPECT_EQ(run("batch meshes -o out").exit_code, 0);
    EXPECT_EQ(lines(), expected) << length;
    const std::size_t kept = length >= last ? last : 0;
    EXPECT_EQ(content("out/results.jsonl").substr(0, kept), whole.substr(0, kept));
  }
}

TEST_F(Batch, complete_results_stay)
{
  ASSERT_EQ(run("batch meshes -o out").exit_code, 0);
  const std::string before = content("out/results.jsonl");
  const Result r = run("batch meshes -o out");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(content("out/results.jsonl"), before);
  EXPECT_TRUE(has_row(r.out, "meshes", 5)) << r.out;
  EXPECT_EQ(run("batch meshes -o out --quiet").out, "");
}

TEST_F(Batch, slices_add_up)
{
  ASSERT_EQ(run("batch meshes -o whole").exit_code, 0);
  std::string text;
  for(const char* slice : {"3/3", "1/3", "2/3"})
  {
    EXPECT_EQ(run(std::string("batch meshes -o out --slice ") + slice).exit_code, 0);
    text += content(std::string("out/results.") + slice[0] + "-of-3.jsonl");
  }
  EXPECT_EQ(lines_of(text), lines("whole/results.jsonl"));
  // the whole finds the lines of the slices, and does what is missing
  EXPECT_TRUE(has_row(run("batch meshes -o out").out, "meshes", 5));
  EXPECT_EQ(content("out/results.jsonl"), "");
  fs::remove(folder / "out/results.2-of-3.jsonl");
  EXPECT_TRUE(has_row(run("batch meshes -o out").out, "meshes", 5));
  EXPECT_EQ(lines().size(), 2u);
}

TEST_F(Batch, results_are_of_the_same_settings)
{
  write("list.txt", "dumbbell.off\n");
  ASSERT_EQ(run("batch list.txt -o out --max 3").exit_code, 0);
  expect_failure(1, "batch list.txt -o out", {"out/settings.json: ", "other settings", "max was 3, not null"});
  EXPECT_EQ(run("batch list.txt -o out --max 3 --time-limit 5 -j 1").exit_code, 0);
}

TEST_F(Batch, unusable_inputs)
{
  write("empty.txt", "");
  write("blank.txt", "\n\r\n\n");
  write("binary", std::string("a\0b", 3));
  fs::create_directory(folder / "nothing");
  expect_failure(1, "batch empty.txt -o out", {"empty.txt: the list of meshes is empty"});
  expect_failure(1, "batch blank.txt", {"blank.txt: the list of meshes is empty"});
  expect_failure(1, "batch - -o out", {"standard input: the list of meshes is empty"});
  expect_failure(1, "batch binary", {"binary: is not a list of meshes"});
  expect_failure(1, "batch missing.txt -o out", {"missing.txt: no such file"});
  expect_failure(1, "batch nothing -o out",
                 {"nothing: there is no OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF file in the folder"});
}

TEST_F(Batch, unusable_outputs)
{
  write("file", "");
  expect_failure(3, "batch meshes -o file", {"file: "});
  fs::create_directories(folder / "taken/results.jsonl");
  EXPECT_EQ(run("batch meshes -o taken").exit_code, 3);
  fs::create_directory(folder / "other");
  write("other/results.jsonl", "{\"file\": \"a\"}\n");
  EXPECT_EQ(run("batch meshes -o other").err,
            "constrictions: other/results.jsonl: line 1 is not in the format constrictions-batch/1\n");
  EXPECT_EQ(content("other/results.jsonl"), "{\"file\": \"a\"}\n");
  if(!fs::exists("/dev/full"))
    return;
  EXPECT_EQ(run("batch meshes", "/dev/full").exit_code, 3);
}

TEST_F(Batch, wrong_usage)
{
  for(const char* arguments :
      {"batch", "batch -o out", "batch meshes -o ''", "batch ''", "batch meshes -j 0", "batch meshes -j two",
       "batch meshes --time-limit 0", "batch meshes --time-limit -1", "batch meshes --time-limit nan",
       "batch meshes --memory-limit 0", "batch meshes --memory-limit much", "batch meshes --slice 0/3",
       "batch meshes --slice 4/3", "batch meshes --slice 1", "batch meshes --slice 1/3/5", "batch meshes --slice 1/",
       "batch meshes --near 1,2,3", "batch meshes --json a.json", "batch meshes --policy best"})
    expect_wrong_usage(arguments);
}

} // namespace test_program_batch
