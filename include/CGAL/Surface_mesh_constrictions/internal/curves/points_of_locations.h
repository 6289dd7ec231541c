// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_POINTS_OF_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_POINTS_OF_LOCATIONS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Writes the points of locations in faces: a face, and barycentric coordinates that begin with the source of its
// halfedge. Linear.
template <class FaceLocations, class TriangleMesh, class VertexPointMap, class OutputIterator>
OutputIterator points_of_locations(const FaceLocations& locations, const TriangleMesh& tm, VertexPointMap vpm,
                                   OutputIterator out)
{
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  typedef typename Kernel_traits<Point>::Kernel::FT FT;
  for(const auto& l : locations)
  {
    std::array<FT, 3> sum = {{FT(0), FT(0), FT(0)}};
    auto h = halfedge(l.first, tm);
    for(std::size_t i = 0; i < 3; ++i, h = next(h, tm))
    {
      const Point& p = get(vpm, source(h, tm));
      const FT b(l.second[i]);
      sum = {{FT(sum[0] + b * p.x()), FT(sum[1] + b * p.y()), FT(sum[2] + b * p.z())}};
    }
    *out++ = Point(sum[0], sum[1], sum[2]);
  }
  return out;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_POINTS_OF_LOCATIONS_H
