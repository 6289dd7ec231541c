// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Boundary_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Descents.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/pinches.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/vertex_passes.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Curves whose lengths differ by no more than this share are nearly equally long, as the holes of a plate or the
// meridians of a turned part are.
constexpr double alike_tolerance = 1e-3;

// How a search for a barrier ends.
enum class Barrier_end
{
  CURVE, // behind the barrier lies a shorter curve, or one of the same length that stands for both
  POINT, // there the curve shortens to a point
  NONE,  // there is no way to become shorter: the curve does not separate
  BEYOND // the barrier is higher than what was asked about
};

// The greatest length on the easiest way on which a curve becomes shorter, and the end of that way.
struct Barrier
{
  double length;
  Barrier_end end;
  Index curve;  // of the tightener, if `end` is CURVE
  Strip strip;  // the faces of a closed curve that shortens to it
  Index vertex; // over which it slides off, if `end` is POINT
};

// Searches the lowest barrier around a curve: over single vertices beside it and beside the curves behind them, and by
// sweeping from it. The sweep goes on at the side that has the lower barrier so far, as water rises. Now and then the
// boundary of the swept region is tightened. As long as it lies before the pass it does not become shorter than the
// curve; behind the pass it does. The result depends on the surface and the curve alone.
class Barrier_search
{
public:
  // A longer curve into whose basin a sweep has come, and the greatest length on the way there.
  struct Neighbour
  {
    Index curve;
    double barrier;
  };

  // `lengths` and `angles` of the surface. Linear in the size of the mesh.
  Barrier_search(const Progressive_mesh& pm, const Edge_lengths& lengths, const Corner_angles& angles)
    : m_sweep(pm, lengths), m_angles(angles), m_tightener(pm, angles), m_descents(m_tightener, angles),
      m_pinch_finder(pm)
  {}

  Boundary_tightener& tightener() { return m_tightener; }

  // What is called now and then during a search.
  void set_pulse(std::function<void()> pulse) { m_pulse = std::move(pulse); }

  // Searches from a simple closed geodesic with this trace, up to a length. The sides of a curve that does not separate
  // meet. Curves of the same length are looked for `with_ties` only. If the curve behind the barrier hardly holds, its
  // `Descent` is the end. O(m log m) for m faces swept, plus the tightening of O(log m) boundaries, and the same again
  // for each detour.
  Barrier search(const std::vector<Arc>& arcs, const std::vector<Trace_point>& trace, bool separates,
                 double greatest_length, bool with_ties = true, std::size_t detours = most_detours)
  {
    begin(arcs, separates, with_ties);
    return followed(lowest(trace, greatest_length, detours));
  }

  // As `search()`, but over single vertices alone; the end is NONE if no way up to the length leads over one.
  Barrier search_vertices(const std::vector<Arc>& arcs, bool separates, double greatest_length, bool with_ties = true)
  {
    begin(arcs, separates, with_ties);
    return followed(pass_vertices(greatest_length));
  }

  // The barrier around the curve from which the last search started, if a given curve of the tightener lies behind it;
  // its end is NONE if that curve is neither shorter nor stands for both.
  Barrier behind_barrier(double length, Index curve)
  {
    if(curve == m_goal || !m_tightener.is_simple(curve) || !is_lower(curve))
      return {length, Barrier_end::NONE, null_index, Strip(), null_index};
    return followed({length, Barrier_end::CURVE, curve, Strip(), null_index});
  }

  // The neighbours of the curve from which the last search started, in no order, some more than once.
  const std::vector<Neighbour>& neighbours() const { return m_all_neighbours; }

private:
  void begin(const std::vector<Arc>& arcs, bool separates, bool with_ties)
  {
    m_goal = m_tightener.enter(arcs);
    m_goal_length = m_tightener.length(m_goal);
    m_separates = separates;
    m_with_ties = with_ties;
    m_neighbours.clear();
    m_all_neighbours.clear();
  }

  // If the curve behind a barrier hardly holds, replaces it by the end of its descent.
  Barrier followed(Barrier b)
  {
    const Descent* const further = b.end == Barrier_end::CURVE ? m_descents.descent(b.curve) : nullptr;
    return further != nullptr && is_lower(*further) ? barrier(b.length, *further) : b;
  }

  static constexpr std::size_t most_detours = 16, most_alike_detours = 128, most_passes = 64;
  // No detour follows if those before it have swept more vertices than this.
  static constexpr std::size_t most_swept_by_detours = 4000000;
  // Rises that differ by less than this share of the length are equal but for rounding.
  static constexpr double equal_rise_tolerance = 1e-12;

