// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/points_of_locations.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A simple closed curve that is held at one location of a triangle mesh and straight everywhere else: in the planar
/// unfolding of the faces that it crosses, with side angles of at least pi at each vertex that it passes through but
/// for the location. No curve through the location that is close to it is shorter.
///
/// If it is straight at the location, too, it is a closed geodesic. All others become shorter when they are let go;
/// `let_go` has what they become.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
///
/// \sa `geodesic_loops_at_location()`
template <class TriangleMesh>
struct Geodesic_loop
{
  typedef typename Constriction<TriangleMesh>::Face_location Face_location; ///< a face, and barycentric coordinates
  typedef typename Constriction<TriangleMesh>::Pivot Pivot;                 ///< a vertex that it passes through

  /// the closed sequence of points. The first is the location that the loop is held at; it is not repeated. Any two
  /// consecutive ones lie in one face. The face of a point on an edge is the one that the loop comes from, and the
  /// barycentric coordinates with respect to the ends of that edge are not zero.
  std::vector<Face_location> locations;

  /// the vertices that the loop passes through, in the order of `locations`; the first location is among them if it is
  /// a vertex
  std::vector<Pivot> pivots;

  double length = 0; ///< in the unit of the mesh's coordinates

  double left_angle = 0;  ///< radians, along the surface at the first location, on the left; infinite to a hole
  double right_angle = 0; ///< radians, along the surface at the first location, on the right; infinite to a hole

  bool is_closed_geodesic = false; ///< whether both angles at the first location are at least pi, but for rounding

  bool separating = false;                      ///< see `Constriction::is_separating()`
  std::array<double, 2> areas = {{0, 0}};       ///< see `Constriction::areas()`
  std::array<std::size_t, 2> genera = {{0, 0}}; ///< see `Constriction::genera()`
  double isoperimetric_ratio = 0;               ///< see `Constriction::isoperimetric_ratio()`
  double roundness = 0;                         ///< see `Constriction::roundness()`
  std::array<double, 3> centroid = {{0, 0, 0}}; ///< see `Constriction::centroid()`
  std::array<double, 3> normal = {{0, 0, 0}};   ///< see `Constriction::normal()`
  Side side = Side::MIXED;                      ///< see `Constriction::side()`
  double boundary_share = 0;                    ///< see `Constriction::boundary_share()`

  /// what the loop becomes when it is let go on the side of the smaller angle, and tightened
  Tightening_verdict verdict = Tightening_verdict::DEGENERATE;

  /// the constriction that it becomes, if `verdict` is `CLOSED_GEODESIC`; else empty. In a flat band this is the
  /// canonical copy, which need not pass through the location even if the loop is a closed geodesic.
  Constriction<TriangleMesh> let_go;

  /// whether the loop shrinks to a point when it is let go. Then it bounds a disc with a tip. By the theorem of Gauss
  /// and Bonnet the angle defects of the vertices strictly inside the disc add up to at least pi plus the angle of the
  /// loop at the location on that side, which is more than at the apex of a cone of 60 degrees.
  bool encloses_tip() const { return verdict == Tightening_verdict::DEGENERATE; }

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
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_H
