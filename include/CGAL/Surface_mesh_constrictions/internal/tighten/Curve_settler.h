// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CURVE_SETTLER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CURVE_SETTLER_H

#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Tightens curves of a network to their final form: closed geodesics, canonical in their flat bands.
class Curve_settler
{
public:
  // `unit` and `angles` of the network's surface, which stays at its level
  Curve_settler(Curve_network& network, const Length_unit& unit, const Corner_angles& angles)
    : m_network(network), m_tightener(network, unit, &angles)
  {}

  Tightening_verdict settle(Index c)
  {
    m_tightener.enqueue_all(c);
    m_tightener.run();
    const Band_report band = settle_flat_band(m_network, c, m_tightener);
    m_band_width = band.width;
    m_leaks += band.leaks;
    if(m_network.is_empty(c))
      return Tightening_verdict::DEGENERATE;
    const Progressive_mesh& pm = m_network.surface();
    return is_simple(pm, trace(pm, arcs_of_curve(m_network, c))) ? Tightening_verdict::CLOSED_GEODESIC
                                                                 : Tightening_verdict::NOT_SIMPLE;
  }

  // of the flat band of the last curve; 0 if it has none
  double band_width() const { return m_band_width; }

  // how often a curve slipped out of a flat band
  std::size_t number_of_leaks() const { return m_leaks; }

private:
  Curve_network& m_network;
  Tightener m_tightener;
  double m_band_width = 0;
  std::size_t m_leaks = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_CURVE_SETTLER_H
