// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CONNECT_TRIANGLES_H
#define CONSTRICTIONS_CONNECT_TRIANGLES_H

#include "input/mesh_findings.h"
#include "input/polygon_soup.h"

#include <cstddef>
#include <vector>

namespace constrictions {

/// Triangles of which each is a face of the file or a piece of one.
struct Triangles
{
  std::vector<Index> corners;
  std::vector<Index> face;     ///< of each triangle, in the file
  std::vector<bool> is_turned; ///< filled by `connect_triangles()`
  std::vector<Index> opposite; ///< filled by `connect_triangles()`: by side, the one joined to it, or `null_index`

  std::size_t size() const { return face.size(); }
};

/// leaves out triangles, turns them round and joins them in pairs: the last steps of `repair_soup()`, but for splitting
/// vertices.
///
/// Throws `Invalid_input` for what cannot be oriented.
void connect_triangles(const std::vector<Point>& points, Triangles& triangles, Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_CONNECT_TRIANGLES_H
