// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RADICAL_NUMBER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_RADICAL_NUMBER_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Thrown when a computation has taken too many steps.
struct Too_many_terms
{};

// The field Q(sqrt b_1, ..., sqrt b_m) of the numbers of one computation, and the steps that it may still take.
struct Radical_field
{
  static constexpr std::size_t max_steps = 1 << 18;

  const std::vector<Integer>& basis;
  std::size_t steps_left = max_steps;

  explicit Radical_field(const std::vector<Integer>& basis) : basis(basis) {}

  void take(std::size_t steps)
  {
    if(steps > steps_left)
      throw Too_many_terms();
    steps_left -= steps;
  }
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
    for(const auto& t : y.m_terms)
      x.add(t.first, t.second);
    x.m_field = x.m_field != nullptr ? x.m_field : y.m_field;
    return x;
  }

  friend Radical_number operator-(Radical_number x, const Radical_number& y)
  {
    for(const auto& t : y.m_terms)
      x.add(t.first, -t.second);
    x.m_field = x.m_field != nullptr ? x.m_field : y.m_field;
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
        Rational coefficient = s.second * t.second;
        std::size_t i = 0;
        for(std::uint64_t common = s.first & t.first; common != 0; common >>= 1, ++i)
          if(common & 1)
            coefficient *= result.m_field->basis[i];
        result.add(s.first ^ t.first, coefficient);
      }
    return result;
  }

private:
  void add(std::uint64_t mask, const Rational& coefficient)
  {
    const auto it = m_terms.emplace(mask, 0).first;
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
