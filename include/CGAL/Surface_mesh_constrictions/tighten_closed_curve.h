// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_CLOSED_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_CLOSED_CURVE_H

#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/tighten_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Tightening_parameters : Mesh_parameters::With<internal_np::certify_t>
{};

// What `tighten_closed_curves()` does with arguments of the right kind.
template <class TriangleMesh, class LoopRange, class OutputIterator, class NamedParameters>
OutputIterator tighten_closed_curves_checked(const TriangleMesh& tm, const LoopRange& loops, OutputIterator out,
                                             const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// shortens closed loops of edges on a fixed mesh until they are closed geodesics, or found degenerate (the paper's
/// "loosening", Section 6).
///
/// Every step shortens the curve, measured in whole multiples of a small unit of length, so the function ends for every
/// input. A loop may run out and back along an edge, or visit an edge twice; tightening removes this. A curve that
/// slips out of a flat band at an end that leaks goes on shortening; a curve in a band that holds is moved to the
/// canonical end of the band.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam LoopRange a range of ranges of vertex descriptors
/// \tparam OutputIterator takes `Tightened_curve<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param loops closed paths of mesh edges, each the cyclic sequence of its vertices, the first not repeated
/// \param out one result for each loop, in order
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
///     \cgalParamDescription{whether each curve is certified with exact arithmetic, and corrected where rounding has
///                           led it astray}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used, for a loop that is not a closed path of mesh edges, and, with
///         `certify`, for a coordinate that is not a rational number of moderate size
/// \cost linear in the size of the mesh, plus for each loop linear in the lengths of the strips that it is led through,
///       plus, with `certify`, that of `certify_constriction()`
template <class TriangleMesh, class LoopRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator tighten_closed_curves(const TriangleMesh& tm, const LoopRange& loops, OutputIterator out,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Tightening_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Tightened_curve<TriangleMesh>>() &&
               knows_all)
    return internal::tighten_closed_curves_checked(tm, loops, out, np);
  else
    return out;
}

namespace internal {

template <class TriangleMesh, class LoopRange, class OutputIterator, class NamedParameters>
OutputIterator tighten_closed_curves_checked(const TriangleMesh& tm, const LoopRange& loops, OutputIterator out,
                                             const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const bool certifies = choose_parameter(get_parameter(np, internal_np::certify), true);

  Prepared_surface<TriangleMesh, std::decay_t<decltype(vpm)>> prepared(tm, vpm, vim);
  prepared.hold_no_levels();
  return tighten_loops(prepared, loops, certifies, out);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// shortens one closed loop of edges until it is a closed geodesic, or found degenerate; see `tighten_closed_curves()`.
///
/// \param tm a triangle mesh, closed or with boundary
/// \param loop a range of vertex descriptors
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `tighten_closed_curves()`
///
/// \return the constriction, or why there is none
/// \throws Invalid_input as `tighten_closed_curves()`
/// \cost that of `tighten_closed_curves()` with one loop
template <class TriangleMesh, class Loop, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tightened_curve<TriangleMesh> tighten_closed_curve(const TriangleMesh& tm, const Loop& loop,
                                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Tightened_curve<TriangleMesh>> result;
  const Loop* loops = &loop;
  tighten_closed_curves(tm, CGAL::make_range(loops, loops + 1), std::back_inserter(result), np);
  return result.front();
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_CLOSED_CURVE_H
