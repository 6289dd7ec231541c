// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SQUARE_ROOT_BASIS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SQUARE_ROOT_BASIS_H

#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Work_budget.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Positive integers b_1, ..., b_m such that no product of distinct ones is a square, and each of the given square roots
// is a rational multiple of a product of some sqrt(b_i). Then the 2^m products are linearly independent over Q.
//
// Whether a product is a square is a question of linear algebra over the field of two elements: the quadratic
// characters of a number modulo many primes form a vector. If the vectors are independent, so are the numbers. A
// dependence of the vectors is verified with an integer square root.
class Square_root_basis
{
public:
  // coefficient * product of the sqrt(b_i) whose bits are set
  struct Root
  {
    Rational coefficient;
    std::uint64_t mask;
  };

  // Takes numbers that are not negative. O(n (m + number of primes)) operations, and a square root for each number.
  // Throws Too_many_steps if the budget does not suffice.
  Square_root_basis(const std::vector<Rational>& radicands, Work_budget& budget)
  {
    for(std::size_t primes = 128; !build(radicands, primes, budget); primes *= 2)
    {
      m_basis.clear();
      m_roots.clear();
    }
  }

  // Whether the basis is small enough for the bits of a mask.
  bool is_valid() const { return m_basis.size() <= 64; }

  const std::vector<Integer>& basis() const { return m_basis; }

  // The square root of one of the numbers given.
  const Root& root(const Rational& radicand) const { return m_roots.at(radicand); }

private:
  typedef std::vector<bool> Characters;

  // A vector in echelon form, and the numbers of the basis whose product it belongs to.
  struct Row
  {
    Characters characters;
    std::size_t pivot;
    std::vector<bool> members;
  };

  // False if the primes could not tell two square classes apart.
  bool build(const std::vector<Rational>& radicands, std::size_t number_of_primes, Work_budget& budget)
  {
    std::vector<Integer> numbers;
    for(const Rational& r : radicands)
    {
      // of a remainder by each prime, and of the square roots
      const std::size_t words = number_of_words(r), words_of_call = 16;
      budget.take(number_of_primes * (words_of_call + words) / 64 + Work_budget::steps_of_product(words, words));
      numbers.push_back(numerator(r) * denominator(r));
    }
    const std::vector<unsigned long> primes = make_primes(numbers, number_of_primes);

    std::vector<Row> rows;
    for(std::size_t i = 0; i < radicands.size(); ++i)
    {
      const Integer& n = numbers[i]; // sqrt(radicand) = sqrt(n) / denominator
      const Integer d = denominator(radicands[i]);
      if(m_roots.count(radicands[i]) != 0)
        continue;
      if(mpz_perfect_square_p(n.backend().data()) != 0)
      {
        m_roots[radicands[i]] = Root{Rational(sqrt(n)) / d, 0};
        continue;
      }
      Row row = {characters(n, primes), 0, std::vector<bool>(m_basis.size(), false)};
      for(const Row& r : rows)
        if(row.characters[r.pivot])
          for(std::size_t j = 0; j < row.characters.size(); ++j)
          {
            row.characters[j] = row.characters[j] != r.characters[j];
            if(j < r.members.size())
              row.members[j] = row.members[j] != r.members[j];
          }
      while(row.pivot < row.characters.size() && !row.characters[row.pivot])
        ++row.pivot;
      if(row.pivot < row.characters.size())
      {
        if(m_basis.size() == 64)
        {
          m_basis.emplace_back(n);
          return true; // too large, whatever follows
        }
        m_roots[radicands[i]] = Root{Rational(1) / d, std::uint64_t(1) << m_basis.size()};
        m_basis.push_back(n);
        row.members.push_back(true);
        rows.push_back(row);
        continue;
      }
      Integer product = 1;
      std::uint64_t mask = 0;
      for(std::size_t j = 0; j < row.members.size(); ++j)
        if(row.members[j])
        {
          budget.take(Work_budget::steps_of_product(number_of_words(product), number_of_words(m_basis[j])));
          product *= m_basis[j];
          mask |= std::uint64_t(1) << j;
        }
      budget.take(Work_budget::steps_of_product(number_of_words(product), number_of_words(product)));
      const Integer square = n * product;
      if(mpz_perfect_square_p(square.backend().data()) == 0)
        return false;
      m_roots[radicands[i]] = Root{Rational(sqrt(square)) / (product * d), mask};
    }
    return true;
  }

  // Primes that divide none of the numbers.
  static std::vector<unsigned long> make_primes(const std::vector<Integer>& numbers, std::size_t count)
  {
    static const std::vector<unsigned long> first = primes_after(1ul << 40, 128);
    std::vector<unsigned long> primes, candidates = first;
    for(;;)
    {
      for(const unsigned long p : candidates)
      {
        const auto is_divisible = [p](const Integer& n) {
          return n != 0 && mpz_divisible_ui_p(n.backend().data(), p) != 0;
        };
        if(std::none_of(numbers.begin(), numbers.end(), is_divisible))
          primes.push_back(p);
      }
      if(primes.size() >= count)
        return primes;
      candidates = primes_after(candidates.back(), count - primes.size());
    }
  }

  static std::vector<unsigned long> primes_after(unsigned long p, std::size_t count)
  {
    std::vector<unsigned long> result;
    Integer prime = p;
    while(result.size() < count)
    {
      mpz_nextprime(prime.backend().data(), prime.backend().data());
      result.push_back(mpz_get_ui(prime.backend().data()));
    }
    return result;
  }

  static Characters characters(const Integer& n, const std::vector<unsigned long>& primes)
  {
    Characters result;
    for(const unsigned long p : primes)
      result.push_back(mpz_kronecker_ui(n.backend().data(), p) < 0);
    return result;
  }

  std::vector<Integer> m_basis;
  std::map<Rational, Root> m_roots;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_SQUARE_ROOT_BASIS_H
