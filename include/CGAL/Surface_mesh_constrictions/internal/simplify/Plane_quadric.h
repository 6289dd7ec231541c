// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef std::array<double, 4> Homogeneous; // x, y, z, w

// The weighted sum of squared distances to some planes, as a function of a point: a symmetric matrix, of which the ten
// different entries are kept (Garland and Heckbert, "Surface simplification using quadric error metrics", 1997).
//
// Sums are added up in the order in which Eigen adds up those of 4x4 matrices on x86-64, so that edges collapse in the
// same order as with CGAL's GarlandHeckbert_plane_policies.
class Plane_quadric
{
public:
  // of no plane
  Plane_quadric() : m{} {}

  // of the plane with this normal, of length one, and this fourth coefficient
  Plane_quadric(double a, double b, double c, double d)
    : m{{a * a, a * b, a * c, a * d, b * b, b * c, b * d, c * c, c * d, d * d}}
  {}

  Plane_quadric& operator+=(const Plane_quadric& other)
  {
    for(std::size_t i = 0; i < m.size(); ++i)
      m[i] += other.m[i];
    return *this;
  }

  friend Plane_quadric operator*(double weight, Plane_quadric q)
  {
    for(double& x : q.m)
      x *= weight;
    return q;
  }

  // The bilinear form.
  double operator()(const Homogeneous& p, const Homogeneous& q) const
  {
    const double x = (p[0] * m[0] + p[2] * m[2]) + (p[1] * m[1] + p[3] * m[3]);
    const double y = (p[0] * m[1] + p[2] * m[5]) + (p[1] * m[4] + p[3] * m[6]);
    const double z = (p[0] * m[2] + p[2] * m[7]) + (p[1] * m[5] + p[3] * m[8]);
    const double w = (p[0] * m[3] + p[2] * m[8]) + (p[1] * m[6] + p[3] * m[9]);
    return (x * q[0] + z * q[2]) + (y * q[1] + w * q[3]);
  }

  // The point of the least value; if there is more than one, that of the least value between two points, whose w is 1.
  Homogeneous best_point(const Homogeneous& p, const Homogeneous& q) const
  {
    const double xx = m[0], xy = m[1], xz = m[2], xw = m[3], yy = m[4], yz = m[5], yw = m[6], zz = m[7], zw = m[8];
    const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    if(determinant == 0)
      return best_point_between(p, q);
    const double yzw = yz * zw - yw * zz, yyw = yy * zw - yw * yz, yyz = yy * zz - yz * yz;
    const double xzw = xy * zw - yw * xz, xyz = xy * zz - yz * xz, xyy = xy * yz - yy * xz;
    const double scale = 1 / determinant;
    return {{scale * -(xy * yzw - xz * yyw + xw * yyz), scale * (xx * yzw - xz * xzw + xw * xyz),
             scale * -(xx * yyw - xy * xzw + xw * xyy), scale * (xx * yyz - xy * xyz + xz * xyy)}};
  }

private:
  Homogeneous best_point_between(const Homogeneous& p, const Homogeneous& q) const
  {
    const Homogeneous d = {{q[0] - p[0], q[1] - p[1], q[2] - p[2], q[3] - p[3]}};
    const double a = (*this)(d, d), b = 2 * (*this)(p, d);
    if(a == 0)
    {
      if(b != 0)
        return b < 0 ? q : p;
      Homogeneous middle;
      for(std::size_t i = 0; i < 4; ++i)
        middle[i] = 0.5 * (p[i] + q[i]);
      return middle;
    }
    const double t = -b / (2 * a);
    if(t < 0 || t > 1 || a < 0)
      return (*this)(p, p) > (*this)(q, q) ? q : p;
    Homogeneous result;
    for(std::size_t i = 0; i < 4; ++i)
      result[i] = p[i] + t * d[i];
    return result;
  }

  std::array<double, 10> m; // row by row
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_H
