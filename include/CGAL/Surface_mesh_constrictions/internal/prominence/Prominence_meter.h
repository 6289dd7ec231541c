// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Measures the prominences of curves of a surface, several at a time. Each depends on the surface, its levels and its
// curve alone. On a large surface most of them are measured on a coarser level, see `prominence_on_level()`.
class Prominence_meter
{
public:
  // `levels` to measure on, the coarsest first. Linear in the size of the mesh.
  Prominence_meter(const Progressive_mesh& pm, const std::deque<Measuring_level>& levels)
    : m_pm(pm), m_lengths(pm), m_angles(pm), m_levels(levels)
  {}

  // Of curves, in their order. Cost: that of `Barrier_search::search()` for each.
  template <class ConcurrencyTag>
  std::vector<Prominence> measure(const std::vector<Measured_curve>& curves)
  {
    // a search needs memory in proportion to the mesh, and time to be made, so there are only a few, and they are kept
    auto groups = make_groups<std::vector<Prominence>>(
        curves.size(), (std::max)((curves.size() + most_searches - 1) / most_searches, least_group_size));
    m_searches.resize((std::max)(m_searches.size(), groups.size()));
    CGAL::for_each<ConcurrencyTag>(groups, [&](Group<std::vector<Prominence>>& group) {
      std::optional<Searches>& searches = m_searches[static_cast<std::size_t>(&group - groups.data())];
      if(!searches)
        searches.emplace(m_pm, m_lengths, m_angles, m_levels);
      for(std::size_t i = group.begin; i < group.end; ++i)
        group.result.push_back(measure(*searches, curves[i]));
      return true;
    });
    std::vector<Prominence> result;
    for(Group<std::vector<Prominence>>& group : groups)
      std::move(group.result.begin(), group.result.end(), std::back_inserter(result));
    return result;
  }

private:
  static constexpr std::size_t most_searches = 4, least_group_size = 16;
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
      for(const Measuring_level& level : levels)
        on_levels.emplace_back(pm, to_input, level);
    }
  };

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
  std::deque<std::optional<Searches>> m_searches;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCE_METER_H
