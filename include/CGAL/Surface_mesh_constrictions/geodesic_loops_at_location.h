// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Geodesic_loop_maker.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A loop with a smaller angle at the location runs to something, around it, and back by nearly the same way.
constexpr double least_loop_angle = CGAL_PI / 4;

struct Geodesic_loop_parameters : Mesh_parameters::With<internal_np::certify_t, internal_np::maximum_number_of_loops_t,
                                                        internal_np::minimum_loop_angle_t>
{};

// What `geodesic_loops_at_location()` does with arguments of the right kind.
template <class TriangleMesh, class Location, class OutputIterator, class NamedParameters>
OutputIterator geodesic_loops_at_location_checked(const TriangleMesh& tm, const Location& location, OutputIterator out,
                                                  const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds the shortest closed curve around the limb through a location, its girth there, whether that is a constriction
/// or not; and, if asked for, the next ones.
///
/// A closed curve that is held at a location and tightened becomes a geodesic loop: straight everywhere else, with side
/// angles of at least pi at each other vertex, `Geodesic_loop`. Geodesic loops go through the cut locus of the
/// location, where two shortest paths from it meet, and there through the local minima of the distance, which are its
/// saddles. These are looked for with shortest paths along edges: to each belongs the loop of edges through it, and the
/// lesser part that it cuts off reaches further by some share, its persistence. The 4096 loops of greatest persistence,
/// among them all of a greedy homotopy basis \cgalCite{ew_gohhg_05}, are tightened with the location held.
///
/// The answer is the shortest of the simple geodesic loops that come up and are not folded: at the location their angle
/// is at least `minimum_loop_angle`. A loop that shrinks to the location while it is held there is none, and one that crosses
/// or touches itself is left out. What remains is of two kinds, which the result tells apart: a loop that comes to
/// rest, as a rule at a constriction, when it is let go; and one that shrinks to a point then,
/// `Geodesic_loop::encloses_tip()`: it slides off over a tip that is steeper than the apex of a cone of 60 degrees, a
/// finger's say. On a body without such a tip, as a ball, there may be no loop; nothing is written then. If the
/// location lies on a constriction, that is one of the loops, `Geodesic_loop::is_closed_geodesic`.
///
/// A location inside a face or on an edge is put into a copy of the mesh as a vertex, to which it is rounded; results
/// are on `tm`. Barycentric coordinates of less than \f$10^{-6}\f$ are taken to be zero.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Location a vertex descriptor of `TriangleMesh`, or `Constriction<TriangleMesh>::Face_location`, or a 3D
///         point of any kernel
/// \tparam OutputIterator takes `Geodesic_loop<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param location where the loops are held. For a point in space, on the surface or not, it is the point of the
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
///     \cgalParamDescription{how many loops are written at most, the shortest ones}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_loop_angle}
///     \cgalParamDescription{the angle that a loop has at least, in radians, on the side of the location where it is
///                           smaller: it is near pi around a tube, and small where a loop runs to a limb, around it,
///                           and back. With 0 the shortest loop of all is written, folded or not.}
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
/// \throws Invalid_input for a mesh that cannot be used; for a location with a coordinate that is no finite number, or
///         that is not on the mesh: an isolated vertex, a vertex or a face that is not one of `tm`, or barycentric
///         coordinates that are negative or do not add up to 1; and, with `certify`, for a coordinate that is no
///         rational number of moderate size
/// \cost O(n log n) for n faces, plus for each of the 4096 loops linear in the lengths of the strips that it is led
///       through until it is what another one was on its way, plus for each loop that is written the cost of
///       `tighten_closed_curve()`
///
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

  Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const Surface_location at = without_tiny_coordinates(given_location(imported, vim, location));
  Surface_with_point inserted = insert_point(imported.table, imported.points, at);
  const Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  std::optional<Progressive_mesh> changed;
  if(inserted.is_changed)
    changed.emplace(std::move(inserted.table), std::move(inserted.points));

  std::vector<std::vector<Arc>> loops = held_loops(changed ? *changed : pm, inserted.vertex, minimum_angle);
  if(loops.size() > maximum_number)
    loops.resize(maximum_number);
  if(loops.empty())
    return out;
  Geodesic_loop_maker<TriangleMesh, std::decay_t<decltype(vpm)>> maker(imported, pm, changed ? *changed : pm, inserted,
                                                                       at, vpm, certifies);
  for(const std::vector<Arc>& loop : loops)
    *out++ = maker.make(loop);
  return out;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_GEODESIC_LOOPS_AT_LOCATION_H
