// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
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

inline Point point_of(const Progressive_mesh& pm, const Surface_location& location)
{
  double sum[3] = {0, 0, 0};
  for(Index i = 0; i < 3; ++i)
    for(int k = 0; k < 3; ++k)
      sum[k] += location.barycentric[i] * pm.point(pm.source(3 * location.face + i))[k];
  return Point(sum[0], sum[1], sum[2]);
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

// Joins faces that have got new corners, on a closed surface: the vertex w, then the ends of a halfedge that had the
// given opposite. Each is given by its first halfedge. Linear in the degrees of the corners.
inline void join_new_faces(Corner_table& table, const std::vector<std::pair<Index, Index>>& faces)
{
  const auto join = [&table](Index h, Index o) {
    table.halfedges[h].opposite = o;
    table.halfedges[o].opposite = h;
  };
  for(const auto& [first, opposite] : faces)
  {
    join(first + 1, opposite);
    for(const auto& [other, its_opposite] : faces)
      if(table.halfedges[first + 1].source == table.halfedges[other + 2].source)
        join(first, other + 2);
  }
  const auto set_outgoing = [&table](Index h) {
    const Index begin = h;
    Index least = h;
    while((h = table.halfedges[Corner_table::prev(h)].opposite) != begin)
      least = (std::min)(least, h);
    table.outgoing[table.halfedges[h].source] = least;
  };
  for(const auto& face : faces)
    for(Index h = face.first; h < face.first + 3; ++h)
      set_outgoing(h);
}

// Puts a point of T^0 in as a vertex: its face falls into three, or the two faces at its edge into two each. Their
// first pieces keep the numbers. Linear in the size of the surface, for the copy; on a closed surface the rest depends
// on the degrees of the corners alone.
inline Surface_with_point insert_point(const Progressive_mesh& pm, const Surface_location& location)
{
  const Corner_table& table = pm.connectivity();
  const Index e = 3 * location.face,
              n = (std::min)(static_cast<Index>(table.halfedges.size() / 3), table.first_ghost_face) * 3;
  const Point p = point_of(pm, location);
  Surface_with_point result = {null_index, false, {}, {}, {}};
  for(Index i = 0; i < 3; ++i)
  {
    const Index v = pm.source(e + i);
    if(location.barycentric[i] == 1 || pm.point(v) == p)
    {
      result.vertex = v;
      return result;
    }
  }
  result.is_changed = true;
  const Index w = result.vertex = (std::min)(static_cast<Index>(pm.points().size()), table.first_ghost_vertex);

  // Faces w, a, b, of which the halfedge from a to b is an old one. The first one of a face replaces that.
  struct Piece_of_face
  {
    Index first, a, b, old;
  };
  std::vector<Piece_of_face> faces;
  Index end = n;
  const auto add_face = [&](Index first, Index a, Index b, Index old) {
    if(first == null_index)
    {
      first = end;
      end += 3;
    }
    faces.push_back({first, a, b, old});
    result.pieces.push_back({first, null_index, 0, 0});
    result.pieces.push_back({first + 1, old, 0, 1});
    result.pieces.push_back({first + 2, null_index, 0, 0});
    return first;
  };
  const auto on_edge = std::find(location.barycentric.begin(), location.barycentric.end(), 0.0);
  if(on_edge == location.barycentric.end())
    for(Index i = 0; i < 3; ++i)
      add_face(i == 0 ? e : null_index, pm.source(e + i), pm.target(e + i), e + i);
  else
  {
    // the edge is opposite to the corner with the coordinate 0
    const Index apex = e + static_cast<Index>(on_edge - location.barycentric.begin()), along = Corner_table::next(apex);
    const double t = location.barycentric[Corner_table::next(along) - e];
    for(const std::pair<Index, double>& side : {std::make_pair(along, t), std::make_pair(pm.opposite(along), 1 - t)})
    {
      const Index h = side.first; // from u to v, with the new vertex between
      if(pm.is_ghost_face(pm.face(h)))
        continue;
      const Index next = Corner_table::next(h), prev = Corner_table::prev(h);
      const Index v_side = add_face(3 * pm.face(h), pm.source(next), pm.source(prev), next); // w v a
      const Index u_side = add_face(null_index, pm.source(prev), pm.source(h), prev);        // w a u
      result.pieces[result.pieces.size() - 6] = {v_side, h, side.second, 1};
      result.pieces[result.pieces.size() - 1] = {u_side + 2, h, 0, side.second};
    }
  }

  if(!pm.has_boundary())
  {
    std::vector<std::pair<Index, Index>> joined;
    for(const Piece_of_face& f : faces)
      joined.emplace_back(f.first, pm.opposite(f.old));
    result.table.halfedges.reserve(end);
    result.table.halfedges = table.halfedges;
    result.table.halfedges.resize(end);
    result.table.outgoing.reserve(table.outgoing.size() + 1);
    result.table.outgoing = table.outgoing;
    result.table.outgoing.push_back(null_index);
    for(const Piece_of_face& f : faces)
    {
      result.table.halfedges[f.first].source = w;
      result.table.halfedges[f.first + 1].source = f.a;
      result.table.halfedges[f.first + 2].source = f.b;
    }
    join_new_faces(result.table, joined);
    result.points.reserve(pm.points().size() + 1);
    result.points = pm.points();
    result.points.push_back(p);
    return result;
  }

  // ghosts follow all other elements, so they are made anew
  std::vector<Index> corners;
  corners.reserve(end);
  for(Index h = 0; h < n; ++h)
    corners.push_back(pm.source(h));
  corners.resize(end);
  for(const Piece_of_face& f : faces)
  {
    corners[f.first] = w;
    corners[f.first + 1] = f.a;
    corners[f.first + 2] = f.b;
  }
  result.points.assign(pm.points().begin(), pm.points().begin() + static_cast<std::ptrdiff_t>(w));
  result.points.push_back(p);
  result.table = make_corner_table(result.points.size(), corners, true);
  close_by_ghosts(result.table, result.points);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_INSERT_POINT_H
