// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_COMPOSED_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_COMPOSED_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossing_filter.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Homology_basis.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Which of the given constrictions with these numbers are composed of others of them: modulo 2 their homology class is
// the sum of classes of shorter ones, one of which they cross. So a curve that winds around a torus both ways is
// composed of a meridian and an equator, but no curve is composed of others that it stays clear of.
// O(n g^2) for n constrictions and genus g.
template <class Constriction>
std::vector<bool> composed_constrictions(const std::vector<Constriction>& given, std::vector<std::size_t> numbers)
{
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&given](std::size_t i, std::size_t j) { return given[i].length() < given[j].length(); });
  Homology_basis basis;
  std::vector<bool> result(given.size(), false);
  const auto contains = [](const Number_set& s, std::size_t i) { return std::find(s.begin(), s.end(), i) != s.end(); };
  const auto cross = [&](std::size_t i, std::size_t j) {
    return contains(given[i].crosses(), j) || contains(given[i].crosses_oddly(), j) ||
           contains(given[j].crosses(), i) || contains(given[j].crosses_oddly(), i);
  };
  for(std::size_t i : numbers)
  {
    if(given[i].is_separating())
      continue;
    Homology_basis::Reduced reduced = basis.reduce(given[i].homology_class());
    if(reduced.is_sum())
      result[i] =
          std::any_of(reduced.members.begin(), reduced.members.end(), [&](std::size_t j) { return cross(i, j); });
    else
      basis.add(std::move(reduced), i);
  }
  return result;
}

// Which of the given constrictions with these numbers belong to a family: where many bumps stand side by side, a closed
// geodesic can pass each of them on either side. Such a curve crosses, there and back, as many shorter ones as a
// `Crossing_filter` allows, or as many firm ones. Those of the family do not count.
// O(n log n + c) for n constrictions and c crossings.
template <class Constriction>
std::vector<bool> family_constrictions(const std::vector<Constriction>& given, std::vector<std::size_t> numbers)
{
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&given](std::size_t i, std::size_t j) { return given[i].length() < given[j].length(); });
  std::vector<bool> result(given.size(), false), counts(given.size(), false);
  for(std::size_t i : numbers)
  {
    std::size_t all = 0;
    std::ptrdiff_t firm = 0;
    for(std::size_t j : given[i].crosses())
      if(counts[j])
      {
        ++all;
        firm += given[j].prominence() >= firm_prominence;
      }
    result[i] = all >= crossing_limit || firm >= firm_crossing_limit;
    counts[i] = !result[i];
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_COMPOSED_CONSTRICTIONS_H
