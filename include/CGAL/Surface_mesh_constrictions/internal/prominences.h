// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Level sets whose lengths differ by less than this share are equally long.
constexpr double level_length_tolerance = 1e-9;

// The greatest length of the level sets on the way to where a curve can become shorter, and the curve that it then
// becomes; null_index if that is none of those that are known.
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
  // The curves from the shortest to the longest. Linear in the size of the mesh.
  Barrier_search(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point> >& traces,
                 const std::vector<double>& lengths)
    : m_lengths(lengths), m_sweep(pm, traces)
  {}

  // Linear, up to a logarithm, in the number of faces swept.
  Barrier operator()(Index c)
  {
    m_length = m_lengths[c];
    m_highest = {{m_length, m_length}};
    m_state = {{State::CLIMBING, State::CLIMBING}};
    m_lowest = {(std::numeric_limits<double>::infinity)(), null_index};
    m_sweep.start(c, m_length);
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
        return m_lowest;
    }
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
    m_state = {{m_state[0] == State::CLIMBING ? State::CLIMBING : State::DONE,
                m_state[1] == State::CLIMBING ? State::CLIMBING : State::DONE}};
    m_state[s] = State::FALLING;
  }

  void fall(std::size_t s)
  {
    const double length = m_sweep.advance(s);
    take_dominating();
    if(m_lowest.dominating != null_index || length > m_highest[s] || m_sweep.is_used_up(s))
      m_state[s] = State::DONE;
  }

  // Looks for a shorter curve at which a sweep that stops there is no longer than the one that it began with.
  void take_dominating()
  {
    m_sweep.for_each_covered([&](Index a) {
      const bool both = m_sweep.crosses_start(a);
      for(std::size_t s = 0; s < 2; ++s)
      {
        const double barrier = both ? (std::max)(m_highest[0], m_highest[1]) : m_highest[s];
        if(barrier > m_lowest.length || (barrier == m_lowest.length && m_lowest.dominating != null_index))
          continue;
        if(m_lengths[a] + m_sweep.rest(a, s) > m_length * (1 + level_length_tolerance))
          continue;
        m_lowest = {barrier, a};
        if(!both)
          m_state[s] = State::DONE;
      }
    });
  }

  const std::vector<double>& m_lengths;
  Distance_sweep m_sweep;
  double m_length = 0;
  std::array<double, 2> m_highest;
  std::array<State, 2> m_state;
  Barrier m_lowest;
};

// A barrier relative to the curve's length, less one.
struct Prominence
{
  double value;
  Index dominated_by; // or null_index
};

inline double length(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  double sum = 0;
  for(std::size_t i = 0; i < trace.size(); ++i)
    sum += norm(position(pm, trace[(i + 1) % trace.size()]) - position(pm, trace[i]));
  return sum;
}

// Prominences of closed geodesics among each other, in their order.
inline std::vector<Prominence> prominences(const Progressive_mesh& pm,
                                           const std::vector<std::vector<Trace_point> >& traces)
{
  std::vector<double> lengths;
  for(const std::vector<Trace_point>& t : traces)
    lengths.push_back(length(pm, t));
  std::vector<Index> order(traces.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return lengths[a] < lengths[b]; });
  std::vector<std::vector<Trace_point> > sorted_traces;
  std::vector<double> sorted_lengths;
  for(Index i : order)
  {
    sorted_traces.push_back(traces[i]);
    sorted_lengths.push_back(lengths[i]);
  }
  Barrier_search search(pm, sorted_traces, sorted_lengths);
  std::vector<Prominence> result(traces.size());
  for(Index i = 0; i < order.size(); ++i)
  {
    const Barrier b = search(i);
    result[order[i]] = {b.length / sorted_lengths[i] - 1,
                        b.dominating == null_index ? null_index : order[b.dominating]};
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H
