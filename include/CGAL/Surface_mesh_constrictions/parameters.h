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

/// Named parameters: CGAL's, and those that it does not have.
namespace parameters {

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Asks for non-face triangles as the only seed curves, as in the paper, and says when they are noticed.
/// Type: `Seed_detection`. Default: unset; seeds are those of `seed_sources`.
/// Of `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_detection)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Where seed curves come from. Type: a model of `ConstrictionSeedSource`. Default: `Default_seed_sources`, or
/// `Non_face_triangle_seeds` with `first_constriction_only`.
/// Of `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_sources)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Cost and placement of edge collapses. Type: a model of `ConstrictionSimplificationPolicies`, or a `std::tuple` of
/// several: then the mesh is simplified with each of them. Default: `Garland_heckbert_policies`.
/// Of `detect_constrictions()` and `detect_constrictions_near()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(simplification_policies)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How curves are carried to the input and where they are tightened. Type: `Tightening_schedule`.
/// Default: `Tightening_schedule::UNSTRAIGHTENED`, or `Tightening_schedule::AT_THE_END` if `seed_detection` is given.
/// Of `detect_constrictions()` and `detect_constrictions_near()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tightening_schedule)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to stop at the first seed curve, and follow that one only. Type: `bool`. Default: `false`.
/// Of `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(first_constriction_only)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether each curve is certified with exact arithmetic, and corrected where rounding has led it astray.
/// Type: `bool`. Default: `true`.
/// Of `detect_constrictions()`, `detect_constrictions_near()` and `tighten_closed_curves()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(certify)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to leave out curves of which a sign stayed open, so that neither is proved: that they are constrictions, or
/// that they are not. Their `Certificate` says which. Type: `bool`. Default: `false`.
/// Of `detect_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(certified_only)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The prominence that a constriction has at least, to be selected or to cut. Type: `double`.
/// Default: 0.05 where constrictions are selected, 0 near a location; where curves cut, unset: all cut.
/// Of the detections, the selections, `segment_by_constrictions()` and `split_along_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_prominence)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The isolation that a constriction has at least among those selected, see `Constriction::isolation()`. Type:
/// `double`. Default: 0.15, and 0 near a location. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_isolation)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The ratio \f$L^2/(4 \pi A)\f$ that a separating constriction has at most, to be selected. Type: `double`.
/// Default: 0.25. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_isoperimetric_ratio)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The length that a constriction has at least, to be written: of those that are selected shorter ones are left out,
/// see `select_by_prominence()`. Type: `double`. Default: 0. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_curve_length)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The length that a constriction has at most, to be written: of those that are selected longer ones are left out,
/// see `select_by_prominence()`. Type: `double`. Default: no limit. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_curve_length)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many constrictions are selected at most, those that rank highest; near a location the nearest ones.
/// Type: `std::size_t`. Default: no limit. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many geodesic loops are written at most, the shortest ones. Type: `std::size_t`. Default: 1.
/// Of `geodesic_loops_at_location()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_loops)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// The angle that a geodesic loop has at least, in radians, on the side of its location where it is smaller.
/// Type: `double`. Default: 0. Of `geodesic_loops_at_location()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_loop_angle)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select also constrictions that cross a more prominent one, there and back, have a rival, or are composed
/// of shorter ones. Type: `bool`. Default: `false`. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(crossing_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select every distinct closed geodesic that was found. Type: `bool`. Default: `false`.
/// Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(all_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether to select also rims, see `Constriction::is_rim()`, whatever their prominence and isoperimetric ratio.
/// Type: `bool`. Default: `false`. Of the detections and the selections.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(rim_constrictions)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// How many parts a surface is cut into at most. Type: `std::size_t`. Default: unset, all curves cut.
/// Of `segment_by_constrictions()` and `split_along_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_parts)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// What a curve chokes, to cut. Type: `Side`. Default: unset, all curves cut.
/// Of `segment_by_constrictions()` and `split_along_constrictions()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(choked_side)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether the holes along which parts have been cut off are filled. Type: `bool`. Default: `true`. Of
/// `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(with_caps)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Whether the other holes of the parts are filled, too: those that the mesh has, and those that run partly along one.
/// Type: `bool`. Default: `false`. Of `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(with_filled_holes)

/// \ingroup PkgSurfaceMeshConstrictionsNamedParameters
/// Takes a `Part_cap` for each cap that closes a part. Type: a model of `OutputIterator`. Default: unset.
/// Of `extract_parts()`.
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(cap_output_iterator)

} // namespace parameters

#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER

namespace Surface_mesh_constrictions {

namespace parameters = CGAL::parameters; // the package's parameters are beside CGAL's, under either name

} // namespace Surface_mesh_constrictions

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H
