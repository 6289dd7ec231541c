// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_THROUGH_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_THROUGH_LOCATIONS_H

#include <CGAL/Surface_mesh_constrictions/Loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/loop_through.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Loop_through_parameters : Mesh_parameters::With<internal_np::certify_t>
{};

// What `geodesic_loop_through_locations()` does with arguments of the right kind.
template <class TriangleMesh, class LocationRange, class NamedParameters>
Loop_through_locations<TriangleMesh> geodesic_loop_through_locations_checked(const TriangleMesh& tm,
                                                                             const LocationRange& locations,
                                                                             const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// joins a few locations of a mesh by geodesics, in their order and back to the first, and tightens the closed curve.
///
/// Each two locations that follow each other are joined by the shortest path of edges, which is then tightened with
/// both ends held. So the curve is bent at the locations at most, and close to a curve through them no shorter one is
/// found. `Loop_through_locations::let_go` is what it becomes when it is let go at the locations, too: see
/// `tighten_closed_curve()`. Consecutive vertices that an edge joins are joined by that edge, so that an open path of
/// edges, given by its vertices, is closed by the way from its end to its beginning.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam LocationRange a range whose elements are vertex descriptors of `TriangleMesh`, or
///         `Constriction<TriangleMesh>::Face_location`, or 3D points of any kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param locations three or more; each differs from the one before, and the last from the first. A point in space
///        stands for the point of the surface that is nearest to it. Barycentric coordinates of less than
///        \f$10^{-6}\f$ are taken to be zero.
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
/// \return the loop
/// \throws Invalid_input for a mesh that cannot be used; for fewer than three locations, for one that is the same as
///         the one before or on another connected component, and for one that is not on the mesh, as
///         `geodesic_loops_at_location()`: `Invalid_input::element()` is its number; and, with `certify`, for a
///         coordinate that is not a rational number of moderate size
/// \cost linear in the size of the mesh, for each location inside a face or on an edge once more; plus, for each
///       location, O(m log m) for the m vertices that are no further away than the next one; plus that of
///       `tighten_closed_curve()`
///
/// \sa `tighten_closed_curve()`
/// \sa `geodesic_loops_at_location()`
template <class TriangleMesh, class LocationRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
Loop_through_locations<TriangleMesh>
geodesic_loop_through_locations(const TriangleMesh& tm, const LocationRange& locations,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Loop_through_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<TriangleMesh>() && knows_all)
    return internal::geodesic_loop_through_locations_checked(tm, locations, np);
  else
    return internal::no_result<Loop_through_locations<TriangleMesh>>();
}

namespace internal {

template <class TriangleMesh, class LocationRange, class NamedParameters>
Loop_through_locations<TriangleMesh> geodesic_loop_through_locations_checked(const TriangleMesh& tm,
                                                                             const LocationRange& locations,
                                                                             const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  Prepared_surface<TriangleMesh, std::decay_t<decltype(vpm)>> prepared(tm, vpm, vim);
  prepared.hold_no_levels();
  return loop_through(prepared, given_locations(prepared, locations),
                      choose_parameter(get_parameter(np, internal_np::certify), true));
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOP_THROUGH_LOCATIONS_H
