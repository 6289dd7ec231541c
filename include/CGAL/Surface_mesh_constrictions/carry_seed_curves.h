// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/Edge_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/Refinement.h>
#include <CGAL/Surface_mesh_constrictions/internal/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/merge_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// On which surfaces `carry_seed_curves()` tightens. A surface is given by its number of vertices; on meshes with fewer
/// vertices it is the input.
struct Carrying_parameters
{
  std::size_t merging_vertices = 1000;     ///< where seeds are merged and degenerate ones given up
  std::size_t kept_when_merging = 12;      ///< how many seeds are kept of those that become equal there
  std::size_t tightening_vertices = 16384; ///< where curves are tightened on the way, on meshes more than twice that size
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// carries seed curves from their levels to T^0 as paths of edges, without straightening them on the way, so that all
/// shortening is done on a surface that is close to T^0 or is T^0.
///
/// The seeds are merged on a coarse level, see `merge_seed_curves()`. Those that are kept go on as paths of edges. On
/// large meshes they are tightened on a finer level, merged again, and kept tight from there to T^0 at every level, see
/// `refine_seed_curves()`: on levels so fine that loses little, and on T^0 there is little left to be done.
///
/// \param pm the surface; at level 0 afterwards
/// \param seeds the seeds, on any levels, in any order
/// \param parameters the levels to tighten on
/// \param out an output iterator that takes `Refined_curve`
/// \param visitor see `Refinement_visitor_base`; told of levels only
/// \cost O(degree) for each level and for each vertex split on a path, plus that of tightening
template <class OutputIterator, class Visitor>
OutputIterator carry_seed_curves(Progressive_mesh& pm, const std::vector<Seed_curve>& seeds,
                                 const Carrying_parameters& parameters, OutputIterator out, Visitor& visitor)
{
  pm.go_to_level(0);
  std::size_t vertices = 0;
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    vertices += pm.is_vertex(v);
  const auto level_with = [&](std::size_t n) {
    return (std::min)(vertices > n ? vertices - n : 0, pm.number_of_collapses());
  };
  const std::size_t merging_level = level_with(parameters.merging_vertices);
  const std::size_t tightening_level =
      vertices / 2 > parameters.tightening_vertices
          ? (std::min)(merging_level, level_with(parameters.tightening_vertices))
          : 0;

  std::vector<Merged_seed> merged;
  merge_seed_curves(pm, seeds, merging_level, parameters.kept_when_merging, std::back_inserter(merged));
  const auto write = [&](std::size_t i, const std::vector<internal::Arc>& arcs) {
    *out++ = Refined_curve{internal::curve_of_arcs(arcs), merged[i].seeds};
  };

  // the coarsest first: those that have been carried already come before those of finer levels
  std::vector<std::size_t> living;
  for(std::size_t i = 0; i < merged.size(); ++i)
    if(merged[i].curve.vertices.empty())
      write(i, {});
    else
      living.push_back(i);
  std::stable_sort(living.begin(), living.end(), [&merged](std::size_t a, std::size_t b) {
    return merged[a].curve.level > merged[b].curve.level;
  });

  internal::Edge_paths paths(pm);
  auto next = living.begin();
  for(;; paths.split())
  {
    for(; next != living.end() && merged[*next].curve.level == pm.level(); ++next)
      paths.add(merged[*next].curve.vertices);
    visitor.on_level(pm.level());
    if(pm.level() == tightening_level)
      break;
  }
  if(tightening_level == 0)
  {
    for(std::size_t i = 0; i < paths.size(); ++i)
    {
      Closed_curve curve;
      for(Index v : paths.path(i))
        curve.nodes.push_back(Closed_curve::Node{v, null_index});
      *out++ = Refined_curve{curve, merged[living[i]].seeds};
    }
    return out;
  }

  const internal::Length_unit unit(pm);
  internal::Curve_network network(pm, true);
  internal::Tightener tightener(network, unit);
  internal::Refinement refinement(pm, network, unit);
  internal::Distinct_curves distinct(network);
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    const Index c = network.add_curve(living[i], paths.path(i));
    tightener.enqueue_all(c);
    tightener.run();
    if(!network.is_empty(c))
      distinct.insert(c);
    else
    {
      write(living[i], {});
      network.remove(c);
    }
  }
  std::vector<Index> changed, pivots;
  while(pm.level() > 0)
  {
    refinement.split(changed, pivots, [&distinct](Index c) { distinct.remove(c); });
    for(Index arc : pivots)
      if(network.node(arc).curve != null_index)
        tightener.enqueue(arc);
    tightener.run();
    for(; next != living.end() && merged[*next].curve.level == pm.level(); ++next)
      changed.push_back(network.add_curve(*next, merged[*next].curve.vertices));
    for(Index c : changed)
      if(!network.is_empty(c))
        distinct.insert(c);
      else
      {
        for(std::size_t i : network.curve(c).seeds)
          write(i, {});
        network.remove(c);
      }
    visitor.on_level(pm.level());
  }
  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
    if(!network.is_empty(c))
    {
      Refined_curve refined = {internal::curve_of_arcs(internal::arcs_of_curve(network, c)), {}};
      for(std::size_t i : network.curve(c).seeds)
        refined.seeds.insert(refined.seeds.end(), merged[i].seeds.begin(), merged[i].seeds.end());
      *out++ = refined;
    }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CARRY_SEED_CURVES_H
