// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/boundary_share.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/curve_measures.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Translates geodesic loops to the user's mesh, and finds what they become when they are let go.
template <class TriangleMesh, class VertexPointMap>
class Geodesic_loop_maker
{
  typedef Geodesic_loop<TriangleMesh> Result;
  typedef typename Result::Face_location Face_location;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

public:
  // `pm` is the user's mesh, `with` the same with the location put in. Linear.
  Geodesic_loop_maker(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm,
                      const Progressive_mesh& with, const Surface_with_point& inserted, const Surface_location& at,
                      VertexPointMap vpm, bool certifies)
    : m_imported(imported), m_pm(pm), m_with(with), m_inserted(inserted), m_at(at), m_sides(pm), m_network(pm, false),
      m_angles(pm), m_settler(m_network, Length_unit(pm), m_angles), m_exact_settler(pm, imported, vpm),
      m_constriction_maker(imported, pm, m_sides), m_certifies(certifies)
  {
    if(inserted.is_changed)
      m_sides_with.emplace(with);
  }

  // Of a geodesic loop of the surface with the location. Cost: that of `Constriction_maker::make()`, plus that of
  // tightening the loop when it is let go.
  Result make(const std::vector<Arc>& loop)
  {
    Result result;
    place(loop, result);
    measure(loop, result);
    let_go(loop, result);
    return result;
  }

private:
  // Its points, the vertices among them, and the angles at these.
  void place(const std::vector<Arc>& loop, Result& result)
  {
    std::size_t arc = 0;
    for(const Trace_point& p : accurate_trace(m_with, loop))
    {
      if(!p.is_pivot())
      {
        const Surface_with_point::Piece piece = m_inserted.piece(p.halfedge);
        if(piece.old != null_index)
          result.locations.push_back(crossing(piece.old, piece.begin + p.parameter * (piece.end - piece.begin)));
        continue;
      }
      const Side_angles angles = side_angles(m_with, loop[(arc + loop.size() - 1) % loop.size()], loop[arc]);
      if(arc++ == 0)
      {
        result.left_angle = angles.left;
        result.right_angle = angles.right;
      }
      if(m_inserted.is_changed && p.pivot == m_inserted.vertex)
        result.locations.push_back(held());
      else
      {
        result.pivots.push_back({m_imported.vertex(p.pivot), result.locations.size(), angles.left, angles.right});
        result.locations.push_back(corner(m_pm.outgoing(p.pivot)));
      }
    }
    result.is_closed_geodesic = (std::min)(result.left_angle, result.right_angle) >= CGAL_PI - flat_tolerance;
  }

  void measure(const std::vector<Arc>& loop, Result& result) const
  {
    const Coordinate_unit& unit = m_imported.unit();
    const double length = total_length(loop);
    const Surface_sides& sides = m_sides_with ? *m_sides_with : m_sides;
    const std::vector<Trace_point> points = accurate_trace(m_with, loop);
    const Parting parting = sides.part(points);
    const Curve_measures measures = curve_measures(m_with, points);
    result.length = unit.restored(length);
    result.separating = parting.is_separating();
    result.areas = {{unit.restored(parting.areas[0], 2), unit.restored(parting.areas[1], 2)}};
    result.genera = sides.genera(points, parting.is_separating());
    result.isoperimetric_ratio = isoperimetric_ratio(length, parting.areas);
    result.roundness = measures.roundness;
    result.centroid = unit.restored_point(measures.centroid);
    result.normal = {{measures.normal.x, measures.normal.y, measures.normal.z}};
    result.side = sides.choked_side(points);
    result.boundary_share = boundary_share(m_with, loop, parting);
  }

  void let_go(const std::vector<Arc>& loop, Result& result)
  {
    std::vector<Arc> arcs = loop;
    if(m_inserted.is_changed)
      arcs = arcs_without_vertices(
          m_with, loop, [this](Index h) { return m_inserted.piece(h).old; },
          [this](Index v) { return v != m_inserted.vertex; }, m_pm);
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    result.verdict = m_settler.settle(c);
    double band_width = m_settler.band_width();
    Certificate certificate;
    if(m_certifies && !m_network.is_empty(c))
    {
      certificate = m_exact_settler.settle(m_network, c);
      band_width = m_imported.unit().divided(certificate.flat_band_width);
      result.verdict = tightening_verdict(certificate, m_network.is_empty(c));
    }
    if(result.verdict == Tightening_verdict::CLOSED_GEODESIC)
    {
      const Seed_curve seed = {0, {}, Seed_origin::CUT_LOCUS};
      result.let_go =
          m_constriction_maker.make(m_network, c, std::vector<Seed_curve>(1, seed), band_width, certificate);
    }
    m_network.remove(c);
  }

  // A location at the source of a halfedge out of a vertex, in a face that is no ghost.
  Face_location corner(Index h) const
  {
    while(m_pm.is_ghost_face(m_pm.face(h)))
      h = m_pm.ccw(h);
    return location(h, {{1, 0, 0}});
  }

  // A crossing of a halfedge is not at an end of it, so that the halfedge can be told from the numbers.
  Face_location crossing(Index h, double parameter) const
  {
    const double t = (std::min)((std::max)(parameter, (std::numeric_limits<double>::min)()),
                                1 - std::numeric_limits<double>::epsilon() / 2);
    return location(h, {{1 - t, t, 0}});
  }

  Face_location held() const { return location(3 * m_at.face, m_at.barycentric); }

  // Barycentric coordinates with respect to the source of a halfedge, its target, and the third corner of its face.
  Face_location location(Index h, const std::array<double, 3>& barycentric) const
  {
    const TriangleMesh& tm = m_imported.mesh();
    const halfedge_descriptor given = m_imported.halfedge_of(h);
    Face_location result(face(given, tm), {{0, 0, 0}});
    halfedge_descriptor first = halfedge(result.first, tm), i = given;
    for(std::size_t k = 0; k < 3; ++k, i = next(i, tm))
    {
      halfedge_descriptor j = first;
      for(std::size_t place = 0; place < 3; ++place, j = next(j, tm))
        if(j == i)
          result.second[place] = barycentric[k];
    }
    return result;
  }

  const Imported_mesh<TriangleMesh>& m_imported;
  const Progressive_mesh &m_pm, &m_with;
  const Surface_with_point& m_inserted;
  const Surface_location m_at;
  const Surface_sides m_sides;
  std::optional<Surface_sides> m_sides_with; // if the surface with the location is another one
  Curve_network m_network;
  const Corner_angles m_angles;
  Curve_settler m_settler;
  Exact_settler<TriangleMesh, VertexPointMap> m_exact_settler;
  Constriction_maker<TriangleMesh> m_constriction_maker;
  const bool m_certifies;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_GEODESIC_LOOP_MAKER_H
