// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_SPLIT_VERTICES_H
#define CONSTRICTIONS_SPLIT_VERTICES_H

#include "input/connect_triangles.h"
#include "input/mesh_findings.h"
#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <cstddef>
#include <vector>

namespace constrictions {

/// A triangle mesh whose vertices have one fan of triangles each.
struct Split_mesh
{
  CGAL::Surface_mesh_constrictions::internal::Corner_table table; ///< at the border `opposite` is `null_index`
  std::vector<Index> vertex;                                      ///< by vertex, the one that it is or is a copy of
};

/// gives each fan of triangles a vertex of its own. The first fan of a vertex keeps it, copies come behind all others.
/// Tells of the triangles turned round, and of the edges and vertices that have become several.
Split_mesh split_vertices(std::size_t number_of_vertices, const Triangles& triangles, Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_SPLIT_VERTICES_H
