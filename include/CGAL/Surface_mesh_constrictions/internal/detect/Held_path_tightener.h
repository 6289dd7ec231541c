// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_PATH_TIGHTENER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_PATH_TIGHTENER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Tightens paths of edges that are held at both ends, one after the other.
template <class TriangleMesh, class VertexPointMap>
class Held_path_tightener
{
public:
  // `pm` has been made of `imported`; `unit` and `angles` are those of `pm`.
  Held_path_tightener(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm, VertexPointMap vpm,
                      const Length_unit& unit, const Corner_angles& angles)
    : m_network(pm, false), m_tightener(m_network, unit, &angles), m_exact_settler(pm, imported, vpm)
  {}

  // The arcs that a path ends as; none if it shrinks to the one vertex that it is held at. Linear in the lengths of the
  // strips that it is led through.
  std::vector<Arc> tighten(const std::vector<Index>& path)
  {
    const Progressive_mesh& pm = m_network.surface();
    std::vector<Arc> arcs(path.size() - 1);
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      arcs[i].from = path[i];
      arcs[i].to = path[i + 1];
      arcs[i].along = pm.halfedge(path[i], path[i + 1]);
      measure(pm, arcs[i]);
    }
    const Index c = m_network.add_curve(0);
    m_network.set_arcs(c, arcs);
    m_tightener.hold(path.front() == path.back() ? path.front() : null_index);
    m_tightener.enqueue_all(c);
    m_tightener.run();
    arcs = arcs_of_curve(m_network, c);
    m_network.remove(c);
    std::size_t first = 0;
    while(first < arcs.size() &&
          !(arcs[first].from == path.front() && arcs[(first + arcs.size() - 1) % arcs.size()].to == path.back()))
      ++first;
    std::rotate(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(first), arcs.end());
    return arcs;
  }

  // See `Exact_settler::settle_path()`.
  Certificate settle(std::vector<Arc>& arcs) { return m_exact_settler.settle_path(arcs); }

private:
  Curve_network m_network;
  Tightener m_tightener;
  Exact_settler<TriangleMesh, VertexPointMap> m_exact_settler;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_HELD_PATH_TIGHTENER_H
