// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BEST_DIAGONALS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BEST_DIAGONALS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The triangulation of a convex polygon whose worst triangle is the best, as the diagonals from corner to corner, each
// after those that it cuts off. A triangle is the worse the smaller its area is compared to the squares of its sides.
// O(n^3) for n corners; a piece of a triangle has six at most.
inline std::vector<std::array<std::size_t, 2>>
best_diagonals(const std::vector<Exact_predicates_inexact_constructions_kernel::Point_3>& polygon)
{
  const std::size_t n = polygon.size();
  const auto quality = [&polygon](std::size_t i, std::size_t j, std::size_t k) {
    const auto u = polygon[j] - polygon[i], v = polygon[k] - polygon[j], w = polygon[i] - polygon[k];
    const double squares = u.squared_length() + v.squared_length() + w.squared_length();
    return squares > 0 ? std::sqrt(cross_product(u, v).squared_length()) / squares : 0;
  };
  // of the polygon from corner i to corner j, by i and j: the worst triangle, and the third corner of the one at i j
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> worst(n * n, infinity);
  std::vector<std::size_t> third(n * n, 0);
  for(std::size_t size = 2; size < n; ++size)
    for(std::size_t i = 0; i + size < n; ++i)
    {
      const std::size_t j = i + size;
      worst[i * n + j] = -1;
      for(std::size_t k = i + 1; k < j; ++k)
      {
        const double q = (std::min)({quality(i, k, j), worst[i * n + k], worst[k * n + j]});
        if(q > worst[i * n + j])
        {
          worst[i * n + j] = q;
          third[i * n + j] = k;
        }
      }
    }

  std::vector<std::array<std::size_t, 2>> result, stack = {{{0, n - 1}}};
  while(!stack.empty())
  {
    const std::array<std::size_t, 2> d = stack.back();
    stack.pop_back();
    if(d[1] - d[0] < 2)
      continue;
    if(d[1] - d[0] < n - 1)
      result.push_back(d);
    const std::size_t k = third[d[0] * n + d[1]];
    stack.push_back({{d[0], k}});
    stack.push_back({{k, d[1]}});
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_BEST_DIAGONALS_H
