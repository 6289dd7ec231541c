// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PINCHES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PINCHES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A place where two stretches of a closed curve run along each other, with no vertex between them. There they can be
// drawn together at a point, where the curve parts into two.
struct Pinch
{
  double rise;              // how much longer the curve gets at most on the way there
  std::vector<Strip> parts; // the halfedges that each of the two crosses, in order, beside the pivots on that side
};

// Finds the pinches of curves on their left. Linear in the size of the mesh to make.
class Pinch_finder
{
public:
  explicit Pinch_finder(const Progressive_mesh& pm) : m_pm(pm), m_last(pm.number_of_halfedge_ids()) {}

  // Of a simple closed geodesic with this trace. Linear if the curve crosses no edge twice; else O(n log n) for n
  // crossings.
  std::vector<Pinch> operator()(const std::vector<Trace_point>& trace)
  {
    std::vector<Pinch> result;
    if(!crosses_an_edge_twice(trace))
      return result;
    find_gaps();
    const std::size_t n = m_crossings.size();
    std::vector<bool> is_done(n, false);
    for(std::size_t i = 0; i < n; ++i)
    {
      if(m_across[i] == none || is_done[i])
        continue;
      std::size_t first = i, size = 1; // of the gaps along which the same two stretches run
      while(size < n && m_across[previous(first)] == next(m_across[first]))
      {
        first = previous(first);
        ++size;
      }
      std::size_t last = i;
      while(size < n && m_across[next(last)] == previous(m_across[last]))
      {
        last = next(last);
        ++size;
      }
      for(std::size_t k = first;; k = next(k))
      {
        is_done[k] = is_done[m_across[k]] = true;
        if(k == last)
          break;
      }
      result.push_back({rise(first, last), {between(last, m_across[last]), between(m_across[first], first)}});
    }
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Crossing
  {
    Index halfedge;
    Index pivot; // at the source, or null_index
    double parameter;
  };

  std::size_t next(std::size_t i) const { return i + 1 < m_crossings.size() ? i + 1 : 0; }
  std::size_t previous(std::size_t i) const { return i > 0 ? i - 1 : m_crossings.size() - 1; }

  // Notes the crossings of a curve with this trace, moved to its left at its pivots.
  bool crosses_an_edge_twice(const std::vector<Trace_point>& trace)
  {
    ++m_curve;
    m_crossings.clear();
    bool result = false;
    for_each_crossing_beside_pivots(m_pm, trace, [&](Index h, std::size_t i) {
      m_crossings.push_back({h, trace[i].pivot, trace[i].is_pivot() ? 0 : trace[i].parameter});
      Index& last = m_last[m_pm.edge(h)];
      result = result || last == m_curve;
      last = m_curve;
    });
    return result;
  }

  // Notes of each crossing the one across the gap on its left, if there is one: on the same edge, in the other
  // direction, and with no other one between. Where the curve crosses an edge and turns back at once there is no gap.
  void find_gaps()
  {
    m_across.assign(m_crossings.size(), none);
    struct On_edge
    {
      Index edge;
      double place; // from the source of the halfedge that stands for the edge
      std::size_t crossing;
    };
    std::vector<On_edge> order;
    for(std::size_t i = 0; i < m_crossings.size(); ++i)
    {
      const Crossing& p = m_crossings[i];
      const Index e = m_pm.edge(p.halfedge);
      if(!m_pm.is_ghost_vertex(m_pm.source(e)) && !m_pm.is_ghost_vertex(m_pm.target(e)))
        order.push_back({e, p.halfedge == e ? p.parameter : 1 - p.parameter, i});
    }
    std::sort(order.begin(), order.end(), [](const On_edge& x, const On_edge& y) {
      return x.edge != y.edge ? x.edge < y.edge : x.place != y.place ? x.place < y.place : x.crossing < y.crossing;
    });
    for(std::size_t i = 0; i + 1 < order.size(); ++i)
    {
      const On_edge &x = order[i], &y = order[i + 1];
      if(x.edge != y.edge || m_crossings[x.crossing].halfedge != x.edge || m_crossings[y.crossing].halfedge == y.edge ||
         next(x.crossing) == y.crossing || next(y.crossing) == x.crossing)
        continue;
      m_across[x.crossing] = y.crossing;
      m_across[y.crossing] = x.crossing;
    }
  }

  // Whether a sequence of points in the plane, of which some follow themselves, is bent at one of them.
  static bool is_bent(const std::vector<Vector2>& points, std::size_t k)
  {
    constexpr double tolerance = 1e-9; // radians
    std::size_t before = k, behind = k;
    while(before > 0 && norm(points[before] - points[k]) == 0)
      --before;
    while(behind + 1 < points.size() && norm(points[behind] - points[k]) == 0)
      ++behind;
    const Vector2 to = points[k] - points[before], from = points[behind] - points[k];
    return std::abs(cross(to, from)) > tolerance * norm(to) * norm(from);
  }

  // The last of a sequence of points in the plane that a straight line leads to from one of them.
  static std::size_t end_of_line(const std::vector<Vector2>& points, std::size_t begin)
  {
    std::size_t k = begin + 1;
    while(k + 1 < points.size() && (norm(points[k] - points[begin]) == 0 || !is_bent(points, k)))
      ++k;
    while(k + 1 < points.size() && norm(points[k + 1] - points[k]) == 0)
      ++k;
    return k;
  }

  // How much longer the curve gets at most if it is drawn together at one of some consecutive gaps, which lie in a
  // strip of faces. Between two gaps, where both stretches are straight, they are opposite sides of a convex quadrangle
  // in the plane. The point from which the sum of the distances to its corners is least is that in which its diagonals
  // cross. The longer the quadrangle, the less is the rise; so it goes from one bend to the next.
  double rise(std::size_t first, std::size_t last)
  {
    const Index begin = m_crossings[first].halfedge;
    Portal portal = {{0, norm(vector(m_pm.point(m_pm.source(begin)), m_pm.point(m_pm.target(begin))))}, {0, 0}};
    m_p.clear();
    m_q.clear();
    for(std::size_t i = first;; i = next(i))
    {
      if(i != first)
      {
        const Index h = m_crossings[previous(i)].halfedge;
        portal = next_portal(m_pm, h, portal, unfold_apex(m_pm, h, portal), m_crossings[i].halfedge);
      }
      const Vector2 along = portal.left - portal.right;
      m_p.push_back(portal.right + m_crossings[i].parameter * along);
      m_q.push_back(portal.left - m_crossings[m_across[i]].parameter * along);
      if(i == last)
        break;
    }
    const std::size_t n = m_p.size();
    if(n == 1)
      return 2 * norm(m_q[0] - m_p[0]);
    double least = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 0; i + 1 < n; ++i)
    {
      if(i > 0 && !is_bent(m_p, i) && !is_bent(m_q, i))
        continue;
      const std::size_t k = (std::min)(end_of_line(m_p, i), end_of_line(m_q, i));
      least = (std::min)(least,
                         norm(m_q[k] - m_p[i]) + norm(m_p[k] - m_q[i]) - norm(m_p[k] - m_p[i]) - norm(m_q[k] - m_q[i]));
    }
    return (std::max)(least, 0.0);
  }

  // What is crossed after one crossing and before another one.
  Strip between(std::size_t from, std::size_t to) const
  {
    Strip strip;
    for(std::size_t i = next(from); i != to; i = next(i))
      strip.push_back(m_crossings[i].halfedge);
    return strip;
  }

  const Progressive_mesh& m_pm;
  std::vector<Crossing> m_crossings;
  std::vector<std::size_t> m_across; // by crossing
  std::vector<Vector2> m_p, m_q;     // the two stretches beside some gaps, unfolded
  Zeroed_array<Index> m_last;        // by edge: the last curve that crosses it
  Index m_curve = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PINCHES_H
