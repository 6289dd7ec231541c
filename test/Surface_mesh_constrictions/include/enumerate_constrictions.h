// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef ENUMERATE_CONSTRICTIONS_H
#define ENUMERATE_CONSTRICTIONS_H

// All strict constrictions of a small mesh up to a given length, by brute force.
//
// A strict constriction is a cycle of straight segments between saddle vertices, those whose angles add up to more than
// 2 pi, that leaves an angle of at least pi on both sides of each of them. The angle to a hole is infinite, so vertices
// on the boundary are saddles. All straight segments are found by unfolding
// the faces that can be seen from each saddle vertex, and all cycles of them by a depth-first search. What is found is
// certified with exact arithmetic, which also tells the simple cycles from the others.
//
// No vertex inside the mesh may have a total angle of exactly 2 pi: segments straight through it would not be found.

#include "geodesic_check.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace enumerate_constrictions {

typedef test_meshes::Mesh Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
typedef std::complex<double> Complex;

class Enumeration
{
  typedef Mesh::Halfedge_index Halfedge;
  typedef Mesh::Vertex_index Vertex;

  // A straight segment from a saddle vertex to a saddle vertex.
  struct Segment
  {
    std::size_t from, to;
    double length;
    double start, end; // angles at `from` and `to`, from the first halfedge there counterclockwise to the segment
    std::vector<Constriction::Location> locations; // `from` and the crossed halfedges
    std::vector<std::size_t> successors;           // segments from `to` that go on with angles of at least pi
  };

  // A halfedge that is crossed from its face to the opposite one, and where its ends are in the unfolding.
  struct Portal
  {
    Halfedge halfedge;
    Complex source, target;
  };

public:
  Enumeration(const Mesh& mesh, double max_length) : m_mesh(mesh), m_max_length(max_length)
  {
    measure_angles();
    for(Vertex v : mesh.vertices())
      if(is_saddle(v))
        find_segments(v);
    find_successors();
    find_distances();
    for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      for(std::size_t s : m_segments_from[v])
        extend({s}, m_segments[s].length);
  }

  const std::vector<Constriction>& constrictions() const { return m_constrictions; }
  std::size_t number_of_segments() const { return m_segments.size(); }

private:
  static double cross(Complex a, Complex b) { return std::imag(std::conj(a) * b); }

  const Mesh::Point& point(Vertex v) const { return m_mesh.point(v); }

  // The angle of each corner, where it begins around its vertex, and the sum around each vertex.
  void measure_angles()
  {
    m_offset.resize(m_mesh.number_of_halfedges());
    m_total.resize(m_mesh.number_of_vertices());
    m_segments_from.resize(m_mesh.number_of_vertices());
    for(Vertex v : m_mesh.vertices())
    {
      if(m_mesh.is_isolated(v))
        continue;
      const Halfedge begin = first_halfedge(v);
      Halfedge h = begin;
      double sum = 0;
      do
      {
        m_offset[h] = sum;
        sum += m_mesh.is_border(h) ? std::numeric_limits<double>::infinity() : std::arg(corner(h));
        h = m_mesh.opposite(m_mesh.prev(h));
      } while(h != begin);
      m_total[v] = sum;
    }
  }

  // Out of a vertex; on the boundary the one from which the faces are counterclockwise, and the hole comes last.
  Halfedge first_halfedge(Vertex v) const
  {
    Halfedge h = m_mesh.opposite(m_mesh.halfedge(v));
    for(Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_mesh.is_border(in))
        h = m_mesh.opposite(in);
    return h;
  }

  // Where the third vertex of the face of h is, with the source of h in the origin and its target on the real axis.
  Complex corner(Halfedge h) const
  {
    const auto &p = point(m_mesh.source(h)), &q = point(m_mesh.target(h)), &r = point(m_mesh.target(m_mesh.next(h)));
    return geodesic_check::unfold(p, q, r, 0, edge_length(h));
  }

