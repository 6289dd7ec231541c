// SPDX-License-Identifier: GPL-3.0-or-later

// The combinatorial curves of real meshes, as hashes that are equal for every compiler, CGAL and build type.
//
//   combinatorial_curves MESH_DIR TABLE              compares; prints what differs, and exits with 1 if anything does
//   combinatorial_curves MESH_DIR TABLE --update     writes the hashes of this build into the table
//   combinatorial_curves MESH                        prints the curves of one mesh
//
// The table has one line per mesh: file name, number of curves, hash.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;

typedef std::uint32_t Vertex;
typedef std::pair<Vertex, Vertex> Node; // a crossed halfedge from source to target, or a pivot twice
typedef std::vector<Node> Curve;

// The rotation of a cyclic sequence that is the smallest in lexicographic order.
Curve smallest_rotation(const Curve& curve)
{
  const Node smallest = *std::min_element(curve.begin(), curve.end());
  Curve result = curve;
  for(std::size_t i = 0; i < curve.size(); ++i)
    if(curve[i] == smallest)
    {
      Curve rotated = curve;
      std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(i), rotated.end());
      result = std::min(result, rotated);
    }
  return result;
}

// Equal for equal curves, wherever they start and in whichever direction they run.
Curve canonical(const Curve& curve)
{
  Curve reversed(curve.rbegin(), curve.rend());
  for(Node& n : reversed)
    std::swap(n.first, n.second);
  return std::min(smallest_rotation(curve), smallest_rotation(reversed));
}

// The curves of the default call, in lexicographic order. Throws std::runtime_error if the file cannot be read.
std::vector<Curve> combinatorial_curves(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(constrictions));

  std::vector<Curve> result;
  for(const Constriction& c : constrictions)
  {
    Curve curve;
    for(const Constriction::Location& l : c.locations())
      if(l.is_pivot)
        curve.emplace_back(l.vertex, l.vertex);
      else
        curve.emplace_back(source(l.halfedge, mesh), target(l.halfedge, mesh));
    result.push_back(canonical(curve));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// FNV-1a, over four bytes of each vertex and a separator after each curve.
std::string hash(const std::vector<Curve>& curves)
{
  std::uint64_t h = 14695981039346656037u;
  const auto add = [&h](Vertex v) {
    for(int shift = 0; shift < 32; shift += 8)
    {
      h ^= (v >> shift) & 255u;
      h *= 1099511628211u;
    }
  };
  for(const Curve& c : curves)
  {
    for(const Node& n : c)
    {
      add(n.first);
      add(n.second);
    }
    add(~Vertex(0));
  }
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << h;
  return text.str();
}

void print(const std::vector<Curve>& curves)
{
  for(const Curve& c : curves)
  {
    for(const Node& n : c)
      if(n.first == n.second)
        std::cout << n.first << ' ';
      else
        std::cout << n.first << '-' << n.second << ' ';
    std::cout << '\n';
  }
}

std::string table_line(const std::string& mesh_dir, const std::string& name)
{
  const std::vector<Curve> curves = combinatorial_curves(mesh_dir + "/" + name);
  return name + " " + std::to_string(curves.size()) + " " + hash(curves);
}

// The number of lines that differ. Throws std::runtime_error for a table that is missing or empty, and for a file that
// cannot be read or written.
int compare_or_update(const std::string& mesh_dir, const std::string& table, bool update)
{
  std::ifstream in(table);
  std::string line, comments, made;
  int compared = 0, different = 0;
  while(std::getline(in, line))
  {
    if(line.empty() || line[0] == '#')
    {
      comments += line + "\n";
      continue;
    }
    const std::string here = table_line(mesh_dir, line.substr(0, line.find(' ')));
    made += here + "\n";
    ++compared;
    if(here != line)
    {
      ++different;
      std::cout << "table: " << line << "\nhere:  " << here << std::endl;
    }
  }
  if(compared == 0)
    throw std::runtime_error("no meshes in " + table);
  std::cout << compared - different << " of " << compared << " meshes have the curves of the table" << std::endl;
  if(!update)
    return different;
  in.close();
  std::ofstream out(table);
  if(!(out << comments << made << std::flush))
    throw std::runtime_error("cannot write " + table);
  return 0;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool updates = arguments.size() == 3 && arguments[2] == "--update";
  try
  {
    if(arguments.size() == 1)
      print(combinatorial_curves(arguments[0]));
    else if(arguments.size() == 2 || updates)
      return compare_or_update(arguments[0], arguments[1], updates) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    else
    {
      std::cerr << "usage: " << argv[0] << " MESH | MESH_DIR TABLE [--update]" << std::endl;
      return 2;
    }
  }
  catch(const std::exception& e)
  {
    std::cerr << argv[0] << ": " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
