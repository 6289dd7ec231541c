// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H

#include <CGAL/Surface_mesh_constrictions/internal/prominence/rivals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The area that a constriction sweeps on the way along dominated_by() to the first one that is selected and no less
// prominent, or that stays and is hardly less prominent, relative to its squared length. Infinite if there is none. A
// greater threshold of prominence keeps the one that is no less prominent, so curves removed for it stay removed.
template <class Constriction>
double isolation_among(const std::vector<Constriction>& given, const std::vector<bool>& is_selected,
                       const std::vector<bool>& stays, std::size_t i)
{
  double isolation = 0; // squared lengths may overflow, ratios do not
  for(std::size_t j = i;;)
  {
    isolation += given[j].isolation() * std::pow(given[j].length() / given[i].length(), 2);
    if(!given[j].dominated_by())
      return (std::numeric_limits<double>::infinity)();
    j = *given[j].dominated_by();
    if((is_selected[j] && given[j].prominence() >= given[i].prominence()) ||
       (stays[j] && are_alike(given[i].prominence(), given[j].prominence())))
      return isolation;
  }
}

// Removes selected constrictions that lie, with less isolation than the minimum, beside a more prominent one, or beside
// one that is hardly less prominent. All selected ones count as more prominent neighbours, so of a row of curves the
// last one stays. A less prominent neighbour counts only if it stays itself; otherwise a whole row would vanish. Rims
// stay if `with_rims` is set. Cost: the square of the lengths of the ways along dominated_by().
template <class Constriction>
void remove_beside_others(const std::vector<Constriction>& given, const std::vector<bool>& is_selected,
                          double minimum_isolation, bool with_rims, std::vector<std::size_t>& selected)
{
  std::vector<bool> stays(given.size(), false), is_judged(given.size(), false);
  std::vector<std::size_t> way;
  for(std::size_t i : selected)
  {
    way.clear();
    for(std::optional<std::size_t> j = i; j && !is_judged[*j]; j = given[*j].dominated_by())
      way.push_back(*j);
    for(; !way.empty(); way.pop_back()) // what dominates comes first
    {
      const std::size_t j = way.back();
      is_judged[j] = true;
      stays[j] = is_selected[j] && ((with_rims && given[j].is_rim()) ||
                                    isolation_among(given, is_selected, stays, j) >= minimum_isolation);
    }
  }
  selected.erase(std::remove_if(selected.begin(), selected.end(), [&stays](std::size_t i) { return !stays[i]; }),
                 selected.end());
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H
