// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LEVEL_WITH_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LEVEL_WITH_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The location on the faces around a vertex of a level that is nearest to a point; not on an edge that does not end at
// the vertex. Linear in its degree.
inline Surface_location location_around(const Progressive_mesh& pm, Index vertex, const Progressive_mesh::Point& point)
{
  constexpr double least_share = 0.01; // of the vertex
  Surface_location nearest = {null_index, {{0, 0, 0}}};
  double least = (std::numeric_limits<double>::infinity)();
  const Index begin = pm.outgoing(vertex);
  Index h = begin;
  do
  {
    const Index f = pm.face(h);
    if(!pm.is_ghost_face(f))
    {
      Surface_location l = {f, nearest_in_triangle(point, pm.point(pm.source(3 * f)), pm.point(pm.source(3 * f + 1)),
                                                   pm.point(pm.source(3 * f + 2)))};
      const double d = norm(vector(point, point_of(pm, l)));
      if(d < least)
      {
        least = d;
        const double share = (std::max)(l.barycentric[h % 3], least_share), rest = 1 - l.barycentric[h % 3];
        for(double& b : l.barycentric)
          b *= rest > 0 ? (1 - share) / rest : 1;
        l.barycentric[h % 3] = share;
        nearest = without_tiny_coordinates(l);
      }
    }
    h = pm.ccw(h);
  } while(h != begin);
  return nearest;
}

// A level with the point put in that is nearest to a location of the input, on the faces around a vertex, the one that
// the location's nearest vertex has been merged into.
class Level_with_location
{
public:
  // Linear in the size of the level.
  Level_with_location(const Progressive_mesh& level, Index merged, const Progressive_mesh::Point& location)
    : m_level(level)
  {
    Surface_with_point inserted = insert_point(level, location_around(level, merged, location));
    m_vertex = inserted.vertex;
    if(inserted.is_changed)
      m_changed.emplace(std::move(inserted.table), std::move(inserted.points));
  }

  const Progressive_mesh& surface() const { return m_changed ? *m_changed : m_level; }
  Index vertex() const { return m_vertex; }

private:
  const Progressive_mesh& m_level;
  std::optional<Progressive_mesh> m_changed;
  Index m_vertex;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LEVEL_WITH_LOCATION_H
