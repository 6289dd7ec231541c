// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_POLYGON_SOUP_H
#define CONSTRICTIONS_POLYGON_SOUP_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh_constrictions::Index Index;

/// The vertices and faces of a file, in its order.
class Polygon_soup
{
public:
  std::vector<Point> points;
  std::vector<Index> corners; ///< of one face after the other
  std::string unit;           ///< of the coordinates, as 3MF names it; empty if the format has none

  /// makes a face of the corners that have been added since the last one.
  void end_face()
  {
    const std::size_t begin = m_begins.empty() ? 3 * m_faces : m_end;
    const std::size_t n = corners.size() - begin;
    if(m_begins.empty() && n != 3)
      for(std::size_t f = 0; f <= m_faces; ++f)
        m_begins.push_back(3 * f);
    else if(!m_begins.empty())
      m_begins.push_back(begin);
    m_end = corners.size();
    ++m_faces;
  }

  std::size_t number_of_faces() const { return m_faces; }
  bool is_triangular() const { return m_begins.empty(); }

  /// the place of the first corner of a face
  std::size_t begin(std::size_t face) const
  {
    return m_begins.empty() ? 3 * face : face == m_faces ? m_end : m_begins[face];
  }

  /// the number of corners of a face
  std::size_t degree(std::size_t face) const { return begin(face + 1) - begin(face); }

private:
  std::size_t m_faces = 0, m_end = 0;
  std::vector<std::size_t> m_begins; // empty as long as every face has three corners
};

/// the 0-based number `index` that a face names, as an `Index`. Throws if there is no such vertex.
inline Index checked_index(std::size_t face, long long index, std::size_t number_of_vertices)
{
  using namespace CGAL::Surface_mesh_constrictions;
  if(index < 0 || static_cast<unsigned long long>(index) >= number_of_vertices || index >= null_index)
    throw Invalid_input(Input_defect::INVALID_VERTEX_INDEX, face,
                        "invalid vertex index: face " + std::to_string(face) + " refers to vertex " +
                            std::to_string(index) + " of " + std::to_string(number_of_vertices));
  return static_cast<Index>(index);
}

} // namespace constrictions

#endif // CONSTRICTIONS_POLYGON_SOUP_H
