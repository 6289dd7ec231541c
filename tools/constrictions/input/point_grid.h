// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_POINT_GRID_H
#define CONSTRICTIONS_POINT_GRID_H

#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/splitmix64.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace constrictions {

/// Numbered points in cells as wide as a distance, so that those within this distance of a place are found in the cells
/// around it.
class Point_grid
{
public:
  explicit Point_grid(double distance) : m_distance(distance) {}

  void add(const Point& p, Index number) { m_cells[key(p, {{0, 0, 0}})].push_back(number); }

  /// calls `f` with the number of each point in the cells around a place, in no particular order
  template <class F>
  void for_each_near(const Point& p, F f) const
  {
    std::array<std::uint64_t, 27> keys;
    std::size_t n = 0;
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
        {
          const std::uint64_t k = key(p, {{x, y, z}});
          bool is_new = true; // cells are so small, or different ones have the same key
          for(std::size_t i = 0; i < n; ++i)
            is_new = is_new && keys[i] != k;
          if(!is_new)
            continue;
          keys[n++] = k;
          const auto cell = m_cells.find(k);
          if(cell != m_cells.end())
            for(Index number : cell->second)
              f(number);
        }
  }

private:
  std::uint64_t key(const Point& p, const std::array<int, 3>& step) const
  {
    std::uint64_t result = 0;
    for(int i = 0; i < 3; ++i)
    {
      const double cell = std::floor(p[i] / m_distance) + step[static_cast<std::size_t>(i)] + 0.; // no -0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &cell, sizeof(bits));
      result = CGAL::Surface_mesh_constrictions::internal::splitmix64(result ^ bits);
    }
    return result;
  }

  double m_distance;
  std::unordered_map<std::uint64_t, std::vector<Index>> m_cells;
};

} // namespace constrictions

#endif // CONSTRICTIONS_POINT_GRID_H
