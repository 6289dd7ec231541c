// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_SEARCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_SEARCH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Measures curves of T^0 on a coarser level. A curve is tightened on the level; the result stands for it if it lies at
// the same place and is about as long. The curve behind the barrier is led back to T^0, and must be shorter there, too. On
// the way it is tightened on the levels between: where a level is much coarser than the next, a curve lies many faces
// beside what it becomes, and has to pass every vertex between.
class Level_search
{
public:
  // `to_input` leads to T^0, `pm`; `finer` is the search on the next finer level, or null. Linear in the size of both
  // levels.
  Level_search(const Progressive_mesh& pm, Paths_to_finer_level& to_input, const Measuring_level& level,
               Level_search* finer)
    : m_pm(pm), m_to_input(to_input, level.copy), m_level(level),
      m_search(level.copy.surface(), level.lengths, level.angles), m_finer(finer)
  {
    if(finer == nullptr)
      return;
    m_paths_on_finer.emplace(finer->m_level.copy.surface());
    m_to_finer.emplace(*m_paths_on_finer, level.copy, &finer->m_level.copy);
  }

  // What is called now and then during a search.
  void set_pulse(std::function<void()> pulse) { m_search.set_pulse(std::move(pulse)); }

  // The prominence of the curve from which `input` searched last; none if this level does not hold that curve. Cost:
  // that of `Barrier_search::search()` on the level, plus that of tightening curves on T^0.
  std::optional<Prominence> measure(Barrier_search& input, const Measured_curve& curve)
  {
    Boundary_tightener& here = m_search.tightener();
    const Index c = here.tighten_path(m_level.copy.path(path_beside_curve(m_pm, curve.trace)));
    if(c == null_index || !here.is_simple(c) ||
       std::abs(here.length(c) - curve.length) > greatest_difference * curve.length)
      return std::nullopt;
    if(!lies_at(trace(here.surface(), here.arcs(c)), curve))
      return std::nullopt;
    // A curve that is shorter here by less than the error of the level may be longer on T^0: then the way goes on from
    // it. A curve that is longer here by less than that may be shorter on T^0: then the way ends there.
    double height = 0;
    for(Index at = c, steps = 0; steps < most_steps; ++steps)
    {
      const Found& found = search(at, curve.separates);
      const double height_before = height;
      height = (std::max)(height, found.barrier.length);
      std::optional<Prominence> p =
          prominence_on_input(input, curve, prominence_of_barrier(height, here.length(c)), found.barrier);
      if(p)
      {
        if(p->value >= negligible_prominence)
          p = lower_neighbour(input, curve, c, height_before, found.neighbours, *p);
        if(p->value >= negligible_prominence && has_lower(input, c))
          return std::nullopt;
        p->place = here.hash(c);
        return p;
      }
      if(found.barrier.end != Barrier_end::CURVE)
        break;
      at = found.barrier.curve;
    }
    return std::nullopt;
  }

private:
  // Of the lengths of a curve on the level and on T^0, as a share of these, and of its points, as a share of its
  // length; so many of them are looked at.
  static constexpr double greatest_difference = 0.01, greatest_distance = 0.03;
  static constexpr std::size_t number_of_points = 32;
  // The greatest number of curves that are passed on the way to one that is shorter on T^0.
  static constexpr Index most_steps = 8;

  // Whether a curve of the level lies where one of T^0 does.
  bool lies_at(const std::vector<Trace_point>& points, const Measured_curve& curve) const
  {
    std::vector<Vector3> corners;
    for(const Trace_point& p : curve.trace)
      corners.push_back(position(m_pm, p));
    const std::size_t n = corners.size(), step = (std::max)(points.size() / number_of_points, std::size_t(1));
    for(std::size_t i = 0; i < points.size(); i += step)
    {
      const Vector3 p = position(m_level.copy.surface(), points[i]);
      bool is_near = false;
      for(std::size_t j = 0; !is_near && j < n; ++j)
        is_near =
            distance_to_segment(p, corners[j], corners[j + 1 < n ? j + 1 : 0]) <= greatest_distance * curve.length;
      if(!is_near)
        return false;
    }
    return true;
  }

  // What a search has found.
  struct Found
  {
    Barrier barrier;
    std::vector<Barrier_search::Neighbour> neighbours;
  };

  // Searches from a curve of this level. Curves of T^0 that become one here come up repeatedly; it is searched once.
  const Found& search(Index c, bool separates)
  {
    const auto known = m_found.find(c);
    if(known != m_found.end())
      return known->second;
    const Boundary_tightener& here = m_search.tightener();
    Barrier barrier = m_search.search(here.arcs(c), trace(here.surface(), here.arcs(c)), separates,
                                      (std::numeric_limits<double>::infinity)());
    return m_found.emplace(c, Found{std::move(barrier), m_search.neighbours()}).first->second;
  }

