// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DISTANCE_SWEEP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DISTANCE_SWEEP_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/Level_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/Side_classes.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/coincidence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Sweeps from a curve to its two sides by the level sets of the distance to it. Which side has been swept how far, how
// long the level sets were, and which other curves have been swept over.
//
// The distance is interpolated linearly in each face, so each level set is a set of closed polygons on the mesh, whose
// length is exact but for rounding, whatever the error of the distances.
class Distance_sweep
{
public:
  // Linear in the size of the mesh.
  Distance_sweep(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point> >& traces)
    : m_pm(pm), m_traces(traces), m_crossings(pm, traces), m_front(pm), m_class(pm.number_of_vertex_ids()),
      m_class_sweep(pm.number_of_vertex_ids(), 0), m_other(traces.size())
  {}

  // Starts at curve c. Other curves count if their number is less than c.
  void start(Index c, double length)
  {
    ++m_sweep;
    m_scale = Level_scale(length);
    m_front.restart();
    m_classes.restart(c);
    m_covered.clear();
    for(Side& s : m_sides)
      s = Side();
    for(Index a = 0; a < c; ++a)
      m_other[a] = {m_crossings.number_of_vertices(a), {{0, 0}}, true, false};
    classify_beside(c);
    cut_faces_along(m_traces[c]);
    start_from_pivots(m_traces[c]);
    m_sides[0].length_at_start = m_sides[1].length_at_start = length;
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
        settled(v, s);
    }
    ++side.level;
    double length = 0;
    for(std::size_t c = 0; c < side.lengths.number_of_classes(); ++c)
      length += side.lengths.length(c, side.level);
    return length;
  }

  // whether the last level set of a side was behind the furthest point
  bool is_used_up(std::size_t s) const
  {
    return m_sides[s].used_up && m_scale.level(m_sides[s].level) > m_front.reached(s);
  }

  // the curves that have been swept over as a whole, and that lie on one side of every level set but where they cross it
  template <class Function>
  void for_each_covered(const Function& f) const
  {
    for(Index c : m_covered)
    {
      bool is_behind = m_other[c].is_consistent;
      for(std::size_t s = 0; is_behind && s < 2; ++s)
        is_behind = m_other[c].furthest[s] <= m_scale.level(m_sides[s].level);
      if(is_behind)
        f(c);
    }
  }

  // whether a curve that has been swept over crosses the curve that the sweep started from, or runs so close to it that
  // there is no vertex between them
  bool crosses_start(Index curve) const { return m_other[curve].crosses_start; }

  // If the sweep stops at a curve that has been swept over, instead of going on behind it: the length of what else is
  // left of the level sets. `s` is the side on which the start, swept, would become that curve.
  double rest(Index curve, std::size_t s) const
  {
    double sum = 0;
    for(std::size_t c = 0; c < m_classes.size(); ++c)
    {
      const std::size_t side = m_classes.is_beyond(static_cast<Index>(c), curve) ? 1 - s : s;
      sum += length_in_class(c, side);
    }
    return sum;
  }

