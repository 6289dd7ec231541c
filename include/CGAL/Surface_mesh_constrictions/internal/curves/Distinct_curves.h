// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_DISTINCT_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_DISTINCT_CURVES_H

#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>

#include <cstdint>
#include <unordered_map>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The curves of a network by their combinatorics, to notice when two become the same.
class Distinct_curves
{
public:
  explicit Distinct_curves(Curve_network& network) : m_network(network) {}

  // Forgets a curve that is going to change.
  void remove(Index c)
  {
    const auto range = m_curves.equal_range(m_network.curve(c).hash);
    for(auto it = range.first; it != range.second; ++it)
      if(it->second == c)
      {
        m_curves.erase(it);
        return;
      }
  }

  // Notes a curve and returns it; or, if an equal one is known, merges the curve into that and returns that.
  // Constant but for hash collisions and for the comparison with an equal curve.
  Index insert(Index c)
  {
    const std::uint64_t hash = m_network.curve(c).hash;
    const auto range = m_curves.equal_range(hash);
    for(auto it = range.first; it != range.second; ++it)
      if(m_network.are_equal(c, it->second))
      {
        m_network.merge(c, it->second);
        return it->second;
      }
    m_curves.emplace(hash, c);
    return c;
  }

private:
  Curve_network& m_network;
  std::unordered_multimap<std::uint64_t, Index> m_curves;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_DISTINCT_CURVES_H
