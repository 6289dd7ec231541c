// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CLOSED_PATH_TIGHTENER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CLOSED_PATH_TIGHTENER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// What an exactly certified curve has been tightened to.
inline Tightening_verdict tightening_verdict(const Certificate& certificate, bool is_degenerate)
{
  if(is_degenerate)
    return Tightening_verdict::DEGENERATE;
  switch(certificate.verdict)
  {
  case Certificate_verdict::STRICT_CONSTRICTION:
  case Certificate_verdict::CONSTRICTION:
    return Tightening_verdict::CLOSED_GEODESIC;
  case Certificate_verdict::CROSSES_ITSELF:
  case Certificate_verdict::TOUCHES_ITSELF:
    return Tightening_verdict::NOT_SIMPLE;
  default:
    return Tightening_verdict::NOT_CERTIFIED;
  }
}

// Tightens closed paths of edges of a mesh, one after the other.
template <class TriangleMesh, class VertexPointMap>
class Closed_path_tightener
{
public:
  // `pm` has been made of `imported`; `unit` and `sides` are those of `pm`.
  Closed_path_tightener(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm, VertexPointMap vpm,
                        const Length_unit& unit, const Surface_sides& sides, bool certifies)
    : m_unit(imported.unit()), m_certifies(certifies), m_network(pm, false), m_angles(pm),
      m_settler(m_network, unit, m_angles), m_exact_settler(pm, imported, vpm), m_maker(imported, pm, sides)
  {}

  // The path is the origin of the curve in its seeds. Cost: that of `tighten_closed_curves()` without that of the mesh.
  Tightened_curve<TriangleMesh> tighten(std::vector<Index> path)
  {
    const Index c = m_network.add_curve(0, path);
    return tighten(c, {0, std::move(path), Seed_origin::USER});
  }

  // The same for a closed curve that is given by its arcs, of this origin.
  Tightened_curve<TriangleMesh> tighten(std::vector<Arc> arcs, Seed_origin origin)
  {
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    return tighten(c, {0, {}, origin});
  }

  const Corner_angles& angles() const { return m_angles; }

private:
  Tightened_curve<TriangleMesh> tighten(Index c, const Seed_curve& seed)
  {
    Tightened_curve<TriangleMesh> result;
    result.verdict = m_settler.settle(c);
    double band_width = m_settler.band_width();
    if(m_certifies && !m_network.is_empty(c))
    {
      result.certificate = m_exact_settler.settle(m_network, c);
      band_width = m_unit.divided(result.certificate.flat_band_width);
      result.verdict = tightening_verdict(result.certificate, m_network.is_empty(c));
    }
    if(result.verdict == Tightening_verdict::CLOSED_GEODESIC)
      result.curve = m_maker.make(m_network, c, accurate_trace(m_network.surface(), arcs_of_curve(m_network, c)),
                                  std::vector<Seed_curve>(1, seed), band_width, result.certificate);
    m_network.remove(c);
    return result;
  }

  const Coordinate_unit m_unit;
  const bool m_certifies;
  Curve_network m_network;
  const Corner_angles m_angles;
  Curve_settler m_settler;
  Exact_settler<TriangleMesh, VertexPointMap> m_exact_settler;
  Constriction_maker<TriangleMesh> m_maker;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CLOSED_PATH_TIGHTENER_H
