// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_STRAIGHT_CUT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_STRAIGHT_CUT_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A point where a cut comes into the face of a halfedge, at source + parameter (target - source). The source is on the
// left of the cut.
struct Cut_point
{
  Index halfedge;
  double parameter;
};

// Draws straight lines on a surface, both ways from a point of a closed curve and at right angles to it, as far as the
// boundary of a set of faces.
class Straight_cut
{
public:
  Straight_cut(const Progressive_mesh& pm, const Edge_lengths& lengths) : m_pm(pm), m_lengths(lengths) {}

  // The points of the line at a share in (0, 1) of the piece of a curve from point i to the next one: from the right of
  // the curve to its left. The first and the last one are on the boundary of the faces for which has(face) is true.
  // Empty if the line comes to a face again, or near a vertex. Linear in the number of points.
  template <class Has>
  std::vector<Cut_point> draw(const std::vector<Trace_point>& trace, std::size_t i, double share, const Has& has) const
  {
    const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
    std::vector<Cut_point> left, right; // where the lines leave faces
    std::unordered_set<Index> passed;
    bool is_complete = true;
    if(p.is_pivot() && q.is_pivot())
    {
      const Index h = m_pm.halfedge(p.pivot, q.pivot);
      is_complete = follow(h, share, {0, 1}, has, passed, left) &&
                    follow(m_pm.opposite(h), 1 - share, {0, 1}, has, passed, right);
      left.insert(left.begin(), {m_pm.opposite(h), 1 - share});
    }
    else
    {
      const Index f = p.is_pivot() ? m_pm.face(q.halfedge) : m_pm.face(m_pm.opposite(p.halfedge));
      const std::array<Vector2, 3> corners = unfolded(3 * f);
      const Vector2 a = boundary_point(corners, place_on_boundary(m_pm, f, p));
      const Vector2 b = boundary_point(corners, place_on_boundary(m_pm, f, q));
      const Vector2 from = (1 - share) * a + share * b, d = b - a;
      passed.insert(f);
      is_complete = leave(3 * f, corners, 3, from, {-d.y, d.x}, has, passed, left) &&
                    leave(3 * f, corners, 3, from, {d.y, -d.x}, has, passed, right);
    }
    if(!is_complete)
      return {};
    std::vector<Cut_point> cut(right.rbegin(), right.rend());
    for(const Cut_point& x : left)
      cut.push_back({m_pm.opposite(x.halfedge), 1 - x.parameter});
    return cut;
  }

private:
  // Lines that come so near to a vertex, relative to the edge, are not drawn.
  static constexpr double least_share = 1e-6;

  // The corners of the face of h, where h runs along the x axis from the origin.
  std::array<Vector2, 3> unfolded(Index h) const
  {
    const Vector3 e = vector(m_pm.point(m_pm.source(h)), m_pm.point(m_pm.target(h)));
    const Vector3 c = vector(m_pm.point(m_pm.source(h)), m_pm.point(m_pm.source(m_pm.prev(h))));
    const double length = m_lengths[h];
    return {{{0, 0}, {length, 0}, {dot(c, e) / length, norm(cross(c, e)) / length}}};
  }

  static Vector2 boundary_point(const std::array<Vector2, 3>& corners, double place)
  {
    const std::size_t i = (std::min)(static_cast<std::size_t>(place), std::size_t(2));
    const double t = place - static_cast<double>(i);
    return (1 - t) * corners[i] + t * corners[(i + 1) % 3];
  }

  // Goes on into the face of h.
  template <class Has>
  bool follow(Index h, double parameter, Vector2 direction, const Has& has, std::unordered_set<Index>& passed,
              std::vector<Cut_point>& points) const
  {
    if(!has(m_pm.face(h)))
      return true;
    if(!passed.insert(m_pm.face(h)).second)
      return false;
    const std::array<Vector2, 3> corners = unfolded(h);
    return leave(h, corners, 0, parameter * corners[1], direction, has, passed, points);
  }

  // Goes on in the face of h to the point where the line leaves it, through another edge than the given one, counted
  // from h.
  template <class Has>
  bool leave(Index h, std::array<Vector2, 3> corners, std::size_t entered, Vector2 from, Vector2 direction,
             const Has& has, std::unordered_set<Index>& passed, std::vector<Cut_point>& points) const
  {
    for(;;)
    {
      double nearest = (std::numeric_limits<double>::infinity)();
      std::size_t exit = 3;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const Vector2 a = corners[i], e = corners[(i + 1) % 3] - a;
        const double d = cross(e, direction);
        if(i == entered || d >= 0)
          continue;
        const double distance = -cross(e, from - a) / d;
        if(distance < nearest)
        {
          nearest = distance;
          exit = i;
        }
      }
      if(exit == 3)
        return false;
      const Vector2 a = corners[exit], e = corners[(exit + 1) % 3] - a;
      const double length = norm(e), t = dot(from + nearest * direction - a, e) / dot(e, e);
      if(!(t > least_share && t < 1 - least_share))
        return false;
      Index g = h;
      for(std::size_t i = 0; i < exit; ++i)
        g = Progressive_mesh::next(g);
      points.push_back({g, t});
      // as seen from the opposite halfedge
      direction = {-dot(direction, e) / length, cross(direction, e) / length};
      h = m_pm.opposite(g);
      if(!has(m_pm.face(h)))
        return true;
      if(!passed.insert(m_pm.face(h)).second)
        return false;
      corners = unfolded(h);
      from = (1 - t) * corners[1];
      entered = 0;
    }
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_STRAIGHT_CUT_H
