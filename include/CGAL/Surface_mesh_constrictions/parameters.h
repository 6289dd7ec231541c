// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H

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
  UNSTRAIGHTENED ///< carried as a path of edges as far as `carry_seed_curves()` tells, and tightened there and on the input
};

} // namespace Surface_mesh_constrictions

namespace internal_np {

enum seed_detection_t { seed_detection };
enum tightening_schedule_t { tightening_schedule };
enum seed_sources_t { seed_sources };
enum simplification_policies_t { simplification_policies };
enum first_constriction_only_t { first_constriction_only };
enum certify_t { certify };
enum minimum_prominence_t { minimum_prominence };
enum maximum_isoperimetric_ratio_t { maximum_isoperimetric_ratio };
enum maximum_number_of_constrictions_t { maximum_number_of_constrictions };
enum crossing_constrictions_t { crossing_constrictions };
enum all_constrictions_t { all_constrictions };
enum maximum_number_of_parts_t { maximum_number_of_parts };
enum choked_side_t { choked_side };
enum with_caps_t { with_caps };

} // namespace internal_np

// Each of the package's own parameters starts a chain, `seed_detection(x).visitor(v)`, or is put in front of one,
// `seed_detection(x, CGAL::parameters::visitor(v))`: CGAL's list of names that can be chained is closed.
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(name)                                                              \
  template <class T>                                                                                                 \
  Named_function_parameters<T, internal_np::name##_t> name(const T& value)                                           \
  {                                                                                                                  \
    return Named_function_parameters<T, internal_np::name##_t>(value);                                               \
  }                                                                                                                  \
  template <class T, class K, class Tag, class Base>                                                                 \
  Named_function_parameters<T, internal_np::name##_t, Named_function_parameters<K, Tag, Base> > name(                \
      const T& value, const Named_function_parameters<K, Tag, Base>& np)                                             \
  {                                                                                                                  \
    return Named_function_parameters<T, internal_np::name##_t, Named_function_parameters<K, Tag, Base> >(value, np); \
  }

namespace Surface_mesh_constrictions {
namespace parameters {

CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_detection)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(seed_sources)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(simplification_policies)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(tightening_schedule)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(first_constriction_only)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(certify)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(minimum_prominence)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_isoperimetric_ratio)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_constrictions)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(crossing_constrictions)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(all_constrictions)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(maximum_number_of_parts)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(choked_side)
CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER(with_caps)

} // namespace parameters
} // namespace Surface_mesh_constrictions

#undef CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETER

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PARAMETERS_H
