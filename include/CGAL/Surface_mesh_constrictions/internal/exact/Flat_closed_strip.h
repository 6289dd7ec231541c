// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_CLOSED_STRIP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_CLOSED_STRIP_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The portals of one turn of a cyclic strip, and the first portal of the next turn. The first portal runs from 0, its
// right end, to 1.
template <class Surface, class Arithmetic>
std::vector<Exact_portal<typename Arithmetic::NT>> unfold_turn(const Surface& s, const Arithmetic& arithmetic,
                                                               std::vector<typename Surface::Halfedge> strip)
{
  typedef Planar<typename Arithmetic::NT> Point;
  strip.push_back(strip.front());
  const Point right = {arithmetic.number(0), arithmetic.number(0)}, left = {arithmetic.number(1), arithmetic.number(0)};
  return unfold(s, arithmetic, {left, right}, strip).portals;
}

// A closed strip of faces whose unfolding along one turn is a translation. Such a strip lies on one side of a closed
// geodesic all of whose angles on that side are pi, or around a closed geodesic without pivots. The corners of the
// strip on the side to which the curve is moved are numbered.
template <class Surface>
class Flat_closed_strip
{
public:
  typedef Exact_arc<Surface> Arc;
  typedef typename Surface::Halfedge Halfedge;
  typedef typename Surface::Vertex Vertex;

  // `side` is the side to which the curve is moved. The strip is cyclic.
  Flat_closed_strip(Sign_prover<Surface>& prover, std::vector<Halfedge> strip, Curve_side side)
    : m_prover(prover), m_strip(std::move(strip)), m_side(side)
  {
    // the first portal begins a corner of that side
    while(m_first < m_strip.size() && vertex(m_first) == vertex(m_first + m_strip.size() - 1))
      ++m_first;
    if(m_first < m_strip.size())
      std::rotate(m_strip.begin(), m_strip.begin() + static_cast<std::ptrdiff_t>(m_first), m_strip.end());
    for(std::size_t i = 0; i < m_strip.size(); ++i)
      if(i == 0 || vertex(i) != vertex(i - 1))
        m_corners.push_back(i);
  }

  // Whether the strip closes around one vertex. Then no other function may be called.
  bool is_degenerate() const { return m_corners.size() < 2; }

  // Numbers of the corners that the curve meets first. Empty if a tie could not be proved.
  std::vector<std::size_t> nearest_corners()
  {
    const Proved_sign nearer = m_side == Curve_side::LEFT ? Proved_sign::NEGATIVE : Proved_sign::POSITIVE;
    std::optional<Prismatic_heights> heights;
    for(std::size_t best = probably_nearest_corner();;)
    {
      std::vector<std::size_t> others;
      for(std::size_t i = 0; i < m_corners.size(); ++i)
        if(i != best)
          others.push_back(i);
      const std::vector<Proved_sign> signs = m_prover.signs(
          others.size(),
          [&](const auto& arithmetic, auto& values) {
            const auto portals = unfold_turn(m_prover.surface(), arithmetic, m_strip);
            const auto turn = portals.back().right - portals.front().right;
            for(std::size_t i = 0; i < others.size(); ++i)
              if(values.wants(i))
                values[i] =
                    determinant(turn, portals[m_corners[others[i]]].end(m_side) - portals[m_corners[best]].end(m_side));
          },
          [&](std::size_t i) {
            if(!heights)
              heights = heights_on_prism();
            return heights->empty() ? Proved_sign::UNPROVED
                                    : proved_sign(Integer((*heights)[others[i]] - (*heights)[best]));
          });
      const auto it = std::find(signs.begin(), signs.end(), nearer);
      if(it != signs.end())
      {
        best = others[static_cast<std::size_t>(it - signs.begin())];
        continue;
      }
      if(contains(signs, Proved_sign::UNPROVED))
        return std::vector<std::size_t>();
      std::vector<std::size_t> result;
      for(std::size_t i = 0; i < m_corners.size(); ++i)
        if(i == best || signs[i - (i > best ? 1 : 0)] == Proved_sign::ZERO)
          result.push_back(i);
      return result;
    }
  }

  // The portal of a corner, as numbered in the strip that was given.
  std::size_t portal_of_corner(std::size_t corner) const { return (m_corners[corner] + m_first) % m_strip.size(); }

