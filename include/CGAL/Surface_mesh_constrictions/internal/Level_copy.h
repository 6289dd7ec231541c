// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_LEVEL_COPY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_LEVEL_COPY_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/path_beside_curve.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A level T^k of a progressive mesh as a surface of its own, whose ids are as few as its elements, and the way to it
// from finer levels.
class Level_copy
{
public:
  // Copies the current surface. Linear in T^0.
  explicit Level_copy(const Progressive_mesh& pm)
    : m_vertex(pm.number_of_vertex_ids(), null_index), m_surface(copy(pm, m_vertex))
  {
    for(std::size_t k = pm.level(); k-- > 0;)
    {
      const Progressive_mesh::Split s = pm.applied_collapse(k);
      m_vertex[s.removed] = m_vertex[s.kept];
    }
  }

  const Progressive_mesh& surface() const { return m_surface; }

  // The closed path of edges of this surface that a closed curve of a finer level, at which `pm` is, becomes as faces
  // shrink: a curve of the same homotopy class. Fewer than three vertices if it becomes a point or an edge forth and
  // back. Linear.
  std::vector<Index> path(const Progressive_mesh& pm, const std::vector<Trace_point>& trace) const
  {
    std::vector<Index> path;
    for(const Trace_point& p : trace)
      path.push_back(m_vertex[p.is_pivot() ? p.pivot : pm.target(p.halfedge)]);
    remove_spurs(path);
    return path;
  }

private:
  static Progressive_mesh copy(const Progressive_mesh& pm, std::vector<Index>& vertex)
  {
    std::vector<Index> corners;
    std::vector<Progressive_mesh::Point> points;
    for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      if(pm.is_face(f))
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          Index& v = vertex[pm.source(h)];
          if(v == null_index)
          {
            v = static_cast<Index>(points.size());
            points.push_back(pm.point(pm.source(h)));
          }
          corners.push_back(v);
        }
    const std::size_t n = points.size();
    return Progressive_mesh(make_corner_table(n, std::move(corners)), std::move(points));
  }

  std::vector<Index> m_vertex; // of this surface, by vertex of T^0
  Progressive_mesh m_surface;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_LEVEL_COPY_H
