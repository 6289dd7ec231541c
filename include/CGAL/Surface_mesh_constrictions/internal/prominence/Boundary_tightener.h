// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BOUNDARY_TIGHTENER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BOUNDARY_TIGHTENER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/tie_key.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightening_basins.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Lengths that differ by less than this share are equal: they are known no better.
constexpr double equal_length_tolerance = 1e-9;

// The result of tightening the boundary of a swept region.
struct Tightened_boundary
{
  double length = 0;          // of all its curves
  Index longest = null_index; // of these, or null_index if all shorten to points
  bool is_simple = true;      // whether all of them are
  Strip strip;                // from which that came
  Index vertex = null_index;  // where the last one did that
};

// Tells on which side of a pass a closed curve lies, by tightening it. Keeps each resulting closed geodesic once.
class Boundary_tightener
{
public:
  // `angles` of the surface. Linear in the size of the mesh.
  Boundary_tightener(const Progressive_mesh& pm, const Corner_angles& angles)
    : m_network(pm, false), m_tightener(m_network, Length_unit(pm), &angles), m_basins(m_network, m_tightener),
      m_distinct(m_network)
  {}

  // Enters a closed geodesic. Returns its number, which is that of an equal one if that is known.
  Index enter(std::vector<Arc> arcs)
  {
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    return settled(c);
  }

  const Progressive_mesh& surface() const { return m_network.surface(); }
  String_puller& puller() { return m_tightener.puller(); }

  // The curve of a number.
  std::vector<Arc> arcs(Index c) const { return arcs_of_curve(m_network, c); }
  double length(Index c) const { return m_length[c]; }
  std::uint64_t hash(Index c) const { return m_network.curve(c).hash; }

  // Tightens a closed path of edges. Returns the number of the resulting curve; null_index if it shortens to a point.
  Index tighten_path(const std::vector<Index>& path)
  {
    return path.size() < 3 ? null_index : end(m_network.add_curve(0, path));
  }

  // Whether a curve is simple.
  bool is_simple(Index c) const { return m_is_simple[c]; }

  // Tightens a closed curve that is held at a vertex that it passes; no arcs if it shortens to that.
  std::vector<Arc> tighten_held(std::vector<Arc> arcs, Index vertex)
  {
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    m_tightener.hold(vertex);
    m_tightener.enqueue_all(c);
    m_tightener.run();
    m_tightener.hold(null_index);
    std::vector<Arc> result = arcs_of_curve(m_network, c);
    m_network.remove(c);
    return result;
  }

  // The shortest path from the begin of `before` to the end of `behind`, among those that pass the vertex where the two
  // meet on one side; no arcs if it is a point. The arcs of each keep their ends but for those at that vertex.
  std::vector<Arc> let_go(const std::vector<Arc>& before, const std::vector<Arc>& behind, Curve_side side)
  {
    const Arc &incoming = before.back(), &outgoing = behind.front();
    Strip strip(incoming.crossings.begin(), incoming.crossings.end());
    append_fan(m_network.surface(), incoming, outgoing, side, strip);
    strip.insert(strip.end(), outgoing.crossings.begin(), outgoing.crossings.end());
    std::vector<Arc> result(before.begin(), before.end() - 1);
    m_tightener.puller().pull(incoming.from, strip, outgoing.to, result);
    result.insert(result.end(), behind.begin() + 1, behind.end());
    return result;
  }

  // Tightens a closed curve that is let go at a vertex that it passes, to one side of the vertex. The curve must have
  // another pivot.
  Tightened_boundary let_go(std::vector<Arc> arcs, Index vertex, Curve_side side)
  {
    const auto at = std::find_if(arcs.begin(), arcs.end(), [vertex](const Arc& a) { return a.from == vertex; });
    std::rotate(arcs.begin(), at, arcs.end());
    const std::vector<Arc> outgoing(1, arcs.front()), incoming(1, arcs.back());
    arcs.erase(arcs.begin());
    arcs.pop_back();
    const std::vector<Arc> between = let_go(incoming, outgoing, side);
    arcs.insert(arcs.end(), between.begin(), between.end());
    Tightened_boundary result = tighten(std::move(arcs));
    if(result.longest == null_index)
      result.vertex = vertex;
    return result;
  }

  // Tightens a closed curve; no arcs stand for a point.
  Tightened_boundary tighten(std::vector<Arc> arcs)
  {
    Tightened_boundary result;
    if(arcs.empty())
      return result;
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    result.longest = end(c);
    if(result.longest != null_index)
    {
      result.length = m_length[result.longest];
      result.is_simple = m_is_simple[result.longest];
    }
    return result;
  }

  // Of two curves of equal length the one that stands for both.
  bool precedes(Index c, Index d) const { return tie_key(m_network, c) < tie_key(m_network, d); }

