// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COORDINATE_UNIT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COORDINATE_UNIT_H

#include <array>
#include <cmath>
#include <cstdlib>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// What coordinates are divided by before anything is computed from them, and what results are multiplied by: a power of
// two. It is 1 unless coordinates are so large or so small that their products would overflow or vanish.
class Coordinate_unit
{
public:
  Coordinate_unit() = default;

  // `greatest` of the absolute values of all coordinates
  explicit Coordinate_unit(double greatest)
  {
    const int exponent = greatest > 0 ? std::ilogb(greatest) : 0;
    if(std::abs(exponent) > greatest_exponent)
      m_exponent = exponent;
  }

  bool is_one() const { return m_exponent == 0; }

  // a length or a coordinate of the mesh in this unit
  double divided(double x) const { return std::ldexp(x, -m_exponent); }

  template <class Point>
  Point divided(const Point& p) const
  {
    return Point(divided(p.x()), divided(p.y()), divided(p.z()));
  }

  // what has been measured in this unit, in that of the mesh: a length, an area if `dimension` is 2, a volume if it is 3
  double restored(double measure, int dimension = 1) const { return std::ldexp(measure, dimension * m_exponent); }

  template <class Vector>
  std::array<double, 3> restored_point(const Vector& p) const
  {
    return {{restored(p.x), restored(p.y), restored(p.z)}};
  }

private:
  static constexpr int greatest_exponent = 64;

  int m_exponent = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_COORDINATE_UNIT_H
