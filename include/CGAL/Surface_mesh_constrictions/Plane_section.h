// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_H

#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/points_of_locations.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What the section of a surface with a plane through one of its points is at that point.
enum class Section_kind
{
  CLOSED, ///< a closed curve
  OPEN,   ///< a curve that ends at the boundary of the surface
  POINT   ///< no curve: the plane touches the surface, at the point or in a flat part around it
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The section of a triangle mesh with a plane through a location: its curve that passes through the location. Where
/// the plane is perpendicular to the axis of a limb, the length of the curve is the girth of the limb as a tailor or an
/// anatomist takes it.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
///
/// \sa `plane_section_at_location()`
template <class TriangleMesh>
struct Plane_section
{
  typedef typename Constriction<TriangleMesh>::Face_location Face_location; ///< a face, and barycentric coordinates

  Section_kind kind = Section_kind::POINT; ///< what the section is at the location

  /// the sequence of points where the curve meets edges and vertices. Between them are straight segments, each in one
  /// face. The first point of a closed curve is the location, which is not repeated; an open curve runs from one end to
  /// the other. Empty if there is no curve.
  std::vector<Face_location> locations;

  double length = 0; ///< in the unit of the mesh's coordinates; 0 if there is no curve

  /// how many curves of the section, closed ones and open ones, meet at the location: 1, or more where limbs meet; 0 if
  /// there is no curve
  std::size_t number_of_curves = 0;

  /// the geodesic loop that a closed curve becomes when it is tightened with the location held; nothing if it shrinks
  /// to the location, or touches or crosses itself. Its member `let_go` is the constriction that the loop becomes when
  /// it is let go.
  std::optional<Geodesic_loop<TriangleMesh>> loop;

  /// writes the points of the curve, in the order of `locations`, to `out`.
  ///
  /// \param tm the mesh that the section was computed on
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
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_H
