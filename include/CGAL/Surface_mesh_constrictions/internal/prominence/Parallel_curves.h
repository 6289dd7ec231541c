// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PARALLEL_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PARALLEL_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Measures the curves of points at one distance from a closed curve, on each of its sides.
class Parallel_curves
{
public:
  Parallel_curves(const Progressive_mesh& pm, const Edge_lengths& lengths) : m_sweep(pm, lengths) {}

  // The length of the longest connected one on either side of a simple closed geodesic of this trace and length: of those
  // at every eighth level of a sweep, and of the curve itself. If the sides meet, as those of a curve that does not
  // separate do, those are left out that are further than the place where they meet first. O(n log n) for n faces,
  // plus the swept region for each of at most a few hundred levels.
  std::array<double, 2> longest(const std::vector<Trace_point>& trace, double length, bool sides_meet)
  {
    std::array<double, 2> result = {{length, length}};
    m_sweep.start(trace, length, sides_meet);
    typedef std::pair<double, std::size_t> Level; // the length of all its curves, and its number
    std::array<std::vector<Level>, 2> levels;
    for(std::size_t s = 0; s < 2; ++s)
      while(!m_sweep.is_used_up(s) && m_sweep.distance(s) < m_sweep.meeting_distance())
      {
        const double sum = m_sweep.advance(s);
        if(m_sweep.level(s) % 8 == 0)
          levels[s].emplace_back(sum, m_sweep.level(s));
      }
    for(std::size_t s = 0; s < 2; ++s)
    {
      std::sort(levels[s].rbegin(), levels[s].rend());
      for(const auto& [sum, level] : levels[s])
      {
        if(sum <= result[s])
          break; // so are all that follow
        if(m_sweep.distance_of_level(level) < m_sweep.meeting_distance())
          for(double l : m_sweep.curve_lengths(s, level, sum))
            result[s] = (std::max)(result[s], l);
      }
    }
    return result;
  }

private:
  Distance_sweep m_sweep;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PARALLEL_CURVES_H
