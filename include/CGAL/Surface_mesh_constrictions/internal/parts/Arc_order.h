// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARC_ORDER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARC_ORDER_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Surface_arc.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The order in which arcs cross a common edge. It follows from where they part, not from the parameters of the
// crossings: arcs that do not cross each other can be drawn in this order on all edges without crossing, whatever the
// rounding of their parameters.
template <class TriangleMesh>
class Arc_order
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef Surface_arc<TriangleMesh> Arc;

public:
  // A crossing, by its place in an arc.
  struct Place
  {
    std::size_t arc, position;
  };

  Arc_order(const TriangleMesh& tm, const std::vector<Arc>& arcs) : m_tm(tm), m_arcs(arcs) {}

  // Whether a crossing of the edge of `h` comes before another one on the way along `h`.
  // It does if its arc parts to that side when both are followed across `h`; else, if it does when both are followed
  // the other way. Arcs that never part are closed and parallel: there the parameters decide, once for all edges.
  // Linear in the number of edges that both arcs cross one after the other.
  bool is_before(halfedge_descriptor h, const Place& a, const Place& b) const
  {
    int order = parting(walk(a, h), walk(b, h));
    if(order == 0)
    {
      const halfedge_descriptor o = opposite(h, m_tm);
      order = -parting(walk(a, o), walk(b, o));
    }
    if(order == 0)
      order = a.arc < b.arc ? order_of_parallels(h, a, b) : a.arc > b.arc ? -order_of_parallels(h, b, a) : 0;
    return order != 0 ? order < 0 : a.arc == b.arc ? a.position < b.position : a.arc < b.arc;
  }

  // Whether two arcs are the same from a common crossing on, in both directions. Closed ones must also have the same
  // parameters, up to rounding, else they are parallel.
  bool is_same(const Place& a, const Place& b) const
  {
    const Arc &p = m_arcs[a.arc], &q = m_arcs[b.arc];
    const std::size_t n = p.crossings.size();
    if(p.is_closed != q.is_closed || n != q.crossings.size())
      return false;
    const halfedge_descriptor h = p.crossings[a.position];
    Walk w = walk(a, h), v = walk(b, h);
    if(!p.is_closed &&
       (w.is_forward ? w.position : n - 1 - w.position) != (v.is_forward ? v.position : n - 1 - v.position))
      return false;
    rewind(w);
    rewind(v);
    for(std::size_t i = 0; i < n; ++i)
    {
      if(crossed(w) != crossed(v) ||
         (p.is_closed && std::abs(parameter(w, crossed(w)) - parameter(v, crossed(w))) > 1e-13))
        return false;
      advance(w);
      advance(v);
    }
    return true;
  }

private:
  // On the way along an arc, or against it.
  struct Walk
  {
    std::size_t arc, position;
    bool is_forward;
  };

  Walk walk(const Place& p, halfedge_descriptor across) const
  {
    return {p.arc, p.position, m_arcs[p.arc].crossings[p.position] == across};
  }

  halfedge_descriptor crossed(const Walk& w) const
  {
    const halfedge_descriptor h = m_arcs[w.arc].crossings[w.position];
    return w.is_forward ? h : opposite(h, m_tm);
  }

  double parameter(const Walk& w, halfedge_descriptor along) const
  {
    const Arc& arc = m_arcs[w.arc];
    return arc.crossings[w.position] == along ? arc.parameters[w.position] : 1 - arc.parameters[w.position];
  }

  // False at the end of the arc, which is a pivot.
  bool advance(Walk& w) const
  {
    const Arc& arc = m_arcs[w.arc];
    const std::size_t n = arc.crossings.size();
    if(!arc.is_closed && w.position == (w.is_forward ? n - 1 : 0))
      return false;
    w.position = (w.position + (w.is_forward ? 1 : n - 1)) % n;
    return true;
  }

  void rewind(Walk& w) const
  {
    if(!m_arcs[w.arc].is_closed)
      w.position = w.is_forward ? 0 : m_arcs[w.arc].crossings.size() - 1;
  }

  // Follows two arcs across the same halfedge until they part: -1 if the first is then on the side of the source.
  int parting(Walk a, Walk b) const
  {
    // periodic sequences that agree for as long as both periods together agree for ever
    for(std::size_t n = m_arcs[a.arc].crossings.size() + m_arcs[b.arc].crossings.size(); n > 0; --n)
    {
      const halfedge_descriptor o = opposite(crossed(a), m_tm);
      // from the side of the source: out of the next edge, into the apex, out of the one before
      const int exit_a = advance(a) ? (crossed(a) == next(o, m_tm) ? -1 : 1) : 0;
      const int exit_b = advance(b) ? (crossed(b) == next(o, m_tm) ? -1 : 1) : 0;
      if(exit_a != exit_b)
        return exit_a < exit_b ? -1 : 1;
      if(exit_a == 0)
        return 0;
    }
    return 0;
  }

  // Decides at the first crossing of the first arc.
  int order_of_parallels(halfedge_descriptor h, const Place& a, const Place& b) const
  {
    const Arc &p = m_arcs[a.arc], &q = m_arcs[b.arc];
    if(!p.is_closed || !q.is_closed)
      return 0;
    const std::size_t n = q.crossings.size(), steps = a.position % n;
    const bool same_direction = p.crossings[a.position] == q.crossings[b.position];
    const std::size_t beside = (b.position + (same_direction ? n - steps : steps)) % n;
    const double t = p.parameters[0], u = parameter({b.arc, beside, true}, p.crossings[0]);
    const int order = t <= u ? -1 : 1;
    return p.crossings[a.position] == h ? order : -order;
  }

  const TriangleMesh& m_tm;
  const std::vector<Arc>& m_arcs;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_ARC_ORDER_H
