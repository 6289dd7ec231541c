// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LEVEL_COPY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LEVEL_COPY_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/remove_spurs.h>

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
    : m_vertex(pm.number_of_vertex_ids(), null_index), m_surface(copy(pm, m_vertex, m_original))
  {
    for(std::size_t k = pm.level(); k-- > 0;)
    {
      const Progressive_mesh::Split s = pm.applied_collapse(k);
      m_vertex[s.removed] = m_vertex[s.kept];
    }
  }

  const Progressive_mesh& surface() const { return m_surface; }

  // the vertex of this surface that a vertex of T^0 has been merged into
  Index vertex(Index v) const { return m_vertex[v]; }

  // the number in T^0 of a vertex of this surface
  Index original(Index v) const { return m_original[v]; }

  // Translates a sequence of vertices of T^0, past which a closed curve of a finer level runs, to a closed path of
  // edges of this surface. Fewer than three vertices if the path is a point, or an edge forth and back. Linear.
  std::vector<Index> path(std::vector<Index> vertices) const
  {
    for(Index& v : vertices)
      v = m_vertex[v];
    remove_spurs(vertices);
    return vertices;
  }

private:
  static Progressive_mesh copy(const Progressive_mesh& pm, std::vector<Index>& vertex, std::vector<Index>& original)
  {
    std::vector<Index> corners;
    std::vector<Progressive_mesh::Point> points;
    std::size_t vertices = 0, faces = 0; // without ghosts, which come last
    for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      if(pm.is_face(f))
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          Index& v = vertex[pm.source(h)];
          if(v == null_index)
          {
            v = static_cast<Index>(points.size());
            points.push_back(pm.point(pm.source(h)));
            original.push_back(pm.source(h));
          }
          corners.push_back(v);
          if(!pm.is_ghost_face(f))
          {
            vertices = points.size();
            faces = corners.size() / 3;
          }
        }
    Corner_table table = make_corner_table(points.size(), corners);
    if(pm.has_boundary())
    {
      table.first_ghost_vertex = static_cast<Index>(vertices);
      table.first_ghost_face = static_cast<Index>(faces);
    }
    return Progressive_mesh(std::move(table), std::move(points));
  }

  std::vector<Index> m_vertex;   // of this surface, by vertex of T^0
  std::vector<Index> m_original; // the other way round
  Progressive_mesh m_surface;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_LEVEL_COPY_H
