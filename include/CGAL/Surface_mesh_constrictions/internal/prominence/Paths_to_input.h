// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PATHS_TO_INPUT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PATHS_TO_INPUT_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/remove_spurs.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Leads closed paths of edges of a coarser level back to T^0 without the levels between. The vertices of T^0 that have
// been merged into one of the level are connected, and so are those of two neighbours; either fill a disc. So the
// shortest path through them is homotopic to the edge, whatever its way.
class Paths_to_input
{
public:
  // `lengths` of the edges of T^0, `pm`. Linear in its size.
  Paths_to_input(const Progressive_mesh& pm, const Edge_lengths& lengths)
    : m_pm(pm), m_lengths(lengths), m_reached(pm.number_of_vertex_ids())
  {}

  // A closed path on T^0 for one of a level, which must have been copied from it. Fewer than three vertices if it is a
  // point or an edge forth and back. O(m log m) for m vertices of T^0 that have been merged into those of the path.
  std::vector<Index> operator()(const Level_copy& level, const std::vector<Index>& path)
  {
    std::vector<Index> result;
    for(std::size_t i = 0; i < path.size(); ++i)
      append_edge(level, path[i], path[(i + 1) % path.size()], result);
    remove_spurs(result);
    return result;
  }

private:
  struct Reached
  {
    Index search = 0; // in which it was reached last
    Index from = null_index;
    double distance = 0;
  };

  typedef std::pair<double, Index> Entry; // distance and vertex

  // The shortest path from the vertex of T^0 that stands for `u` to the one that stands for `v`, without the latter.
  void append_edge(const Level_copy& level, Index u, Index v, std::vector<Index>& path)
  {
    ++m_search;
    const Index begin = level.original(u), end = level.original(v);
    reach(end, null_index, 0);
    while(!m_heap.empty())
    {
      std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
      const Entry nearest = m_heap.back();
      m_heap.pop_back();
      const Index w = nearest.second;
      if(w == begin)
        break;
      if(nearest.first > m_reached[w].distance)
        continue;
      const Index first = m_pm.outgoing(w);
      Index h = first;
      do
      {
        const Index x = m_pm.target(h);
        if(!m_pm.is_ghost_vertex(x) && (level.vertex(x) == u || level.vertex(x) == v))
        {
          const double distance = nearest.first + m_lengths[h];
          if(m_reached[x].search != m_search || distance < m_reached[x].distance)
            reach(x, w, distance);
        }
        h = m_pm.ccw(h);
      } while(h != first);
    }
    m_heap.clear();
    for(Index w = begin; w != end; w = m_reached[w].from)
      path.push_back(w);
  }

  void reach(Index v, Index from, double distance)
  {
    m_reached[v].search = m_search;
    m_reached[v].from = from;
    m_reached[v].distance = distance;
    m_heap.emplace_back(distance, v);
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  std::vector<Reached> m_reached; // by vertex of T^0
  std::vector<Entry> m_heap;
  Index m_search = 0;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PATHS_TO_INPUT_H
