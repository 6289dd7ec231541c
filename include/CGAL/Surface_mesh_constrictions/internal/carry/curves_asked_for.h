// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

inline double length_of_path(const Progressive_mesh& pm, const std::vector<Index>& path)
{
  double sum = 0;
  for(std::size_t i = 0; i < path.size(); ++i)
    sum += norm(vector(pm.point(path[i]), pm.point(path[(i + 1) % path.size()])));
  return sum;
}

// A closed path of edges zigzags, and lies aslant: it is no more than this many times as long as what it is tightened
// to, but for few.
constexpr double slack_of_paths = 2.1;

// Of closed paths of edges, of which path_of(i) gives number i as a vector of vertices, those that may be tightened to
// a curve of no greater isoperimetric ratio, as far as their own ratios tell. Ascending. Linear in the paths.
template <class ConcurrencyTag, class PathOf>
std::vector<std::size_t> paths_asked_for(std::size_t number_of_paths, const PathOf& path_of, const Progressive_mesh& pm,
                                         const Surface_sides& sides, double maximum_isoperimetric_ratio)
{
  auto groups = make_groups<std::vector<std::size_t> >(number_of_paths, 512);
  CGAL::for_each<ConcurrencyTag>(groups, [&](Group<std::vector<std::size_t> >& group) {
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      const std::vector<Index> path = path_of(i);
      if(!is_too_long(length_of_path(pm, path) / slack_of_paths, sides.part(path), maximum_isoperimetric_ratio))
        group.result.push_back(i);
    }
    return true;
  });
  std::vector<std::size_t> result;
  for(const Group<std::vector<std::size_t> >& group : groups)
    result.insert(result.end(), group.result.begin(), group.result.end());
  return result;
}

// Of the closed geodesics of a level the ones that may be asked for, as far as this level tells: those of no greater
// isoperimetric ratio and no less prominence, which do not cross others if these are not to. Curves that are not simple
// here may be on a finer level. Ascending. Cost: that of the areas and prominences.
template <class ConcurrencyTag>
std::vector<Index> curves_asked_for(const Curve_network& network, const Surface_sides& sides,
                                    double maximum_isoperimetric_ratio, double minimum_prominence, bool with_crossing)
{
  const Progressive_mesh& pm = network.surface();
  std::vector<Index> all, result, simple;
  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
    if(!network.is_empty(c))
      all.push_back(c);
  const bool any_ratio = maximum_isoperimetric_ratio == (std::numeric_limits<double>::infinity)();
  if(any_ratio && minimum_prominence <= 0)
    return all;

  // The curves of a group that are asked for if they are simple ones with enough prominence, and of the simple ones the
  // traces.
  struct Candidates
  {
    std::vector<Index> simple, not_simple;
    std::vector<std::vector<Trace_point> > traces;
  };
  auto groups = make_groups<Candidates>(all.size(), 128);
  CGAL::for_each<ConcurrencyTag>(groups, [&](Group<Candidates>& group) {
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      std::vector<Trace_point> points = trace(pm, arcs_of_curve(network, all[i]));
      if(!is_simple(pm, points))
      {
        group.result.not_simple.push_back(all[i]);
        continue;
      }
      if(is_too_long(network.length(all[i]), sides.part(points), maximum_isoperimetric_ratio))
        continue;
      group.result.simple.push_back(all[i]);
      group.result.traces.push_back(std::move(points));
    }
    return true;
  });
  std::vector<std::vector<Trace_point> > traces;
  for(Group<Candidates>& group : groups)
  {
    result.insert(result.end(), group.result.not_simple.begin(), group.result.not_simple.end());
    simple.insert(simple.end(), group.result.simple.begin(), group.result.simple.end());
    std::move(group.result.traces.begin(), group.result.traces.end(), std::back_inserter(traces));
  }
  if(minimum_prominence <= 0)
    result.insert(result.end(), simple.begin(), simple.end());
  else
  {
    const std::vector<Prominence> p = prominences(pm, traces, with_crossing ? nullptr : &sides);
    for(std::size_t i = 0; i < simple.size(); ++i)
      if(p[i].value >= minimum_prominence)
        result.push_back(simple[i]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H
