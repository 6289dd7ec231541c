// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

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
  explicit Level_scale(double unit) : m_unit(unit), m_first(&first_factors()) {}

  double level(std::size_t k) const
  {
    return m_unit * (k < m_first->size() ? (*m_first)[k] : factor(k));
  }

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

// Lengths of the level sets of a piecewise linear function, by the class that each triangle is in.
class Level_lengths
{
public:
  typedef std::array<std::pair<Vector3, double>, 3> Triangle; // corners with their values

  // Forgets the lengths. What has been allocated is used again: sweeps are many and mostly small.
  void clear()
  {
    for(std::vector<double>& lengths : m_lengths)
      lengths.clear();
    for(std::vector<std::size_t>& classes : m_classes)
      classes.clear();
  }

  // The lengths of a level set in those classes in which it is longer than 0, in ascending order of the classes.
  std::vector<std::pair<std::size_t, double> > lengths(std::size_t level) const
  {
    std::vector<std::pair<std::size_t, double> > result;
    if(level >= m_classes.size())
      return result;
    for(std::size_t c : m_classes[level])
      if(m_lengths[c][level] > 0)
        result.emplace_back(c, m_lengths[c][level]);
    std::sort(result.begin(), result.end());
    return result;
  }

  // Adds the pieces of the level sets in a triangle to their lengths in its class c. Constant but for the number of
  // levels that the triangle spans.
  void add(const Level_scale& scale, Triangle t, std::size_t c)
  {
    const auto sort2 = [&](std::size_t i, std::size_t j) {
      if(t[j].second < t[i].second)
        std::swap(t[i], t[j]);
    };
    sort2(0, 1);
    sort2(1, 2);
    sort2(0, 1);
    const double low = t[0].second, middle = t[1].second, high = t[2].second;
    const std::size_t begin = scale.first_above(low);
    if(high < scale.level(begin))
      return;
    const Vector3 opposite = t[0].first + ((middle - low) / (high - low)) * (t[2].first - t[0].first);
    const double longest = norm(t[1].first - opposite);
    if(m_lengths.size() <= c)
      m_lengths.resize(c + 1);
    std::vector<double>& lengths = m_lengths[c];
    for(std::size_t k = begin;; ++k)
    {
      const double d = scale.level(k);
      if(d > high)
        return;
      if(lengths.size() <= k)
        lengths.resize(k + 1, unset);
      if(lengths[k] == unset)
      {
        lengths[k] = 0;
        if(m_classes.size() <= k)
          m_classes.resize(k + 1);
        m_classes[k].push_back(c);
      }
      lengths[k] += longest * (d < middle ? (d - low) / (middle - low)
                               : high > middle ? (high - d) / (high - middle)
                                               : 1);
    }
  }

private:
  static constexpr double unset = -1;

  std::vector<std::vector<double> > m_lengths;      // of a class, of a level
  std::vector<std::vector<std::size_t> > m_classes; // of a level, those whose length is set
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_LENGTHS_H
