// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A side angle this close to pi, in radians, is taken to be pi.
constexpr double angle_tolerance = 1e-10;

// Lengths as whole multiples of a unit far below the resolution that matters. A step of the tightening is accepted if
// the sum of these integers over the arcs that it replaces goes down. Equal arcs have equal integers, so no curve comes
// up twice, and a tightening ends whatever rounding does.
class Length_unit
{
public:
  // Linear in the number of vertices.
  explicit Length_unit(const Progressive_mesh& pm)
  {
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0}, diagonal = 0;
    for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
      for(int i = 0; i < 3; ++i)
      {
        const double x = pm.point(v)[i];
        low[i] = v == 0 ? x : (std::min)(low[i], x);
        high[i] = v == 0 ? x : (std::max)(high[i], x);
      }
    for(int i = 0; i < 3; ++i)
      diagonal = std::hypot(diagonal, high[i] - low[i]);
    m_scale = diagonal > 0 ? std::ldexp(1.0, 53) / diagonal : 1;
  }

  std::int64_t operator()(const Arc& a) const
  {
    return static_cast<std::int64_t>((std::min)(a.length * m_scale, 1e18));
  }

  std::int64_t operator()(const std::vector<Arc>& arcs) const
  {
    std::int64_t sum = 0;
    for(const Arc& a : arcs)
      sum += (*this)(a);
    return sum;
  }

private:
  double m_scale;
};

// Tightens curves of a network: as long as a pivot has a side angle below pi, the curve is led around that side of the
// pivot and pulled straight between the neighbouring pivots. The arcs of a curve may be a path that is not closed, of
// which the ends are held: the network takes the last arc to be the one before the first, but they do not meet.
class Tightener
{
public:
  // `angles` of the surface if it stays at its level, or null
  Tightener(Curve_network& network, const Length_unit& unit, const Corner_angles* angles = nullptr)
    : m_network(network), m_unit(unit), m_angles(angles), m_puller(network.surface())
  {}

  String_puller& puller() { return m_puller; }

  // Curves that pass a vertex are held there, until another one is given, or null_index.
  void hold(Index vertex) { m_held = vertex; }

  // Notes the pivot at which an arc starts, if one of its side angles is below pi. The arcs at it must be in place.
  void enqueue(Index arc)
  {
    const Index from = m_network.arc(arc).from;
    if(from == m_held || from != m_network.arc(m_network.previous(arc)).to)
    {
      m_network.renew_stamp(arc);
      return;
    }
    const Arc &incoming = m_network.arc(m_network.previous(arc)), &outgoing = m_network.arc(arc);
    const Side_angles angles =
        side_angles(m_network.surface(), incoming, outgoing, [this](Index h) { return corner(h); });
    const Index stamp = m_network.renew_stamp(arc);
    if((std::min)(angles.left, angles.right) < CGAL_PI - angle_tolerance)
      m_queue.push(Entry{angles, from, incoming.from + outgoing.to, arc, stamp, incoming.from < outgoing.to});
  }

  void enqueue_all(Index curve)
  {
    m_network.for_each_arc(curve, [this](Index arc) { enqueue(arc); });
  }

  // Works, the sharpest pivot first, until no noted pivot can be improved. A curve that degenerates is left without
  // arcs. The order makes the result independent of where a curve starts and of its direction.
  void run()
  {
    run([](Index) { return false; });
  }

  // As above, and calls is_known(curve) after each step. Once that is true the noted pivots are forgotten.
  template <class IsKnown>
  void run(IsKnown is_known)
  {
    while(!m_queue.empty())
    {
      const Entry entry = m_queue.top();
      m_queue.pop();
      if(m_network.stamp(entry.arc) != entry.stamp)
        continue;
      const Index curve = m_network.node(entry.arc).curve;
      const Curve_side sharper = entry.sharper_side();
      const bool is_changed = reroute(entry.arc, sharper) ||
                              ((std::max)(entry.angles.left, entry.angles.right) < CGAL_PI - angle_tolerance &&
                               reroute(entry.arc, other_side(sharper)));
      if(is_changed && is_known(curve))
        m_queue = std::priority_queue<Entry>();
    }
  }

private:
  // The pivot at which an arc starts, as it was when the arc had this stamp. On a symmetric surface many pivots are
  // equally sharp but for rounding. Then their vertices decide, and not the ids of the arcs, which tell where a curve
  // has been.
  struct Entry
  {
    Side_angles angles;
    Index vertex, neighbours; // the pivot, and the sum of those before and after it
    Index arc, stamp;
    bool is_ascending; // the pivot before is less than the one after

