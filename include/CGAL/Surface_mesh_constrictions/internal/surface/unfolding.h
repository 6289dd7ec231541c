// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_UNFOLDING_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_UNFOLDING_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Angle at source(h) in the face of h, in [0, pi]; infinite in a ghost face: a hole is an obstacle, and no curve can be
// led around a vertex through it.
inline double corner_angle(const Progressive_mesh& pm, Index h)
{
  if(pm.is_ghost_face(pm.face(h)))
    return (std::numeric_limits<double>::infinity)();
  const auto& p = pm.point(pm.source(h));
  const Vector3 a = vector(p, pm.point(pm.target(h))), b = vector(p, pm.point(pm.source(pm.prev(h))));
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// The sum of the angles at a vertex; infinite on the boundary. O(degree).
inline double total_angle(const Progressive_mesh& pm, Index v)
{
  double total = 0;
  const Index begin = pm.outgoing(v);
  Index h = begin;
  do
  {
    total += corner_angle(pm, h);
    h = pm.ccw(h);
  } while(h != begin);
  return total;
}

// The crossed halfedge h, unfolded: as one goes out of its face, its target is on the left, its source on the right.
struct Portal
{
  Vector2 left, right;
};

// The first portal of a strip that starts at the corner opposite to h. The corner comes to lie at the origin, and
// source(h) on the positive x axis.
inline Portal portal_from_apex(const Progressive_mesh& pm, Index h)
{
  const auto& apex = pm.point(pm.source(pm.prev(h)));
  const Vector3 a = vector(apex, pm.point(pm.source(h))), b = vector(apex, pm.point(pm.target(h)));
  const double la = norm(a);
  if(la == 0)
    return {{norm(b), 0}, {0, 0}};
  return {{dot(a, b) / la, norm(cross(a, b)) / la}, {la, 0}};
}

// The corner that the halfedge h is crossed to, unfolded.
inline Vector2 unfold_apex(const Progressive_mesh& pm, Index h, const Portal& portal)
{
  const Index o = pm.opposite(h);
  const auto& right = pm.point(pm.source(h));
  const Vector3 e = vector(right, pm.point(pm.target(h))), c = vector(right, pm.point(pm.source(pm.prev(o))));
  const double ee = dot(e, e);
  const Vector2 d = portal.left - portal.right;
  if(ee == 0) // on coarse levels only: inputs with such an edge are refused
    return portal.right + Vector2{norm(c), 0};
  const double s = dot(c, e) / ee, t = norm(cross(c, e)) / ee;
  return portal.right + s * d + t * Vector2{d.y, -d.x};
}

// The portal of `crossed`, one of the two other halfedges of the face that h is crossed to, whose corner opposite to h
// is unfolded to `apex`.
inline Portal next_portal(const Progressive_mesh& pm, Index h, const Portal& portal, Vector2 apex, Index crossed)
{
  if(crossed == pm.next(pm.opposite(h)))
    return {apex, portal.right};
  return {portal.left, apex};
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_UNFOLDING_H
