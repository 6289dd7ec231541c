// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CLEAN_FACES_H
#define CONSTRICTIONS_CLEAN_FACES_H

#include "input/mesh_findings.h"
#include "input/polygon_soup.h"

#include <cstddef>
#include <vector>

namespace constrictions {

/// The faces of a file that are left, and what became of its vertices.
struct Clean_faces
{
  std::vector<Index> corners;      ///< of one face after the other
  std::vector<std::size_t> begins; ///< the first corner of each face, and, at the end, the number of corners
  std::vector<Index> face;         ///< the number of each in the file
  std::vector<Index> stand_in;     ///< by vertex of the file, the vertex that it was merged into, or itself
  std::vector<Index> twin;         ///< by face of the file, the face that it was left out for, else `null_index`
  std::size_t border_edges = 0;    ///< edges with one face before seams were closed

  std::size_t size() const { return face.size(); }
  std::size_t degree(std::size_t i) const { return begins[i + 1] - begins[i]; }
};

/// merges vertices, collapses edges of length zero, and leaves out degenerate and duplicate faces: the first four steps
/// of `repair_soup()`. Coordinates must be finite.
///
/// \param closes_seams whether to merge the vertices of border edges that have the same ends in space
Clean_faces clean_faces(const Polygon_soup& soup, double merging_distance, bool closes_seams, Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_CLEAN_FACES_H
