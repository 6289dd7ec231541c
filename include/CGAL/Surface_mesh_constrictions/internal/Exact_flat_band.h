// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_BAND_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_BAND_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/Side_angle.h>
#include <CGAL/Surface_mesh_constrictions/internal/Sign_prover.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The signs of angle - pi at all pivots of a closed curve, on one side. Element i is that of the pivot where arc i
// starts.
template <class Surface>
std::vector<Proved_sign> signs_beyond_pi(Sign_prover<Surface>& prover, const std::vector<Exact_arc<Surface> >& arcs,
                                         Curve_side side)
{
  std::vector<Proved_sign> result;
  for(std::size_t i = 0; i < arcs.size(); ++i)
    result.push_back(
        Side_angle<Surface>(prover, arcs[(i + arcs.size() - 1) % arcs.size()], arcs[i], side).sign_beyond_pi());
  return result;
}

inline bool contains(const std::vector<Proved_sign>& signs, Proved_sign sign)
{
  return std::find(signs.begin(), signs.end(), sign) != signs.end();
}

// A closed strip of faces whose unfolding along one turn is a translation: what lies on one side of a closed geodesic
// with all angles on that side equal to pi, or around one without pivots.
template <class Surface>
class Flat_closed_strip
{
public:
  typedef Exact_arc<Surface> Arc;
  typedef typename Surface::Halfedge Halfedge;
  typedef typename Surface::Vertex Vertex;

  // `side` is the side to which the curve is moved. The strip is cyclic and does not close around one vertex.
  Flat_closed_strip(Sign_prover<Surface>& prover, std::vector<Halfedge> strip, Curve_side side)
    : m_prover(prover), m_strip(std::move(strip)), m_side(side)
  {
    // the first portal begins a corner of that side
    std::size_t first = 0;
    while(first < m_strip.size() && vertex(first) == vertex(first + m_strip.size() - 1))
      ++first;
    if(first < m_strip.size())
      std::rotate(m_strip.begin(), m_strip.begin() + static_cast<std::ptrdiff_t>(first), m_strip.end());
    for(std::size_t i = 0; i < m_strip.size(); ++i)
      if(i == 0 || vertex(i) != vertex(i - 1))
        m_corners.push_back(i);
  }

  bool is_degenerate() const { return m_corners.size() < 2; }

