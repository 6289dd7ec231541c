// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_NEIGHBOURHOOD_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_NEIGHBOURHOOD_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Front_start.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The faces around a closed curve, up to a distance on either side. Where the two sides of a curve that does not
// separate meet, the faces between them are left out, so that the curve separates what is left.
class Curve_neighbourhood
{
public:
  // Linear in the size of the mesh.
  Curve_neighbourhood(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_front(pm, lengths), m_place(pm.number_of_face_ids(), null_index)
  {}

  void start(const std::vector<Trace_point>& trace)
  {
    m_front.restart();
    for(std::size_t side = 0; side < 2; ++side)
      m_settled[side].clear();
    m_curve_faces.clear();
    Front_start left, right;
    start_front(m_pm, trace, m_front, left, right);
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
      if(p.is_pivot() && q.is_pivot())
        for(Index h = m_pm.halfedge(p.pivot, q.pivot), k = 0; k < 2; ++k, h = m_pm.opposite(h))
          m_curve_faces.push_back(m_pm.face(h));
    }
    for(const Strand& s : strands(m_pm, trace))
      m_curve_faces.push_back(s.face);
    m_pivots.clear();
    for(const Trace_point& p : trace)
      if(p.is_pivot())
        m_pivots.push_back(p.pivot);
  }

  // Takes the faces whose corners are no further from the curve than this, or than where `most` vertices of a side are.
  // A side that has no end is cut short of its furthest vertex. O(m log m) for the m faces.
  void grow(double distance, std::size_t most)
  {
    std::array<double, 2> reach = {{distance, distance}};
    for(std::size_t side = 0; side < 2; ++side)
    {
      const std::size_t other = 1 - side;
      while(m_front.next_distance(side) <= reach[side] && m_settled[side].size() < most)
      {
        // in the order of their distances, as the sides may meet
        const std::size_t next =
            m_front.next_distance(other) < m_front.next_distance(side) && m_settled[other].size() < most ? other : side;
        const Index v = m_front.settle_next(next);
        if(m_front.belongs_to(v, next))
          m_settled[next].push_back(v);
      }
      if(m_settled[side].size() >= most)
        reach[side] = (std::min)(reach[side], m_front.distance(m_settled[side].back(), side));
    }
    m_is_limited = reach[0] < distance && reach[1] < distance;
    for(bool is_taken = false; !is_taken;)
    {
      take_faces(reach);
      is_taken = true;
      for(std::size_t side = 0; side < 2; ++side)
        if(!has_end(side) && reach[side] > 0 && !m_settled[side].empty())
        {
          const double furthest = m_front.distance(m_settled[side].back(), side);
          reach[side] = (std::min)(reach[side], furthest) * share_of_closed_side;
          if(reach[side] < least_share_of_side * furthest)
            reach[side] = 0;
          is_taken = false;
        }
    }
  }

  // whether the greatest number of vertices has kept both sides from growing
  bool is_limited() const { return m_is_limited; }

  const std::vector<Index>& faces() const { return m_faces; }
  bool has(Index f) const { return m_place[f] != null_index; }
  Index place(Index f) const { return m_place[f]; } // in `faces()`

  // the faces that the curve crosses or runs along; some more than once
  const std::vector<Index>& curve_faces() const { return m_curve_faces; }

  // 0 for a face on the left of the curve, 1 on the right, 2 if the curve crosses it or has all of its corners
  std::size_t side(Index f) const
  {
    if(m_front.is_barred(f))
      return 2;
    std::array<bool, 2> belongs = {{true, true}};
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      for(std::size_t s = 0; s < 2; ++s)
        belongs[s] = belongs[s] && m_front.belongs_to(m_pm.source(h), s);
    return belongs[0] == belongs[1] ? 2 : belongs[1];
  }

private:
  // Of a side all of which is near, this share of the distance of its furthest vertex is taken.
  static constexpr double share_of_closed_side = 0.85;
  // A side of which so little is left is not taken.
  static constexpr double least_share_of_side = 0.05;

  void take(Index f)
  {
    if(m_place[f] != null_index)
      return;
    m_place[f] = static_cast<Index>(m_faces.size());
    m_faces.push_back(f);
  }

  bool is_near(Index f, std::size_t side, double reach) const
  {
    if(m_front.is_barred(f))
      return false;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(!m_front.belongs_to(m_pm.source(h), side) || m_front.distance(m_pm.source(h), side) > reach)
        return false;
    return true;
  }

  void take_faces(const std::array<double, 2>& reach)
  {
    for(Index f : m_faces)
      m_place[f] = null_index;
    m_faces.clear();
    for(Index f : m_curve_faces)
      take(f);
    for(std::size_t side = 0; side < 2; ++side)
    {
      for(Index v : m_pivots)
        take_around(v, side, reach[side]);
      for(Index v : m_settled[side])
        if(m_front.distance(v, side) <= reach[side])
          take_around(v, side, reach[side]);
    }
  }

  void take_around(Index v, std::size_t side, double reach)
  {
    const Index begin = m_pm.outgoing(v);
    Index h = begin;
    do
    {
      if(is_near(m_pm.face(h), side, reach))
        take(m_pm.face(h));
      h = m_pm.ccw(h);
    } while(h != begin);
  }

  // Whether a face of a side has a neighbour that has not been taken.
  bool has_end(std::size_t s) const
  {
    return std::any_of(m_faces.begin(), m_faces.end(), [&](Index f) {
      if(side(f) != s)
        return false;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(!has(m_pm.face(m_pm.opposite(h))))
          return true;
      return false;
    });
  }

  const Progressive_mesh& m_pm;
  Distance_front m_front;
  std::array<std::vector<Index>, 2> m_settled; // vertices by side, in the order of their distances
  std::vector<Index> m_pivots;
  std::vector<Index> m_curve_faces;
  std::vector<Index> m_faces;
  std::vector<Index> m_place; // of a face in m_faces, or null_index
  bool m_is_limited = false;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVE_NEIGHBOURHOOD_H
