// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_OPENED_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_OPENED_MESH_H

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Triangles of a mesh opened along marked edges: a vertex there becomes one for each fan of faces between two of them.
// Vertices can be merged again, and triangles and vertices added.
template <class TriangleMesh, class EdgeIsConstrainedMap, class VertexPointMap>
class Opened_mesh
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

public:
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;

  Opened_mesh(const TriangleMesh& tm, EdgeIsConstrainedMap marks, VertexPointMap vpm)
    : m_tm(tm), m_marks(marks), m_vpm(vpm)
  {}

  void add_face(face_descriptor f)
  {
    std::array<std::size_t, 3> triangle;
    halfedge_descriptor h = halfedge(f, m_tm);
    for(std::size_t& v : triangle)
    {
      v = vertex(h);
      h = next(h, m_tm);
    }
    m_triangles.push_back(triangle);
  }

  void add_triangle(const std::array<std::size_t, 3>& triangle) { m_triangles.push_back(triangle); }

  std::size_t add_vertex(const Point& p)
  {
    m_points.push_back(p);
    m_merged_into.push_back(m_merged_into.size());
    return m_merged_into.back();
  }

  // The vertex at the end of a halfedge, the same for all of its fan.
  std::size_t vertex(halfedge_descriptor h)
  {
    const auto known = m_vertex.find(h);
    if(known != m_vertex.end())
      return known->second;
    halfedge_descriptor first = h;
    while(!is_end(first))
    {
      first = prev(opposite(first, m_tm), m_tm);
      if(first == h)
        break;
    }
    const std::size_t v = add_vertex(get(m_vpm, target(h, m_tm)));
    h = first;
    do
    {
      m_vertex[h] = v;
      const halfedge_descriptor n = next(h, m_tm);
      if(is_end(n))
        break;
      h = opposite(n, m_tm);
    } while(h != first);
    return v;
  }

  void merge(std::size_t a, std::size_t b) { m_merged_into[representative(a)] = representative(b); }

  std::size_t number_of_triangles() const { return m_triangles.size(); }

  // Points and triangles, without vertices that have been merged into others.
  std::pair<std::vector<Point>, std::vector<std::array<std::size_t, 3>>> soup()
  {
    std::vector<Point> points;
    std::vector<std::size_t> number(m_points.size());
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(m_merged_into[v] == v)
      {
        number[v] = points.size();
        points.push_back(m_points[v]);
      }
    std::vector<std::array<std::size_t, 3>> triangles = m_triangles;
    for(std::array<std::size_t, 3>& t : triangles)
      for(std::size_t& v : t)
        v = number[representative(v)];
    return {points, triangles};
  }

private:
  // where a fan of faces ends
  bool is_end(halfedge_descriptor h) const { return get(m_marks, edge(h, m_tm)) || CGAL::is_border_edge(h, m_tm); }

  std::size_t representative(std::size_t v)
  {
    while(m_merged_into[v] != v)
      v = m_merged_into[v] = m_merged_into[m_merged_into[v]];
    return v;
  }

  const TriangleMesh& m_tm;
  EdgeIsConstrainedMap m_marks;
  VertexPointMap m_vpm;
  std::unordered_map<halfedge_descriptor, std::size_t> m_vertex;
  std::vector<Point> m_points;
  std::vector<std::size_t> m_merged_into; // of a vertex: itself, or one that it has been merged with
  std::vector<std::array<std::size_t, 3>> m_triangles;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_OPENED_MESH_H
