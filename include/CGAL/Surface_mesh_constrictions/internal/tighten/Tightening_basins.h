// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENING_BASINS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENING_BASINS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Tightens curves one after the other, and finds out which of them end as the same curve. A step of the tightening
// depends on the curve alone, so a curve that meets the way of an earlier one has the same end, and is not tightened
// any further. Only one in eight curves on a way is remembered, chosen by its hash: two ways that have met soon pass
// the same remembered curve. On a long way it is one in as many as a sixteenth of the steps so far, so that a way of
// millions of steps needs little memory.
class Tightening_basins
{
public:
  Tightening_basins(Curve_network& network, Tightener& tightener) : m_network(network), m_tightener(tightener) {}

  // Tightens a curve. Returns the earlier curve with the same end, or the curve itself if it is the first one with this
  // end; null_index if it degenerates, and then it is left without arcs. Curves must be given in the order of their
  // ids.
  Index tighten(Index c)
  {
    m_ends.resize(static_cast<std::size_t>(c) + 1, null_index);
    Index known = null_index;
    m_pivots.resize(m_ends.size(), null_index);
    std::uint64_t steps = 0, mask = 7;
    const auto pass = [&](Index curve) {
      if(m_network.is_empty(curve))
        return true;
      m_pivots[c] = m_network.arc(m_network.curve(curve).first).from;
      if(++steps > 32 * mask)
        mask = 2 * mask + 1;
      const std::uint64_t hash = m_network.curve(curve).hash;
      if((hash & 7u) != 0)
        return false;
      const auto passed = m_passed.find(hash);
      if(passed != m_passed.end())
        known = passed->second;
      else if((hash & mask) == 0)
        m_passed.emplace(hash, curve);
      return known != null_index && known != curve;
    };
    if(!pass(c))
    {
      m_tightener.enqueue_all(c);
      m_tightener.run(pass);
    }
    m_last_pivot = m_pivots[c];
    if(m_network.is_empty(c))
      return null_index;
    if(known == null_index || known == c)
      known = m_passed.emplace(m_network.curve(c).hash, c).first->second;
    m_ends[c] = known == c ? c : m_ends[known];
    if(m_ends[c] == null_index)
    {
      m_last_pivot = m_pivots[c] = m_pivots[known];
      m_network.remove(c);
    }
    return m_ends[c];
  }

  // Of the last curve, if it degenerated: a vertex that it passed through just before.
  Index last_pivot() const { return m_last_pivot; }

private:
  Curve_network& m_network;
  Tightener& m_tightener;
  std::vector<Index> m_ends;   // by curve
  std::vector<Index> m_pivots; // by curve: one that it has passed through
  Index m_last_pivot = null_index;
  std::unordered_map<std::uint64_t, Index> m_passed; // the first curve that was ever equal to one of that hash
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENING_BASINS_H
