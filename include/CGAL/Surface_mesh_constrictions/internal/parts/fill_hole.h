// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FILL_HOLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FILL_HOLE_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/iterator.h>
#include <CGAL/version.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Fills the hole of a border halfedge with Polygon Mesh Processing's triangulation, which has no new vertices; where it
// finds none, with the cone to the mean of the vertices of the hole.
template <class TriangleMesh>
void fill_hole(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, TriangleMesh& mesh)
{
  namespace PMP = Polygon_mesh_processing;
#if CGAL_VERSION_NR >= 1050600000
  PMP::triangulate_hole(mesh, h);
#else
  PMP::triangulate_hole(mesh, h, Emptyset_iterator());
#endif
  if(!is_border(h, mesh))
    return;
  const auto vpm = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  typedef typename Kernel_traits<Point>::Kernel Kernel;
  typename Kernel::Vector_3 sum = NULL_VECTOR;
  typename Kernel::FT n = 0;
  for(auto v : vertices_around_face(h, mesh))
  {
    sum = sum + (get(vpm, v) - Point(ORIGIN));
    n += 1;
  }
  Euler::fill_hole(h, mesh);
  put(vpm, target(Euler::add_center_vertex(h, mesh), mesh), Point(ORIGIN) + sum / n);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FILL_HOLE_H
