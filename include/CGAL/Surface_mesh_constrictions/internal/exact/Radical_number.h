// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RADICAL_NUMBER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RADICAL_NUMBER_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Work_budget.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The field Q(sqrt b_1, ..., sqrt b_m) of the numbers of one computation, and the steps that it may still take. An
// operation with coefficients takes more steps the longer they are. Doubles do not bound their length: if some
// coordinates are near 1 and others subnormal, a square area has a thousand digits, and sums of quotients have many
// more. All steps are also taken from the budget.
struct Radical_field
{
  static constexpr std::size_t max_steps = 1 << 18;

  std::size_t steps_left = max_steps;

  // `budget` must outlive the field.
  Radical_field(const std::vector<Integer>& basis, Work_budget& budget) : m_budget(budget)
  {
    for(const Integer& b : basis)
      m_basis.push_back({b, number_of_words(b)});
  }

  // Throws Too_many_steps if there are not so many left.
  void take(std::size_t steps)
  {
    if(steps > steps_left)
      throw Too_many_steps();
    m_budget.take_algebra(steps);
    steps_left -= steps;
  }

  // The steps that x * y, x + y and x - y take in addition if the coefficients are long.
  void take_lengths(const Rational& x, const Rational& y) { take_lengths(number_of_words(x), number_of_words(y)); }

  // x times the product of the b_i whose bits are set in `mask`.
  void multiply_by_basis(Rational& x, std::uint64_t mask)
  {
    for(std::size_t i = 0; mask != 0; mask >>= 1, ++i)
      if(mask & 1)
      {
        take_lengths(number_of_words(x), m_basis[i].words);
        x *= m_basis[i].number;
      }
  }

private:
  struct Element
  {
    Integer number;
    std::size_t words;
  };

  void take_lengths(std::size_t words_of_x, std::size_t words_of_y)
  {
    take(Work_budget::steps_of_product(words_of_x, words_of_y));
  }

  std::vector<Element> m_basis;
  Work_budget& m_budget;
};

// An element of Q(sqrt b_1, ..., sqrt b_m) as the sum of rational multiples of products of square roots. As these
// products are linearly independent the number is zero only if it has no terms.
class Radical_number
{
public:
  Radical_number() = default;

  // `coefficient` times the product of the sqrt(b_i) whose bits are set in `mask`. The field must outlive the number.
  Radical_number(const Rational& coefficient, std::uint64_t mask, Radical_field& field) : m_field(&field)
  {
    if(coefficient != 0)
      m_terms.emplace(mask, coefficient);
  }

  bool is_zero() const { return m_terms.empty(); }

  friend Radical_number operator+(Radical_number x, const Radical_number& y)
  {
    x.m_field = x.m_field != nullptr ? x.m_field : y.m_field;
    for(const auto& t : y.m_terms)
      x.add(t.first, t.second);
    return x;
  }

  friend Radical_number operator-(Radical_number x, const Radical_number& y)
  {
    x.m_field = x.m_field != nullptr ? x.m_field : y.m_field;
    for(const auto& t : y.m_terms)
      x.add(t.first, -t.second);
    return x;
  }

  friend Radical_number operator*(const Radical_number& x, const Radical_number& y)
  {
    Radical_number result;
    if(x.is_zero() || y.is_zero())
      return result;
    result.m_field = x.m_field;
    result.m_field->take(x.m_terms.size() * y.m_terms.size());
    for(const auto& s : x.m_terms)
      for(const auto& t : y.m_terms)
      {
        result.m_field->take_lengths(s.second, t.second);
        Rational coefficient = s.second * t.second;
        result.m_field->multiply_by_basis(coefficient, s.first & t.first);
        result.add(s.first ^ t.first, coefficient);
      }
    return result;
  }

private:
  void add(std::uint64_t mask, const Rational& coefficient)
  {
    const auto [it, is_new] = m_terms.emplace(mask, coefficient);
    if(is_new)
      return;
    m_field->take_lengths(it->second, coefficient);
    it->second += coefficient;
    if(it->second == 0)
      m_terms.erase(it);
  }

  Radical_field* m_field = nullptr;
  std::map<std::uint64_t, Rational> m_terms;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RADICAL_NUMBER_H
