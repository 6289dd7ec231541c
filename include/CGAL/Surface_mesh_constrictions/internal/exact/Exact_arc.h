// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The piece of a curve between two consecutive pivots, as combinatorics alone.
template <class Surface>
struct Exact_arc
{
  typedef typename Surface::Vertex Vertex;
  typedef typename Surface::Halfedge Halfedge;

  Vertex from, to;
  Halfedge along;                  // the edge's halfedge out of `from`, if there are no crossings
  std::vector<Halfedge> crossings; // each is crossed from its own face to the opposite one
  std::size_t location;            // of `from` in the curve

  bool is_edge() const { return crossings.empty(); }
};

template <class Surface>
typename Surface::Halfedge ccw(const Surface& s, typename Surface::Halfedge h)
{
  return s.opposite(s.prev(h));
}

template <class Surface>
typename Surface::Halfedge cw(const Surface& s, typename Surface::Halfedge h)
{
  return s.next(s.opposite(h));
}

// The same for both halfedges of an edge.
template <class Surface>
typename Surface::Halfedge edge(const Surface& s, typename Surface::Halfedge h)
{
  return (std::min)(h, s.opposite(h));
}

// The halfedge out of `from` that bounds clockwise the face that the arc leaves through, or that it runs along.
template <class Surface>
typename Surface::Halfedge start_halfedge(const Surface& s, const Exact_arc<Surface>& arc)
{
  return arc.is_edge() ? arc.along : s.prev(arc.crossings.front());
}

// The halfedge out of `to` that bounds clockwise the face that the arc arrives through, or that it runs along.
template <class Surface>
typename Surface::Halfedge end_halfedge(const Surface& s, const Exact_arc<Surface>& arc)
{
  return arc.is_edge() ? s.opposite(arc.along) : s.prev(s.opposite(arc.crossings.back()));
}

// An unfolded halfedge that is crossed: as one goes out of its face, its target is on the left.
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

// Unfolds a strip into the plane, its first portal given. The vectors along the portals are products of numbers of
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

// Unfolds the strip of an arc with crossings, `from` to the origin and its start halfedge to the positive x axis.
template <class Surface, class Arithmetic>
Unfolded_strip<typename Arithmetic::NT> unfold(const Surface& s, const Arithmetic& arithmetic,
                                               const Exact_arc<Surface>& arc)
{
  const Planar<typename Arithmetic::NT> right = {arithmetic.number(1), arithmetic.number(0)};
  return unfold(s, arithmetic, {arithmetic.ratio(s.prev(arc.crossings.front())), right}, arc.crossings);
}

// The direction of an arc at `from`, the start halfedge being the positive x axis.
template <class Surface, class Arithmetic>
Planar<typename Arithmetic::NT> start_direction(const Surface& s, const Arithmetic& arithmetic,
                                                const Exact_arc<Surface>& arc)
{
  if(arc.is_edge())
    return {arithmetic.number(1), arithmetic.number(0)};
  return unfold(s, arithmetic, arc).apex;
}

// The direction from `to` back into the arc, the end halfedge being the positive x axis; of an arc that is unfolded.
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

// A corner of a strip: an end of the portals from number `portal` on, until the end on that side changes.
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

// Appends the halfedges that a curve crosses when it passes the pivot between two arcs on the given side instead of
// through it. `is_whole_turn` tells, for arcs in one face, that this side goes around the whole pivot. O(degree).
template <class Surface>
void append_fan(const Surface& s, const Exact_arc<Surface>& incoming, const Exact_arc<Surface>& outgoing,
                Curve_side side, bool is_whole_turn, std::vector<typename Surface::Halfedge>& strip)
{
  const typename Surface::Halfedge in = end_halfedge(s, incoming), out = start_halfedge(s, outgoing);
  if(in == out && !is_whole_turn)
    return;
  if(side == Curve_side::LEFT)
  {
    typename Surface::Halfedge h = incoming.is_edge() ? cw(s, in) : in;
    do
    {
      if(h == out && in != out)
        return;
      strip.push_back(h);
      h = cw(s, h);
    } while(h != out);
    return;
  }
  for(typename Surface::Halfedge h = ccw(s, in);; h = ccw(s, h))
  {
    if(h == out && outgoing.is_edge())
      return;
    strip.push_back(s.opposite(h));
    if(h == out)
      return;
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARC_H
