// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TWIN_CAPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TWIN_CAPS_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/best_diagonals.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/triangulate_cap.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The diagonals of a polygon, as the places of two corners, the lower first.
typedef std::set<std::array<std::size_t, 2>> Diagonals;

// A polygon near a curve, on one side of it.
struct Polygon_beside
{
  Cap_polygon corners;

  // of each corner the corner of the curve that it belongs to, in cyclic order; those of which this is no such number
  // belong to none
  std::vector<std::size_t> origins;
  bool ascends; // whether they ascend
};

// The triangulations of two polygons on the two sides of a curve by the same pattern, that of a triangulation of the
// curve: if they were triangulated separately, two that are close to each other would intersect. Where several corners
// belong to a corner of the curve, the middle one has its place in the pattern.
class Twin_caps
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  // is_edge(side, a, b) tells whether two corners of a polygon are joined by an edge already, which no diagonal may be.
  template <class IsEdge>
  Twin_caps(const Cap_polygon& curve, const std::array<Polygon_beside, 2>& beside, const IsEdge& is_edge)
  {
    std::array<std::vector<std::size_t>, 2> corner;
    for(std::size_t side = 0; side < 2; ++side)
      corner[side] = corners_in_pattern(curve.size(), beside[side]);
    const Cap_triangles pattern = triangulate_cap(curve, [&](std::size_t a, std::size_t b) {
      return is_edge(0, corner[0][a], corner[0][b]) || is_edge(1, corner[1][a], corner[1][b]);
    });
    m_are_found = !pattern.empty();
    for(std::size_t side = 0; side < 2 && m_are_found; ++side)
    {
      const std::size_t n = beside[side].corners.size();
      for(const std::array<std::size_t, 3>& t : pattern)
        add_triangle(side, beside[side], corner[side], t);
      m_are_found = m_are_found && m_diagonals[side].size() + 3 == n &&
                    std::none_of(m_diagonals[side].begin(), m_diagonals[side].end(),
                                 [&](const auto& d) { return is_edge(side, d[0], d[1]); });
    }
  }

  // Whether there are such triangulations.
  bool are_found() const { return m_are_found; }

  const Diagonals& diagonals(std::size_t side) const { return m_diagonals[side]; }

private:
  // For each corner of the curve the place of a corner of the polygon, in the same order or the reverse one.
  static std::vector<std::size_t> corners_in_pattern(std::size_t n, const Polygon_beside& polygon)
  {
    std::vector<std::vector<std::size_t>> places(n);
    for(std::size_t i = 0; i < polygon.origins.size(); ++i)
      if(polygon.origins[i] < n)
        places[polygon.origins[i]].push_back(i);
    std::vector<std::size_t> result(n, none);
    std::size_t last = none;
    for(std::size_t i = 0; i < 2 * n; ++i) // a corner to which none belongs shares that of the one before it
    {
      if(!places[i % n].empty())
        last = places[i % n][places[i % n].size() / 2];
      result[i % n] = last;
    }
    return result;
  }

  static void insert(std::size_t a, std::size_t b, std::size_t n, Diagonals& diagonals)
  {
    const std::size_t low = (std::min)(a, b), high = (std::max)(a, b);
    if(high - low > 1 && high - low + 1 < n)
      diagonals.insert({{low, high}});
  }

  // Adds a triangle of the pattern, with what lies between it and the polygon. There the best triangles are taken: thin
  // ones would lie close to the surface, and some of them in it.
  void add_triangle(std::size_t side, const Polygon_beside& polygon, const std::vector<std::size_t>& corner,
                    const std::array<std::size_t, 3>& triangle)
  {
    const std::size_t n = polygon.corners.size(), size = corner.size();
    std::vector<std::size_t> piece;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t from = triangle[i], to = triangle[(i + 1) % 3];
      if((from + 1) % size == to)
        for(std::size_t k = corner[from]; k != corner[to]; k = (k + (polygon.ascends ? 1 : n - 1)) % n)
          piece.push_back(k);
      else
      {
        if(corner[from] != corner[to])
          piece.push_back(corner[from]);
        insert(corner[from], corner[to], n, m_diagonals[side]);
      }
    }
    if(piece.size() < 4)
      return;
    Cap_polygon points;
    for(std::size_t k : piece)
      points.push_back(polygon.corners[k]);
    for(const std::array<std::size_t, 2>& d : best_diagonals(points))
      insert(piece[d[0]], piece[d[1]], n, m_diagonals[side]);
  }

  bool m_are_found = false;
  std::array<Diagonals, 2> m_diagonals;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_TWIN_CAPS_H
