// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Faces of a surface in compact blocks of about equal size, by halving them again and again near the median of their
// positions along the longest axis. The cut is at a multiple of a share of their extent: so if a few faces are left out or
// added, most blocks stay the same, and are simplified in the same way.
class Halved_faces
{
public:
  // Blocks of at most `most` of the given faces, which are in ascending order. O(n log n).
  template <class Point>
  Halved_faces(const Corner_table& table, const std::vector<Point>& points, const std::vector<Index>& faces,
               std::size_t most)
  {
    std::vector<Place> places;
    places.reserve(faces.size());
    for(Index f : faces)
    {
      places.push_back({{}, f});
      for(int i = 0; i < 3; ++i)
      {
        double sum = 0;
        for(Index h = 3 * f; h < 3 * f + 3; ++h)
          sum += points[table.halfedges[h].source][i];
        places.back().at[static_cast<std::size_t>(i)] = static_cast<float>(sum);
      }
    }
    m_order.reserve(places.size());
    halve(places.begin(), places.end(), most);
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

  static constexpr int cuts = 32; // into how many equal parts of the extent a cut may divide it

  void halve(Iterator begin, Iterator end, std::size_t most)
  {
    const std::size_t n = static_cast<std::size_t>(end - begin);
    if(n <= most)
    {
      m_first.push_back(static_cast<Index>(m_order.size()));
      for(Iterator it = begin; it != end; ++it)
        m_order.push_back(it->face);
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
    Iterator cut = begin;
    if(low[axis] < high[axis])
    {
      const double plane = plane_of_cut(begin, end, axis, low[axis], high[axis]);
      cut = std::stable_partition(begin, end, [&](const Place& p) { return p.at[axis] < plane; });
    }
    if(4 * static_cast<std::size_t>((std::min)(cut - begin, end - cut)) < n) // most of the faces lie near one plane
    {
      cut = std::next(begin, static_cast<std::ptrdiff_t>(n / 2));
      std::nth_element(begin, cut, end, [axis](const Place& a, const Place& b) {
        return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.face < b.face;
      });
      const auto is_before = [](const Place& a, const Place& b) { return a.face < b.face; };
      std::sort(begin, cut, is_before);
      std::sort(cut, end, is_before);
    }
    halve(begin, cut, most);
    halve(cut, end, most);
  }

  // The place of the cut that is nearest to the median. Counts the faces in slabs, two between two cuts.
  static double plane_of_cut(Iterator begin, Iterator end, std::size_t axis, double low, double high)
  {
    std::array<std::size_t, 2 * cuts> faces{};
    const double slabs_per_length = 2 * cuts / (high - low);
    for(Iterator it = begin; it != end; ++it)
      ++faces[(std::min)(static_cast<std::size_t>((it->at[axis] - low) * slabs_per_length), faces.size() - 1)];
    const std::size_t half = static_cast<std::size_t>(end - begin) / 2;
    std::size_t slab = 0, before = 0; // those before the slab
    while(before + faces[slab] <= half)
      before += faces[slab++];
    return low + static_cast<double>((slab + 1) / 2) / cuts * (high - low);
  }

  std::vector<Index> m_order, m_first;
};

// Blocks of faces of a surface. A vertex is inside a block if all faces around it are in the block, and else it is at the
// border of several.
class Face_blocks
{
public:
  // Block b has the faces order[first[b]] to order[first[b + 1] - 1]. Linear.
  Face_blocks(const Corner_table& table, std::vector<Index> order, std::vector<Index> first)
    : m_order(std::move(order)), m_first(std::move(first)), m_place(table.halfedges.size() / 3, null_index),
      m_block_of_vertex(table.outgoing.size(), null_index)
  {
    for(Index i = 0; i < m_order.size(); ++i)
      m_place[m_order[i]] = i;
    for(Index b = 0; b < size(); ++b)
      for(Index i = 0; i < number_of_faces(b); ++i)
        for(Index h = 3 * face(b, i); h < 3 * face(b, i) + 3; ++h)
          m_block_of_vertex[table.halfedges[h].source] = b;
    for(Index b = 0; b < size(); ++b)
      for(Index i = 0; i < number_of_faces(b); ++i)
        for(Index h = 3 * face(b, i); h < 3 * face(b, i) + 3; ++h)
          if(table.halfedges[h].opposite == null_index || place(b, table.halfedges[h].opposite / 3) == null_index)
            m_block_of_vertex[table.halfedges[h].source] =
                m_block_of_vertex[table.halfedges[Corner_table::next(h)].source] = null_index;
  }

  Index size() const { return static_cast<Index>(m_first.size() - 1); }

  Index number_of_faces(Index block) const { return m_first[block + 1] - m_first[block]; }

  // the i-th face of a block
  Index face(Index block, Index i) const { return m_order[m_first[block] + i]; }

  // which of the faces of a block a face is; null_index for one of another block, or of none
  Index place(Index block, Index f) const
  {
    const Index i = m_place[f];
    return m_first[block] <= i && i < m_first[block + 1] ? i - m_first[block] : null_index;
  }

  // the block that a vertex is inside of; null_index at the border
  Index block_of_vertex(Index v) const { return m_block_of_vertex[v]; }

private:
  std::vector<Index> m_order, m_first, m_place, m_block_of_vertex;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_FACE_BLOCKS_H
