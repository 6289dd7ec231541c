// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The levels of a distance at which level sets are measured: `per_unit` of them on the first stretch of one unit, and
// as many on each further factor of e, so that their number stays small however far a sweep goes.
class Level_scale
{
public:
  // A unit that is rounded to zero, or to few bits, is rounded up: distances are divided by it.
  explicit Level_scale(double unit) : m_unit((std::max)(unit, least_unit)), m_first(&first_factors()) {}

  double level(std::size_t k) const { return m_unit * (k < m_first->size() ? (*m_first)[k] : factor(k)); }

  // the first level above a distance
  std::size_t first_above(double distance) const
  {
    const double t = distance / m_unit;
    std::size_t k = static_cast<std::size_t>(std::floor(per_unit * (t <= 1 ? t : 1 + std::log(t))));
    while(level(k) <= distance)
      ++k;
    while(k > 0 && level(k - 1) > distance)
      --k;
    return k;
  }

private:
  static constexpr double per_unit = 256;
  static constexpr double least_unit = 1e-200; // in the unit of the search, so that quotients do not overflow

  static double factor(std::size_t k)
  {
    const double t = static_cast<double>(k) / per_unit;
    return t <= 1 ? t : std::exp(t - 1);
  }

  typedef std::array<double, 2048> Factors;

  // Those of nearly all levels of any sweep.
  static const Factors& first_factors()
  {
    static const Factors result = [] {
      Factors factors;
      for(std::size_t k = 0; k < factors.size(); ++k)
        factors[k] = factor(k);
      return factors;
    }();
    return result;
  }

  double m_unit;
  const Factors* m_first;
};

// Lengths of the boundaries of the sublevel sets of a function that is linear in each triangle: of its level sets, and,
// where another function ends the domain, of what they leave on that end.
class Level_lengths
{
public:
  struct Corner
  {
    Vector3 point;
    double value;
  };
  typedef std::array<Corner, 3> Triangle;

  // Forgets the lengths. What has been allocated is used again: sweeps are many and mostly small.
  void clear()
  {
    m_lengths.clear();
    m_from.clear();
    m_number_added = 0;
    m_sum = 0;
  }

  // The length at a level. Call it for levels in ascending order. Constant, amortised.
  double length(std::size_t level)
  {
    for(; m_number_added <= level && m_number_added < m_from.size(); ++m_number_added)
      m_sum += m_from[m_number_added];
    return m_sum + (level < m_lengths.size() ? m_lengths[level] : 0);
  }

  // Adds the pieces of the level sets in a triangle. Constant but for the number of levels that the triangle spans.
  void add(const Level_scale& scale, Triangle t)
  {
    sort(t);
    const double low = t[0].value, middle = t[1].value, high = t[2].value;
    const std::size_t begin = scale.first_above(low);
    if(high < scale.level(begin))
      return;
    const Vector3 opposite = t[0].point + ((middle - low) / (high - low)) * (t[2].point - t[0].point);
    const double longest = norm(t[1].point - opposite);
    for(std::size_t k = begin;; ++k)
    {
      const double d = scale.level(k);
      if(d > high)
        return;
      at(m_lengths, k) += longest * (d < middle      ? (d - low) / (middle - low)
                                     : high > middle ? (high - d) / (high - middle)
                                                     : 1);
    }
  }

  // The same where the domain is the part of the triangle in which the function is not greater than another one, which
  // has these values at its corners: the level sets in that part, and the piece of its end that lies below each level.
  void add(const Level_scale& scale, const Triangle& t, const std::array<double, 3>& others)
  {
    // the part is a triangle or a quadrilateral; its corners in order, the end between the first and the last
    std::array<Corner, 4> part;
    std::size_t n = 0;
    const auto inside = [&](std::size_t i) { return t[i % 3].value <= others[i % 3]; };
    std::size_t first = 0; // inside, after one that is not
    while(first < 3 && !(inside(first) && !inside(first + 2)))
      ++first;
    if(first == 3)
    {
      if(inside(0))
        add(scale, t);
      return;
    }
    const auto end_on_edge = [&](std::size_t i, std::size_t j) {
      const double a = others[i] - t[i].value, b = others[j] - t[j].value, s = a / (a - b);
      return Corner{t[i].point + s * (t[j].point - t[i].point), t[i].value + s * (t[j].value - t[i].value)};
    };
    part[n++] = end_on_edge(first, (first + 2) % 3);
    part[n++] = t[first];
    std::size_t last = first;
    if(inside(first + 1))
      part[n++] = t[last = (first + 1) % 3];
    part[n++] = end_on_edge(last, (last + 1) % 3);
    for(std::size_t i = 2; i < n; ++i)
      add(scale, Triangle{{part[0], part[i - 1], part[i]}});
    add_end(scale, part[0], part[n - 1]);
  }

private:
  static void sort(Triangle& t)
  {
    const auto sort2 = [&](std::size_t i, std::size_t j) {
      if(t[j].value < t[i].value)
        std::swap(t[i], t[j]);
    };
    sort2(0, 1);
    sort2(1, 2);
    sort2(0, 1);
  }

  static double& at(std::vector<double>& values, std::size_t k)
  {
    if(values.size() <= k)
      values.resize(k + 1, 0);
    return values[k];
  }

  // A segment of the end of the domain: at each level as much of it as lies below.
  void add_end(const Level_scale& scale, const Corner& a, const Corner& b)
  {
    const double low = (std::min)(a.value, b.value), high = (std::max)(a.value, b.value),
                 length = norm(b.point - a.point);
    std::size_t k = scale.first_above(low);
    for(; scale.level(k) < high; ++k)
      at(m_lengths, k) += length * (scale.level(k) - low) / (high - low);
    CGAL_assertion(k >= m_number_added);
    at(m_from, k) += length;
  }

  std::vector<double> m_lengths;  // of the level sets, by level
  std::vector<double> m_from;     // of what stays from a level on
  std::size_t m_number_added = 0; // of the levels of the latter that are in the sum
  double m_sum = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H
