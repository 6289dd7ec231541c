// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LANDMARKS_FILE_H
#define CONSTRICTIONS_LANDMARKS_FILE_H

#include "input/mesh_file.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// A place that the user has named.
struct Landmark
{
  std::string name; ///< may be empty
  std::array<double, 3> location;
};

/// reads places from a file of comma-separated values: a line each, with the coordinates `x,y,z`, or a name before
/// them. The first line may have the names of the columns. Empty lines and lines that start with # are skipped.
///
/// Throws `Input_file_error`, with the number of the line, for anything else, and if there is no place.
std::vector<Landmark> read_landmarks_file(const std::string& name);

/// The places that loops lead through, and where the loops stand in their file.
struct Place_loops
{
  std::vector<std::vector<Mesh::Point>> places;
  std::vector<std::size_t> lines; ///< counted from 1
};

/// reads loops through places, one a line, separated by blanks: each place is the number of a vertex of the file of
/// `mesh`, counted from 0, or a point `x,y,z`. Empty lines and lines that start with # are skipped.
///
/// Throws `Input_file_error`, with the number of the line, for anything else.
Place_loops read_places_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering);

} // namespace constrictions

#endif // CONSTRICTIONS_LANDMARKS_FILE_H
