// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The lengths of the edges of T^0, computed once; infinite for those of ghost vertices.
class Edge_lengths
{
public:
  // Linear.
  explicit Edge_lengths(const Progressive_mesh& pm)
  {
    m_lengths.reserve(pm.number_of_halfedge_ids());
    for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
      m_lengths.push_back(pm.is_ghost_vertex(pm.source(h)) || pm.is_ghost_vertex(pm.target(h))
                              ? (std::numeric_limits<double>::infinity)()
                              : norm(vector(pm.point(pm.source(h)), pm.point(pm.target(h)))));
  }

  double operator[](Index h) const { return m_lengths[h]; }

private:
  std::vector<double> m_lengths; // of halfedges
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H
