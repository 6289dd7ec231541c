// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_PATH_BESIDE_CURVE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_PATH_BESIDE_CURVE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/remove_spurs.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The vertices that a closed curve passes: its pivots, and of each edge that it crosses the end on its left. Linear.
inline std::vector<Index> vertices_passed(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> vertices;
  for(const Trace_point& p : trace)
    vertices.push_back(p.is_pivot() ? p.pivot : pm.target(p.halfedge));
  return vertices;
}

// The closed path of edges beside a closed curve without pivots that crosses these halfedges, on its left; along the
// rims of holes where it crosses edges of ghosts. Linear.
inline std::vector<Index> path_inside(const Progressive_mesh& pm, const Strip& strip)
{
  std::vector<Index> path;
  for(Index h : strip)
    path.push_back(pm.is_ghost_vertex(pm.target(h)) ? pm.source(h) : pm.target(h));
  remove_spurs(path);
  return path;
}

// The vertices beside a curve: its pivots, and of each edge that it crosses the nearer end; each adjacent or equal to
// the next. Linear.
inline std::vector<Index> vertices_beside(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> path;
  for(const Trace_point& p : trace)
    path.push_back(p.is_pivot() ? p.pivot : p.parameter < 0.5 ? pm.source(p.halfedge) : pm.target(p.halfedge));
  return path;
}

// The closed path of edges beside a closed curve: each crossing is moved to the nearer end of its edge. Fewer than
// three vertices if the path shrinks to a point or an edge forth and back. Linear.
inline std::vector<Index> path_beside_curve(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> path = vertices_beside(pm, trace);
  remove_spurs(path);
  return path;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_PATH_BESIDE_CURVE_H
