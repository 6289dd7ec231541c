// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVES_ON_COPY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVES_ON_COPY_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Graph_connectivity.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Constrictions of a mesh on its copy.
template <class TriangleMesh, class VertexIndexMap>
class Curves_on_copy
{
public:
  // Throws Invalid_input if one is no closed curve on the mesh. Linear.
  Curves_on_copy(const std::vector<Constriction<TriangleMesh>>& constrictions,
                 const Imported_mesh<TriangleMesh>& imported, VertexIndexMap vim, const Progressive_mesh& pm)
    : m_tm(imported.mesh()), m_vim(vim), m_pm(pm)
  {
    for(Index v = 0; v < imported.number_of_vertices(); ++v)
      m_vertices.emplace(get(vim, imported.vertex(v)), v);
    for(const Constriction<TriangleMesh>& c : constrictions)
    {
      arcs.push_back(arcs_on_copy(arcs_on_mesh(m_tm, c.locations(), arcs.size())));
      traces.emplace_back();
      for(const auto& l : c.locations())
        traces.back().push_back(l.is_pivot ? Trace_point{vertex(l.vertex), null_index, 0}
                                           : Trace_point{null_index, halfedge(l.halfedge), l.parameter});
    }
  }

  std::vector<std::vector<Trace_point>> traces;
  std::vector<std::vector<Arc>> arcs;

private:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

  Index vertex(typename Graph_traits::vertex_descriptor v) const { return m_vertices.at(get(m_vim, v)); }

  Index halfedge(typename Graph_traits::halfedge_descriptor h) const
  {
    return m_pm.halfedge(vertex(source(h, m_tm)), vertex(target(h, m_tm)));
  }

  Strip strip(const std::vector<typename Graph_traits::halfedge_descriptor>& crossings) const
  {
    Strip result;
    for(auto h : crossings)
      result.push_back(halfedge(h));
    return result;
  }

  // A curve without pivots gets the one around which its strip is shortest.
  std::vector<Arc> arcs_on_copy(const Arcs_of_locations<Graph_connectivity<TriangleMesh>>& curve) const
  {
    std::vector<Arc> result;
    if(curve.arcs.empty())
    {
      const Closed_strip closed(m_pm, strip(curve.closed_strip));
      String_puller puller(m_pm);
      if(!closed.is_degenerate())
        result = closed.shortest_loop(closed.foremost_corner(closed.inner_side()), puller);
    }
    for(const auto& arc : curve.arcs)
    {
      const Strip crossings = strip(arc.crossings);
      result.emplace_back();
      result.back().from = vertex(arc.from);
      result.back().to = vertex(arc.to);
      result.back().crossings.assign(crossings.begin(), crossings.end());
      if(arc.is_edge())
        result.back().along = halfedge(arc.along);
      measure(m_pm, result.back());
    }
    return result;
  }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  const Progressive_mesh& m_pm;
  std::unordered_map<std::size_t, Index> m_vertices; // by the user's index
};

template <class TriangleMesh, class VertexIndexMap>
Curves_on_copy<TriangleMesh, VertexIndexMap>
curves_on_copy(const std::vector<Constriction<TriangleMesh>>& constrictions,
               const Imported_mesh<TriangleMesh>& imported, VertexIndexMap vim, const Progressive_mesh& pm)
{
  return Curves_on_copy<TriangleMesh, VertexIndexMap>(constrictions, imported, vim, pm);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_CURVES_ON_COPY_H
