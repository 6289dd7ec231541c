// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/unfolding.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that is less prominent is not looked for by sweeps from longer ones: they slide to the same place, or nearly.
// On a tube most closed geodesics are such, and each that is looked for costs time in all later sweeps.
constexpr double negligible_prominence = 0.01;

// A barrier relative to the curve's length, less one, and what else the search found.
struct Prominence
{
  double value;
  Index dominated_by;         // or null_index
  std::vector<Index> crosses; // of the shorter curves, there and back
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
  std::vector<Index> order(traces.size()), known;
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return lengths[a] < lengths[b]; });

  Barrier_search search(pm);
  std::vector<Prominence> result(traces.size());
  for(Index i : order)
  {
    const Barrier b = search.search(traces[i], lengths[i]);
    result[i].value = b.length / lengths[i] - 1;
    result[i].dominated_by = b.dominating == null_index ? null_index : known[b.dominating];
    for(Index a : search.crossed())
      result[i].crosses.push_back(known[a]);
    if(result[i].value >= negligible_prominence)
    {
      search.add_curve(traces[i], lengths[i]);
      known.push_back(i);
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCES_H
