// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H

#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/boundary_share.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/curve_measures.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Closed_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Face_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Translates geodesic loops to the user's mesh, and finds the curves that they become when they are let go.
template <class TriangleMesh, class VertexPointMap>
class Geodesic_loop_maker
{
  typedef Geodesic_loop<TriangleMesh> Result;

public:
  // `with` is the prepared surface with the location put in.
  Geodesic_loop_maker(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared, const Progressive_mesh& with,
                      const Surface_with_point& inserted, const Surface_location& at, bool certifies)
    : m_imported(prepared.imported()), m_pm(prepared.surface()), m_with(with), m_inserted(inserted), m_at(at),
      m_sides(prepared.sides()), m_locations(m_imported, m_pm),
      m_tightener(m_imported, m_pm, prepared.vertex_point_map(), prepared.length_unit(), m_sides, certifies)
  {}

  // The result for a geodesic loop of the surface with the location put in. The loop starts at the location. Cost: that
  // of `Constriction_maker::make()`, plus that of tightening the loop when it is let go.
  Result make(const std::vector<Arc>& loop)
  {
    Result result;
    place(loop, result);
    measure(loop, result);
    let_go(loop, result);
    return result;
  }

private:
  // Sets the points of the loop, the vertices among them, and the angles at these vertices.
  void place(const std::vector<Arc>& loop, Result& result)
  {
    std::size_t arc = 0;
    for(const Trace_point& p : accurate_trace(m_with, loop))
    {
      if(!p.is_pivot())
      {
        const Surface_with_point::Piece piece = m_inserted.piece(p.halfedge);
        if(piece.old != null_index)
          result.locations.push_back(
              m_locations.crossing(piece.old, piece.begin + p.parameter * (piece.end - piece.begin)));
        continue;
      }
      const Side_angles angles = side_angles(m_with, loop[(arc + loop.size() - 1) % loop.size()], loop[arc]);
      if(arc++ == 0)
      {
        result.left_angle = angles.left;
        result.right_angle = angles.right;
      }
      if(m_inserted.is_changed && p.pivot == m_inserted.vertex)
        result.locations.push_back(m_locations.at(m_at));
      else
      {
        result.pivots.push_back({m_imported.vertex(p.pivot), result.locations.size(), angles.left, angles.right});
        result.locations.push_back(m_locations.corner(p.pivot));
      }
    }
    result.is_closed_geodesic = (std::min)(result.left_angle, result.right_angle) >= CGAL_PI - flat_tolerance;
  }

  void measure(const std::vector<Arc>& loop, Result& result) const
  {
    const Coordinate_unit& unit = m_imported.unit();
    const double length = accurate_length(m_with, loop);
    const std::vector<Trace_point> points = accurate_trace(m_with, loop);
    const Parting parting = part(points);
    const Curve_measures measures = curve_measures(m_with, points);
    result.length = unit.restored(length);
    result.separating = parting.is_separating();
    result.areas = {{unit.restored(parting.areas[0], 2), unit.restored(parting.areas[1], 2)}};
    result.genera = m_sides.genera_beside(crossings_of_surface(points), parting.is_separating());
    result.isoperimetric_ratio = isoperimetric_ratio(length, parting.areas);
    result.roundness = measures.roundness;
    result.centroid = unit.restored_point(measures.centroid);
    result.normal = {{measures.normal.x, measures.normal.y, measures.normal.z}};
    result.side = m_sides.choked_side(m_with, points, m_at.face);
    result.boundary_share = boundary_share(m_with, loop, parting);
  }

  // How a loop parts the surface. The path beside the loop may pass the vertex that has been put in. Then the path is
  // led past a corner of the face, or past an end of the edge, instead; the area between the two paths is that of flat
  // triangles.
  Parting part(const std::vector<Trace_point>& points) const
  {
    std::vector<Index> path = vertices_passed(m_with, points);
    double between = Surface_sides::area_between(m_with, points, path);
    if(m_inserted.is_changed)
    {
      const Index w = m_inserted.vertex;
      const Index corner = m_pm.source(is_on_edge() ? Progressive_mesh::next(apex()) : 3 * m_at.face);
      for(std::size_t i = 0; i < path.size(); ++i)
      {
        const Index u = path[i], v = path[(i + 1) % path.size()];
        if((u == w) != (v == w))
          between += area(corner, u, v, u == w ? v : u);
      }
      std::replace(path.begin(), path.end(), w, corner);
    }
    return m_sides.part(path, between);
  }

