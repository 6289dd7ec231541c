// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CLOSED_STRIP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CLOSED_STRIP_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A cyclic strip of faces, an annulus, that a closed curve without pivots runs through. Unfolding it along one turn
// maps its first portal by a rigid motion z -> e^(i theta) z + t to the first portal of the next turn.
class Closed_strip
{
public:
  // An end of a portal.
  struct Corner
  {
    Index vertex;
    std::size_t portal;
    Vector2 position;
    Curve_side side;
  };

  // Takes the crossed halfedges of one turn; what is crossed forth and back at once is removed. Linear.
  Closed_strip(const Progressive_mesh& pm, Strip strip) : m_pm(pm), m_strip(std::move(strip))
  {
    cancel_backtracks(pm, m_strip);
    std::size_t n = 0;
    while(2 * n + 1 < m_strip.size() && m_strip[n] == pm.opposite(m_strip[m_strip.size() - 1 - n]))
      ++n;
    m_strip.erase(m_strip.end() - static_cast<std::ptrdiff_t>(n), m_strip.end());
    m_strip.erase(m_strip.begin(), m_strip.begin() + static_cast<std::ptrdiff_t>(n));
    if(!is_degenerate())
      unfold();
  }

  // Whether the strip closes around a single vertex, or around nothing: the curve shrinks to a point.
  bool is_degenerate() const
  {
    bool one_left = true, one_right = true;
    for(Index h : m_strip)
    {
      one_left = one_left && m_pm.target(h) == m_pm.target(m_strip[0]);
      one_right = one_right && m_pm.source(h) == m_pm.source(m_strip[0]);
    }
    return one_left || one_right;
  }

  // One turn, as crossed halfedges.
  const Strip& crossings() const { return m_strip; }

  // The angle of the rotation, counterclockwise.
  double rotation() const { return m_theta; }

  // An end of a portal, as a corner.
  Corner corner(Curve_side side, std::size_t i) const
  {
    const Index h = m_strip[i];
    return Corner{side == Curve_side::LEFT ? m_pm.target(h) : m_pm.source(h), i, position(side, i), side};
  }

  // The side that the shortest curve of the strip bends around: the one that the centre of the rotation is on.
  Curve_side inner_side() const { return m_theta >= 0 ? Curve_side::LEFT : Curve_side::RIGHT; }

  // The corner of the given side that reaches furthest into the strip: of the side that the centre of the rotation is
  // on, the corner furthest from the centre. The shortest closed curve of the strip passes through it: where that curve
  // is furthest from the centre it bends around the centre, so it is at a corner of this side, and none is further.
  Corner foremost_corner(Curve_side side) const
  {
    std::size_t best = 0;
    for(std::size_t i = 1; i < m_strip.size(); ++i)
      if(reach(position(side, i), side) > reach(position(side, best), side))
        best = i;
    return corner(side, best);
  }

  // How much further the one corner lies to the left than the other, across the direction of a strip that does not
  // rotate.
  double height(const Corner& corner, const Corner& above) const
  {
    const double length = norm(m_translation);
    return length == 0 ? 0 : cross(m_translation, corner.position - above.position) / length;
  }

  // All corners, those that follow each other at one vertex taken once.
  std::vector<Corner> corners() const
  {
    std::vector<Corner> result;
    for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
      for(std::size_t i = 0; i < m_strip.size(); ++i)
        if(corner(side, i).vertex != corner(side, i == 0 ? m_strip.size() - 1 : i - 1).vertex)
          result.push_back(corner(side, i));
    return result;
  }

  // The strip of one turn from a corner on.
  Strip rotated(const Corner& base) const
  {
    Strip strip(m_strip.begin() + static_cast<std::ptrdiff_t>(base.portal), m_strip.end());
    strip.insert(strip.end(), m_strip.begin(), m_strip.begin() + static_cast<std::ptrdiff_t>(base.portal));
    return strip;
  }

  // The shortest closed curve of the strip through a corner, as arcs that start there; none if it is that point alone.
  // Linear.
  std::vector<Arc> shortest_loop(const Corner& base, String_puller& puller) const
  {
    Strip strip = rotated(base);
    std::vector<Arc> arcs;
    puller.pull(base.vertex, strip, base.vertex, arcs);
    return arcs;
  }

private:
  Vector2 position(Curve_side side, std::size_t i) const
  {
    return side == Curve_side::LEFT ? m_portals[i].left : m_portals[i].right;
  }

  // Grows with the distance from the centre c of the rotation, the side taken to be the one of the centre. Written as
  // |p|^2 / (2 |c|) - p . c / |c| because the centre goes to infinity as the rotation goes to zero.
  double reach(Vector2 p, Curve_side side) const
  {
    const double length = norm(m_translation);
    if(length == 0)
      return dot(p, p);
    const double s = side == Curve_side::LEFT ? 1 : -1, half = m_theta / 2;
    const Vector2 d = (s / length) * Vector2{-m_translation.y, m_translation.x};
    const Vector2 to_centre = {std::cos(half) * d.x + std::sin(half) * d.y,
                               -std::sin(half) * d.x + std::cos(half) * d.y};
    const double curvature = s * 2 * std::sin(half) / length;
    return curvature / 2 * dot(p, p) - dot(p, to_centre);
  }

  void unfold()
  {
    const double width = norm(vector(m_pm.point(m_pm.source(m_strip[0])), m_pm.point(m_pm.target(m_strip[0]))));
    Portal portal = {{0, width}, {0, 0}};
    for(std::size_t i = 0; i < m_strip.size(); ++i)
    {
      m_portals.push_back(portal);
      const Index crossed = m_strip[(i + 1) % m_strip.size()], o = m_pm.opposite(m_strip[i]);
      portal = next_portal(m_pm, m_strip[i], portal, unfold_apex(m_pm, m_strip[i], portal), crossed);
      m_theta += crossed == m_pm.next(o) ? -corner_angle(m_pm, crossed) : corner_angle(m_pm, o);
    }
    m_translation = portal.right;
  }

  const Progressive_mesh& m_pm;
  Strip m_strip;
  std::vector<Portal> m_portals;
  double m_theta = 0;
  Vector2 m_translation = {0, 0};
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CLOSED_STRIP_H
