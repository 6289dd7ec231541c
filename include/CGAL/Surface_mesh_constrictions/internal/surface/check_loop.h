// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_LOOP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_LOOP_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Throws Invalid_input, with the number of the loop, if `path` is not a closed path of edges.
inline void check_loop(const Progressive_mesh& pm, const std::vector<Index>& path, std::size_t number)
{
  const std::string name = "loop " + std::to_string(number);
  if(path.size() < 3)
    throw Invalid_input(Input_defect::INVALID_LOOP, number,
                        name + " has " + std::to_string(path.size()) + " vertices; a closed path has at least 3");
  for(std::size_t i = 0; i < path.size(); ++i)
  {
    const Index u = path[i], v = path[(i + 1) % path.size()];
    if(u >= pm.number_of_vertex_ids() || v >= pm.number_of_vertex_ids() || pm.is_ghost_vertex(u) ||
       pm.is_ghost_vertex(v) || !pm.is_vertex(u) || pm.halfedge(u, v) == null_index)
      throw Invalid_input(Input_defect::INVALID_LOOP, number,
                          name + " is not a path of mesh edges: no edge joins vertices " + std::to_string(u) + " and " +
                              std::to_string(v));
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_LOOP_H
