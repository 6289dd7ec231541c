// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_SHORTEST_PATH_PATCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_SHORTEST_PATH_PATCH_H

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A small surface of its own, made of triangles between corners, and the shortest paths in it between two corners, as
// CGAL's Surface_mesh_shortest_path finds them. Its unit of length is chosen so that its bounding box has a diagonal
// between 1/2 and 1: with an inexact kernel CGAL compares with an absolute tolerance.
template <class Kernel>
class Shortest_path_patch
{
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Mesh;
  typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> Traits;
  typedef CGAL::Surface_mesh_shortest_path<Traits> Shortest_path;

public:
  typedef std::array<double, 3> Position;
  typedef typename Mesh::Vertex_index Vertex;

  // A point of a path: a corner, or a point in an edge between two corners.
  struct Event
  {
    Vertex source, target; // equal for a corner
    Point_3 point;

    bool is_corner() const { return source == target; }
    bool is_on(Vertex s, Vertex t) const { return (source == s && target == t) || (source == t && target == s); }
  };

  struct Path
  {
    double length; // not a number if there is none
    std::vector<Event> events;
  };

  // adds the corner p + parameter * (q - p) and returns its number.
  std::size_t add_corner(const Position& p, const Position& q, double parameter)
  {
    m_corners.push_back({p, q, parameter});
    return m_corners.size() - 1;
  }
  std::size_t add_corner(const Position& p) { return add_corner(p, p, 0); }

  void add_face(std::size_t a, std::size_t b, std::size_t c) { m_faces.push_back({{a, b, c}}); }

  // To be called when all corners and faces have been added. Returns whether the faces form a surface.
  bool build()
  {
    const Position origin = m_corners.front().p;
    const int exponent = exponent_of_diagonal();
    for(const Corner& c : m_corners)
      m_mesh.add_vertex(position(c, origin, exponent));
    for(const std::array<std::size_t, 3>& f : m_faces)
      if(m_mesh.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2])) == boost::graph_traits<Mesh>::null_face())
        return false;
    return true;
  }

  Vertex vertex(std::size_t corner) const { return Vertex(static_cast<typename Mesh::size_type>(corner)); }
  const Point_3& point(Vertex v) const { return m_mesh.point(v); }

  // the point at `parameter` on the segment between two corners
  Point_3 point(Vertex source, Vertex target, double parameter) const
  {
    return point(source) + FT(parameter) * (point(target) - point(source));
  }

  static double distance(const Point_3& p, const Point_3& q)
  {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
  }

  // of p from the segment between q and r
  static double distance(const Point_3& p, const Point_3& q, const Point_3& r)
  {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, typename Kernel::Segment_3(q, r))));
  }

  Path shortest_path(Vertex from, Vertex to)
  {
    Shortest_path shortest_path(m_mesh);
    shortest_path.add_source_point(to);
    Path path;
    Recorder recorder = {m_mesh, path.events};
    const FT length = shortest_path.shortest_path_sequence_to_source_points(from, recorder).first;
    path.length = path.events.empty() ? std::numeric_limits<double>::quiet_NaN() : CGAL::to_double(length);
    return path;
  }

private:
  struct Corner
  {
    Position p, q;
    double parameter;
  };

  struct Recorder
  {
    const Mesh& mesh;
    std::vector<Event>& events;

    void operator()(typename Mesh::Halfedge_index h, const FT& alpha)
    {
      const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
      events.push_back({mesh.source(h), mesh.target(h), p + alpha * (q - p)});
    }
    void operator()(Vertex v) { events.push_back({v, v, mesh.point(v)}); }
    // not called, since sources are corners
    void operator()(typename Mesh::Face_index, const typename Traits::Barycentric_coordinates&) {}
  };

  // The exponent e such that 2^e is between the diagonal of the bounding box and twice of it. Coordinates are halved,
  // lest their differences overflow.
  int exponent_of_diagonal() const
  {
    std::array<double, 3> extent;
    for(std::size_t i = 0; i < 3; ++i)
    {
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for(const Corner& c : m_corners)
      {
        const double x = c.p[i] / 2 + c.parameter * (c.q[i] / 2 - c.p[i] / 2);
        least = (std::min)(least, x);
        most = (std::max)(most, x);
      }
      extent[i] = most - least;
    }
    const double greatest = *std::max_element(extent.begin(), extent.end());
    if(!(greatest > 0))
      return 0;
    const int exponent = std::ilogb(greatest);
    double squared_diagonal = 0;
    for(double e : extent)
      squared_diagonal += std::ldexp(e, -exponent) * std::ldexp(e, -exponent);
    return exponent + 2 + std::ilogb(squared_diagonal) / 2;
  }

  // Relative to a corner, so that the rounding of a point on a segment is relative to the size of the patch, and not to
  // its distance from the origin of the mesh.
  static Point_3 position(const Corner& c, const Position& origin, int exponent)
  {
    std::array<FT, 3> x;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const FT o(std::ldexp(origin[i], -exponent));
      const FT p(std::ldexp(c.p[i], -exponent)), q(std::ldexp(c.q[i], -exponent));
      x[i] = p - o;
      if(c.parameter != 0)
        x[i] += FT(c.parameter) * (q - p);
    }
    return Point_3(x[0], x[1], x[2]);
  }

  std::vector<Corner> m_corners;
  std::vector<std::array<std::size_t, 3>> m_faces;
  Mesh m_mesh;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_SHORTEST_PATH_PATCH_H
