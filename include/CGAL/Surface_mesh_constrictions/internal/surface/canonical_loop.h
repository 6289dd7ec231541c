// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CANONICAL_LOOP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CANONICAL_LOOP_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Turns a closed path so that it starts with its smallest vertex and goes on to the smaller of the two neighbours.
// Paths that visit no vertex twice are the same, whatever their start and direction, if and only if they are equal
// then.
inline void make_canonical(std::vector<Index>& loop)
{
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if(loop.size() > 2 && loop.back() < loop[1])
    std::reverse(loop.begin() + 1, loop.end());
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CANONICAL_LOOP_H
