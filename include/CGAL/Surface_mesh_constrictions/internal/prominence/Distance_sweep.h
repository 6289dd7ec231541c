// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Front_start.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Rim_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Side_classes.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Vertex_classes.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
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

// Sweeps from a curve to its two sides by the level sets of the distance to it: how long they are, and which other
// curves have been swept over.
//
// The distance is interpolated linearly in each face, so each level set is a set of closed polygons on the mesh, whose
// length is exact but for rounding, whatever the error of the distances. Where they end on a hole they are closed along
// its boundary.
class Distance_sweep
{
public:
  // Linear in the size of the mesh.
  Distance_sweep(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_lengths(lengths), m_crossings(pm), m_front(pm, lengths), m_class(pm.number_of_vertex_ids())
  {}

  // Adds a curve, given by its trace, to those that later sweeps look for.
  void add_curve(const std::vector<Trace_point>& trace) { m_crossings.add(crossings_beside_pivots(m_pm, trace)); }

  // Looks which curves a curve crosses, and puts the sweep there.
  void put(const std::vector<Trace_point>& trace)
  {
    m_class.restart(m_crossings.number_of_curves());
    m_crossed.clear();
    m_other.resize(m_crossings.number_of_curves());
    ++m_put;
    classify_beside(crossings_beside_pivots(m_pm, trace));
  }

  // Starts at the curve where the sweep was put, once.
  void start(const std::vector<Trace_point>& trace, double length)
  {
    m_scale = Level_scale(length);
    m_front.restart();
    m_without_class = 0;
    m_covered.clear();
    m_vertices.clear();
    for(Side& s : m_sides)
      s.restart();
    for(const Trace_point& p : trace)
      if(p.is_pivot())
        m_vertices.push_back(p.pivot);
    for(std::size_t i = 0; m_pm.has_boundary() && i < trace.size(); ++i)
    {
      const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
      const Index h = p.is_pivot() && q.is_pivot() ? m_pm.halfedge(p.pivot, q.pivot) : null_index;
      if(h == null_index || !m_pm.is_on_boundary(h))
        continue;
      const std::size_t s = m_pm.is_ghost_face(m_pm.face(h)) ? 0 : 1; // the side of the hole
      m_sides[s].rims.add(m_pm, m_lengths, h, 0, 0, 0);
      m_sides[1 - s].rims.take_away(m_pm, m_lengths, h);
    }
    start_front(m_pm, trace, m_front, m_sides[0].start, m_sides[1].start);
    for(Index v : m_vertices)
      note_settled(v, Distance_front::both_sides);
    for(Side& s : m_sides)
    {
      for(Index f : s.start.faces)
        s.touched.emplace_back(f, 0.);
      s.length = length;
    }
  }

  // Goes on until the next level set of a side is complete, and returns its length.
  double advance(std::size_t s)
  {
    Side& side = m_sides[s];
    while(!side.used_up && m_scale.level(side.level + 1) > complete(s))
    {
      const Index v = m_front.settle_next(s);
      if(v == null_index)
        side.used_up = true;
      else
      {
        m_vertices.push_back(v);
        note_settled(v, s);
      }
    }
    ++side.level;
    side.pieces = side.lengths.lengths(side.level);
    if(m_pm.has_boundary() && !is_used_up(s))
      side.rims.for_each(m_scale.level(side.level),
                         [&side](std::size_t c, double length) { side.pieces.emplace_back(c, length); });
    side.length = 0;
    for(const std::pair<std::size_t, double>& piece : side.pieces)
      side.length += piece.second;
    return side.length;
  }

  // whether the last level set of a side was behind the furthest point
  bool is_used_up(std::size_t s) const
  {
    return m_sides[s].used_up && m_scale.level(m_sides[s].level) > m_front.reached(s);
  }

  // the curves that have been swept over as a whole, and that part what has been swept
  template <class Function>
  void for_each_covered(const Function& f) const
  {
    const double left = reached(0), right = reached(1);
    for(Index c : m_covered)
    {
      const std::array<double, 2>& furthest = m_other[c].furthest;
      if(furthest[0] <= left && furthest[1] <= right && m_class.is_consistent(c))
        f(c);
    }
  }

  // whether a curve crosses the curve where the sweep was put, or touches it, or runs so close to it that there is no
  // vertex between them
  bool is_beside_start(Index curve) const { return m_other[curve].put == m_put && m_other[curve].is_beside_start; }

  // The curves that cross the curve where the sweep was put, and cross it back again. Those that run beside it, or
  // touch it, are no such; nor, on a surface with handles, are those that part no neighbourhood of it.
  const std::vector<Index>& crossed_by_start() const { return m_crossed; }

  // If the sweep stops at a curve that has been swept over, instead of going on behind it: the length of what else is
  // left of the level sets. `s` is the side on which the start, swept, would become that curve. Linear in the number of
  // classes that the level sets run through, up to a logarithm.
  double rest(Index curve, std::size_t s) const
  {
    const Side &near = m_sides[s], &far = m_sides[1 - s];
    return (std::max)(near.length - length_beyond(near, curve), 0.) + length_beyond(far, curve);
  }

  // the distance of the furthest point of a curve that has been swept over
  double distance(Index curve) const { return (std::max)(m_other[curve].furthest[0], m_other[curve].furthest[1]); }

  // the distance of the last level set of a side
  double reached(std::size_t s) const { return m_scale.level(m_sides[s].level); }

  // The vertices that have been reached, in no order.
  const std::vector<Index>& vertices() const { return m_vertices; }

  bool has_reached(Index v) const { return m_front.is_settled(v) && m_class.has(v); }

  // of a vertex that has been reached: positive on side s
  double signed_distance(Index v, std::size_t s) const
  {
    return m_front.is_settled(v, s) ? m_front.distance(v) : -m_front.distance(v);
  }

  // Whether a vertex that has been reached lies on the other side of a curve than where the sweep began.
  bool is_beyond(Index v, Index curve) const { return m_class.classes().is_beyond(m_class[v], curve); }

  // The halfedges that a curve crosses.
  const std::vector<Index>& crossings(Index curve) const { return m_crossings.crossings(curve); }

private:
  struct Side
  {
    Level_lengths lengths;
    Rim_lengths rims;
    std::size_t level = 0;             // the last that is complete
    double length = 0;                 // of its level set
    std::vector<std::pair<std::size_t, double> > pieces; // of that: classes and lengths
    bool used_up = false;              // every vertex that can be reached is settled
    Front_start start;
    std::size_t number_settled = 0; // of the vertices beside the start, from the beginning of the list
    std::deque<std::pair<Index, double> > touched; // faces and where the front was when it reached them

    void restart()
    {
      lengths.clear();
      rims.restart();
      level = 0;
      pieces.clear();
      used_up = false;
      start.clear();
      number_settled = 0;
      touched.clear();
    }
  };

  // Another curve.
  struct Other
  {
    std::size_t vertices_left;      // vertices beside it that are not settled
    std::array<double, 2> furthest; // of those that are, on each side
    bool is_beside_start;
    std::size_t put = 0; // how often the sweep had been put somewhere when this was known
  };

  // What is known of a curve since the sweep was put. Made when first asked for: most are far away.
  Other& other(Index curve)
  {
    Other& result = m_other[curve];
    if(result.put != m_put)
      result = {m_crossings.number_of_vertices(curve), {{0, 0}}, false, m_put};
    return result;
  }

  // The length of those pieces of a level set that lie on the other side of a curve.
  double length_beyond(const Side& side, Index curve) const
  {
    double sum = 0;
    for(const std::pair<std::size_t, double>& piece : side.pieces)
      if(m_class.classes().is_beyond(static_cast<Index>(piece.first), curve))
        sum += piece.second;
    return sum;
  }

  // The distance up to which the lengths of a side's level sets are complete.
  double complete(std::size_t s)
  {
    Side& side = m_sides[s];
    while(side.number_settled < side.start.vertices.size() &&
          m_front.is_settled(side.start.vertices[side.number_settled]))
      if(++side.number_settled == side.start.vertices.size())
        add_cut_faces(s);
    if(side.used_up)
      return (std::numeric_limits<double>::infinity)();
    if(side.number_settled < side.start.vertices.size())
      return 0;
    while(!side.touched.empty() && is_finished(side.touched.front().first, s))
      side.touched.pop_front();
    return side.touched.empty() ? m_front.reached(s) : side.touched.front().second;
  }

  // Whether all corners of a face are settled, or one belongs to the other side.
  bool is_finished(Index f, std::size_t s) const
  {
    bool all = true;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if(m_front.belongs_to_other(m_pm.source(h), s))
        return true;
      all = all && m_front.is_settled(m_pm.source(h));
    }
    return all;
  }

