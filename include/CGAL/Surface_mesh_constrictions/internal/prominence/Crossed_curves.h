// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSED_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSED_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Vertex_classes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A growing set of simple closed geodesics, which tells which of them another one crosses there and back. The
// directions of the curves do not matter.
class Crossed_curves
{
public:
  explicit Crossed_curves(const Progressive_mesh& pm) : m_pm(pm), m_crossings(pm), m_class(pm.number_of_vertex_ids()) {}

  // Adds a curve. Curves are numbered in this order.
  void add(const std::vector<Trace_point>& trace)
  {
    m_crossings.add(crossings_beside_pivots(m_pm, trace));
    m_crossings.add(crossings_beside_pivots(m_pm, reversed(m_pm, trace)));
  }

  // The added curves that a curve crosses there and back. Curves that run beside it, or touch it, do not count; nor, on
  // a surface with handles, do curves that do not divide a neighbourhood of it. Ascending. Linear, up to a logarithm,
  // in the edges that it crosses and the curves that cross these edges.
  std::vector<Index> crossed_by(const std::vector<Trace_point>& trace)
  {
    // Curves are moved off their pivots. Two that touch at a pivot are moved apart, or over each other. Between two
    // that cross there may be nothing but pivots, and then moving them can separate them, too. So a curve counts as
    // crossed if there is a side to which it can be moved such that it is crossed on whichever side the other one is.
    const std::array<std::vector<Index>, 2> by = {
        {crossed_beside(crossings_beside_pivots(m_pm, trace)),
         crossed_beside(crossings_beside_pivots(m_pm, reversed(m_pm, trace)))}};
    std::vector<Index> result;
    std::array<std::vector<Index>, 2> some; // crossed if moved to one of its sides
    for(std::size_t side = 0; side < 2; ++side)
      for(Index a : by[side])
        if(!some[side].empty() && some[side].back() == a / 2)
          result.push_back(a / 2);
        else
          some[side].push_back(a / 2);
    std::set_intersection(some[0].begin(), some[0].end(), some[1].begin(), some[1].end(), std::back_inserter(result));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  // The curves that one beside its pivots crosses, of which these are the crossed halfedges; twice a number if it is
  // moved to its left, and one more if to its right. Ascending.
  std::vector<Index> crossed_beside(const std::vector<Index>& crossings)
  {
    m_class.restart(m_crossings.number_of_curves());
    m_class.set(m_pm.target(crossings[0]), 0);
    for(std::size_t i = 0; i <= crossings.size(); ++i)
    {
      const Index h = crossings[i % crossings.size()];
      const Index u = m_pm.source(h), v = m_pm.target(h);
      if(m_class.has(v))
        m_class.set_across(u, v, m_crossings.curves_at_edge(h));
      else
        m_class.set_across(v, u, m_crossings.curves_at_edge(h));
    }
    std::array<std::vector<Index>, 2> classes; // of the vertices on the left and on the right
    for(Index h : crossings)
    {
      classes[0].push_back(m_class[m_pm.target(h)]);
      classes[1].push_back(m_class[m_pm.source(h)]);
    }
    for(std::vector<Index>& c : classes)
    {
      std::sort(c.begin(), c.end());
      c.erase(std::unique(c.begin(), c.end()), c.end());
    }
    std::vector<Index> result;
    for_each_curve(m_class.classes().curves_between(classes[0]) & m_class.classes().curves_between(classes[1]),
                   [&](Index a) {
                     if(m_class.is_consistent(a))
                       result.push_back(a);
                   });
    std::sort(result.begin(), result.end());
    return result;
  }

  const Progressive_mesh& m_pm;
  Curve_crossings m_crossings;
  Vertex_classes m_class; // of a vertex beside the curve of the last call
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CROSSED_CURVES_H
