// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Front_start.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Rim_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Sweeps from a closed curve to its two sides. The region swept on a side up to a distance is bounded by the curve and
// by closed curves that together are homologous to it: the level set of the distance, and, where the sides of a curve
// that does not separate have met, the points at the same distance from both.
//
// The distance is interpolated linearly in each face, so these are closed polygons on the mesh, whose length is exact
// but for rounding, whatever the error of the distances.
class Distance_sweep
{
public:
  Distance_sweep(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_lengths(lengths), m_front(pm, lengths), m_sides{{Side(pm, lengths), Side(pm, lengths)}},
      m_is_crossed(pm.number_of_halfedge_ids()), m_is_passed(pm.number_of_halfedge_ids())
  {}

  // Starts at a simple closed curve. Its sides meet if it does not separate.
  void start(const std::vector<Trace_point>& trace, double length, bool sides_meet)
  {
    ++m_sweep;
    m_scale = Level_scale(length);
    m_sides_meet = sides_meet;
    m_longest_edge = 0;
    m_meeting_distance = (std::numeric_limits<double>::infinity)();
    m_front.restart();
    m_crossings = crossings_beside_pivots(m_pm, trace);
    for(Index h : m_crossings)
    {
      Index& mark = m_is_crossed[m_pm.edge(h)];
      mark = mark == m_sweep ? 0 : m_sweep; // crossed twice, its ends are on the same side
    }
    for(Side& s : m_sides)
      s.restart(length);
    start_front(m_pm, trace, m_front, m_sides[0].start, m_sides[1].start);
    // where the sides meet, a face at a pivot may come to be on both of them
    for(std::size_t s = 0; s < 2; ++s)
      for(std::size_t from = 0; from < 2; ++from)
        if(from == s || m_sides_meet)
          for(Index f : m_sides[from].start.faces)
            m_sides[s].touched.emplace_back(f, 0.);
    for(const Trace_point& p : trace)
      if(p.is_pivot())
        m_sides[1].vertices.push_back(p.pivot); // it lies on the right of the crossings
    for(std::size_t i = 0; m_pm.has_boundary() && i < trace.size(); ++i)
    {
      const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
      const Index h = p.is_pivot() && q.is_pivot() ? m_pm.halfedge(p.pivot, q.pivot) : null_index;
      if(h != null_index && m_pm.is_on_boundary(h))
        m_sides[m_pm.is_ghost_face(m_pm.face(h)) ? 0 : 1].rims.add(h, 0, 0);
    }
  }

  // Whether there is a vertex on a side of the start, which has not been left yet. If not, the side is no disc, and all
  // of it lies between stretches of the start, where no boundary is found. On a surface with holes one may be there.
  bool can_leave(std::size_t s)
  {
    return m_pm.has_boundary() || m_front.next_distance(s) < (std::numeric_limits<double>::infinity)();
  }

  // Goes on until the next boundary on a side is complete, and returns its length. Both sides go on if they meet.
  double advance(std::size_t s)
  {
    Side& side = m_sides[s];
    while(!side.used_up && m_scale.level(side.level + 1) > complete(s))
    {
      const std::size_t next = m_sides_meet && m_front.next_distance(1 - s) < m_front.next_distance(s) ? 1 - s : s;
      const Index v = m_front.settle_next(next);
      if(v == null_index)
        side.used_up = true;
      else
        note_settled(v, next);
    }
    ++side.level;
    side.length = side.lengths.length(side.level);
    if(m_pm.has_boundary())
      side.length += side.rims.length(m_scale.level(side.level));
    return side.length;
  }

  // whether the last boundary of a side was behind the furthest point
  bool is_used_up(std::size_t s) const
  {
    return m_sides[s].used_up && m_scale.level(m_sides[s].level) > m_front.reached(s);
  }

  // how many levels of a side are complete
  std::size_t level(std::size_t s) const { return m_sides[s].level; }

  // how far a level is from the start
  double distance_of_level(std::size_t level) const { return m_scale.level(level); }

  // the distance up to which a side is complete
  double distance(std::size_t s) const { return m_scale.level(m_sides[s].level); }

  // The least distance of a corner of a face in which the sides have met; infinity if they have not met so far.
  double meeting_distance() const { return m_meeting_distance; }

  // how many vertices have been swept on both sides
  std::size_t number_swept() const { return m_sides[0].vertices.size() + m_sides[1].vertices.size(); }

  // the vertex that was settled last on a side; null_index if none was
  Index last_vertex(std::size_t s) const
  {
    return m_sides[s].vertices.empty() ? null_index : m_sides[s].vertices.back();
  }

  // The boundary, without the start, of the region swept on a side up to a level that is complete: the halfedges that
  // each of its closed curves crosses, in order, from their face to the opposite one. The target of each is swept, or
  // lies across the start. A halfedge from or to a ghost stands for its other end, on the rim of a hole that the curve
  // runs along. Linear in the vertices that lie as near to the start or to the boundary as the longest edge is long; in
  // all that are swept if the sides meet or the surface has holes.
  std::vector<Strip> boundary(std::size_t s, std::size_t level)
  {
    ++m_boundary;
    m_distance = m_scale.level(level);
    std::vector<Strip> strips;
    const auto follow_from = [&](Index v) {
      if(!is_swept(v, s))
        return;
      const Index begin = m_pm.outgoing(v);
      Index h = begin;
      do
      {
        if(!is_crossed(h) && !is_swept(m_pm.target(h), s))
          follow(h, s, strips);
        h = m_pm.ccw(h);
      } while(h != begin);
    };
    // in the order of their distances
    const std::vector<Index>& vertices = m_sides[s].vertices;
    const auto further_than = [&](double distance) {
      return std::partition_point(vertices.begin(), vertices.end(),
                                  [&](Index v) { return m_front.distance(v, s) <= distance; });
    };
    // All neighbours of the vertices between these are swept, as each edge leads the front on, and it is no slower.
    const double longest_step = (1 + 1e-9) * m_longest_edge;
    const bool is_far_from_others = !m_sides_meet && !m_pm.has_boundary();
    const auto begin_inside = is_far_from_others ? further_than(longest_step) : vertices.end();
    const auto end_inside = is_far_from_others ? further_than(m_distance - longest_step) : vertices.end();
    std::for_each(vertices.begin(), begin_inside, follow_from);
    std::for_each((std::max)(begin_inside, end_inside), vertices.end(), follow_from);
    for(Index crossing : m_crossings)
    {
      const Index h = s == 0 ? crossing : m_pm.opposite(crossing); // from the other side of the start
      if(is_crossed(h) && !is_swept(m_pm.target(h), s))
        follow(h, s, strips);
    }
    return strips;
  }

  // The lengths of the closed curves of the boundary of a side at a level that is complete, before the sides meet. `sum`
  // is the length of the whole boundary, as `advance()` has returned it. Of the curves that come through faces that the
  // start cuts, or along a hole, only one has a known length, and all of them are left out if there are more. Linear in
  // the swept region.
  std::vector<double> curve_lengths(std::size_t s, std::size_t level, double sum)
  {
    const double d = m_scale.level(level);
    std::vector<double> result;
    std::size_t open = 0;
    for(const Strip& strip : boundary(s, level))
    {
      const auto is_cut = [this](Index h) { return m_front.is_barred(m_pm.face(h)); };
      if(std::any_of(strip.begin(), strip.end(), is_cut))
      {
        ++open;
        continue;
      }
      double length = 0;
      Vector3 previous = level_point(strip.back(), s, d);
      for(Index h : strip)
      {
        const Vector3 p = level_point(h, s, d);
        length += norm(p - previous);
        previous = p;
      }
      result.push_back(length);
      sum -= length;
    }
    if(open == 1)
      result.push_back(sum);
    return result;
  }

private:
  // The point of an edge, with its ends in different places of the sweep, at a distance.
  Vector3 level_point(Index h, std::size_t s, double distance) const
  {
    const Index from = m_pm.source(h), to = m_pm.target(h);
    const double a = m_front.distance(from, s), b = m_front.distance(to, s);
    const Vector3 p = position(m_pm, from);
    return p + ((distance - a) / (b - a)) * (position(m_pm, to) - p);
  }

  struct Side
  {
    Side(const Progressive_mesh& pm, const Edge_lengths& edge_lengths) : rims(pm, edge_lengths) {}

    Level_lengths lengths;
    Rim_lengths rims;      // if the surface has holes
    std::size_t level = 0; // the last that is complete
    double length = 0;     // of its boundary
    bool used_up = false;  // every vertex that can be reached is settled
    Front_start start;
    std::vector<Index> vertices;                  // that belong to the side, in the order in which they were settled
    std::size_t number_settled = 0;               // of the vertices beside the start, from the beginning of the list
    std::deque<std::pair<Index, double>> touched; // faces and where the front was when it reached a corner

    void restart(double length_of_start)
    {
      lengths.clear();
      rims.restart();
      level = 0;
      length = length_of_start;
      used_up = false;
      start.clear();
      vertices.clear();
      number_settled = 0;
      touched.clear();
    }
  };

  bool is_crossed(Index h) const { return m_is_crossed[m_pm.edge(h)] == m_sweep; }

  // Whether a vertex on this side has been swept up to m_distance. A pivot lies on the right side.
  bool is_swept(Index v, std::size_t s) const
  {
    if(m_pm.is_ghost_vertex(v))
      return m_sides[s].rims.is_passed(v, m_distance);
    return m_front.belongs_to(v, s) && m_front.distance(v, s) <= m_distance && (s == 1 || !m_front.belongs_to(v, 1));
  }

  // Walks around a curve of the boundary, from a halfedge that leads out of the swept region, or across the start to an
  // unswept one. Does nothing if that halfedge was passed before.
  void follow(Index h, std::size_t s, std::vector<Strip>& strips)
  {
    if(m_is_passed[h] == m_boundary)
      return;
    strips.emplace_back();
    do
    {
      m_is_passed[h] = m_boundary;
      strips.back().push_back(m_pm.opposite(h));
      const Index next = m_pm.next(h);
      const bool is_inside = is_crossed(next) || is_swept(m_pm.target(next), s);
      h = m_pm.opposite(is_inside ? next : m_pm.prev(h));
    } while(m_is_passed[h] != m_boundary);
  }

  // The distance up to which the boundaries of a side are complete.
  double complete(std::size_t s)
  {
    Side& side = m_sides[s];
    while(side.number_settled < side.start.vertices.size() &&
          m_front.is_settled(side.start.vertices[side.number_settled], s))
      if(++side.number_settled == side.start.vertices.size())
        add_cut_faces(s);
    if(side.used_up)
      return (std::numeric_limits<double>::infinity)();
    if(side.number_settled < side.start.vertices.size())
      return 0;
    while(!side.touched.empty() && is_finished(side.touched.front().first))
      side.touched.pop_front();
    return side.touched.empty() ? m_front.reached(s) : side.touched.front().second;
  }

  // How many corners of a face are settled on a side, and how many belong to it.
  std::pair<int, int> corners(Index f, std::size_t s) const
  {
    std::pair<int, int> result(0, 0);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      result.first += m_front.is_settled(m_pm.source(h), s);
      result.second += m_front.belongs_to(m_pm.source(h), s);
    }
    return result;
  }

