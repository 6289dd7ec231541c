// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BOUNDARY_SHARE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BOUNDARY_SHARE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that runs along one boundary for more than this share of its length is a rim.
constexpr double rim_share = 0.5;

// An arc that cuts off teeth of a jagged boundary runs along it, if the way along the boundary is no more than this
// many times as long.
constexpr double slack_of_boundary = 2;

// The ghost vertex of the hole that a boundary vertex is at, or `null_index`. O(degree) on surfaces with boundary.
inline Index hole_at_vertex(const Progressive_mesh& pm, Index v)
{
  const Index h = pm.along_hole(v);
  return h == null_index ? null_index : pm.source(pm.prev(h));
}

// Whether the way along the boundary from one vertex to another, with the hole on its left, is no longer than this.
// Linear in the edges of the way, times their degrees.
inline bool is_boundary_between(const Progressive_mesh& pm, Index from, Index to, double length)
{
  while(from != to && length >= 0)
  {
    const Index next = pm.target(pm.along_hole(from));
    length -= norm(vector(pm.point(from), pm.point(next)));
    from = next;
  }
  return length >= 0;
}

// The greatest share of the length of a closed curve that runs along the boundary of one hole: along its edges; and, if
// the curve has hardly anything on the side of the hole, less than a disc of the same perimeter, through faces beside
// the boundary from one of its vertices to another. Linear, times the degrees of the pivots.
inline double boundary_share(const Progressive_mesh& pm, const std::vector<Arc>& curve, const Parting& parting)
{
  if(!pm.has_boundary())
    return 0;
  const double length = total_length(curve);
  const bool hardly_anything = parting.is_separating() && isoperimetric_ratio(length, parting.areas) > 1;
  std::map<Index, double> along; // by hole
  for(std::size_t i = 0; i < curve.size(); ++i)
  {
    const Arc& arc = curve[i];
    const Index hole = hole_at_vertex(pm, arc.from);
    if(hole == null_index || hole != hole_at_vertex(pm, arc.to))
      continue;
    bool is_along = arc.is_edge() && pm.is_on_boundary(arc.along);
    if(!is_along && hardly_anything && arc.from != arc.to)
    {
      const Arc &before = curve[(i + curve.size() - 1) % curve.size()], &after = curve[(i + 1) % curve.size()];
      for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
        if(is_hole_on_side(pm, before, arc, side) && is_hole_on_side(pm, arc, after, side))
          is_along = side == Curve_side::LEFT
                         ? is_boundary_between(pm, arc.from, arc.to, slack_of_boundary * arc.length)
                         : is_boundary_between(pm, arc.to, arc.from, slack_of_boundary * arc.length);
    }
    if(is_along)
      along[hole] += arc.length;
  }
  double greatest = 0;
  for(const auto& hole : along)
    greatest = (std::max)(greatest, hole.second);
  return length > 0 ? greatest / length : 0;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BOUNDARY_SHARE_H
