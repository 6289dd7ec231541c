// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COARSEST_FIRST_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COARSEST_FIRST_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The numbers of the seeds, from the coarsest level to the finest.
inline std::vector<std::size_t> coarsest_first(const std::vector<Seed_curve>& seeds)
{
  std::vector<std::size_t> order(seeds.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&seeds](std::size_t a, std::size_t b) { return seeds[a].level > seeds[b].level; });
  return order;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COARSEST_FIRST_H
