// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_EDGE_GROUPS_H
#define CONSTRICTIONS_EDGE_GROUPS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace constrictions {

/// The sides of faces, sorted by the two vertices that they join. A side is known by the place of its first corner.
class Edge_groups
{
public:
  typedef CGAL::Surface_mesh_constrictions::Index Index;

  struct Side
  {
    Index to;      ///< the greater of its vertices
    Index side;    ///< the place of its first corner
    bool is_forth; ///< whether it runs to the greater vertex
  };

  /// \param begins the places of the first corners of the faces, and, at the end, the number of corners
  Edge_groups(std::size_t number_of_vertices, const std::vector<Index>& corners, const std::vector<std::size_t>& begins)
    : m_first(number_of_vertices + 1, 0), m_sides(corners.size())
  {
    const auto for_each_side = [&](auto f) {
      for(std::size_t face = 0; face + 1 < begins.size(); ++face)
        for(std::size_t c = begins[face]; c < begins[face + 1]; ++c)
          f(c, corners[c], corners[c + 1 == begins[face + 1] ? begins[face] : c + 1]);
    };
    for_each_side([&](std::size_t, Index u, Index v) { ++m_first[(std::min)(u, v) + std::size_t(1)]; });
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      m_first[v + 1] += m_first[v];
    std::vector<std::size_t> end(m_first.begin(), m_first.end() - 1);
    for_each_side([&](std::size_t c, Index u, Index v) {
      m_sides[end[(std::min)(u, v)]++] = {(std::max)(u, v), static_cast<Index>(c), u < v};
    });
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      std::sort(m_sides.begin() + static_cast<std::ptrdiff_t>(m_first[v]),
                m_sides.begin() + static_cast<std::ptrdiff_t>(m_first[v + 1]),
                [](const Side& a, const Side& b) { return a.to != b.to ? a.to < b.to : a.side < b.side; });
  }

  /// calls `f(u, begin, end)` with the sides between u and a greater vertex, for each edge, by its vertices
  template <class F>
  void for_each(F f) const
  {
    for(std::size_t v = 0; v + 1 < m_first.size(); ++v)
      for(std::size_t i = m_first[v]; i < m_first[v + 1];)
      {
        std::size_t j = i + 1;
        while(j < m_first[v + 1] && m_sides[j].to == m_sides[i].to)
          ++j;
        f(static_cast<Index>(v), m_sides.data() + i, m_sides.data() + j);
        i = j;
      }
  }

private:
  std::vector<std::size_t> m_first;
  std::vector<Side> m_sides;
};

} // namespace constrictions

#endif // CONSTRICTIONS_EDGE_GROUPS_H
