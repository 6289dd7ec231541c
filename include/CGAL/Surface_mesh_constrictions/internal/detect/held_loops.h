// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/loops_at_vertex.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/bisect_edges.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightening_basins.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The greatest number of loops of edges that are tightened. Most of them soon meet the way of another one.
constexpr std::size_t max_held_seeds = 4096;

// Loops of edges are looked for on a surface with no fewer vertices than this.
constexpr std::size_t least_held_vertices = 4096;

// Translates a closed curve to a coarser surface, into whose faces and edges some of its vertices have been put: the
// result has arcs of that surface. The curve is led past each vertex that the coarser surface does not have, on the
// side of the smaller angle, and pulled straight between the others. Up to rounding it gets no longer. No arcs if it is
// a point. old_of(h) is the halfedge that h is a piece of, or null_index if h lies in a face. Linear in the strips of
// the curve.
template <class OldOf, class IsKept>
std::vector<Arc> arcs_without_vertices(const Progressive_mesh& fine, std::vector<Arc> loop, const OldOf& old_of,
                                       const IsKept& is_kept, const Progressive_mesh& coarse)
{
  const auto kept = std::find_if(loop.begin(), loop.end(), [&](const Arc& a) { return is_kept(a.from); });
  const bool keeps_none = kept == loop.end();
  std::rotate(loop.begin(), keeps_none ? loop.begin() : kept, loop.end());
  String_puller puller(coarse);
  std::vector<Arc> arcs;
  Strip strip;
  const auto append = [&](const auto& crossings) {
    for(Index h : crossings)
      if(const Index old = old_of(h); old != null_index)
        strip.push_back(old);
  };
  Index from = loop.front().from;
  for(std::size_t i = 0; i < loop.size(); ++i)
  {
    const Arc &arc = loop[i], &next = loop[(i + 1) % loop.size()];
    append(arc.crossings);
    if(is_kept(arc.to))
    {
      puller.pull(from, strip, arc.to, arcs);
      strip.clear();
      from = arc.to;
      continue;
    }
    const Side_angles angles = side_angles(fine, arc, next);
    Strip fan;
    append_fan(fine, arc, next, angles.left <= angles.right ? Curve_side::LEFT : Curve_side::RIGHT, fan);
    append(fan);
  }
  if(!keeps_none)
    return arcs;
  const Closed_strip closed(coarse, std::move(strip));
  if(closed.is_degenerate())
    return arcs;
  arcs = closed.shortest_loop(closed.foremost_corner(closed.inner_side()), puller);
  // rounding, or a strip so wide that it unfolds over its own centre
  if(total_length(arcs) > total_length(loop) * (1 + flat_tolerance))
    for(const Closed_strip::Corner& corner : closed.corners())
    {
      std::vector<Arc> others = closed.shortest_loop(corner, puller);
      if(total_length(others) < total_length(arcs))
        arcs = std::move(others);
    }
  return arcs;
}

// Tightens closed curves that are held at a vertex, and keeps each result once.
class Held_curves
{
public:
  Held_curves(const Progressive_mesh& pm, Index vertex)
    : m_network(pm, false), m_angles(pm), m_tightener(m_network, Length_unit(pm), &m_angles),
      m_basins(m_network, m_tightener), m_vertex(vertex)
  {
    m_tightener.hold(vertex);
  }

  // Cost: that of tightening it until it meets the way of another one.
  void insert(const std::vector<Index>& path) { insert(m_network.add_curve(0, path)); }
  void insert(std::vector<Arc> arcs)
  {
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    if(!m_network.is_empty(c))
      insert(c);
  }

  // The curves that did not shrink to the vertex, in the order in which they were found. Each starts at the vertex.
  const std::vector<std::vector<Arc>>& ends() const { return m_ends; }

private:
  void insert(Index c)
  {
    if(m_basins.tighten(c) == c)
    {
      m_ends.push_back(arcs_of_curve(m_network, c));
      std::vector<Arc>& arcs = m_ends.back();
      const auto first = std::find_if(arcs.begin(), arcs.end(), [this](const Arc& a) { return a.from == m_vertex; });
      std::rotate(arcs.begin(), first, arcs.end());
    }
    m_network.remove(c);
  }

  Curve_network m_network;
  const Corner_angles m_angles;
  Tightener m_tightener;
  Tightening_basins m_basins;
  const Index m_vertex;
  std::vector<std::vector<Arc>> m_ends;
};

// The simple geodesic loops at a vertex that result from loops of edges, tightened while they are held at the vertex.
// Only those with at least the given angle at the vertex, each once, the shortest first. Each starts at the vertex.
// Cost: O(n log n) for the loops of edges, plus that of tightening each until it meets the way of another one.
inline std::vector<std::vector<Arc>> held_loops(const Progressive_mesh& pm, Index vertex, double minimum_angle)
{
  Held_curves curves(pm, vertex);
  if(pm.number_of_vertices() >= least_held_vertices)
    for(const std::vector<Index>& path : loops_at_vertex(pm, vertex, max_held_seeds))
      curves.insert(path);
  else
  {
    Bisected_surface bisected = bisect_edges(pm, least_held_vertices);
    const std::vector<Index> old = std::move(bisected.old);
    const Progressive_mesh fine(std::move(bisected.table), std::move(bisected.points));
    const Index vertices = static_cast<Index>(pm.number_of_vertex_ids() - pm.number_of_holes());
    Held_curves fine_curves(fine, vertex);
    for(const std::vector<Index>& path : loops_at_vertex(fine, vertex, max_held_seeds))
      fine_curves.insert(path);
    for(const std::vector<Arc>& loop : fine_curves.ends())
      curves.insert(arcs_without_vertices(
          fine, loop, [&old](Index h) { return old[h]; }, [vertices](Index v) { return v < vertices; }, pm));
  }

  std::vector<std::vector<Arc>> loops;
  for(const std::vector<Arc>& arcs : curves.ends())
  {
    const Side_angles angles = side_angles(pm, arcs.back(), arcs.front());
    if((std::min)(angles.left, angles.right) >= minimum_angle && is_simple(pm, trace(pm, arcs)))
      loops.push_back(arcs);
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const auto& a, const auto& b) { return total_length(a) < total_length(b); });
  return loops;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_LOOPS_H
