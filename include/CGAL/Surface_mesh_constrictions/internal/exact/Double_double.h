// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_DOUBLE_DOUBLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_DOUBLE_DOUBLE_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/floating_point_requirements.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The unevaluated sum of two doubles, of which the second is at most half a unit in the last place of the first: about
// 106 bits. The rounding mode is to nearest. The relative error of a sum, a product, a quotient or a square root is at
// most 2^-100, generously; that of the difference of two doubles is zero. (Dekker, A floating-point technique for
// extending the available precision, 1971; Hida, Li, Bailey, Algorithms for quad-double precision, 2001.)
class Double_double
{
public:
  Double_double(double x = 0) : m_high(x), m_low(0) {}

  // a - b without error, unless it overflows.
  static Double_double difference(double a, double b) { return sum_of(a, -b); }

  explicit operator double() const { return m_high + m_low; }

  friend Double_double operator-(const Double_double& a) { return {-a.m_high, -a.m_low}; }

  friend Double_double operator+(const Double_double& a, const Double_double& b)
  {
    const Double_double high = sum_of(a.m_high, b.m_high), low = sum_of(a.m_low, b.m_low);
    const Double_double sum = ordered_sum_of(high.m_high, high.m_low + low.m_high);
    return ordered_sum_of(sum.m_high, sum.m_low + low.m_low);
  }

  friend Double_double operator-(const Double_double& a, const Double_double& b) { return a + (-b); }

  friend Double_double operator*(const Double_double& a, const Double_double& b)
  {
    const Double_double p = product_of(a.m_high, b.m_high);
    return ordered_sum_of(p.m_high, p.m_low + (a.m_high * b.m_low + a.m_low * b.m_high));
  }

  // The quotient, by two steps of a long division.
  friend Double_double operator/(const Double_double& a, const Double_double& b)
  {
    const double first = a.m_high / b.m_high;
    const Double_double rest = a - b * Double_double(first);
    const double second = rest.m_high / b.m_high;
    const Double_double rest_of_rest = rest - b * Double_double(second);
    return ordered_sum_of(first, second) + Double_double(rest_of_rest.m_high / b.m_high);
  }

  // The square root of a number that is not negative, by a step of Newton's method.
  friend Double_double sqrt(const Double_double& a)
  {
    if(!(a.m_high > 0))
      return 0;
    const double root = std::sqrt(a.m_high);
    const Double_double rest = a - product_of(root, root);
    return ordered_sum_of(root, rest.m_high / (2 * root));
  }

private:
  Double_double(double high, double low) : m_high(high), m_low(low) {}

  static Double_double sum_of(double a, double b)
  {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
  }

  // The sum of a and b, where |a| >= |b| or a is zero.
  static Double_double ordered_sum_of(double a, double b)
  {
    const double sum = a + b;
    return {sum, b - (sum - a)};
  }

  static Double_double product_of(double a, double b)
  {
    const double product = a * b;
#ifdef FP_FAST_FMA
    return {product, std::fma(a, b, -product)};
#else
    const Double_double x = halves(a), y = halves(b);
    return {product, ((x.m_high * y.m_high - product) + x.m_high * y.m_low + x.m_low * y.m_high) + x.m_low * y.m_low};
#endif
  }

  // Two numbers of 26 bits that add up to a.
  static Double_double halves(double a)
  {
    const double scaled = 134217729 * a; // 2^27 + 1
    const double high = scaled - (scaled - a);
    return {high, a - high};
  }

  double m_high, m_low;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_DOUBLE_DOUBLE_H