  // A barrier of this height, with the end of the curve behind it.
  static Barrier barrier(double height, const Descent& d)
  {
    return {height, d.curve == null_index ? Barrier_end::POINT : Barrier_end::CURVE, d.curve, d.strip, d.vertex};
  }

  // The lowest barrier around the goal up to a length, and the curve right behind it.
  Barrier lowest(const std::vector<Trace_point>& trace, double greatest_length, std::size_t detours)
  {
    Barrier best = pass_vertices(greatest_length);
    if(best.length <= (1 + negligible_prominence) * m_goal_length)
      return best;
    find_pinches(trace);
    Barrier pinched = pass_pinches((std::min)(best.length, greatest_length));
    if(pinched.end != Barrier_end::NONE)
      best = std::move(pinched);
    Barrier swept = sweep(m_goal, trace, (std::min)(best.length, greatest_length));
    if(best.end == Barrier_end::NONE || (swept.end != Barrier_end::NONE && swept.length < best.length))
      best = std::move(swept);
    // Around a bend level sets fall behind on the outside. Where they have come into the basin of a longer curve, the
    // sweep from that one is better aligned; the lowest such curve first.
    // Beyond some such curves only those are passed that are nearly as short as the goal, and only for a barrier of less
    // than half the height: of equal ways the nearer one is kept.
    // Noise makes many such curves on a fine mesh, and sweeps from them go as far as the first one did.
    std::vector<Index> passed(1, m_goal);
    std::size_t swept_by_detours = 0;
    const auto is_longer = [this](const Neighbour& n) {
      return m_tightener.length(n.curve) > (1 + alike_tolerance) * m_goal_length;
    };
    for(std::size_t i = 0;
        i < (detours < most_detours ? detours : most_alike_detours) && swept_by_detours < most_swept_by_detours; ++i)
    {
      const double limit = i < detours ? best.length : m_goal_length + (best.length - m_goal_length) / 2;
      if(i >= detours)
        m_neighbours.erase(std::remove_if(m_neighbours.begin(), m_neighbours.end(), is_longer), m_neighbours.end());
      const auto lowest =
          std::min_element(m_neighbours.begin(), m_neighbours.end(),
                           [](const Neighbour& x, const Neighbour& y) { return x.barrier < y.barrier; });
      if(lowest == m_neighbours.end() || lowest->barrier >= limit)
        break;
      const Neighbour by = *lowest;
      m_neighbours.erase(lowest);
      if(std::find(passed.begin(), passed.end(), by.curve) != passed.end())
        continue;
      const Descent* const further = m_descents.descent(by.curve);
      if(further != nullptr && is_lower(*further))
      {
        const double height = (std::max)(by.barrier, further->height);
        if(height < limit)
          best = barrier(height, *further);
        continue;
      }
      passed.push_back(by.curve);
      m_barrier_before = by.barrier;
      const std::vector<Trace_point> its_trace = internal::trace(m_tightener.surface(), m_tightener.arcs(by.curve));
      find_pinches(its_trace);
      Barrier found = sweep(by.curve, its_trace, limit);
      swept_by_detours += m_sweep.number_swept();
      found.length = (std::max)(found.length, by.barrier);
      if((found.end == Barrier_end::CURVE || found.end == Barrier_end::POINT) && found.length < limit)
        best = std::move(found);
    }
    m_barrier_before = 0;
    return best;
  }

