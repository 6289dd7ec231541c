// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_COMPOSED_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_COMPOSED_CONSTRICTIONS_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A set of numbers, ascending, as a vector over the field of two elements.
typedef std::vector<std::size_t> Number_set;

inline void add_modulo_two(Number_set& a, const Number_set& b)
{
  Number_set sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  a.swap(sum);
}

// Which of some constrictions are composed of others: modulo 2 their homology class is the sum of classes of shorter ones,
// one of which they cross. So a curve that winds around a torus both ways is composed of a meridian
// and an equator, but no curve is composed of others that it stays clear of.
//
// The shorter ones are the shortest basis of what they span, which the greedy algorithm finds (Erickson and Whittlesey,
// "Greedy optimal homotopy and homology generators", 2005). O(n g^2) for n constrictions and genus g.
template <class Constriction>
std::vector<bool> composed_constrictions(const std::vector<Constriction>& given, std::vector<std::size_t> numbers)
{
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&given](std::size_t i, std::size_t j) { return given[i].length() < given[j].length(); });
  struct Row
  {
    Number_set homology_class, members; // its first number is that of no other row; whose classes add up to it
  };
  std::map<std::size_t, Row> rows; // by first number
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
    Row row = {given[i].homology_class(), {}};
    for(auto it = rows.end(); !row.homology_class.empty() &&
                              (it = rows.find(row.homology_class.front())) != rows.end();)
    {
      add_modulo_two(row.homology_class, it->second.homology_class);
      add_modulo_two(row.members, it->second.members);
    }
    if(row.homology_class.empty())
      result[i] = std::any_of(row.members.begin(), row.members.end(),
                              [&](std::size_t j) { return cross(i, j); });
    else
    {
      add_modulo_two(row.members, {i});
      rows.emplace(row.homology_class.front(), std::move(row));
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_COMPOSED_CONSTRICTIONS_H