  // Classifies the vertices on both sides of the start. Class 0 is that of a vertex on its left.
  void classify_beside(const std::vector<Index>& crossings)
  {
    m_class.set(m_pm.target(crossings[0]), 0);
    for(std::size_t i = 0; i <= crossings.size(); ++i)
    {
      const Index h = crossings[i % crossings.size()];
      const Index u = m_pm.source(h), v = m_pm.target(h);
      if(m_class.has(v))
        m_class.set_across(u, v, m_crossings.curves_at_edge(h));
      else
        m_class.set_across(v, u, m_crossings.curves_at_edge(h));
    }
    std::array<std::vector<Index>, 2> classes; // of the vertices on the left and on the right
    for(Index h : crossings)
    {
      classes[0].push_back(m_class[m_pm.target(h)]);
      classes[1].push_back(m_class[m_pm.source(h)]);
    }
    Side_classes::Curves beside(m_crossings.number_of_curves());
    for(std::vector<Index>& c : classes)
    {
      std::sort(c.begin(), c.end());
      c.erase(std::unique(c.begin(), c.end()), c.end());
      for(Index k : c)
        beside |= m_class.classes().curves(k);
    }
    for_each_curve(beside, [&](Index a) { other(a).is_beside_start = true; });
    for_each_curve(m_class.classes().curves_between(classes[0]) & m_class.classes().curves_between(classes[1]),
                   [&](Index a) {
                     if(m_class.is_consistent(a))
                       m_crossed.push_back(a);
                   });
  }

