// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The copy of the input that is simplified, whatever the type of the input. Cost and placement policies passed to
/// `detect_constrictions()` are called with edge profiles of this mesh: models of CGAL's `EdgeProfile`, of a type of
/// this package's own, so that their `operator()` has to be a template like that of CGAL's policies. What a profile
/// tells is looked up when it is asked for: after the collapse only the vertices are what they were.
typedef CGAL::Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3> Simplification_mesh;

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H
