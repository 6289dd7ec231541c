// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_SPLITTER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_SPLITTER_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Face_ring.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/best_diagonals.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/spread_parameters.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Turns arranged curves into edges of the mesh, and keeps it a triangle mesh.
// `EdgeMark` has is_marked(edge) and mark(edge, bool).
template <class TriangleMesh, class VertexPointMap, class EdgeMark, class Visitor>
class Curve_splitter
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  typedef Curve_arrangement<TriangleMesh> Arrangement;

public:
  // Nothing is changed yet. Linear in the number of crossings.
  Curve_splitter(TriangleMesh& tm, const Arrangement& arrangement, VertexPointMap vpm, EdgeMark& mark,
                 const Visitor& visitor)
    : m_tm(tm), m_arrangement(arrangement), m_vpm(vpm), m_mark(mark), m_visitor(visitor)
  {
    for(std::size_t i = 0; i < arrangement.faces().size(); ++i)
    {
      if(arrangement.faces()[i].strands.empty())
        continue;
      const halfedge_descriptor h = halfedge(arrangement.faces()[i].face, tm);
      m_rings.push_back({i, face_ring(arrangement, i, h), {{h, next(h, tm), prev(h, tm)}}});
    }
    for(const auto& arc : arrangement.arcs())
      m_halfedges.emplace_back(arc.number_of_strands(), arc.along);
  }

  // Linear in the number of crossings, times the logarithm of their number on one edge.
  void split()
  {
    m_edge_pieces.resize(m_arrangement.edges().size());
    for(std::size_t e = 0; e < m_edge_pieces.size(); ++e)
      if(!m_arrangement.edges()[e].crossings.empty())
        split_edge(e);
    for(Ring& ring : m_rings)
      split_face(ring);
    for(const std::vector<halfedge_descriptor>& arc : m_halfedges)
      for(halfedge_descriptor h : arc)
        m_mark.mark(edge(h, m_tm), true);
  }

  // the halfedges along a curve, in its direction
  std::vector<halfedge_descriptor> halfedges(std::size_t curve) const
  {
    std::vector<halfedge_descriptor> result;
    for(const auto& use : m_arrangement.curve(curve))
    {
      const std::vector<halfedge_descriptor>& arc = m_halfedges[use.arc];
      if(use.is_forward)
        result.insert(result.end(), arc.begin(), arc.end());
      else
        for(auto h = arc.rbegin(); h != arc.rend(); ++h)
          result.push_back(opposite(*h, m_tm));
    }
    return result;
  }

