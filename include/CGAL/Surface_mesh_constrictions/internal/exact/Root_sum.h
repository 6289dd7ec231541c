// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ROOT_SUM_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ROOT_SUM_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>

#include <mpfr.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A sum of terms coefficient * sqrt(radicand), each linear in one root. Square roots of positive rational numbers, no
// two of which have a product that is a square, are linearly independent over the rational numbers: multiply a sum that
// is zero by one of the roots; the trace of the product, down to the rational numbers, is a multiple of the coefficient
// of this root alone. So the sum is zero only if the coefficients of each square class add up to zero, and no product
// of roots is ever formed.
class Root_sum
{
public:
  // `radicand` must be positive.
  void add(const Rational& coefficient, const Rational& radicand)
  {
    if(coefficient != 0)
      m_terms.push_back({coefficient, radicand});
  }

  // -1, 0 or 1. A sum of n terms costs O(n) operations if 256 bits tell it from zero, else O(n c) tests for a square,
  // where c is the number of square classes. If the sum is not zero, the precision is doubled until its sign shows.
  int sign() const
  {
    if(m_terms.empty())
      return 0;
    const int quickly = sign_at(256);
    if(quickly != 0)
      return quickly;
    if(is_zero())
      return 0;
    for(mpfr_prec_t precision = 512;; precision *= 2)
      if(const int sign = sign_at(precision))
        return sign;
  }

private:
  struct Term
  {
    Rational coefficient, radicand;
  };

  int sign_at(mpfr_prec_t precision) const
  {
    Multiprecision_interval sum(0, precision);
    for(const Term& t : m_terms)
      sum = sum + Multiprecision_interval(t.coefficient, precision) *
                      Multiprecision_interval::square_root(t.radicand, precision);
    return sum.certain_sign();
  }

  bool is_zero() const
  {
    // of each square class one integer n, and the sum of its terms as a multiple of sqrt(n)
    std::vector<std::pair<Integer, Rational>> classes;
    for(const Term& t : m_terms)
    {
      const Integer d = denominator(t.radicand), n = numerator(t.radicand) * d; // sqrt(radicand) = sqrt(n) / d
      auto it = classes.begin();
      for(; it != classes.end(); ++it)
      {
        const Integer product = n * it->first;
        if(n != it->first && mpz_perfect_square_p(product.backend().data()) == 0)
          continue;
        // sqrt(n) = sqrt(n m) / m * sqrt(m)
        it->second += t.coefficient * Rational(sqrt(product)) / (it->first * d);
        break;
      }
      if(it == classes.end())
        classes.emplace_back(n, t.coefficient / d);
    }
    for(const auto& c : classes)
      if(c.second != 0)
        return false;
    return true;
  }

  std::vector<Term> m_terms;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_ROOT_SUM_H
