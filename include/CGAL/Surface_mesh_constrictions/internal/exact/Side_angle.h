// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIDE_ANGLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIDE_ANGLE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How a sum of angles in [0, pi], given as complex numbers, compares with pi, by intervals.
enum class Angle_sum
{
  BELOW_PI,
  AROUND_PI,
  ABOVE_PI,
  UNKNOWN
};

// AROUND_PI means that the sum lies strictly between pi / 2 and 3 pi / 2. `product` becomes the product of the numbers
// unless the answer is ABOVE_PI or UNKNOWN.
template <class Arithmetic>
Angle_sum compare_angle_sum(const Arithmetic& arithmetic, const std::vector<Planar<typename Arithmetic::NT>>& angles,
                            Planar<typename Arithmetic::NT>& product)
{
  Angle_sum sum = Angle_sum::BELOW_PI;
  product = {arithmetic.number(1), arithmetic.number(0)};
  for(const Planar<typename Arithmetic::NT>& angle : angles)
  {
    const Planar<typename Arithmetic::NT> next = product * angle;
    const int sine = arithmetic.certain_sign(next.y()), cosine = arithmetic.certain_sign(next.x());
    if(sine < 0)
      return Angle_sum::ABOVE_PI; // from below pi to below 2 pi, or from around pi to below 5/2 pi
    if(sum == Angle_sum::BELOW_PI)
    {
      if(sine == 0 && cosine == 0)
        return Angle_sum::UNKNOWN;
      if(sine == 0 && cosine < 0)
        sum = Angle_sum::AROUND_PI;
      else if(sine == 0)
      {
        // about 0 or about 2 pi
        const int before = arithmetic.certain_sign(product.x()), added = arithmetic.certain_sign(angle.x());
        if(before < 0 && added < 0)
          return Angle_sum::ABOVE_PI;
        if(before <= 0 && added <= 0)
          return Angle_sum::UNKNOWN;
      }
    }
    else
    {
      if(cosine > 0)
        return Angle_sum::ABOVE_PI;
      if(cosine == 0)
        return Angle_sum::UNKNOWN;
      if(sine > 0)
        sum = Angle_sum::BELOW_PI;
    }
    product = next;
  }
  return sum;
}

template <class Arithmetic>
Angle_sum compare_angle_sum(const Arithmetic& arithmetic, const std::vector<Planar<typename Arithmetic::NT>>& angles)
{
  Planar<typename Arithmetic::NT> product;
  return compare_angle_sum(arithmetic, angles, product);
}

// Compares with pi the angle that a curve makes at a pivot, on one side of it.
template <class Surface>
class Side_angle
{
public:
  typedef Exact_arc<Surface> Arc;
  typedef typename Surface::Halfedge Halfedge;

  // The directions of the arcs may be given, if they are known.
  Side_angle(Sign_prover<Surface>& prover, const Arc& incoming, const Arc& outgoing, Curve_side side,
             const Rounded_directions* of_incoming = nullptr, const Rounded_directions* of_outgoing = nullptr)
    : m_prover(prover), m_incoming(incoming), m_outgoing(outgoing), m_of_incoming(of_incoming),
      m_of_outgoing(of_outgoing), m_side(side),
      m_first(side == Curve_side::LEFT ? start_halfedge(prover.surface(), outgoing)
                                       : end_halfedge(prover.surface(), incoming)),
      m_last(side == Curve_side::LEFT ? end_halfedge(prover.surface(), incoming)
                                      : start_halfedge(prover.surface(), outgoing))
  {}

  // The sign of angle - pi; positive where the side contains a hole, whose angle is infinite. O(degree + crossings of
  // both arcs) operations at each stage of the arithmetic.
  Proved_sign sign_beyond_pi()
  {
    if(m_first == m_last)
    {
      // both arcs in one face, or along its edge
      const Proved_sign inside = m_prover.sign([&](const auto& arithmetic, auto& value) {
        value[0] = determinant(first_direction(arithmetic), last_direction(arithmetic));
      });
      if(inside == Proved_sign::UNPROVED)
        return inside;
      m_is_whole_turn = inside == Proved_sign::NEGATIVE;
      if(!m_is_whole_turn)
        return Proved_sign::NEGATIVE; // no more than a corner of a face
    }
    if(has_ghost())
      return Proved_sign::POSITIVE;
    Angle_sum sum = Angle_sum::UNKNOWN;
    int sine = 0;
    m_prover.decide_by_intervals([&](const auto& arithmetic) {
      Planar<typename std::decay_t<decltype(arithmetic)>::NT> product;
      sum = compare_angle_sum(arithmetic, angles(arithmetic), product);
      if(sum == Angle_sum::AROUND_PI)
        sine = arithmetic.certain_sign(product.y());
      return sum != Angle_sum::UNKNOWN;
    });
    switch(sum)
    {
    case Angle_sum::BELOW_PI:
      return Proved_sign::NEGATIVE;
    case Angle_sum::ABOVE_PI:
      return Proved_sign::POSITIVE;
    case Angle_sum::UNKNOWN:
      return Proved_sign::UNPROVED;
    default:
      return sine != 0 ? proved_sign(-sine) : sign_around_pi();
    }
  }

