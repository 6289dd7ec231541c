// SPDX-License-Identifier: GPL-3.0-or-later

// Whole detection against CGAL's edge_collapse() alone, with the same policies on a copy of the same mesh, in one run.
//
// Meshes: a generated chain of necks with about 1,000, 10,000, 100,000 and 800,000 faces; and, with
// CONSTRICTIONS_MESH_DIR in the environment, its armadillo.off after 0, 1 and 2 Loop subdivisions.
// Counters: faces, curves; the times of finding seeds, refinement, tightening and selection, in percent of that of the
// simplification, and of certification, in percent of the whole; peak_MB is what the process's peak memory rose to, which
// only means something if one benchmark is run alone (--benchmark_filter).

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_utils.h>
#include <CGAL/subdivision_method_3.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// A surface of revolution with four necks and about the given number of faces, without two equal edges in it.
Mesh chain_of_necks(int faces)
{
  const int around = static_cast<int>(std::lround(std::sqrt(faces / 8.0))), along = faces / (2 * around);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for(int i = 0; i <= along; ++i)
  {
    const double s = (i + 0.5) / (along + 1), radius = std::sqrt(std::sin(CGAL_PI * s)) * (1 + 0.6 * std::cos(10 * CGAL_PI * s));
    for(int j = 0; j < around; ++j)
    {
      const double wobble = 1e-3 * std::sin(37.0 * i + 91.0 * j), phi = 2 * CGAL_PI * (j + 0.5 * (i % 2)) / around;
      vertices.push_back(mesh.add_vertex(Kernel::Point_3((1 + wobble) * radius * std::cos(phi),
                                                         (1 + wobble) * radius * std::sin(phi), 12 * s)));
    }
  }
  const auto at = [&](int i, int j) { return vertices[static_cast<std::size_t>(i * around + j % around)]; };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const int shift = i % 2;
      mesh.add_face(at(i, j), at(i, j + 1), at(i + 1, j + shift));
      mesh.add_face(at(i, j + 1 - shift), at(i + 1, j + 1), at(i + 1, j));
    }
  const Mesh::Vertex_index bottom = mesh.add_vertex(Kernel::Point_3(0, 0, -0.05));
  const Mesh::Vertex_index top = mesh.add_vertex(Kernel::Point_3(0, 0, 12.05));
  for(int j = 0; j < around; ++j)
  {
    mesh.add_face(at(0, j + 1), at(0, j), bottom);
    mesh.add_face(at(along, j), at(along, j + 1), top);
  }
  return mesh;
}

// armadillo.off after some Loop subdivisions; empty if there is no such file.
Mesh armadillo(int subdivisions)
{
  const char* const directory = std::getenv("CONSTRICTIONS_MESH_DIR");
  Mesh mesh;
  if(directory == nullptr || !CGAL::IO::read_polygon_mesh(std::string(directory) + "/armadillo.off", mesh))
    return Mesh();
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  mesh.collect_garbage();
  return mesh;
}

const Mesh& mesh_of(const benchmark::State& state)
{
  static std::vector<std::pair<std::pair<std::int64_t, std::int64_t>, Mesh> > cache;
  const std::pair<std::int64_t, std::int64_t> key(state.range(0), state.range(1));
  if(cache.empty() || cache.front().first != key)
  {
    cache.clear();
    cache.emplace_back(key, key.first == 0 ? chain_of_necks(static_cast<int>(key.second))
                                           : armadillo(static_cast<int>(key.second)));
  }
  return cache.front().second;
}

struct Never_stop
{
  template <class FT, class Profile, class Size>
  bool operator()(const FT&, const Profile&, Size, Size) const { return false; }
};

void report(benchmark::State& state, const Mesh& mesh)
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  state.counters["faces"] = static_cast<double>(mesh.number_of_faces());
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

void edge_collapse_alone(benchmark::State& state)
{
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError("no armadillo.off in CONSTRICTIONS_MESH_DIR");
  for(auto _ : state)
  {
    Mesh copy = mesh;
    const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(copy);
    SMS::edge_collapse(copy, Never_stop(),
                       CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  }
  report(state, mesh);
}

// Adds up the processor time of the stages.
struct Stage_clock : public SMC::Detection_visitor_base
{
  struct Times
  {
    std::clock_t begin = 0;
    std::array<double, 6> seconds = {0, 0, 0, 0, 0, 0};

    double operator[](SMC::Detection_stage stage) const { return seconds[static_cast<std::size_t>(stage)]; }
  };
  Times* times;

  explicit Stage_clock(Times& times) : times(&times) {}
  void on_stage_begin(SMC::Detection_stage, std::size_t) const { times->begin = std::clock(); }
  void on_stage_end(SMC::Detection_stage stage) const
  {
    times->seconds[static_cast<std::size_t>(stage)] +=
        static_cast<double>(std::clock() - times->begin) / CLOCKS_PER_SEC;
  }
};

void whole_detection(benchmark::State& state)
{
  using SMC::Detection_stage;
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError("no armadillo.off in CONSTRICTIONS_MESH_DIR");
  std::vector<SMC::Constriction<Mesh> > constrictions;
  Stage_clock::Times times;
  const std::clock_t start = std::clock();
  for(auto _ : state)
  {
    constrictions.clear();
    SMC::detect_constrictions(mesh, std::back_inserter(constrictions), CGAL::parameters::visitor(Stage_clock(times)));
  }
  const double whole = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double simplification = times[Detection_stage::SIMPLIFICATION];
  report(state, mesh);
  state.counters["seeds_percent"] = 100 * times[Detection_stage::SEEDS] / simplification;
  state.counters["select_percent"] = 100 * times[Detection_stage::SELECTION] / simplification;
  state.counters["refine_percent"] = 100 * times[Detection_stage::REFINEMENT] / simplification;
  state.counters["tighten_percent"] = 100 * times[Detection_stage::TIGHTENING] / simplification;
  state.counters["certify_percent"] = 100 * times[Detection_stage::CERTIFICATION] / whole;
  state.counters["curves"] = static_cast<double>(constrictions.size());
}

void arguments(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"armadillo", "size"})->Unit(benchmark::kMillisecond);
  for(int faces : {1000, 10000, 100000, 800000})
    b->Args({0, faces});
  for(int subdivisions : {0, 1, 2})
    b->Args({1, subdivisions});
}

BENCHMARK(edge_collapse_alone)->Apply(arguments);
BENCHMARK(whole_detection)->Apply(arguments);

} // namespace

BENCHMARK_MAIN();