  // The easiest way found over single vertices, of no more than a length; its end is NONE if there is none. The passes
  // of the curves found are tried in the order of their heights. n vertices lead to 2^n curves, as most passes do not
  // interfere with each other. So a pass that makes the curve longer by as much as it did before is tried only once
  // more: from the curve on the way to which the most vertices have been passed.
  Barrier pass_vertices(double greatest_length)
  {
    struct Way
    {
      Index curve;
      std::size_t depth; // how many vertices have been passed on the way to the curve
      double height_before;
      Vertex_pass pass;
      double rise;
      bool is_second; // the pass is also tried from another curve

      double height() const { return (std::max)(height_before, pass.length); }
    };
    // A pass that has been tried, or will be.
    struct Tried
    {
      double rise;
      std::size_t depth; // of the second time; 0 if there was none
      bool is_done;      // whether it was tried twice
    };
    const auto is_higher = [](const Way& x, const Way& y) { return x.height() > y.height(); };
    std::vector<Way> ways; // a heap
    std::vector<Index> found(1, m_goal);
    std::unordered_map<Index, std::vector<Tried>> tried; // by vertex
    const auto find_tried = [&](Index vertex, double rise) {
      std::vector<Tried>& all = tried[vertex];
      const auto it = std::find_if(all.begin(), all.end(), [&](const Tried& t) {
        return std::abs(t.rise - rise) <= equal_rise_tolerance * m_goal_length;
      });
      return it == all.end() ? nullptr : &*it;
    };
    // of a curve that has just been led over a vertex, or null_index; the way back over that is none
    const auto add_ways = [&](Index curve, std::size_t depth, double height, Index vertex) {
      for(Vertex_pass& p : vertex_passes(m_tightener.surface(), m_angles, m_tightener.arcs(curve), greatest_length,
                                         m_tightener.puller()))
      {
        const double rise = p.length - m_tightener.length(curve);
        if(p.vertex == vertex)
          continue;
        Tried* const t = find_tried(p.vertex, rise);
        if(t == nullptr)
          tried[p.vertex].push_back({rise, 0, false});
        else if(t->is_done || depth <= t->depth)
          continue;
        else
          t->depth = depth;
        ways.push_back({curve, depth, height, std::move(p), rise, t != nullptr});
        std::push_heap(ways.begin(), ways.end(), is_higher);
      }
    };
    add_ways(m_goal, 0, 0, null_index);
    for(std::size_t i = 0; i < most_passes && !ways.empty();)
    {
      std::pop_heap(ways.begin(), ways.end(), is_higher);
      const Way way = std::move(ways.back());
      ways.pop_back();
      if(way.is_second)
      {
        Tried* const t = find_tried(way.pass.vertex, way.rise);
        if(t->is_done || t->depth != way.depth)
          continue;
        t->is_done = true;
      }
      else
        ++i;
      double height = way.height();
      Tightened_boundary b = behind(way.curve, way.height_before, way.pass, height);
      if(!b.is_simple || (b.longest == null_index && !m_separates))
        continue;
      if(is_lower(b))
        return {height, b.longest == null_index ? Barrier_end::POINT : Barrier_end::CURVE, b.longest,
                std::move(b.strip), b.longest != null_index ? null_index : way.pass.vertex};
      if(std::find(found.begin(), found.end(), b.longest) == found.end())
      {
        found.push_back(b.longest);
        add_ways(b.longest, way.depth + 1, height, way.pass.vertex);
      }
    }
    return {(std::numeric_limits<double>::infinity)(), Barrier_end::NONE, null_index, Strip(), null_index};
  }

  // Finds the pinches of a curve with this trace on both sides.
  void find_pinches(const std::vector<Trace_point>& trace)
  {
    m_pinches[0] = m_pinch_finder(trace);
    m_pinches[1] = m_pinch_finder(reversed(m_tightener.surface(), trace));
  }

  // The lowest way found over one pinch of the goal, of less than a length; its end is NONE if there is none.
  Barrier pass_pinches(double less_than)
  {
    std::vector<const Pinch*> order;
    for(const std::vector<Pinch>& side : m_pinches)
      for(const Pinch& p : side)
        order.push_back(&p);
    std::stable_sort(order.begin(), order.end(), [](const Pinch* p, const Pinch* q) { return p->rise < q->rise; });
    for(const Pinch* p : order)
    {
      const double height = m_goal_length + p->rise;
      if(!(height < less_than))
        break;
      Tightened_boundary b = m_tightener.tighten(p->parts, height, m_goal_length * (1 + equal_length_tolerance));
      if(b.is_simple && (b.longest != null_index || m_separates) && is_lower(b))
        return {height, b.longest == null_index ? Barrier_end::POINT : Barrier_end::CURVE, b.longest,
                std::move(b.strip), b.longest == null_index ? b.vertex : null_index};
    }
    return {(std::numeric_limits<double>::infinity)(), Barrier_end::NONE, null_index, Strip(), null_index};
  }

