// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossing_filter.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightening_basins.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that is less prominent is not looked for by sweeps from longer ones: they slide to the same place, or nearly.
// On a tube most closed geodesics are such, and each that is looked for costs time in all later sweeps.
constexpr double negligible_prominence = 0.01;

// That of a curve that is not measured because of those that it crosses.
constexpr double no_prominence = -1;

// A barrier relative to the curve's length, less one, and what else the search found.
struct Prominence
{
  double value;
  Index dominated_by;         // or null_index
  std::vector<Index> crosses; // of the curves known when it was measured, there and back
};

inline double length(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  double sum = 0;
  for(std::size_t i = 0; i < trace.size(); ++i)
    sum += norm(position(pm, trace[(i + 1) % trace.size()]) - position(pm, trace[i]));
  return sum;
}

// The indices of lengths, the least first.
inline std::vector<Index> by_length(const std::vector<double>& lengths)
{
  std::vector<Index> order(lengths.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&lengths](Index a, Index b) { return lengths[a] < lengths[b]; });
  return order;
}

// Prominences of those closed geodesics for which `asked` is set, among each other; nothing is written for the others,
// which are looked for when it comes to crossings, but dominate none. If the sides of the surface are given, those that
// a `Crossing_filter` does not let pass get none. In the order of the curves.
inline void add_prominences(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point> >& traces,
                            const std::vector<bool>& asked, const Surface_sides* filtering_sides,
                            std::vector<Prominence>& result)
{
  std::vector<double> lengths;
  for(const std::vector<Trace_point>& t : traces)
    lengths.push_back(length(pm, t));
  std::vector<Index> known;
  Barrier_search search(pm);
  const auto add = [&](Index i, double length) {
    search.add_curve(traces[i], length);
    known.push_back(i);
  };
  for(Index i = 0; i < traces.size(); ++i)
    if(!asked[i])
      add(i, (std::numeric_limits<double>::infinity)());
  std::optional<Crossing_filter> filter;
  if(filtering_sides != nullptr)
    filter.emplace(pm, *filtering_sides, traces);
  for(Index i : by_length(lengths))
  {
    if(!asked[i])
      continue;
    std::vector<Index> crosses, shorter;
    for(Index a : search.crossed_by(traces[i]))
      crosses.push_back(known[a]);
    std::copy_if(crosses.begin(), crosses.end(), std::back_inserter(shorter),
                 [&](Index a) { return lengths[a] <= lengths[i]; });
    if(filter && !filter->passes(i, shorter))
    {
      result[i] = {no_prominence, null_index, {}};
      continue;
    }
    const Barrier b = search.search(traces[i], lengths[i]);
    result[i] = {b.length / lengths[i] - 1, b.dominating == null_index ? null_index : known[b.dominating],
                 std::move(crosses)};
    if(result[i].value < negligible_prominence)
      continue;
    add(i, lengths[i]);
    if(filter)
      filter->keep(i, result[i].value);
  }
}

// Prominences of closed geodesics among each other, in their order, see `add_prominences()`.
inline std::vector<Prominence> prominences(const Progressive_mesh& pm,
                                           const std::vector<std::vector<Trace_point> >& traces,
                                           const Surface_sides* filtering_sides)
{
  std::vector<Prominence> result(traces.size());
  add_prominences(pm, traces, std::vector<bool>(traces.size(), true), filtering_sides, result);
  return result;
}

// A curve is looked for on a coarse level by a closed geodesic of it that is no more than this longer or shorter.
constexpr double coarse_length_tolerance = 0.1;

// Prominences of closed geodesics of T^0 among each other, in their order. What lies between them is measured on a
// coarse level, of those that are there: where tightening leads to a simple closed geodesic of about the same length.
// Curves that are the same there have no barrier between them: the shortest dominates the others. Those that are not
// there are measured on T^0, among each other.
inline std::vector<Prominence> prominences(const Progressive_mesh& pm, const Level_copy& coarse,
                                           const std::vector<std::vector<Trace_point> >& traces,
                                           const Surface_sides* filtering_sides)
{
  std::vector<Prominence> result(traces.size());
  std::vector<double> lengths;
  for(const std::vector<Trace_point>& t : traces)
    lengths.push_back(length(pm, t));

  const Progressive_mesh& surface = coarse.surface();
  Curve_network network(surface, false);
  const Corner_angles angles(surface);
  Tightener tightener(network, Length_unit(surface), &angles);
  Tightening_basins basins(network, tightener);
  std::vector<std::vector<Trace_point> > on_coarse;
  std::vector<Index> curves; // those that are there
  std::unordered_map<Index, Index> first_in_network; // of those, by what they are there
  std::vector<bool> is_missing(traces.size(), false);
  for(Index i : by_length(lengths))
  {
    const std::vector<Index> path = coarse.path(vertices_passed(pm, traces[i]));
    const Index end = path.size() < 3 ? null_index : basins.tighten(network.add_curve(i, path));
    const auto known = end == null_index ? first_in_network.end() : first_in_network.find(end);
    if(known != first_in_network.end())
    {
      result[i] = {0, known->second, {}};
      continue;
    }
    if(end != null_index && std::abs(network.length(end) / lengths[i] - 1) <= coarse_length_tolerance)
    {
      std::vector<Trace_point> points = trace(surface, arcs_of_curve(network, end));
      if(is_simple(surface, points))
      {
        first_in_network.emplace(end, i);
        curves.push_back(i);
        on_coarse.push_back(std::move(points));
        continue;
      }
    }
    is_missing[i] = true;
  }

  std::optional<Surface_sides> sides_of_coarse;
  if(filtering_sides != nullptr)
    sides_of_coarse.emplace(surface);
  std::vector<Prominence> of_coarse =
      prominences(surface, on_coarse, sides_of_coarse ? &*sides_of_coarse : nullptr);
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    Prominence& p = result[curves[i]] = std::move(of_coarse[i]);
    if(p.dominated_by != null_index)
      p.dominated_by = curves[p.dominated_by];
    for(Index& a : p.crosses)
      a = curves[a];
  }
  if(std::find(is_missing.begin(), is_missing.end(), true) != is_missing.end())
    add_prominences(pm, traces, is_missing, filtering_sides, result);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
