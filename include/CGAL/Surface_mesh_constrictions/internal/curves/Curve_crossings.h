// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_CROSSINGS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_CROSSINGS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The fan of faces around a pivot: the halfedges out of it that bound clockwise the face that the curve leaves through
// and the face that it arrives through, or that it runs along.
struct Pivot_fan
{
  Index out, in;
  bool arrives_along_edge;
};

inline Pivot_fan pivot_fan(const Progressive_mesh& pm, const std::vector<Trace_point>& trace, std::size_t i)
{
  const Trace_point &from = trace[(i + trace.size() - 1) % trace.size()], &to = trace[(i + 1) % trace.size()];
  return {to.is_pivot() ? pm.halfedge(trace[i].pivot, to.pivot) : pm.prev(to.halfedge),
          from.is_pivot() ? pm.halfedge(trace[i].pivot, from.pivot) : pm.prev(pm.opposite(from.halfedge)),
          from.is_pivot()};
}

// Calls f(h, i) for the halfedges h that a closed geodesic crosses when it is moved a little to its left at its pivots,
// in order, and the place i of the point in the trace: of the crossing, or of the pivot. The source of each is on the
// right of the curve, or is the pivot; two consecutive ones share a vertex and a face.
template <class F>
void for_each_crossing_beside_pivots(const Progressive_mesh& pm, const std::vector<Trace_point>& trace, F f)
{
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    if(!trace[i].is_pivot())
    {
      f(trace[i].halfedge, i);
      continue;
    }
    const Pivot_fan fan = pivot_fan(pm, trace, i);
    Index h = fan.arrives_along_edge ? pm.cw(fan.in) : fan.in;
    do
    {
      if(h == fan.out && fan.in != fan.out)
        break;
      f(h, i);
      h = pm.cw(h);
    } while(h != fan.out);
  }
}

// The halfedges alone.
inline std::vector<Index> crossings_beside_pivots(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> result;
  for_each_crossing_beside_pivots(pm, trace, [&result](Index h, std::size_t) { result.push_back(h); });
  return result;
}

// For a growing set of closed curves, moved a little to their left at their pivots: which of them cross an edge.
class Curve_crossings
{
public:
  explicit Curve_crossings(const Progressive_mesh& pm)
    : m_pm(pm), m_edges(pm.number_of_halfedge_ids()), m_vertices(pm.number_of_vertex_ids())
  {}

  // Adds a curve, of which these are the crossed halfedges. Curves are numbered in the order in which they are added.
  // Linear in the number of crossings.
  void add(const std::vector<Index>& crossings)
  {
    const Index c = static_cast<Index>(m_curves.size());
    m_curves.push_back({crossings, 0});
    for(Index h : crossings)
    {
      m_edges.toggle(m_pm.edge(h), c);
      for(Index v : {m_pm.source(h), m_pm.target(h)})
        if(!m_pm.is_ghost_vertex(v))
          m_curves[c].number_of_vertices += m_vertices.insert(v, c);
    }
  }

  std::size_t number_of_curves() const { return m_curves.size(); }

  // the halfedges that a curve crosses, in order
  const std::vector<Index>& crossings(Index curve) const { return m_curves[curve].crossings; }

  // the number of different vertices, without ghosts, of the edges that a curve crosses
  std::size_t number_of_vertices(Index curve) const { return m_curves[curve].number_of_vertices; }

  // the curves on different sides of which the ends of a halfedge lie, as far as the edge tells; ascending
  const std::vector<Index>& curves_at_edge(Index h) const { return m_edges[m_pm.edge(h)]; }

  // the curves that cross an edge of a vertex; ascending
  const std::vector<Index>& curves_at_vertex(Index v) const { return m_vertices[v]; }

private:
  struct Curve
  {
    std::vector<Index> crossings;
    std::size_t number_of_vertices;
  };

  // The curves at each element, most of which have none.
  class Table
  {
  public:
    explicit Table(std::size_t size) : m_place(size), m_curves(1) {}

    const std::vector<Index>& operator[](Index i) const { return m_curves[m_place[i]]; }

    // Returns whether the newest curve, which this is, was not there.
    bool insert(Index i, Index curve)
    {
      if(m_place[i] == 0)
      {
        m_place[i] = static_cast<Index>(m_curves.size());
        m_curves.emplace_back();
      }
      std::vector<Index>& curves = m_curves[m_place[i]];
      if(!curves.empty() && curves.back() == curve)
        return false;
      curves.push_back(curve);
      return true;
    }

    // Inserts the newest curve, or takes it out: when it crosses an edge twice it is back on the same side.
    void toggle(Index i, Index curve)
    {
      if(!insert(i, curve))
        m_curves[m_place[i]].pop_back();
    }

  private:
    Zeroed_array<Index> m_place; // of the curves of an element, 0 if it has none
    std::vector<std::vector<Index>> m_curves;
  };

  const Progressive_mesh& m_pm;
  std::vector<Curve> m_curves;
  Table m_edges, m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_CROSSINGS_H
