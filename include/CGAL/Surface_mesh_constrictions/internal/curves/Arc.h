// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARC_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Combinatorial_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A sequence of crossed halfedges. Each is crossed from its own face to the opposite one.
typedef std::vector<Index> Strip;

// The crossed halfedges of an arc; a few are stored in place. Boost's small_vector forgets its place when its elements are
// moved away, so that it allocates memory when others are moved to it, in an assignment that promises not to throw: where
// there is no memory the program ends. This assignment constructs it anew, in which case small_vector allocates nothing.
class Arc_crossings : public boost::container::small_vector<Index, 6>
{
public:
  Arc_crossings() = default;
  Arc_crossings(const Arc_crossings&) = default;
  Arc_crossings(Arc_crossings&&) = default;
  Arc_crossings& operator=(const Arc_crossings&) = default;

  Arc_crossings& operator=(Arc_crossings&& other) noexcept
  {
    if(this != &other)
    {
      this->~Arc_crossings();
      new(this) Arc_crossings(std::move(other));
    }
    return *this;
  }

  ~Arc_crossings() = default;
};

// A piece of a curve on a progressive mesh between two pivots, measured.
struct Arc : Combinatorial_arc<Index, Index, Arc_crossings>
{
  double length = 0;
  double start_angle = 0; // at `from`, counterclockwise from start_halfedge() to the arc
  double end_angle = 0;   // at `to`, counterclockwise from end_halfedge() to the arc

  Arc() { from = to = along = null_index; }
};

// Computes the length and the angles of an arc from its combinatorics alone, so that equal arcs have bitwise equal
// lengths. Linear in the number of crossings.
inline void measure(const Progressive_mesh& pm, Arc& arc)
{
  if(arc.is_edge())
  {
    arc.length = norm(vector(pm.point(arc.from), pm.point(arc.to)));
    arc.start_angle = arc.end_angle = 0;
    return;
  }
  Portal portal = portal_from_apex(pm, arc.crossings.front());
  for(std::size_t i = 0; i < arc.crossings.size(); ++i)
  {
    const Vector2 apex = unfold_apex(pm, arc.crossings[i], portal);
    if(i + 1 == arc.crossings.size())
    {
      arc.length = norm(apex);
      arc.start_angle = std::atan2(apex.y, apex.x);
      arc.end_angle = angle(portal.left - apex, Vector2{0, 0} - apex);
      return;
    }
    portal = next_portal(pm, arc.crossings[i], portal, apex, arc.crossings[i + 1]);
  }
}

// The sum of the lengths of measured arcs.
inline double total_length(const std::vector<Arc>& arcs)
{
  double sum = 0;
  for(const Arc& a : arcs)
    sum += a.length;
  return sum;
}

// The angles on the two sides of a curve at a pivot, along the surface.
struct Side_angles
{
  double left, right;
};

// Side angles between the arc that arrives at a pivot and the one that leaves it. corner(h) is the angle at source(h)
// in the face of h. On the boundary the side that the hole is on has an infinite angle. O(degree).
template <class Corner>
Side_angles side_angles(const Progressive_mesh& pm, const Arc& incoming, const Arc& outgoing, const Corner& corner)
{
  const Index out = start_halfedge(pm, outgoing), in = end_halfedge(pm, incoming);
  double total = 0, left = 0;
  Index h = out;
  do
  {
    if(h == in)
      left = total + incoming.end_angle - outgoing.start_angle;
    total += corner(h);
    h = pm.ccw(h);
  } while(h != out);
  if(total == (std::numeric_limits<double>::infinity)())
  {
    if(in == out)
      return incoming.end_angle >= outgoing.start_angle ? Side_angles{incoming.end_angle - outgoing.start_angle, total}
                                                        : Side_angles{total, outgoing.start_angle - incoming.end_angle};
    if(left < total)
      return {(std::max)(left, 0.), total};
    double right = outgoing.start_angle - incoming.end_angle;
    for(h = in; h != out; h = pm.ccw(h))
      right += corner(h);
    return {total, (std::max)(right, 0.)};
  }
  if(left < 0) // by rounding, unless the arc that arrives lies clockwise of the one that leaves in the same face
    left = in == out ? left + total : 0;
  return {left, total - left};
}

inline Side_angles side_angles(const Progressive_mesh& pm, const Arc& incoming, const Arc& outgoing)
{
  return side_angles(pm, incoming, outgoing, [&pm](Index h) { return corner_angle(pm, h); });
}

// Whether the hole at a pivot on the boundary is on the given side of a curve, so that the curve cannot pass the pivot
// there. O(degree) on surfaces with boundary.
inline bool is_hole_on_side(const Progressive_mesh& pm, const Arc& incoming, const Arc& outgoing, Curve_side side)
{
  if(!pm.has_boundary())
    return false;
  const Side_angles angles = side_angles(pm, incoming, outgoing);
  return (side == Curve_side::LEFT ? angles.left : angles.right) == (std::numeric_limits<double>::infinity)();
}

// Appends to `strip` the halfedges that a curve crosses when it passes the pivot between two arcs on the given side
// instead of through it. Of arcs in one face, or along its edge, one side holds no edge. O(degree).
inline void append_fan(const Progressive_mesh& pm, const Arc& incoming, const Arc& outgoing, Curve_side side,
                       Strip& strip)
{
  append_fan(pm, incoming, outgoing, side,
             side == Curve_side::LEFT ? incoming.end_angle < outgoing.start_angle
                                      : incoming.end_angle > outgoing.start_angle,
             strip);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARC_H