private:
  struct Ring
  {
    std::size_t face; // of the arrangement
    Face_ring ring;
    std::array<halfedge_descriptor, 3> sides;
  };

  // The crossing points of an edge. They keep apart as long as the coordinates can tell them apart.
  std::vector<Point> crossing_points(std::size_t e) const
  {
    typedef typename Kernel_traits<Point>::Kernel::FT FT;
    const halfedge_descriptor h = m_arrangement.edges()[e].halfedge;
    const Point p = get(m_vpm, source(h, m_tm)), q = get(m_vpm, target(h, m_tm));
    const auto points = [&](double distance) {
      std::vector<Point> result;
      for(double t : spread_parameters(m_arrangement, e, distance))
        result.push_back(p + FT(t) * (q - p));
      return result;
    };
    const auto are_apart = [&](const std::vector<Point>& x) {
      return x.front() != p && x.back() != q && std::adjacent_find(x.begin(), x.end()) == x.end();
    };
    const double n = static_cast<double>(m_arrangement.edges()[e].crossings.size());
    for(double distance = least_distance_of_crossings; distance * (n + 1) < 1; distance *= 16)
    {
      const std::vector<Point> result = points(distance);
      if(are_apart(result))
        return result;
    }
    return points(least_distance_of_crossings);
  }

  void split_edge(std::size_t e)
  {
    const halfedge_descriptor h = m_arrangement.edges()[e].halfedge;
    const bool is_marked = m_mark.is_marked(edge(h, m_tm));
    for(const Point& p : crossing_points(e))
    {
      const halfedge_descriptor piece = Euler::split_edge(h, m_tm);
      put(m_vpm, target(piece, m_tm), p);
      m_mark.mark(edge(piece, m_tm), is_marked);
      m_edge_pieces[e].push_back(piece);
      m_visitor.edge_split(piece, m_tm);
    }
    m_edge_pieces[e].push_back(h);
  }

  // For each place of a ring, once the edges have been split, the halfedge of the face that ends there.
  std::vector<halfedge_descriptor> halfedges_to_places(const Ring& ring) const
  {
    const std::vector<Face_ring::Place>& places = ring.ring.places;
    const std::size_t n = places.size();
    std::vector<halfedge_descriptor> result(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const Face_ring::Place& from = places[i];
      const Face_ring::Place& to = places[(i + 1) % n];
      const halfedge_descriptor side = ring.sides[from.side];
      if(to.crossing == Face_ring::none && from.crossing == Face_ring::none)
      {
        result[(i + 1) % n] = side;
        continue;
      }
      const std::size_t e =
          m_arrangement.crossings()[to.crossing != Face_ring::none ? to.crossing : from.crossing].edge;
      const std::vector<halfedge_descriptor>& pieces = m_edge_pieces[e];
      result[(i + 1) % n] = m_arrangement.edges()[e].halfedge == side
                                ? pieces[from.rank]
                                : opposite(pieces[pieces.size() - 1 - from.rank], m_tm);
    }
    return result;
  }

  void split_face(const Ring& ring)
  {
    const face_descriptor f = m_arrangement.faces()[ring.face].face;
    m_visitor.before_subface_creations(f, m_tm);
    std::vector<halfedge_descriptor> to = halfedges_to_places(ring);
    std::vector<face_descriptor> pieces = {f};
    for(const Face_ring::Chord& c : ring.ring.chords)
    {
      const halfedge_descriptor up = cut_off(c.low, c.high, to);
      const auto& strand = m_arrangement.faces()[ring.face].strands[c.strand];
      m_halfedges[strand.arc][strand.position] = c.is_ascending ? up : opposite(up, m_tm);
      pieces.push_back(face(up, m_tm));
      m_visitor.after_subface_created(pieces.back(), m_tm);
    }
    for(face_descriptor piece : pieces)
      triangulate(piece);
    m_visitor.after_subface_creations(m_tm);
  }

  void triangulate(face_descriptor f)
  {
    std::vector<halfedge_descriptor> to;
    std::vector<Exact_predicates_inexact_constructions_kernel::Point_3> polygon;
    for(halfedge_descriptor h : halfedges_around_face(halfedge(f, m_tm), m_tm))
    {
      to.push_back(h);
      polygon.push_back(nearest_point(get(m_vpm, target(h, m_tm))));
    }
    for(const std::array<std::size_t, 2>& d : best_diagonals(polygon))
    {
      const halfedge_descriptor up = cut_off(d[0], d[1], to);
      m_mark.mark(edge(up, m_tm), false);
      m_visitor.after_subface_created(face(up, m_tm), m_tm);
    }
  }

  // Cuts the corners between two off a polygon, whose corner i halfedge `to[i]` leads to, and returns the new halfedge
  // from the lower to the higher, in the new face. The corners keep the old face.
  halfedge_descriptor cut_off(std::size_t low, std::size_t high, std::vector<halfedge_descriptor>& to)
  {
    to[high] = opposite(Euler::split_face(to[high], to[low], m_tm), m_tm);
    return to[high];
  }

  TriangleMesh& m_tm;
  const Arrangement& m_arrangement;
  VertexPointMap m_vpm;
  EdgeMark& m_mark;
  const Visitor& m_visitor;
  std::vector<Ring> m_rings;
  std::vector<std::vector<halfedge_descriptor>> m_edge_pieces; // of a crossed edge, along its halfedge
  std::vector<std::vector<halfedge_descriptor>> m_halfedges;   // of an arc
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_SPLITTER_H
