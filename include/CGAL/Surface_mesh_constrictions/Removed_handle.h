// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVED_HANDLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVED_HANDLE_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A cut along a curve, closed by two caps, with which the genus of a surface has fallen by one.
///
/// \tparam Point the type of the points of the mesh
template <class Point>
struct Removed_handle
{
  std::size_t round; ///< of the search: how often the surface had been searched before the one that found the curve
  std::size_t curve; ///< the place of the curve among those found in its round, or in the input of `cut_handles()`
  std::vector<Point> points; ///< of the curve: closed, the first not repeated
  double length;             ///< of the curve
  Side
      side; ///< that it chokes: the object, when a handle has been cut off, or the complement, when a tunnel was filled

  Certificate certificate; ///< what exact arithmetic has proved of the curve

  /// the areas of the caps on the left and on the right of the curve, in the squared unit of the mesh's coordinates
  std::array<double, 2> cap_areas;

  /// the volume that the surface encloses more than before, in the cubed unit of the mesh's coordinates; negative where
  /// something of the solid has been cut away
  double volume_change;

  /// of each cap, on the left and on the right, whether one of its triangles meets another triangle of the surface in
  /// more than common vertices and edges
  std::array<bool, 2> caps_intersect;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVED_HANDLE_H
