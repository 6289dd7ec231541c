// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_AT_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_AT_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Plane_section.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/section_at_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Plane_section_parameters : Mesh_parameters::With<internal_np::certify_t>
{};

// What `plane_section_at_location()` does with arguments of the right kind.
template <class TriangleMesh, class Location, class Vector, class NamedParameters>
Plane_section<TriangleMesh> plane_section_at_location_checked(const TriangleMesh& tm, const Location& location,
                                                              const Vector& axis, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// cuts a surface with the plane that passes through a location and is perpendicular to an axis, and tightens the curve
/// through the location. The length of the curve is the girth of a limb whose axis has the given direction; tightening
/// leads to the geodesic loop nearest to the curve.
///
/// The curve is the one that passes through the location; other curves of the same section, for example of other limbs,
/// are left out. Where several curves of the section meet at the location, for example at the crotch between two legs,
/// the shortest closed one is taken. Vertices in the plane count as being above it, or below it if there is no curve
/// then, so that the section is a curve everywhere. An axis and the opposite one give the same curve. A closed curve is
/// tightened with the location held, like the loops of `geodesic_loops_at_location()`, and the loop that results is let
/// go. The plane may be far from perpendicular to the limb, and then the section is longer than the loop: on a cylinder
/// it is an ellipse, and the loop a circle.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Location a vertex descriptor of `TriangleMesh`, or `Constriction<TriangleMesh>::Face_location`, or a 3D
///         point of any kernel
/// \tparam Vector a 3D vector of any kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param location a place, as for `geodesic_loops_at_location()`
/// \param axis the direction of the axis, of any length but 0
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether the curve that the loop becomes when it is let go is certified with exact
///                           arithmetic, and corrected where rounding has led it astray}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the curve: closed, or open where the surface has a boundary, or none where the plane only touches the
///         surface
/// \throws Invalid_input for a mesh that cannot be used; for a location that is not on the mesh, as
///         `geodesic_loops_at_location()`; for an axis with a coordinate that is not a finite number, and for one of
///         length 0; and, with `certify`, for a coordinate that is not a rational number of moderate size
/// \cost linear in the size of the mesh, plus the cost of `tighten_closed_curve()`. Of a prepared mesh, see
///       `Constriction_query::plane_section()`, the section at a vertex is linear in the number of faces that it
///       crosses; at another location it costs a copy of the mesh's connectivity and points.
///
/// \sa `geodesic_loops_at_location()`
/// \sa `Constriction_query`
template <class TriangleMesh, class Location, class Vector,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Plane_section<TriangleMesh> plane_section_at_location(const TriangleMesh& tm, const Location& location,
                                                      const Vector& axis,
                                                      const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Plane_section_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<TriangleMesh>() && knows_all)
    return internal::plane_section_at_location_checked(tm, location, axis, np);
  else
    return internal::no_result<Plane_section<TriangleMesh>>();
}

namespace internal {

template <class TriangleMesh, class Location, class Vector, class NamedParameters>
Plane_section<TriangleMesh> plane_section_at_location_checked(const TriangleMesh& tm, const Location& location,
                                                              const Vector& axis, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  typedef std::decay_t<decltype(vpm)> Vertex_point_map;
  const Vector3 direction = given_axis(axis);
  Prepared_surface<TriangleMesh, Vertex_point_map> prepared(tm, vpm, vim);
  prepared.hold_no_levels();
  return Section_at_location<TriangleMesh, Vertex_point_map>(prepared, location)
      .section(direction, choose_parameter(get_parameter(np, internal_np::certify), true));
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PLANE_SECTION_AT_LOCATION_H
