// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_CURVE_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Index of a vertex, halfedge or face of a `Progressive_mesh`; it means the same element at every level.
typedef std::uint32_t Index;

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The index of no element.
constexpr Index null_index = 0xffffffffu;

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Where a seed curve comes from.
enum class Seed_origin
{
  NON_FACE_TRIANGLE, ///< three edges of a simplified surface that bound no face
  CUT_LOCUS,         ///< a loop through the cut locus of a vertex of a simplified surface
  SECTION,           ///< a piece of a level set of a function on a simplified surface
  BARRIER,           ///< a curve that a longer constriction becomes behind its lowest barrier
  USER,              ///< a loop given by the user
  BOUNDARY           ///< the boundary of a hole
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A closed path of edges of the simplified surface T^level that starts the search for a constriction.
struct Seed_curve
{
  std::size_t level;           ///< number of edge collapses after which the path exists
  std::vector<Index> vertices; ///< its vertices in cyclic order, the first not repeated
  Seed_origin origin;          ///< the kind of its source
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_CURVE_H
