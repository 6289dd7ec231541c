// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_AFFINE_MAP_H
#define CONSTRICTIONS_AFFINE_MAP_H

#include "input/polygon_soup.h"

#include <array>
#include <cstddef>

namespace constrictions {

/// An affine map of space, in doubles: how an object is placed in a scene.
struct Affine_map
{
  typedef std::array<double, 3> Vector;

  /// the images of the axes, and where the origin goes
  std::array<Vector, 4> columns = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{0, 0, 0}}}};

  bool is_identity() const { return columns == Affine_map().columns; }

  Point operator()(const Point& p) const
  {
    if(is_identity())
      return p;
    const Vector q = added({{p.x(), p.y(), p.z()}}, columns[3]);
    return Point(q[0], q[1], q[2]);
  }

  /// first `inner`, then this one
  Affine_map after(const Affine_map& inner) const
  {
    if(is_identity())
      return inner;
    Affine_map result;
    for(std::size_t i = 0; i < 3; ++i)
      result.columns[i] = added(inner.columns[i], {{0, 0, 0}});
    result.columns[3] = added(inner.columns[3], columns[3]);
    return result;
  }

  /// whether it turns the surface of a solid inside out
  bool is_mirroring() const
  {
    const Vector &a = columns[0], &b = columns[1], &c = columns[2];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) <
           0;
  }

private:
  // The image of a vector, with another one added to it.
  Vector added(const Vector& v, Vector result) const
  {
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 3; ++k)
        result[k] += columns[i][k] * v[i];
    return result;
  }
};

} // namespace constrictions

#endif // CONSTRICTIONS_AFFINE_MAP_H
