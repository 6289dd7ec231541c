// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_INTERSECTING_CAPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_INTERSECTING_CAPS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// For each cap of a part, a range of its faces by their order, whether one of its faces meets another face of the part,
// or of a cap, in more than common vertices and edges. Faces without area do not count. Cost: that of
// `self_intersections()` for the faces in the bounding boxes of the caps, and linear in the size of the part.
template <class TriangleMesh>
std::vector<bool> intersecting_caps(const TriangleMesh& part, const std::vector<std::array<std::size_t, 2>>& caps)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  std::vector<bool> result(caps.size(), false);
  if(caps.empty())
    return result;
  const std::vector<face_descriptor> all(faces(part).begin(), faces(part).end());
  std::unordered_map<face_descriptor, std::size_t> cap_of_face;
  std::vector<Bbox_3> boxes(caps.size());
  for(std::size_t c = 0; c < caps.size(); ++c)
    for(std::size_t i = caps[c][0]; i < caps[c][1]; ++i)
    {
      cap_of_face.emplace(all[i], c);
      boxes[c] += Polygon_mesh_processing::face_bbox(all[i], part);
    }
  std::vector<face_descriptor> near;
  for(face_descriptor f : all)
  {
    const Bbox_3 box = Polygon_mesh_processing::face_bbox(f, part);
    if(std::any_of(boxes.begin(), boxes.end(), [&box](const Bbox_3& b) { return do_overlap(box, b); }))
      near.push_back(f);
  }
  std::vector<std::pair<face_descriptor, face_descriptor>> pairs;
  Polygon_mesh_processing::self_intersections(near, part, std::back_inserter(pairs));
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
