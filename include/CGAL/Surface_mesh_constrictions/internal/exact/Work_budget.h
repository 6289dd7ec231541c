// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_WORK_BUDGET_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_WORK_BUDGET_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Thrown when a computation may not take so many steps.
struct Too_many_steps
{};

// The steps that the signs of one curve may still take beyond 256 bits. They are counted from the lengths of the
// numbers, so that a curve has the same certificate on each machine and in each run. A step of the algebra is a product
// of two numbers of 1024 bits; those of the basis, the finite field and of more digits take less. The algebra has a
// share of its own: where it gives up, the other arithmetics still tell what is not zero.
class Work_budget
{
public:
  static constexpr std::size_t max_steps = 1 << 22, max_algebra_steps = 1 << 21;

  std::size_t steps_left = max_steps, algebra_steps_left = max_algebra_steps;

  // Throws Too_many_steps, and takes none, if there are not so many left.
  void take(std::size_t steps) { take(steps, steps_left); }
  void take_algebra(std::size_t steps) { take(steps, algebra_steps_left); }

  // The steps of a product, a sum or a comparison of numbers of so many words: most of the time goes into common
  // divisors, which take time in proportion to the product of the lengths.
  static std::size_t steps_of_product(std::size_t words, std::size_t other_words)
  {
    return words * other_words / words_of_step;
  }

  // The steps of a corner of a face in an expression, with the operations that follow upon it, in an arithmetic whose
  // numbers have so many words; the corner itself has coefficients of `given_words` words.
  static std::size_t steps_of_corner(std::size_t words, std::size_t given_words)
  {
    const std::size_t operations = 16, calls = 4;
    return calls + steps_of_product(operations * words, words) + steps_of_product(given_words, given_words);
  }

private:
  static void take(std::size_t steps, std::size_t& left)
  {
    if(steps > left)
      throw Too_many_steps();
    left -= steps;
  }

  static constexpr std::size_t words_of_step = 256; // lengths of 1024 bits, multiplied
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_WORK_BUDGET_H
