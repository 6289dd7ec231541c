// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The faces of a surface in compact blocks of about equal size, by halving them again and again near the median of their
// positions along the longest axis. The cut is at a multiple of a share of their extent: so if a few faces are left out or
// added, most blocks stay the same, and are simplified in the same way.
class Halved_faces
{
public:
  // Blocks of at most the given number of faces. O(n log n).
  template <class Point>
  Halved_faces(const Corner_table& table, const std::vector<Point>& points, std::size_t faces)
  {
    std::vector<Place> places(table.halfedges.size() / 3);
    for(Index f = 0; f < places.size(); ++f)
    {
      places[f].face = f;
      for(int i = 0; i < 3; ++i)
      {
        double sum = 0;
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
          sum += points[table.halfedges[h].source][i];
        places[f].at[static_cast<std::size_t>(i)] = static_cast<float>(sum);
      }
    }
    m_order.reserve(places.size());
    halve(places.begin(), places.end(), faces);
    m_first.push_back(static_cast<Index>(m_order.size()));
  }

  // all faces, block after block, in ascending order in each
  const std::vector<Index>& order() const { return m_order; }

  // where each block begins in the order, and where the last one ends
  const std::vector<Index>& first() const { return m_first; }

private:
  struct Place
  {
    std::array<float, 3> at; // three times the centroid
    Index face;
  };
  typedef typename std::vector<Place>::iterator Iterator;

  static constexpr double cuts = 32; // into how many equal parts of the extent a cut may divide it

  void halve(Iterator begin, Iterator end, std::size_t faces)
  {
    const std::size_t n = static_cast<std::size_t>(end - begin);
    if(n <= faces)
    {
      m_first.push_back(static_cast<Index>(m_order.size()));
      for(Iterator it = begin; it != end; ++it)
        m_order.push_back(it->face);
      std::sort(std::next(m_order.begin(), static_cast<std::ptrdiff_t>(m_first.back())), m_order.end());
      return;
    }
    std::array<float, 3> low = begin->at, high = begin->at;
    for(Iterator it = begin; it != end; ++it)
      for(std::size_t i = 0; i < 3; ++i)
      {
        low[i] = (std::min)(low[i], it->at[i]);
        high[i] = (std::max)(high[i], it->at[i]);
      }
    std::size_t axis = 0;
    for(std::size_t i = 1; i < 3; ++i)
      if(high[i] - low[i] > high[axis] - low[axis])
        axis = i;
    const auto is_less = [axis](const Place& a, const Place& b) {
      return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.face < b.face;
    };
    Iterator middle = std::next(begin, static_cast<std::ptrdiff_t>(n / 2));
    std::nth_element(begin, middle, end, is_less);
    const double from = low[axis], extent = high[axis] - from;
    const double plane = from + std::round((middle->at[axis] - from) / extent * cuts) / cuts * extent;
    const Iterator cut = std::partition(begin, end, [&](const Place& p) { return p.at[axis] < plane; });
    if(4 * static_cast<std::size_t>((std::min)(cut - begin, end - cut)) >= n)
      middle = cut;
    else // most of the faces lie near one plane
      std::nth_element(begin, middle, end, is_less);
    halve(begin, middle, faces);
    halve(middle, end, faces);
  }

  std::vector<Index> m_order, m_first;
};

// Blocks of faces of a surface whose faces lie block after block. A vertex is inside a block if all faces around it are
// in the block, and else it is at the border of several.
class Face_blocks
{
public:
  // Block b has the faces first[b] to first[b + 1] - 1. Linear.
  Face_blocks(const Corner_table& table, std::vector<Index> first)
    : m_first(std::move(first)), m_block_of_vertex(table.outgoing.size(), null_index)
  {
    for(Index b = 0; b < size(); ++b)
      for(Index h = 3 * begin(b); h < 3 * end(b); ++h)
        m_block_of_vertex[table.halfedges[h].source] = b;
    for(Index b = 0; b < size(); ++b)
      for(Index h = 3 * begin(b); h < 3 * end(b); ++h)
        if(!has_face(b, table.halfedges[h].opposite / 3))
          m_block_of_vertex[table.halfedges[h].source] =
              m_block_of_vertex[table.halfedges[Corner_table::next(h)].source] = null_index;
  }

  std::size_t size() const { return m_first.size() - 1; }

  // the first face of a block
  Index begin(Index block) const { return m_first[block]; }

  // the face after the last one of a block
  Index end(Index block) const { return m_first[block + 1]; }

  bool has_face(Index block, Index f) const { return begin(block) <= f && f < end(block); }

  // the block that a vertex is inside of; null_index at the border
  Index block_of_vertex(Index v) const { return m_block_of_vertex[v]; }

private:
  std::vector<Index> m_first, m_block_of_vertex;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H
