// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_FILE_H
#define CONSTRICTIONS_MESH_FILE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

/// reads a triangle mesh from an OFF, OBJ, PLY or STL file, told apart by their content and, where that leaves
/// a doubt, by the extension. Vertices and faces have the numbers of the file, and the halfedge of a face starts at
/// its first corner. A vertex on no face keeps its number, but is marked as removed. If the faces are not oriented
/// consistently, but can be, some are turned round. If the surface is open along seams of doubled vertices, the first of
/// the vertices at one position stands for all; other holes stay as they are.
///
/// Throws `Input_file_error` for a file that cannot be read, and `Invalid_input` for a mesh that is not an orientable
/// 2-manifold of triangles, with or without boundary, or has a position that is not finite or an edge of length zero.
Mesh read_mesh_file(const std::string& name);

/// as above. `is_turned` gets for each face whether it was turned round: its corners are then those of the file in the
/// order 0, 2, 1.
Mesh read_mesh_file(const std::string& name, std::vector<bool>& is_turned);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_FILE_H