  // The lowest barrier to a neighbour that is shorter on T^0, if that is lower than what has been found for a curve
  // that is number `c` here. `height_before` is the greatest length on the way to where the neighbours were met.
  Prominence lower_neighbour(Barrier_search& input, const Measured_curve& curve, Index c, double height_before,
                             std::vector<Barrier_search::Neighbour> neighbours, const Prominence& found)
  {
    const double length = m_search.tightener().length(c);
    std::sort(neighbours.begin(), neighbours.end(),
              [](const Barrier_search::Neighbour& x, const Barrier_search::Neighbour& y) {
                return std::tie(x.barrier, x.curve) < std::tie(y.barrier, y.curve);
              });
    std::vector<Index> done(1, c);
    for(const Barrier_search::Neighbour& n : neighbours)
    {
      const double value = prominence_of_barrier((std::max)(height_before, n.barrier), length);
      if(value >= found.value)
        break;
      if(m_search.tightener().length(n.curve) > length * (1 + greatest_difference) ||
         std::find(done.begin(), done.end(), n.curve) != done.end())
        continue;
      done.push_back(n.curve);
      const std::optional<Prominence> p =
          prominence_on_input(input, curve, value, {n.barrier, Barrier_end::CURVE, n.curve, Strip(), null_index});
      if(p)
        return *p;
    }
    return found;
  }

  // A curve of the level on T^0.
  struct On_input
  {
    std::vector<Index> path; // of edges, that is tightened
    Index curve;             // the number of the curve that it becomes; null_index if it shortens to a point
  };

  // A path of T^0 where number `c` of this level lies.
  std::vector<Index> path_on_input(Index c)
  {
    const Boundary_tightener& here = m_search.tightener();
    const std::vector<Index> path = path_beside_curve(here.surface(), trace(here.surface(), here.arcs(c)));
    if(m_finer != nullptr)
      if(const Index d = m_finer->m_search.tightener().tighten_path((*m_to_finer)(path)); d != null_index)
        return m_finer->path_on_input(d);
    return m_to_input(path);
  }

  // The curve that number `c` of this level becomes on T^0. Curves come up repeatedly; each is tightened once.
  const On_input& on_input(Barrier_search& input, Index c)
  {
    const auto known = m_on_input.find(c);
    if(known != m_on_input.end())
      return known->second;
    On_input there = {path_on_input(c), null_index};
    there.curve = input.tightener().tighten_path(there.path);
    return m_on_input.emplace(c, std::move(there)).first->second;
  }

  // Whether T^0 holds a curve where number `c` here lies that is lower than the one that was searched from last. The
  // barrier between them is too fine for the level.
  bool has_lower(Barrier_search& input, Index c)
  {
    const Index there = on_input(input, c).curve;
    return there != null_index && input.behind_barrier(0, there).end != Barrier_end::NONE;
  }

  // The prominence on T^0 that follows from a barrier on the level; nothing if the curve behind it is not shorter on
  // T^0.
  std::optional<Prominence> prominence_on_input(Barrier_search& input, const Measured_curve& curve, double value,
                                                const Barrier& barrier)
  {
    Prominence result = {value, barrier.end, {}, 0, {}, null_index};
    if(barrier.end == Barrier_end::POINT)
      result.vertex = m_level.copy.original(barrier.vertex);
    if(barrier.end != Barrier_end::CURVE)
      return result;
    const On_input& behind = on_input(input, barrier.curve);
    Barrier there = {0, Barrier_end::POINT, null_index, Strip(), null_index};
    if(behind.curve != null_index)
      there = input.behind_barrier(0, behind.curve);
    else if(!behind.path.empty())
      there.vertex = behind.path.front();
    if(there.end == Barrier_end::NONE ||
       (there.end == Barrier_end::POINT && (!curve.separates || there.vertex == null_index)))
      return std::nullopt;
    result.end = there.end;
    result.vertex = there.vertex;
    if(there.end == Barrier_end::CURVE)
    {
      result.path = behind.path;
      result.arcs = input.tightener().arcs(there.curve);
      result.length = input.tightener().length(there.curve);
    }
    return result;
  }

  const Progressive_mesh& m_pm;
  Paths_from_level m_to_input;
  const Measuring_level& m_level;
  Barrier_search m_search;
  Level_search* m_finer;
  std::optional<Paths_to_finer_level> m_paths_on_finer; // set if there is one
  std::optional<Paths_from_level> m_to_finer;           // likewise
  std::unordered_map<Index, Found> m_found;             // by number here
  std::unordered_map<Index, On_input> m_on_input;       // likewise
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_LEVEL_SEARCH_H
