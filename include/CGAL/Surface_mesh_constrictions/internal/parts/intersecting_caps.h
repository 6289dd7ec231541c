// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_INTERSECTING_CAPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_INTERSECTING_CAPS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// For each cap, given by its faces, whether one of them meets another face of the mesh, or of a cap, in more than
// common vertices and edges. Faces without area do not count. Cost: that of `self_intersections()` for the faces in the
// bounding boxes of the caps, and linear in the size of the mesh.
template <class TriangleMesh, class VertexPointMap>
std::vector<bool>
intersecting_caps(const TriangleMesh& tm, VertexPointMap vpm,
                  const std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>>& caps)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  std::vector<bool> result(caps.size(), false);
  if(caps.empty())
    return result;
  const auto np = CGAL::parameters::vertex_point_map(vpm);
  std::unordered_map<face_descriptor, std::size_t> cap_of_face;
  std::vector<Bbox_3> boxes(caps.size());
  for(std::size_t c = 0; c < caps.size(); ++c)
    for(face_descriptor f : caps[c])
    {
      cap_of_face.emplace(f, c);
      boxes[c] += Polygon_mesh_processing::face_bbox(f, tm, np);
    }
  std::vector<face_descriptor> near;
  for(face_descriptor f : faces(tm))
  {
    const Bbox_3 box = Polygon_mesh_processing::face_bbox(f, tm, np);
    if(std::any_of(boxes.begin(), boxes.end(), [&box](const Bbox_3& b) { return do_overlap(box, b); }))
      near.push_back(f);
  }
  std::vector<std::pair<face_descriptor, face_descriptor>> pairs;
  Polygon_mesh_processing::self_intersections(near, tm, std::back_inserter(pairs), np);
  for(const auto& [f, g] : pairs)
    for(face_descriptor x : {f, g})
    {
      const auto cap = cap_of_face.find(x);
      if(f != g && cap != cap_of_face.end())
        result[cap->second] = true;
    }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_INTERSECTING_CAPS_H
