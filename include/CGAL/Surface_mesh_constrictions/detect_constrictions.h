// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/bound_prominences.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/carry_seeds_to_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/constrictions_of_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curves_on_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/policies_asked_for.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/merge_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Detection_parameters
  : Selection_on_mesh_parameters::With<
        internal_np::visitor_t, internal_np::get_cost_policy_t, internal_np::get_placement_policy_t,
        internal_np::simplification_policies_t, internal_np::tightening_schedule_t, internal_np::certify_t,
        internal_np::certified_only_t, internal_np::seed_sources_t, internal_np::seed_detection_t,
        internal_np::first_constriction_only_t, internal_np::measure_prominence_t, internal_np::prove_prominence_t>
{};

// What `detect_constrictions()` does with arguments of the right kind.
template <class ConcurrencyTag, class TriangleMesh, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_checked(const TriangleMesh& tm, OutputIterator out, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds constrictions of a triangle mesh: simple closed curves on it whose length is locally minimal.
///
/// The function copies the mesh, simplifies the copy by edge collapses, and finds seed curves on the way. It undoes the
/// collapses one by one and carries the curves along. On the input mesh it tightens them until they are closed
/// geodesics, drops degenerate curves, merges equal ones, and certifies the others. Of these it selects those that a
/// person would call necks, each once: see `select_by_prominence()`. This is the method of \cgalCite{ha_dccps_03}. The
/// function is the composition of the package's stages; see the user manual.
///
/// The boundary of a mesh is an obstacle: curves may touch it, and run along it. See "Surfaces with Boundary" in the
/// user manual.
///
/// The same input gives the same output. `tm` is not changed.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components. Faces of area
///        zero and isolated vertices are allowed, edges of length zero are not.
/// \param out the selected constrictions, those that rank highest first: see `select_by_prominence()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point; coordinates that are not
///                    doubles are rounded to the nearest double for the search}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
///   \cgalParamNBegin{get_cost}
///     \cgalParamDescription{the cost of an edge collapse; give `get_placement` with it}
///     \cgalParamType{a model of `GetCost` for edge profiles of `Simplification_mesh`}
///     \cgalParamDefault{that of `simplification_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{get_placement}
///     \cgalParamDescription{the position of the vertex that an edge is collapsed to; give `get_cost` with it}
///     \cgalParamType{a model of `GetPlacement` for edge profiles of `Simplification_mesh`}
///     \cgalParamDefault{that of `simplification_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{simplification_policies}
///     \cgalParamDescription{the cost and the placement of edge collapses; if several are given, the mesh is simplified
///                           with each of them, and seeds of all are followed. Not together with `get_cost`.}
///     \cgalParamType{a model of `ConstrictionSimplificationPolicies`, or a `std::tuple` of several}
///     \cgalParamDefault{`Garland_heckbert_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{seed_sources}
///     \cgalParamDescription{where the seed curves come from}
///     \cgalParamType{a model of `ConstrictionSeedSource`; `Seed_sources` makes one of several}
///     \cgalParamDefault{`Default_seed_sources`, or `Non_face_triangle_seeds` with `first_constriction_only`}
///   \cgalParamNEnd
///   \cgalParamNBegin{seed_detection}
///     \cgalParamDescription{makes non-face triangles the only seed curves, as in the paper, and says when they are
///                           noticed; ignored if `seed_sources` is given}
///     \cgalParamType{`Seed_detection`}
///     \cgalParamDefault{unset}
///   \cgalParamNEnd
///   \cgalParamNBegin{tightening_schedule}
///     \cgalParamDescription{how curves are carried to the input and where they are tightened. With other schedules
///                           than `UNSTRAIGHTENED` the cost grows faster than the number of seeds.}
///     \cgalParamType{`Tightening_schedule`}
///     \cgalParamDefault{`Tightening_schedule::AT_THE_END` if `seed_detection` is given, else
///                       `Tightening_schedule::UNSTRAIGHTENED`}
///   \cgalParamNEnd
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether each curve is certified with exact arithmetic, and corrected where rounding has
///                           led it astray. A curve that is proved not to be a constriction is not returned.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{certified_only}
///     \cgalParamDescription{whether to leave out curves that are neither proved to be constrictions nor proved not to
///                           be, because a sign stayed open. Their certificates say which sign.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{first_constriction_only}
///     \cgalParamDescription{whether to stop at the first seed curve, and follow that one only. It may degenerate: then
///                           the output is empty.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the least prominence of a selected constriction}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.05}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_isolation}
///     \cgalParamDescription{the least isolation of a selected constriction, see `select_by_prominence()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.15}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_isoperimetric_ratio}
///     \cgalParamDescription{the greatest ratio \f$L^2/(4 \pi A)\f$ of a selected constriction that separates}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.25}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_curve_length}
///     \cgalParamDescription{the least length, in the unit of the mesh's coordinates: shorter constrictions are left
///                           out after the selection, see `select_by_prominence()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_curve_length}
///     \cgalParamDescription{the greatest length, as above}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_constrictions}
///     \cgalParamDescription{the greatest number of constrictions; those that rank highest are selected}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{crossing_constrictions}
///     \cgalParamDescription{whether to select also constrictions that cross selected ones or rivals of theirs, or that
///                           are composed of shorter ones: see `select_by_prominence()`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{rim_constrictions}
///     \cgalParamDescription{whether to select also rims, see `Constriction::is_rim()`, whatever their prominence and
///                           isoperimetric ratio}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{all_constrictions}
///     \cgalParamDescription{whether to select every distinct closed geodesic that was found. A user who keeps them all
///                           can select again at no cost: see `select_by_prominence()`.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{measure_prominence}
///     \cgalParamDescription{whether the prominences of the curves are measured. If not, the curves that the seeds lead
///                           to are written as with `all_constrictions`, in ascending order of their lengths, and
///                           prominence, isolation, `Constriction::dominated_by()`, `Constriction::crosses()` and what
///                           depends on them are unset: for a user who needs many short curves of a mesh with many
///                           handles, and no ranking}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{prove_prominence}
///     \cgalParamDescription{whether the prominences of the selected constrictions are bounded from below, too:
///                           `bound_prominences()`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told of the progress, and at the end how the seeds ended}
///     \cgalParamType{a model of `ConstrictionDetectionVisitor`; it is copied}
///     \cgalParamDefault{`Detection_visitor_base`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The parameters from `simplification_policies` to `all_constrictions` are the package's own: see
/// \ref PkgSurfaceMeshConstrictionsNamedParameters "Named Parameters".
///
/// \return the output iterator, past the last constriction
/// \throws Invalid_input for a mesh that cannot be used, and, with `certify`, for a coordinate that is not a rational
///         number of moderate size; it says what is wrong and where
/// \throws exceptions of the visitor; then nothing has been written
/// \cost The simplification is O(n log n) for n faces. Add that of the seed sources, and that of `carry_seed_curves()`,
///       or of `refine_seed_curves()` with another `tightening_schedule` than `UNSTRAIGHTENED`. Each curve that is left
///       on the input is linear in the lengths of the strips that it is led through, plus that of
///       `certify_constriction()` and `compute_prominences()`. Memory: O(n), plus the seed curves.
///
/// \sa `tighten_closed_curve()`
/// \sa `select_constrictions()`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator detect_constrictions(const TriangleMesh& tm, OutputIterator out,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Detection_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::detect_constrictions_checked<ConcurrencyTag>(tm, out, np);
  else
    return out;
}

