// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A piece of a curve between two pivots: along an edge, or through the halfedges that it crosses, each from its face to
// the opposite one. A curve without pivots is one closed arc.
template <class TriangleMesh>
struct Surface_arc
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

  bool is_closed = false;
  typename Graph_traits::vertex_descriptor from, to; // unless closed
  typename Graph_traits::halfedge_descriptor edge;   // from -> to, if nothing is crossed
  std::vector<typename Graph_traits::halfedge_descriptor> crossed;
  std::vector<double> parameters; // of the crossings, along the crossed halfedges

  bool is_edge() const { return crossed.empty(); }

  // its pieces, each in one face or along the edge
  std::size_t number_of_strands() const { return crossed.size() + !is_closed; }
};

// Translates sequences of locations, closed or from one pivot to another, to arcs.
template <class TriangleMesh>
class Arc_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Constriction<TriangleMesh>::Location Location;
  typedef Surface_arc<TriangleMesh> Arc;

public:
  // `number` is the place of the curve in the user's sequence, for messages.
  Arc_reader(const TriangleMesh& tm, const std::vector<Location>& locations, std::size_t number, bool is_closed = true)
    : m_tm(tm), m_locations(locations), m_number(number), m_is_closed(is_closed)
  {}

  // Throws Invalid_input unless any two consecutive locations lie in one triangle. Linear, times the mean vertex
  // degree.
  std::vector<Arc> arcs() const
  {
    const std::size_t n = m_locations.size();
    if(n == 0)
      fail("it has no points");
    if(!m_is_closed && (n == 1 || !m_locations.front().is_pivot || !m_locations.back().is_pivot))
      fail("it has no vertices at its ends");
    const std::size_t steps = m_is_closed ? n : n - 1;
    for(std::size_t i = 0; i < steps; ++i)
      check(i);
    const auto is_pivot = [](const Location& l) { return l.is_pivot; };
    const std::size_t first = std::find_if(m_locations.begin(), m_locations.end(), is_pivot) - m_locations.begin();
    if(first == n)
    {
      Arc arc;
      arc.is_closed = true;
      for(const Location& l : m_locations)
        append_crossing(l, arc);
      return {arc};
    }
    std::vector<Arc> result;
    for(std::size_t i = 0; i < steps; ++i)
    {
      const Location &p = m_locations[(first + i) % n], &q = m_locations[(first + i + 1) % n];
      if(p.is_pivot)
      {
        result.emplace_back();
        result.back().from = p.vertex;
      }
      if(!q.is_pivot)
      {
        append_crossing(q, result.back());
        continue;
      }
      result.back().to = q.vertex;
      if(p.is_pivot)
        result.back().edge = halfedge(p.vertex, q.vertex, m_tm).first;
    }
    return result;
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Invalid_input(Input_defect::INVALID_LOOP, m_number, "curve " + std::to_string(m_number) + ": " + reason);
  }

  static void append_crossing(const Location& l, Arc& arc)
  {
    arc.crossed.push_back(l.halfedge);
    arc.parameters.push_back(l.parameter);
  }

  bool is_triangle(halfedge_descriptor h) const
  {
    return face(h, m_tm) != Graph_traits::null_face() && next(next(next(h, m_tm), m_tm), m_tm) == h;
  }

  // Location i on its own, and with the one after it.
  void check(std::size_t i) const
  {
    const Location &p = m_locations[i], &q = m_locations[(i + 1) % m_locations.size()];
    if(!p.is_pivot)
    {
      if(!(p.parameter >= 0 && p.parameter <= 1))
        fail("the parameter of point " + std::to_string(i) + " is not in [0, 1]");
      if(!is_triangle(p.halfedge) || !is_triangle(opposite(p.halfedge, m_tm)))
        fail("point " + std::to_string(i) + " is not between two triangles");
    }
    if(!are_in_one_face(p, q))
      fail("point " + std::to_string(i) + " and the next are not in one face");
  }

  bool are_in_one_face(const Location& p, const Location& q) const
  {
    if(p.is_pivot && q.is_pivot)
    {
      if(p.vertex == q.vertex)
        return false;
      const auto edge = halfedge(p.vertex, q.vertex, m_tm);
      return edge.second && (face(edge.first, m_tm) != Graph_traits::null_face() ||
                             face(opposite(edge.first, m_tm), m_tm) != Graph_traits::null_face());
    }
    if(p.is_pivot)
      return target(next(q.halfedge, m_tm), m_tm) == p.vertex;
    const halfedge_descriptor o = opposite(p.halfedge, m_tm);
    if(q.is_pivot)
      return target(next(o, m_tm), m_tm) == q.vertex;
    return q.halfedge == next(o, m_tm) || q.halfedge == prev(o, m_tm);
  }

  const TriangleMesh& m_tm;
  const std::vector<Location>& m_locations;
  std::size_t m_number;
  bool m_is_closed;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H
