// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SHORTEST_PATH_VERIFICATION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SHORTEST_PATH_VERIFICATION_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Why an arc of a curve is not confirmed to be the shortest path between its ends.
enum class Arc_refusal
{
  NONE,         ///< it is confirmed
  NOT_A_PATH,   ///< the locations are not those of a closed curve on the mesh: no arc has been looked at
  SHORTER_PATH, ///< there is a path that is shorter by more than the tolerance
  OTHER_FACES,  ///< the shortest path passes other faces
  OTHER_PLACES, ///< the shortest path crosses the same edges elsewhere, by more than the tolerance
  NO_ANSWER     ///< no path was found; this happens where a face of the patch has no area
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What `verify_with_shortest_paths()` found.
struct Shortest_path_verification
{
  std::size_t number_of_arcs = 0;          ///< each has been looked at in a patch of its own
  std::size_t number_of_refused_arcs = 0;  ///< those that are not confirmed
  Arc_refusal refusal = Arc_refusal::NONE; ///< of the first refused arc; `NONE` if all are confirmed
  std::size_t refused_location = 0;        ///< in `locations()`, inside the first refused arc
  double greatest_excess = 0;              ///< of an arc over the shortest path, as a share of the arc's length
  double greatest_deviation = 0;           ///< between the two where they cross edges, relative to the patch's diameter

  /// whether every arc is confirmed
  bool is_confirmed() const { return refusal == Arc_refusal::NONE; }
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SHORTEST_PATH_VERIFICATION_H
