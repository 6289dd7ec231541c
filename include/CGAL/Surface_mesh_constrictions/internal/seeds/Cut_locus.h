// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_CUT_LOCUS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_CUT_LOCUS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Shortest_path_tree.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/canonical_loop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The loops of edges through one vertex, the root, and one edge of its cut locus: an edge whose two ends are reached
// from the root by shortest paths that have only the root in common.
class Cut_locus
{
public:
  explicit Cut_locus(const Edge_graph& graph) : m_graph(graph), m_tree(graph), m_lengths(graph.edges().size()) {}

  // Calls f(loop), a canonical closed path of vertex ids, for each loop that is not longer than those of the next two
  // edges along the cut locus, whichever way, and that does not bound a face. O(n log n), plus the loops.
  template <class F>
  void for_each_loop(Index root, F f)
  {
    m_tree.grow(root);
    const std::vector<Edge_graph::Edge>& edges = m_graph.edges();
    for(std::size_t e = 0; e < edges.size(); ++e)
      m_lengths[e] = length(edges[e]);
    for(std::size_t e = 0; e < edges.size(); ++e)
    {
      if(m_lengths[e] == infinity)
        continue;
      if(!is_shortest(e) || is_face(edges[e]))
        continue;
      m_loop.clear();
      for(Index v = edges[e].ends[0]; v != null_index; v = m_tree.parent(v))
        m_loop.push_back(m_graph.id(v));
      std::reverse(m_loop.begin(), m_loop.end());
      for(Index v = edges[e].ends[1]; v != root; v = m_tree.parent(v))
        m_loop.push_back(m_graph.id(v));
      make_canonical(m_loop);
      f(static_cast<const std::vector<Index>&>(m_loop));
    }
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // Of the loop that the edge closes; infinite if it is not on the cut locus.
  double length(const Edge_graph::Edge& e) const
  {
    const Index u = m_tree.branch(e.ends[0]), v = m_tree.branch(e.ends[1]);
    if(u == v || u == null_index || v == null_index)
      return infinity;
    return m_tree.distance(e.ends[0]) + e.length + m_tree.distance(e.ends[1]);
  }

  // Whether the loop that an edge closes is not longer than those of the edges of its two faces, nor, as far as these
  // are on the cut locus, than those of the edges of their faces: distances along edges vary from one to the next.
  // Loops that bound a face count among the nearer ones only, or else none around a tube of a few edges would be left.
  bool is_shortest(std::size_t e) const
  {
    const std::vector<Edge_graph::Edge>& edges = m_graph.edges();
    for(Index next : edges[e].around)
    {
      if(next == null_index)
        continue;
      if(m_lengths[next] < m_lengths[e])
        return false;
      if(m_lengths[next] == infinity)
        continue;
      for(Index second : edges[next].around)
        if(second != null_index && m_lengths[second] < m_lengths[e] && !is_face(edges[second]))
          return false;
    }
    return true;
  }

  // Whether the loop that the edge closes bounds one of the faces at the edge.
  bool is_face(const Edge_graph::Edge& e) const
  {
    return m_tree.parent(e.ends[0]) == m_tree.root() && m_tree.parent(e.ends[1]) == m_tree.root() &&
           (e.apexes[0] == m_tree.root() || e.apexes[1] == m_tree.root());
  }

  const Edge_graph& m_graph;
  Shortest_path_tree m_tree;
  std::vector<double> m_lengths; // of the loops that edges close
  std::vector<Index> m_loop;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_CUT_LOCUS_H
