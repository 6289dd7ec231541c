// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/Edge_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/canonical_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/unfolding.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A seed curve that stands for several.
struct Merged_seed
{
  Seed_curve curve;               ///< without vertices if the seeds shorten to a point
  std::vector<std::size_t> seeds; ///< numbers of the seeds that it stands for
};

namespace internal {

inline double length_of_path(const Progressive_mesh& pm, const std::vector<Index>& path)
{
  double sum = 0;
  for(std::size_t i = 0; i < path.size(); ++i)
    sum += norm(vector(pm.point(path[i]), pm.point(path[(i + 1) % path.size()])));
  return sum;
}

// The numbers of the seeds, from the coarsest level to the finest.
inline std::vector<std::size_t> coarsest_first(const std::vector<Seed_curve>& seeds)
{
  std::vector<std::size_t> order(seeds.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&seeds](std::size_t a, std::size_t b) { return seeds[a].level > seeds[b].level; });
  return order;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// merges seed curves early, on a coarse level where that is cheap, and discards degenerate ones.
///
/// The seeds of coarser levels are carried to the given level as paths of edges. A copy of each seed is tightened there.
/// Seeds whose copies shorten to a point are given up. Of the seeds whose copies become equal only some are kept, from
/// the shortest to the longest at equal steps; each of the others is handed to the one kept before it. What is kept is
/// not tightened: a curve that is tight on a coarse level often lies where it slips off later on.
///
/// \param pm the surface; at the given level afterwards
/// \param seeds the seeds, on any levels, in any order. Those of finer levels are written as they are.
/// \param level the level to merge on
/// \param kept how many seeds are kept of those that become equal, at least one. On T^0 it is one.
/// \param out an output iterator that takes `Merged_seed`
/// \cost O(degree) for each level and for each vertex split on a path, plus for each seed that of tightening it on the
///       given level
template <class OutputIterator>
OutputIterator merge_seed_curves(Progressive_mesh& pm, const std::vector<Seed_curve>& seeds, std::size_t level,
                                 std::size_t kept, OutputIterator out)
{
  typedef std::vector<Index> Path;
  const std::vector<std::size_t> order = internal::coarsest_first(seeds);
  std::size_t coarse = 0; // how many are carried
  internal::Edge_paths carried(pm);
  pm.go_to_level(order.empty() ? level : (std::max)(level, seeds[order.front()].level));
  for(;; carried.split())
  {
    for(; coarse < order.size() && seeds[order[coarse]].level == pm.level(); ++coarse)
      carried.add(seeds[order[coarse]].vertices);
    if(pm.level() == level)
      break;
  }

  // equal paths are one
  std::vector<Merged_seed> paths;
  std::unordered_map<Path, std::size_t, boost::hash<Path> > known;
  for(std::size_t i = 0; i < coarse; ++i)
  {
    Path path = carried.path(i);
    internal::make_canonical(path);
    const auto it = known.emplace(path, paths.size());
    if(it.second)
      paths.push_back({Seed_curve{level, std::move(path), seeds[order[i]].origin}, {}});
    paths[it.first->second].seeds.push_back(order[i]);
  }

  internal::Curve_network network(pm, false);
  internal::Tightener tightener(network, internal::Length_unit(pm));
  tightener.fix_level();
  internal::Distinct_curves distinct(network);
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    const Index c = network.add_curve(i, paths[i].curve.vertices);
    tightener.enqueue_all(c);
    tightener.run();
    if(network.is_empty(c))
      *out++ = Merged_seed{Seed_curve{level, {}, paths[i].curve.origin}, paths[i].seeds};
    else
      distinct.insert(c);
  }

  if(level == 0)
    kept = 1;
  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
  {
    if(network.is_empty(c))
      continue;
    std::vector<std::pair<double, std::size_t> > equal; // lengths and numbers of paths
    for(std::size_t i : network.curve(c).seeds)
      equal.emplace_back(internal::length_of_path(pm, paths[i].curve.vertices), i);
    std::sort(equal.begin(), equal.end());
    const std::size_t n = equal.size(), k = (std::min)(n, kept);
    for(std::size_t i = 0; i < k; ++i)
    {
      const std::size_t begin = i * n / k, end = (i + 1) * n / k;
      Merged_seed merged = paths[equal[begin].second];
      for(std::size_t j = begin + 1; j < end; ++j)
      {
        const std::vector<std::size_t>& others = paths[equal[j].second].seeds;
        merged.seeds.insert(merged.seeds.end(), others.begin(), others.end());
      }
      *out++ = std::move(merged);
    }
  }
  for(std::size_t i = coarse; i < order.size(); ++i)
    *out++ = Merged_seed{seeds[order[i]], {order[i]}};
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H
