// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEAST_SUM_OF_WAVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEAST_SUM_OF_WAVES_H

#include <CGAL/Surface_mesh_constrictions/internal/prominence/Window_distances.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A convex function is nowhere less than the tangents at the ends of an interval: a lower bound of its values there.
inline double least_by_tangents(double begin, double end, double first, double last, double slope_first,
                                double slope_last)
{
  if(slope_first >= 0 || end <= begin)
    return first;
  if(slope_last <= 0)
    return last;
  const double x = (last - first + slope_first * begin - slope_last * end) / (slope_first - slope_last);
  return first + slope_first * ((std::min)((std::max)(x, begin), end) - begin);
}

// A lower bound of the least value of some waves on an interval of their edge.
inline double least_of_waves(const std::vector<Wave>& waves, double begin, double end)
{
  double least = (std::numeric_limits<double>::infinity)();
  for(const Wave& w : waves)
  {
    const double a = (std::max)(w.begin, begin), b = (std::min)(w.end, end);
    if(a <= b)
      least = (std::min)(least, least_by_tangents(a, b, w.value(a), w.value(b), w.slope(a, true), w.slope(b, false)));
  }
  return least;
}

// A lower bound, on an interval of an edge, of the sum of two distances that are given by waves. Each sum of two waves
// is convex; the bound is off by the square of the interval relative to the distances.
inline double least_sum_of_waves(const std::vector<Wave>& first, const std::vector<Wave>& second, double begin,
                                 double end)
{
  double least = (std::numeric_limits<double>::infinity)();
  for(const Wave& v : first)
    for(const Wave& w : second)
    {
      const double a = (std::max)({v.begin, w.begin, begin}), b = (std::min)({v.end, w.end, end});
      if(a > b)
        continue;
      const double at_a = v.value(a) + w.value(a), at_b = v.value(b) + w.value(b);
      if((std::min)(at_a, at_b) - 2 * (b - a) >= least) // it changes by no more than twice what one walks
        continue;
      least = (std::min)(least, least_by_tangents(a, b, at_a, at_b, v.slope(a, true) + w.slope(a, true),
                                                  v.slope(b, false) + w.slope(b, false)));
    }
  return least;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEAST_SUM_OF_WAVES_H
