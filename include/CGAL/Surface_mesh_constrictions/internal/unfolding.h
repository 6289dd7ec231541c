// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_UNFOLDING_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_UNFOLDING_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A point or vector of the plane that faces are unfolded into.
struct Vector2
{
  double x, y;

  friend Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector2 operator*(double s, Vector2 a) { return {s * a.x, s * a.y}; }
};

inline double dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vector2 a, Vector2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vector2 a) { return std::sqrt(dot(a, a)); }

// Angle from a to b, counterclockwise positive, in (-pi, pi].
inline double angle(Vector2 a, Vector2 b) { return std::atan2(cross(a, b), dot(a, b)); }

struct Vector3
{
  double x, y, z;

  friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector3 operator*(double s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline Vector3 vector(const Progressive_mesh::Point& p, const Progressive_mesh::Point& q)
{
  return {q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
}

inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vector3& a) { return std::sqrt(dot(a, a)); }

inline Vector3 position(const Progressive_mesh& pm, Index v)
{
  return vector(Progressive_mesh::Point(0, 0, 0), pm.point(v));
}

// Angle at source(h) in the face of h, in [0, pi].
inline double corner_angle(const Progressive_mesh& pm, Index h)
{
  const auto& p = pm.point(pm.source(h));
  const Vector3 a = vector(p, pm.point(pm.target(h))), b = vector(p, pm.point(pm.source(pm.prev(h))));
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// The crossed halfedge h, unfolded: as one goes out of its face, its target is on the left, its source on the right.
struct Portal
{
  Vector2 left, right;
};

// The first portal of a strip that starts at the corner opposite to h, unfolded to the origin; the corner's other end
// source(h) comes to lie on the positive x axis.
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

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_UNFOLDING_H