  // The copy of the curve that passes through corners at the same height.
  std::vector<Arc> curve_through(const std::vector<std::size_t>& corners) const
  {
    const Surface& s = m_prover.surface();
    std::vector<Arc> arcs;
    for(std::size_t c = 0; c < corners.size(); ++c)
    {
      const std::size_t begin = m_corners[corners[c]], end = m_corners[corners[(c + 1) % corners.size()]];
      Arc arc;
      arc.from = vertex(begin);
      arc.to = vertex(end);
      arc.location = 0;
      std::size_t i = begin;
      do
      {
        i = (i + 1) % m_strip.size();
      } while(i != end && vertex(i) == arc.from);
      const Halfedge o = s.opposite(m_strip[(i + m_strip.size() - 1) % m_strip.size()]);
      arc.along = m_side == Curve_side::LEFT ? s.opposite(s.prev(o)) : s.next(o);
      for(; i != end; i = (i + 1) % m_strip.size())
        arc.crossings.push_back(m_strip[i]);
      arcs.push_back(arc);
    }
    return arcs;
  }

  // The distance between the parallel lines through a corner and through the other end of portal `portal` of the strip
  // given, in the unit of the coordinates; rounded.
  double distance(std::size_t corner, Halfedge portal) const
  {
    Interval_nt<false>::Protector upward;
    const Interval_arithmetic<Surface> arithmetic(m_prover.surface());
    const auto portals = unfold_turn(m_prover.surface(), arithmetic, m_strip);
    const auto turn = portals.back().right - portals.front().right;
    const std::size_t i = static_cast<std::size_t>(std::find(m_strip.begin(), m_strip.end(), portal) - m_strip.begin());
    const auto across = portals[m_corners[corner]].end(m_side) - portals[i].end(other_side(m_side));
    const auto scale = square_length(m_strip.front()) / (square(turn.x()) + square(turn.y()));
    const double height = CGAL::to_double(determinant(turn, across)), factor = CGAL::to_double(scale);
    return std::abs(height) * std::sqrt(factor);
  }

private:
  typedef std::vector<Integer> Prismatic_heights;

  // On a prism, how far the corners lie to the left, as seen along the turn, from some point and in some unit; else
  // empty.
  Prismatic_heights heights_on_prism() const
  {
    std::vector<Halfedge> turn = m_strip;
    turn.push_back(m_strip.front());
    Prismatic_heights result;
    const auto prism = Prismatic_strip<Surface>::make(m_prover.surface(), turn);
    if(!prism)
      return result;
    const bool is_right =
        prism->way_right(prism->corner(0, m_side), prism->corner(m_strip.size(), m_side)) == Proved_sign::POSITIVE;
    for(std::size_t c : m_corners)
      result.push_back(is_right ? prism->height(vertex(c)) : Integer(-prism->height(vertex(c))));
    return result;
  }

  // The corner that the curve meets first, up to rounding.
  std::size_t probably_nearest_corner() const
  {
    Interval_nt<false>::Protector upward;
    const Interval_arithmetic<Surface> arithmetic(m_prover.surface());
    const auto portals = unfold_turn(m_prover.surface(), arithmetic, m_strip);
    const auto turn = portals.back().right - portals.front().right;
    std::size_t best = 0;
    double least = 0;
    for(std::size_t i = 0; i < m_corners.size(); ++i)
    {
      const double height = CGAL::to_double(determinant(turn, portals[m_corners[i]].end(m_side)));
      const double distance = m_side == Curve_side::LEFT ? height : -height;
      if(i == 0 || distance < least)
      {
        best = i;
        least = distance;
      }
    }
    return best;
  }

  Vertex vertex(std::size_t portal) const
  {
    return corner_vertex(m_prover.surface(), m_strip[portal % m_strip.size()], m_side);
  }

  Interval_nt<false> square_length(Halfedge h) const
  {
    const auto p = m_prover.surface().interval_point(m_prover.surface().source(h));
    const auto q = m_prover.surface().interval_point(m_prover.surface().target(h));
    return square(q[0] - p[0]) + square(q[1] - p[1]) + square(q[2] - p[2]);
  }

  Sign_prover<Surface>& m_prover;
  std::vector<Halfedge> m_strip;
  std::size_t m_first = 0; // its first portal, as numbered in the strip that was given
  Curve_side m_side;
  std::vector<std::size_t> m_corners; // the first portal of each
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_CLOSED_STRIP_H
