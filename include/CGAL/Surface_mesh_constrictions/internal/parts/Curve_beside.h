// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve beside a cycle of edges, on its left: it crosses the edges that leave the cycle there, at a distance from it
// that is the given one, or a third of the edge if that is less. So it stays clear of curves beside the other side, and
// beside other cycles.
template <class TriangleMesh>
struct Curve_beside
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  std::vector<typename Constriction<TriangleMesh>::Location> locations;
  std::vector<std::size_t> origins; // of each location, the halfedge of the cycle to the vertex where its edge begins

  // Linear in the number of crossed edges.
  template <class VertexPointMap>
  Curve_beside(const TriangleMesh& tm, VertexPointMap vpm, const std::vector<halfedge_descriptor>& cycle,
               double distance)
  {
    for(std::size_t i = 0; i < cycle.size(); ++i)
    {
      const halfedge_descriptor out = cycle[(i + 1) % cycle.size()];
      for(halfedge_descriptor h = next(cycle[i], tm); h != out; h = next(opposite(h, tm), tm))
      {
        // on both sides of a face between two edges of the cycle is the same edge, which joins their other ends
        if(!locations.empty() && locations.back().halfedge == opposite(h, tm))
        {
          locations.pop_back();
          origins.pop_back();
          continue;
        }
        const auto edge = nearest_point(get(vpm, target(h, tm))) - nearest_point(get(vpm, source(h, tm)));
        const double length = std::sqrt(edge.squared_length());
        locations.push_back({false, vertex_descriptor(), h, distance < length / 3 ? distance / length : 1. / 3});
        origins.push_back(i);
      }
    }
    while(locations.size() > 1 && locations.front().halfedge == opposite(locations.back().halfedge, tm))
    {
      locations.pop_back();
      origins.pop_back();
      locations.erase(locations.begin());
      origins.erase(origins.begin());
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_BESIDE_H