  double edge_length(Halfedge h) const
  {
    return std::sqrt(CGAL::squared_distance(point(m_mesh.source(h)), point(m_mesh.target(h))));
  }

  bool is_saddle(Vertex v) const { return m_total[v] > 2 * CGAL_PI; }

  // Appends all segments from a vertex: along the edges, and through the faces.
  void find_segments(Vertex v)
  {
    const Halfedge begin = first_halfedge(v);
    Halfedge h = begin;
    do
    {
      add_segment(v, m_mesh.target(h), edge_length(h), m_offset[h], m_offset[m_mesh.opposite(h)], {}, 0);
      if(m_mesh.is_border(h))
        break;
      const Complex right = edge_length(h), left = corner(h);
      std::vector<Portal> strip = {{m_mesh.next(h), right, left}};
      look_through(v, h, strip, right, left);
      h = m_mesh.opposite(m_mesh.prev(h));
    } while(h != begin);
  }

  // Unfolds the face behind the last portal of the strip, and goes on through those of its two other edges that can be
  // seen from the origin between the rays `right` and `left`.
  void look_through(Vertex v, Halfedge first, std::vector<Portal>& strip, Complex right, Complex left)
  {
    const Portal p = strip.back();
    if(m_mesh.is_border(m_mesh.opposite(p.halfedge)) || distance(p, right, left) > m_max_length)
      return;
    const Halfedge o = m_mesh.opposite(p.halfedge), beside_source = m_mesh.next(o), beside_target = m_mesh.prev(o);
    const Vertex w = m_mesh.target(beside_source);
    const Complex apex = geodesic_check::unfold(point(m_mesh.target(p.halfedge)), point(m_mesh.source(p.halfedge)),
                                                point(w), p.target, p.source);
    const bool left_of_right = cross(right, apex) > 0, right_of_left = cross(apex, left) > 0;
    if(left_of_right && right_of_left)
      add_segment(v, w, std::abs(apex), m_offset[first] + std::arg(apex),
                  m_offset[beside_target] + std::arg(-apex / (p.target - apex)), strip, apex);
    if(left_of_right)
    {
      strip.push_back({beside_source, p.source, apex});
      look_through(v, first, strip, right, right_of_left ? apex : left);
      strip.pop_back();
    }
    if(right_of_left)
    {
      strip.push_back({beside_target, apex, p.target});
      look_through(v, first, strip, left_of_right ? apex : right, left);
      strip.pop_back();
    }
  }

  // Of the part of the portal between two rays from the origin.
  static double distance(const Portal& p, Complex right, Complex left)
  {
    const Complex along = p.target - p.source;
    const Complex a = right * (cross(p.source, along) / cross(right, along));
    const Complex b = left * (cross(p.source, along) / cross(left, along));
    const double length = std::norm(b - a);
    const double t = length > 0 ? std::min(std::max(-std::real(std::conj(b - a) * a) / length, 0.0), 1.0) : 0;
    return std::abs(a + t * (b - a));
  }

  void add_segment(Vertex from, Vertex to, double length, double start, double end, const std::vector<Portal>& strip,
                   Complex apex)
  {
    if(length > m_max_length || !is_saddle(to))
      return;
    Segment s = {from, to, length, start, end, {{true, from, Halfedge(), 0}}, {}};
    for(const Portal& p : strip)
    {
      const double a = cross(apex, p.source), b = cross(apex, p.target);
      s.locations.push_back({false, Vertex(), p.halfedge, a / (a - b)});
    }
    m_segments_from[from].push_back(m_segments.size());
    m_segments.push_back(s);
  }

  void find_successors()
  {
    const double rounding = 1e-9; // the certificate decides
    for(Segment& s : m_segments)
      for(std::size_t t : m_segments_from[s.to])
      {
        if(left_angle(s, m_segments[t]) > CGAL_PI - rounding && right_angle(s, m_segments[t]) > CGAL_PI - rounding)
          s.successors.push_back(t);
      }
  }

