// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PRISMATIC_STRIP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PRISMATIC_STRIP_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Root_sum.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A strip of faces on a prism, in a wide sense: each edge that is crossed is parallel to one direction e, or its two
// faces are coplanar. So all faces are parallel to e.
//
// In the unfolding of such a strip each coordinate is linear in square roots. Let e point up, and let n be the normal
// of a face, as seen from outside. In the plane of the face p has height p.e and lies p.(e x n) / |n| to the right,
// both in units of 1 / |e|. Neighbouring faces agree on both coordinates along their common edge, up to a shift to the
// right, since they are coplanar or the edge is parallel to e. So heights in the unfolding are those in space, rational
// numbers, and a way to the right is a sum of rational multiples of 1 / |n|, one for each plane in between.
//
// Therefore the turn of three corners is a Root_sum, whatever the number of faces. And one turn of a closed strip is a
// translation to the right, exactly, because it leads to a vertex of the same height.
template <class Surface>
class Prismatic_strip
{
public:
  typedef typename Surface::Vertex Vertex;
  typedef typename Surface::Halfedge Halfedge;

  // A point of the unfolded strip.
  struct Place
  {
    std::size_t plane; // number of the plane that the point is measured in
    Integer height;
    Integer right; // of the origin of the plane, times |n|
  };

  // None if the strip is not prismatic, or if it lies in a single plane as far as intervals of doubles tell. O(n)
  // operations for n crossings: on intervals if the strip is not prismatic, else on rational numbers.
  static std::optional<Prismatic_strip> make(const Surface& s, const std::vector<Halfedge>& strip)
  {
    Prismatic_strip result(s, strip);
    if(!result.may_be_prismatic() || !result.first_edges_are_parallel())
      return std::nullopt;
    result.take_points();
    if(!result.find_planes())
      return std::nullopt;
    return result;
  }

  // The corner opposite to the first edge, in the face that it is crossed from.
  Place start() const { return place(m_surface->source(m_surface->prev(m_strip.front())), 0); }

  // The corner opposite to the last edge, in the face that it is crossed to.
  Place end() const
  {
    return place(m_surface->source(m_surface->prev(m_surface->opposite(m_strip.back()))), m_strip.size());
  }

  // An end of an edge that is crossed.
  Place corner(std::size_t portal, Curve_side side) const
  {
    return place(corner_vertex(*m_surface, m_strip[portal], side), portal);
  }

  // The sign of the turn from a over b to c, positive to the left.
  Proved_sign turn(const Place& a, const Place& b, const Place& c) const
  {
    const Integer up_to_b = b.height - a.height, up_to_c = c.height - b.height;
    if(up_to_b == 0 && up_to_c == 0)
      return Proved_sign::ZERO;
    std::vector<Integer> coefficients(m_planes.size());
    add_way(a, b, up_to_c, coefficients);
    add_way(b, c, -up_to_b, coefficients);
    return sign_of(coefficients);
  }

  // The height of all places at a vertex.
  Integer height(Vertex v) const { return dot(point(v), m_direction); }

  // POSITIVE if b lies to the right of a, where the direction e points up.
  Proved_sign way_right(const Place& a, const Place& b) const
  {
    std::vector<Integer> coefficients(m_planes.size());
    add_way(a, b, 1, coefficients);
    return sign_of(coefficients);
  }

private:
  // coordinates times a common denominator of all of them: rational arithmetic would look for common divisors all the
  // time
  typedef std::array<Integer, 3> Vector;
  typedef std::array<Interval_nt<false>, 3> Interval_vector;

  struct Plane
  {
    Vector origin;       // a point
    Vector right;        // e x n
    Integer square_norm; // of n
    Integer width;       // from the origin to the edge that leads into the next plane, times |n|
  };

  Prismatic_strip(const Surface& s, const std::vector<Halfedge>& strip) : m_surface(&s), m_strip(strip) {}

  template <class V>
  static V difference(const V& a, const V& b)
  {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
  }

  template <class V>
  static V cross(const V& a, const V& b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }

  static Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  template <class V>
  static bool is_zero(const V& v)
  {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
  }

  static bool may_be_zero(const Interval_vector& v)
  {
    for(const Interval_nt<false>& x : v)
      if(x.inf() > 0 || x.sup() < 0)
        return false;
    return true;
  }

  Vertex apex(Halfedge h) const { return m_surface->source(m_surface->prev(h)); }

  Interval_vector interval_vector(Halfedge h) const
  {
    return difference(m_surface->interval_point(m_surface->target(h)), m_surface->interval_point(m_surface->source(h)));
  }

  Interval_vector interval_normal(Halfedge h) const
  {
    return cross(interval_vector(h), interval_vector(m_surface->next(h)));
  }

  std::array<Rational, 3> rational_vector(Halfedge h) const
  {
    return difference(m_surface->rational_point(m_surface->target(h)), m_surface->rational_point(m_surface->source(h)));
  }

  const Vector& point(Vertex v) const { return m_points.at(v); }

  Vector vector(Halfedge h) const { return difference(point(m_surface->target(h)), point(m_surface->source(h))); }

  Vector normal(Halfedge h) const { return cross(vector(h), vector(m_surface->next(h))); }

  // Finds the edge that gives the direction. False if intervals show that the strip is not prismatic.
  bool may_be_prismatic()
  {
    Interval_nt<false>::Protector upward;
    for(Halfedge h : m_strip)
    {
      m_is_bent.push_back(!may_be_zero(cross(interval_normal(h), interval_normal(m_surface->opposite(h)))));
      if(m_is_bent.back() && !m_direction_edge)
        m_direction_edge = h;
    }
    if(!m_direction_edge)
      return false;
    const Interval_vector e = interval_vector(*m_direction_edge);
    for(std::size_t i = 0; i < m_strip.size(); ++i)
      if(m_is_bent[i] && !may_be_zero(cross(interval_vector(m_strip[i]), e)))
        return false;
    return true;
  }

