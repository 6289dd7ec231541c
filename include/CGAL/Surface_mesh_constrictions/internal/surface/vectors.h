// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_VECTORS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_VECTORS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>

#include <algorithm>
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

// A point or vector of space.
struct Vector3
{
  double x, y, z;

  friend Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector3 operator*(double s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

// From p to q.
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

// Of p from the segment between a and b.
inline double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 d = b - a;
  const double dd = dot(d, d), t = dd > 0 ? (std::min)((std::max)(dot(p - a, d) / dd, 0.0), 1.0) : 0;
  return norm(p - (a + t * d));
}

inline Vector3 position(const Progressive_mesh& pm, Index v)
{
  return vector(Progressive_mesh::Point(0, 0, 0), pm.point(v));
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_VECTORS_H
