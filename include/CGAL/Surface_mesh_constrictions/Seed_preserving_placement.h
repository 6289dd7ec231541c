// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_PRESERVING_PLACEMENT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_PRESERVING_PLACEMENT_H

#include <CGAL/Surface_mesh_constrictions/internal/simplify/non_face_triangles.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Placement that forbids the collapse of the edges of seed curves, by giving no position for them (Section 4.4 of the
/// paper), and calls another placement for all other edges.
///
/// The edges of seeds are recognised by their non-face triangle, not by a mark: a mark would be lost when the edge
/// merges with a neighbour, while the triangle lives on with the merged vertex.
///
/// \cgalModels{GetPlacement}
///
/// \tparam BasePlacement a model of `GetPlacement`
template <class BasePlacement>
class Seed_preserving_placement : private BasePlacement
{
public:
  /// \param base the placement that is called for all other edges
  explicit Seed_preserving_placement(const BasePlacement& base = BasePlacement()) : BasePlacement(base) {}

  /// none for an edge of a non-face triangle, otherwise what the base placement says.
  /// \cost quadratic in the degree of the edge's ends, and that of the base placement
  template <class Profile>
  auto operator()(const Profile& profile) const
  {
    typedef decltype(static_cast<const BasePlacement&>(*this)(profile)) Optional_point;
    return internal::is_on_non_face_triangle(profile) ? Optional_point()
                                                      : static_cast<const BasePlacement&>(*this)(profile);
  }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_PRESERVING_PLACEMENT_H