  // whether a face has been added to each side that one of its corners belongs to
  bool is_finished(Index f) const
  {
    const std::pair<int, int> left = corners(f, 0), right = corners(f, 1);
    return left.second == 3 || right.second == 3 || (left.first == 3 && right.first == 3);
  }

  // The pieces of the faces that the start cuts, once their corners are settled.
  void add_cut_faces(std::size_t s)
  {
    Side& side = m_sides[s];
    for(const Front_start::Piece& piece : side.start.pieces)
    {
      Level_lengths::Triangle t;
      for(std::size_t i = 0; i < 3; ++i)
        t[i] = {piece[i].point, piece[i].vertex != null_index ? m_front.distance(piece[i].vertex, s) : 0};
      side.lengths.add(m_scale, t);
    }
  }

  // Adds the faces that are complete now that a vertex has been settled on a side.
  void note_settled(Index v, std::size_t s)
  {
    if(m_front.belongs_to(v, s))
      m_sides[s].vertices.push_back(v);
    const Index begin = m_pm.outgoing(v);
    Index h = begin;
    do
    {
      const Index f = m_pm.face(h);
      m_longest_edge = (std::max)(m_longest_edge, m_lengths[h]);
      if(m_pm.has_boundary() && m_pm.is_on_boundary(h) && m_front.is_settled(m_pm.target(h), s))
        m_sides[s].rims.add(h, m_front.distance(v, s), m_front.distance(m_pm.target(h), s));
      if(!m_front.is_barred(f))
      {
        const std::pair<int, int> here = corners(f, s);
        if(here.second == 3)
          m_sides[s].lengths.add(m_scale, triangle(f, s));
        else if(here.first == 3 && corners(f, 1 - s) == std::make_pair(3, 3))
          ; // the other side's alone
        else if(here.first == 3 && corners(f, 1 - s).first == 3)
          for(std::size_t side = 0; side < 2; ++side)
          {
            m_sides[side].lengths.add(m_scale, triangle(f, side), distances(f, 1 - side));
            const std::array<double, 3> d = distances(f, side);
            m_meeting_distance = (std::min)(m_meeting_distance, *std::min_element(d.begin(), d.end()));
          }
        else
          m_sides[s].touched.emplace_back(f, m_front.reached(s));
      }
      h = m_pm.ccw(h);
    } while(h != begin);
  }

