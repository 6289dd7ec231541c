// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CONNECT_TRIANGLES_H
#define CONSTRICTIONS_CONNECT_TRIANGLES_H

#include "input/mesh_findings.h"
#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <vector>

namespace constrictions {

/// Triangles of which each is a face of the file or a piece of one.
struct Triangles
{
  std::vector<Index> corners;
  std::vector<Index> face;     ///< of each triangle, in the file
  std::vector<bool> is_turned; ///< filled by `connect_triangles()`
  std::vector<Index> vertex;   ///< filled by `connect_triangles()`: by vertex, that of the file

  std::size_t size() const { return face.size(); }
};

/// the last four steps of `repair_soup()`: leaves out triangles, turns them round, splits edges and vertices. Copies of
/// vertices come behind the vertices of the file. At the border of the table `opposite` is `null_index`.
///
/// Throws `Invalid_input` for what cannot be oriented.
CGAL::Surface_mesh_constrictions::internal::Corner_table
connect_triangles(const std::vector<Point>& points, Triangles& triangles, Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_CONNECT_TRIANGLES_H
