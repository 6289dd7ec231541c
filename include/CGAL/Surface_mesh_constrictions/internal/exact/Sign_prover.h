// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIGN_PROVER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIGN_PROVER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Radical_number.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Square_root_basis.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Work_budget.h>

#include <CGAL/Interval_nt.h>

#include <mpfr.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

enum class Proved_sign
{
  NEGATIVE,
  ZERO,
  POSITIVE,
  UNPROVED
};

inline Proved_sign opposite_sign(Proved_sign sign)
{
  return sign == Proved_sign::POSITIVE   ? Proved_sign::NEGATIVE
         : sign == Proved_sign::NEGATIVE ? Proved_sign::POSITIVE
                                         : sign;
}

// The sign of an exact number.
template <class NT>
Proved_sign proved_sign(const NT& x)
{
  return x > 0 ? Proved_sign::POSITIVE : x < 0 ? Proved_sign::NEGATIVE : Proved_sign::ZERO;
}

inline bool contains(const std::vector<Proved_sign>& signs, Proved_sign sign)
{
  return std::find(signs.begin(), signs.end(), sign) != signs.end();
}

// The values of an expression, which sets those that are wanted.
template <class NT>
class Wanted_values
{
public:
  explicit Wanted_values(const std::vector<bool>& wanted) : m_wanted(wanted), m_values(wanted.size()) {}

  bool wants(std::size_t i) const { return m_wanted[i]; }
  NT& operator[](std::size_t i) { return m_values[i]; }

private:
  const std::vector<bool>& m_wanted;
  std::vector<NT> m_values;
};

// Decides the signs of expressions in the corners of a surface's faces. Each expression is an element of Q(sqrt r_1,
// ..., sqrt r_m), with one root for each face. It is computed by intervals of doubles, then by intervals of growing
// precision. If these still contain zero, either its image in a finite field proves that it is not zero, and then the
// precision grows until the sign shows; or it is proved to be zero by writing it in a basis of the field. What is not
// decided within the budget stays unproved.
template <class Surface>
class Sign_prover
{
public:
  explicit Sign_prover(const Surface& surface) : m_surface(surface), m_corners(surface) {}

  const Surface& surface() const { return m_surface; }
  const Sign_statistics& statistics() const { return m_statistics; }

  // Begins a new curve. All signs of a curve have one budget: its correction may ask for thousands of signs, and if each
  // had a budget of its own a curve among subnormal coordinates, or one that runs many times around, would take minutes.
  void begin_curve() { m_budget = Work_budget(); }

  // The signs of n values. `expression(arithmetic, values)` sets the values that are wanted. It is called with
  // different arithmetics, and must use only what each of them provides.
  template <class Expression>
  std::vector<Proved_sign> signs(std::size_t n, const Expression& expression)
  {
    return signs(n, expression, [](std::size_t) { return Proved_sign::UNPROVED; });
  }

  // As above. `tie(i)` is called for a value that intervals of doubles do not tell from zero. It returns the sign if it
  // knows it for another reason, else UNPROVED. It may use this prover.
  template <class Expression, class Tie>
  std::vector<Proved_sign> signs(std::size_t n, const Expression& expression, const Tie& tie)
  {
    std::vector<Proved_sign> result(n, Proved_sign::UNPROVED);
    std::vector<bool> wanted(n, true);
    {
      Interval_nt<false>::Protector upward;
      const Interval_arithmetic<Surface> arithmetic(m_surface);
      m_statistics.interval += decide(expression, arithmetic, wanted, result);
    }
    if(!contains(wanted))
      return result;

    for(std::size_t i = 0; i < n; ++i)
      if(wanted[i] && (result[i] = tie(i)) != Proved_sign::UNPROVED)
      {
        wanted[i] = false;
        ++m_statistics.algebra;
      }
    if(!contains(wanted))
      return result;
    m_corners.begin_expression();
    for(mpfr_prec_t precision = 128; precision <= free_precision && contains(wanted); precision *= 2)
      m_statistics.multiprecision += decide_at(precision, expression, wanted, result);
    if(contains(wanted))
      decide_close_to_zero(expression, wanted, result);
    return result;
  }

  template <class Expression>
  Proved_sign sign(const Expression& expression)
  {
    return signs(1, expression).front();
  }

  template <class Expression, class Tie>
  Proved_sign sign(const Expression& expression, const Tie& tie)
  {
    return signs(1, expression, [&tie](std::size_t) { return tie(); }).front();
  }

  // Intervals of the first precision beyond double.
  Multiprecision_arithmetic<Surface> multiprecision_arithmetic()
  {
    m_corners.begin_expression();
    return Multiprecision_arithmetic<Surface>(m_corners, Rational_corners<Surface>::kept_precision, m_budget);
  }

  // Counts a sign that a caller has found with intervals of its own.
  void count_interval() { ++m_statistics.interval; }
  void count_multiprecision() { ++m_statistics.multiprecision; }

  // Calls `attempt(arithmetic)` with intervals of growing precision until it returns true; false if it never does.
  template <class Attempt>
  bool decide_by_intervals(const Attempt& attempt)
  {
    {
      Interval_nt<false>::Protector upward;
      if(attempt(Interval_arithmetic<Surface>(m_surface)))
      {
        ++m_statistics.interval;
        return true;
      }
    }
    m_corners.begin_expression();
    try
    {
      for(mpfr_prec_t precision = 128; precision <= max_precision_of_unproved; precision *= 2)
        if(attempt(Multiprecision_arithmetic<Surface>(m_corners, precision, m_budget)))
        {
          ++m_statistics.multiprecision;
          return true;
        }
    }
    catch(const Too_many_steps&)
    {}
    ++m_statistics.unproved;
    return false;
  }

private:
  static constexpr mpfr_prec_t free_precision = Multiprecision_arithmetic<Surface>::free_precision;
  static constexpr mpfr_prec_t max_precision_of_unproved = 4096; // bits