  // Between a segment and one that goes on from its end.
  double left_angle(const Segment& s, const Segment& t) const
  {
    const double angle = s.end - t.start;
    return angle < 0 ? angle + m_total[s.to] : angle;
  }
  double right_angle(const Segment& s, const Segment& t) const
  {
    const double angle = t.start - s.end;
    return angle <= 0 ? angle + m_total[s.to] : angle;
  }

  // Lengths of shortest paths of segments (Floyd and Warshall): how much a path must get longer before it closes.
  void find_distances()
  {
    const std::size_t n = m_mesh.number_of_vertices();
    m_distance.assign(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
    for(const Segment& s : m_segments)
      m_distance[s.from][s.to] = s.from == s.to ? 0 : std::min(m_distance[s.from][s.to], s.length);
    for(std::size_t v = 0; v < n; ++v)
      m_distance[v][v] = 0;
    for(std::size_t k = 0; k < n; ++k)
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
          m_distance[i][j] = std::min(m_distance[i][j], m_distance[i][k] + m_distance[k][j]);
  }

  // Closes the path and looks at what it is, or goes on to vertices that are not on it. The first vertex of a path is
  // the smallest one, so that a cycle is met once in each direction.
  void extend(const std::vector<std::size_t>& path, double length)
  {
    const std::size_t first = m_segments[path.front()].from, last = m_segments[path.back()].to;
    const std::vector<std::size_t>& successors = m_segments[path.back()].successors;
    if(last == first)
    {
      if(std::find(successors.begin(), successors.end(), path.front()) != successors.end())
        close(path, length);
      return;
    }
    if(last < first)
      return;
    for(std::size_t s : path)
      if(m_segments[s].from == last)
        return;
    for(std::size_t t : successors)
    {
      const double extended = length + m_segments[t].length;
      if(extended + m_distance[m_segments[t].to][first] > m_max_length)
        continue;
      std::vector<std::size_t> longer = path;
      longer.push_back(t);
      extend(longer, extended);
    }
  }

  void close(const std::vector<std::size_t>& path, double length)
  {
    Constriction::Data data;
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      const Segment &before = m_segments[path[(i + path.size() - 1) % path.size()]], &s = m_segments[path[i]];
      data.pivots.push_back(
          {s.locations[0].vertex, data.locations.size(), left_angle(before, s), right_angle(before, s)});
      data.locations.insert(data.locations.end(), s.locations.begin(), s.locations.end());
    }
    data.length = length;
    Constriction curve(data);
    if(!m_known.insert(key(m_mesh, curve)).second)
      return;
    data.certificate = CGAL::Surface_mesh_constrictions::certify_constriction(m_mesh, curve);
    if(data.certificate.verdict == CGAL::Surface_mesh_constrictions::Certificate_verdict::STRICT_CONSTRICTION)
      m_constrictions.push_back(Constriction(data));
  }

public:
  typedef std::vector<std::size_t> Key;

  // The cyclic sequence of vertices and crossed edges, the same for both directions and every start.
  static Key key(const Mesh& mesh, const Constriction& curve)
  {
    Key nodes;
    for(const auto& l : curve.locations())
      nodes.push_back(l.is_pivot ? 2 * l.vertex.idx() : 2 * mesh.edge(l.halfedge).idx() + 1);
    Key least;
    for(int direction = 0; direction < 2; ++direction)
    {
      for(std::size_t i = 0; i < nodes.size(); ++i)
      {
        std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
        if(least.empty() || nodes < least)
          least = nodes;
      }
      std::reverse(nodes.begin(), nodes.end());
    }
    return least;
  }

private:
  const Mesh& m_mesh;
  double m_max_length;
  std::vector<double> m_offset; // of halfedges
  std::vector<double> m_total;  // of vertices
  std::vector<Segment> m_segments;
  std::vector<std::vector<std::size_t>> m_segments_from;
  std::vector<std::vector<double>> m_distance;
  std::set<Key> m_known;
  std::vector<Constriction> m_constrictions;
};

} // namespace enumerate_constrictions

#endif // ENUMERATE_CONSTRICTIONS_H
