// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/by_length.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossed_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossing_filter.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

inline double length_of_path(const Progressive_mesh& pm, const std::vector<Index>& path)
{
  double sum = 0;
  for(std::size_t i = 0; i < path.size(); ++i)
    sum += norm(vector(pm.point(path[i]), pm.point(path[(i + 1) % path.size()])));
  return sum;
}

// A closed path of edges zigzags, and lies aslant. But for a few, a path is at most this many times as long as the
// curve that it is tightened to.
constexpr double slack_of_paths = 2.5;

// Selects closed paths of edges that may be tightened to a curve of no greater isoperimetric ratio, as far as their own
// ratios tell. path_of(i) is number i as a vector of vertices. Ascending. Linear in the paths.
template <class ConcurrencyTag, class PathOf>
std::vector<std::size_t> paths_asked_for(std::size_t number_of_paths, const PathOf& path_of, const Progressive_mesh& pm,
                                         const Surface_sides& sides, double maximum_isoperimetric_ratio)
{
  auto groups = make_groups<std::vector<std::size_t>>(number_of_paths, 512);
  CGAL::for_each<ConcurrencyTag>(groups, [&](Group<std::vector<std::size_t>>& group) {
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      const std::vector<Index> path = path_of(i);
      if(!is_too_long(length_of_path(pm, path) / slack_of_paths, sides.part(path), maximum_isoperimetric_ratio))
        group.result.push_back(i);
    }
    return true;
  });
  std::vector<std::size_t> result;
  for(const Group<std::vector<std::size_t>>& group : groups)
    result.insert(result.end(), group.result.begin(), group.result.end());
  return result;
}

// A curve that a coarse level hardly holds may be held firmly by a finer one. If its prominence is less than this, the
// coarse level does not hold it.
constexpr double least_coarse_prominence = 1e-4;

// Adds those simple closed geodesics to `result`, curves of a network with these traces, that have at least the given
// prominence and, unless `with_crossing`, pass a `Crossing_filter`. The curve that a less prominent one slides to
// stands for it, and is added to the network if it is not there: add_seed(path) enters a closed path of edges that
// shortens to it, and returns the number of that seed. If this level holds the less prominent curve at all, it is added
// itself, too, but does not count as a curve that others cross. Cost: that of `Barrier_search::search()` for each.
template <class AddSeed>
void add_prominent_curves(Curve_network& network, std::vector<Index> curves,
                          std::vector<std::vector<Trace_point>> traces, const Surface_sides& sides,
                          double minimum_prominence, bool with_crossing, const AddSeed& add_seed,
                          std::vector<Index>& result)
{
  const Progressive_mesh& pm = network.surface();
  const Edge_lengths edge_lengths(pm);
  const Corner_angles angles(pm);
  Barrier_search search(pm, edge_lengths, angles);
  std::unordered_set<Index> numbers; // of the curves, in the search
  std::vector<double> lengths;
  for(Index c : curves)
  {
    lengths.push_back(network.length(c));
    numbers.insert(search.tightener().enter(arcs_of_curve(network, c)));
  }
  Crossed_curves crossed(pm);
  Crossing_filter filter(pm, sides);
  std::vector<Index> known;
  std::vector<Index> order = by_length(lengths);
  for(std::size_t done = 0; done < order.size(); ++done)
  {
    const Index i = order[done];
    if(!with_crossing)
    {
      std::vector<Index> crosses;
      for(Index a : crossed.crossed_by(traces[i]))
        crosses.push_back(known[a]);
      if(!filter.passes(i, traces[i], crosses))
        continue;
    }
    const Measured_curve curve = {arcs_of_curve(network, curves[i]), traces[i], lengths[i],
                                  sides.part(traces[i]).is_separating(), true};
    Prominence p = prominence(search, curve, (std::max)(minimum_prominence, firm_prominence));
    if(p.value < minimum_prominence)
    {
      if(p.value >= least_coarse_prominence)
        result.push_back(curves[i]);
      std::vector<Index> path = std::move(p.path);
      if(p.end == Barrier_end::CURVE && path.size() > 2 && numbers.insert(search.tightener().enter(p.arcs)).second)
      {
        const Index c = network.add_curve(add_seed(std::move(path)));
        network.set_arcs(c, p.arcs);
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(done) + 1, static_cast<Index>(curves.size()));
        curves.push_back(c);
        traces.push_back(trace(pm, arcs_of_curve(network, c)));
        lengths.push_back(network.length(c));
      }
      continue;
    }
    result.push_back(curves[i]);
    if(!with_crossing)
    {
      crossed.add(traces[i]);
      known.push_back(i);
      filter.keep(i, traces[i], p.value);
    }
  }
}

// The numbers of the curves of a network. Ascending.
inline std::vector<Index> curves_of_network(const Curve_network& network)
{
  std::vector<Index> result;
  for(Index c = 0; c < network.number_of_curve_ids(); ++c)
    if(!network.is_empty(c))
      result.push_back(c);
  return result;
}

// The closed geodesics of a level that may be selected, as far as this level tells: those of at most this isoperimetric
// ratio and at least this prominence, and, unless `with_crossing`, only those that pass a `Crossing_filter`. Curves
// that are not simple here may be simple on a finer level, and are kept. Curves may be added, see
// `add_prominent_curves()`. Ascending. Cost: that of the areas and prominences.
template <class ConcurrencyTag, class AddSeed>
std::vector<Index> curves_asked_for(Curve_network& network, const Surface_sides& sides,
                                    double maximum_isoperimetric_ratio, double minimum_prominence, bool with_crossing,
                                    const AddSeed& add_seed)
{
  const Progressive_mesh& pm = network.surface();
  const std::vector<Index> all = curves_of_network(network);
  std::vector<Index> result, simple;
  const bool any_ratio = maximum_isoperimetric_ratio == (std::numeric_limits<double>::infinity)();
  if(any_ratio && minimum_prominence <= 0)
    return all;

  // The curves of a group that may be selected, and the traces of the simple ones among them.
  struct Candidates
  {
    std::vector<Index> simple, not_simple;
    std::vector<std::vector<Trace_point>> traces;
  };
  auto groups = make_groups<Candidates>(all.size(), 128);
  CGAL::for_each<ConcurrencyTag>(groups, [&](Group<Candidates>& group) {
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      std::vector<Trace_point> points = trace(pm, arcs_of_curve(network, all[i]));
      if(!is_simple(pm, points))
      {
        group.result.not_simple.push_back(all[i]);
        continue;
      }
      if(is_too_long(network.length(all[i]), sides.part(points), maximum_isoperimetric_ratio))
        continue;
      group.result.simple.push_back(all[i]);
      group.result.traces.push_back(std::move(points));
    }
    return true;
  });
  std::vector<std::vector<Trace_point>> traces;
  for(Group<Candidates>& group : groups)
  {
    result.insert(result.end(), group.result.not_simple.begin(), group.result.not_simple.end());
    simple.insert(simple.end(), group.result.simple.begin(), group.result.simple.end());
    std::move(group.result.traces.begin(), group.result.traces.end(), std::back_inserter(traces));
  }
  if(minimum_prominence <= 0)
    result.insert(result.end(), simple.begin(), simple.end());
  else
    add_prominent_curves(network, simple, std::move(traces), sides, minimum_prominence, with_crossing, add_seed,
                         result);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CARRY_CURVES_ASKED_FOR_H