  // Returns the number of values whose signs it found; they are not wanted any more.
  template <class Expression, class Arithmetic>
  static std::size_t decide(const Expression& expression, const Arithmetic& arithmetic, std::vector<bool>& wanted,
                            std::vector<Proved_sign>& result)
  {
    Wanted_values<typename Arithmetic::NT> values(wanted);
    expression(arithmetic, values);
    std::size_t decided = 0;
    for(std::size_t i = 0; i < wanted.size(); ++i)
    {
      const int sign = wanted[i] ? arithmetic.certain_sign(values[i]) : 0;
      if(sign == 0)
        continue;
      result[i] = sign > 0 ? Proved_sign::POSITIVE : Proved_sign::NEGATIVE;
      wanted[i] = false;
      ++decided;
    }
    return decided;
  }

  template <class Expression>
  std::size_t decide_at(mpfr_prec_t precision, const Expression& expression, std::vector<bool>& wanted,
                        std::vector<Proved_sign>& result)
  {
    const Multiprecision_arithmetic<Surface> arithmetic(m_corners, precision, m_budget);
    return decide(expression, arithmetic, wanted, result);
  }

  static bool contains(const std::vector<bool>& wanted)
  {
    return std::find(wanted.begin(), wanted.end(), true) != wanted.end();
  }

  // For values that 256 bits do not tell from zero.
  template <class Expression>
  void decide_close_to_zero(const Expression& expression, std::vector<bool>& wanted, std::vector<Proved_sign>& result)
  {
    try
    {
      const Square_root_basis basis(m_corners.radicands(), m_budget);
      if(basis.is_valid())
      {
        m_statistics.finite_field +=
            decide_in_field<Finite_field_arithmetic<Surface>>(basis, expression, wanted, result, false);
        m_statistics.algebra += decide_in_field<Radical_arithmetic<Surface>>(basis, expression, wanted, result, true);
      }
    }
    catch(const Too_many_steps&)
    {}
    m_statistics.multiprecision += decide_beyond(max_precision_of_unproved, expression, wanted, result);
    m_statistics.unproved += static_cast<std::size_t>(std::count(wanted.begin(), wanted.end(), true));
  }

  // By intervals of up to a precision, as long as the budget suffices. Returns the number of values decided.
  template <class Expression>
  std::size_t decide_beyond(mpfr_prec_t max_precision, const Expression& expression, std::vector<bool>& wanted,
                            std::vector<Proved_sign>& result)
  {
    std::size_t count = 0;
    try
    {
      for(mpfr_prec_t precision = 2 * free_precision; contains(wanted) && precision <= max_precision; precision *= 2)
        count += decide_at(precision, expression, wanted, result);
    }
    catch(const Too_many_steps&)
    {}
    return count;
  }

  // Decides the values that the arithmetic tells from zero, or, if it can, those that it proves to be zero. Returns
  // their number.
  template <class Arithmetic, class Expression>
  std::size_t decide_in_field(const Square_root_basis& basis, const Expression& expression, std::vector<bool>& wanted,
                              std::vector<Proved_sign>& result, bool proves_zero)
  {
    std::vector<bool> nonzero(wanted.size(), false);
    std::size_t zeros = 0;
    // All at once, as what they have in common need not be computed again; if that fails, one by one.
    if(!evaluate<Arithmetic>(basis, expression, std::vector<bool>(wanted), wanted, nonzero, result, proves_zero, zeros))
      for(std::size_t i = 0; i < wanted.size(); ++i)
        if(wanted[i])
        {
          std::vector<bool> only(wanted.size(), false);
          only[i] = true;
          evaluate<Arithmetic>(basis, expression, only, wanted, nonzero, result, proves_zero, zeros);
        }
    const std::size_t decided =
        decide_beyond((std::numeric_limits<mpfr_prec_t>::max)() / 2, expression, nonzero, result);
    for(std::size_t i = 0; i < wanted.size(); ++i)
      if(nonzero[i])
        wanted[i] = true; // the budget did not suffice
    return zeros + decided;
  }

  // Moves values that are not zero from `wanted` to `nonzero`. If the arithmetic can prove that a value is zero, such
  // values get their sign and are counted. False if the arithmetic gave up.
  template <class Arithmetic, class Expression>
  bool evaluate(const Square_root_basis& basis, const Expression& expression, const std::vector<bool>& evaluated,
                std::vector<bool>& wanted, std::vector<bool>& nonzero, std::vector<Proved_sign>& result,
                bool proves_zero, std::size_t& zeros)
  {
    try
    {
      const Arithmetic arithmetic(m_corners, basis, m_budget);
      Wanted_values<typename Arithmetic::NT> values(evaluated);
      expression(arithmetic, values);
      for(std::size_t i = 0; i < evaluated.size(); ++i)
      {
        if(!evaluated[i] || (values[i].is_zero() && !proves_zero))
          continue;
        if(values[i].is_zero())
        {
          result[i] = Proved_sign::ZERO;
          ++zeros;
        }
        else
          nonzero[i] = true;
        wanted[i] = false;
      }
      return true;
    }
    catch(const No_image&)
    {
      return false;
    }
    catch(const Too_many_steps&)
    {
      return false;
    }
  }

  const Surface& m_surface;
  Rational_corners<Surface> m_corners;
  Sign_statistics m_statistics;
  Work_budget m_budget; // of the curve under way
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SIGN_PROVER_H
