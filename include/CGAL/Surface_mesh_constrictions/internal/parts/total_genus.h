// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TOTAL_GENUS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TOTAL_GENUS_H

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <unordered_set>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The sum of the genera of the connected components of a mesh, with their holes filled. Linear.
template <class TriangleMesh>
std::size_t total_genus(const TriangleMesh& tm)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  std::unordered_set<typename Graph_traits::vertex_descriptor> seen; // isolated vertices do not count
  std::unordered_set<typename Graph_traits::halfedge_descriptor> seen_on_borders;
  std::size_t twice_edges = 0, holes = 0, number_of_faces = 0;
  for(auto f : faces(tm))
  {
    ++number_of_faces;
    for(auto h : halfedges_around_face(halfedge(f, tm), tm))
    {
      seen.insert(target(h, tm));
      ++twice_edges;
      const auto o = opposite(h, tm);
      if(face(o, tm) != Graph_traits::null_face())
        continue;
      ++twice_edges;
      if(!seen_on_borders.insert(o).second)
        continue;
      ++holes;
      for(auto b = next(o, tm); b != o; b = next(b, tm))
        seen_on_borders.insert(b);
    }
  }
  const std::size_t components = Polygon_mesh_processing::connected_components(
      tm, get(CGAL::dynamic_face_property_t<std::size_t>(), tm), CGAL::parameters::default_values());
  return (2 * components + twice_edges / 2 - seen.size() - number_of_faces - holes) / 2;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TOTAL_GENUS_H
