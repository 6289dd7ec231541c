// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/bound_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/policies_asked_for.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <iterator>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

struct Detection_near_parameters
  : Near_parameters::With<internal_np::vertex_point_t, internal_np::vertex_index_t, internal_np::get_cost_policy_t,
                          internal_np::get_placement_policy_t, internal_np::simplification_policies_t,
                          internal_np::prove_prominence_t>
{};

// What `detect_constrictions_near()` does with arguments of the right kind.
template <class ConcurrencyTag, class TriangleMesh, class Point, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_near_checked(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                                 const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds the constrictions around a location: "the loop around this arm".
///
/// The seeds are the loops of `Local_cut_locus_seeds` at the vertex of `tm` that is nearest to `location`; and, on a
/// mesh with holes, the boundaries of the three nearest holes, `Local_boundary_seeds`. Of the constrictions that they
/// lead to those are written that are around the location, so that where nothing is narrow there are none: those that
/// pass it, at a distance of at most a twentieth of their length; those that are no longer than 1.5 times the girth at
/// the location, as the level of 1000 vertices tells it (where limbs meet, the greatest one), and no further away than
/// their length; and, where no loop holds at the location, those that cut it off, on the side of lesser area. Of two
/// that cross the nearer one is written.
///
/// They are written in ascending order of \f$d (1 + d/L) + L/10\f$, where \f$L\f$ is the length of the curve and
/// \f$d\f$ its distance in space from the location, less the width of its flat band. So the nearest comes first; of two
/// that are about as near the shorter one; and late one whose distance is several times its length.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Point a 3D point, of any kernel
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, as for `detect_constrictions()`
/// \param location a point on the surface or near it
/// \param out the constrictions, the nearest first. The places that `Constriction::dominated_by()` and
///        `Constriction::crosses()` name are those in this sequence; a constriction slides to one that is not in it,
///        too, and then has no dominating one.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
///        `detect_constrictions()` but for `seed_sources`, `seed_detection`, `tightening_schedule` and
///        `first_constriction_only`; of the simplification policies one can be given. There are these differences:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the least prominence of a constriction}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: around a tube that does not widen all constrictions have a small prominence, and the caller
///                       wants one of them}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_isolation}
///     \cgalParamDescription{the least isolation of a constriction among those of no less prominence}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_constrictions}
///     \cgalParamDescription{the greatest number of constrictions; the nearest are written}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{all_constrictions}
///     \cgalParamDescription{whether to write every constriction that the seeds lead to, around the location or not}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last constriction
/// \throws Invalid_input as `detect_constrictions()`, and for a location with a coordinate that is not a finite number
/// \throws exceptions of the visitor; then nothing has been written
/// \cost hardly more than that of the simplification, O(n log n) for n faces; see `Constriction_query` for many
///        locations
///
/// \sa `Constriction_query`
/// \sa `detect_constrictions()`
/// \sa `Local_cut_locus_seeds`
/// \sa `Local_boundary_seeds`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class Point, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator detect_constrictions_near(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                         const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Detection_near_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::detect_constrictions_near_checked<ConcurrencyTag>(tm, location, out, np);
  else
    return out;
}

namespace internal {

template <class ConcurrencyTag, class TriangleMesh, class Point, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_near_checked(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                                 const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
  const auto policies = policies_asked_for(np);
  static_assert(std::tuple_size<std::decay_t<decltype(policies)>>::value == 1,
                "near a location, give one of the simplification policies");

  Prepared_surface<TriangleMesh, std::decay_t<decltype(vpm)>> prepared(tm, vpm, vim);
  given_point(prepared.imported(), location);
  prepared.template simplify<ConcurrencyTag>(std::get<0>(policies), false, visitor, append_collapses);
  if(!choose_parameter(get_parameter(np, internal_np::prove_prominence), false))
    return write_constrictions_near<ConcurrencyTag>(prepared, location, out, np);
  std::vector<Constriction<TriangleMesh>> found;
  write_constrictions_near<ConcurrencyTag>(prepared, location, std::back_inserter(found), np);
  return bound_prominences_checked(tm, found, out, np);
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H
