// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/loops_at_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

struct Geodesic_loop_parameters : Mesh_parameters::With<internal_np::certify_t, internal_np::maximum_number_of_loops_t,
                                                        internal_np::minimum_loop_angle_t>
{};

// What `geodesic_loops_at_location()` does with arguments of the right kind.
template <class TriangleMesh, class Location, class OutputIterator, class NamedParameters>
OutputIterator geodesic_loops_at_location_checked(const TriangleMesh& tm, const Location& location, OutputIterator out,
                                                  const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds the shortest closed curve through a location around the limb that it is on, the girth of the limb there,
/// whether the limb is narrow there or not. `maximum_number_of_loops` adds the next ones.
///
/// A closed curve that is held at a location and tightened becomes a geodesic loop: straight everywhere else, with side
/// angles of at least pi at each other vertex, `Geodesic_loop`. Geodesic loops go through the cut locus of the
/// location, where two shortest paths from it meet, and there through the local minima of the distance along the cut
/// locus, which are saddles of the distance. The function looks for these saddles with shortest paths along edges. To
/// each saddle belongs the loop of edges through it, and a persistence: how much further than the saddle the lesser of
/// the two parts reaches that meet there. The 4096 loops of greatest persistence, among them all of a greedy homotopy
/// basis \cgalCite{ew_gohhg_05}, are tightened with the location held. On a mesh of more than 16384
/// vertices loops are looked for on levels of its simplification; those that are tight there are led to the mesh, and
/// tightened again. Then the loop that is found need not be the shortest; see the user manual.
///
/// The answer is the shortest of the simple geodesic loops that result and are not folded: their angle at the location
/// is at least `minimum_loop_angle`. A loop that shrinks to the location while it is held is dropped, and so is one
/// that crosses or touches itself. The loops that remain are of two kinds, which the result tells apart. One comes to
/// rest when it is let go, as a rule at a constriction. The other one shrinks to a point when it is let go,
/// `Geodesic_loop::encloses_tip()`: it slides off over a tip, of a finger say, that is steeper than the apex of a cone
/// of 60 degrees. On a body without such a tip, as a ball, there may be no loop; then nothing is written. If the
/// location lies on a constriction, the constriction is one of the loops, `Geodesic_loop::is_closed_geodesic`.
///
/// A location inside a face or on an edge is rounded and put into a copy of the mesh as a vertex; the results are on
/// `tm`. Barycentric coordinates of less than \f$10^{-6}\f$ are taken to be zero.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Location a vertex descriptor of `TriangleMesh`, or `Constriction<TriangleMesh>::Face_location`, or a 3D
///         point of any kernel
/// \tparam OutputIterator takes `Geodesic_loop<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param location where the loops are held. A point in space, on the surface or not, stands for the point of the
///        surface that is nearest to it.
/// \param out the loops, the shortest first
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
///   \cgalParamNBegin{maximum_number_of_loops}
///     \cgalParamDescription{the greatest number of loops; the shortest are written}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_loop_angle}
///     \cgalParamDescription{the least angle of a loop at the location, in radians, on the side where it is smaller. It
///                           is near pi around a tube, and small where a loop runs to a limb, around it, and back. With
///                           0 the shortest loop of all is written, folded or not.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{a quarter of pi}
///   \cgalParamNEnd
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether the curves that loops become when they are let go are certified with exact
///                           arithmetic, and corrected where rounding has led them astray. The loops themselves rest on
///                           rounded numbers.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used; for a location with a coordinate that is not a finite number,
///         or that is not on the mesh: an isolated vertex, a vertex or a face that is not one of `tm`, or barycentric
///         coordinates that are negative or do not add up to 1; and, with `certify`, for a coordinate that is not a
///         rational number of moderate size
/// \cost O(n log n) for n faces; plus, for each of the 4096 loops, linear in the lengths of the strips that it is led
///       through until it meets the way of another loop; plus, for each loop that is written, the cost of
///       `tighten_closed_curve()`
///
/// \sa `Constriction_query`
/// \sa `detect_constrictions_near()`
/// \sa `tighten_closed_curve()`
template <class TriangleMesh, class Location, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator geodesic_loops_at_location(const TriangleMesh& tm, const Location& location, OutputIterator out,
                                          const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Geodesic_loop_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Geodesic_loop<TriangleMesh>>() &&
               knows_all)
    return internal::geodesic_loops_at_location_checked(tm, location, out, np);
  else
    return out;
}

namespace internal {

template <class TriangleMesh, class Location, class OutputIterator, class NamedParameters>
OutputIterator geodesic_loops_at_location_checked(const TriangleMesh& tm, const Location& location, OutputIterator out,
                                                  const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const bool certifies = choose_parameter(get_parameter(np, internal_np::certify), true);
  const std::size_t maximum_number =
      choose_parameter(get_parameter(np, internal_np::maximum_number_of_loops), std::size_t(1));
  const double minimum_angle =
      choose_parameter(get_parameter(np, internal_np::minimum_loop_angle), internal::least_loop_angle);

  Prepared_surface<TriangleMesh, std::decay_t<decltype(vpm)>> prepared(tm, vpm, vim);
  if(prepared.is_searched_on_level())
    prepared.template simplify<Sequential_tag>(Garland_heckbert_policies(), false, Detection_visitor_base(),
                                               append_collapses);
  else
    prepared.hold_no_levels();
  return write_loops_at_location(prepared, location, maximum_number, minimum_angle, certifies, out);
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H