    float sharpness() const { return static_cast<float>((std::min)(angles.left, angles.right)); }

    Curve_side sharper_side() const
    {
      const float left = static_cast<float>(angles.left), right = static_cast<float>(angles.right);
      return left < right || (left == right && is_ascending) ? Curve_side::LEFT : Curve_side::RIGHT;
    }

    friend bool operator<(const Entry& a, const Entry& b) // the top of the queue is the greatest
    {
      return std::make_tuple(a.sharpness(), a.vertex, a.neighbours, a.arc) >
             std::make_tuple(b.sharpness(), b.vertex, b.neighbours, b.arc);
    }
  };

  double corner(Index h) const { return m_angles ? (*m_angles)(h) : corner_angle(m_network.surface(), h); }

  // Leads the curve around the given side of the pivot where `arc` starts, if that shortens it.
  bool reroute(Index arc, Curve_side side)
  {
    const Progressive_mesh& pm = m_network.surface();
    const Index before = m_network.previous(arc);
    const Arc &incoming = m_network.arc(before), &outgoing = m_network.arc(arc);
    m_strip.clear();
    m_arcs.clear();
    if(before == arc)
    {
      m_strip.assign(outgoing.crossings.begin(), outgoing.crossings.end());
      append_fan(pm, incoming, outgoing, side, m_strip);
      if(!pull_closed(m_unit(outgoing)))
        return false;
    }
    else
    {
      m_strip.assign(incoming.crossings.begin(), incoming.crossings.end());
      append_fan(pm, incoming, outgoing, side, m_strip);
      m_strip.insert(m_strip.end(), outgoing.crossings.begin(), outgoing.crossings.end());
      m_puller.pull(incoming.from, m_strip, outgoing.to, m_arcs);
      if(m_unit(m_arcs) >= m_unit(incoming) + m_unit(outgoing))
        return false;
    }
    const Index curve = m_network.node(arc).curve;
    const std::size_t count = m_arcs.size();
    Index id = m_network.replace(before, arc, m_arcs);
    if(m_network.is_empty(curve))
      return true;
    if(id == null_index)
    {
      enqueue_all(curve);
      return true;
    }
    for(std::size_t i = 0; i <= count; ++i)
      enqueue(id = m_network.next(id));
    return true;
  }

  // Finds the shortest curve of the closed strip m_strip. False if it is not shorter than `length`; no arcs if it
  // degenerates.
  bool pull_closed(std::int64_t length)
  {
    const Closed_strip strip(m_network.surface(), m_strip);
    if(strip.is_degenerate())
      return true;
    m_arcs = strip.shortest_loop(strip.foremost_corner(strip.inner_side()), m_puller);
    if(m_unit(m_arcs) < length)
      return true;
    // Rounding, or a strip so wide that it unfolds over its own centre: the best of all corners.
    std::int64_t best = length;
    for(const Closed_strip::Corner& corner : strip.corners())
    {
      std::vector<Arc> arcs = strip.shortest_loop(corner, m_puller);
      if(m_unit(arcs) < best)
      {
        best = m_unit(arcs);
        m_arcs = std::move(arcs);
      }
    }
    return best < length;
  }

  Curve_network& m_network;
  Length_unit m_unit;
  const Corner_angles* m_angles;
  String_puller m_puller;
  Index m_held = null_index;
  std::priority_queue<Entry> m_queue;
  Strip m_strip;
  std::vector<Arc> m_arcs;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTENER_H
