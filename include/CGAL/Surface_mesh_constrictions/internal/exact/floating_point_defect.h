// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLOATING_POINT_DEFECT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLOATING_POINT_DEFECT_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/floating_point_requirements.h>

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>

#include <boost/config.hpp>

#include <cfloat>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Compares the bits: where subnormal numbers are taken for zero, comparisons of doubles take them for zero, too.
inline bool is_same_double(double a, double b)
{
  static_assert(sizeof(double) == sizeof(std::uint64_t));
  std::uint64_t x, y;
  std::memcpy(&x, &a, sizeof x);
  std::memcpy(&y, &b, sizeof y);
  return x == y;
}

// Whether an interval has exactly these bounds.
template <class Interval>
bool has_bounds(const Interval& x, double inf, double sup)
{
  return is_same_double(x.inf(), inf) && is_same_double(x.sup(), sup);
}

// Whether the bounds of inexact results are the two doubles next to them. The operands are read at run time, so that no
// compiler computes the results instead. Products that are contracted with a sum make no difference: the bound of each
// operation is looked at by itself.
template <class Interval>
bool rounds_as_directed()
{
  const volatile double one_at_run_time = 1;
  const double one = one_at_run_time;
  const double after_one = one + DBL_EPSILON, tiny = DBL_EPSILON / 256 * one;
  return has_bounds(Interval(one) + Interval(tiny), 1, 1 + DBL_EPSILON) &&
         has_bounds(Interval(one) - Interval(tiny), 1 - DBL_EPSILON / 2, 1) &&
         has_bounds(Interval(one) / Interval(3 * one), 6004799503160661. / 18014398509481984.,
                    6004799503160662. / 18014398509481984.) && // 2^54 / 3
         has_bounds(Interval(after_one) * Interval(after_one), 1 + 2 * DBL_EPSILON, 1 + 3 * DBL_EPSILON) &&
         has_bounds(Interval(-after_one) * Interval(after_one), -(1 + 3 * DBL_EPSILON), -(1 + 2 * DBL_EPSILON)) &&
         has_bounds(square(Interval(after_one)), 1 + 2 * DBL_EPSILON, 1 + 3 * DBL_EPSILON) &&
         has_bounds(sqrt(Interval(2 * one)), 6369051672525772. / 4503599627370496.,
                    6369051672525773. / 4503599627370496.); // 2^52 sqrt(2)
}

// Whether results and operands below the least normal number keep their values, and are not taken for zero.
template <class Interval>
bool keeps_subnormals()
{
  const volatile double least_at_run_time = DBL_MIN, subnormal_at_run_time = DBL_MIN / 4;
  const double least = least_at_run_time, subnormal = subnormal_at_run_time;
  const Interval half(0.5), two(2);
  return has_bounds(Interval(least) * half, DBL_MIN / 2, DBL_MIN / 2) &&
         has_bounds(Interval(least) / two, DBL_MIN / 2, DBL_MIN / 2) &&
         has_bounds(Interval(least) - Interval(subnormal), DBL_MIN - DBL_MIN / 4, DBL_MIN - DBL_MIN / 4) &&
         has_bounds(Interval(subnormal) + Interval(subnormal), DBL_MIN / 2, DBL_MIN / 2) &&
         has_bounds(Interval(subnormal) * Interval(4), DBL_MIN, DBL_MIN);
}

// Whether each result is a double. Excess precision would do no harm to bounds, but would make the computed errors of
// sums and products wrong.
inline bool has_no_excess_precision()
{
  const volatile double one_at_run_time = 1;
  const double one = one_at_run_time, tiny = DBL_EPSILON / 256 * one;
  const volatile double rest = (one + tiny) - one; // computed before the rounding mode changes
  return is_same_double(rest, 0);
}

// The defect of the calling thread's floating-point arithmetic that the signs of intervals, and with them the proofs,
// would suffer from: NO_DIRECTED_ROUNDING or SUBNORMALS_FLUSHED; NOT_COMPUTED if there is none. The caller may have set
// any rounding mode. Valgrind ignores the rounding mode. A library that was linked with -Ofast by GCC makes the thread
// that loads it, and all threads that this thread starts, flush subnormal numbers to zero. Some 20 operations.
template <class Interval = Interval_nt<false>>
BOOST_NOINLINE Certificate_verdict floating_point_defect()
{
  {
    const Protect_FPU_rounding<true> upward(CGAL_FE_UPWARD);
    // first the subnormals, because rounding is tried with normal numbers only
    if(!keeps_subnormals<Interval>())
      return Certificate_verdict::SUBNORMALS_FLUSHED;
    if(!rounds_as_directed<Interval>())
      return Certificate_verdict::NO_DIRECTED_ROUNDING;
  }
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return has_no_excess_precision() ? Certificate_verdict::NOT_COMPUTED : Certificate_verdict::NO_DIRECTED_ROUNDING;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FLOATING_POINT_DEFECT_H
