// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A point of a surface, by the face that it is in and barycentric coordinates with respect to its corners.
struct Surface_location
{
  Index face;
  std::array<double, 3> barycentric;
};

// A barycentric coordinate of less than this is taken to be zero: faces as thin as that would be put in otherwise.
constexpr double least_barycentric = 1e-6;

// The same location with barycentric coordinates that are zero or not tiny, and add up to 1.
inline Surface_location without_tiny_coordinates(Surface_location location)
{
  double sum = 0;
  for(double& b : location.barycentric)
  {
    if(b < least_barycentric)
      b = 0;
    sum += b;
  }
  for(double& b : location.barycentric)
    b /= sum;
  return location;
}

// Without ghosts.
inline Index number_of_faces(const Corner_table& table)
{
  return (std::min)(static_cast<Index>(table.halfedges.size() / 3), table.first_ghost_face);
}

// The point of a triangle that is nearest to p, in barycentric coordinates (Ericson, Real-Time Collision Detection,
// 5.1.5).
inline std::array<double, 3> nearest_in_triangle(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const auto ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab * ap, d2 = ac * ap;
  if(d1 <= 0 && d2 <= 0)
    return {{1, 0, 0}};
  const double d3 = ab * bp, d4 = ac * bp;
  if(d3 >= 0 && d4 <= d3)
    return {{0, 1, 0}};
  const double vc = d1 * d4 - d3 * d2;
  if(vc <= 0 && d1 >= 0 && d3 <= 0)
    return {{1 - d1 / (d1 - d3), d1 / (d1 - d3), 0}};
  const double d5 = ab * cp, d6 = ac * cp;
  if(d6 >= 0 && d5 <= d6)
    return {{0, 0, 1}};
  const double vb = d5 * d2 - d1 * d6;
  if(vb <= 0 && d2 >= 0 && d6 <= 0)
    return {{1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)}};
  const double va = d3 * d6 - d5 * d4, e = d4 - d3, f = d5 - d6;
  if(va <= 0 && e >= 0 && f >= 0)
    return {{0, f / (e + f), e / (e + f)}};
  const double sum = va + vb + vc;
  return {{va / sum, vb / sum, vc / sum}};
}

inline Point point_of(const Corner_table& table, const std::vector<Point>& points, const Surface_location& location)
{
  double sum[3] = {0, 0, 0};
  for(Index i = 0; i < 3; ++i)
    for(int k = 0; k < 3; ++k)
      sum[k] += location.barycentric[i] * points[table.halfedges[3 * location.face + i].source][k];
  return Point(sum[0], sum[1], sum[2]);
}

// The location on a surface that is nearest to a point in space, that in the first face if there are several. A point
// that is further away than a million times the size of the surface is brought as near as that, so that no square
// overflows. Linear.
inline Surface_location nearest_location(const Corner_table& table, const std::vector<Point>& points, const Point& p)
{
  const Index n = number_of_faces(table);
  double bounded[3];
  for(int k = 0; k < 3; ++k)
  {
    double low = points[table.halfedges[0].source][k], high = low;
    for(Index h = 0; h < 3 * n; ++h)
    {
      low = (std::min)(low, points[table.halfedges[h].source][k]);
      high = (std::max)(high, points[table.halfedges[h].source][k]);
    }
    const double room = 1e6 * ((std::max)(std::abs(low), std::abs(high)));
    bounded[k] = (std::min)((std::max)(p[k], low - room), high + room);
  }
  const Point q(bounded[0], bounded[1], bounded[2]);
  Surface_location nearest = {0, {{1, 0, 0}}};
  double least = -1;
  for(Index f = 0; f < n; ++f)
  {
    const Surface_location l = {f, nearest_in_triangle(q, points[table.halfedges[3 * f].source],
                                                       points[table.halfedges[3 * f + 1].source],
                                                       points[table.halfedges[3 * f + 2].source])};
    const double d = (q - point_of(table, points, l)).squared_length();
    if(least < 0 || d < least)
    {
      least = d;
      nearest = l;
    }
  }
  return nearest;
}

