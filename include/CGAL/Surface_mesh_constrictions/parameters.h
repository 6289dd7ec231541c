// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/Parameter_chain.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// When a non-face triangle is noticed.
enum class Seed_detection
{
  ON_APPEARANCE,      ///< after the collapse that makes it
  ON_REFUSED_COLLAPSE ///< when the simplification refuses to collapse one of its edges
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// When a curve that is carried through the levels is tightened.
enum class Tightening_schedule
{
  EVERY_LEVEL,   ///< after every vertex split that touches it, and on the input
  AT_THE_END,    ///< on the input only; between its pivots it is straightened after every vertex split that touches it
  UNSTRAIGHTENED ///< carried as a path of edges as far as `carry_seed_curves()` tells, tightened there and on the input
};

} // namespace Surface_mesh_constrictions

// Starts a chain, `seed_detection(x).visitor(v)`, or is put in front of one, `seed_detection(x, visitor(v))`.
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(name)                                                                \
  template <class T>                                                                                                   \
  Surface_mesh_constrictions::internal::Parameter_chain<T, internal_np::name##_t> name(const T& value)                 \
  {                                                                                                                    \
    return {value};                                                                                                    \
  }                                                                                                                    \
  template <class T, class K, class Tag, class Base>                                                                   \
  Surface_mesh_constrictions::internal::Parameter_chain<T, internal_np::name##_t,                                      \
                                                        Named_function_parameters<K, Tag, Base>>                       \
  name(const T& value, const Named_function_parameters<K, Tag, Base>& np)                                              \
  {                                                                                                                    \
    return {value, np};                                                                                                \
  }

/// Named parameters: CGAL's own, and those of this package.
namespace parameters {

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Asks for non-face triangles as the only seed curves, as in the paper, and says when they are noticed.
/// Type: `Seed_detection`. Default: unset; seeds are those of `seed_sources`.
/// Accepted by `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_detection)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Where seed curves come from. Type: a model of `ConstrictionSeedSource`. Default: `Default_seed_sources`, or
/// `Non_face_triangle_seeds` with `first_constriction_only`.
/// Accepted by `detect_constrictions()` and `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_sources)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Cost and placement of edge collapses. Type: a model of `ConstrictionSimplificationPolicies`, or a `std::tuple` of
/// several: then the mesh is simplified with each of them. Default: `Garland_heckbert_policies`.
/// Accepted by `detect_constrictions()`, `detect_constrictions_near()` and `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(simplification_policies)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How curves are carried to the input and where they are tightened. Type: `Tightening_schedule`.
/// Default: `Tightening_schedule::UNSTRAIGHTENED`, or `Tightening_schedule::AT_THE_END` if `seed_detection` is given.
/// Accepted by `detect_constrictions()` and `detect_constrictions_near()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tightening_schedule)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to stop at the first seed curve, and follow that one only. Type: `bool`. Default: `false`.
/// Accepted by `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(first_constriction_only)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether each curve is certified with exact arithmetic, and corrected where rounding has led it astray.
/// Type: `bool`. Default: `true`.
/// Accepted by `detect_constrictions()`, `detect_constrictions_near()`, `tighten_closed_curves()` and
/// `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(certify)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to leave out curves that are neither proved to be constrictions nor proved not to be, because a sign stayed
/// open; their `Certificate` says which sign. Type: `bool`. Default: `false`.
/// Accepted by `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(certified_only)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The least prominence of a constriction that is selected, or that cuts. Type: `double`.
/// Default: 0.05 where constrictions are selected, 0 near a location; where curves cut, unset: all cut.
/// Accepted by all functions that detect or select constrictions, `segment_by_constrictions()` and
/// `split_along_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_prominence)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The least isolation of a constriction among those selected, see `Constriction::isolation()`. Type:
/// `double`. Default: 0.15, and 0 near a location.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_isolation)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The greatest ratio \f$L^2/(4 \pi A)\f$ of a separating constriction that is selected. Type: `double`.
/// Default: 0.25.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_isoperimetric_ratio)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The least length, in the unit of the mesh's coordinates. Constrictions are selected first; shorter ones are then
/// left out, see `select_by_prominence()`. Type: `double`. Default: 0.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_curve_length)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The greatest length, in the unit of the mesh's coordinates. Constrictions are selected first; longer ones are then
/// left out, see `select_by_prominence()`. Type: `double`. Default: no limit.
/// Accepted by all functions that detect or select constrictions, `cut_handles()` and `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_curve_length)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many constrictions are selected at most, those that rank highest; near a location the nearest ones.
/// Type: `std::size_t`. Default: no limit.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many geodesic loops are written at most, the shortest ones. Type: `std::size_t`. Default: 1.
/// Accepted by `geodesic_loops_at_location()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_loops)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The least angle of a geodesic loop at its location, in radians, on the side where it is smaller.
/// Type: `double`. Default: a quarter of pi. Accepted by `geodesic_loops_at_location()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_loop_angle)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select also constrictions that cross a more prominent one, there and back, have a rival, or are composed
/// of shorter ones. Type: `bool`. Default: `false`.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(crossing_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select every distinct closed geodesic that was found. Type: `bool`. Default: `false`.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(all_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select also rims, see `Constriction::is_rim()`, whatever their prominence and isoperimetric ratio.
/// Type: `bool`. Default: `false`.
/// Accepted by all functions that detect or select constrictions.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(rim_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether prominences are measured; if not, all curves are selected. Type: `bool`. Default: `true`.
/// Accepted by `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(measure_prominence)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether the prominences of the constrictions that are selected are bounded from below, too, as `bound_prominences()`
/// does. Type: `bool`. Default: `false`.
/// Accepted by `detect_constrictions()` and `detect_constrictions_near()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(prove_prominence)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many parts a surface is cut into at most. Type: `std::size_t`. Default: unset, all curves cut.
/// Accepted by `segment_by_constrictions()` and `split_along_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_parts)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Only curves that choke this side cut. Type: `Side`. Default: unset, all curves cut.
/// Accepted by `segment_by_constrictions()`, `split_along_constrictions()`, `cut_handles()` and `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(choked_side)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The genus at which the removal of handles stops. Type: `std::size_t`. Default: 0.
/// Accepted by `remove_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(target_genus)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many handles are removed at most. Type: `std::size_t`. Default: no limit.
/// Accepted by `remove_handles()` and `cut_handles()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_handles)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether the holes along which parts have been cut off are filled. Type: `bool`. Default: `true`.
/// Accepted by `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(with_caps)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether the other holes of the parts are filled, too: holes of the mesh, and holes that run partly along one of
/// these. Type: `bool`. Default: `false`. Accepted by `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(with_filled_holes)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Takes a `Part_cap` for each cap that closes a part. Type: a model of `OutputIterator`. Default: unset.
/// Accepted by `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(cap_output_iterator)

} // namespace parameters

#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER

namespace Surface_mesh_constrictions {

namespace parameters = CGAL::parameters; // the package's parameters are beside CGAL's, under either name

} // namespace Surface_mesh_constrictions

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H
