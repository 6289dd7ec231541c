// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_GRAPH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_GRAPH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The vertices and edges of one level of a progressive mesh, without ghosts, numbered without gaps in ascending order
// of their ids, so that repeated work on a coarse level does not depend on the size of the input.
class Edge_graph
{
public:
  struct Neighbour
  {
    Index vertex;
    double length;
  };

  struct Edge
  {
    std::array<Index, 2> ends;
    std::array<Index, 2> apexes; // the third vertices of its two faces; null_index for a hole
    std::array<Index, 4> around; // the other edges of its two faces; null_index for a hole
    double length;
  };

  // O(size of T^0) for the ids, and linear in the size of the current surface.
  explicit Edge_graph(const Progressive_mesh& pm)
  {
    std::vector<Index> number(pm.number_of_vertex_ids(), null_index);
    for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
      if(pm.is_vertex(v) && !pm.is_ghost_vertex(v))
      {
        number[v] = static_cast<Index>(m_vertices.size());
        m_vertices.push_back(v);
      }

    std::vector<Index> edges; // the halfedge that stands for it
    m_begin.push_back(0);
    for(Index v : m_vertices)
    {
      const Index begin = pm.outgoing(v);
      Index h = begin;
      do
      {
        if(pm.is_ghost_vertex(pm.target(h)))
        {
          h = pm.ccw(h);
          continue;
        }
        m_neighbours.push_back({number[pm.target(h)], norm(vector(pm.point(v), pm.point(pm.target(h))))});
        if(pm.edge(h) == h)
        {
          edges.push_back(h);
          const Index left = pm.source(pm.prev(h)), right = pm.source(pm.prev(pm.opposite(h)));
          m_edges.push_back({{{number[v], m_neighbours.back().vertex}},
                             {{number[left], number[right]}},
                             {},
                             m_neighbours.back().length});
        }
        h = pm.ccw(h);
      } while(h != begin);
      m_begin.push_back(m_neighbours.size());
    }

    std::vector<Index> number_of_edge(pm.number_of_halfedge_ids(), null_index);
    for(Index e = 0; e < edges.size(); ++e)
      number_of_edge[edges[e]] = e;
    for(Index e = 0; e < edges.size(); ++e)
    {
      const Index h = edges[e], o = pm.opposite(h);
      const std::array<Index, 4> around = {{pm.next(h), pm.prev(h), pm.next(o), pm.prev(o)}};
      for(std::size_t i = 0; i < 4; ++i)
        m_edges[e].around[i] = number_of_edge[pm.edge(around[i])];
    }
  }

  std::size_t number_of_vertices() const { return m_vertices.size(); }

  // The id of a vertex, and the other way round.
  Index id(Index vertex) const { return m_vertices[vertex]; }
  Index number(Index id) const
  {
    return static_cast<Index>(std::lower_bound(m_vertices.begin(), m_vertices.end(), id) - m_vertices.begin());
  }

  const std::vector<Edge>& edges() const { return m_edges; }

  const Neighbour* neighbours_begin(Index vertex) const { return m_neighbours.data() + m_begin[vertex]; }
  const Neighbour* neighbours_end(Index vertex) const { return m_neighbours.data() + m_begin[vertex + 1]; }

private:
  std::vector<Index> m_vertices;    // their ids
  std::vector<std::size_t> m_begin; // of the neighbours of each vertex
  std::vector<Neighbour> m_neighbours;
  std::vector<Edge> m_edges;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_EDGE_GRAPH_H