  // For arcs in one face, whether this side goes around the whole pivot. Known after `sign_beyond_pi()`.
  bool is_whole_turn() const { return m_is_whole_turn; }

private:
  // Whether the side goes around a corner of a ghost.
  bool has_ghost() const
  {
    const Surface& s = m_prover.surface();
    Halfedge h = m_first;
    do
    {
      if(s.is_ghost(h))
        return true;
      h = ccw(s, h);
    } while(h != m_last);
    return false;
  }

  template <class Arithmetic>
  Planar<typename Arithmetic::NT> first_direction(const Arithmetic& arithmetic) const
  {
    return m_side == Curve_side::LEFT ? outgoing_direction(arithmetic) : incoming_direction(arithmetic);
  }

  template <class Arithmetic>
  Planar<typename Arithmetic::NT> last_direction(const Arithmetic& arithmetic) const
  {
    return m_side == Curve_side::LEFT ? incoming_direction(arithmetic) : outgoing_direction(arithmetic);
  }

  template <class Arithmetic>
  Planar<typename Arithmetic::NT> outgoing_direction(const Arithmetic& arithmetic) const
  {
    if constexpr(std::is_same<Arithmetic, Interval_arithmetic<Surface>>::value)
      if(m_of_outgoing != nullptr)
        return m_of_outgoing->start;
    return start_direction(m_prover.surface(), arithmetic, m_outgoing);
  }

  template <class Arithmetic>
  Planar<typename Arithmetic::NT> incoming_direction(const Arithmetic& arithmetic) const
  {
    if constexpr(std::is_same<Arithmetic, Interval_arithmetic<Surface>>::value)
      if(m_of_incoming != nullptr)
        return m_of_incoming->end;
    return end_direction(m_prover.surface(), arithmetic, m_incoming);
  }

  // Angles that add up to the side angle: what is left of the first corner, whole corners, the part of the last one.
  template <class Arithmetic>
  std::vector<Planar<typename Arithmetic::NT>> angles(const Arithmetic& arithmetic) const
  {
    std::vector<Planar<typename Arithmetic::NT>> result;
    result.push_back(relative(first_direction(arithmetic), arithmetic.corner(m_first)));
    for(Halfedge h = ccw(m_prover.surface(), m_first); h != m_last; h = ccw(m_prover.surface(), h))
      result.push_back(arithmetic.corner(h));
    result.push_back(last_direction(arithmetic));
    return result;
  }

  // The sign for a sum around pi: that of minus its sine.
  Proved_sign sign_around_pi()
  {
    return m_prover.sign(
        [&](const auto& arithmetic, auto& value) {
          Planar<typename std::decay_t<decltype(arithmetic)>::NT> product(arithmetic.number(-1), arithmetic.number(0));
          for(const auto& angle : angles(arithmetic))
            product = product * angle;
          value[0] = product.y();
        },
        [this] {
          Proved_sign sign = sign_in_plane();
          if(sign == Proved_sign::UNPROVED)
            sign = sign_on_prism();
          return sign == Proved_sign::UNPROVED && &m_incoming == &m_outgoing ? sign_of_loop() : sign;
        });
  }

  // The same sign if both arcs are edges, and all corners between them lie in one plane, facing the same way: then it is
  // that of the turn from one edge to the other. Found if the plane is by intervals of doubles, as where coordinates are
  // integers; most ties of a body of boxes and voxels are of this kind. O(degree).
  Proved_sign sign_in_plane() const
  {
    if(!m_incoming.crossings.empty() || !m_outgoing.crossings.empty() || m_first == m_last)
      return Proved_sign::UNPROVED;
    const Interval_nt<false>::Protector upward;
    const Surface& s = m_prover.surface();
    const auto arithmetic = Interval_arithmetic<Surface>(s);
    const auto is_zero = [](const Interval_nt<false>& x) { return x.inf() == 0 && x.sup() == 0; };
    const auto v = s.source(m_first);
    const auto first = arithmetic.vector(v, s.target(m_first));
    auto last = first;
    auto normal = arithmetic.cross(first, arithmetic.vector(v, s.source(s.prev(m_first))));
    for(Halfedge h = m_first; h != m_last; h = ccw(s, h))
    {
      const auto next = arithmetic.vector(v, s.source(s.prev(h)));
      const auto its_normal = arithmetic.cross(last, next), turned = arithmetic.cross(normal, its_normal);
      if(!is_zero(turned[0]) || !is_zero(turned[1]) || !is_zero(turned[2]) ||
         arithmetic.certain_sign(arithmetic.dot(normal, its_normal)) <= 0)
        return Proved_sign::UNPROVED;
      last = next;
    }
    const auto turn = arithmetic.dot(arithmetic.cross(first, last), normal);
    const int sign = arithmetic.certain_sign(turn);
    return is_zero(turn) ? Proved_sign::ZERO : sign != 0 ? proved_sign(-sign) : Proved_sign::UNPROVED;
  }

