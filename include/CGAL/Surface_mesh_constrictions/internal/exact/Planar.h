// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PLANAR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PLANAR_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/floating_point_requirements.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A point or vector of the plane that faces are unfolded into, over any number type, with the product of complex
// numbers.
template <class NT>
class Planar
{
public:
  Planar() = default;
  Planar(NT x, NT y) : m_x(std::move(x)), m_y(std::move(y)) {}

  const NT& x() const { return m_x; }
  const NT& y() const { return m_y; }

  friend Planar conjugate(const Planar& a) { return {a.m_x, NT() - a.m_y}; }
  friend Planar operator+(const Planar& a, const Planar& b) { return {a.m_x + b.m_x, a.m_y + b.m_y}; }
  friend Planar operator-(const Planar& a, const Planar& b) { return {a.m_x - b.m_x, a.m_y - b.m_y}; }
  friend Planar operator*(const Planar& a, const Planar& b)
  {
    return {a.m_x * b.m_x - a.m_y * b.m_y, a.m_x * b.m_y + a.m_y * b.m_x};
  }

private:
  NT m_x, m_y;
};

// Over intervals a point or vector is a disc instead of a box. A box grows each time it is turned, and is of no use in
// a long strip. The radius of a product of discs, relative to the distance of the disc from the origin, is hardly
// more than the sum of these relative radii of the factors. The rounding mode is upward, as Interval_nt<false> needs;
// the bounds hold in any rounding mode.
template <>
class Planar<Interval_nt<false>>
{
public:
  typedef Interval_nt<false> NT;

  Planar() = default;

  Planar(const NT& x, const NT& y) : m_x(x.inf() + (x.sup() - x.inf()) / 2), m_y(y.inf() + (y.sup() - y.inf()) / 2)
  {
    const double dx = (std::max)(x.sup() - m_x, m_x - x.inf()), dy = (std::max)(y.sup() - m_y, m_y - y.inf());
    m_radius = inflate(dx + dy);
  }

  NT x() const { return around(m_x); }
  NT y() const { return around(m_y); }

  friend Planar conjugate(const Planar& a) { return Planar(a.m_x, -a.m_y, a.m_radius); }

  friend Planar operator+(const Planar& a, const Planar& b)
  {
    const double x = a.m_x + b.m_x, y = a.m_y + b.m_y;
    return Planar(x, y, inflate(a.m_radius + b.m_radius + unit_roundoff * (std::abs(x) + std::abs(y))));
  }

  friend Planar operator-(const Planar& a, const Planar& b)
  {
    const double x = a.m_x - b.m_x, y = a.m_y - b.m_y;
    return Planar(x, y, inflate(a.m_radius + b.m_radius + unit_roundoff * (std::abs(x) + std::abs(y))));
  }

  friend Planar operator*(const Planar& a, const Planar& b)
  {
    const double x = a.m_x * b.m_x - a.m_y * b.m_y, y = a.m_x * b.m_y + a.m_y * b.m_x;
    const double rounding =
        2 * unit_roundoff * (std::abs(a.m_x) + std::abs(a.m_y)) * (std::abs(b.m_x) + std::abs(b.m_y));
    return Planar(x, y,
                  inflate(a.distance() * b.m_radius + b.distance() * a.m_radius + a.m_radius * b.m_radius + rounding));
  }

private:
  // that of a rounding to either side, which is twice that of a rounding to the nearest
  static constexpr double unit_roundoff = 2.220446049250313e-16;

  Planar(double x, double y, double radius) : m_x(x), m_y(y), m_radius(radius) {}

  // Covers the rounding of the few operations that the bound was computed with, and underflow.
  static double inflate(double bound) { return bound * (1 + 32 * unit_roundoff) + 1e-300; }

  double distance() const { return std::sqrt(m_x * m_x + m_y * m_y); }

  NT around(double x) const
  {
    const double radius = inflate(m_radius + unit_roundoff * std::abs(x));
    return NT(x - radius, x + radius);
  }

  double m_x = 0, m_y = 0, m_radius = 0;
};

// conj(a) b: the dot product of a and b, and their determinant.
template <class NT>
Planar<NT> relative(const Planar<NT>& a, const Planar<NT>& b)
{
  return conjugate(a) * b;
}

// Positive if b lies to the left of a.
template <class NT>
NT determinant(const Planar<NT>& a, const Planar<NT>& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

inline Interval_nt<false> determinant(const Planar<Interval_nt<false>>& a, const Planar<Interval_nt<false>>& b)
{
  return relative(a, b).y();
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_PLANAR_H
