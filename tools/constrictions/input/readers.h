// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_READERS_H
#define CONSTRICTIONS_READERS_H

#include "input/input_file.h"
#include "input/polygon_soup.h"

#include <string_view>

namespace constrictions {

/// \name Readers
/// One for each format. `read_mesh_file()` chooses among them. Each throws `Input_file_error` for a file that is not of
/// its format and `Invalid_input` for a face with a vertex that does not exist.
/// @{
Polygon_soup read_off(const Input_file& file);
Polygon_soup read_obj(const Input_file& file);
Polygon_soup read_ply(const Input_file& file);

/// PolyData, or the surfaces of an unstructured grid, as text or in binary. Faces are the polygons, then the triangles of
/// strips.
Polygon_soup read_vtk(const Input_file& file);

/// PolyData in VTK's XML format: numbers as text, in base64, or appended, also compressed by zlib. Of each piece the
/// polygons come first, then the triangles of strips. Points of pieces are not shared.
Polygon_soup read_vtp(const Input_file& file);

/// The meshes of the nodes of the scene, each where its node puts it, in the order of the nodes. Of a mesh in two nodes
/// there are two copies. Points are moved in doubles.
Polygon_soup read_glb(const Input_file& file);

/// The objects that are to be built, each where the build puts it, in that order; those made of components likewise.
/// Points are moved in doubles. Coordinates are in the unit of the model with the build; those of a model in another file
/// of the archive are scaled if its unit is another one.
Polygon_soup read_3mf(const Input_file& file);

/// Corners with the same coordinates are one vertex; vertices are numbered as they appear.
Polygon_soup read_ascii_stl(const Input_file& file);
Polygon_soup read_binary_stl(const Input_file& file);
/// @}

/// whether an OFF file can begin with this word: "OFF", with prefixes, in any case
bool is_off_keyword(std::string_view word);

} // namespace constrictions

#endif // CONSTRICTIONS_READERS_H
