// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A piece of a curve between two pivots, on a surface for the exact arithmetic.
template <class Surface>
using Exact_arc = Located_arc<Surface>;

// The same for both halfedges of an edge.
template <class Surface>
typename Surface::Halfedge edge(const Surface& s, typename Surface::Halfedge h)
{
  return (std::min)(h, s.opposite(h));
}

// An unfolded halfedge that is crossed. For a curve that leaves the face of the halfedge, its target is on the left.
template <class NT>
struct Exact_portal
{
  Planar<NT> left, right;

  const Planar<NT>& end(Curve_side side) const { return side == Curve_side::LEFT ? left : right; }
};

template <class NT>
struct Unfolded_strip
{
  std::vector<Exact_portal<NT>> portals;
  Planar<NT> apex; // the corner that the last halfedge is crossed to
};

// Unfolds a strip into the plane. Its first portal is given. The vectors along the portals are products of numbers of
// the faces, not differences of positions, so that intervals stay narrow. Linear.
template <class Surface, class Arithmetic>
Unfolded_strip<typename Arithmetic::NT> unfold(const Surface& s, const Arithmetic& arithmetic,
                                               const Exact_portal<typename Arithmetic::NT>& first,
                                               const std::vector<typename Surface::Halfedge>& strip)
{
  Unfolded_strip<typename Arithmetic::NT> result;
  Exact_portal<typename Arithmetic::NT> portal = first;
  Planar<typename Arithmetic::NT> across = first.left - first.right;
  const Planar<typename Arithmetic::NT> one(arithmetic.number(1), arithmetic.number(0));
  for(std::size_t i = 0; i < strip.size(); ++i)
  {
    result.portals.push_back(portal);
    const typename Surface::Halfedge o = s.opposite(strip[i]);
    const Planar<typename Arithmetic::NT> ratio = arithmetic.ratio(o);
    result.apex = portal.left - across * ratio;
    if(i + 1 == strip.size())
      break;
    const bool moves_left = strip[i + 1] == s.next(o);
    (moves_left ? portal.left : portal.right) = result.apex;
    across = across * (moves_left ? one - ratio : ratio);
  }
  return result;
}

// Unfolds the strip of an arc with crossings, with `from` at the origin and the start halfedge along the positive x
// axis.
template <class Surface, class Arithmetic>
Unfolded_strip<typename Arithmetic::NT> unfold(const Surface& s, const Arithmetic& arithmetic,
                                               const Exact_arc<Surface>& arc)
{
  const Planar<typename Arithmetic::NT> right = {arithmetic.number(1), arithmetic.number(0)};
  return unfold(s, arithmetic, {arithmetic.ratio(s.prev(arc.crossings.front())), right}, arc.crossings);
}

// The direction of an arc at `from`, with the start halfedge along the positive x axis.
template <class Surface, class Arithmetic>
Planar<typename Arithmetic::NT> start_direction(const Surface& s, const Arithmetic& arithmetic,
                                                const Exact_arc<Surface>& arc)
{
  if(arc.is_edge())
    return {arithmetic.number(1), arithmetic.number(0)};
  return unfold(s, arithmetic, arc).apex;
}

// The direction from `to` back into an arc that is unfolded, with the end halfedge along the positive x axis.
template <class Arithmetic>
Planar<typename Arithmetic::NT> end_direction(const Arithmetic& arithmetic,
                                              const Unfolded_strip<typename Arithmetic::NT>& strip)
{
  const Planar<typename Arithmetic::NT> origin = {arithmetic.number(0), arithmetic.number(0)};
  return relative(strip.portals.back().left - strip.apex, origin - strip.apex);
}

template <class Surface, class Arithmetic>
Planar<typename Arithmetic::NT> end_direction(const Surface& s, const Arithmetic& arithmetic,
                                              const Exact_arc<Surface>& arc)
{
  if(arc.is_edge())
    return {arithmetic.number(1), arithmetic.number(0)};
  return end_direction(arithmetic, unfold(s, arithmetic, arc));
}

// The directions of an arc at its ends, rounded: what start_direction() and end_direction() give for intervals.
struct Rounded_directions
{
  Planar<Interval_nt<false>> start, end;
};

// A corner of a strip: the vertex that is the end on one side of portal number `portal`, and of those after it until
// the end on this side changes.
struct Strip_corner
{
  std::size_t portal;
  Curve_side side;
};

// The corners of a strip, in the order in which they are passed.
template <class Surface>
std::vector<Strip_corner> strip_corners(const Surface& s, const std::vector<typename Surface::Halfedge>& strip)
{
  std::vector<Strip_corner> result = {{0, Curve_side::RIGHT}, {0, Curve_side::LEFT}};
  for(std::size_t i = 1; i < strip.size(); ++i)
    result.push_back({i, strip[i] == s.next(s.opposite(strip[i - 1])) ? Curve_side::LEFT : Curve_side::RIGHT});
  return result;
}

// The vertex at an end of a portal.
template <class Surface>
typename Surface::Vertex corner_vertex(const Surface& s, typename Surface::Halfedge h, Curve_side side)
{
  return side == Curve_side::LEFT ? s.target(h) : s.source(h);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H
