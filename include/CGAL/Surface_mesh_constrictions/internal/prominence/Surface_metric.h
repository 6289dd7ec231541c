// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SURFACE_METRIC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SURFACE_METRIC_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A triangulated surface, as a rule with boundary, whose faces are laid into the plane one by one. Face f has the
// halfedges 3f, 3f + 1 and 3f + 2, counterclockwise. Several fans of faces may meet at a vertex of the boundary.
class Surface_metric
{
public:
  Surface_metric() : m_first(1, 0) {}

  // Of faces with these corners. No two faces run along an edge in the same direction. O(n log n).
  Surface_metric(std::vector<Index> corners, const std::vector<Vector3>& points)
    : m_source(std::move(corners)), m_opposite(m_source.size(), null_index), m_first(points.size() + 1, 0)
  {
    const Index n = static_cast<Index>(m_source.size());
    m_length.reserve(n);
    m_apex.reserve(n);
    for(Index h = 0; h < n; ++h)
    {
      const Vector3 e = points[target(h)] - points[source(h)], c = points[source(prev(h))] - points[source(h)];
      const double length = norm(e);
      m_length.push_back(length);
      m_apex.push_back({dot(c, e) / length, norm(cross(c, e)) / length});
      ++m_first[source(h) + 1];
    }
    for(std::size_t v = 0; v < points.size(); ++v)
      m_first[v + 1] += m_first[v];
    std::vector<Index> end(m_first.begin(), m_first.end() - 1);
    m_outgoing.resize(n);
    for(Index h = 0; h < n; ++h)
      m_outgoing[end[source(h)]++] = h;
    std::vector<double> angle(points.size(), 0);
    std::vector<Index> borders(points.size(), 0);
    for(Index h = 0; h < n; ++h)
    {
      m_opposite[h] = halfedge(target(h), source(h));
      borders[source(h)] += m_opposite[h] == null_index;
      angle[source(h)] += std::atan2(m_apex[h].y, m_apex[h].x);
    }
    for(std::size_t v = 0; v < points.size(); ++v)
      m_bends.push_back(borders[v] > 1 || angle[v] > (borders[v] == 1 ? 1 : 2) * CGAL_PI + flat_tolerance);
  }

  static Index next(Index h) { return Corner_table::next(h); }
  static Index prev(Index h) { return Corner_table::prev(h); }

  std::size_t number_of_vertices() const { return m_first.size() - 1; }
  std::size_t number_of_halfedges() const { return m_source.size(); }
  Index source(Index h) const { return m_source[h]; }
  Index target(Index h) const { return m_source[next(h)]; }
  Index opposite(Index h) const { return m_opposite[h]; } // null_index on the boundary
  double length(Index h) const { return m_length[h]; }

  // The smaller halfedge of an edge; on the boundary the only one.
  Index edge(Index h) const { return (std::min)(h, m_opposite[h]); }

  // The third corner of the face of h, where h runs along the x axis from the origin.
  Vector2 apex(Index h) const { return m_apex[h]; }

  // The halfedges out of a vertex.
  const Index* outgoing_begin(Index v) const { return m_outgoing.data() + m_first[v]; }
  const Index* outgoing_end(Index v) const { return m_outgoing.data() + m_first[v + 1]; }

  // The halfedge from u to v, or null_index. Linear in the degree of u.
  Index halfedge(Index u, Index v) const
  {
    const Index* const h = std::find_if(outgoing_begin(u), outgoing_end(u), [&](Index x) { return target(x) == v; });
    return h == outgoing_end(u) ? null_index : *h;
  }

  // Whether a shortest path may bend at a vertex: whether its angles add up to more than a full turn, on the boundary
  // to more than half a turn.
  bool bends(Index v) const { return m_bends[v]; }

private:
  // A vertex that exceeds its turn by less is flat but for rounding.
  static constexpr double flat_tolerance = 1e-12;

  std::vector<Index> m_source, m_opposite; // by halfedge
  std::vector<double> m_length;
  std::vector<Vector2> m_apex;
  std::vector<Index> m_first, m_outgoing; // vertex v has m_outgoing[m_first[v]] ... m_outgoing[m_first[v + 1] - 1]
  std::vector<bool> m_bends;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SURFACE_METRIC_H
