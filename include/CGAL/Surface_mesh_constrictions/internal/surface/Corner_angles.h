// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_ANGLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_ANGLES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>

#include <atomic>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The angles of the corners of a surface that stays at its level, each computed when it is first read. Several threads
// may read them at a time. Memory: 8 bytes for each halfedge that is read.
class Corner_angles
{
public:
  explicit Corner_angles(const Progressive_mesh& pm) : m_pm(pm), m_angles(pm.number_of_halfedge_ids()) {}

  // at the source of a halfedge, in its face
  double operator()(Index h) const
  {
    const double known = m_angles[h].load(std::memory_order_relaxed);
    if(known > 0)
      return known;
    const double angle = corner_angle(m_pm, h);
    m_angles[h].store(angle, std::memory_order_relaxed);
    return angle;
  }

private:
  const Progressive_mesh& m_pm;
  mutable Zeroed_array<std::atomic<double>> m_angles; // 0 for one that has not been read
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_ANGLES_H
