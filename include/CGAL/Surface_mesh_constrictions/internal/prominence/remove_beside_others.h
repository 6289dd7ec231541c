// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H

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
// prominent, relative to its squared length. Infinite if there is none. With a greater threshold of prominence that one
// is still there, so that what is removed for it stays so.
template <class Constriction>
double isolation_among(const std::vector<Constriction>& given, const std::vector<bool>& is_selected, std::size_t i)
{
  double area = 0;
  for(std::optional<std::size_t> j = i; j; j = given[*j].dominated_by())
  {
    if(*j != i && is_selected[*j] && given[*j].prominence() >= given[i].prominence())
      return area / std::pow(given[i].length(), 2);
    area += given[*j].isolation() * std::pow(given[*j].length(), 2);
  }
  return (std::numeric_limits<double>::infinity)();
}

// Removes from those selected the ones that lie beside a more prominent one, with less isolation. Each is judged among
// all that were selected, so of a row of them the last one stays. Rims stay if they are asked for.
// Cost: the ways along dominated_by().
template <class Constriction>
void remove_beside_others(const std::vector<Constriction>& given, const std::vector<bool>& is_selected,
                          double minimum_isolation, bool with_rims, std::vector<std::size_t>& selected)
{
  selected.erase(std::remove_if(selected.begin(), selected.end(),
                                [&](std::size_t i) {
                                  return !(with_rims && given[i].is_rim()) &&
                                         isolation_among(given, is_selected, i) < minimum_isolation;
                                }),
                 selected.end());
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_REMOVE_BESIDE_OTHERS_H
