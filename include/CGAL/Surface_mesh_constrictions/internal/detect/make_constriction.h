// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CONSTRICTION_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CONSTRICTION_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/boundary_share.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/curve_measures.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Translates curves of T^0 to the user's mesh.
template <class TriangleMesh>
class Constriction_maker
{
public:
  Constriction_maker(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm,
                     const Surface_sides& sides)
    : m_imported(imported), m_pm(pm), m_sides(sides)
  {}

  // `points` is the accurate trace of the curve. May be called by several threads. Linear in the curve and its seeds.
  Constriction<TriangleMesh> make(const Curve_network& network, Index c, const std::vector<Trace_point>& points,
                                  const std::vector<Seed_curve>& seeds, double band_width,
                                  const Certificate& certificate) const
  {
    typedef Constriction<TriangleMesh> Result;
    const std::vector<Arc> arcs = arcs_of_curve(network, c);
    typename Result::Data data;
    std::size_t arc = 0;
    for(const Trace_point& p : points)
    {
      typename Result::Location location;
      location.is_pivot = p.is_pivot();
      location.parameter = p.parameter;
      if(p.is_pivot())
      {
        location.vertex = m_imported.vertex(p.pivot);
        location.halfedge = typename Result::halfedge_descriptor();
        const Side_angles angles = side_angles(m_pm, arcs[(arc + arcs.size() - 1) % arcs.size()], arcs[arc]);
        data.pivots.push_back({location.vertex, data.locations.size(), angles.left, angles.right});
        ++arc;
      }
      else
      {
        location.vertex = typename Result::vertex_descriptor();
        location.halfedge = m_imported.halfedge_of(p.halfedge);
      }
      data.locations.push_back(location);
    }
    for(const Seed_curve& s : seeds)
    {
      typename Result::Seed seed = {s.level, {}, s.origin};
      for(Index v : s.vertices)
        seed.vertices.push_back(m_imported.vertex(v));
      data.seeds.push_back(std::move(seed));
    }
    const Coordinate_unit& unit = m_imported.unit();
    const double length = accurate_length(m_pm, arcs);
    data.length = unit.restored(length);
    const Parting parting = m_sides.part(points);
    data.separating = parting.is_separating();
    data.homology_class.assign(parting.homology_class.begin(), parting.homology_class.end());
    data.areas = {{unit.restored(parting.areas[0], 2), unit.restored(parting.areas[1], 2)}};
    data.genera = m_sides.genera(points, parting.is_separating());
    data.isoperimetric_ratio = isoperimetric_ratio(length, parting);
    const Curve_measures measures = curve_measures(m_pm, points);
    data.roundness = measures.roundness;
    data.centroid = unit.restored_point(measures.centroid);
    data.normal = {{measures.normal.x, measures.normal.y, measures.normal.z}};
    data.side = m_sides.choked_side(points);
    data.boundary_share = boundary_share(m_pm, arcs, parting);
    data.rim = data.boundary_share > rim_share;
    data.flat_band_width = unit.restored(band_width);
    data.certificate = certificate;
    return Result(std::move(data));
  }

private:
  const Imported_mesh<TriangleMesh>& m_imported;
  const Progressive_mesh& m_pm;
  const Surface_sides& m_sides;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_MAKE_CONSTRICTION_H
