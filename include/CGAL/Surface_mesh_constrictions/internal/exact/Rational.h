// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RATIONAL_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RATIONAL_H

#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/gmp.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off> Rational;
typedef boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off> Integer;

// The length of a number.
inline std::size_t number_of_words(const Integer& n) { return mpz_size(n.backend().data()); }
inline std::size_t number_of_words(const Rational& q)
{
  return mpz_size(mpq_numref(q.backend().data())) + mpz_size(mpq_denref(q.backend().data()));
}

// The rational number that a coordinate is; none if the coordinate is not known to be rational. There is an overload
// for each kind of number type.

template <class T>
std::enable_if_t<std::is_arithmetic<T>::value, std::optional<Rational>> exact_rational(const T& x)
{
  return Rational(x);
}

template <boost::multiprecision::expression_template_option option>
std::optional<Rational>
exact_rational(const boost::multiprecision::number<boost::multiprecision::gmp_rational, option>& x)
{
  return Rational(x);
}

// For a number type that has no more than the field operations, comparisons and an approximation in double. The number
// is tried as a double, then its continued fraction is developed. The continued fraction of a rational number p / q
// ends after at most 3 log2(q) terms; after `max_terms` none is returned, as for an irrational number.
template <class FT>
std::optional<Rational> rational_by_continued_fraction(const FT& x)
{
  const int max_terms = 100;
  const double nearest = CGAL::to_double(x);
  if(!std::isfinite(nearest))
    return std::nullopt;
  if(FT(nearest) == x)
    return Rational(nearest);
  std::vector<Integer> terms;
  FT rest = x;
  for(int i = 0; i < max_terms; ++i)
  {
    const double approximation = CGAL::to_double(rest);
    if(!(std::abs(approximation) < 4503599627370496.)) // 2^52: up to there integers and the next ones are doubles
      return std::nullopt;
    double term = std::floor(approximation);
    while(FT(term) > rest)
      --term;
    while(FT(term + 1) <= rest)
      ++term;
    terms.emplace_back(term);
    rest = rest - FT(term);
    if(rest == FT(0))
    {
      Rational result(terms.back());
      for(auto it = terms.rbegin() + 1; it != terms.rend(); ++it)
        result = Rational(*it) + 1 / result;
      return result;
    }
    rest = FT(1) / rest;
  }
  return std::nullopt;
}

template <class Integral>
Integer exact_integer(const Integral& x)
{
  std::ostringstream digits;
  digits << x;
  return Integer(digits.str());
}

template <class FT>
std::enable_if_t<!std::is_arithmetic<FT>::value, std::optional<Rational>> exact_rational(const FT& x)
{
  typedef CGAL::Fraction_traits<FT> Fraction;
  if constexpr(Fraction::Is_fraction::value)
  {
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(x, numerator, denominator);
    return Rational(exact_integer(numerator), exact_integer(denominator));
  }
  else
    return rational_by_continued_fraction(x);
}

template <class ET>
std::optional<Rational> exact_rational(const CGAL::Lazy_exact_nt<ET>& x)
{
  return exact_rational(x.exact());
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RATIONAL_H
