// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CORNER_ARITHMETIC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CORNER_ARITHMETIC_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Finite_field_number.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_disc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Radical_number.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Square_root_basis.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Work_budget.h>

#include <CGAL/Interval_nt.h>

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Each arithmetic gives the corners of faces, in its own number type, as complex numbers. The corner of halfedge h is
// the one at its source a, between h, which leads to b, and the edge to the third vertex c of the face:
//
//   corner(h)  a positive multiple of e^(i angle), (c - a).(b - a) + i |(c - a) x (b - a)|
//   ratio(h)   the complex number (c - a) / (b - a) in the plane of the face: corner(h) / |b - a|^2

// By intervals of doubles, in the rounding mode that Interval_nt<false> needs.
template <class Surface>
class Interval_arithmetic
{
public:
  typedef Interval_nt<false> NT;

  explicit Interval_arithmetic(const Surface& surface) : m_surface(surface) {}

  Planar<NT> corner(typename Surface::Halfedge h) const
  {
    const Corner c = corner_at(h);
    return {c.dot, c.double_area};
  }

  Planar<NT> ratio(typename Surface::Halfedge h) const
  {
    const Corner c = corner_at(h);
    return {c.dot / c.square_length, c.double_area / c.square_length};
  }

  NT number(int n) const { return NT(n); }
  int certain_sign(const NT& x) const { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; }

  typedef std::array<NT, 3> Vector;

  Vector vector(typename Surface::Vertex from, typename Surface::Vertex to) const
  {
    const Vector p = m_surface.interval_point(from), q = m_surface.interval_point(to);
    return {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}};
  }

  static NT dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  static Vector cross(const Vector& u, const Vector& v)
  {
    return {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  }

private:
  struct Corner
  {
    NT dot, square_length, double_area;
  };

  Corner corner_at(typename Surface::Halfedge h) const
  {
    const auto a = m_surface.source(h);
    const Vector u = vector(a, m_surface.target(h)), v = vector(a, m_surface.source(m_surface.prev(h)));
    const Vector n = cross(u, v);
    const NT square_area = square(n[0]) + square(n[1]) + square(n[2]);
    return {dot(u, v), square(u[0]) + square(u[1]) + square(u[2]), sqrt(square_area)};
  }

  const Surface& m_surface;
};

// The rational numbers that corners are made of, and the complex numbers rounded to `kept_precision` bits, computed
// once for each corner.
template <class Surface>
class Rational_corners
{
public:
  static constexpr mpfr_prec_t kept_precision = 128;

  struct Corner
  {
    Rational dot;           // (c - a).(b - a)
    Rational square_length; // |b - a|^2
    Rational square_area;   // |(c - a) x (b - a)|^2

    std::size_t words() const
    {
      return (std::max)({number_of_words(dot), number_of_words(square_length), number_of_words(square_area)});
    }
  };

  explicit Rational_corners(const Surface& surface) : m_surface(surface) {}

  // Begins a new expression, to which the corners computed from now on belong.
  void begin_expression()
  {
    if(m_corners.size() > max_kept)
      m_corners.clear();
    m_asked_for.clear();
    ++m_expression;
  }

  const Corner& operator()(typename Surface::Halfedge h) { return kept(h).corner; }

  // The complex number corner / |b - a|^2.
  const Planar<Multiprecision_interval>& rounded_ratio(typename Surface::Halfedge h)
  {
    typedef Multiprecision_interval NT;
    Kept& k = kept(h);
    if(!k.has_ratio)
    {
      const Corner& c = k.corner;
      k.ratio = {NT(c.dot / c.square_length, kept_precision),
                 NT::square_root(c.square_area / (c.square_length * c.square_length), kept_precision)};
      k.has_ratio = true;
    }
    return k.ratio;
  }

  // the radicands of all corners that the expression has used
  std::vector<Rational> radicands() const
  {
    std::vector<Rational> result;
    for(const Corner* c : m_asked_for)
      result.push_back(c->square_area);
    return result;
  }

private:
  typedef std::array<Rational, 3> Vector;

  static constexpr std::size_t max_kept = 100000;

  struct Kept
  {
    Corner corner;
    Planar<Multiprecision_interval> ratio;
    bool has_ratio = false;
    std::size_t expression = 0; // that used it last
  };

  Kept& kept(typename Surface::Halfedge h)
  {
    const auto it = m_corners.emplace(h, Kept());
    Kept& k = it.first->second;
    if(it.second)
      k.corner = compute(h);
    if(k.expression != m_expression)
      m_asked_for.push_back(&k.corner);
    k.expression = m_expression;
    return k;
  }

  Corner compute(typename Surface::Halfedge h) const
  {
    const auto a = m_surface.source(h);
    const Vector u = vector(a, m_surface.target(h)), v = vector(a, m_surface.source(m_surface.prev(h)));
    Corner c;
    c.dot = dot(u, v);
    c.square_length = dot(u, u);
    c.square_area = c.square_length * dot(v, v) - c.dot * c.dot;
    return c;
  }

