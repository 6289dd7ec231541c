// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_H

#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Arcs of T^0 for the exact arithmetic. Linear.
template <class Surface>
std::vector<Exact_arc<Surface>> exact_arcs(const std::vector<Arc>& arcs)
{
  std::vector<Exact_arc<Surface>> result;
  std::size_t location = 0;
  for(const Arc& a : arcs)
  {
    result.push_back({{a.from, a.to, a.along, {a.crossings.begin(), a.crossings.end()}}, location});
    location += 1 + a.crossings.size();
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_H
