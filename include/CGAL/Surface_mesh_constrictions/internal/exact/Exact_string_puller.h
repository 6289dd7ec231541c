// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_STRING_PULLER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_STRING_PULLER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Shortest path between two vertices inside a strip of faces, as String_puller computes it, with every decision exact.
// A line that passes exactly through a corner of the strip gets a pivot there.
template <class Surface>
class Exact_string_puller
{
public:
  typedef Exact_arc<Surface> Arc;
  typedef typename Surface::Vertex Vertex;
  typedef typename Surface::Halfedge Halfedge;

  explicit Exact_string_puller(Sign_prover<Surface>& prover) : m_prover(prover) {}

  // Appends to `arcs` the shortest path from u to w. The strip must not be empty, and must not cross edges of u at its
  // start or of w at its end. False if a tie could not be proved.
  // O(n) decisions for n crossings, each linear in n.
  bool pull(Vertex u, const std::vector<Halfedge>& strip, Vertex w, std::vector<Arc>& arcs)
  {
    m_strip = &strip;
    m_is_proved = true;
    m_rounded.reset();
    m_precise.reset();
    const std::vector<Corner> bends = find_bends();
    if(!m_is_proved)
      return false;
    Vertex from = u;
    std::size_t first = 0; // the first portal that does not end at `from`
    for(const Corner& bend : bends)
    {
      const Vertex v = corner_vertex(m_prover.surface(), strip[bend.portal], bend.side);
      append_arc(first, bend.portal, from, v, arcs);
      from = v;
      first = bend.portal;
      while(first < strip.size() &&
            (m_prover.surface().source(strip[first]) == v || m_prover.surface().target(strip[first]) == v))
        ++first;
    }
    append_arc(first, strip.size(), from, w, arcs);
    return true;
  }

private:
  // A point of the unfolded strip: an end of a portal, or the start or the end of the path.
  struct Corner
  {
    enum Kind
    {
      START,
      PORTAL,
      END
    } kind;
    std::size_t portal;
    Curve_side side;
  };

  struct Chain
  {
    std::vector<Corner> corners;
    std::size_t head = 0;

    bool empty() const { return head == corners.size(); }
  };

  // The signs of the turn from a over b to c, positive to the left, and of the dot product of b - a and c - b.
  struct Bend
  {
    Proved_sign turn, forward;
  };

  // The whole strip, unfolded once by intervals.
  template <class NT>
  using Unfolded = std::optional<Unfolded_strip<NT>>;

  // The sign of the turn from a over b to c: 1, -1, or 0 if the intervals do not decide it.
  template <class Arithmetic>
  int rounded_turn(const Arithmetic& arithmetic, Unfolded<typename Arithmetic::NT>& unfolded, const Corner& a,
                   const Corner& b, const Corner& c) const
  {
    typedef Planar<typename Arithmetic::NT> Point;
    if(!unfolded)
    {
      Arc whole;
      whole.crossings = *m_strip;
      unfolded = unfold(m_prover.surface(), arithmetic, whole);
    }
    const Point origin(arithmetic.number(0), arithmetic.number(0));
    const auto position = [&](const Corner& corner) -> const Point& {
      return corner.kind == Corner::START ? origin
             : corner.kind == Corner::END ? unfolded->apex
                                          : unfolded->portals[corner.portal].end(corner.side);
    };
    return arithmetic.certain_sign(determinant(position(b) - position(a), position(c) - position(b)));
  }

  Bend bend(const Corner& a, const Corner& b, const Corner& c)
  {
    int turn = 0;
    {
      Interval_nt<false>::Protector upward;
      turn = rounded_turn(Interval_arithmetic<Surface>(m_prover.surface()), m_rounded, a, b, c);
    }
    if(turn != 0)
      m_prover.count_interval();
    else if((turn = rounded_turn(m_prover.multiprecision_arithmetic(), m_precise, a, b, c)) != 0)
      m_prover.count_multiprecision();
    return turn != 0 ? Bend{proved_sign(turn), Proved_sign::UNPROVED} : exact_bend(a, b, c);
  }

