// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_OPENED_NEIGHBOURHOOD_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_OPENED_NEIGHBOURHOOD_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Straight_cut.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Surface_metric.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Some faces of a surface, opened along a cut: each face that the cut crosses is divided into three, and the points of
// the cut are there twice, once on either side.
class Opened_neighbourhood
{
public:
  // A stretch of an edge of the surface, and the edge of `metric()` that it has become.
  struct Part
  {
    Index edge;
    double begin, end; // along the edge of the surface
    bool is_reversed;
  };

  // `local_vertices` has room for the vertices of the surface, each null_index; it is left as it was. The cut is as
  // drawn by `Straight_cut`. O(n log n) for n faces.
  Opened_neighbourhood(const Progressive_mesh& pm, const Edge_lengths& lengths, const std::vector<Index>& faces,
                       const std::vector<Cut_point>& cut, std::vector<Index>& local_vertices)
    : m_pm(pm), m_lengths(lengths)
  {
    std::vector<Index> corners, vertices;
    const auto local = [&](Index v) {
      if(local_vertices[v] == null_index)
      {
        local_vertices[v] = static_cast<Index>(vertices.size());
        vertices.push_back(v);
        m_points.push_back(position(pm, v));
      }
      return local_vertices[v];
    };
    for(Index f : faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        local(pm.source(h));
    std::unordered_map<Index, std::size_t> cut_faces;
    const Index first = static_cast<Index>(m_points.size());
    for(std::size_t i = 0; i < cut.size(); ++i)
    {
      const Index h = cut[i].halfedge;
      if(i + 1 < cut.size())
        cut_faces.emplace(pm.face(h), i);
      const Vector3 p =
          position(pm, pm.source(h)) + cut[i].parameter * vector(pm.point(pm.source(h)), pm.point(pm.target(h)));
      m_points.push_back(p);
      m_points.push_back(p);
      m_crossed.emplace(pm.edge(h), i);
    }
    const auto left = [first](std::size_t i) { return first + static_cast<Index>(2 * i); };
    const auto right = [first](std::size_t i) { return first + static_cast<Index>(2 * i + 1); };
    const auto add = [&corners](Index a, Index b, Index c) { corners.insert(corners.end(), {a, b, c}); };
    for(Index f : faces)
    {
      const auto found = cut_faces.find(f);
      if(found == cut_faces.end())
      {
        add(local(pm.source(3 * f)), local(pm.source(3 * f + 1)), local(pm.source(3 * f + 2)));
        continue;
      }
      const std::size_t i = found->second;
      const Index h = cut[i].halfedge, exit = pm.opposite(cut[i + 1].halfedge);
      const Index p = local(pm.source(h)), q = local(pm.target(h)), r = local(pm.source(pm.prev(h)));
      if(exit == pm.next(h)) // the corner q is cut off, on the right
      {
        add(right(i), q, right(i + 1));
        add(left(i), left(i + 1), r);
        add(left(i), r, p);
      }
      else // the corner p is cut off, on the left
      {
        add(left(i), left(i + 1), p);
        add(right(i), q, r);
        add(right(i), r, right(i + 1));
      }
    }
    m_metric = Surface_metric(std::move(corners), m_points);
    m_first_copy = first;
    for(std::size_t i = 0; i + 1 < cut.size(); ++i)
    {
      m_left.push_back(m_metric.halfedge(left(i), left(i + 1)));
      m_right.push_back(m_metric.halfedge(right(i + 1), right(i)));
    }
    m_parts.reserve(3 * faces.size());
    for(Index f : faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(m_first_part.emplace(pm.edge(h), m_parts.size()).second)
          add_parts(pm.edge(h), cut, first, local_vertices);
    for(Index v : vertices)
    {
      m_local.emplace(v, local_vertices[v]);
      local_vertices[v] = null_index;
    }
  }

  const Surface_metric& metric() const { return m_metric; }

  // the vertex of `metric()` that a vertex of the surface has become
  Index vertex(Index v) const { return m_local.at(v); }

  // Two copies of `metric()`, the right side of the cut of the first one glued to the left side of the second one, and
  // the vertex of the second one that vertex v is. O(n log n).
  Surface_metric two_copies() const
  {
    std::vector<Index> corners;
    for(Index h = 0; h < m_metric.number_of_halfedges(); ++h)
      corners.push_back(m_metric.source(h));
    for(Index h = 0; h < m_metric.number_of_halfedges(); ++h)
      corners.push_back(in_second_copy(m_metric.source(h)));
    std::vector<Vector3> points = m_points;
    points.insert(points.end(), m_points.begin(), m_points.end());
    return Surface_metric(std::move(corners), points);
  }

  Index in_second_copy(Index v) const
  {
    const bool is_left = v >= m_first_copy && (v - m_first_copy) % 2 == 0;
    return is_left ? v + 1 : static_cast<Index>(m_points.size()) + v;
  }

  // The halfedges along the cut, of the faces on its left and on its right, one for each face that it crosses.
  const std::vector<Index>& left() const { return m_left; }
  const std::vector<Index>& right() const { return m_right; }

  // Calls f(part) for each part of an edge, which is given by its smaller halfedge.
  template <class Function>
  void for_each_part(Index edge, const Function& f) const
  {
    const std::size_t first = m_first_part.at(edge);
    f(m_parts[first]);
    if(m_crossed.count(edge) != 0)
      f(m_parts[first + 1]);
  }

private:
  void add_parts(Index edge, const std::vector<Cut_point>& cut, Index first, const std::vector<Index>& local)
  {
    const Index u = local[m_pm.source(edge)], v = local[m_pm.target(edge)];
    const auto crossed = m_crossed.find(edge);
    if(crossed == m_crossed.end())
    {
      add_part(u, v, 0, m_lengths[edge]);
      return;
    }
    const Cut_point& c = cut[crossed->second];
    Index before = first + static_cast<Index>(2 * crossed->second), after = before + 1; // left and right
    double t = c.parameter;
    if(c.halfedge != edge)
    {
      std::swap(before, after);
      t = 1 - t;
    }
    add_part(u, before, 0, t * m_lengths[edge]);
    add_part(after, v, t * m_lengths[edge], m_lengths[edge]);
  }

  void add_part(Index u, Index v, double begin, double end)
  {
    const Index h = m_metric.halfedge(u, v), o = m_metric.halfedge(v, u);
    const Index e = (std::min)(h, o);
    m_parts.push_back({e, begin, end, e != h});
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  std::vector<Vector3> m_points;
  Index m_first_copy = 0; // of the points of the cut: each is there on the left and then on the right
  std::unordered_map<Index, Index> m_local;
  Surface_metric m_metric;
  std::vector<Index> m_left, m_right;
  std::unordered_map<Index, std::size_t> m_crossed; // edge of the surface -> place in the cut
  std::unordered_map<Index, std::size_t> m_first_part;
  std::vector<Part> m_parts;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_OPENED_NEIGHBOURHOOD_H
