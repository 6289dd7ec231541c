// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_NESTED_PARTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_NESTED_PARTS_H

#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/find_nested_cuts.h>

#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// unites the parts of a surface until there are no more of them than a given number, but at least one for each
/// connected component of the surface. So one call of `segment_by_constrictions()` gives the parts for any number.
///
/// The parts are those that `segment_by_constrictions()` finds with `maximum_number_of_parts`. They are nested: their
/// borders are some of those for any greater number, and each of them consists of parts for any greater number. A
/// number of parts is left out where one curve makes several, as one that touches others can.
///
/// \param parts the parts between all curves, computed without `maximum_number_of_parts`
/// \param maximum_number_of_parts the greatest number of parts
///
/// \return for each of the parts the number of the part that contains it; these are counted from 0 in the order of
///         their first parts
/// \cost linear in the number of adjacencies, but for the uniting of parts
///
/// \sa `Surface_parts::nested_cuts`
inline std::vector<std::size_t> nested_parts(const Surface_parts& parts, std::size_t maximum_number_of_parts)
{
  std::unordered_set<std::size_t> cuts;
  for(const Nested_cut& c : parts.nested_cuts)
    if(c.number_of_parts <= maximum_number_of_parts)
      cuts.insert(c.curve);
  internal::United_parts united(parts.parts.size());
  for(const Part_adjacency& a : parts.adjacencies)
    if(cuts.count(a.curve) == 0)
      united.unite(a.parts[0], a.parts[1]);

  std::vector<std::size_t> result(parts.parts.size());
  std::size_t n = 0;
  for(std::size_t p = 0; p < result.size(); ++p)
  {
    const std::size_t first = united.representative(p);
    result[p] = first == p ? n++ : result[first];
  }
  return result;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_NESTED_PARTS_H
