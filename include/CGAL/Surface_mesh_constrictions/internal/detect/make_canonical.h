// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CANONICAL_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CANONICAL_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The same closed curve in the other direction, from the same start. Linear.
inline std::vector<Arc> reversed(const Progressive_mesh& pm, const std::vector<Arc>& arcs)
{
  std::vector<Arc> result;
  for(auto a = arcs.rbegin(); a != arcs.rend(); ++a)
  {
    Arc back;
    back.from = a->to;
    back.to = a->from;
    if(a->is_edge())
      back.along = pm.opposite(a->along);
    for(auto h = a->crossings.rbegin(); h != a->crossings.rend(); ++h)
      back.crossings.push_back(pm.opposite(*h));
    back.length = a->length;
    back.start_angle = a->end_angle;
    back.end_angle = a->start_angle;
    result.push_back(std::move(back));
  }
  return result;
}

// Gives a curve of a network the start and the direction that depend on its combinatorics alone, not on how it was
// found: of the sequences of pivots and of crossed edges that start at its smallest pivot, the one that comes first in
// lexicographic order. Its arcs get accurate lengths. So curves that are equal have the same arcs, and lengths that are
// equal to the bit. Linear if the smallest pivot is passed once.
inline void make_canonical(Curve_network& network, Index c)
{
  const Progressive_mesh& pm = network.surface();
  std::vector<Arc> forward = arcs_of_curve(network, c);
  if(forward.empty())
    return;
  std::vector<Arc> backward = reversed(pm, forward);
  const auto is_smaller = [](const Arc& a, const Arc& b) { return a.from < b.from; };
  const Index least = std::min_element(forward.begin(), forward.end(), is_smaller)->from;

  // the vertices that are joined and the edges that are crossed, from an arc on
  typedef std::vector<std::pair<int, Index>> Sequence;
  const auto sequence = [&pm](const std::vector<Arc>& arcs, std::size_t first) {
    Sequence s;
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      const Arc& a = arcs[(first + i) % arcs.size()];
      s.emplace_back(0, a.from);
      for(Index h : a.crossings)
        s.emplace_back(1, pm.edge(h));
    }
    return s;
  };
  std::vector<Arc>* arcs = nullptr;
  std::size_t start = 0;
  Sequence best;
  for(std::vector<Arc>* candidate : {&forward, &backward})
    for(std::size_t i = 0; i < candidate->size(); ++i)
    {
      if((*candidate)[i].from != least)
        continue;
      Sequence s = sequence(*candidate, i);
      if(arcs != nullptr && !(s < best))
        continue;
      arcs = candidate;
      start = i;
      best = std::move(s);
    }
  std::rotate(arcs->begin(), arcs->begin() + static_cast<std::ptrdiff_t>(start), arcs->end());
  for(Arc& a : *arcs)
    a.length = accurate_length(pm, a);
  network.set_arcs_in_order(c, *arcs);
}

// As above, for a curve that is going to be returned, unless its certificate names a place of it.
inline void make_canonical(Curve_network& network, Index c, const Certificate& certificate)
{
  if(certificate.is_certified() || certificate.verdict == Certificate_verdict::NOT_COMPUTED)
    make_canonical(network, c);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CANONICAL_H
