// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_PASSES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_PASSES_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A way of a closed geodesic over one vertex beside it. On the way to the vertex the curve is never longer than at one of
// the two ends.
struct Vertex_pass
{
  std::size_t arc;         // of the curve, by place, that is drawn to the vertex
  std::vector<Arc> before; // from the begin of the arc to the vertex
  std::vector<Arc> behind; // from there to the end of the arc
  double length;           // of the curve at the vertex
  Index vertex;
  Curve_side far_side; // of the curve, that it gets to
};

// A curve at the vertex of one of its passes. Linear in the curve.
inline std::vector<Arc> drawn_to_vertex(const std::vector<Arc>& arcs, const Vertex_pass& pass)
{
  const auto at = arcs.begin() + static_cast<std::ptrdiff_t>(pass.arc);
  std::vector<Arc> result(arcs.begin(), at);
  result.insert(result.end(), pass.before.begin(), pass.before.end());
  result.insert(result.end(), pass.behind.begin(), pass.behind.end());
  result.insert(result.end(), at + 1, arcs.end());
  return result;
}

// The halfedges that a closed curve crosses when it is led past each of its pivots on one side.
inline Strip strip_beside(const Progressive_mesh& pm, const std::vector<Arc>& arcs, Curve_side side)
{
  Strip strip;
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    append_fan(pm, arcs[i == 0 ? arcs.size() - 1 : i - 1], arcs[i], side, strip);
    strip.insert(strip.end(), arcs[i].crossings.begin(), arcs[i].crossings.end());
  }
  cancel_backtracks(pm, strip);
  return strip;
}

// The vertices over which a closed geodesic gets if one arc is drawn to them: those at the rim of the strip of faces of
// an arc, or opposite to the edge that it runs along. Only those behind which the curve becomes shorter at once, up to
// a length, the shortest first. While the arc moves to the vertex the curve stays in one strip of faces, where its
// length is a convex function of the places of its crossings. So on the straight way it is never longer than at one of
// its ends.
//
// `angles` of the surface. Linear in the crossings of the curve, and for each vertex at which the surface is curved so
// that there may be a pass linear in the arc and in the number of pivots.
inline std::vector<Vertex_pass> vertex_passes(const Progressive_mesh& pm, const Corner_angles& angles,
                                              const std::vector<Arc>& arcs, double greatest_length,
                                              String_puller& puller)
{
  std::vector<Vertex_pass> result;
  const double length = total_length(arcs);
  Strip before, behind;
  std::vector<Arc> to, from;
  std::vector<Portal> portals;
  const auto total_angle = [&](Index out) { // around the source of a halfedge
    double sum = 0;
    Index h = out;
    do
    {
      sum += angles(h);
      h = pm.ccw(h);
    } while(h != out);
    return sum;
  };
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    const Arc& arc = arcs[i];
    // draws the arc to v, on this side of it, which is an end of its crossing k
    const auto draw_to = [&](Index v, std::size_t k, Curve_side side) {
      if(pm.is_ghost_vertex(v) ||
         std::any_of(arcs.begin(), arcs.end(), [v](const Arc& a) { return a.from == v; })) // then it would meet itself
        return;
      before.assign(arc.crossings.begin(), arc.crossings.begin() + static_cast<std::ptrdiff_t>(k));
      behind.assign(arc.crossings.begin() + static_cast<std::ptrdiff_t>(k), arc.crossings.end());
      to.clear();
      puller.pull(arc.from, before, v, to);
      from.clear();
      puller.pull(v, behind, arc.to, from);
      double drawn = total_length(to);
      for(const Arc& a : from)
        drawn += a.length;
      const double passes = length - arc.length + drawn;
      if(passes > greatest_length || to.empty() || from.empty())
        return;
      const Side_angles at = side_angles(pm, to.back(), from.front(), angles);
      if((side == Curve_side::LEFT ? at.left : at.right) >= CGAL_PI) // it becomes longer
        return;
      result.push_back({i, to, from, passes, v, side});
    };
    if(arc.is_edge())
    {
      draw_to(pm.target(pm.next(arc.along)), 0, Curve_side::LEFT);
      draw_to(pm.target(pm.next(pm.opposite(arc.along))), 0, Curve_side::RIGHT);
      continue;
    }
    portals.assign(1, portal_from_apex(pm, arc.crossings.front()));
    for(std::size_t k = 0; k + 1 < arc.crossings.size(); ++k)
      portals.push_back(next_portal(pm, arc.crossings[k], portals[k], unfold_apex(pm, arc.crossings[k], portals[k]),
                                    arc.crossings[k + 1]));
    const Vector2 end = unfold_apex(pm, arc.crossings.back(), portals.back());
    // No path in the strip makes a greater angle at the vertex than the straight lines to the ends of the arc do.
    const auto may_get_over = [&](Vector2 p, Index out) {
      return total_angle(out) - std::abs(angle(Vector2{0, 0} - p, end - p)) < CGAL_PI;
    };
    for(std::size_t k = 0; k < arc.crossings.size(); ++k)
    {
      const Index h = arc.crossings[k], last = k == 0 ? null_index : arc.crossings[k - 1];
      if((last == null_index || pm.target(last) != pm.target(h)) && may_get_over(portals[k].left, pm.opposite(h)))
        draw_to(pm.target(h), k, Curve_side::LEFT);
      if((last == null_index || pm.source(last) != pm.source(h)) && may_get_over(portals[k].right, h))
        draw_to(pm.source(h), k, Curve_side::RIGHT);
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Vertex_pass& p, const Vertex_pass& q) { return p.length < q.length; });
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_VERTEX_PASSES_H
