// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_FILE_H
#define CONSTRICTIONS_MESH_FILE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>

namespace constrictions {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

/// reads a closed triangle mesh from an OFF, OBJ, PLY or STL file, told apart by their content and, where that leaves
/// a doubt, by the extension. Vertices and faces have the numbers of the file, and the halfedge of a face starts at
/// its first corner. A vertex on no face keeps its number, but is marked as removed.
///
/// Throws `Input_file_error` for a file that cannot be read, and `Invalid_input` for a mesh that is not a closed,
/// oriented 2-manifold of triangles. Positions are not checked.
Mesh read_mesh_file(const std::string& name);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_FILE_H
