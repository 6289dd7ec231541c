// SPDX-License-Identifier: GPL-3.0-or-later

// Whole detection, with one thread and with all, against other programs on the same mesh: CGAL's edge_collapse() alone,
// with the same policies on a copy, and, where they are installed, OpenMesh's quadric decimater on a copy, and
// meshoptimizer's simplification of arrays to 1,000 faces. The mesh is in memory: reading and converting it is left
// out.
//
// Meshes: surfaces with one neck and with many, of about 1,000 to 1,000,000 faces; two boxes joined by a bar, all of
// grids in flat squares, of about 1,000 to 820,000 faces; and, with CONSTRICTIONS_MESH_DIR in the environment, its
// armadillo.off after 0 to 4 Loop subdivisions, of 52,000 to 13,312,000 faces. What takes minutes on a mesh is left
// out there.
// Counters: faces, curves; faces_reached by meshoptimizer, which may stop before; milliseconds of the stages, of which
// `copy` is what comes before the first one, checking and copying the mesh, and `record` what the stage SEEDS takes
// without a seed source: building the progressive mesh from the record; peak_MB is what the process's memory rose to,
// and own_bytes by how many bytes a face that is above its memory before, which holds the mesh, and for OpenMesh and
// meshoptimizer their own one, too. Both only mean something if one benchmark is run alone (--benchmark_filter).
// run_benchmarks.py does that, and makes tables and plots.

#include "benchmark_meshes.h"
#include "meshoptimizer_simplifier.h"
#include "openmesh_decimater.h"
#include "peak_memory.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
using benchmark_meshes::Kernel;
using benchmark_meshes::Mesh;

enum Family
{
  ONE_NECK,
  MANY_NECKS,
  REAL,
  FLAT
};

// The size is the number of faces, or of subdivisions of the real mesh.
Mesh make_mesh(std::int64_t family, std::int64_t size)
{
  const int n = static_cast<int>(size);
  if(family == ONE_NECK)
    return benchmark_meshes::chain_of_necks(n, 1);
  if(family == MANY_NECKS)
    return benchmark_meshes::bed_of_mushrooms(n, n / 500);
  if(family == FLAT)
    return benchmark_meshes::flat_boxes(n);
  const char* const directory = std::getenv("CONSTRICTIONS_MESH_DIR");
  return directory == nullptr ? Mesh() : benchmark_meshes::subdivided(std::string(directory) + "/armadillo.off", n);
}

const Mesh& mesh_of(const benchmark::State& state)
{
  static std::pair<std::int64_t, std::int64_t> key(-1, -1);
  static Mesh mesh;
  if(key != std::make_pair(state.range(0), state.range(1)))
  {
    key = std::make_pair(state.range(0), state.range(1));
    mesh = make_mesh(key.first, key.second);
  }
  return mesh;
}

constexpr const char* no_mesh = "no armadillo.off in CONSTRICTIONS_MESH_DIR";

struct Never_stop
{
  template <class FT, class Profile, class Size>
  bool operator()(const FT&, const Profile&, Size, Size) const
  {
    return false;
  }
};

void report(benchmark::State& state, const Mesh& mesh, const Peak_memory& memory)
{
  const double faces = static_cast<double>(mesh.number_of_faces());
  state.counters["faces"] = faces;
  state.counters["peak_MB"] = static_cast<double>(memory.peak()) / (1024 * 1024);
  state.counters["own_bytes"] = static_cast<double>(memory.rise()) / faces;
}

std::vector<std::array<double, 3>> points_of(const Mesh& mesh)
{
  std::vector<std::array<double, 3>> points;
  points.reserve(mesh.number_of_vertices());
  for(auto v : mesh.vertices())
    points.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  return points;
}

std::vector<std::array<std::size_t, 3>> triangles_of(const Mesh& mesh)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  triangles.reserve(mesh.number_of_faces());
  for(auto f : mesh.faces())
  {
    triangles.emplace_back();
    std::size_t i = 0;
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangles.back()[i++] = v;
  }
  return triangles;
}

