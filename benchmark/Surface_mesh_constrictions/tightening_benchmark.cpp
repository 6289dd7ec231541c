// SPDX-License-Identifier: GPL-3.0-or-later

// Tightening loops of edges, against what else makes a loop short: shortest paths between three of its vertices, a
// third of the loop apart, along edges by Dijkstra's algorithm, and on the surface by CGAL's
// Surface_mesh_shortest_path.
//
// The loops run beside constrictions of elephant.off, which is looked for in CONSTRICTIONS_MESH_DIR, after 0 and 1 Loop
// subdivisions. Counters: faces, loops, and the length of the result in percent of the constriction's, on average.
// Shortest paths have a corner at each of the three vertices, so theirs is no closed geodesic.

#include "benchmark_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <benchmark/benchmark.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
using benchmark_meshes::Kernel;
using benchmark_meshes::Mesh;
typedef std::vector<Mesh::Vertex_index> Loop;

struct Problem
{
  Mesh mesh;
  std::vector<Loop> loops;
  std::vector<double> lengths; // of the constrictions
};

// A closed path of edges beside a constriction; empty if there is none of three vertices or more.
Loop loop_beside(const Mesh& mesh, const SMC::Constriction<Mesh>& curve)
{
  Loop loop;
  for(const auto& l : curve.locations())
  {
    const Mesh::Vertex_index v = l.is_pivot          ? l.vertex
                                 : l.parameter < 0.5 ? mesh.source(l.halfedge)
                                                     : mesh.target(l.halfedge);
    if(loop.empty() || loop.back() != v)
      loop.push_back(v);
  }
  while(loop.size() > 1 && loop.front() == loop.back())
    loop.pop_back();
  for(std::size_t i = 0; i < loop.size(); ++i)
    if(!mesh.halfedge(loop[i], loop[(i + 1) % loop.size()]).is_valid())
      return Loop();
  return loop.size() < 3 ? Loop() : loop;
}

const Problem& problem(std::int64_t subdivisions)
{
  static std::int64_t key = -1;
  static Problem result;
  if(key == subdivisions)
    return result;
  key = subdivisions;
  result = Problem();
  const char* const directory = std::getenv("CONSTRICTIONS_MESH_DIR");
  if(directory == nullptr)
    return result;
  result.mesh = benchmark_meshes::subdivided(std::string(directory) + "/elephant.off", static_cast<int>(subdivisions));
  if(result.mesh.is_empty())
    return result;
  std::vector<SMC::Constriction<Mesh>> constrictions;
  SMC::detect_constrictions(result.mesh, std::back_inserter(constrictions),
                            SMC::parameters::maximum_number_of_constrictions(5));
  for(const SMC::Constriction<Mesh>& c : constrictions)
  {
    const Loop loop = loop_beside(result.mesh, c);
    if(loop.empty())
      continue;
    result.loops.push_back(loop);
    result.lengths.push_back(c.length());
  }
  return result;
}

std::array<Mesh::Vertex_index, 3> three_vertices(const Loop& loop)
{
  return {{loop[0], loop[loop.size() / 3], loop[2 * loop.size() / 3]}};
}

// Calls length_of(loop) for each loop and reports.
template <class LengthOf>
void measure(benchmark::State& state, const LengthOf& length_of)
{
  const Problem& p = problem(state.range(0));
  if(p.loops.empty())
    return state.SkipWithError("no elephant.off in CONSTRICTIONS_MESH_DIR");
  std::vector<double> lengths;
  for(auto _ : state)
    lengths = length_of(p);
  double sum = 0;
  for(std::size_t i = 0; i < lengths.size(); ++i)
    sum += 100 * lengths[i] / p.lengths[i];
  state.counters["faces"] = static_cast<double>(p.mesh.number_of_faces());
  state.counters["loops"] = static_cast<double>(p.loops.size());
  state.counters["length_percent"] = sum / static_cast<double>(lengths.size());
}

void tighten(benchmark::State& state)
{
  measure(state, [](const Problem& p) {
    std::vector<SMC::Tightened_curve<Mesh>> curves;
    SMC::tighten_closed_curves(p.mesh, p.loops, std::back_inserter(curves));
    std::vector<double> lengths;
    for(const auto& c : curves)
      lengths.push_back(c.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC ? c.curve.length() : 0);
    return lengths;
  });
}

void dijkstra(benchmark::State& state)
{
  measure(state, [](const Problem& p) {
    std::vector<double> lengths;
    for(const Loop& loop : p.loops)
    {
      const std::array<Mesh::Vertex_index, 3> ends = three_vertices(loop);
      double sum = 0;
      for(std::size_t i = 0; i < 3; ++i)
      {
        std::vector<double> distance(p.mesh.number_of_vertices());
        const auto weight = [&p](Mesh::Edge_index e) {
          const auto h = p.mesh.halfedge(e);
          return std::sqrt(CGAL::squared_distance(p.mesh.point(p.mesh.source(h)), p.mesh.point(p.mesh.target(h))));
        };
        const auto index = get(boost::vertex_index, p.mesh);
        boost::dijkstra_shortest_paths(p.mesh, ends[i],
                                       boost::weight_map(boost::make_function_property_map<Mesh::Edge_index>(weight))
                                           .distance_map(boost::make_iterator_property_map(distance.begin(), index))
                                           .vertex_index_map(index));
        sum += distance[ends[(i + 1) % 3]];
      }
      lengths.push_back(sum);
    }
    return lengths;
  });
}

void surface_mesh_shortest_path(benchmark::State& state)
{
  measure(state, [](const Problem& p) {
    typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_paths;
    std::vector<double> lengths;
    for(const Loop& loop : p.loops)
    {
      const std::array<Mesh::Vertex_index, 3> ends = three_vertices(loop);
      double sum = 0;
      for(std::size_t i = 0; i < 3; ++i)
      {
        Shortest_paths paths(p.mesh);
        paths.add_source_point(ends[i]);
        sum += paths.shortest_distance_to_source_points(ends[(i + 1) % 3]).first;
      }
      lengths.push_back(sum);
    }
    return lengths;
  });
}

void arguments(benchmark::internal::Benchmark* b)
{
  b->ArgName("subdivisions")->Unit(benchmark::kMillisecond)->Arg(0)->Arg(1);
}

BENCHMARK(tighten)->Apply(arguments);
BENCHMARK(dijkstra)->Apply(arguments);
BENCHMARK(surface_mesh_shortest_path)->Apply(arguments);

} // namespace

BENCHMARK_MAIN();
