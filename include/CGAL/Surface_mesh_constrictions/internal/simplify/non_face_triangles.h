// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_NON_FACE_TRIANGLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_NON_FACE_TRIANGLES_H

#include <CGAL/boost/graph/iterator.h>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Calls report(k) for each vertex k that is joined by edges to both ends of the edge from v0 to v1 and spans no face
// with it: v0 v1 k is a non-face triangle. `profile` is an Edge_profile of the simplification. Stops when report
// returns false. O(degree^2).
template <class Profile, class Report>
void for_each_apex_of_non_face_triangle(const Profile& profile, Report report)
{
  const auto& tm = profile.surface_mesh();
  for(auto k : CGAL::vertices_around_target(halfedge(profile.v0(), tm), tm))
  {
    if(k == profile.v1() || (profile.left_face_exists() && k == profile.vL()) ||
       (profile.right_face_exists() && k == profile.vR()))
      continue;
    if(halfedge(k, profile.v1(), tm).second && !report(k))
      return;
  }
}

// Whether the profile's edge lies on a non-face triangle.
template <class Profile>
bool is_on_non_face_triangle(const Profile& profile)
{
  bool found = false;
  for_each_apex_of_non_face_triangle(profile, [&found](const auto&) {
    found = true;
    return false;
  });
  return found;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_NON_FACE_TRIANGLES_H
