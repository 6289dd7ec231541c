// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BY_LENGTH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BY_LENGTH_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The indices of lengths, the least first.
inline std::vector<Index> by_length(const std::vector<double>& lengths)
{
  std::vector<Index> order(lengths.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&lengths](Index a, Index b) { return lengths[a] < lengths[b]; });
  return order;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_BY_LENGTH_H
