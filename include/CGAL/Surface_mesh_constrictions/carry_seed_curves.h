// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/carry/Edge_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/coarsest_first.h>
#include <CGAL/Surface_mesh_constrictions/merge_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The surfaces on which `carry_seed_curves()` merges and tightens, and what it keeps there. A surface is given by its
/// number of vertices; if the mesh has fewer vertices the surface is the input.
struct Carrying_parameters
{
  std::size_t merging_vertices = 1000; ///< where seeds are merged
  /// what is kept there. On the levels where curves are tightened one is kept of those that become equal, whatever its
  /// prominence, because too few curves are left to measure prominences among.
  Merging_parameters merging;
  /// the coarsest surface on which curves are tightened, moved to edges, and merged again
  std::size_t tightening_vertices = 16384;
  /// the ratio of the numbers of vertices of two such surfaces in turn; the last has less than half of those of the
  /// input
  std::size_t tightening_factor = 8;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// carries seed curves from their levels to T^0 as paths of edges, without straightening them on coarse levels.
///
/// The seeds are merged on a coarse level, see `merge_seed_curves()`. Those that are kept go on as paths of edges. The
/// boundaries of T^0 always go on: they are few, and a rim is judged on the input. On large meshes the curves are
/// tightened on a few fine levels on the way, where this loses hardly any curve, so that little is left to do on T^0.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
/// \tparam OutputIterator takes `Refined_curve`
/// \tparam Visitor a model of `ConstrictionRefinementVisitor`
///
/// \param pm the surface; at level 0 afterwards
/// \param seeds the seeds, on any levels, in any order; those that `merge_seed_curves()` adds are appended
/// \param parameters the levels to tighten on, and what is kept
/// \param out an output iterator; curves that `is_discarded` or that shortened to a point are written without nodes
/// \param visitor is told of levels only
/// \return the output iterator, past the last element that was written
/// \pre `parameters.merging.kept > 0`, `parameters.tightening_vertices > 0` and `parameters.tightening_factor > 1`
/// \cost O(degree) for each level and for each vertex split on a path, plus that of `merge_seed_curves()`
template <class ConcurrencyTag = Sequential_tag, class OutputIterator, class Visitor>
OutputIterator carry_seed_curves(Progressive_mesh& pm, std::vector<Seed_curve>& seeds,
                                 const Carrying_parameters& parameters, OutputIterator out, Visitor& visitor)
{
  std::vector<Seed_curve> curves;
  std::vector<std::vector<std::size_t>> stands_for; // seeds of a curve
  std::vector<std::size_t> boundaries;              // of T^0
  for(std::size_t i = 0; i < seeds.size(); ++i)
    if(seeds[i].origin == Seed_origin::BOUNDARY && seeds[i].level == 0)
      boundaries.push_back(i);
    else
    {
      curves.push_back(seeds[i]);
      stands_for.push_back({i});
    }

  Merging_parameters merging = parameters.merging;
  const auto merge_on = [&](std::size_t level) {
    std::vector<Merged_seed> merged;
    merge_seed_curves<ConcurrencyTag>(pm, curves, level, merging, std::back_inserter(merged));
    for(std::size_t i = stands_for.size(); i < curves.size(); ++i)
    {
      stands_for.push_back({seeds.size()});
      seeds.push_back(curves[i]);
    }
    visitor.on_level(level);
    std::vector<Seed_curve> kept;
    std::vector<std::vector<std::size_t>> kept_for;
    for(Merged_seed& m : merged)
    {
      std::vector<std::size_t> its_seeds;
      for(std::size_t i : m.seeds)
        its_seeds.insert(its_seeds.end(), stands_for[i].begin(), stands_for[i].end());
      if(m.verdict != Merging_verdict::KEPT)
        *out++ = Refined_curve{Closed_curve(), std::move(its_seeds), m.verdict == Merging_verdict::DISCARDED};
      else
      {
        kept.push_back(std::move(m.curve));
        kept_for.push_back(std::move(its_seeds));
      }
    }
    curves.swap(kept);
    stands_for.swap(kept_for);
  };

  const std::size_t merging_level = pm.level_with(parameters.merging_vertices);
  merge_on(merging_level);
  merging.tight = true;
  merging.minimum_prominence = 0;
  for(std::size_t vertices = parameters.tightening_vertices; pm.level_with(2 * vertices) > 0;
      vertices *= parameters.tightening_factor)
    if(pm.level_with(vertices) < merging_level)
      merge_on(pm.level_with(vertices));

  const std::vector<std::size_t> order = internal::coarsest_first(curves);
  internal::Edge_paths paths(pm);
  auto next = order.begin();
  if(next != order.end())
    pm.go_to_level((std::max)(pm.level(), curves[*next].level));
  for(;; paths.split())
  {
    for(; next != order.end() && curves[*next].level == pm.level(); ++next)
      paths.add(curves[*next].vertices);
    visitor.on_level(pm.level());
    if(pm.level() == 0)
      break;
  }
  for(std::size_t i = 0; i < paths.size(); ++i)
    *out++ = Refined_curve{Closed_curve(paths.path(i)), stands_for[order[i]], false};
  for(std::size_t i : boundaries)
    *out++ = Refined_curve{Closed_curve(seeds[i].vertices), {i}, false};
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H
