// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLE_STOP_PREDICATE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLE_STOP_PREDICATE_H

#include <CGAL/Surface_mesh_constrictions/internal/simplify/non_face_triangles.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Stop predicate that ends a simplification at the first edge selected for collapse that lies on a *non-face
/// triangle*: three edges of the surface that bound no face (Section 4.1 of the paper). Its collapse would change the
/// topology of the surface.
///
/// \cgalModels{StopPredicate}
class Non_face_triangle_stop_predicate
{
public:
  /// whether `profile`'s edge lies on a non-face triangle.
  /// \cost quadratic in the degree of the edge's ends
  template <class FT, class Profile, class Size>
  bool operator()(const FT&, const Profile& profile, Size, Size) const
  {
    return internal::is_on_non_face_triangle(profile);
  }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLE_STOP_PREDICATE_H
