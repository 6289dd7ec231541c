// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_EDGE_PATHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_EDGE_PATHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Closed paths of edges of the current surface that are carried over vertex splits as paths of edges. Where the split
// vertex was, a path passes through one of the two new vertices, or through both, whichever is shortest. Nothing else
// moves, so a path stays where it was put, which a straightened curve would not.
class Edge_paths
{
public:
  explicit Edge_paths(Progressive_mesh& pm) : m_pm(pm), m_first_at(pm.number_of_vertex_ids(), null_index) {}

  std::size_t size() const { return m_begin.size(); }

  // Adds a closed path of edges of the current surface. Paths are numbered from 0.
  void add(const std::vector<Index>& path)
  {
    const Index begin = static_cast<Index>(m_nodes.size()), n = static_cast<Index>(path.size());
    m_begin.push_back(begin);
    for(Index i = 0; i < n; ++i)
    {
      m_nodes.push_back({path[i], begin + (i + n - 1) % n, begin + (i + 1) % n, null_index});
      enter(begin + i);
    }
  }

  std::vector<Index> path(std::size_t number) const
  {
    std::vector<Index> vertices;
    Index i = m_begin[number];
    do
    {
      vertices.push_back(m_nodes[i].vertex);
      i = m_nodes[i].next;
    } while(i != m_begin[number]);
    return vertices;
  }

  // Undoes the last collapse and carries all paths over. O(degree) for each passage of a path through the vertex.
  void split()
  {
    const Progressive_mesh::Split s = m_pm.split();
    const std::array<Index, 2> ends = {{s.kept, s.removed}};
    Index node = m_first_at[s.kept];
    m_first_at[s.kept] = null_index;
    while(node != null_index)
    {
      const Index following = m_nodes[node].next_at, next = m_nodes[node].next;
      const Index from = m_nodes[m_nodes[node].previous].vertex, to = m_nodes[next].vertex;
      double best = (std::numeric_limits<double>::infinity)();
      Index first = s.kept, last = s.kept;
      for(Index u : ends)
        for(Index v : ends)
        {
          if(m_pm.halfedge(from, u) == null_index || m_pm.halfedge(v, to) == null_index)
            continue;
          const double length = distance(from, u) + distance(u, v) + distance(v, to);
          if(length < best)
          {
            best = length;
            first = u;
            last = v;
          }
        }
      m_nodes[node].vertex = first;
      enter(node);
      if(first != last)
      {
        const Index inserted = static_cast<Index>(m_nodes.size());
        m_nodes.push_back({last, node, next, null_index});
        m_nodes[node].next = inserted;
        m_nodes[next].previous = inserted;
        enter(inserted);
      }
      node = following;
    }
  }

private:
  // A passage of a path through a vertex.
  struct Node
  {
    Index vertex, previous, next;
    Index next_at; // another passage through the same vertex
  };

  void enter(Index node)
  {
    Index& first = m_first_at[m_nodes[node].vertex];
    m_nodes[node].next_at = first;
    first = node;
  }

  double distance(Index u, Index v) const { return norm(vector(m_pm.point(u), m_pm.point(v))); }

  Progressive_mesh& m_pm;
  std::vector<Node> m_nodes;
  std::vector<Index> m_begin;    // any node of each path
  std::vector<Index> m_first_at; // a node at each vertex
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_EDGE_PATHS_H
