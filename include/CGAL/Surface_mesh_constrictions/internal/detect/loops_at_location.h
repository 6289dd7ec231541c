// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOPS_AT_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOPS_AT_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Geodesic_loop_maker.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Writes the shortest geodesic loops at a location of a prepared surface, at most `maximum_number` of them. Throws
// Invalid_input for a location that is not on the mesh. Cost: that of `geodesic_loops_at_location()` without that of
// preparing the mesh. A location that is not a vertex costs a copy of the connectivity and the points.
template <class TriangleMesh, class VertexPointMap, class Location, class OutputIterator>
OutputIterator write_loops_at_location(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                       const Location& location, std::size_t maximum_number, double minimum_angle,
                                       bool certifies, OutputIterator out)
{
  const Progressive_mesh& pm = prepared.surface();
  const Surface_location at = without_tiny_coordinates(given_location(prepared, location));
  if(maximum_number == 0)
    return out;
  Surface_with_point inserted = insert_point(pm, at);
  std::optional<Progressive_mesh> changed;
  if(inserted.is_changed)
    changed.emplace(std::move(inserted.table), std::move(inserted.points));
  const Progressive_mesh& with = changed ? *changed : pm;

  std::vector<std::vector<Arc>> loops;
  if(prepared.searching() == nullptr)
    loops = held_loops(with, inserted.vertex, minimum_angle, prepared.length_unit());
  else
  {
    // a corner that is joined to the location, and lies nearest to it
    const Index corner =
        static_cast<Index>(std::max_element(at.barycentric.begin(), at.barycentric.end()) - at.barycentric.begin());
    const Index nearest = changed ? pm.source(3 * at.face + corner) : inserted.vertex;
    loops = held_loops_of_levels(prepared, with, inserted.vertex, nearest, minimum_angle, maximum_number);
  }
  if(loops.size() > maximum_number)
    loops.resize(maximum_number);
  if(loops.empty())
    return out;
  Geodesic_loop_maker<TriangleMesh, VertexPointMap> maker(prepared, with, inserted, at, certifies);
  for(const std::vector<Arc>& loop : loops)
    *out++ = maker.make(loop);
  return out;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOPS_AT_LOCATION_H
