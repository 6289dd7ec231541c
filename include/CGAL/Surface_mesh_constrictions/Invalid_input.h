// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_INPUT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_INPUT_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What keeps a mesh, or a loop or a location on it, from being used.
enum class Input_defect
{
  EMPTY_MESH,               ///< no face
  TOO_LARGE,                ///< more elements than 32-bit indices can name
  NOT_TRIANGULAR,           ///< a face with other than three vertices
  INVALID_VERTEX_INDEX,     ///< a face, or a loop, names a vertex that does not exist
  NON_FINITE_COORDINATE,    ///< a coordinate that is NaN or infinite
  ZERO_LENGTH_EDGE,         ///< a face with two vertices at the same position, or the same vertex twice
  NON_MANIFOLD_EDGE,        ///< an edge with more than two faces, or two edges with the same ends
  INCONSISTENT_ORIENTATION, ///< two faces that run along their common edge in the same direction
  NOT_CLOSED,               ///< an edge with one face only, where the surface has to be closed
  NON_MANIFOLD_VERTEX,      ///< a vertex with more than one fan of faces
  INVALID_LOOP,             ///< a loop that is not a closed path of mesh edges
  IRRATIONAL_COORDINATE,    ///< a coordinate of an exact kernel that is not a rational number of moderate size
  INVALID_LOCATION          ///< a location that is not on the mesh
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Exception of every function of this package that is given a mesh, a loop or a location that it cannot use. The
/// message is one line that names the defect and its place.
class Invalid_input : public std::invalid_argument
{
public:
  /// \param defect the kind of defect
  /// \param element the index of the offending face, vertex or loop, in the order of the input
  /// \param message one line that names the defect and the place
  Invalid_input(Input_defect defect, std::size_t element, const std::string& message)
    : std::invalid_argument(message), m_defect(defect), m_element(element)
  {}

  /// what is wrong
  Input_defect defect() const noexcept { return m_defect; }

  /// the index of the offending element (0 for defects of the whole mesh)
  std::size_t element() const noexcept { return m_element; }

private:
  Input_defect m_defect;
  std::size_t m_element;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_INPUT_H
