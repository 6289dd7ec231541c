// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_FILE_NUMBERING_H
#define CONSTRICTIONS_FILE_NUMBERING_H

#include "input/polygon_soup.h"

#include <cstddef>
#include <vector>

namespace constrictions {

/// How the vertices and triangles of a mesh are called in its file. A vector that is empty stands for the same numbers
/// on both sides.
struct File_numbering
{
  std::size_t vertices = 0, faces = 0; ///< of the file
  std::vector<Index> face;             ///< by triangle, the face of the file that it is, or is a piece of
  std::vector<Index> vertex;           ///< by vertex, that of the file
  std::vector<Index> stand_in;         ///< by vertex of the file, the vertex that it has been merged into, or itself
  std::vector<bool> is_piece;          ///< by triangle, whether the face of the file has more than three corners
  std::vector<bool> is_turned;         ///< by triangle, whether it was turned round: its corners are 0, 2, 1
  std::vector<Index> nearby;           ///< by face of the file, a triangle of it, or, of one left out, one beside it

  Index face_of(std::size_t triangle) const { return face.empty() ? static_cast<Index>(triangle) : face[triangle]; }
  Index vertex_of(std::size_t v) const { return vertex.empty() ? static_cast<Index>(v) : vertex[v]; }
  Index stand_in_of(std::size_t v) const { return stand_in.empty() ? static_cast<Index>(v) : stand_in[v]; }
  bool is_piece_of_polygon(std::size_t triangle) const { return !is_piece.empty() && is_piece[triangle]; }
  bool is_turned_round(std::size_t triangle) const { return !is_turned.empty() && is_turned[triangle]; }

  /// a triangle of a face of the file, or one beside it; `null_index` if there is none
  Index triangle_at(std::size_t face_of_file) const
  {
    return face.empty() ? static_cast<Index>(face_of_file) : nearby[face_of_file];
  }
};

} // namespace constrictions

#endif // CONSTRICTIONS_FILE_NUMBERING_H
