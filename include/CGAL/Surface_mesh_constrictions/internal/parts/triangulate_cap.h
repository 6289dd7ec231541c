// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TRIANGULATE_CAP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TRIANGULATE_CAP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef std::vector<Exact_predicates_inexact_constructions_kernel::Point_3> Cap_polygon;
typedef std::vector<std::array<std::size_t, 3>> Cap_triangles;

// The triangulation of a polygon in space of least area, without certain diagonals. None if there is none, or if the
// polygon has more than 400 corners. O(n^3).
template <class IsForbidden>
Cap_triangles least_triangulation(const Cap_polygon& polygon, const IsForbidden& is_forbidden)
{
  const std::size_t n = polygon.size();
  if(n > 400)
    return {};
  const double infinity = std::numeric_limits<double>::infinity();
  // of the polygon from corner i to corner j, by i and j: the least area, and the third corner of the triangle at i j
  std::vector<double> area(n * n, infinity);
  std::vector<std::size_t> third(n * n, 0);
  for(std::size_t i = 0; i + 1 < n; ++i)
    area[i * n + i + 1] = 0;
  for(std::size_t size = 2; size < n; ++size)
    for(std::size_t i = 0; i + size < n; ++i)
    {
      const std::size_t j = i + size;
      if(size + 1 < n && is_forbidden(i, j))
        continue;
      for(std::size_t k = i + 1; k < j; ++k)
      {
        const double sum = area[i * n + k] + area[k * n + j];
        if(!(sum < area[i * n + j]))
          continue;
        const auto normal = cross_product(polygon[k] - polygon[i], polygon[j] - polygon[i]);
        const double with_triangle = sum + std::sqrt(normal.squared_length()) / 2;
        if(with_triangle < area[i * n + j])
        {
          area[i * n + j] = with_triangle;
          third[i * n + j] = k;
        }
      }
    }
  if(!(area[n - 1] < infinity))
    return {};
  Cap_triangles result;
  std::vector<std::array<std::size_t, 2>> stack = {{{0, n - 1}}};
  while(!stack.empty())
  {
    const std::array<std::size_t, 2> d = stack.back();
    stack.pop_back();
    if(d[1] - d[0] < 2)
      continue;
    const std::size_t k = third[d[0] * n + d[1]];
    result.push_back({{d[0], k, d[1]}});
    stack.push_back({{d[0], k}});
    stack.push_back({{k, d[1]}});
  }
  return result;
}

// Triangulates a polygon in space without new vertices: as Polygon Mesh Processing does, or, if that gives a diagonal
// for which is_forbidden(i, j) holds, with the least area without such diagonals. The corners of each triangle are in
// ascending order. None if no triangulation is found. Cost: that of `triangulate_hole_polyline()`, at worst O(n^3).
template <class IsForbidden>
Cap_triangles triangulate_cap(const Cap_polygon& polygon, const IsForbidden& is_forbidden)
{
  const std::size_t n = polygon.size();
  std::vector<Triple<int, int, int>> found;
  if(n > 3)
    Polygon_mesh_processing::triangulate_hole_polyline(polygon, std::back_inserter(found));
  else
    found.emplace_back(0, 1, 2);
  Cap_triangles result;
  for(const Triple<int, int, int>& t : found)
  {
    std::array<std::size_t, 3> corners = {
        {static_cast<std::size_t>(t.first), static_cast<std::size_t>(t.second), static_cast<std::size_t>(t.third)}};
    std::sort(corners.begin(), corners.end());
    result.push_back(corners);
  }
  const auto is_bad = [&](std::size_t i, std::size_t j) { return j - i > 1 && j - i + 1 < n && is_forbidden(i, j); };
  const bool is_good = result.size() + 2 == n && std::none_of(result.begin(), result.end(), [&](const auto& t) {
                         return is_bad(t[0], t[1]) || is_bad(t[1], t[2]) || is_bad(t[0], t[2]);
                       });
  return is_good ? result : least_triangulation(polygon, is_forbidden);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TRIANGULATE_CAP_H
