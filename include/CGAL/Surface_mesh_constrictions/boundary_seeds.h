// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_BOUNDARY_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_BOUNDARY_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/canonical_loop.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The boundary of the hole that a ghost closes. Linear in its edges.
inline Seed_curve boundary_seed(const Progressive_mesh& pm, Index ghost)
{
  std::vector<Index> loop;
  const Index begin = pm.outgoing(ghost);
  Index h = begin;
  do
  {
    loop.push_back(pm.target(h));
    h = pm.ccw(h);
  } while(h != begin);
  make_canonical(loop);
  return Seed_curve{pm.level(), std::move(loop), Seed_origin::BOUNDARY};
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the boundaries of the holes of the current surface. A rubber band that is laid along a boundary stays there
/// as a rim, or slides to the narrow place behind it, or shrinks to a point; tightening finds which.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \return the output iterator, past the last element that was written
/// \cost linear in the number of boundary edges
template <class OutputIterator>
OutputIterator boundary_seeds(const Progressive_mesh& pm, OutputIterator out)
{
  const Index n = static_cast<Index>(pm.number_of_vertex_ids());
  for(Index ghost = n - static_cast<Index>(pm.number_of_holes()); ghost < n; ++ghost)
    *out++ = internal::boundary_seed(pm, ghost);
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_BOUNDARY_SEEDS_H
