// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_FILE_H
#define CONSTRICTIONS_MESH_FILE_H

#include "input/file_numbering.h"
#include "input/mesh_findings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

/// How a mesh file is taken.
struct Reading
{
  bool is_strict = false;      ///< refuse what would have to be repaired
  double merging_distance = 0; ///< merge vertices that are nearer to each other
};

/// What the program remembers of a mesh file.
struct File_record
{
  File_numbering numbering;
  Mesh_findings findings;
  std::string unit; ///< of the coordinates, as 3MF names it; empty if the format has none
};

/// reads a mesh from an OFF, OBJ, PLY, STL, VTK, VTP, GLB or 3MF file, which may be gzipped, or from the standard input if
/// the name is "-". The formats are told apart by the content and, where that leaves a doubt, by the extension.
/// Coordinates that the file has in single precision are taken as they are.
///
/// If the file holds a closed, oriented triangle mesh, vertices and faces have the numbers of the file, and the
/// halfedge of a face starts at its first corner. A vertex on no face keeps its number, but is marked as removed.
/// Anything else is made a triangle mesh as `repair_soup()` says, which may have holes, and `record` tells what was
/// done, and how its elements are called in the file.
///
/// Throws `Input_file_error` for a file that cannot be read or is a point cloud, and `Invalid_input` for what no mesh
/// can be made of: an index or position that cannot be used, no face, a surface that cannot be oriented, a border that
/// is mostly cracks. With `is_strict` it throws for all that is repaired, but for faces turned round and seams closed.
Mesh read_mesh_file(const std::string& name, const Reading& reading, File_record& record);

/// what a computation throws about a mesh that was read, with what is known of the mesh: of an open one how many holes
/// and border edges it has, and whether vertices near to each other make them
CGAL::Surface_mesh_constrictions::Invalid_input
with_hint(const CGAL::Surface_mesh_constrictions::Invalid_input& refusal, const File_record& record);

/// as above, with repairs, when nobody wants to know
Mesh read_mesh_file(const std::string& name);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_FILE_H
