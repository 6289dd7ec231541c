// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SECTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SECTIONS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/canonical_loop.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Level sets of functions on the vertices of the current surface, as closed paths of edges: the boundary loops of the
// faces none of whose vertices is above the level. No loop is given twice, whatever the functions.
class Sections
{
public:
  explicit Sections(const Progressive_mesh& pm)
    : m_pm(pm), m_greatest(pm.number_of_face_ids(), 0), m_stamps(pm.number_of_halfedge_ids(), 0),
      m_values(pm.number_of_vertex_ids(), 0)
  {
    for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      if(pm.is_face(f))
        m_faces.push_back(f);
  }

  // Writes the loops of the given number of levels, at equal distances from the least value to the greatest. Values
  // are given by number in the graph; those that are not finite are above all levels. O(faces), plus the loops.
  template <class OutputIterator>
  OutputIterator cut(const Edge_graph& graph, const std::vector<double>& values, std::size_t levels, OutputIterator out)
  {
    double least = infinity, greatest = -infinity;
    for(Index v = 0; v < values.size(); ++v)
    {
      const bool is_finite = std::isfinite(values[v]);
      m_values[graph.id(v)] = is_finite ? values[v] : infinity;
      if(is_finite)
      {
        least = (std::min)(least, values[v]);
        greatest = (std::max)(greatest, values[v]);
      }
    }
    if(!(least < greatest))
      return out;
    for(Index f : m_faces)
      m_greatest[f] = (std::max)({value(3 * f), value(3 * f + 1), value(3 * f + 2)});

    const double step = (greatest - least) / static_cast<double>(levels);
    const auto level = [&](std::size_t i) {
      return least + (greatest - least) * ((static_cast<double>(i) + 0.5) / static_cast<double>(levels));
    };
    m_boundary.resize(levels);
    for(std::vector<Index>& halfedges : m_boundary)
      halfedges.clear();
    for(Index f : m_faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const double low = m_greatest[f], high = m_greatest[m_pm.face(m_pm.opposite(h))];
        if(!(low < high))
          continue;
        std::size_t i = low <= level(0) ? 0 : static_cast<std::size_t>((low - least) / step - 0.5);
        while(i < levels && level(i) < low)
          ++i;
        for(; i < levels && level(i) < high; ++i)
          m_boundary[i].push_back(h);
      }
    for(std::size_t i = 0; i < levels; ++i)
    {
      ++m_stamp;
      for(Index h : m_boundary[i])
        if(m_stamps[h] != m_stamp)
        {
          walk(h, level(i));
          if(m_loop.size() > 2 && m_known.insert(m_loop).second)
            *out++ = Seed_curve{m_pm.level(), m_loop, Seed_origin::SECTION};
        }
    }
    return out;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  double value(Index h) const { return m_values[m_pm.source(h)]; }

  // Follows the boundary of the faces below the level, which lie on its left, once around, along the boundary of one
  // and the same fan of faces at each vertex.
  void walk(Index begin, double level)
  {
    m_loop.clear();
    Index h = begin;
    do {
      m_stamps[h] = m_stamp;
      m_loop.push_back(m_pm.source(h));
      h = m_pm.next(h);
      while(m_greatest[m_pm.face(m_pm.opposite(h))] <= level)
        h = m_pm.next(m_pm.opposite(h));
    } while(h != begin);
    make_canonical(m_loop);
  }

  const Progressive_mesh& m_pm;
  std::vector<Index> m_faces;
  std::vector<double> m_greatest; // value of a face's vertices
  std::vector<std::size_t> m_stamps; // of halfedges: the last walk along them
  std::vector<double> m_values; // of vertices, by id
  std::size_t m_stamp = 0;
  std::vector<std::vector<Index> > m_boundary; // by level: halfedges of faces that are not above it, next to faces that are
  std::vector<Index> m_loop;
  std::unordered_set<std::vector<Index>, boost::hash<std::vector<Index> > > m_known;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SECTIONS_H
