// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSING_FILTER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSING_FILTER_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/crossings_of_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Homology_basis.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Where many bumps stand side by side, a closed geodesic can pass each of them on either side, and there are
// exponentially many, which cross each other. Of those that cross each other there and back one is selected, the most
// prominent. A curve that crosses this many shorter ones is one of such a family, or this many firm ones: those of some
// prominence.
constexpr std::size_t crossing_limit = 16;
constexpr std::ptrdiff_t firm_crossing_limit = 4;
constexpr double firm_prominence = 0.3;

// A coarse level tells only roughly how many: there it takes this many times as many.
constexpr double coarse_crossing_factor = 1.5;

// Tells closed geodesics of a coarse level that would hardly ever be selected, because of shorter ones that they cross:
// they cross many there and back, or they are composed of shorter ones, see `composed_constrictions()`. Curves come
// from the shortest to the longest, so that few are kept of a family of any size.
class Crossing_filter
{
public:
  Crossing_filter(const Progressive_mesh& pm, const Surface_sides& sides) : m_pm(pm), m_sides(sides) {}

  // Whether a curve with this trace passes, of which these of the curves that were kept are crossed there and back.
  // O(g^2) for genus g, and the length of the curves that its class is composed of.
  bool passes(Index i, const std::vector<Trace_point>& trace, const std::vector<Index>& crossed)
  {
    m_is_firm.resize((std::max)(m_is_firm.size(), static_cast<std::size_t>(i) + 1), false);
    m_reduced = Homology_basis::Reduced();
    const auto firm = std::count_if(crossed.begin(), crossed.end(), [&](Index j) { return m_is_firm[j]; });
    if(static_cast<double>(crossed.size()) >= coarse_crossing_factor * crossing_limit ||
       static_cast<double>(firm) >= coarse_crossing_factor * firm_crossing_limit)
      return false;
    const Parting parting = m_sides.part(trace);
    if(parting.is_separating())
      return true;
    m_reduced = m_basis.reduce(parting.homology_class);
    return !m_reduced.is_sum() || std::none_of(m_reduced.members.begin(), m_reduced.members.end(), [&](std::size_t j) {
      return std::find(crossed.begin(), crossed.end(), j) != crossed.end() ||
             !odd_crossings(m_pm, {m_basis_traces.at(j), trace})[1].empty();
    });
  }

  // Keeps the curve that has just passed, and has this prominence.
  void keep(Index i, const std::vector<Trace_point>& trace, double prominence)
  {
    m_is_firm[i] = prominence >= firm_prominence;
    if(m_reduced.is_sum())
      return;
    m_basis.add(std::move(m_reduced), i);
    m_basis_traces.emplace(i, trace);
  }

private:
  const Progressive_mesh& m_pm;
  const Surface_sides& m_sides;
  std::vector<bool> m_is_firm;                                              // by curve
  std::unordered_map<std::size_t, std::vector<Trace_point>> m_basis_traces; // by curve
  Homology_basis m_basis;
  Homology_basis::Reduced m_reduced; // class of the curve that was asked about last
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSING_FILTER_H
