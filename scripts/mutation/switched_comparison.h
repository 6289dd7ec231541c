// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SWITCHED_COMPARISON_H
#define SWITCHED_COMPARISON_H

// For scripts/mutation/run.py: an operator that is put between the two sides of a comparison, so that `a < b` becomes
// `a < switched_comparison::at(17) < b`, with the same precedence. It is false where `a < b` is true, and the other way
// round, in a process with MUTANT=17 in its environment; otherwise the comparison is the original one.

#include <cstdlib>

namespace switched_comparison {

struct Place
{
  bool is_flipped;
};

inline Place at(long number)
{
  static const char* const chosen = std::getenv("MUTANT");
  static const long flipped = chosen ? std::atol(chosen) : -1;
  return {number == flipped};
}

#define SWITCHED_COMPARISON_OPERATOR(NAME, OPERATOR)                                                                   \
  template <class Left>                                                                                                \
  struct NAME                                                                                                          \
  {                                                                                                                    \
    const Left& left;                                                                                                  \
    bool is_flipped;                                                                                                   \
    template <class Right>                                                                                             \
    friend bool operator OPERATOR(const NAME& l, const Right& right)                                                   \
    {                                                                                                                  \
      return static_cast<bool>(l.left OPERATOR right) != l.is_flipped;                                                 \
    }                                                                                                                  \
  };                                                                                                                   \
  template <class Left>                                                                                                \
  NAME<Left> operator OPERATOR(const Left& left, Place place)                                                          \
  {                                                                                                                    \
    return {left, place.is_flipped};                                                                                   \
  }

SWITCHED_COMPARISON_OPERATOR(Less, <)
SWITCHED_COMPARISON_OPERATOR(Greater, >)
SWITCHED_COMPARISON_OPERATOR(Less_equal, <=)
SWITCHED_COMPARISON_OPERATOR(Greater_equal, >=)
SWITCHED_COMPARISON_OPERATOR(Equal, ==)
SWITCHED_COMPARISON_OPERATOR(Not_equal, !=)
#undef SWITCHED_COMPARISON_OPERATOR

} // namespace switched_comparison

#endif // SWITCHED_COMPARISON_H
