// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_IMPORTED_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_IMPORTED_MESH_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point;

// Throws Invalid_input for a coordinate that is no finite number and for an edge of length zero.
inline void check_points(const Corner_table& table, const std::vector<Point>& points)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(points[v][i]))
        throw Invalid_input(Input_defect::NON_FINITE_COORDINATE, v,
                            "non-finite coordinate: vertex " + std::to_string(v) + " has " + "xyz"[i] + " = " +
                                std::to_string(points[v][i]));
  for(Index h = 0; h < table.halfedges.size(); ++h)
  {
    const Index u = table.halfedges[h].source, v = table.halfedges[Corner_table::next(h)].source;
    if(points[u] == points[v])
      throw Invalid_input(Input_defect::ZERO_LENGTH_EDGE, h / 3,
                          "degenerate face: " + edge_name(u, v) + " of face " + std::to_string(h / 3) +
                              " has length zero");
  }
}

// Closes the holes of an open surface by ghosts. A ghost vertex is put in the middle of the vertices of its hole.
// Linear.
inline void close_by_ghosts(Corner_table& table, std::vector<Point>& points)
{
  for(const std::vector<Index>& hole : close_by_ghosts(table))
  {
    double sum[3] = {0, 0, 0};
    for(Index v : hole)
      for(int i = 0; i < 3; ++i)
        sum[i] += points[v][i] / static_cast<double>(hole.size());
    points.emplace_back(sum[0], sum[1], sum[2]);
  }
}

// A triangle mesh taken over from a face graph, with the way back; if it has a boundary, closed by ghosts. Vertices and
// faces are numbered in the order of the graph, until the faces are put into another order. Faces start at their vertex
// of smallest index, so that the same mesh in different data structures is taken over the same way.
template <class TriangleMesh>
class Imported_mesh
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  Corner_table table;
  std::vector<Point> points;

  // Throws Invalid_input for every defect of the mesh. Linear in its size.
  template <class VertexPointMap, class VertexIndexMap>
  Imported_mesh(const TriangleMesh& tm, VertexPointMap vpm, VertexIndexMap vim) : m_tm(tm)
  {
    std::vector<Index> index; // of the descriptor's index, which may have gaps
    for(vertex_descriptor v : vertices(tm))
    {
      const std::size_t i = get(vim, v);
      if(index.size() <= i)
        index.resize(i + 1, null_index);
      index[i] = static_cast<Index>(m_vertices.size());
      m_vertices.push_back(v);
      points.push_back(nearest_point(get(vpm, v)));
    }

    std::vector<Index> corners;
    for(auto f : faces(tm))
    {
      const halfedge_descriptor h = halfedge(f, tm);
      const halfedge_descriptor n = next(h, tm), p = next(n, tm);
      if(next(p, tm) != h || p == h || n == h)
        throw Invalid_input(Input_defect::NOT_TRIANGULAR, m_halfedges.size(),
                            "not a triangle mesh: face " + std::to_string(m_halfedges.size()) +
                                " has not three vertices; triangulate_with_face_map() makes a mesh of triangles");
      const Index a = index[get(vim, source(h, tm))], b = index[get(vim, source(n, tm))],
                  c = index[get(vim, source(p, tm))];
      if(a <= b && a <= c)
        add_face(h, a, b, c, corners);
      else if(b <= a && b <= c)
        add_face(n, b, c, a, corners);
      else
        add_face(p, c, a, b, corners);
    }
    table = make_corner_table(points.size(), corners, true);
    check_points(table, points);
    if(has_border(table))
      close_by_ghosts(table, points);
  }

  // Numbers the faces of the mesh anew: first face order[0], then order[1]. Ghosts stay the last.
  void reorder_faces(const std::vector<Index>& order)
  {
    std::vector<Index> with_ghosts = order;
    for(Index f = static_cast<Index>(order.size()); f < table.halfedges.size() / 3; ++f)
      with_ghosts.push_back(f);
    table = with_faces_in_order(table, with_ghosts);
    std::vector<halfedge_descriptor> halfedges;
    halfedges.reserve(order.size());
    for(Index f : order)
      halfedges.push_back(m_halfedges[f]);
    m_halfedges.swap(halfedges);
  }

  const TriangleMesh& mesh() const { return m_tm; }

  // without ghosts
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  std::size_t number_of_faces() const { return m_halfedges.size(); }

  // Divides coordinates by `unit()`.
  void rescale()
  {
    double greatest = 0;
    for(const Point& p : points)
      greatest = (std::max)({greatest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    m_unit = Coordinate_unit(greatest);
    if(m_unit.is_one())
      return;
    for(Point& p : points)
      p = m_unit.divided(p);
  }

  // what coordinates have been divided by
  const Coordinate_unit& unit() const { return m_unit; }

  vertex_descriptor vertex(Index v) const { return m_vertices[v]; }

  halfedge_descriptor halfedge_of(Index h) const
  {
    const halfedge_descriptor first = m_halfedges[h / 3];
    return h % 3 == 0 ? first : h % 3 == 1 ? next(first, m_tm) : next(next(first, m_tm), m_tm);
  }

private:
  void add_face(halfedge_descriptor h, Index a, Index b, Index c, std::vector<Index>& corners)
  {
    m_halfedges.push_back(h);
    corners.push_back(a);
    corners.push_back(b);
    corners.push_back(c);
  }

  const TriangleMesh& m_tm;
  Coordinate_unit m_unit;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges; // the first of each face
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_IMPORTED_MESH_H