  // The pieces of the faces that the start cuts, once their corners are settled.
  void add_cut_faces(std::size_t s)
  {
    Side& side = m_sides[s];
    for(const Front_start::Piece& piece : side.start.pieces)
    {
      Level_lengths::Triangle t;
      Index c = 0;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const bool is_vertex = piece[i].vertex != null_index;
        t[i] = {piece[i].point, is_vertex ? m_front.distance(piece[i].vertex) : 0};
        if(is_vertex)
          c = m_class[piece[i].vertex];
      }
      side.lengths.add(m_scale, t, c);
    }
  }

  // What a vertex that has just been settled makes known.
  void note_settled(Index v, std::size_t s)
  {
    for(Index a : m_crossings.curves_at_vertex(v))
    {
      Other& swept = other(a);
      for(std::size_t side = 0; side < 2; ++side)
        if(s == side || s == Distance_front::both_sides)
          swept.furthest[side] = (std::max)(swept.furthest[side], m_front.distance(v));
      if(--swept.vertices_left == 0)
        m_covered.insert(std::lower_bound(m_covered.begin(), m_covered.end(), a), a);
    }
    if(s == Distance_front::both_sides)
      return;

    classify(v, s);
    Index h = m_pm.outgoing(v);
    const Index begin = h;
    do {
      const Index f = m_pm.face(h);
      if(m_pm.has_boundary() && m_pm.is_on_boundary(h) && m_front.is_settled(m_pm.target(h)))
        note_boundary_edge(h, s);
      if(!m_front.is_barred(f))
      {
        const bool u = m_front.is_settled(m_pm.target(h), s), w = m_front.is_settled(m_pm.source(m_pm.prev(h)), s);
        if(u && w)
          add_face(f, s);
        else if(!u && !w)
          m_sides[s].touched.emplace_back(f, m_front.distance(v));
      }
      h = m_pm.ccw(h);
    } while(h != begin);
  }

  // The ends of a boundary edge are settled, its source has just been, on side s.
  void note_boundary_edge(Index h, std::size_t s)
  {
    const Index v = m_pm.source(h), w = m_pm.target(h);
    m_sides[1 - s].rims.take_away(m_pm, m_lengths, h);
    if(m_front.is_settled(w, s))
      m_sides[s].rims.add(m_pm, m_lengths, h, m_front.distance(v), m_front.distance(w),
                          m_class.has(v) ? m_class[v] : 0);
    else
      m_sides[s].rims.take_away(m_pm, m_lengths, h);
  }

  // Classifies a vertex that has just been settled after a settled neighbour, and then those settled neighbours that
  // had none when they were.
  void classify(Index v, std::size_t s)
  {
    if(!m_class.has(v) && !classify_after_neighbour(v, s))
    {
      ++m_without_class;
      return;
    }
    m_stack.assign(1, v);
    while(m_without_class > 0 && !m_stack.empty())
    {
      const Index begin = m_pm.outgoing(m_stack.back());
      m_stack.pop_back();
      Index h = begin;
      do {
        const Index w = m_pm.target(h);
        if(!m_class.has(w) && m_front.is_settled(w, s) && classify_after_neighbour(w, s))
        {
          m_stack.push_back(w);
          --m_without_class;
        }
        h = m_pm.ccw(h);
      } while(h != begin);
    }
  }

  // False if no neighbour is settled and has a class.
  bool classify_after_neighbour(Index v, std::size_t s)
  {
    const Index begin = m_pm.outgoing(v);
    Index h = begin;
    do {
      const Index w = m_pm.target(h);
      if(m_class.has(w) && m_front.is_settled(w, s))
      {
        m_class.set_across(v, w, m_crossings.curves_at_edge(h));
        return true;
      }
      h = m_pm.ccw(h);
    } while(h != begin);
    return false;
  }

  // Adds a face whose corners are settled.
  void add_face(Index f, std::size_t s)
  {
    Level_lengths::Triangle t;
    Index c = 0;
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * f + i, v = m_pm.source(h), w = m_pm.target(h);
      t[i] = {position(m_pm, v), m_front.distance(v)};
      if(!m_class.has(v))
        continue;
      c = m_class[v];
      if(m_class.has(w))
        m_class.check_across(w, v, m_crossings.curves_at_edge(h));
    }
    m_sides[s].lengths.add(m_scale, t, c);
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  Curve_crossings m_crossings;
  Distance_front m_front;
  Vertex_classes m_class; // of a vertex
  std::vector<Other> m_other;
  std::size_t m_put = 0;
  std::vector<Index> m_covered; // in ascending order
  std::vector<Index> m_crossed;
  std::vector<Index> m_vertices; // that are settled
  std::vector<Index> m_stack;
  std::size_t m_without_class = 0; // settled vertices without a settled neighbour when they were, and still
  std::array<Side, 2> m_sides;
  Level_scale m_scale{1};
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_DISTANCE_SWEEP_H