  // Tightens closed curves without pivots, given by the halfedges that they cross, of this length in total; stops as
  // soon as several results together are longer than the limit. Each curve is first pulled tight in its strip, which
  // shortens it steadily, so that on the way to its result it never gets longer. Cost: linear in the strips, plus that
  // of tightening each until it meets the way of another one.
  Tightened_boundary tighten(const std::vector<Strip>& strips, double length, double limit)
  {
    Tightened_boundary result;
    for(const Strip& given : strips)
    {
      std::vector<Arc> arcs = pulled_tight(given, length);
      if(arcs.empty())
      {
        result.vertex = m_network.surface().target(given.front());
        continue;
      }
      const Index c = m_network.add_curve(0);
      m_network.set_arcs(c, arcs);
      const Index end = this->end(c);
      if(end == null_index)
      {
        result.vertex = m_basins.last_pivot();
        continue;
      }
      result.length += m_length[end];
      result.is_simple = result.is_simple && m_is_simple[end];
      if(result.longest == null_index || m_length[end] > m_length[result.longest])
      {
        result.longest = end;
        result.strip = given;
      }
      // a single curve that is too long may be a neighbour, if the other ones are points
      if(result.length > limit && result.length > m_length[result.longest])
        break;
    }
    return result;
  }

private:
  // Pulls a closed curve of at most this length, given by the halfedges that it crosses, tight between the rims of
  // holes that it runs along; no arcs if it is a point.
  std::vector<Arc> pulled_tight(const Strip& given, double length)
  {
    const Progressive_mesh& pm = m_network.surface();
    const auto on_rim = [&pm](Index h) { // the vertex on a rim that a halfedge stands for, or null_index
      return pm.is_ghost_vertex(pm.source(h))   ? pm.target(h)
             : pm.is_ghost_vertex(pm.target(h)) ? pm.source(h)
                                                : null_index;
    };
    const auto first = pm.has_boundary()
                           ? std::find_if(given.begin(), given.end(), [&](Index h) { return on_rim(h) != null_index; })
                           : given.end();
    if(first == given.end())
    {
      const Closed_strip strip(pm, given);
      return strip.is_degenerate() ? std::vector<Arc>() : shortest_loop(strip, length);
    }
    std::vector<Arc> arcs;
    Strip between;
    Index last = on_rim(*first);
    for(std::size_t i = 1; i <= given.size(); ++i)
    {
      const Index h = given[(static_cast<std::size_t>(first - given.begin()) + i) % given.size()], v = on_rim(h);
      if(v == null_index)
      {
        between.push_back(h);
        continue;
      }
      const Index along = between.empty() && v != last ? pm.halfedge(last, v) : null_index;
      if(along != null_index)
      {
        arcs.emplace_back();
        arcs.back().from = last;
        arcs.back().to = v;
        arcs.back().along = along;
        measure(pm, arcs.back());
      }
      else
        m_tightener.puller().pull(last, between, v, arcs);
      between.clear();
      last = v;
    }
    return arcs;
  }

  // The shortest curve of a closed strip that holds one of no more than this length; no arcs if it is a point.
  std::vector<Arc> shortest_loop(const Closed_strip& strip, double length)
  {
    String_puller& puller = m_tightener.puller();
    std::vector<Arc> best = strip.shortest_loop(strip.foremost_corner(strip.inner_side()), puller);
    if(total_length(best) <= length * (1 + equal_length_tolerance))
      return best;
    for(const Closed_strip::Corner& corner : strip.corners())
    {
      std::vector<Arc> arcs = strip.shortest_loop(corner, puller);
      if(total_length(arcs) < total_length(best))
        best = std::move(arcs);
    }
    return best;
  }

  // Tightens the newest curve of the network. Returns the number of the result; null_index if it shortens to a point.
  Index end(Index c)
  {
    const Index end = m_basins.tighten(c);
    if(end == null_index)
      return null_index;
    if(end != c)
      m_network.remove(c);
    m_settled.resize(m_network.number_of_curve_ids(), unknown);
    if(m_settled[end] == unknown)
    {
      settle_flat_band(m_network, end, m_tightener);
      m_settled[end] = m_network.is_empty(end) ? null_index : settled(end);
    }
    return m_settled[end];
  }

  // The number of a curve that is settled.
  Index settled(Index c)
  {
    const Index known = m_distinct.insert(c);
    m_length.resize(m_network.number_of_curve_ids(), 0);
    m_is_simple.resize(m_network.number_of_curve_ids(), false);
    if(known == c)
    {
      m_length[c] = m_network.length(c);
      m_is_simple[c] =
          internal::is_simple(m_network.surface(), trace(m_network.surface(), arcs_of_curve(m_network, c)));
    }
    return known;
  }

  static constexpr Index unknown = null_index - 1;

  Curve_network m_network;
  Tightener m_tightener;
  Tightening_basins m_basins;
  Distinct_curves m_distinct;
  std::vector<Index> m_settled; // by curve that a tightening ended as
  std::vector<double> m_length; // by curve
  std::vector<bool> m_is_simple;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_BOUNDARY_TIGHTENER_H