namespace internal {

template <class ConcurrencyTag, class TriangleMesh, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_checked(const TriangleMesh& tm, OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
  const bool proves_prominence = choose_parameter(get_parameter(np, internal_np::prove_prominence), false);

  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();

  internal::Seeds_on_input carried;
  std::optional<Progressive_mesh> surface;
  std::apply(
      [&](const auto&... policies) {
        static_assert(sizeof...(policies) > 0, "simplification_policies is empty");
        std::size_t left = sizeof...(policies);
        (surface.emplace(
             internal::carry_seeds_to_input<ConcurrencyTag>(imported, --left == 0, policies, np, visitor, carried)),
         ...);
      },
      internal::policies_asked_for(np));
  const std::deque<internal::Measuring_level> levels = internal::measuring_levels(*surface);
  const Progressive_mesh& pm = *surface;
  const internal::Surface_sides sides(pm);
  Detection_statistics statistics;
  const std::vector<Constriction<TriangleMesh>> constrictions = internal::constrictions_of_seeds<ConcurrencyTag>(
      imported, pm, levels, sides, vpm, carried, np, visitor, statistics);
  if(!proves_prominence)
    return internal::write_selected(constrictions, out, np, visitor, statistics);
  std::vector<Constriction<TriangleMesh>> selected;
  internal::write_selected(constrictions, std::back_inserter(selected), np, visitor, statistics);
  internal::set_prominence_intervals(pm, internal::curves_on_copy(selected, imported, vim, pm), selected);
  return std::move(selected.begin(), selected.end(), out);
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H
