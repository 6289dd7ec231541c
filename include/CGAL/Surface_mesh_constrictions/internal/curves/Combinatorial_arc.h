// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COMBINATORIAL_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COMBINATORIAL_ARC_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The piece of a curve between two consecutive pivots, as combinatorics alone: it runs along an edge, or straight
// through the strip of faces between the crossed halfedges. The first crossed halfedge is opposite to `from` in its
// face, the last one opposite to `to` in the face that it is crossed to.
template <class Vertex, class Halfedge, class Crossings = std::vector<Halfedge>>
struct Combinatorial_arc
{
  Vertex from, to;
  Halfedge along;      // the edge's halfedge out of `from`, if there are no crossings
  Crossings crossings; // each halfedge is crossed from its own face to the opposite one

  bool is_edge() const { return crossings.empty(); }
};

template <class Surface, class Halfedge>
Halfedge ccw(const Surface& s, Halfedge h)
{
  return s.opposite(s.prev(h));
}

template <class Surface, class Halfedge>
Halfedge cw(const Surface& s, Halfedge h)
{
  return s.next(s.opposite(h));
}

// The halfedge out of `from` that bounds clockwise the face that the arc leaves through, or that it runs along.
template <class Surface, class Vertex, class Halfedge, class Crossings>
Halfedge start_halfedge(const Surface& s, const Combinatorial_arc<Vertex, Halfedge, Crossings>& arc)
{
  return arc.is_edge() ? arc.along : s.prev(arc.crossings.front());
}

// The halfedge out of `to` that bounds clockwise the face that the arc arrives through, or that it runs along.
template <class Surface, class Vertex, class Halfedge, class Crossings>
Halfedge end_halfedge(const Surface& s, const Combinatorial_arc<Vertex, Halfedge, Crossings>& arc)
{
  return arc.is_edge() ? s.opposite(arc.along) : s.prev(s.opposite(arc.crossings.back()));
}

// Appends the halfedges that a curve crosses when it passes the pivot between two arcs on the given side instead of
// through it: the edges of the pivot strictly between the arcs. `is_whole_turn` tells, for arcs in one face, that this
// side goes around the whole pivot. O(degree).
template <class Surface, class Vertex, class Halfedge, class Crossings>
void append_fan(const Surface& s, const Combinatorial_arc<Vertex, Halfedge, Crossings>& incoming,
                const Combinatorial_arc<Vertex, Halfedge, Crossings>& outgoing, Curve_side side, bool is_whole_turn,
                std::vector<Halfedge>& strip)
{
  const Halfedge in = end_halfedge(s, incoming), out = start_halfedge(s, outgoing);
  if(in == out && !is_whole_turn)
    return;
  if(side == Curve_side::LEFT)
  {
    Halfedge h = incoming.is_edge() ? cw(s, in) : in;
    do
    {
      if(h == out && in != out)
        return;
      strip.push_back(h);
      h = cw(s, h);
    } while(h != out);
    return;
  }
  for(Halfedge h = ccw(s, in);; h = ccw(s, h))
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

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COMBINATORIAL_ARC_H
