// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_TIGHTEN_LOOPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_TIGHTEN_LOOPS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Closed_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_loop.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Tightens closed paths of edges, ranges of vertex descriptors of the mesh. Throws Invalid_input for a loop that is not
// such a path. Cost: that of `tighten_closed_curves()` without that of the mesh.
template <class TriangleMesh, class VertexPointMap, class LoopRange, class OutputIterator>
OutputIterator tighten_loops(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared, const LoopRange& loops,
                             bool certifies, OutputIterator out)
{
  Closed_path_tightener<TriangleMesh, VertexPointMap> tightener(prepared.imported(), prepared.surface(),
                                                                prepared.vertex_point_map(), prepared.length_unit(),
                                                                prepared.sides(), certifies);
  std::size_t number = 0;
  for(const auto& loop : loops)
  {
    std::vector<Index> path;
    for(const auto& v : loop)
      path.push_back(prepared.number_of(v));
    check_loop(prepared.surface(), path, number);
    *out++ = tightener.tighten(std::move(path));
    ++number;
  }
  return out;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_TIGHTEN_LOOPS_H
