// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_AS_TEXT_H
#define CONSTRICTIONS_MESH_AS_TEXT_H

#include "input/mesh_file.h"

#include <string>

namespace constrictions {

/// whether `mesh_as_text()` knows the format that the extension of a file name stands for: OFF, OBJ or PLY
bool is_text_format(const std::string& file_name);

/// a mesh in the format that the extension of the file name stands for, with all digits of its coordinates. Vertices
/// keep their numbers, those on no face too.
std::string mesh_as_text(const Mesh& mesh, const std::string& file_name);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_AS_TEXT_H
