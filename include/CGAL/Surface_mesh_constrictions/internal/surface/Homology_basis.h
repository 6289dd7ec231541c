// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_HOMOLOGY_BASIS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_HOMOLOGY_BASIS_H

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

// Writes homology classes modulo 2 as sums of the classes of a basis. If curves are offered from the shortest to the
// longest, and those whose class is not a sum are added to the basis, the basis is the shortest one of its span, as the
// greedy algorithm finds it (Erickson and Whittlesey, "Greedy optimal homotopy and homology generators", 2005).
class Homology_basis
{
public:
  // A class, reduced by a sum of classes of the basis, and that sum.
  struct Reduced
  {
    Number_set homology_class; // what is left; its first number is that of no class in the basis
    Number_set members;        // the numbers of the curves whose classes have been added up

    bool is_sum() const { return homology_class.empty(); }
  };

  // O(g^2) for genus g.
  template <class Range>
  Reduced reduce(const Range& homology_class) const
  {
    Reduced result = {Number_set(homology_class.begin(), homology_class.end()), {}};
    while(!result.homology_class.empty())
    {
      const auto it = m_rows.find(result.homology_class.front());
      if(it == m_rows.end())
        break;
      add_modulo_two(result.homology_class, it->second.homology_class);
      add_modulo_two(result.members, it->second.members);
    }
    return result;
  }

  // Adds a reduced class that is not a sum, as that of the curve with this number.
  void add(Reduced reduced, std::size_t number)
  {
    add_modulo_two(reduced.members, {number});
    const std::size_t first = reduced.homology_class.front();
    m_rows.emplace(first, std::move(reduced));
  }

private:
  std::map<std::size_t, Reduced> m_rows; // by first number; the members add up to the class
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_HOMOLOGY_BASIS_H
