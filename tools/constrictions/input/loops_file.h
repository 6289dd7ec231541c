// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_LOOPS_FILE_H
#define CONSTRICTIONS_LOOPS_FILE_H

#include "input/mesh_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// Closed loops of vertices, and where they stand in their file.
struct Loops
{
  std::vector<std::vector<Mesh::Vertex_index>> vertices;
  std::vector<std::size_t> lines; ///< counted from 1
};

/// reads closed loops, one a line: numbers of vertices of the file of `mesh`, counted from 0 and separated by blanks,
/// the first not repeated. Empty lines and lines that start with # are skipped. Of the copies of a vertex that was
/// split those are taken that edges join, if there are such.
///
/// Throws `Input_file_error`, with the number of the line, for anything else. Whether the vertices are joined by edges
/// is not checked.
Loops read_loops_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering);

} // namespace constrictions

#endif // CONSTRICTIONS_LOOPS_FILE_H
