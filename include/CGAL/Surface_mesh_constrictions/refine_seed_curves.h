// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_REFINE_SEED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_REFINE_SEED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/carry/Refinement.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/coarsest_first.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A curve on T^0 that `refine_seed_curves()` or `carry_seed_curves()` has carried through the levels.
struct Refined_curve
{
  Closed_curve curve;             ///< empty if the seeds shortened to a point on the way, or were given up
  std::vector<std::size_t> seeds; ///< numbers of the seeds that led to it, the first to arrive first
  bool is_discarded = false;      ///< whether it was given up on the way without shortening to a point
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Visitor of `refine_seed_curves()` whose callbacks do nothing: derive from it and hide what you need.
///
/// \cgalModels{ConstrictionRefinementVisitor}
struct Refinement_visitor_base
{
  /// called when all curves have reached T^level
  void on_level(std::size_t /* level */) {}

  /// called when a curve has appeared or changed on T^level. `curve()` gives it as a `Closed_curve`, which is empty if
  /// it has shortened to a point.
  template <class Curve>
  void on_curve(std::size_t /* level */, const std::vector<std::size_t>& /* seeds */, const Curve& /* curve */)
  {}
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// carries seed curves from their levels to T^0, one vertex split after the other (Sections 4.2 to 4.4 of the paper).
/// At each split only the arcs through the star of the vertex that is split are computed anew, between the nearest
/// pivots. Curves that become equal are merged at the level where they meet.
///
/// \tparam OutputIterator takes `Refined_curve`
/// \tparam Visitor a model of `ConstrictionRefinementVisitor`
///
/// \param pm the surface; at level 0 afterwards
/// \param seeds the seeds, on any levels, in any order
/// \param schedule whether the changed part of a curve is tightened at every level. A curve that shortens to a point on
///        a level is given up there. Not `UNSTRAIGHTENED`: see `carry_seed_curves()`.
/// \param out an output iterator
/// \param visitor is told of each level and of each change of a curve
/// \return the output iterator, past the last element that was written
/// \pre `schedule != Tightening_schedule::UNSTRAIGHTENED`, and each seed is a closed path of edges of its level
/// \cost O(degree) for each level, plus, for each curve through the star that is split, linear in the lengths of the
///       strips between the pivots around the star
template <class OutputIterator, class Visitor>
OutputIterator refine_seed_curves(Progressive_mesh& pm, const std::vector<Seed_curve>& seeds,
                                  Tightening_schedule schedule, OutputIterator out, Visitor& visitor)
{
  CGAL_precondition(schedule != Tightening_schedule::UNSTRAIGHTENED);
  const bool every_level = schedule == Tightening_schedule::EVERY_LEVEL;

  const std::vector<std::size_t> order = internal::coarsest_first(seeds);
  const internal::Length_unit unit(pm);
  internal::Curve_network network(pm, true);
  internal::Tightener tightener(network, unit);
  internal::Refinement refinement(pm, network, unit);
  internal::Distinct_curves distinct(network);

  const auto report = [&](Index c) {
    visitor.on_curve(pm.level(), network.curve(c).seeds,
                     [&network, c]() { return internal::curve_of_arcs(internal::arcs_of_curve(network, c)); });
  };
  const auto finish = [&](Index c) {
    report(c);
    if(!network.is_empty(c))
      distinct.insert(c);
    else
    {
      *out++ = Refined_curve{Closed_curve(), network.curve(c).seeds, false};
      network.remove(c);
    }
  };

  pm.go_to_level(order.empty() ? 0 : seeds[order.front()].level);
  std::vector<Index> changed, pivots;
  auto next_seed = order.begin();
  for(;;)
  {
    for(; next_seed != order.end() && seeds[*next_seed].level == pm.level(); ++next_seed)
    {
      const Index c = network.add_curve(*next_seed, seeds[*next_seed].vertices);
      if(every_level)
      {
        tightener.enqueue_all(c);
        tightener.run();
      }
      finish(c);
    }
    visitor.on_level(pm.level());
    if(pm.level() == 0)
      break;

    refinement.split(changed, pivots, [&distinct](Index c) { distinct.remove(c); });
    if(every_level)
    {
      for(Index arc : pivots)
        if(network.node(arc).curve != null_index)
          tightener.enqueue(arc);
      tightener.run();
    }
    for(Index c : changed)
      finish(c);
  }

  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
    if(!network.is_empty(c))
      *out++ =
          Refined_curve{internal::curve_of_arcs(internal::arcs_of_curve(network, c)), network.curve(c).seeds, false};
  return out;
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// as above, without a visitor.
template <class OutputIterator>
OutputIterator refine_seed_curves(Progressive_mesh& pm, const std::vector<Seed_curve>& seeds,
                                  Tightening_schedule schedule, OutputIterator out)
{
  Refinement_visitor_base visitor;
  return refine_seed_curves(pm, seeds, schedule, out, visitor);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_REFINE_SEED_CURVES_H
