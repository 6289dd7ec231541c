// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVE_CROSSINGS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVE_CROSSINGS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/Trace.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The fan of faces around a pivot: the halfedges out of it that bound clockwise the face that the curve leaves through
// and the face that it arrives through, or that it runs along.
struct Pivot_fan
{
  Index out, in;
  bool leaves_along_edge, arrives_along_edge;
};

inline Pivot_fan pivot_fan(const Progressive_mesh& pm, const std::vector<Trace_point>& trace, std::size_t i)
{
  const Trace_point &from = trace[(i + trace.size() - 1) % trace.size()], &to = trace[(i + 1) % trace.size()];
  return {to.is_pivot() ? pm.halfedge(trace[i].pivot, to.pivot) : pm.prev(to.halfedge),
          from.is_pivot() ? pm.halfedge(trace[i].pivot, from.pivot) : pm.prev(pm.opposite(from.halfedge)),
          to.is_pivot(), from.is_pivot()};
}

// The halfedges that a closed geodesic crosses when it is moved a little to its left at its pivots, in order. The
// source of each is on the right of the curve; two consecutive ones share a vertex and a face.
inline std::vector<Index> crossings_beside_pivots(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> result;
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    if(!trace[i].is_pivot())
    {
      result.push_back(trace[i].halfedge);
      continue;
    }
    const Pivot_fan fan = pivot_fan(pm, trace, i);
    Index h = fan.arrives_along_edge ? pm.cw(fan.in) : fan.in;
    do {
      if(h == fan.out && fan.in != fan.out)
        break;
      result.push_back(h);
      h = pm.cw(h);
    } while(h != fan.out);
  }
  return result;
}

// For a set of closed curves, moved a little to their left at their pivots: which of them cross an edge.
class Curve_crossings
{
public:
  // A range of numbers of curves, ascending.
  struct Range
  {
    const Index *first, *last;

    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    bool empty() const { return first == last; }
  };

  // Linear in the size of the mesh, and O(k log k) in the total number of crossings.
  Curve_crossings(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point> >& traces)
    : m_pm(pm)
  {
    std::vector<Entry> at_edge, at_vertex;
    for(Index c = 0; c < traces.size(); ++c)
    {
      m_crossings.push_back(crossings_beside_pivots(pm, traces[c]));
      for(Index h : m_crossings.back())
      {
        at_edge.emplace_back(pm.edge(h), c);
        at_vertex.emplace_back(pm.source(h), c);
        at_vertex.emplace_back(pm.target(h), c);
      }
    }
    std::sort(at_edge.begin(), at_edge.end());
    std::vector<Entry> odd; // a curve that crosses an edge twice is back on the same side
    for(const Entry& e : at_edge)
      if(!odd.empty() && odd.back() == e)
        odd.pop_back();
      else
        odd.push_back(e);
    std::sort(at_vertex.begin(), at_vertex.end());
    at_vertex.erase(std::unique(at_vertex.begin(), at_vertex.end()), at_vertex.end());
    m_vertices_of_curve.assign(traces.size(), 0);
    for(const Entry& e : at_vertex)
      ++m_vertices_of_curve[e.second];
    m_edges.fill(odd, pm.number_of_halfedge_ids());
    m_vertices.fill(at_vertex, pm.number_of_vertex_ids());
  }

  std::size_t number_of_curves() const { return m_crossings.size(); }

  // the halfedges that a curve crosses, in order
  const std::vector<Index>& crossings(Index curve) const { return m_crossings[curve]; }

  // the curves on different sides of which the ends of a halfedge lie, as far as the edge tells
  Range curves_at_edge(Index h) const { return m_edges.range(m_pm.edge(h)); }

  // the curves that cross an edge of a vertex
  Range curves_at_vertex(Index v) const { return m_vertices.range(v); }

  // the number of different vertices of the edges that a curve crosses
  std::size_t number_of_vertices(Index curve) const { return m_vertices_of_curve[curve]; }

private:
  typedef std::pair<Index, Index> Entry; // an element and a curve

  // The curves at each element, one behind the other.
  struct Table
  {
    std::vector<Index> first, curves;

    void fill(const std::vector<Entry>& sorted, std::size_t size)
    {
      first.assign(size + 1, 0);
      for(const Entry& e : sorted)
      {
        ++first[e.first + 1];
        curves.push_back(e.second);
      }
      for(std::size_t i = 0; i < size; ++i)
        first[i + 1] += first[i];
    }

    Range range(Index i) const { return {curves.data() + first[i], curves.data() + first[i + 1]}; }
  };

  const Progressive_mesh& m_pm;
  std::vector<std::vector<Index> > m_crossings;
  std::vector<std::size_t> m_vertices_of_curve;
  Table m_edges, m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVE_CROSSINGS_H
