// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SEEDED_RANDOM_H
#define SEEDED_RANDOM_H

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace seeded_random {

// Random numbers that are the same with every standard library: its distributions are not.
class Random
{
public:
  explicit Random(std::size_t seed) : m_engine(seed) {}

  // Below n.
  int integer(int n) { return static_cast<int>(m_engine() % static_cast<std::size_t>(n)); }

  double real(double from, double to)
  {
    return from + (to - from) * static_cast<double>(m_engine() >> 11) / 9007199254740992.0; // 2^53
  }

  template <class T>
  void shuffle(std::vector<T>& sequence)
  {
    for(std::size_t i = sequence.size(); i > 1; --i)
      std::swap(sequence[i - 1], sequence[m_engine() % i]);
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace seeded_random

#endif // SEEDED_RANDOM_H