  // The curve behind a pass of a curve; sets the height of the pass. Held at the vertex and tightened the curve gets
  // shorter. If it then becomes the old curve when it is let go to the near side, the pass is no higher than that.
  Tightened_boundary behind(Index curve, double height_before, const Vertex_pass& pass, double& height)
  {
    const auto let_go = [&](const std::vector<Arc>& arcs, Curve_side side) {
      Tightened_boundary b = m_tightener.let_go(arcs, pass.vertex, side);
      if(b.longest != null_index && is_lower(b))
        b.strip = strip_beside(m_tightener.surface(), arcs, side);
      return b;
    };
    const std::vector<Arc> at_vertex = drawn_to_vertex(m_tightener.arcs(curve), pass);
    Tightened_boundary result = let_go(at_vertex, pass.far_side);
    if(height <= (1 + negligible_prominence) * m_goal_length && result.is_simple && is_lower(result))
      return result;
    const std::vector<Arc> held = m_tightener.tighten_held(at_vertex, pass.vertex);
    if(held.size() < 2 || total_length(held) >= pass.length ||
       m_tightener.let_go(held, pass.vertex, other_side(pass.far_side)).longest != curve)
      return result;
    height = (std::max)(height_before, total_length(held));
    return let_go(held, pass.far_side);
  }

  // Whether a tightened boundary is shorter than the goal, or is a curve of the same length that stands for both.
  bool is_lower(const Tightened_boundary& b) const { return is_lower(b.length, b.longest); }

  bool is_lower(Index curve) const { return is_lower(m_tightener.length(curve), curve); }

  // A point is shorter than any curve, also than one whose length is rounded to zero.
  bool is_lower(double length, Index longest) const
  {
    if(longest == null_index)
      return true;
    const double tolerance = equal_length_tolerance * m_goal_length;
    return length < m_goal_length - tolerance || (length <= m_goal_length + tolerance && m_with_ties &&
                                                  longest != m_goal && m_tightener.precedes(longest, m_goal));
  }

  // Whether a descent ends in a curve that is lower than the goal, or, if the goal separates, in a point.
  bool is_lower(const Descent& d) const { return d.curve == null_index ? m_separates : is_lower(d.curve); }

  // Searches the lowest barrier on the way from a curve to one that is shorter than the goal.
  Barrier sweep(Index start, const std::vector<Trace_point>& trace, double greatest_length)
  {
    m_start = start;
    m_length = m_tightener.length(start);
    m_lowest = {(std::numeric_limits<double>::infinity)(), Barrier_end::NONE, null_index, Strip(), null_index};
    for(std::size_t s = 0; s < 2; ++s)
    {
      // the first boundary is that of what is left when all pinches have been passed
      double rise = 0;
      for(const Pinch& p : m_pinches[s])
        rise += p.rise;
      m_sides[s].restart(m_length, m_length + rise);
    }
    m_sweep.start(trace, m_length, !m_separates);
    for(std::size_t s = 0; s < 2; ++s)
      m_sides[s].is_done = m_sides[s].is_blocked = !m_sweep.can_leave(s);
    for(;;)
    {
      std::size_t s = m_sides[1].highest() < m_sides[0].highest() ? 1 : 0;
      if(!is_climbing(s))
        s = 1 - s;
      if(!is_climbing(s))
        break;
      if(m_sides[s].highest() > greatest_length)
      {
        m_lowest = {m_sides[s].highest(), Barrier_end::BEYOND, null_index, Strip(), null_index};
        break;
      }
      climb(s);
    }
    if(m_lowest.end == Barrier_end::NONE)
      m_lowest.length = m_sides[0].is_blocked != m_sides[1].is_blocked
                            ? m_sides[m_sides[0].is_blocked ? 1 : 0].highest()
                            : (std::min)(m_sides[0].highest(), m_sides[1].highest());
    return std::move(m_lowest);
  }

  struct Side
  {
    bool is_done, is_blocked;
    std::vector<double> lengths;       // of the boundaries, by level
    std::vector<double> highest_up_to; // by level: the greatest of them so far
    double next_height;                // at which the boundary is tightened
    double peak;                       // since it was tightened last
    std::size_t next_level_below;      // from which on it is tightened if it is shorter than the curve
    std::size_t before;                // the last level at which it was found before the pass

    double highest() const { return highest_up_to.back(); }

    void restart(double length, double height)
    {
      is_done = false;
      lengths.assign(1, length);
      highest_up_to.assign(1, height);
      next_height = (1 + first_rise) * length;
      peak = length;
      next_level_below = 0;
      before = 0;
    }
  };

