// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SURFACE_PART_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SURFACE_PART_H

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A part of a surface that has been cut along closed curves: a connected component of the rest.
struct Surface_part
{
  /// in the squared unit of the mesh's coordinates; of crossed faces only the pieces in the part count
  double area;

  /// in the cubed unit of the mesh's coordinates. Positive if the normals point out of the enclosed region, negative if
  /// the part encloses a region outside of the solid, as the wall of a pocket does. Each boundary curve is closed by
  /// the cone from the curve to its centre of mass; curves that touch each other have a common apex. The cones on the
  /// two sides of a curve cancel, so that the volumes of the parts add up.
  double volume;

  std::size_t genus;                ///< after its boundary curves have been closed by discs
  std::size_t number_of_boundaries; ///< boundary curves, each counted on each side where the part lies
  std::size_t number_of_faces;      ///< faces that have been given the id of the part
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Two parts on the two sides of a curve; they may be the same part.
struct Part_adjacency
{
  std::size_t curve; ///< the place of the curve in the input; of several that share the stretch, the first used
  std::array<std::size_t, 2> parts; ///< on the left and on the right of the curve
  double length;                    ///< of the curve, or of that stretch of it along which these two parts meet
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Whether a curve has cut a surface, and if not, why.
struct Cut_outcome
{
  /// no curve
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  bool is_used;              ///< whether the surface was cut along it
  std::size_t crossed_curve; ///< the used curve that it crosses, or itself; none if it was used or not chosen
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A curve that cuts a surface, and from which number of parts on.
struct Nested_cut
{
  std::size_t curve;           ///< the place of the curve in the input
  std::size_t number_of_parts; ///< the least `maximum_number_of_parts` with which the curve cuts
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The parts of a surface, which of them meet at which curve, and which curves have cut.
struct Surface_parts
{
  std::vector<Surface_part> parts;         ///< numbered as in the face patch map
  std::vector<Part_adjacency> adjacencies; ///< sorted by curve
  std::vector<Cut_outcome> outcomes;       ///< one for each curve of the input

  /// the curves that cut if the number of parts is not limited, in the order in which they do, by ascending number of
  /// parts. It does not depend on `maximum_number_of_parts`. See `nested_parts()`.
  std::vector<Nested_cut> nested_cuts;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SURFACE_PART_H