  // Whether the first two edges that must be parallel to e are parallel to it. A strip that was rotated in doubles
  // fails this test.
  bool first_edges_are_parallel() const
  {
    const auto e = rational_vector(*m_direction_edge);
    std::size_t checked = 0;
    for(std::size_t i = 0; i < m_strip.size() && checked < 2; ++i)
      if(m_is_bent[i] && m_strip[i] != *m_direction_edge)
      {
        if(!is_zero(cross(rational_vector(m_strip[i]), e)))
          return false;
        ++checked;
      }
    return true;
  }

  void take_points()
  {
    std::map<Vertex, std::array<Rational, 3>> points;
    const auto take = [&](Vertex v) {
      if(points.count(v) == 0)
        points.emplace(v, m_surface->rational_point(v));
    };
    take(apex(m_strip.front()));
    for(Halfedge h : m_strip)
    {
      take(m_surface->source(h));
      take(m_surface->target(h));
      take(apex(m_surface->opposite(h)));
    }
    Integer unit = 1;
    for(const auto& p : points)
      for(const Rational& x : p.second)
        unit = lcm(unit, denominator(x));
    for(const auto& p : points)
    {
      Vector& scaled = m_points[p.first];
      for(std::size_t i = 0; i < 3; ++i)
        scaled[i] = numerator(p.second[i]) * (unit / denominator(p.second[i]));
    }
  }

  bool find_planes()
  {
    m_direction = vector(*m_direction_edge);
    if(!add_plane(m_strip.front()))
      return false;
    m_plane_of_face.push_back(0);
    Vector n = normal(m_strip.front());
    for(Halfedge h : m_strip)
    {
      const Halfedge o = m_surface->opposite(h);
      if(is_zero(cross(vector(h), m_direction)))
      {
        m_planes.back().width = right(point(m_surface->source(h)), m_planes.back());
        n = normal(o);
        if(!add_plane(o))
          return false;
      }
      else
      {
        const Vector across = difference(point(apex(o)), point(m_surface->source(h)));
        if(dot(n, across) != 0 || dot(n, normal(o)) <= 0)
          return false; // not coplanar, or folded back
      }
      m_plane_of_face.push_back(m_planes.size() - 1);
    }
    return true;
  }

  // The plane of the face of h, with its origin at source(h). False if the face is degenerate, or not parallel to e.
  bool add_plane(Halfedge h)
  {
    const Vector n = normal(h);
    if(is_zero(n) || dot(n, m_direction) != 0)
      return false;
    m_planes.push_back({point(m_surface->source(h)), cross(m_direction, n), dot(n, n), 0});
    return true;
  }

  static Integer right(const Vector& point, const Plane& plane)
  {
    return dot(difference(point, plane.origin), plane.right);
  }

  Place place(Vertex v, std::size_t face) const
  {
    const std::size_t plane = m_plane_of_face[face];
    return {plane, height(v), right(point(v), m_planes[plane])};
  }

  // Adds the way to the right from a to b, times a factor, to the coefficients of 1 / |n| of the planes.
  void add_way(const Place& a, const Place& b, const Integer& factor, std::vector<Integer>& coefficients) const
  {
    if(factor == 0)
      return;
    coefficients[b.plane] += factor * b.right;
    coefficients[a.plane] -= factor * a.right;
    for(std::size_t i = a.plane; i < b.plane; ++i)
      coefficients[i] += factor * m_planes[i].width;
    for(std::size_t i = b.plane; i < a.plane; ++i)
      coefficients[i] -= factor * m_planes[i].width;
  }

  Proved_sign sign_of(const std::vector<Integer>& coefficients) const
  {
    Root_sum sum;
    for(std::size_t i = 0; i < coefficients.size(); ++i)
      if(coefficients[i] != 0)
        sum.add(Rational(coefficients[i]), 1 / Rational(m_planes[i].square_norm));
    return proved_sign(sum.sign());
  }

  const Surface* m_surface;
  std::vector<Halfedge> m_strip;
  std::optional<Halfedge> m_direction_edge;
  std::vector<bool> m_is_bent; // of each edge: whether intervals show that its faces are not coplanar
  std::map<Vertex, Vector> m_points;
  Vector m_direction;                       // e
  std::vector<Plane> m_planes;              // in the order of the strip
  std::vector<std::size_t> m_plane_of_face; // of the face before each edge, and of the last face
};

// Decides ties of one strip. Makes the Prismatic_strip at the first call.
template <class Surface>
class Prismatic_ties
{
public:
  Prismatic_ties(const Surface& s, const std::vector<typename Surface::Halfedge>& strip) : m_surface(s), m_strip(strip)
  {}

  // The sign that `sign_in(prismatic strip)` finds; UNPROVED if the strip is not prismatic.
  template <class Sign>
  Proved_sign operator()(const Sign& sign_in)
  {
    if(!m_is_made)
      m_prismatic = Prismatic_strip<Surface>::make(m_surface, m_strip);
    m_is_made = true;
    return m_prismatic ? sign_in(*m_prismatic) : Proved_sign::UNPROVED;
  }

private:
  const Surface& m_surface;
  std::vector<typename Surface::Halfedge> m_strip;
  bool m_is_made = false;
  std::optional<Prismatic_strip<Surface>> m_prismatic;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PRISMATIC_STRIP_H