  // A boundary is tightened when it has risen by so much, relative to the curve, then by this many times that, and so
  // on;
  static constexpr double first_rise = 0.02;
  static constexpr double rise = 2.25;
  // and when it has fallen so far below its greatest length since that was done last.
  static constexpr double drop = 0.03;
  // The height of a pass is located to this share of the curve's length.
  static constexpr double resolution = 0.002;

  bool is_climbing(std::size_t s) const { return !m_sides[s].is_done && m_sides[s].highest() < m_lowest.length; }

  void climb(std::size_t s)
  {
    const double infinity = (std::numeric_limits<double>::infinity)();
    Side& side = m_sides[s];
    const double length = advance(s);
    const std::size_t level = m_sweep.level(s);
    const bool is_used_up = m_sweep.is_used_up(s);
    side.peak = (std::max)(side.peak, length);
    side.is_done = is_used_up;
    const bool is_below = length < m_goal_length * (1 - equal_length_tolerance);
    if(is_used_up || (is_below && level >= side.next_level_below) || side.highest() >= side.next_height ||
       length < side.peak * (1 - drop))
      look(s, level);
    if(is_below)
      side.next_level_below = level + 1 + level / 8;
    while(side.next_height <= side.highest())
    {
      const double higher = m_length + rise * (side.next_height - m_length);
      // not higher, if the length is rounded to zero, or to few bits
      side.next_height = higher > side.next_height ? higher : std::nextafter(side.highest(), infinity);
    }
  }

  double advance(std::size_t s)
  {
    Side& side = m_sides[s];
    const double length = m_sweep.advance(s);
    side.lengths.push_back(length);
    side.highest_up_to.push_back((std::max)(side.highest(), length));
    return length;
  }

  // Tightens the boundary of a side, and if that is behind the pass locates the pass.
  void look(std::size_t s, std::size_t level)
  {
    Side& side = m_sides[s];
    side.peak = 0;
    Barrier found = m_lowest;
    if(!is_behind(s, level, found))
    {
      side.before = level;
      return;
    }
    side.is_done = true;
    std::size_t behind = level;
    while(behind > side.before + 1 &&
          side.highest_up_to[behind] > side.highest_up_to[side.before] + resolution * m_length)
    {
      const std::size_t middle = side.before + (behind - side.before) / 2;
      if(is_behind(s, middle, found))
        behind = middle;
      else
        side.before = middle;
    }
    found.length = side.highest_up_to[behind];
    if(found.length < m_lowest.length)
      m_lowest = std::move(found);
  }

  // Whether the boundary of a side at a level, tightened, is shorter than the curve, or is a curve of the same length
  // that stands for both. If so, its end is written to `found`.
  bool is_behind(std::size_t s, std::size_t level, Barrier& found)
  {
    if(m_pulse)
      m_pulse();
    Tightened_boundary b = m_tightener.tighten(m_sweep.boundary(s, level), m_sides[s].lengths[level],
                                               m_length + equal_length_tolerance * m_goal_length);
    if(!b.is_simple || (b.longest == null_index && !m_separates))
      return false;
    if(!is_lower(b))
    {
      if(b.longest != m_start && b.longest != m_goal && b.length == m_tightener.length(b.longest))
      {
        m_neighbours.push_back({b.longest, (std::max)(m_sides[s].highest_up_to[level], m_barrier_before)});
        m_all_neighbours.push_back(m_neighbours.back());
      }
      return false;
    }
    found.end = b.longest == null_index ? Barrier_end::POINT : Barrier_end::CURVE;
    found.curve = b.longest;
    found.strip = std::move(b.strip);
    found.vertex = b.longest != null_index ? null_index : b.vertex != null_index ? b.vertex : m_sweep.last_vertex(s);
    return true;
  }

  Distance_sweep m_sweep;
  const Corner_angles& m_angles;
  Boundary_tightener m_tightener;
  Descents m_descents;
  Pinch_finder m_pinch_finder;
  std::array<std::vector<Pinch>, 2> m_pinches; // of the curve that is swept from, by side
  std::array<Side, 2> m_sides;
  Index m_goal = null_index; // the curve that is to become shorter, of the tightener
  double m_goal_length = 0;
  Index m_start = null_index;          // the curve that is swept from, of the tightener
  double m_length = 0;                 // of that
  std::vector<Neighbour> m_neighbours; // to be swept from
  std::vector<Neighbour> m_all_neighbours;
  double m_barrier_before = 0; // the greatest length on the way to the curve that is swept from
  bool m_separates = true, m_with_ties = true;
  Barrier m_lowest;
  std::function<void()> m_pulse;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H