  // Numbers of the corners that the curve meets first. Empty if a tie could not be proved.
  std::vector<std::size_t> nearest_corners()
  {
    const Proved_sign nearer = m_side == Curve_side::LEFT ? Proved_sign::NEGATIVE : Proved_sign::POSITIVE;
    for(std::size_t best = 0;;)
    {
      std::vector<std::size_t> others;
      for(std::size_t i = 0; i < m_corners.size(); ++i)
        if(i != best)
          others.push_back(i);
      const std::vector<Proved_sign> signs =
          m_prover.signs(others.size(), [&](const auto& arithmetic, auto& values) {
            const auto strip = unfold_turn(arithmetic);
            const auto turn = strip.portals.back().right - strip.portals.front().right;
            for(std::size_t i = 0; i < others.size(); ++i)
              if(values.wants(i))
                values[i] = determinant(turn, strip.portals[m_corners[others[i]]].end(m_side) -
                                                  strip.portals[m_corners[best]].end(m_side));
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

  // The portal of a corner, as numbered in the strip that the constructor was given.
  std::size_t portal_of_corner(std::size_t corner, const std::vector<Halfedge>& strip) const
  {
    const std::size_t rotated = m_corners[corner];
    for(std::size_t shift = 0;; ++shift)
      if(std::equal(m_strip.begin(), m_strip.end() - static_cast<std::ptrdiff_t>(shift),
                    strip.begin() + static_cast<std::ptrdiff_t>(shift)))
        return (rotated + shift) % strip.size();
  }

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
      do {
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
    const auto strip = unfold_turn(arithmetic);
    const auto turn = strip.portals.back().right - strip.portals.front().right;
    const std::size_t i =
        static_cast<std::size_t>(std::find(m_strip.begin(), m_strip.end(), portal) - m_strip.begin());
    const auto across = strip.portals[m_corners[corner]].end(m_side) - strip.portals[i].end(other(m_side));
    const auto scale = square_length(m_strip.front()) / (square(turn.x()) + square(turn.y()));
    const double height = CGAL::to_double(determinant(turn, across)), factor = CGAL::to_double(scale);
    return std::abs(height) * std::sqrt(factor);
  }

private:
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

  // The portals of one turn and the first one of the next.
  template <class Arithmetic>
  Unfolded_strip<typename Arithmetic::NT> unfold_turn(const Arithmetic& arithmetic) const
  {
    typedef Planar<typename Arithmetic::NT> Point;
    std::vector<Halfedge> turn = m_strip;
    turn.push_back(m_strip.front());
    const Point right = {arithmetic.number(0), arithmetic.number(0)}, left = {arithmetic.number(1), arithmetic.number(0)};
    return unfold(m_prover.surface(), arithmetic, {left, right}, turn);
  }

  Sign_prover<Surface>& m_prover;
  std::vector<Halfedge> m_strip;
  Curve_side m_side;
  std::vector<std::size_t> m_corners; // first portals
};

// What happens at the end of a flat band.
enum class Band_outcome { HOLDS, LEAKS, UNPROVED };

template <class Surface>
struct Exact_band_end
{
  Band_outcome outcome;
  std::vector<Exact_arc<Surface> > curve; // the last copy
  double width;                           // from the curve that the band was followed from
};

// Moves a closed geodesic, all of whose angles on a side are pi, through the flat band on that side to its end: the
// first copy with an angle on that side other than pi. The end leaks if one of them is less. A band that closes in
// itself, around a flat torus, holds.
// O(copies that meet vertices) steps, each linear in the faces of the band, times the cost of the arithmetic.
template <class Surface>
Exact_band_end<Surface> follow_flat_band(Sign_prover<Surface>& prover, std::vector<Exact_arc<Surface> > curve,
                                         Curve_side side)
{
  typedef typename Surface::Halfedge Halfedge;
  const Surface& s = prover.surface();
  double width = 0;
  std::set<typename Surface::Vertex> visited;
  for(;;)
  {
    // the fan at a pivot whose angle is pi consists of whole edges, so arcs in one face go around the whole pivot
    std::vector<Halfedge> strip;
    Halfedge at_pivot = Halfedge();
    bool has_fan = false;
    for(std::size_t i = 0; i < curve.size(); ++i)
    {
      strip.insert(strip.end(), curve[i].crossings.begin(), curve[i].crossings.end());
      const std::size_t before = strip.size();
      append_fan(s, curve[i], curve[(i + 1) % curve.size()], side, true, strip);
      if(strip.size() > before)
      {
        has_fan = true;
        at_pivot = strip[before];
      }
    }
    Flat_closed_strip<Surface> band(prover, strip, side);
    if(!has_fan || band.is_degenerate())
      return {Band_outcome::UNPROVED, curve, width};
    const std::vector<std::size_t> corners = band.nearest_corners();
    if(corners.empty())
      return {Band_outcome::UNPROVED, curve, width};
    std::vector<Exact_arc<Surface> > moved = band.curve_through(corners);
    if(!visited.insert(moved.front().from).second)
      return {Band_outcome::HOLDS, curve, width};
    width += band.distance(corners.front(), at_pivot);
    curve = std::move(moved);
    const std::vector<Proved_sign> signs = signs_beyond_pi(prover, curve, side);
    if(contains(signs, Proved_sign::NEGATIVE))
      return {Band_outcome::LEAKS, curve, width};
    if(contains(signs, Proved_sign::UNPROVED))
      return {Band_outcome::UNPROVED, curve, width};
    if(contains(signs, Proved_sign::POSITIVE))
      return {Band_outcome::HOLDS, curve, width};
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLAT_BAND_H
