// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_CURVE_NODES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_CURVE_NODES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The locations of a curve for verification: every vertex that the curve passes through, or passes so close that the
// difference is within the tolerance, is a vertex here and is there once.
template <class TriangleMesh>
class Curve_nodes
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Constriction<TriangleMesh>::Location Location;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  // A vertex, or the crossing of a halfedge from its face to the opposite one.
  struct Node
  {
    bool is_vertex;
    vertex_descriptor vertex;
    halfedge_descriptor halfedge;
    double parameter;
    std::size_t location; // of the curve
  };

  // tolerance: of the parameter of a crossing
  Curve_nodes(const TriangleMesh& tm, const std::vector<Location>& locations, double tolerance) : m_tm(tm)
  {
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      const Node node = node_of(locations[i], i, tolerance);
      if(m_nodes.empty() || !is_same_vertex(m_nodes.back(), node))
        m_nodes.push_back(node);
    }
    while(m_nodes.size() > 1 && is_same_vertex(m_nodes.back(), m_nodes.front()))
      m_nodes.pop_back();
    remove_crossings_of_followed_edges();
  }

  std::size_t size() const { return m_nodes.size(); }
  const Node& operator[](std::size_t i) const { return m_nodes[i % m_nodes.size()]; }

  // Whether the curve goes from node i to the next one inside a face or along an edge.
  bool is_connected(std::size_t i) const
  {
    const Node &a = (*this)[i], &b = (*this)[i + 1];
    if(a.is_vertex && b.is_vertex)
      return halfedge(a.vertex, b.vertex, m_tm).second;
    if(a.is_vertex)
      return has_face(b.halfedge) && a.vertex == apex(b.halfedge);
    const halfedge_descriptor o = opposite(a.halfedge, m_tm);
    if(!has_face(o))
      return false;
    return b.is_vertex ? b.vertex == apex(o) : b.halfedge == next(o, m_tm) || b.halfedge == prev(o, m_tm);
  }

private:
  Node node_of(const Location& l, std::size_t i, double tolerance) const
  {
    if(l.is_pivot)
      return {true, l.vertex, l.halfedge, 0, i};
    if(l.parameter <= tolerance)
      return {true, source(l.halfedge, m_tm), l.halfedge, 0, i};
    if(l.parameter >= 1 - tolerance)
      return {true, target(l.halfedge, m_tm), l.halfedge, 0, i};
    return {false, l.vertex, l.halfedge, l.parameter, i};
  }

  static bool is_same_vertex(const Node& a, const Node& b)
  {
    return a.is_vertex && b.is_vertex && a.vertex == b.vertex;
  }

  // A curve along an edge may be given as one that crosses it on the way from one end to the other.
  void remove_crossings_of_followed_edges()
  {
    std::vector<Node> kept;
    for(std::size_t i = 0; i < m_nodes.size(); ++i)
    {
      const Node &before = (*this)[i + m_nodes.size() - 1], &node = m_nodes[i], &after = (*this)[i + 1];
      if(!node.is_vertex && before.is_vertex && after.is_vertex)
      {
        const vertex_descriptor s = source(node.halfedge, m_tm), t = target(node.halfedge, m_tm);
        if((before.vertex == s && after.vertex == t) || (before.vertex == t && after.vertex == s))
          continue;
      }
      kept.push_back(node);
    }
    m_nodes.swap(kept);
  }

  bool has_face(halfedge_descriptor h) const { return face(h, m_tm) != Graph_traits::null_face(); }
  vertex_descriptor apex(halfedge_descriptor h) const { return target(next(h, m_tm), m_tm); }

  const TriangleMesh& m_tm;
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_CURVE_NODES_H
