// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_POINT_LOCATOR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_POINT_LOCATOR_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Finds what is nearest to a point in space: the vertices of a surface come in clusters, and a ball holds the faces of
// each cluster. A tree of boxes would take several times the memory of the surface. Of two that are as near, the
// one with the smaller number is found, as by a scan of them all.
class Point_locator
{
  typedef Progressive_mesh::Point Point;

public:
  // `cluster_of[v]` is less than `clusters`, or null_index for a vertex that is not to be found. Linear. Memory: 4
  // bytes a vertex.
  Point_locator(const Progressive_mesh& pm, const std::vector<Index>& cluster_of, std::size_t clusters)
    : m_pm(pm), m_begin(clusters + 1, 0), m_balls(clusters)
  {
    for(Index c : cluster_of)
      if(c != null_index)
        ++m_begin[c + 1];
    for(std::size_t c = 0; c < clusters; ++c)
      m_begin[c + 1] += m_begin[c];
    m_vertices.resize(m_begin.back());
    std::vector<Index> end(m_begin.begin(), m_begin.end() - 1);
    for(Index v = 0; v < cluster_of.size(); ++v)
      if(cluster_of[v] != null_index)
        m_vertices[end[cluster_of[v]]++] = v;
    for(std::size_t c = 0; c < clusters; ++c)
      m_balls[c] = ball(c);
  }

  // A vertex of the surface, which has one. O(clusters + the vertices of those that are about as near).
  Index nearest_vertex(const Point& p) const
  {
    Index nearest = null_index;
    const Vector3 q = {p.x(), p.y(), p.z()};
    search(q, [&](Index v, double& least) {
      const double d = norm(position(m_pm, v) - q);
      if(d < least || (d == least && v < nearest))
      {
        least = d;
        nearest = v;
      }
    });
    return nearest;
  }

  // A location of the surface, which has a face. A point that is further away than a million times the size of the
  // surface is brought as near as that, so that no square overflows. Cost as above.
  Surface_location nearest_location(const Point& p) const
  {
    double bounded[3];
    const double c[3] = {m_center.x, m_center.y, m_center.z};
    for(int k = 0; k < 3; ++k)
    {
      const double room = 1e6 * (std::abs(c[k]) + m_extent);
      bounded[k] = (std::min)((std::max)(p[k], c[k] - room), c[k] + room);
    }
    const Vector3 q = {bounded[0], bounded[1], bounded[2]};
    const Point there(q.x, q.y, q.z);
    Surface_location nearest = {null_index, {{1, 0, 0}}};
    search(q, [&](Index v, double& least) {
      const Index begin = m_pm.outgoing(v);
      Index h = begin;
      do
      {
        const Index f = m_pm.face(h);
        if(!m_pm.is_ghost_face(f))
        {
          Surface_location l = {f, {}};
          l.barycentric = nearest_in_triangle(there, m_pm.point(m_pm.source(3 * f)), m_pm.point(m_pm.source(3 * f + 1)),
                                              m_pm.point(m_pm.source(3 * f + 2)));
          Vector3 at = {0, 0, 0};
          for(Index i = 0; i < 3; ++i)
            at = at + l.barycentric[i] * position(m_pm, m_pm.source(3 * f + i));
          const double d = norm(at - q);
          if(d < least || (d == least && f < nearest.face))
          {
            least = d;
            nearest = l;
          }
        }
        h = m_pm.ccw(h);
      } while(h != begin);
    });
    return nearest;
  }

private:
  struct Ball
  {
    Vector3 center;
    double radius;
  };

  // A bit larger than the ball around the middle of the box of the cluster that holds all faces of its vertices.
  Ball ball(std::size_t cluster)
  {
    if(m_begin[cluster] == m_begin[cluster + 1])
      return {{0, 0, 0}, 0};
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    Vector3 low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
    for(Index i = m_begin[cluster]; i < m_begin[cluster + 1]; ++i)
    {
      const Vector3 p = position(m_pm, m_vertices[i]);
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
    Ball result = {0.5 * (low + high), 0};
    for(Index i = m_begin[cluster]; i < m_begin[cluster + 1]; ++i)
    {
      const Index begin = m_pm.outgoing(m_vertices[i]);
      Index h = begin;
      do
      {
        if(!m_pm.is_ghost_vertex(m_pm.target(h)))
          result.radius = (std::max)(result.radius, norm(position(m_pm, m_pm.target(h)) - result.center));
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    result.radius *= 1 + 1e-9;
    if(m_extent == 0)
      m_center = result.center;
    m_extent = (std::max)(m_extent, norm(result.center - m_center) + result.radius);
    return result;
  }

  // Calls visit(v, least) for the vertices of clusters, the nearest cluster first, until the next one is further away
  // than `least`, which visit() makes smaller.
  template <class Visit>
  void search(const Vector3& q, const Visit& visit) const
  {
    typedef std::pair<double, Index> Entry; // distance of the ball, and cluster
    std::vector<Entry> entries;
    for(Index c = 0; c < m_balls.size(); ++c)
      if(m_begin[c] != m_begin[c + 1])
      {
        const double d = norm(q - m_balls[c].center);
        entries.emplace_back((std::max)(d * (1 - 1e-9) - m_balls[c].radius, 0.), c);
      }
    std::make_heap(entries.begin(), entries.end(), std::greater<Entry>());
    double least = (std::numeric_limits<double>::infinity)();
    while(!entries.empty() && entries.front().first <= least)
    {
      std::pop_heap(entries.begin(), entries.end(), std::greater<Entry>());
      const Index c = entries.back().second;
      entries.pop_back();
      for(Index i = m_begin[c]; i < m_begin[c + 1]; ++i)
        visit(m_vertices[i], least);
    }
  }

  const Progressive_mesh& m_pm;
  std::vector<Index> m_vertices, m_begin; // the vertices of the clusters, one after the other
  std::vector<Ball> m_balls;              // by cluster
  Vector3 m_center = {0, 0, 0};           // of the first ball
  double m_extent = 0;                    // how far the surface reaches from there
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_POINT_LOCATOR_H
