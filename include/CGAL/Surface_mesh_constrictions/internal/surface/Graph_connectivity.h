// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GRAPH_CONNECTIVITY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GRAPH_CONNECTIVITY_H

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The functions of a graph are found by the graph's own namespace, but not where members have the same names.
namespace graph {

template <class Halfedge, class Graph>
Halfedge next_halfedge(Halfedge h, const Graph& g)
{
  return next(h, g);
}

template <class Halfedge, class Graph>
Halfedge opposite_halfedge(Halfedge h, const Graph& g)
{
  return opposite(h, g);
}

template <class Halfedge, class Graph>
auto source_vertex(Halfedge h, const Graph& g)
{
  return source(h, g);
}

template <class Halfedge, class Graph>
auto target_vertex(Halfedge h, const Graph& g)
{
  return target(h, g);
}

template <class Halfedge, class Graph>
Halfedge prev_halfedge(Halfedge h, const Graph& g)
{
  return prev(h, g);
}

template <class Vertex, class Graph>
auto incoming_halfedge(Vertex v, const Graph& g)
{
  return halfedge(v, g);
}

} // namespace graph

// The connectivity of a user's mesh in the words of `Progressive_mesh`. The ghost of a hole is its border: one face with
// many edges, which is gone around vertices through, but never computed with.
template <class TriangleMesh>
class Graph_connectivity
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor Halfedge;

  explicit Graph_connectivity(const TriangleMesh& tm) : m_tm(tm) {}

  Halfedge next(Halfedge h) const { return graph::next_halfedge(h, m_tm); }
  Halfedge prev(Halfedge h) const { return graph::prev_halfedge(h, m_tm); }
  Halfedge opposite(Halfedge h) const { return graph::opposite_halfedge(h, m_tm); }
  Vertex source(Halfedge h) const { return graph::source_vertex(h, m_tm); }
  Vertex target(Halfedge h) const { return graph::target_vertex(h, m_tm); }
  Halfedge outgoing(Vertex v) const { return opposite(graph::incoming_halfedge(v, m_tm)); }

  // whether a halfedge lies in a hole
  bool is_ghost(Halfedge h) const { return CGAL::is_border(h, m_tm); }

  bool is_triangle(Halfedge h) const { return !is_ghost(h) && next(next(next(h))) == h; }

private:
  const TriangleMesh& m_tm;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_GRAPH_CONNECTIVITY_H
