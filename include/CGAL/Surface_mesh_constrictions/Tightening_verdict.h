// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENING_VERDICT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENING_VERDICT_H

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What a closed curve becomes when it is tightened.
enum class Tightening_verdict
{
  CLOSED_GEODESIC, ///< a simple closed geodesic that no flat band leaks away
  DEGENERATE,      ///< a point
  NOT_SIMPLE,      ///< a closed geodesic that crosses or touches itself
  NOT_CERTIFIED    ///< a curve that could not be proved to be a constriction
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENING_VERDICT_H
