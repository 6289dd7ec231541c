// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_STRING_PULLER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_STRING_PULLER_H

#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A corner of less than this many radians is straight: a line that passes a vertex so close is taken through it.
constexpr double straight_tolerance = 1e-12;

// Removes from a strip what is crossed forth and back at once. Linear.
inline void cancel_backtracks(const Progressive_mesh& pm, Strip& strip)
{
  std::size_t end = 0;
  for(std::size_t i = 0; i < strip.size(); ++i)
    if(end > 0 && strip[end - 1] == pm.opposite(strip[i]))
      --end;
    else
      strip[end++] = strip[i];
  strip.resize(end);
}

inline bool is_incident(const Progressive_mesh& pm, Index h, Index v) { return pm.source(h) == v || pm.target(h) == v; }

// Makes a strip from u to w legal: no backtracks, and no crossing of an edge of u at its start or of w at its end.
inline void normalize_strip(const Progressive_mesh& pm, Index u, Strip& strip, Index w)
{
  cancel_backtracks(pm, strip);
  std::size_t begin = 0, end = strip.size();
  while(begin < end && is_incident(pm, strip[begin], u))
    ++begin;
  while(begin < end && is_incident(pm, strip[end - 1], w))
    --end;
  strip.erase(strip.begin() + static_cast<std::ptrdiff_t>(end), strip.end());
  strip.erase(strip.begin(), strip.begin() + static_cast<std::ptrdiff_t>(begin));
}

// Shortest path between two vertices inside a strip of faces: the strip is unfolded into the plane and the string
// pulled tight with a funnel (Lee and Preparata 1984).
class String_puller
{
public:
  explicit String_puller(const Progressive_mesh& pm) : m_pm(pm) {}

  // Appends to `arcs` the shortest path from u to w inside the strip, as measured arcs; none if the strip is empty and
  // u == w. The strip is normalised first. Linear in its length.
  void pull(Index u, Strip& strip, Index w, std::vector<Arc>& arcs)
  {
    normalize_strip(m_pm, u, strip, w);
    if(strip.empty())
    {
      if(u != w)
        append_arc(strip, 0, 0, u, w, arcs);
      return;
    }
    find_bends(strip, w);

    Index from = u;
    std::size_t first = 0; // the first portal that does not end at `from`
    for(const Corner& bend : m_bends)
    {
      append_arc(strip, first, bend.portal, from, bend.vertex, arcs);
      from = bend.vertex;
      first = bend.portal;
      while(first < strip.size() && is_incident(m_pm, strip[first], from))
        ++first;
    }
    append_arc(strip, first, strip.size(), from, w, arcs);
  }

private:
  // An unfolded end of portals, the first of which is number `portal`.
  struct Corner
  {
    Vector2 position;
    Index vertex;
    std::size_t portal;
  };

  // One side of the funnel: corners [head, size) from its apex outwards.
  struct Chain
  {
    std::vector<Corner> corners;
    std::size_t head = 0;

    bool empty() const { return head == corners.size(); }
    void clear()
    {
      corners.clear();
      head = 0;
    }
  };

  // Sign of the turn from a over b to c, seen from the side: positive if the path bends towards the left for
  // `sign` = 1, towards the right for `sign` = -1; 0 if it is straight but for rounding.
  int turn(Vector2 a, Vector2 b, Vector2 c, double sign) const
  {
    const Vector2 u = b - a, v = c - b;
    const double nu = std::abs(u.x) + std::abs(u.y), nv = std::abs(v.x) + std::abs(v.y);
    const double d = sign * cross(u, v), tolerance = straight_tolerance * nu * nv + 1e-15 * m_extent * (nu + nv);
    return d > tolerance ? 1 : d < -tolerance ? -1 : 0;
  }

  // Moves the end of one side of the funnel to `corner`. The side's chain turns towards its own side.
  void advance(Chain& side, Chain& other, double sign, const Corner& corner)
  {
    while(!side.empty())
    {
      const Vector2 before =
          side.corners.size() - side.head >= 2 ? side.corners[side.corners.size() - 2].position : m_apex;
      const Vector2 last = side.corners.back().position;
      const int t = turn(before, last, corner.position, sign);
      if(t > 0 || (t == 0 && dot(last - before, corner.position - last) >= 0))
        break;
      side.corners.pop_back();
    }
    if(side.empty())
    {
      side.clear();
      // the new corner lies beyond the other side: the path bends there
      while(!other.empty() && is_beyond(other.corners[other.head].position, corner.position, sign))
      {
        m_apex = other.corners[other.head].position;
        m_bends.push_back(other.corners[other.head]);
        ++other.head;
      }
    }
    side.corners.push_back(corner);
  }

  bool is_beyond(Vector2 first, Vector2 corner, double sign) const
  {
    const int t = turn(m_apex, first, corner, sign);
    if(t != 0)
      return t < 0;
    const Vector2 a = first - m_apex, b = corner - m_apex;
    return dot(a, b) >= dot(a, a);
  }

  void find_bends(const Strip& strip, Index w)
  {
    m_bends.clear();
    m_left.clear();
    m_right.clear();
    m_apex = {0, 0};
    Portal portal = portal_from_apex(m_pm, strip[0]);
    m_extent = norm(portal.left) + norm(portal.right);
    m_left.corners.push_back({portal.left, m_pm.target(strip[0]), 0});
    m_right.corners.push_back({portal.right, m_pm.source(strip[0]), 0});
    for(std::size_t i = 0;; ++i)
    {
      const Vector2 apex = unfold_apex(m_pm, strip[i], portal);
      m_extent = (std::max)(m_extent, norm(apex));
      if(i + 1 == strip.size())
      {
        const Corner end = {apex, w, strip.size()};
        advance(m_left, m_right, 1, end);
        m_left.corners.pop_back();
        m_bends.insert(m_bends.end(), m_left.corners.begin() + static_cast<std::ptrdiff_t>(m_left.head),
                       m_left.corners.end());
        return;
      }
      portal = next_portal(m_pm, strip[i], portal, apex, strip[i + 1]);
      if(strip[i + 1] == m_pm.next(m_pm.opposite(strip[i])))
        advance(m_left, m_right, 1, {apex, m_pm.target(strip[i + 1]), i + 1});
      else
        advance(m_right, m_left, -1, {apex, m_pm.source(strip[i + 1]), i + 1});
    }
  }

  // The arc from one bend to the next through portals [first, last).
  void append_arc(const Strip& strip, std::size_t first, std::size_t last, Index from, Index to,
                  std::vector<Arc>& arcs) const
  {
    Arc arc;
    arc.from = from;
    arc.to = to;
    if(first < last)
      arc.crossings.assign(strip.begin() + static_cast<std::ptrdiff_t>(first),
                           strip.begin() + static_cast<std::ptrdiff_t>(last));
    else
      arc.along = m_pm.halfedge(from, to);
    measure(m_pm, arc);
    arcs.push_back(std::move(arc));
  }

  const Progressive_mesh& m_pm;
  Chain m_left, m_right;
  std::vector<Corner> m_bends;
  Vector2 m_apex = {0, 0};
  double m_extent = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_STRING_PULLER_H
