// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SHORTEST_PATH_TREE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SHORTEST_PATH_TREE_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The shortest paths along edges from one vertex to all others (Dijkstra). Vertices as numbered in the graph.
class Shortest_path_tree
{
public:
  explicit Shortest_path_tree(const Edge_graph& graph) : m_graph(graph), m_vertices(graph.number_of_vertices()) {}

  // O(n log n) for the n vertices of the graph. Ties go to the vertex with the smaller number.
  void grow(Index root)
  {
    std::fill(m_vertices.begin(), m_vertices.end(), Vertex());
    m_root = root;
    m_vertices[root] = Vertex{0, null_index, null_index};
    m_heap.assign(1, Entry(0, root));
    while(!m_heap.empty())
    {
      std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
      const Entry nearest = m_heap.back();
      m_heap.pop_back();
      const Index u = nearest.second;
      if(nearest.first > m_vertices[u].distance)
        continue;
      for(const Edge_graph::Neighbour* n = m_graph.neighbours_begin(u); n != m_graph.neighbours_end(u); ++n)
      {
        Vertex& v = m_vertices[n->vertex];
        const double distance = nearest.first + n->length;
        if(distance < v.distance)
        {
          v = Vertex{distance, u, u == root ? n->vertex : m_vertices[u].branch};
          m_heap.emplace_back(distance, n->vertex);
          std::push_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
        }
      }
    }
  }

  Index root() const { return m_root; }

  bool is_reached(Index v) const { return v == m_root || m_vertices[v].parent != null_index; }

  // Infinite for a vertex of another connected component.
  double distance(Index v) const { return m_vertices[v].distance; }

  // The next vertex on the way to the root; null_index for the root.
  Index parent(Index v) const { return m_vertices[v].parent; }

  // The neighbour of the root through which the path runs; null_index for the root.
  Index branch(Index v) const { return m_vertices[v].branch; }

private:
  struct Vertex
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index parent = null_index, branch = null_index;

    Vertex() = default;
    Vertex(double distance, Index parent, Index branch) : distance(distance), parent(parent), branch(branch) {}
  };
  typedef std::pair<double, Index> Entry; // distance and vertex

  const Edge_graph& m_graph;
  std::vector<Vertex> m_vertices;
  std::vector<Entry> m_heap;
  Index m_root = null_index;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_SHORTEST_PATH_TREE_H