  // Decides exactly the signs that the intervals of the whole strip leave open.
  Bend exact_bend(const Corner& a, const Corner& b, const Corner& c)
  {
    // only the part of the strip between the corners is unfolded
    std::size_t begin = m_strip->size(), end = 0;
    for(const Corner& corner : {a, b, c})
    {
      begin = (std::min)(begin, corner.kind == Corner::PORTAL  ? corner.portal
                                : corner.kind == Corner::START ? 0
                                                               : begin);
      end = (std::max)(end, corner.kind == Corner::PORTAL ? corner.portal + 1
                            : corner.kind == Corner::END  ? m_strip->size()
                                                          : 0);
    }
    const bool from_start = a.kind == Corner::START;
    Arc piece;
    piece.crossings.assign(m_strip->begin() + static_cast<std::ptrdiff_t>(begin),
                           m_strip->begin() + static_cast<std::ptrdiff_t>(end));
    const auto place_on_prism = [&](const Prismatic_strip<Surface>& prism, const Corner& corner) {
      return corner.kind == Corner::START ? prism.start()
             : corner.kind == Corner::END ? prism.end()
                                          : prism.corner(corner.portal - begin, corner.side);
    };
    const std::vector<Proved_sign> signs = m_prover.signs(
        2,
        [&](const auto& arithmetic, auto& values) {
          typedef typename std::decay_t<decltype(arithmetic)>::NT NT;
          const Planar<NT> origin(arithmetic.number(0), arithmetic.number(0));
          const Planar<NT> one(arithmetic.number(1), arithmetic.number(0));
          const Surface& s = m_prover.surface();
          const Unfolded_strip<NT> strip =
              from_start ? unfold(s, arithmetic, piece) : unfold(s, arithmetic, {one, origin}, piece.crossings);
          const auto position = [&](const Corner& corner) {
            return corner.kind == Corner::START ? origin
                   : corner.kind == Corner::END ? strip.apex
                                                : strip.portals[corner.portal - begin].end(corner.side);
          };
          const Planar<NT> r = relative(position(b) - position(a), position(c) - position(b));
          values[0] = r.y();
          if(values.wants(1))
            values[1] = r.x();
        },
        [&](std::size_t i) {
          const auto prism =
              i == 0 ? Prismatic_strip<Surface>::make(m_prover.surface(), piece.crossings) : std::nullopt;
          return prism ? prism->turn(place_on_prism(*prism, a), place_on_prism(*prism, b), place_on_prism(*prism, c))
                       : Proved_sign::UNPROVED;
        });
    if(signs[0] == Proved_sign::UNPROVED || (signs[0] == Proved_sign::ZERO && signs[1] == Proved_sign::UNPROVED))
      m_is_proved = false;
    return {signs[0], signs[1]};
  }

  // Moves the end of one side of the funnel to `corner`. The chain of the left side turns to the left, that of the
  // right side to the right.
  void advance(Chain& side, Chain& other, Curve_side which, const Corner& corner, std::vector<Corner>& bends)
  {
    const Proved_sign outward = which == Curve_side::LEFT ? Proved_sign::POSITIVE : Proved_sign::NEGATIVE;
    while(!side.empty())
    {
      const Corner before = side.corners.size() - side.head >= 2 ? side.corners[side.corners.size() - 2] : m_apex;
      const Bend b = bend(before, side.corners.back(), corner);
      if(b.turn == outward || (b.turn == Proved_sign::ZERO && b.forward != Proved_sign::NEGATIVE))
        break;
      side.corners.pop_back();
    }
    if(side.empty())
      while(!other.empty())
      {
        // the new corner lies beyond the other side: the path bends there
        const Bend b = bend(m_apex, other.corners[other.head], corner);
        if(b.turn == outward || (b.turn == Proved_sign::ZERO && b.forward == Proved_sign::NEGATIVE))
          break;
        if(b.turn == Proved_sign::UNPROVED)
          break;
        m_apex = other.corners[other.head];
        bends.push_back(m_apex);
        ++other.head;
      }
    side.corners.push_back(corner);
  }

  std::vector<Corner> find_bends()
  {
    std::vector<Corner> bends;
    m_apex = {Corner::START, 0, Curve_side::LEFT};
    Chain left, right;
    const auto step = [&](Curve_side side, const Corner& corner) {
      if(side == Curve_side::LEFT)
        advance(left, right, side, corner, bends);
      else
        advance(right, left, side, corner, bends);
    };
    right.corners.push_back({Corner::PORTAL, 0, Curve_side::RIGHT});
    left.corners.push_back({Corner::PORTAL, 0, Curve_side::LEFT});
    const std::vector<Strip_corner> corners = strip_corners(m_prover.surface(), *m_strip);
    for(std::size_t c = 2; m_is_proved && c < corners.size(); ++c)
      step(corners[c].side, {Corner::PORTAL, corners[c].portal, corners[c].side});
    step(Curve_side::LEFT, {Corner::END, 0, Curve_side::LEFT});
    left.corners.pop_back();
    bends.insert(bends.end(), left.corners.begin() + static_cast<std::ptrdiff_t>(left.head), left.corners.end());
    return bends;
  }

  // The arc from one bend to the next through portals [first, last).
  void append_arc(std::size_t first, std::size_t last, Vertex from, Vertex to, std::vector<Arc>& arcs) const
  {
    Arc arc;
    arc.from = from;
    arc.to = to;
    arc.location = 0;
    arc.along = Halfedge();
    if(first < last)
      arc.crossings.assign(m_strip->begin() + static_cast<std::ptrdiff_t>(first),
                           m_strip->begin() + static_cast<std::ptrdiff_t>(last));
    else
    {
      arc.along = m_prover.surface().outgoing(from);
      while(m_prover.surface().target(arc.along) != to)
        arc.along = ccw(m_prover.surface(), arc.along);
    }
    arcs.push_back(arc);
  }

  Sign_prover<Surface>& m_prover;
  const std::vector<Halfedge>* m_strip = nullptr;
  Unfolded<Interval_nt<false>> m_rounded;
  Unfolded<Multiprecision_interval> m_precise;
  Corner m_apex = {Corner::START, 0, Curve_side::LEFT};
  bool m_is_proved = true;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_STRING_PULLER_H
