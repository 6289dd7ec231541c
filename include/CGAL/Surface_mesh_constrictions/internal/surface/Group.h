// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GROUP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GROUP_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Consecutive items that one thread processes, and its result. Groups do not depend on the number of threads, so
// results that depend on the grouping do not either.
template <class Result>
struct Group
{
  std::size_t begin, end;
  Result result;
};

// Groups of `size` items, of which the last may have fewer.
template <class Result>
std::vector<Group<Result>> make_groups(std::size_t items, std::size_t size)
{
  std::vector<Group<Result>> groups;
  for(std::size_t begin = 0; begin < items; begin += size)
    groups.push_back({begin, (std::min)(begin + size, items), Result()});
  return groups;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GROUP_H