// A surface with a vertex more, or the same one if the location is at a vertex; closed by ghosts if it has a boundary.
struct Surface_with_point
{
  // A halfedge beside the new vertex is a piece of an old one, or lies in an old face.
  struct Piece
  {
    Index halfedge;    // of this surface
    Index old;         // null_index if it lies in a face
    double begin, end; // along the old one, from 0 to 1
  };

  Index vertex;    // at the location
  bool is_changed; // otherwise there is nothing else here
  Corner_table table;
  std::vector<Point> points;
  std::vector<Piece> pieces;

  // Where a halfedge was before. Constant.
  Piece piece(Index h) const
  {
    for(const Piece& p : pieces)
      if(p.halfedge == h)
        return p;
    return {h, h, 0, 1};
  }
};

// Puts a point of a surface in as a vertex: its face falls into three, or the two faces at its edge into two each.
// Their first pieces keep the numbers. Linear in the size of the surface.
inline Surface_with_point insert_point(const Corner_table& table, const std::vector<Point>& points,
                                       const Surface_location& location)
{
  const Index e = 3 * location.face, n = 3 * number_of_faces(table);
  const Point p = point_of(table, points, location);
  Surface_with_point result = {null_index, false, {}, {}, {}};
  for(Index i = 0; i < 3; ++i)
  {
    const Index v = table.halfedges[e + i].source;
    if(location.barycentric[i] == 1 || points[v] == p)
    {
      result.vertex = v;
      return result;
    }
  }
  result.is_changed = true;
  const Index w = result.vertex = (std::min)(static_cast<Index>(points.size()), table.first_ghost_vertex);
  std::vector<Index> corners;
  for(Index h = 0; h < n; ++h)
    corners.push_back(table.halfedges[h].source);

  // A face w, a, b, of which the halfedge from a to b is an old one. The first one of a face replaces that.
  const auto add_face = [&](Index first, Index a, Index b, Index old) {
    if(first == null_index)
    {
      first = static_cast<Index>(corners.size());
      corners.resize(corners.size() + 3);
    }
    corners[first] = w;
    corners[first + 1] = a;
    corners[first + 2] = b;
    result.pieces.push_back({first, null_index, 0, 0});
    result.pieces.push_back({first + 1, old, 0, 1});
    result.pieces.push_back({first + 2, null_index, 0, 0});
    return first;
  };
  const auto source = [&](Index h) { return table.halfedges[h].source; };
  const auto on_edge = std::find(location.barycentric.begin(), location.barycentric.end(), 0.0);
  if(on_edge == location.barycentric.end())
    for(Index i = 0; i < 3; ++i)
      add_face(i == 0 ? e : null_index, source(e + i), source(Corner_table::next(e + i)), e + i);
  else
  {
    // the edge is opposite to the corner with the coordinate 0
    const Index apex = e + static_cast<Index>(on_edge - location.barycentric.begin()), along = Corner_table::next(apex);
    const double t = location.barycentric[Corner_table::next(along) - e];
    for(const std::pair<Index, double>& side :
        {std::make_pair(along, t), std::make_pair(table.halfedges[along].opposite, 1 - t)})
    {
      const Index h = side.first; // from u to v, with the new vertex between
      if(h == null_index || h >= n)
        continue;
      const Index next = Corner_table::next(h), prev = Corner_table::prev(h);
      const Index v_side = add_face(3 * (h / 3), source(next), source(prev), next); // w v a
      const Index u_side = add_face(null_index, source(prev), source(h), prev);     // w a u
      result.pieces[result.pieces.size() - 6] = {v_side, h, side.second, 1};
      result.pieces[result.pieces.size() - 1] = {u_side + 2, h, 0, side.second};
    }
  }
  result.points.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(w));
  result.points.push_back(p);
  result.table = make_corner_table(result.points.size(), corners, true);
  if(has_border(result.table))
    close_by_ghosts(result.table, result.points);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H
