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

/// Corners with the same coordinates are one vertex; vertices are numbered as they appear.
Polygon_soup read_ascii_stl(const Input_file& file);
Polygon_soup read_binary_stl(const Input_file& file);
/// @}

/// whether an OFF file can begin with this word: "OFF", with prefixes, in any case
bool is_off_keyword(std::string_view word);

} // namespace constrictions

#endif // CONSTRICTIONS_READERS_H
