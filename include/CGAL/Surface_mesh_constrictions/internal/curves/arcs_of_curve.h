// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_CURVE_H

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The measured arcs of a closed curve. Linear, times the degrees of the pivots for arcs along edges.
inline std::vector<Arc> arcs_of_curve(const Progressive_mesh& pm, const Closed_curve& curve)
{
  std::vector<Arc> arcs;
  for(const Closed_curve::Node& n : curve.nodes)
    if(n.is_pivot())
    {
      arcs.emplace_back();
      arcs.back().from = n.pivot;
    }
    else
      arcs.back().crossings.push_back(n.halfedge);
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    arcs[i].to = arcs[(i + 1) % arcs.size()].from;
    if(arcs[i].crossings.empty())
      arcs[i].along = pm.halfedge(arcs[i].from, arcs[i].to);
    measure(pm, arcs[i]);
  }
  return arcs;
}

// The arcs of a curve of a network. Linear.
inline std::vector<Arc> arcs_of_curve(const Curve_network& network, Index c)
{
  std::vector<Arc> arcs;
  network.for_each_arc(c, [&](Index id) { arcs.push_back(network.arc(id)); });
  return arcs;
}

// The other way round: the closed curve that consists of these arcs. Linear.
inline Closed_curve curve_of_arcs(const std::vector<Arc>& arcs)
{
  Closed_curve curve;
  for(const Arc& a : arcs)
  {
    curve.nodes.push_back(Closed_curve::Node{a.from, null_index});
    for(Index h : a.crossings)
      curve.nodes.push_back(Closed_curve::Node{null_index, h});
  }
  return curve;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_CURVE_H
