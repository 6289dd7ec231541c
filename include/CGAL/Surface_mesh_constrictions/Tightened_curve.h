// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENED_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENED_CURVE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The result of tightening a loop.
template <class TriangleMesh>
struct Tightened_curve
{
  Tightening_verdict verdict;       ///< how it ended
  Constriction<TriangleMesh> curve; ///< empty unless the verdict is `CLOSED_GEODESIC`
  Certificate certificate;          ///< that of `curve`, or why there is none; not computed with `certify(false)`
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTENED_CURVE_H