  // A face with the distances on a side.
  Level_lengths::Triangle triangle(Index f, std::size_t s) const
  {
    Level_lengths::Triangle t;
    for(Index i = 0; i < 3; ++i)
    {
      const Index v = m_pm.source(3 * f + i);
      t[i] = {position(m_pm, v), m_front.distance(v, s)};
    }
    return t;
  }

  std::array<double, 3> distances(Index f, std::size_t s) const
  {
    std::array<double, 3> result;
    for(Index i = 0; i < 3; ++i)
      result[i] = m_front.distance(m_pm.source(3 * f + i), s);
    return result;
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  Distance_front m_front;
  std::array<Side, 2> m_sides;
  std::vector<Index> m_crossings;   // of the start, moved to its left at its pivots
  Zeroed_array<Index> m_is_crossed; // the last sweep whose start crossed an edge an odd number of times
  Zeroed_array<Index> m_is_passed;  // the last boundary that was followed across a halfedge
  Index m_sweep = 0, m_boundary = 0;
  double m_longest_edge = 0; // at a vertex that has been settled
  double m_distance = 0;     // up to which a boundary is computed
  double m_meeting_distance = (std::numeric_limits<double>::infinity)();
  bool m_sides_meet = false;
  Level_scale m_scale{1};
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H
