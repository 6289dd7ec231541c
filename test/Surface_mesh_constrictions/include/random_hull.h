// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RANDOM_HULL_H
#define RANDOM_HULL_H

// Random convex polyhedra. Apart from the other meshes, since CGAL's convex hull takes long to compile and few tests
// need it.

#include "test_meshes.h"

#include <CGAL/convex_hull_3.h>

#include <random>
#include <vector>

namespace test_meshes {

inline Soup random_hull(unsigned seed, int points)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(-50, 50);
  std::vector<Kernel::Point_3> p;
  for(int i = 0; i < points; ++i)
    p.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  Mesh hull;
  CGAL::convex_hull_3(p.begin(), p.end(), hull);
  Soup soup;
  for(auto v : hull.vertices())
    soup.points.push_back({{hull.point(v).x(), hull.point(v).y(), hull.point(v).z()}});
  for(auto f : hull.faces())
  {
    const auto h = hull.halfedge(f);
    soup.faces.push_back({{hull.source(h), hull.target(h), hull.target(hull.next(h))}});
  }
  return soup;
}

} // namespace test_meshes

#endif // RANDOM_HULL_H
