// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Measures the prominences of curves of a surface, several at a time. Each depends on the surface, its levels and its
// curve alone, but for rounding. On a large surface most of them are measured on a coarser level, see `Level_search`.
class Prominence_meter
{
public:
  // `levels` to measure on, the coarsest first. Linear in the size of the mesh.
  Prominence_meter(const Progressive_mesh& pm, const std::deque<Measuring_level>& levels)
    : m_pm(pm), m_lengths(pm), m_angles(pm), m_levels(levels)
  {}

  // In so many steps a curve is measured.
  static constexpr std::size_t steps_of_curve = 64;

  // Of curves, in their order. Calls on_step() with the number of steps done, one call at a time. Cost: that of
  // `Barrier_search::search()` for each.
  template <class ConcurrencyTag, class Progress>
  std::vector<Prominence> measure(const std::vector<Measured_curve>& curves, const Progress& on_step)
  {
    if(m_regions.empty())
      divide(curves);
    for(Region& r : m_regions)
      r.curves.clear();
    for(std::size_t i = 0; i < curves.size(); ++i)
      region(curves[i]).curves.push_back(i);
    std::vector<Prominence> result(curves.size());
    std::mutex mutex;
    std::size_t done = 0;
    const auto add_steps = [&](std::size_t n) {
      const std::lock_guard<std::mutex> lock(mutex);
      on_step(done += n);
    };
    CGAL::for_each<ConcurrencyTag>(m_regions, [&](Region& r) {
      if(r.curves.empty())
        return true;
      if(!r.searches)
        r.searches.emplace(m_pm, m_lengths, m_angles, m_levels);
      std::size_t left = 0; // of the steps of the curve that is measured
      r.searches->set_pulse([&] {
        if(left == 1)
          return;
        --left;
        add_steps(1);
      });
      for(const std::size_t i : r.curves)
      {
        left = steps_of_curve;
        result[i] = measure(*r.searches, curves[i]);
        add_steps(left);
      }
      r.searches->set_pulse({});
      return true;
    });
    return result;
  }

private:
  static constexpr std::size_t most_regions = 4, least_region_size = 16;
  // The barriers between curves that become one on a level are lower than this, and near: on scans subdivided to
  // 832,000 faces they are up to 0.035. If no barrier is found up to there, the prominence on the level is right.
  static constexpr double greatest_within_place = 0.05;
  static constexpr std::size_t detours_within_place = 2;

  struct Searches
  {
    Barrier_search on_input;
    Paths_to_finer_level to_input;
    std::deque<Level_search> on_levels;

    Searches(const Progressive_mesh& pm, const Edge_lengths& lengths, const Corner_angles& angles,
             const std::deque<Measuring_level>& levels)
      : on_input(pm, lengths, angles), to_input(pm)
    {
      for(auto level = levels.rbegin(); level != levels.rend(); ++level)
        on_levels.emplace_front(pm, to_input, *level, on_levels.empty() ? nullptr : &on_levels.front());
    }

    void set_pulse(const std::function<void()>& pulse)
    {
      on_input.set_pulse(pulse);
      for(Level_search& level : on_levels)
        level.set_pulse(pulse);
    }
  };

  // A part of space. The curves in it are measured by the same searches, in their order, on any number of threads. A
  // search remembers the curves that it has met, and these lie near: so each is met by few searches. It needs memory in
  // proportion to the mesh, and time to be made, so there are only a few, and they are kept.
  struct Region
  {
    double begin; // of its interval of `place()`
    std::optional<Searches> searches;
    std::vector<std::size_t> curves;

    explicit Region(double b) : begin(b) {}
  };

  // Divides space so that each region has about as many of these curves.
  void divide(const std::vector<Measured_curve>& curves)
  {
    std::array<std::vector<double>, 3> places; // by axis
    for(const Measured_curve& c : curves)
      for(m_axis = 0; m_axis < 3; ++m_axis)
        places[m_axis].push_back(place(c));
    const auto extent = [](std::vector<double>& x) {
      std::sort(x.begin(), x.end());
      return x.empty() ? 0 : x.back() - x.front();
    };
    std::array<double, 3> extents;
    std::transform(places.begin(), places.end(), extents.begin(), extent);
    m_axis = static_cast<std::size_t>(std::max_element(extents.begin(), extents.end()) - extents.begin());
    const std::vector<double>& x = places[m_axis];
    m_regions.emplace_back(-(std::numeric_limits<double>::infinity)());
    const std::size_t regions = (std::min)(x.size() / least_region_size, most_regions);
    for(std::size_t i = 1; i < regions; ++i)
      m_regions.emplace_back(x[i * x.size() / regions]);
  }

  // The centre of the box around a curve, along the axis by which space is divided.
  double place(const Measured_curve& c) const
  {
    double low = (std::numeric_limits<double>::infinity)(), high = -low;
    for(const Trace_point& p : c.trace)
    {
      const Vector3 at = position(m_pm, p);
      const double x = m_axis == 0 ? at.x : m_axis == 1 ? at.y : at.z;
      low = (std::min)(low, x);
      high = (std::max)(high, x);
    }
    return low + (high - low) / 2;
  }

  Region& region(const Measured_curve& c)
  {
    const double x = place(c);
    std::size_t i = m_regions.size() - 1;
    while(i > 0 && x < m_regions[i].begin)
      --i;
    return m_regions[i];
  }

  static Prominence measure(Searches& searches, const Measured_curve& curve)
  {
    Barrier_search& input = searches.on_input;
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    if(searches.on_levels.empty())
      return prominence(input, curve, infinity);
    if(curve.on_input || !curve.with_ties)
    {
      const Prominence p = prominence_from(input,
                                           input.search(curve.arcs, curve.trace, curve.separates,
                                                        (1 + greatest_within_place) * curve.length, curve.with_ties,
                                                        detours_within_place),
                                           curve.length);
      if(p.end != Barrier_end::BEYOND)
        return p;
    }
    const Barrier over_vertices = input.search_vertices(curve.arcs, curve.separates, infinity, curve.with_ties);
    Prominence lowest = prominence_from(input, over_vertices, curve.length);
    if(lowest.value <= negligible_prominence)
      return lowest;
    for(Level_search& level : searches.on_levels)
      if(const std::optional<Prominence> p = level.measure(input, curve))
        return lowest.end != Barrier_end::NONE && lowest.value <= p->value ? lowest : *p;
    return prominence(input, curve, infinity);
  }

  const Progressive_mesh& m_pm;
  Edge_lengths m_lengths;
  Corner_angles m_angles;
  const std::deque<Measuring_level>& m_levels;
  std::size_t m_axis = 0;
  std::deque<Region> m_regions; // in the order of their intervals
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H
