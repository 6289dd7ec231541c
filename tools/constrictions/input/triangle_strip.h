// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_TRIANGLE_STRIP_H
#define CONSTRICTIONS_TRIANGLE_STRIP_H

#include "input/polygon_soup.h"

#include <cstddef>

namespace constrictions {

/// Adds the triangles of strips to a soup. Of a strip each vertex from the third on makes a triangle with the two before
/// it, in turn of one orientation and of the other. Triangles with a vertex twice, with which strips are led on, are
/// skipped.
class Triangle_strip
{
public:
  explicit Triangle_strip(Polygon_soup& soup) : m_soup(soup) {}

  /// begins a new strip.
  void begin() { m_size = 0; }

  void add(Index v)
  {
    if(++m_size >= 3 && v != m_last && v != m_before && m_last != m_before)
    {
      const bool is_even = m_size % 2 == 1;
      for(Index corner : {is_even ? m_before : m_last, is_even ? m_last : m_before, v})
        m_soup.corners.push_back(corner);
      m_soup.end_face();
    }
    m_before = m_last;
    m_last = v;
  }

private:
  Polygon_soup& m_soup;
  std::size_t m_size = 0;
  Index m_before = 0, m_last = 0;
};

} // namespace constrictions

#endif // CONSTRICTIONS_TRIANGLE_STRIP_H