  // The same sign if the curve, led past the pivot on this side, runs on a prism: then the side angle is less than pi
  // if and only if the way from one end of the strip over the pivot to the other end turns to this side.
  Proved_sign sign_on_prism()
  {
    const Surface& s = m_prover.surface();
    std::vector<Halfedge> strip = m_incoming.crossings;
    const std::size_t at_pivot = strip.size();
    append_fan(s, m_incoming, m_outgoing, m_side, m_is_whole_turn, strip);
    if(strip.size() == at_pivot)
      return Proved_sign::UNPROVED;
    strip.insert(strip.end(), m_outgoing.crossings.begin(), m_outgoing.crossings.end());
    const auto prism = Prismatic_strip<Surface>::make(s, strip);
    if(!prism)
      return Proved_sign::UNPROVED;
    const Proved_sign turn = prism->turn(prism->start(), prism->corner(at_pivot, other_side(m_side)), prism->end());
    return m_side == Curve_side::LEFT ? opposite_sign(turn) : turn;
  }

  // A corner of a face, turned counterclockwise or clockwise.
  struct Turned_corner
  {
    Halfedge halfedge;
    bool is_clockwise;
  };

  // The same sign for a curve that has only this pivot. The directions of its arc at both ends are those of one line,
  // so the sum is one of corners alone, those by which the strip turns. Equal angles of opposite orientation cancel, as
  // on symmetric surfaces: a product that would be long may then be short enough to be proved zero.
  Proved_sign sign_of_loop()
  {
    const Surface& s = m_prover.surface();
    const std::vector<Halfedge>& strip = m_incoming.crossings;
    const bool reversed = m_side == Curve_side::RIGHT;
    std::vector<Turned_corner> corners;
    corners.push_back({s.next(s.prev(strip.front())), reversed});
    for(std::size_t i = 0; i < strip.size(); ++i)
    {
      const Halfedge o = s.opposite(strip[i]);
      const bool moves_left = i + 1 < strip.size() && strip[i + 1] == s.next(o);
      corners.push_back({moves_left ? s.next(o) : o, moves_left == reversed});
    }
    for(Halfedge h = m_first; h != m_last || corners.size() == strip.size() + 1; h = ccw(s, h))
      corners.push_back({h, false});
    cancel_opposite(corners);
    return m_prover.sign([&corners](const auto& arithmetic, auto& value) {
      Planar<typename std::decay_t<decltype(arithmetic)>::NT> product(arithmetic.number(-1), arithmetic.number(0));
      for(const Turned_corner& c : corners)
        product = product * (c.is_clockwise ? conjugate(arithmetic.corner(c.halfedge)) : arithmetic.corner(c.halfedge));
      value[0] = product.y();
    });
  }

  // Removes pairs of equal angles of opposite orientation.
  void cancel_opposite(std::vector<Turned_corner>& corners) const
  {
    // an angle is determined by the sign of its cosine and the square of its tangent; a right angle has no tangent
    typedef std::pair<int, Rational> Key;
    Rational_corners<Surface> rational(m_prover.surface());
    std::map<Key, std::vector<std::size_t>> open[2];
    std::vector<bool> is_cancelled(corners.size(), false);
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const auto& c = rational(corners[i].halfedge);
      const int sign = c.dot > 0 ? 1 : c.dot < 0 ? -1 : 0;
      const Key key(sign, sign == 0 ? Rational(0) : Rational(c.square_area / (c.dot * c.dot)));
      std::vector<std::size_t>& partners = open[corners[i].is_clockwise ? 0 : 1][key];
      if(partners.empty())
      {
        open[corners[i].is_clockwise ? 1 : 0][key].push_back(i);
        continue;
      }
      is_cancelled[i] = is_cancelled[partners.back()] = true;
      partners.pop_back();
    }
    std::size_t end = 0;
    for(std::size_t i = 0; i < corners.size(); ++i)
      if(!is_cancelled[i])
        corners[end++] = corners[i];
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(end), corners.end());
  }

  Sign_prover<Surface>& m_prover;
  const Arc &m_incoming, &m_outgoing;
  const Rounded_directions *m_of_incoming, *m_of_outgoing;
  Curve_side m_side;
  Halfedge m_first, m_last; // the side extends counterclockwise from m_first to m_last
  bool m_is_whole_turn = false;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIDE_ANGLE_H
