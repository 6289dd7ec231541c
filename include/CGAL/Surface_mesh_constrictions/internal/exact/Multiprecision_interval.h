// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_INTERVAL_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_INTERVAL_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>

#include <mpfr.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A floating-point number of MPFR. Up to 256 bits its digits are stored in place: to ask for memory takes longer than
// to compute with them.
class Multiprecision_number
{
public:
  explicit Multiprecision_number(mpfr_prec_t precision = MPFR_PREC_MIN) { initialize(precision); }

  Multiprecision_number(const Multiprecision_number& x)
  {
    initialize(mpfr_get_prec(x.m_value));
    mpfr_set(m_value, x.m_value, MPFR_RNDN);
  }

  Multiprecision_number& operator=(const Multiprecision_number& x)
  {
    if(this == &x)
      return *this;
    if(mpfr_get_prec(m_value) != mpfr_get_prec(x.m_value))
    {
      finish();
      initialize(mpfr_get_prec(x.m_value));
    }
    mpfr_set(m_value, x.m_value, MPFR_RNDN);
    return *this;
  }

  ~Multiprecision_number() { finish(); }

  mpfr_ptr get() { return m_value; }
  mpfr_srcptr get() const { return m_value; }

private:
  static constexpr mpfr_prec_t precision_in_place = 256;

  bool is_in_place() const { return mpfr_get_prec(m_value) <= precision_in_place; }

  void initialize(mpfr_prec_t precision)
  {
    if(precision <= precision_in_place)
    {
      mpfr_custom_init(m_limbs, precision);
      mpfr_custom_init_set(m_value, MPFR_ZERO_KIND, 0, precision, m_limbs);
      return;
    }
    mpfr_init2(m_value, precision);
    mpfr_set_zero(m_value, 1);
  }

  void finish()
  {
    if(!is_in_place())
      mpfr_clear(m_value);
  }

  mpfr_t m_value;
  mp_limb_t m_limbs[(precision_in_place + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS];
};

// Bounds of a real number, rounded outwards. Results have the precision of the more precise operand.
class Multiprecision_interval
{
public:
  Multiprecision_interval() = default;

  Multiprecision_interval(const Rational& q, mpfr_prec_t precision) : Multiprecision_interval(precision)
  {
    mpfr_set_q(m_low.get(), q.backend().data(), MPFR_RNDD);
    mpfr_set_q(m_high.get(), q.backend().data(), MPFR_RNDU);
  }

  // Bounds of the square root of a number that is not negative.
  static Multiprecision_interval square_root(const Rational& q, mpfr_prec_t precision)
  {
    Multiprecision_interval result(q, precision);
    mpfr_sqrt(result.m_low.get(), result.m_low.get(), MPFR_RNDD);
    mpfr_sqrt(result.m_high.get(), result.m_high.get(), MPFR_RNDU);
    return result;
  }

  // The numbers that are no further from `centre` than `radius`.
  static Multiprecision_interval around(mpfr_srcptr centre, mpfr_srcptr radius)
  {
    Multiprecision_interval result(mpfr_get_prec(centre));
    mpfr_sub(result.m_low.get(), centre, radius, MPFR_RNDD);
    mpfr_add(result.m_high.get(), centre, radius, MPFR_RNDU);
    return result;
  }

  mpfr_srcptr low() const { return m_low.get(); }
  mpfr_srcptr high() const { return m_high.get(); }
  mpfr_prec_t precision() const { return mpfr_get_prec(m_low.get()); }

  // 1 or -1; 0 if the interval contains 0.
  int certain_sign() const { return mpfr_sgn(m_low.get()) > 0 ? 1 : mpfr_sgn(m_high.get()) < 0 ? -1 : 0; }

  friend Multiprecision_interval operator+(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    Multiprecision_interval result(common_precision(a, b));
    mpfr_add(result.m_low.get(), a.m_low.get(), b.m_low.get(), MPFR_RNDD);
    mpfr_add(result.m_high.get(), a.m_high.get(), b.m_high.get(), MPFR_RNDU);
    return result;
  }

  friend Multiprecision_interval operator-(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    Multiprecision_interval result(common_precision(a, b));
    mpfr_sub(result.m_low.get(), a.m_low.get(), b.m_high.get(), MPFR_RNDD);
    mpfr_sub(result.m_high.get(), a.m_high.get(), b.m_low.get(), MPFR_RNDU);
    return result;
  }

  friend Multiprecision_interval operator*(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    const mpfr_prec_t precision = common_precision(a, b);
    Multiprecision_interval result(precision);
    const int a_sign = a.weak_sign(), b_sign = b.weak_sign();
    if(a_sign != 0 && b_sign != 0)
    {
      // which ends make the least and the greatest product
      mpfr_srcptr const a_low = b_sign > 0 ? a.m_low.get() : a.m_high.get();
      mpfr_srcptr const a_high = b_sign > 0 ? a.m_high.get() : a.m_low.get();
      mpfr_srcptr const b_low = a_sign > 0 ? b.m_low.get() : b.m_high.get();
      mpfr_srcptr const b_high = a_sign > 0 ? b.m_high.get() : b.m_low.get();
      mpfr_mul(result.m_low.get(), a_low, b_low, MPFR_RNDD);
      mpfr_mul(result.m_high.get(), a_high, b_high, MPFR_RNDU);
      return result;
    }
    Multiprecision_number product(precision);
    bool first = true;
    for(mpfr_srcptr x : {a.m_low.get(), a.m_high.get()})
      for(mpfr_srcptr y : {b.m_low.get(), b.m_high.get()})
      {
        mpfr_mul(product.get(), x, y, MPFR_RNDD);
        if(first || mpfr_less_p(product.get(), result.m_low.get()))
          mpfr_set(result.m_low.get(), product.get(), MPFR_RNDD);
        mpfr_mul(product.get(), x, y, MPFR_RNDU);
        if(first || mpfr_greater_p(product.get(), result.m_high.get()))
          mpfr_set(result.m_high.get(), product.get(), MPFR_RNDU);
        first = false;
      }
    return result;
  }

private:
  // 1 if no number of the interval is negative, -1 if none is positive, else 0
  int weak_sign() const { return mpfr_sgn(m_low.get()) >= 0 ? 1 : mpfr_sgn(m_high.get()) <= 0 ? -1 : 0; }

  explicit Multiprecision_interval(mpfr_prec_t precision) : m_low(precision), m_high(precision) {}

  static mpfr_prec_t common_precision(const Multiprecision_interval& a, const Multiprecision_interval& b)
  {
    return (std::max)(mpfr_get_prec(a.m_low.get()), mpfr_get_prec(b.m_low.get()));
  }

  Multiprecision_number m_low, m_high;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_MULTIPRECISION_INTERVAL_H
