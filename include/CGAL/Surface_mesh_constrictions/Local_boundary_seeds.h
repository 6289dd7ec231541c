// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_BOUNDARY_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_BOUNDARY_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes some of the seeds of `Boundary_seeds`: the boundaries of the holes that are nearest to a
/// given vertex, along edges, on T^0 and on one coarse surface.
///
/// Without them a rim is hardly found: loops through vertices that lead to a rim are given up on the coarse surface,
/// because they are too long for the area that they cut off.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost O(n log n) for the n vertices that are no farther away than the holes, and linear in the number of vertices
///
/// \sa `detect_constrictions_near()`
class Local_boundary_seeds
{
public:
  /// \param vertex a vertex of T^0 that is not isolated, numbered as it comes in `vertices(tm)`
  /// \param vertices the number of vertices of the coarse surface
  /// \param max_holes the greatest number of holes; they are in the connected component of the vertex
  explicit Local_boundary_seeds(Index vertex, std::size_t vertices = 1000, std::size_t max_holes = 3)
    : m_vertex(vertex), m_vertices(vertices), m_max_holes(max_holes)
  {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    if(pm.number_of_holes() == 0 || (pm.level() != 0 && !is_level_with(pm, level, m_vertices)))
      return out;
    for(Index ghost : nearest_holes(pm))
      *out++ = internal::boundary_seed(pm, ghost);
    return out;
  }

private:
  // By their ghosts, the nearest first. Ties go to the vertex with the smaller number.
  std::vector<Index> nearest_holes(const Progressive_mesh& pm) const
  {
    std::vector<Index> holes;
    std::vector<double> distance(pm.number_of_vertex_ids(), (std::numeric_limits<double>::infinity)());
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const Index root = pm.representative(m_vertex);
    distance[root] = 0;
    queue.emplace(0, root);
    while(!queue.empty() && holes.size() < m_max_holes)
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > distance[v])
        continue;
      const Index begin = pm.outgoing(v);
      Index h = begin;
      do
      {
        const Index w = pm.target(h);
        if(pm.is_ghost_vertex(w))
        {
          if(std::find(holes.begin(), holes.end(), w) == holes.end() && holes.size() < m_max_holes)
            holes.push_back(w);
        }
        else
        {
          const double there = d + internal::norm(internal::vector(pm.point(v), pm.point(w)));
          if(there < distance[w])
          {
            distance[w] = there;
            queue.emplace(there, w);
          }
        }
        h = pm.ccw(h);
      } while(h != begin);
    }
    return holes;
  }

  Index m_vertex;
  std::size_t m_vertices, m_max_holes;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_BOUNDARY_SEEDS_H
