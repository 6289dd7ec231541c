// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SHRINKS_IN_SMALL_DISC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SHRINKS_IN_SMALL_DISC_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>

#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Angles that differ by less than this, in radians, are taken to be equal.
constexpr double disc_angle_tolerance = 1e-9;

// The faces on the left of a loop, given by its halfedges, and all that are reached from them without crossing it.
// Returns whether there are no more than `most` of them, and none is a ghost.
inline bool find_faces_inside(const Progressive_mesh& pm, const boost::container::small_vector_base<Index>& loop,
                              std::size_t most, boost::container::small_vector_base<Index>& faces)
{
  faces.clear();
  const auto add = [&](Index f) {
    if(std::find(faces.begin(), faces.end(), f) == faces.end())
      faces.push_back(f);
  };
  for(Index h : loop)
    add(pm.face(h));
  for(std::size_t i = 0; i < faces.size(); ++i)
  {
    if(faces.size() > most || pm.is_ghost_face(faces[i]))
      return false;
    for(Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h)
      if(std::find(loop.begin(), loop.end(), h) == loop.end())
        add(pm.face(pm.opposite(h)));
  }
  return true;
}

// Whether faces that fill one side of a simple loop form a disc, convex along the loop, in which no closed geodesic
// lies, and the loop is not pulled away from them.
inline bool is_convex_without_geodesic(const Progressive_mesh& pm, const std::vector<Index>& loop,
                                       const boost::container::small_vector_base<Index>& faces)
{
  boost::container::small_vector<std::pair<Index, double>, 24> angles; // of vertices, in these faces
  for(Index v : loop)
    angles.emplace_back(v, 0);
  for(Index f : faces)
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const auto it = std::find_if(angles.begin(), angles.end(),
                                   [v = pm.source(h)](const std::pair<Index, double>& a) { return a.first == v; });
      if(it == angles.end())
        angles.emplace_back(pm.source(h), corner_angle(pm, h));
      else
        it->second += corner_angle(pm, h);
    }
  const std::size_t inside = angles.size() - loop.size();
  if(faces.size() + 2 != 2 * inside + loop.size()) // Euler's formula for a disc
    return false;
  double curvature = 0; // of the vertices inside where it is positive
  for(std::size_t i = 0; i < angles.size(); ++i)
    if(i >= loop.size())
      curvature += (std::max)(2 * CGAL_PI - angles[i].second, 0.);
    else if(angles[i].second > CGAL_PI + disc_angle_tolerance ||
            total_angle(pm, loop[i]) - angles[i].second < CGAL_PI - disc_angle_tolerance)
      return false;
  return curvature < 2 * CGAL_PI - disc_angle_tolerance;
}

// Whether one side of a simple closed path of edges is seen to be a disc of at most `most` faces in which the curve
// shortens to a point. If the angles along the curve are at most pi in the disc, and at least pi beside it, a curve that
// gets shorter in the disc does not leave it. A closed geodesic in it bounds a smaller disc, has no angle below pi there,
// and so, by Gauss and Bonnet, encloses a curvature of at least 2 pi: it cannot be there if the positive curvature in the
// whole disc is less. Such curves are what flat and developable regions are full of. Quadratic in `most`, plus the
// degrees of the path's vertices.
inline bool shrinks_in_small_disc(const Progressive_mesh& pm, const std::vector<Index>& loop, std::size_t most)
{
  boost::container::small_vector<Index, 8> left, right;
  for(std::size_t i = 0; i < loop.size(); ++i)
  {
    left.push_back(pm.halfedge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]));
    right.push_back(pm.opposite(left.back()));
  }
  boost::container::small_vector<Index, 64> faces;
  // most such discs have few faces, and then the other side need not be searched far
  for(std::size_t m : {(std::min)(most, std::size_t(6)), most})
    for(const boost::container::small_vector_base<Index>* side : {&left, &right})
      if(find_faces_inside(pm, *side, m, faces) && is_convex_without_geodesic(pm, loop, faces))
        return true;
  return false;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SHRINKS_IN_SMALL_DISC_H
