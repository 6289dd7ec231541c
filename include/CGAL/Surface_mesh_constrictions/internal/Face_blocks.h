// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FACE_BLOCKS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FACE_BLOCKS_H

#include <CGAL/Surface_mesh_constrictions/internal/Corner_table.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The faces of a surface in compact blocks of about equal size, by halving them again and again at the median of their
// positions along the longest axis. A vertex is inside a block if all faces around it are in the block, and else it is
// at the border of several.
class Face_blocks
{
public:
  // Blocks of at most the given number of faces. O(n log n).
  template <class Point>
  Face_blocks(const Corner_table& table, const std::vector<Point>& points, std::size_t faces)
    : m_block_of_face(table.halfedges.size() / 3),
      m_position(table.halfedges.size() / 3),
      m_block_of_vertex(points.size(), null_index)
  {
    std::vector<Place> places(m_block_of_face.size());
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
    halve(places.begin(), places.end(), faces);
    for(Index h = 0; h < table.halfedges.size(); ++h)
      m_block_of_vertex[table.halfedges[h].source] = m_block_of_face[h / 3];
    for(Index h = 0; h < table.halfedges.size(); ++h)
      if(m_block_of_face[h / 3] != m_block_of_face[table.halfedges[h].opposite / 3])
        m_block_of_vertex[table.halfedges[h].source] = m_block_of_vertex[table.halfedges[Corner_table::next(h)].source] = null_index;
  }

  std::size_t size() const { return m_faces.size(); }

  // in ascending order
  const std::vector<Index>& faces(std::size_t block) const { return m_faces[block]; }

  Index block_of_face(Index f) const { return m_block_of_face[f]; }

  // of a face in faces()
  Index position(Index f) const { return m_position[f]; }

  // the block that a vertex is inside of; null_index at the border
  Index block_of_vertex(Index v) const { return m_block_of_vertex[v]; }

private:
  struct Place
  {
    std::array<float, 3> at; // three times the centroid
    Index face;
  };
  typedef typename std::vector<Place>::iterator Iterator;

  void halve(Iterator begin, Iterator end, std::size_t faces)
  {
    const std::size_t n = static_cast<std::size_t>(end - begin);
    if(n <= faces)
    {
      std::vector<Index> block;
      for(Iterator it = begin; it != end; ++it)
        block.push_back(it->face);
      std::sort(block.begin(), block.end());
      for(Index i = 0; i < n; ++i)
      {
        m_block_of_face[block[i]] = static_cast<Index>(m_faces.size());
        m_position[block[i]] = i;
      }
      m_faces.push_back(std::move(block));
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
    const Iterator middle = std::next(begin, static_cast<std::ptrdiff_t>(n / 2));
    std::nth_element(begin, middle, end, [axis](const Place& a, const Place& b) {
      return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.face < b.face;
    });
    halve(begin, middle, faces);
    halve(middle, end, faces);
  }

  std::vector<Index> m_block_of_face, m_position, m_block_of_vertex;
  std::vector<std::vector<Index> > m_faces; // by block
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_FACE_BLOCKS_H