private:
  // A corner of a piece of a face that the start cuts: a vertex, or a point of the start.
  struct Corner
  {
    Index vertex; // or null_index
    Vector3 point;
  };

  struct Side
  {
    Level_lengths lengths;
    std::size_t level = 0;                   // the last that is complete
    double length_at_start = 0;
    bool used_up = false;                    // every vertex that can be reached is settled
    std::vector<Index> beside_start;         // vertices of the faces that the start cuts
    std::size_t number_settled = 0;          // of these, from the beginning of the list
    std::vector<std::array<Corner, 3> > cut; // what the start cuts these faces into
    std::deque<std::pair<Index, double> > touched; // faces and where the front was when it reached them
  };

  // Another curve.
  struct Other
  {
    std::size_t vertices_left;      // vertices beside it that are not settled
    std::array<double, 2> furthest; // of those that are, on each side
    bool is_consistent;             // whether the classes tell on which side of it a place is
    bool crosses_start;
  };

  double length_in_class(std::size_t c, std::size_t s) const
  {
    const Side& side = m_sides[s];
    if(side.level == 0)
      return c == 0 ? side.length_at_start : 0;
    return c < side.lengths.number_of_classes() ? side.lengths.length(c, side.level) : 0;
  }

  // The distance up to which the lengths of a side's level sets are complete.
  double complete(std::size_t s)
  {
    Side& side = m_sides[s];
    while(side.number_settled < side.beside_start.size() &&
          m_front.is_settled(side.beside_start[side.number_settled]))
      if(++side.number_settled == side.beside_start.size())
        add_cut_faces(s);
    if(side.used_up)
      return (std::numeric_limits<double>::infinity)();
    if(side.number_settled < side.beside_start.size())
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

  Vector3 point(Index v) const { return vector(Progressive_mesh::Point(0, 0, 0), m_pm.point(v)); }

  bool has_class(Index v) const { return m_class_sweep[v] == m_sweep; }

  void set_class(Index v, Index c)
  {
    if(has_class(v))
      check_classes(m_class[v], c);
    m_class[v] = c;
    m_class_sweep[v] = m_sweep;
  }

  // Two ways to the same place must end in the same class.
  void check_classes(Index c, Index d)
  {
    if(c == d)
      return;
    std::vector<Index> wrong;
    std::set_symmetric_difference(m_classes.curves(c).begin(), m_classes.curves(c).end(), m_classes.curves(d).begin(),
                                  m_classes.curves(d).end(), std::back_inserter(wrong));
    for(Index a : wrong)
      m_other[a].is_consistent = false;
  }

  // Classifies the vertices on both sides of the start. Class 0 is that of a vertex on its left.
  void classify_beside(Index c)
  {
    const std::vector<Index>& crossings = m_crossings.crossings(c);
    set_class(m_pm.target(crossings[0]), 0);
    for(std::size_t i = 0; i <= crossings.size(); ++i)
    {
      const Index h = crossings[i % crossings.size()];
      const Index u = m_pm.source(h), v = m_pm.target(h);
      if(has_class(v))
        set_class(u, m_classes.across(m_class[v], m_crossings.curves_at_edge(h)));
      else
        set_class(v, m_classes.across(m_class[u], m_crossings.curves_at_edge(h)));
    }
    for(Index k = 0; k < m_classes.size(); ++k)
      for(Index a : m_classes.curves(k))
        m_other[a].crosses_start = true;
  }

  // Bars the faces that the start crosses, and gives their corners their distances.
  void cut_faces_along(const std::vector<Trace_point>& trace)
  {
    std::vector<Strand> all = strands(m_pm, trace);
    std::sort(all.begin(), all.end(), [](const Strand& a, const Strand& b) { return a.face < b.face; });
    for(std::size_t i = 0; i < all.size();)
    {
      std::size_t end = i;
      while(end < all.size() && all[end].face == all[i].face)
        ++end;
      m_front.bar(all[i].face);
      cut_face(all.data() + i, all.data() + end);
      i = end;
    }
  }

  void cut_face(const Strand* begin, const Strand* end)
  {
    const Index f = begin->face;
    // walking around the face, the left side follows an exit and the right side an entry
    struct End
    {
      double place;
      std::size_t side;
      const Strand* strand;
    };
    std::vector<End> ends;
    for(const Strand* s = begin; s != end; ++s)
    {
      ends.push_back({s->exit, 0, s});
      ends.push_back({s->entry, 1, s});
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place < b.place; });
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      const End &from = ends[i], &to = ends[(i + 1) % ends.size()];
      const double last = i + 1 < ends.size() ? to.place : to.place + 3;
      Side& side = m_sides[from.side];
      const Corner start = {null_index, boundary_position(f, from.place)};
      Corner previous = {null_index, boundary_position(f, to.place)};
      for(int corner = static_cast<int>(std::ceil(last)) - 1; corner > from.place; --corner)
      {
        const Index v = m_pm.source(3 * f + static_cast<Index>(corner % 3));
        double distance = (std::numeric_limits<double>::max)();
        for(const Strand* s : {from.strand, to.strand})
          distance = (std::min)(distance, distance_to_segment(point(v), boundary_position(f, s->entry),
                                                              boundary_position(f, s->exit)));
        m_front.offer(v, distance, from.side);
        side.beside_start.push_back(v);
        side.cut.push_back({{start, Corner{v, point(v)}, previous}});
        previous = {v, point(v)};
      }
    }
  }

  Vector3 boundary_position(Index f, double place) const
  {
    const double corner = std::floor(place);
    return position(m_pm, Trace_point{null_index, 3 * f + static_cast<Index>(corner) % 3, place - corner});
  }

  // Settles the pivots of the start, and lets the front into the faces around them that the start does not cut.
  void start_from_pivots(const std::vector<Trace_point>& trace)
  {
    for(const Trace_point& p : trace)
      if(p.is_pivot())
      {
        m_front.settle_source(p.pivot);
        settled(p.pivot, Distance_front::both_sides);
      }
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      if(!trace[i].is_pivot())
        continue;
      const Pivot_fan fan = pivot_fan(m_pm, trace, i);
      std::size_t side = 0;
      Index h = fan.out;
      do {
        if(h == fan.in)
          side = 1;
        const Index f = m_pm.face(h);
        if(!m_front.is_barred(f))
        {
          m_sides[side].touched.emplace_back(f, 0.);
          m_front.pass_through(f, side);
        }
        h = m_pm.ccw(h);
      } while(h != fan.out);
    }
  }

  // The pieces of the faces that the start cuts, once their corners are settled.
  void add_cut_faces(std::size_t s)
  {
    Side& side = m_sides[s];
    for(const std::array<Corner, 3>& piece : side.cut)
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
  void settled(Index v, std::size_t s)
  {
    for(Index a : m_crossings.curves_at_vertex(v))
    {
      Other& other = m_other[a];
      if(a >= m_classes.end())
        break;
      for(std::size_t side = 0; side < 2; ++side)
        if(s == side || s == Distance_front::both_sides)
          other.furthest[side] = (std::max)(other.furthest[side], m_front.distance(v));
      if(--other.vertices_left == 0)
        m_covered.insert(std::lower_bound(m_covered.begin(), m_covered.end(), a), a);
    }
    if(s == Distance_front::both_sides)
      return;

    classify(v, s);
    Index h = m_pm.outgoing(v);
    const Index begin = h;
    do {
      const Index f = m_pm.face(h);
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

  // Classifies a vertex after a settled neighbour, and then those settled neighbours that had none.
  void classify(Index v, std::size_t s)
  {
    m_stack.assign(1, v);
    while(!m_stack.empty())
    {
      const Index u = m_stack.back();
      m_stack.pop_back();
      const Index begin = m_pm.outgoing(u);
      Index h = begin;
      for(bool more = !has_class(u); more;)
      {
        const Index w = m_pm.target(h);
        if(has_class(w) && m_front.is_settled(w, s))
          set_class(u, m_classes.across(m_class[w], m_crossings.curves_at_edge(h)));
        h = m_pm.ccw(h);
        more = !has_class(u) && h != begin;
      }
      if(!has_class(u))
        continue;
      h = begin;
      do {
        const Index w = m_pm.target(h);
        if(!has_class(w) && m_front.is_settled(w, s))
          m_stack.push_back(w);
        h = m_pm.ccw(h);
      } while(h != begin);
    }
  }

  // Adds a face whose corners are settled.
  void add_face(Index f, std::size_t s)
  {
    Level_lengths::Triangle t;
    Index c = 0;
    for(Index i = 0; i < 3; ++i)
    {
      const Index h = 3 * f + i, v = m_pm.source(h), w = m_pm.target(h);
      t[i] = {point(v), m_front.distance(v)};
      if(!has_class(v))
        continue;
      c = m_class[v];
      const Curve_crossings::Range curves = m_crossings.curves_at_edge(h);
      if(has_class(w) && (m_class[w] != c || !curves.empty()))
        check_classes(m_class[w], m_classes.across(c, curves));
    }
    m_sides[s].lengths.add(m_scale, t, c);
  }

  const Progressive_mesh& m_pm;
  const std::vector<std::vector<Trace_point> >& m_traces;
  Curve_crossings m_crossings;
  Distance_front m_front;
  Side_classes m_classes;
  std::vector<Index> m_class;       // of a vertex
  std::vector<Index> m_class_sweep; // the sweep that this was in
  std::vector<Other> m_other;
  std::vector<Index> m_covered; // in ascending order
  std::vector<Index> m_stack;
  std::array<Side, 2> m_sides;
  Level_scale m_scale{1};
  Index m_sweep = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DISTANCE_SWEEP_H
