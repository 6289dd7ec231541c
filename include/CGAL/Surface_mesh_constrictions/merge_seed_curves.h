// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/carry/Edge_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/carry/curves_asked_for.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/canonical_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/coarsest_first.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/tighten_paths.h>

#include <CGAL/tags.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Which seeds `merge_seed_curves()` keeps.
struct Merging_parameters
{
  /// how many seeds are kept of those that become equal, unless bounds say otherwise
  static constexpr std::size_t most_kept = 12;
  /// how many seeds are kept of those that become equal, at least one. On T^0 one is kept.
  std::size_t kept = most_kept;
  /// whether, of the seeds that become equal, the tightened copy is kept, moved to edges, instead of the seeds
  /// themselves
  bool tight = false;
  /// the greatest isoperimetric ratio of a copy that separates, see `Constriction::isoperimetric_ratio()`. A seed whose
  /// own ratio is more than 6.25 times greater is not even tightened.
  double maximum_isoperimetric_ratio = (std::numeric_limits<double>::infinity)();
  /// the least prominence of a copy among the others, see `compute_prominences()`; 0 or less for any. A less prominent
  /// copy is kept if the level holds it at all, since finer levels may hold it better. The curve that it slides to is
  /// kept in any case.
  double minimum_prominence = 0;
  /// whether copies are kept that cross many shorter ones there and back, or are composed of shorter ones, see
  /// `parameters::crossing_constrictions()`; without a least prominence all are. Where many bumps stand side by side
  /// there are thousands of such copies.
  bool crossing = true;
  /// all copies are kept, whatever the bounds say, and `most_kept` of the seeds that become equal, if sweeping the whole
  /// of T^0 from each of them takes no more faces than this. Then the hierarchy costs little, and what is selected from
  /// it is what is selected of all constrictions. On coarser levels than T^0 seeds that are far too long are not
  /// tightened all the same.
  std::size_t most_swept_faces = 0;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// How a seed ends when seeds are merged.
enum class Merging_verdict
{
  KEPT,       ///< it goes on
  DEGENERATE, ///< it shortens to a point
  DISCARDED   ///< the curve that it shortens to does not meet the `Merging_parameters`
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A seed curve that stands for several.
struct Merged_seed
{
  Seed_curve curve;               ///< without vertices if it does not go on
  std::vector<std::size_t> seeds; ///< numbers of the seeds that it stands for
  Merging_verdict verdict;        ///< whether it goes on
};

namespace internal {

// Carries seeds, in an order from the coarsest level, to a level as paths of edges, each path once. Seeds of finer
// levels are not carried; `number_carried` gets the number of those that are. The surface is at the level afterwards.
inline std::vector<Merged_seed> distinct_paths(Progressive_mesh& pm, const std::vector<Seed_curve>& seeds,
                                               const std::vector<std::size_t>& order, std::size_t level,
                                               std::size_t& number_carried)
{
  typedef std::vector<Index> Path;
  Edge_paths carried(pm);
  for(;; carried.split())
  {
    for(; number_carried < order.size() && seeds[order[number_carried]].level == pm.level(); ++number_carried)
      carried.add(seeds[order[number_carried]].vertices);
    if(pm.level() == level)
      break;
  }
  std::vector<Merged_seed> paths;
  std::unordered_map<Path, std::size_t, boost::hash<Path>> known;
  for(std::size_t i = 0; i < number_carried; ++i)
  {
    Path path = carried.path(i);
    make_canonical(path);
    const auto it = known.emplace(path, paths.size());
    if(it.second)
      paths.push_back({Seed_curve{level, std::move(path), seeds[order[i]].origin}, {}, Merging_verdict::KEPT});
    paths[it.first->second].seeds.push_back(order[i]);
  }
  return paths;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// merges seed curves early, on a coarse level where that is cheap, and discards those that lead nowhere.
///
/// The seeds of coarser levels are carried to the given level as paths of edges. A copy of each seed is tightened
/// there, unless it is far too long. Seeds whose copies shorten to a point are given up; so are those whose copies do
/// not meet `parameters`. Of the seeds whose copies become equal only some are kept, from the shortest to the longest
/// at equal steps; each of the others is counted to the one kept before it. Unless `Merging_parameters::tight` is set,
/// the kept seeds themselves are not tightened: a curve that is tight on a coarse level often slips off on a finer one.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
/// \tparam OutputIterator takes `Merged_seed`
///
/// \param pm the surface; at the given level afterwards
/// \param seeds the seeds, on any levels, in any order. Those of finer levels are written as they are. The curve that a
///        copy of too small a prominence slides to is kept; if no seed leads to that curve, one is appended, with the
///        origin `Seed_origin::BARRIER`.
/// \param level the level to merge on
/// \param parameters what is kept
/// \param out an output iterator
/// \return the output iterator, past the last element that was written
/// \pre `parameters.kept > 0` and `level <= pm.number_of_collapses()`
/// \cost O(degree) for each level and for each vertex split on a path, plus for each seed that of tightening it on the
///       given level until it meets the way of another one, plus that of areas and prominences if `parameters` bounds
///       them
template <class ConcurrencyTag = Sequential_tag, class OutputIterator>
OutputIterator merge_seed_curves(Progressive_mesh& pm, std::vector<Seed_curve>& seeds, std::size_t level,
                                 const Merging_parameters& parameters, OutputIterator out)
{
  typedef std::vector<Index> Path;
  const std::vector<std::size_t> order = internal::coarsest_first(seeds);
  pm.go_to_level(order.empty() ? level : (std::max)(level, seeds[order.front()].level));
  std::size_t number_carried = 0;
  std::vector<Merged_seed> paths = internal::distinct_paths(pm, seeds, order, level, number_carried);

  const auto give_up = [&](std::size_t i, Merging_verdict verdict) {
    *out++ = Merged_seed{Seed_curve{level, {}, paths[i].curve.origin}, paths[i].seeds, verdict};
  };
  // ids of the level's own keep what belongs together close in memory
  const internal::Level_copy level_copy(pm);
  const auto path_on_copy = [&](std::size_t i) {
    Path path = paths[i].curve.vertices;
    for(Index& v : path)
      v = level_copy.vertex(v);
    return path;
  };
  const Progressive_mesh& surface = level_copy.surface();
  const internal::Surface_sides sides(surface);
  const std::size_t most_curves = parameters.most_swept_faces / (std::max)(pm.number_of_face_ids(), std::size_t(1));
  if((level > 0 || most_curves == 0) &&
     parameters.maximum_isoperimetric_ratio < (std::numeric_limits<double>::infinity)())
  {
    const std::vector<std::size_t> promising = internal::paths_asked_for<ConcurrencyTag>(
        paths.size(), path_on_copy, surface, sides, parameters.maximum_isoperimetric_ratio);
    std::size_t kept = 0;
    for(std::size_t i = 0; i < paths.size(); ++i)
      if(kept < promising.size() && promising[kept] == i)
        std::swap(paths[kept++], paths[i]);
      else
        give_up(i, Merging_verdict::DISCARDED);
    paths.resize(kept);
  }

  internal::Curve_network network(surface, false);
  for(std::size_t i : internal::tighten_paths<ConcurrencyTag>(paths.size(), path_on_copy, network))
    give_up(i, Merging_verdict::DEGENERATE);

  const auto add_seed = [&](Path path) {
    for(Index& v : path)
      v = level_copy.original(v);
    paths.push_back({Seed_curve{level, path, Seed_origin::BARRIER}, {seeds.size()}, Merging_verdict::KEPT});
    seeds.push_back(paths.back().curve);
    return paths.size() - 1;
  };
  std::vector<Index> asked = internal::curves_of_network(network);
  const bool keeps_all = asked.size() <= most_curves;
  if(!keeps_all)
    asked = internal::curves_asked_for<ConcurrencyTag>(network, sides, parameters.maximum_isoperimetric_ratio,
                                                       parameters.minimum_prominence, parameters.crossing, add_seed);
  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
  {
    if(network.is_empty(c))
      continue;
    const std::vector<std::size_t>& ends_here = network.curve(c).seeds;
    if(!std::binary_search(asked.begin(), asked.end(), c))
    {
      for(std::size_t i : ends_here)
        give_up(i, Merging_verdict::DISCARDED);
      continue;
    }
    std::vector<std::pair<double, std::size_t>> equal; // lengths and numbers of paths
    for(std::size_t i : ends_here)
      equal.emplace_back(internal::length_of_path(pm, paths[i].curve.vertices), i);
    std::sort(equal.begin(), equal.end());
    const std::size_t n = equal.size();
    const std::size_t most = keeps_all ? Merging_parameters::most_kept : parameters.kept;
    const std::size_t k = level == 0 || parameters.tight ? 1 : (std::min)(n, most);
    for(std::size_t i = 0; i < k; ++i)
    {
      const std::size_t begin = i * n / k, end = (i + 1) * n / k;
      Merged_seed merged = paths[equal[begin].second];
      for(std::size_t j = begin + 1; j < end; ++j)
      {
        const std::vector<std::size_t>& others = paths[equal[j].second].seeds;
        merged.seeds.insert(merged.seeds.end(), others.begin(), others.end());
      }
      if(parameters.tight)
      {
        Path path = internal::path_beside_curve(surface, internal::trace(surface, internal::arcs_of_curve(network, c)));
        for(Index& v : path)
          v = level_copy.original(v);
        if(path.size() > 2)
          merged.curve.vertices.swap(path);
      }
      *out++ = std::move(merged);
    }
  }
  for(std::size_t i = number_carried; i < order.size(); ++i)
    *out++ = Merged_seed{seeds[order[i]], {order[i]}, Merging_verdict::KEPT};
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_MERGE_SEED_CURVES_H
