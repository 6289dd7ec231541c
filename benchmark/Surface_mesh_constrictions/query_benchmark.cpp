// SPDX-License-Identifier: GPL-3.0-or-later

// What it costs to prepare a mesh, and what each query of the prepared object costs: medians and maxima of 100 random
// places. A row of a table for each line that is printed, for each mesh file that is named on the command line.

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = SMC::parameters;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef SMC::Constriction_query<Mesh> Query;
typedef std::vector<Mesh::Vertex_index> Loop;

constexpr std::size_t number_of_places = 100, number_of_edges = 100;

std::size_t resident_bytes()
{
  malloc_trim(0);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

template <class Run>
double seconds(const Run& run)
{
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void print(const std::string& what, double value, const std::string& unit)
{
  std::cout << "| " << what << " | " << value << " " << unit << " | |" << std::endl;
}

// Of the times that run(i) takes for each place.
template <class Run>
void print_times(const std::string& what, const Run& run)
{
  std::vector<double> times;
  for(std::size_t i = 0; i < number_of_places; ++i)
    times.push_back(1000 * seconds([&] { run(i); }));
  std::sort(times.begin(), times.end());
  std::cout << "| " << what << " | " << times[times.size() / 2] << " ms | " << times.back() << " ms |" << std::endl;
}

// Points inside random faces.
std::vector<Mesh::Point> random_places(const Mesh& mesh, std::mt19937& random)
{
  std::vector<Mesh::Point> result;
  for(std::size_t i = 0; i < number_of_places; ++i)
  {
    const Mesh::Face_index f(static_cast<Mesh::size_type>(random() % mesh.number_of_faces()));
    double b[3], sum = 0;
    for(double& x : b)
      sum += x = 1 + static_cast<double>(random() % 1000);
    CGAL::Vector_3<CGAL::Exact_predicates_inexact_constructions_kernel> at(0, 0, 0);
    std::size_t k = 0;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      at = at + b[k++] / sum * (mesh.point(v) - CGAL::ORIGIN);
    result.push_back(CGAL::ORIGIN + at);
  }
  return result;
}

// The vertices that are so many edges away from one, or fewer, with the vertex before each on the way there.
std::map<Mesh::Vertex_index, std::pair<std::size_t, Mesh::Vertex_index>> ball(const Mesh& mesh, Mesh::Vertex_index v,
                                                                              std::size_t edges)
{
  std::map<Mesh::Vertex_index, std::pair<std::size_t, Mesh::Vertex_index>> result;
  std::vector<Mesh::Vertex_index> queue(1, v);
  result[v] = {0, v};
  for(std::size_t i = 0; i < queue.size() && result[queue[i]].first < edges; ++i)
    for(Mesh::Vertex_index w : mesh.vertices_around_target(mesh.halfedge(queue[i])))
      if(result.emplace(w, std::make_pair(result[queue[i]].first + 1, queue[i])).second)
        queue.push_back(w);
  return result;
}

// A triangle of three shortest paths of edges, of a third of the edges each, at a random vertex.
Loop random_loop(const Mesh& mesh, std::mt19937& random)
{
  const std::size_t side = number_of_edges / 3;
  for(;;)
  {
    const Mesh::Vertex_index a(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices()));
    const auto from_a = ball(mesh, a, side);
    std::vector<Mesh::Vertex_index> ring;
    for(const auto& [v, way] : from_a)
      if(way.first == side)
        ring.push_back(v);
    if(ring.empty())
      continue;
    const Mesh::Vertex_index b = ring[random() % ring.size()];
    const auto from_b = ball(mesh, b, side);
    std::vector<Mesh::Vertex_index> both;
    for(Mesh::Vertex_index v : ring)
    {
      const auto way = from_b.find(v);
      if(way != from_b.end() && way->second.first == side)
        both.push_back(v);
    }
    if(both.empty())
      continue;
    const Mesh::Vertex_index c = both[random() % both.size()];
    Loop loop;
    for(Mesh::Vertex_index v = c; v != b; v = from_b.at(v).second)
      loop.push_back(v);
    for(Mesh::Vertex_index v = b; v != a; v = from_a.at(v).second)
      loop.push_back(v);
    Loop last;
    for(Mesh::Vertex_index v = from_a.at(c).second; v != a; v = from_a.at(v).second)
      last.push_back(v);
    loop.push_back(a);
    loop.insert(loop.end(), last.rbegin(), last.rend());
    return loop;
  }
}

void measure(const Mesh& mesh)
{
  std::vector<SMC::Constriction<Mesh>> detected;
  print("`detect_constrictions()`", seconds([&] { SMC::detect_constrictions(mesh, std::back_inserter(detected)); }),
        "s");

  const std::size_t before = resident_bytes();
  std::unique_ptr<Query> query;
  print("prepare", seconds([&] { query = std::make_unique<Query>(mesh); }), "s");
  print("memory of the object",
        static_cast<double>(resident_bytes() - before) / static_cast<double>(mesh.number_of_faces()), "bytes a face");
  {
    std::stringstream file;
    print("write into memory", seconds([&] { query->write(file); }), "s");
    print("size of the file", static_cast<double>(file.tellp()) / static_cast<double>(mesh.number_of_faces()),
          "bytes a face");
    print("read from memory", seconds([&] { Query read(mesh, file); }), "s");
  }

  std::mt19937 random(1);
  const std::vector<Mesh::Point> places = random_places(mesh, random);
  std::vector<Loop> loops;
  for(std::size_t i = 0; i < number_of_places; ++i)
    loops.push_back(random_loop(mesh, random));
  std::vector<SMC::Constriction<Mesh>> near;
  print_times("near, the first", [&](std::size_t i) {
    query->constrictions_near(places[i], std::back_inserter(near),
                              params::maximum_number_of_constrictions(std::size_t(1)));
  });
  print("places with a constriction", static_cast<double>(near.size()), "");
  near.clear();
  print_times("near, all", [&](std::size_t i) { query->constrictions_near(places[i], std::back_inserter(near)); });
  print("constrictions near them", static_cast<double>(near.size()), "");
  std::size_t held = 0;
  print_times("girth", [&](std::size_t i) { held += query->girth(places[i]).has_value(); });
  print("places with a girth", static_cast<double>(held), "");
  print_times("tighten a loop of 100 edges", [&](std::size_t i) { query->tighten(loops[i]); });
  print_times("loop through three places", [&](std::size_t i) {
    query->loop_through(
        std::vector<Mesh::Point>{places[i], places[(i + 1) % places.size()], places[(i + 2) % places.size()]});
  });
  print("memory after these queries",
        static_cast<double>(resident_bytes() - before) / static_cast<double>(mesh.number_of_faces()), "bytes a face");

  std::vector<SMC::Constriction<Mesh>> found;
  print("the constrictions", seconds([&] { query->constrictions(std::back_inserter(found)); }), "s");
  print("the same with another threshold",
        seconds([&] { query->constrictions(std::back_inserter(found), params::minimum_prominence(0.2)); }), "s");
}

} // namespace

int main(int argc, char* argv[])
{
  for(int i = 1; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh))
    {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "\n| " << argv[i] << " | median | greatest |\n| --- | ---: | ---: |" << std::endl;
    measure(mesh);
  }
  return EXIT_SUCCESS;
}
