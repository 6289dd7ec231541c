// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIVALS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIVALS_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Of two curves that cross each other there and back the more prominent is preferred if it is more prominent by more
// than this factor.
constexpr double rival_factor = 1.2;

// Curves between which there is less area than this, relative to the squared length, are at one place: around a tube
// two that are nearer to each other than half of its diameter.
constexpr double area_of_one_place = 0.15;

// Whether neither of two prominences stands out against the other.
inline bool are_alike(double prominence, double other)
{
  return prominence <= rival_factor * other && other <= rival_factor * prominence;
}

// Selects from constrictions with these numbers, the most prominent first, those that cross none of the others selected
// there and back, and have no rival that could be selected instead, unless `with_rivals`. `crossing` are the numbers of
// those that each one crosses. Linear in these.
template <class Constriction>
std::vector<std::size_t> without_crossing_ones(const std::vector<Constriction>& given,
                                               const std::vector<std::size_t>& order,
                                               const std::vector<std::vector<std::size_t>>& crossing, bool with_rivals)
{
  enum Choice
  {
    NOT_GIVEN,
    OPEN,
    SELECTED,
    CROSSES_A_SELECTED_ONE
  };
  std::vector<Choice> choice(given.size(), NOT_GIVEN);
  for(std::size_t i : order)
    choice[i] = OPEN;
  std::vector<std::size_t> selected;
  for(std::size_t i : order)
  {
    if(choice[i] == CROSSES_A_SELECTED_ONE)
      continue;
    const auto is_open = [&choice](std::size_t j) { return choice[j] == OPEN; };
    if(!with_rivals && std::any_of(given[i].rivals().begin(), given[i].rivals().end(), is_open))
      continue;
    choice[i] = SELECTED;
    selected.push_back(i);
    for(std::size_t j : crossing[i])
      if(choice[j] == OPEN)
        choice[j] = CROSSES_A_SELECTED_ONE;
  }
  return selected;
}

// The same. A body with a symmetry so gets an answer with that symmetry: of a curve that lies aslant and its mirror
// image neither is selected. Only where nothing but rivals is found they are selected as others are.
template <class Constriction>
std::vector<std::size_t> without_crossing_ones(const std::vector<Constriction>& given,
                                               const std::vector<std::size_t>& order,
                                               const std::vector<std::vector<std::size_t>>& crossing)
{
  std::vector<std::size_t> result = without_crossing_ones(given, order, crossing, false);
  return result.empty() ? without_crossing_ones(given, order, crossing, true) : result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIVALS_H
