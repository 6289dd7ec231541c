// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curve_slide.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Level sets whose lengths differ by less than this share are equally long.
constexpr double level_length_tolerance = 1e-9;

// The greatest length on the way to where a curve can become shorter, and the curve that it then becomes; null_index if
// that is none of those that are known.
struct Barrier
{
  double length;
  Index dominating;
};

// Searches the lowest barrier around a curve, by sweeping from it. The side that has the lower barrier so far is swept
// on, as water rises, so that nothing is swept that is higher than the answer.
class Barrier_search
{
public:
  // Linear in the size of the mesh.
  explicit Barrier_search(const Progressive_mesh& pm)
    : m_lengths_of_edges(pm), m_sweep(pm, m_lengths_of_edges), m_slide(pm, m_lengths_of_edges)
  {}

  // Makes a curve known to later searches. Curves are numbered in this order.
  void add_curve(const std::vector<Trace_point>& trace, double length)
  {
    m_sweep.add_curve(trace);
    m_traces.push_back(trace);
    m_lengths.push_back(length);
  }

  // The known curves that a curve crosses, there and back. Linear, up to a logarithm, in the edges that it crosses and
  // the curves that cross those.
  const std::vector<Index>& crossed_by(const std::vector<Trace_point>& trace)
  {
    m_sweep.put(trace);
    return m_sweep.crossed_by_start();
  }

  // Searches from the curve that was asked about last. Linear, up to a logarithm, in the number of faces swept.
  Barrier search(const std::vector<Trace_point>& trace, double length)
  {
    m_length = length;
    m_highest = {{length, length}};
    m_state = {{State::CLIMBING, State::CLIMBING}};
    m_lowest = {(std::numeric_limits<double>::infinity)(), null_index};
    m_sweep.start(trace, length);
    for(;;)
    {
      std::size_t s = m_highest[1] < m_highest[0] ? 1 : 0;
      if(!is_climbing(s))
        s = 1 - s;
      if(is_climbing(s))
        climb(s);
      else if(m_state[0] == State::FALLING || m_state[1] == State::FALLING)
        fall(m_state[0] == State::FALLING ? 0 : 1);
      else
        break;
    }
    if(m_lowest.dominating != null_index)
      slide();
    return m_lowest;
  }

private:
  // A side is climbing until its level sets get shorter than the curve, and then falling until it is known where to.
  enum class State { CLIMBING, FALLING, DONE };

  bool is_climbing(std::size_t s) const
  {
    return m_state[s] == State::CLIMBING && m_highest[s] < m_lowest.length;
  }

  void climb(std::size_t s)
  {
    const double length = m_sweep.advance(s);
    m_highest[s] = (std::max)(m_highest[s], length);
    take_dominating();
    if(m_state[s] != State::CLIMBING || length >= m_length * (1 - level_length_tolerance))
      return;
    m_state[s] = State::DONE;
    if(m_highest[s] >= m_lowest.length)
      return;
    m_lowest = {m_highest[s], null_index};
    if(m_state[1 - s] == State::FALLING)
      m_state[1 - s] = State::DONE;
    m_state[s] = State::FALLING;
  }

  void fall(std::size_t s)
  {
    const double length = m_sweep.advance(s);
    take_dominating();
    if(m_lowest.dominating != null_index || length > m_highest[s] || m_sweep.is_used_up(s))
      m_state[s] = State::DONE;
  }

  // Looks for a shorter curve at which a sweep that stops there is no longer than the one that it began with, and which
  // is the greater part of what is left.
  void take_dominating()
  {
    m_sweep.for_each_covered([&](Index a) {
      const bool both = m_sweep.is_beside_start(a);
      for(std::size_t s = 0; s < 2; ++s)
      {
        const double barrier = both ? (std::max)(m_highest[0], m_highest[1]) : m_highest[s];
        if(barrier > m_lowest.length || (barrier == m_lowest.length && m_lowest.dominating != null_index))
          continue;
        const double rest = m_sweep.rest(a, s);
        if(rest > m_lengths[a] || m_lengths[a] + rest > m_length * (1 + level_length_tolerance))
          continue;
        m_lowest = {barrier, a};
        m_side = s;
        if(!both)
          m_state[s] = State::DONE;
      }
    });
  }

  // Lowers the barrier to that of the direct way to the dominating curve, where that is lower.
  void slide()
  {
    const Index a = m_lowest.dominating;
    // what lies between the two has to be swept as a whole, and the vertices next to both
    for(std::size_t s = 0; s < 2; ++s)
    {
      if(m_sweep.reached(s) == 0)
        m_sweep.advance(s);
      if(s == m_side || m_sweep.is_beside_start(a))
        while(m_sweep.rest(a, m_side) > 0 && m_sweep.reached(s) < 2 * m_sweep.distance(a) && !m_sweep.is_used_up(s))
          m_sweep.advance(s);
    }
    const double direct = m_slide.greatest_length(m_sweep, a, m_traces[a], m_side);
    m_lowest.length = (std::min)(m_lowest.length, (std::max)(m_length, direct));
  }

  Edge_lengths m_lengths_of_edges;
  Distance_sweep m_sweep;
  Curve_slide m_slide;
  std::vector<std::vector<Trace_point> > m_traces;
  std::vector<double> m_lengths;
  double m_length = 0;
  std::array<double, 2> m_highest;
  std::array<State, 2> m_state;
  Barrier m_lowest;
  std::size_t m_side = 0; // on which the dominating curve lies
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BARRIER_SEARCH_H
