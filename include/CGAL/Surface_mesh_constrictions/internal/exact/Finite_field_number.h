// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FINITE_FIELD_NUMBER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FINITE_FIELD_NUMBER_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>

#include <cstdint>
#include <optional>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// An element a + b i of the field of p^2 elements, p = 2^61 - 1. As p = 3 mod 4, -1 is no square in F_p, so i is not
// in F_p, and each element of F_p has a square root in F_p or in i F_p.
class Finite_field_number
{
public:
  static constexpr std::uint64_t prime = (std::uint64_t(1) << 61) - 1;

  Finite_field_number() = default;

  // None if p divides the denominator.
  static std::optional<Finite_field_number> image(const Rational& q)
  {
    const std::uint64_t n = residue(mpq_numref(q.backend().data())), d = residue(mpq_denref(q.backend().data()));
    if(d == 0)
      return std::nullopt;
    return Finite_field_number(multiply(n, power(d, prime - 2)), 0);
  }

  // A square root of the image of an integer.
  static Finite_field_number square_root(const Integer& n)
  {
    const std::uint64_t a = residue(n.backend().data()), root = power(a, (prime + 1) / 4);
    if(multiply(root, root) == a)
      return Finite_field_number(root, 0);
    return Finite_field_number(0, power(subtract(0, a), (prime + 1) / 4));
  }

  bool is_zero() const { return m_a == 0 && m_b == 0; }

  friend Finite_field_number operator+(Finite_field_number x, Finite_field_number y)
  {
    return Finite_field_number(add(x.m_a, y.m_a), add(x.m_b, y.m_b));
  }

  friend Finite_field_number operator-(Finite_field_number x, Finite_field_number y)
  {
    return Finite_field_number(subtract(x.m_a, y.m_a), subtract(x.m_b, y.m_b));
  }

  friend Finite_field_number operator*(Finite_field_number x, Finite_field_number y)
  {
    return Finite_field_number(subtract(multiply(x.m_a, y.m_a), multiply(x.m_b, y.m_b)),
                               add(multiply(x.m_a, y.m_b), multiply(x.m_b, y.m_a)));
  }

private:
  Finite_field_number(std::uint64_t a, std::uint64_t b) : m_a(a), m_b(b) {}

  static std::uint64_t residue(mpz_srcptr n)
  {
    static_assert(sizeof(unsigned long) == sizeof(std::uint64_t), "GMP takes a remainder by a long");
    return mpz_fdiv_ui(n, prime);
  }

  static std::uint64_t add(std::uint64_t x, std::uint64_t y) { return x + y < prime ? x + y : x + y - prime; }
  static std::uint64_t subtract(std::uint64_t x, std::uint64_t y) { return x >= y ? x - y : x + prime - y; }

  static std::uint64_t multiply(std::uint64_t x, std::uint64_t y)
  {
    __extension__ typedef unsigned __int128 Product;
    const Product product = Product(x) * y;
    return add(static_cast<std::uint64_t>(product & prime), static_cast<std::uint64_t>(product >> 61));
  }

  static std::uint64_t power(std::uint64_t x, std::uint64_t exponent)
  {
    std::uint64_t result = 1;
    for(; exponent != 0; exponent >>= 1, x = multiply(x, x))
      if(exponent & 1)
        result = multiply(result, x);
    return result;
  }

  std::uint64_t m_a = 0, m_b = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FINITE_FIELD_NUMBER_H
