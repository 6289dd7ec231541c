// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_LOOP_THROUGH_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_LOOP_THROUGH_LOCATIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/points_of_locations.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A closed curve through given locations of a triangle mesh, straight between each two of them that follow each other:
/// in the planar unfolding of the faces that it crosses, with side angles of at least pi at each vertex that it passes
/// through but for the locations. It may cross itself.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
///
/// \sa `geodesic_loop_through_locations()`
template <class TriangleMesh>
struct Loop_through_locations
{
  typedef typename Constriction<TriangleMesh>::Face_location Face_location; ///< a face, and barycentric coordinates

  /// the closed sequence of points, from the first location on, which is not repeated. Any two consecutive ones lie in
  /// one face. The face of a point on an edge is the one that the loop comes from.
  std::vector<Face_location> locations;

  /// the places in `locations` of the given locations, in their order
  std::vector<std::size_t> held;

  double length = 0; ///< in the unit of the mesh's coordinates

  bool is_simple = false; ///< whether it neither crosses nor touches itself

  /// writes the points of the loop, in the order of `locations`, to `out`.
  ///
  /// \param tm the mesh that the loop was computed on
  /// \param vpm its vertex point map
  /// \param out an output iterator that takes the value type of `vpm`
  /// \cost linear in the number of locations
  template <class VertexPointMap, class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, VertexPointMap vpm, OutputIterator out) const
  {
    return internal::points_of_locations(locations, tm, vpm, out);
  }

  /// as above, with the mesh's own points.
  template <class OutputIterator>
  OutputIterator points(const TriangleMesh& tm, OutputIterator out) const
  {
    return points(tm, get(CGAL::vertex_point, tm), out);
  }

  /// what the loop becomes when it is let go at all locations, and tightened
  Tightened_curve<TriangleMesh> let_go;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_LOOP_THROUGH_LOCATIONS_H