  Vector vector(typename Surface::Vertex from, typename Surface::Vertex to) const
  {
    const Vector p = m_surface.rational_point(from), q = m_surface.rational_point(to);
    return {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}};
  }

  static Rational dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  const Surface& m_surface;
  std::map<typename Surface::Halfedge, Kept> m_corners;
  std::vector<const Corner*> m_asked_for; // by the expression under way
  std::size_t m_expression = 1;
};

// By intervals of a fixed precision. Beyond 256 bits the steps are taken from the budget; throws Too_many_steps.
template <class Surface>
class Multiprecision_arithmetic
{
public:
  typedef Multiprecision_interval NT;

  static constexpr mpfr_prec_t free_precision = 256;

  Multiprecision_arithmetic(Rational_corners<Surface>& corners, mpfr_prec_t precision, Work_budget& budget)
    : m_corners(corners), m_precision(precision), m_budget(budget)
  {}

  Planar<NT> corner(typename Surface::Halfedge h) const
  {
    const auto& c = counted(h);
    return {NT(c.dot, m_precision), NT::square_root(c.square_area, m_precision)};
  }

  Planar<NT> ratio(typename Surface::Halfedge h) const
  {
    if(m_precision == Rational_corners<Surface>::kept_precision)
      return m_corners.rounded_ratio(h);
    const auto& c = counted(h);
    return {NT(c.dot / c.square_length, m_precision),
            NT::square_root(c.square_area / (c.square_length * c.square_length), m_precision)};
  }

  NT number(int n) const { return NT(n, m_precision); }
  int certain_sign(const NT& x) const { return x.certain_sign(); }

private:
  const typename Rational_corners<Surface>::Corner& counted(typename Surface::Halfedge h) const
  {
    const auto& c = m_corners(h);
    if(m_precision > free_precision)
      m_budget.take(Work_budget::steps_of_corner(static_cast<std::size_t>(m_precision / mp_bits_per_limb), c.words()));
    return c;
  }

  Rational_corners<Surface>& m_corners;
  mpfr_prec_t m_precision;
  Work_budget& m_budget;
};

// Thrown when a number has no image in the finite field.
struct No_image
{};

// In the finite field. The roots of the basis are independent, so any choice of their images extends to a homomorphism
// from the numbers whose denominators the prime does not divide. So a number whose image is not zero is not zero.
// Throws No_image and Too_many_steps.
template <class Surface>
class Finite_field_arithmetic
{
public:
  typedef Finite_field_number NT;

  Finite_field_arithmetic(Rational_corners<Surface>& corners, const Square_root_basis& basis, Work_budget& budget)
    : m_corners(corners), m_basis(basis), m_budget(budget)
  {
    for(const Integer& b : basis.basis())
    {
      m_budget.take(Work_budget::steps_of_corner(1, number_of_words(b)));
      m_roots.push_back(NT::square_root(b));
    }
  }

  Planar<NT> corner(typename Surface::Halfedge h) const
  {
    const auto& c = counted(h);
    return {image(c.dot), root(c.square_area)};
  }

  Planar<NT> ratio(typename Surface::Halfedge h) const
  {
    const auto& c = counted(h);
    const NT inverse = image(1 / c.square_length);
    return {image(c.dot) * inverse, root(c.square_area) * inverse};
  }

  NT number(int n) const { return image(n); }

private:
  const typename Rational_corners<Surface>::Corner& counted(typename Surface::Halfedge h) const
  {
    const auto& c = m_corners(h);
    m_budget.take(Work_budget::steps_of_corner(1, c.words()));
    return c;
  }

  static NT image(const Rational& q)
  {
    const auto result = NT::image(q);
    if(!result)
      throw No_image();
    return *result;
  }

  NT root(const Rational& radicand) const
  {
    const Square_root_basis::Root& r = m_basis.root(radicand);
    NT result = image(r.coefficient);
    for(std::size_t i = 0; i < m_roots.size(); ++i)
      if((r.mask >> i) & 1)
        result = result * m_roots[i];
    return result;
  }

  Rational_corners<Surface>& m_corners;
  const Square_root_basis& m_basis;
  Work_budget& m_budget;
  std::vector<NT> m_roots;
};

// By sums of roots. Throws Too_many_steps.
template <class Surface>
class Radical_arithmetic
{
public:
  typedef Radical_number NT;

  Radical_arithmetic(Rational_corners<Surface>& corners, const Square_root_basis& basis, Work_budget& budget)
    : m_corners(corners), m_basis(basis), m_field(basis.basis(), budget)
  {}

  Planar<NT> corner(typename Surface::Halfedge h) const
  {
    const auto& c = m_corners(h);
    return {NT(c.dot, 0, m_field), root(c.square_area, 1)};
  }

  Planar<NT> ratio(typename Surface::Halfedge h) const
  {
    const auto& c = m_corners(h);
    return {NT(c.dot / c.square_length, 0, m_field), root(c.square_area, c.square_length)};
  }

  NT number(int n) const { return NT(n, 0, m_field); }

private:
  NT root(const Rational& radicand, const Rational& divisor) const
  {
    const Square_root_basis::Root& r = m_basis.root(radicand);
    return NT(r.coefficient / divisor, r.mask, m_field);
  }

  Rational_corners<Surface>& m_corners;
  const Square_root_basis& m_basis;
  mutable Radical_field m_field;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CORNER_ARITHMETIC_H
