// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TIE_KEY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TIE_KEY_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/splitmix64.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Of curves of equal length the one with the least key stands for all: the one with the least pivot, and of those with
// the same the one with the least sum of pseudorandom numbers of its pivots and of the edges that it crosses. Where a
// curve may pass many vertices on either side, at equal lengths, each choice changes the sum independently; so the
// least sum can be reached by steps each of which makes it smaller. Linear.
inline std::pair<Index, std::uint64_t> tie_key(const Curve_network& network, Index curve)
{
  const Progressive_mesh& pm = network.surface();
  const auto lot = [](std::uint64_t x) { return splitmix64(x) >> 32; }; // sums of these do not overflow
  std::pair<Index, std::uint64_t> key(null_index, 0);
  network.for_each_arc(curve, [&](Index a) {
    const Arc& arc = network.arc(a);
    key.first = (std::min)(key.first, arc.from);
    key.second += lot(2 * std::uint64_t(arc.from));
    for(Index h : arc.crossings)
      key.second += lot(2 * std::uint64_t(pm.edge(h)) + 1);
  });
  return key;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TIE_KEY_H
