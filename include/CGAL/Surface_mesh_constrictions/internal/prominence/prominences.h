// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A simple closed geodesic, and whether it separates its component of the surface.
struct Measured_curve
{
  std::vector<Arc> arcs;
  std::vector<Trace_point> trace;
  double length;
  bool separates;
  bool with_ties = true; // whether another curve of the same length may stand for it
};

// A barrier relative to the length of its curve, less one, and what lies behind it.
struct Prominence
{
  double value;
  Barrier_end end;
  std::vector<Arc> arcs; // of the shorter curve, if `end` is CURVE
  double length = 0;     // of that
  Strip strip;           // of a closed curve that shortens to it
  Index vertex;          // over which the curve slides off, if `end` is POINT
};

// The height of a barrier relative to the length of its curve, less one; no less than 0 if rounding makes it so.
inline double prominence_of_barrier(double barrier, double length) { return (std::max)(barrier / length - 1, 0.0); }

// The prominence of one curve, up to a greatest value.
inline Prominence prominence(Barrier_search& search, const Measured_curve& curve, double greatest)
{
  Barrier b = search.search(curve.arcs, curve.trace, curve.separates, (1 + greatest) * curve.length, curve.with_ties);
  Prominence result = {prominence_of_barrier(b.length, curve.length), b.end, {}, 0, std::move(b.strip), b.vertex};
  if(b.end == Barrier_end::CURVE)
  {
    result.arcs = search.tightener().arcs(b.curve);
    result.length = search.tightener().length(b.curve);
  }
  return result;
}

// Measures the prominences of curves of a surface, several at a time. Each depends on the surface and its curve alone.
class Prominence_meter
{
public:
  // Linear in the size of the mesh.
  explicit Prominence_meter(const Progressive_mesh& pm) : m_pm(pm), m_lengths(pm), m_angles(pm) {}

  // Of curves, in their order, up to a greatest value. Cost: that of `Barrier_search::search()` for each.
  template <class ConcurrencyTag>
  std::vector<Prominence> measure(const std::vector<Measured_curve>& curves, double greatest)
  {
    // a search takes memory in proportion to the mesh, and time to make, so they are few, and kept
    auto groups = make_groups<std::vector<Prominence>>(
        curves.size(), (std::max)((curves.size() + most_searches - 1) / most_searches, least_group_size));
    m_searches.resize((std::max)(m_searches.size(), groups.size()));
    CGAL::for_each<ConcurrencyTag>(groups, [&](Group<std::vector<Prominence>>& group) {
      std::optional<Barrier_search>& search = m_searches[static_cast<std::size_t>(&group - groups.data())];
      if(!search)
        search.emplace(m_pm, m_lengths, m_angles);
      for(std::size_t i = group.begin; i < group.end; ++i)
        group.result.push_back(prominence(*search, curves[i], greatest));
      return true;
    });
    std::vector<Prominence> result;
    for(Group<std::vector<Prominence>>& group : groups)
      std::move(group.result.begin(), group.result.end(), std::back_inserter(result));
    return result;
  }

private:
  static constexpr std::size_t most_searches = 4, least_group_size = 16;

  const Progressive_mesh& m_pm;
  Edge_lengths m_lengths;
  Corner_angles m_angles;
  std::deque<std::optional<Barrier_search>> m_searches;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
