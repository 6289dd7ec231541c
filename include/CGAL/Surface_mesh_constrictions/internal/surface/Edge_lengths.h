// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <atomic>
#include <limits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The lengths of the edges of a surface that stays at its level, each computed when it is first read; infinite for
// those of ghost vertices. Several threads may read them at a time. Memory: 8 bytes for each halfedge that is read.
class Edge_lengths
{
public:
  explicit Edge_lengths(const Progressive_mesh& pm) : m_pm(pm), m_lengths(pm.number_of_halfedge_ids()) {}

  double operator[](Index h) const
  {
    const double known = m_lengths[h].load(std::memory_order_relaxed);
    if(known > 0)
      return known;
    const double length = m_pm.is_ghost_vertex(m_pm.source(h)) || m_pm.is_ghost_vertex(m_pm.target(h))
                              ? (std::numeric_limits<double>::infinity)()
                              : norm(vector(m_pm.point(m_pm.source(h)), m_pm.point(m_pm.target(h))));
    m_lengths[h].store(length, std::memory_order_relaxed);
    return length;
  }

private:
  const Progressive_mesh& m_pm;
  mutable Zeroed_array<std::atomic<double>> m_lengths; // of halfedges; 0 for one that has not been read
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_LENGTHS_H
