// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_MESH_FROM_CORNER_TABLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_MESH_FROM_CORNER_TABLE_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Writes the mesh of a corner table into the empty mesh sm, a Simplification_mesh or a CGAL::Surface_mesh: vertices and
// faces keep their numbers, edges are numbered in the order in which the faces show them, and the halfedge of face f
// starts at the first corner of f. Isolated vertices keep their number too, but are marked as removed. The table may
// have a border, where `opposite` is null_index. Linear, and ten times as fast as add_face(), which has to search.
template <class Mesh, class PointRange>
void mesh_from_corner_table(const Corner_table& table, const PointRange& points, Mesh& sm)
{
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename Mesh::Face_index Face;

  const std::size_t nv = table.outgoing.size(), nh = table.halfedges.size();
  sm.reserve(static_cast<typename Mesh::size_type>(nv), static_cast<typename Mesh::size_type>(nh / 2),
             static_cast<typename Mesh::size_type>(nh / 3));
  for(const auto& p : points)
    sm.add_vertex(p);

  std::vector<Halfedge> halfedge(nh);
  for(Index h = 0; h < nh; ++h)
    if(h < table.halfedges[h].opposite)
    {
      halfedge[h] = sm.add_edge();
      if(table.halfedges[h].opposite != null_index)
        halfedge[table.halfedges[h].opposite] = sm.opposite(halfedge[h]);
    }
  for(Index f = 0; f < nh / 3; ++f)
  {
    const Face face = sm.add_face();
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      sm.set_target(halfedge[h], Vertex(table.halfedges[Corner_table::next(h)].source));
      sm.set_next(halfedge[h], halfedge[Corner_table::next(h)]);
      sm.set_face(halfedge[h], face);
    }
    sm.set_halfedge(face, halfedge[3 * f]);
  }

  for(Index h = 0; h < nh; ++h)
  {
    if(table.halfedges[h].opposite != null_index)
      continue;
    // the fan of faces at the source of h ends where a border halfedge starts again
    Index last = Corner_table::prev(h);
    while(table.halfedges[last].opposite != null_index)
      last = Corner_table::prev(table.halfedges[last].opposite);
    const Halfedge in = sm.opposite(halfedge[h]), out = sm.opposite(halfedge[last]);
    const Vertex v(table.halfedges[h].source);
    sm.set_target(in, v);
    sm.set_next(in, out);
    sm.set_halfedge(v, in);
  }
  for(std::size_t v = 0; v < nv; ++v)
  {
    const Index h = table.outgoing[v];
    const Vertex vertex(static_cast<Index>(v));
    if(h == null_index)
      sm.remove_vertex(vertex);
    else if(sm.halfedge(vertex) == Mesh::null_halfedge())
      sm.set_halfedge(vertex, halfedge[table.halfedges[h].opposite]);
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_MESH_FROM_CORNER_TABLE_H