  // Whether the location that has been put in is on an edge; and, if it is, the halfedge out of the corner opposite to
  // this edge.
  bool is_on_edge() const
  {
    return std::find(m_at.barycentric.begin(), m_at.barycentric.end(), 0.0) != m_at.barycentric.end();
  }
  Index apex() const
  {
    return 3 * m_at.face + static_cast<Index>(std::find(m_at.barycentric.begin(), m_at.barycentric.end(), 0.0) -
                                              m_at.barycentric.begin());
  }

  // The area of the triangle a, u, v, one of whose corners has been put in, as a part of its face; negative if the
  // triangle is clockwise. `old` is the one of u and v that has not been put in.
  double area(Index a, Index u, Index v, Index old) const
  {
    Index f = m_at.face;
    if(is_on_edge())
    {
      const Index along = Progressive_mesh::next(apex());
      if(old == m_pm.source(along) || old == m_pm.target(along))
        return 0;
      if(old != m_pm.source(apex()))
        f = m_pm.face(m_pm.opposite(along));
    }
    const Vector3 p = position(m_pm, m_pm.source(3 * f));
    const Vector3 normal =
        cross(position(m_pm, m_pm.source(3 * f + 1)) - p, position(m_pm, m_pm.source(3 * f + 2)) - p);
    const double length = norm(normal);
    const Vector3 q = position(m_with, a);
    return length > 0 ? dot(cross(position(m_with, u) - q, position(m_with, v) - q), normal) / length / 2 : 0;
  }

  // The halfedge of the surface without the location that h, of the surface with the location, is a piece of;
  // null_index if h lies in a face. Ghost faces have other numbers on that surface: each is found by its edge of the
  // hole, which is its first halfedge.
  Index old_halfedge(Index h) const
  {
    if(!m_with.is_ghost_face(m_with.face(h)))
      return m_inserted.piece(h).old;
    const Index place = h % 3;
    const Surface_with_point::Piece beside = m_inserted.piece(m_with.opposite(h - place));
    if((place == 1 && beside.begin > 0) || (place == 2 && beside.end < 1))
      return null_index; // from the location to the ghost
    return m_pm.opposite(beside.old) + place;
  }

  // The halfedges of the surface without the location that a loop crosses when, at its vertices and at the location, it
  // is moved a little to its left.
  std::vector<Index> crossings_of_surface(const std::vector<Trace_point>& points) const
  {
    std::vector<Index> crossings;
    for(Index h : crossings_beside_pivots(m_with, points))
    {
      const Index old = m_inserted.is_changed ? old_halfedge(h) : h;
      if(old == null_index)
        continue;
      if(!crossings.empty() && crossings.back() == m_pm.opposite(old))
        crossings.pop_back();
      else
        crossings.push_back(old);
    }
    std::size_t begin = 0, end = crossings.size();
    while(end - begin > 2 && crossings[begin] == m_pm.opposite(crossings[end - 1]))
    {
      ++begin;
      --end;
    }
    return std::vector<Index>(crossings.begin() + static_cast<std::ptrdiff_t>(begin),
                              crossings.begin() + static_cast<std::ptrdiff_t>(end));
  }

  void let_go(const std::vector<Arc>& loop, Result& result)
  {
    std::vector<Arc> arcs = loop;
    if(m_inserted.is_changed)
      arcs = arcs_without_vertices(
          m_with, loop, [this](Index h) { return m_inserted.piece(h).old; },
          [this](Index v) { return v != m_inserted.vertex; }, m_pm);
    Tightened_curve<TriangleMesh> tightened = m_tightener.tighten(std::move(arcs), Seed_origin::CUT_LOCUS);
    result.verdict = tightened.verdict;
    result.let_go = std::move(tightened.curve);
  }

  const Imported_mesh<TriangleMesh>& m_imported;
  const Progressive_mesh &m_pm, &m_with;
  const Surface_with_point& m_inserted;
  const Surface_location m_at;
  const Surface_sides& m_sides;
  const Face_locations<TriangleMesh> m_locations;
  Closed_path_tightener<TriangleMesh, VertexPointMap> m_tightener;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H
