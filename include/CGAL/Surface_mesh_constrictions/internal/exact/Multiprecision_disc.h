// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_DISC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_DISC_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// An upper bound mantissa * 2^exponent of a number that is not negative. The number may have any size: at precisions of
// many thousand bits, radii are no doubles. The operations add what they may lose by rounding, in any rounding mode.
class Upper_bound
{
public:
  Upper_bound() = default;

  static Upper_bound power_of_two(long exponent) { return Upper_bound(1, exponent); }

  static Upper_bound absolute(mpfr_srcptr x)
  {
    if(mpfr_zero_p(x))
      return Upper_bound();
    long exponent = 0;
    const double mantissa = std::abs(mpfr_get_d_2exp(&exponent, x, MPFR_RNDA));
    return Upper_bound(mantissa, exponent);
  }

  // An upper bound of the length of a vector.
  static Upper_bound norm(mpfr_srcptr x, mpfr_srcptr y)
  {
    const Upper_bound a = absolute(x), b = absolute(y);
    const long exponent = common_exponent(a, b);
    const double p = a.scaled(exponent), q = b.scaled(exponent);
    return Upper_bound(std::sqrt(p * p + q * q), exponent);
  }

  // Sets a number to this bound, rounded up.
  void get(mpfr_ptr x) const
  {
    mpfr_set_d(x, m_mantissa, MPFR_RNDU);
    mpfr_mul_2si(x, x, m_exponent, MPFR_RNDU);
  }

  friend Upper_bound operator+(const Upper_bound& a, const Upper_bound& b)
  {
    const long exponent = common_exponent(a, b);
    return Upper_bound(a.scaled(exponent) + b.scaled(exponent), exponent);
  }

  friend Upper_bound operator*(const Upper_bound& a, const Upper_bound& b)
  {
    return Upper_bound(a.m_mantissa * b.m_mantissa, a.m_exponent + b.m_exponent);
  }

private:
  Upper_bound(double mantissa, long exponent)
  {
    if(mantissa == 0)
      return;
    int shift = 0;
    m_mantissa = std::frexp(mantissa * (1 + 1e-15), &shift);
    m_exponent = exponent + shift;
  }

  static long common_exponent(const Upper_bound& a, const Upper_bound& b)
  {
    return a.m_mantissa == 0 ? b.m_exponent : b.m_mantissa == 0 ? a.m_exponent : (std::max)(a.m_exponent, b.m_exponent);
  }

  // The bound as a multiple of 2^exponent, which is not much smaller than the bound.
  double scaled(long exponent) const
  {
    if(m_mantissa == 0)
      return 0;
    const long shift = m_exponent - exponent;
    return shift < -100 ? 1e-30 : std::ldexp(m_mantissa, static_cast<int>(shift));
  }

  double m_mantissa = 0; // 0, or in [1/2, 1)
  long m_exponent = 0;
};

// Points and vectors are discs, for the same reason as over intervals of doubles: boxes of any precision are of no use
// where they are turned hundreds of times.
template <>
class Planar<Multiprecision_interval>
{
public:
  typedef Multiprecision_interval NT;

  Planar() = default;

  Planar(const NT& x, const NT& y) : m_x(x.precision()), m_y(y.precision())
  {
    m_radius = set_to_centre(m_x, x) + set_to_centre(m_y, y);
  }

  NT x() const { return NT::around(m_x.get(), radius().get()); }
  NT y() const { return NT::around(m_y.get(), radius().get()); }

  friend Planar conjugate(Planar a)
  {
    mpfr_neg(a.m_y.get(), a.m_y.get(), MPFR_RNDN);
    return a;
  }

  friend Planar operator+(const Planar& a, const Planar& b)
  {
    Planar result(common_precision(a, b));
    mpfr_add(result.m_x.get(), a.m_x.get(), b.m_x.get(), MPFR_RNDN);
    mpfr_add(result.m_y.get(), a.m_y.get(), b.m_y.get(), MPFR_RNDN);
    result.m_radius = a.m_radius + b.m_radius + result.roundoff() * result.norm();
    return result;
  }

  friend Planar operator-(const Planar& a, const Planar& b)
  {
    Planar result(common_precision(a, b));
    mpfr_sub(result.m_x.get(), a.m_x.get(), b.m_x.get(), MPFR_RNDN);
    mpfr_sub(result.m_y.get(), a.m_y.get(), b.m_y.get(), MPFR_RNDN);
    result.m_radius = a.m_radius + b.m_radius + result.roundoff() * result.norm();
    return result;
  }

  friend Planar operator*(const Planar& a, const Planar& b)
  {
    Planar result(common_precision(a, b));
    Multiprecision_number product(common_precision(a, b));
    mpfr_mul(result.m_x.get(), a.m_x.get(), b.m_x.get(), MPFR_RNDN);
    mpfr_mul(product.get(), a.m_y.get(), b.m_y.get(), MPFR_RNDN);
    mpfr_sub(result.m_x.get(), result.m_x.get(), product.get(), MPFR_RNDN);
    mpfr_mul(result.m_y.get(), a.m_x.get(), b.m_y.get(), MPFR_RNDN);
    mpfr_mul(product.get(), a.m_y.get(), b.m_x.get(), MPFR_RNDN);
    mpfr_add(result.m_y.get(), result.m_y.get(), product.get(), MPFR_RNDN);
    // the six roundings are together less than four times the roundoff of the product of the lengths
    const Upper_bound a_norm = a.norm(), b_norm = b.norm();
    result.m_radius = a_norm * b.m_radius + b_norm * a.m_radius + a.m_radius * b.m_radius +
                      Upper_bound::power_of_two(2) * result.roundoff() * a_norm * b_norm;
    return result;
  }

private:
  explicit Planar(mpfr_prec_t precision) : m_x(precision), m_y(precision) {}

  // Returns a bound of the distance of the numbers of the interval from its centre.
  static Upper_bound set_to_centre(Multiprecision_number& centre, const NT& x)
  {
    mpfr_add(centre.get(), x.low(), x.high(), MPFR_RNDN);
    mpfr_div_2ui(centre.get(), centre.get(), 1, MPFR_RNDN);
    Multiprecision_number below(64), above(64);
    mpfr_sub(below.get(), centre.get(), x.low(), MPFR_RNDU);
    mpfr_sub(above.get(), x.high(), centre.get(), MPFR_RNDU);
    mpfr_max(below.get(), below.get(), above.get(), MPFR_RNDU);
    return Upper_bound::absolute(below.get());
  }

  static mpfr_prec_t common_precision(const Planar& a, const Planar& b)
  {
    return (std::max)({mpfr_get_prec(a.m_x.get()), mpfr_get_prec(a.m_y.get()), mpfr_get_prec(b.m_x.get()),
                       mpfr_get_prec(b.m_y.get())});
  }

  // The greatest change by a rounding to the nearest, relative to the result.
  Upper_bound roundoff() const { return Upper_bound::power_of_two(-static_cast<long>(mpfr_get_prec(m_x.get()))); }

  Upper_bound norm() const { return Upper_bound::norm(m_x.get(), m_y.get()); }

  Multiprecision_number radius() const
  {
    Multiprecision_number result(64);
    m_radius.get(result.get());
    return result;
  }

  Multiprecision_number m_x, m_y;
  Upper_bound m_radius;
};

inline Multiprecision_interval determinant(const Planar<Multiprecision_interval>& a,
                                           const Planar<Multiprecision_interval>& b)
{
  return relative(a, b).y();
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_DISC_H
