// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REMOVE_SPURS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REMOVE_SPURS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Takes out of a closed path what goes forth and back, and vertices that follow themselves. Linear.
inline void remove_spurs(std::vector<Index>& path)
{
  std::vector<Index> kept;
  for(Index v : path)
    if(kept.size() > 1 && kept[kept.size() - 2] == v)
      kept.pop_back();
    else if(kept.empty() || kept.back() != v)
      kept.push_back(v);
  std::size_t begin = 0, end = kept.size(); // of what is left when the ends are compared
  while(end - begin > 2)
    if(kept[begin] == kept[end - 1] || kept[begin] == kept[end - 2])
      --end;
    else if(kept[begin + 1] == kept[end - 1])
      ++begin;
    else
      break;
  path.assign(kept.begin() + static_cast<std::ptrdiff_t>(begin), kept.begin() + static_cast<std::ptrdiff_t>(end));
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REMOVE_SPURS_H