void edge_collapse_alone(benchmark::State& state)
{
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError(no_mesh);
  const Peak_memory memory;
  for(auto _ : state)
  {
    Mesh copy = mesh;
    const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(copy);
    SMS::edge_collapse(copy, Never_stop(),
                       CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  }
  report(state, mesh, memory);
}

void openmesh_decimater(benchmark::State& state)
{
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError(no_mesh);
  const Openmesh_decimater decimater(points_of(mesh), triangles_of(mesh));
  const Peak_memory memory;
  for(auto _ : state)
    if(decimater.collapses_of_a_copy() == 0)
      return state.SkipWithError("OpenMesh is not installed");
  report(state, mesh, memory);
}

void meshoptimizer_simplify(benchmark::State& state)
{
  constexpr std::size_t target = 1000;
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError(no_mesh);
  if(mesh.number_of_faces() < 2 * target)
    return state.SkipWithError("the mesh has hardly more faces than it is to be simplified to");
  Meshoptimizer_simplifier simplifier(points_of(mesh), triangles_of(mesh));
  const Peak_memory memory;
  std::size_t reached = 0;
  for(auto _ : state)
  {
    reached = simplifier.faces_after_simplification(target);
    if(reached == 0)
      return state.SkipWithError("meshoptimizer is not installed");
  }
  report(state, mesh, memory);
  state.counters["faces_reached"] = static_cast<double>(reached);
}

// Adds up the time of the stages, and of what comes before the first one. `times.begin` must be when that begins.
struct Stage_clock : public SMC::Detection_visitor_base
{
  typedef std::chrono::steady_clock Clock;
  struct Times
  {
    Clock::time_point begin = Clock::now();
    double copy = 0;
    std::array<double, 6> stages = {0, 0, 0, 0, 0, 0};

    double operator[](SMC::Detection_stage stage) const { return stages[static_cast<std::size_t>(stage)]; }
    double since_begin() const { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }
  };
  Times* times;

  explicit Stage_clock(Times& times) : times(&times) {}
  void on_stage_begin(SMC::Detection_stage stage, std::size_t) const
  {
    if(stage == SMC::Detection_stage::SIMPLIFICATION)
      times->copy += times->since_begin();
    times->begin = Clock::now();
  }
  void on_stage_end(SMC::Detection_stage stage) const
  {
    times->stages[static_cast<std::size_t>(stage)] += times->since_begin();
  }
};

template <class ConcurrencyTag>
void whole_detection(benchmark::State& state)
{
  using SMC::Detection_stage;
  const Mesh& mesh = mesh_of(state);
  if(mesh.is_empty())
    return state.SkipWithError(no_mesh);
  std::vector<SMC::Constriction<Mesh>> constrictions;
  Stage_clock::Times times, without_seeds;
  const Peak_memory memory;
  for(auto _ : state)
  {
    constrictions.clear();
    times.begin = Stage_clock::Clock::now();
    SMC::detect_constrictions<ConcurrencyTag>(mesh, std::back_inserter(constrictions),
                                              CGAL::parameters::visitor(Stage_clock(times)));
  }
  report(state, mesh, memory);
  std::vector<SMC::Constriction<Mesh>> none;
  SMC::detect_constrictions<ConcurrencyTag>(
      mesh, std::back_inserter(none),
      SMC::parameters::seed_sources(SMC::Given_seeds({}), CGAL::parameters::visitor(Stage_clock(without_seeds))));
  const double n = static_cast<double>(state.iterations()), record = without_seeds[Detection_stage::SEEDS];
  state.counters["copy"] = times.copy / n;
  state.counters["simplify"] = times[Detection_stage::SIMPLIFICATION] / n;
  state.counters["record"] = record;
  state.counters["seeds"] = times[Detection_stage::SEEDS] / n - record;
  state.counters["refine"] = times[Detection_stage::REFINEMENT] / n;
  state.counters["tighten"] = times[Detection_stage::TIGHTENING] / n;
  state.counters["certify"] = times[Detection_stage::CERTIFICATION] / n;
  state.counters["select"] = times[Detection_stage::SELECTION] / n;
  state.counters["curves"] = static_cast<double>(constrictions.size());
}

void arguments(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"family", "size"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for(int family : {ONE_NECK, MANY_NECKS})
    for(int faces : {1000, 10000, 100000, 1000000})
      b->Args({family, faces});
  for(int subdivisions : {0, 1, 2})
    b->Args({REAL, subdivisions});
  for(int faces : {1000, 10000, 100000})
    b->Args({FLAT, faces});
}

// OpenMesh's decimater takes minutes here.
void large_flat_argument(benchmark::internal::Benchmark* b) { b->Args({FLAT, 820000}); }

// Whatever has a queue of all edges takes minutes here.
void large_real_arguments(benchmark::internal::Benchmark* b)
{
  for(int subdivisions : {3, 4})
    b->Args({REAL, subdivisions});
}

void all_arguments(benchmark::internal::Benchmark* b)
{
  arguments(b);
  large_flat_argument(b);
  large_real_arguments(b);
}

BENCHMARK(edge_collapse_alone)->Apply(arguments)->Apply(large_flat_argument);
BENCHMARK(openmesh_decimater)->Apply(arguments);
BENCHMARK(meshoptimizer_simplify)->Apply(all_arguments);
BENCHMARK_TEMPLATE(whole_detection, CGAL::Sequential_tag)->Apply(all_arguments);
BENCHMARK_TEMPLATE(whole_detection, CGAL::Parallel_if_available_tag)->Apply(all_arguments);

} // namespace

BENCHMARK_MAIN();
