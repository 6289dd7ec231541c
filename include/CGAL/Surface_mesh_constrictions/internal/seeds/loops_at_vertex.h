// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Loops of edges through one vertex, the root, one for each kind of geodesic loop at the root: the shortest paths to
// the two ends of an edge, and the edge. On smooth surfaces, geodesic loops at a point go through the local minima of
// the distance from it along its cut locus, which are the saddles of the distance.
//
// Process the surface from far to near. The processed part begins as a region around each tip and each hole. At a
// saddle two regions become one; the loop there encloses either of them. Its persistence is how much longer the loops
// of edges further out in the lesser region are, relative to this loop; errors of paths along edges make loops of small
// persistence. Once all regions are one, a loop that joins it to itself is not contractible. These loops are a greedy
// homotopy basis (Erickson and Whittlesey 2005), and all of them are taken.
//
// Only the vertices that are nearest to the root, along edges, are looked at, so many of them at most. All that is
// beyond is one region, like a hole. So the loops around a limb that leads out of that part are of those that join a
// region to itself, if they are shorter than twice the distance of what is beyond.
class Loops_at_vertex
{
public:
  // O(n log n) for the n vertices that are looked at.
  Loops_at_vertex(const Progressive_mesh& pm, Index root, std::size_t most_vertices) : m_pm(pm), m_root(root)
  {
    grow(most_vertices);
    find_loops();
    find_persistences();
  }

  // At most so many loops, paths of vertex ids from the root on, which is not repeated: first those that join a region
  // to itself or separate two holes, the shortest first, then the others by persistence. A path may begin and end with
  // the same edges.
  std::vector<std::vector<Index>> paths(std::size_t maximum_number)
  {
    std::stable_sort(m_loops.begin(), m_loops.end(), [](const Loop& a, const Loop& b) {
      return a.persistence != b.persistence ? a.persistence > b.persistence : a.length < b.length;
    });
    std::vector<std::vector<Index>> result;
    for(std::size_t i = 0; i < m_loops.size() && i < maximum_number; ++i)
    {
      std::vector<Index> path;
      for(Index v = m_pm.source(m_loops[i].halfedge); v != null_index; v = m_reached.at(v).parent)
        path.push_back(v);
      std::reverse(path.begin(), path.end());
      for(Index v = m_pm.target(m_loops[i].halfedge); v != m_root; v = m_reached.at(v).parent)
        path.push_back(v);
      result.push_back(std::move(path));
    }
    return result;
  }

private:
  struct Loop
  {
    Index halfedge;
    double length, persistence;
  };

  struct Reached
  {
    double distance;
    Index parent;
    bool is_settled;
  };

  // A region of faces, or what is beyond, or a hole.
  struct Region
  {
    Index parent;
    double longest; // of the loops in it, where it begins
  };

  void grow(std::size_t most_vertices)
  {
    typedef std::pair<double, Index> Entry; // distance and vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_reached[m_root] = {0, null_index, false};
    queue.emplace(0, m_root);
    while(!queue.empty() && m_settled.size() < most_vertices)
    {
      const auto [distance, u] = queue.top();
      queue.pop();
      Reached& here = m_reached.at(u);
      if(here.is_settled)
        continue;
      here.is_settled = true;
      m_settled.push_back(u);
      const Index begin = m_pm.outgoing(u);
      Index h = begin;
      do
      {
        const Index v = m_pm.target(h);
        if(!m_pm.is_ghost_vertex(v))
        {
          const double there = distance + norm(vector(m_pm.point(u), m_pm.point(v)));
          const auto known = m_reached.find(v);
          if(known == m_reached.end() || there < known->second.distance)
          {
            m_reached[v] = {there, u, false};
            queue.emplace(there, v);
          }
        }
        h = m_pm.ccw(h);
      } while(h != begin);
    }
  }

  bool is_settled(Index v) const
  {
    const auto known = m_reached.find(v);
    return known != m_reached.end() && known->second.is_settled;
  }

  // From the longest to the shortest.
  void find_loops()
  {
    std::sort(m_settled.begin(), m_settled.end());
    for(Index u : m_settled)
    {
      const Index begin = m_pm.outgoing(u);
      Index h = begin;
      do
      {
        const Index v = m_pm.target(h);
        if(m_pm.edge(h) == h && !m_pm.is_ghost_vertex(v) && is_settled(v) && m_reached.at(u).parent != v &&
           m_reached.at(v).parent != u)
          m_loops.push_back(
              {h, m_reached.at(u).distance + norm(vector(m_pm.point(u), m_pm.point(v))) + m_reached.at(v).distance, 0});
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    std::sort(m_loops.begin(), m_loops.end(), [](const Loop& a, const Loop& b) {
      return a.length != b.length ? a.length > b.length : a.halfedge < b.halfedge;
    });
  }

  void find_persistences()
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    m_regions.push_back({0, infinity}); // what is beyond
    for(Loop& l : m_loops)
    {
      Index a = region_of(l.halfedge), b = region_of(m_pm.opposite(l.halfedge));
      if(a == b)
      {
        l.persistence = infinity;
        continue;
      }
      if(m_regions[a].longest < m_regions[b].longest)
        std::swap(a, b);
      m_regions[a].longest = (std::max)(m_regions[a].longest, l.length);
      l.persistence = (std::max)(m_regions[b].longest, l.length) / l.length - 1;
      m_regions[b].parent = a;
    }
  }

  // The region on the left of a halfedge whose ends are settled.
  Index region_of(Index h)
  {
    const Index f = m_pm.face(h), third = m_pm.source(m_pm.prev(h));
    const bool is_hole = m_pm.is_ghost_face(f);
    Index r = 0;
    if(is_hole || is_settled(third))
    {
      auto& places = is_hole ? m_region_of_hole : m_region_of_face;
      const auto place = places.emplace(is_hole ? third : f, static_cast<Index>(m_regions.size()));
      r = place.first->second;
      if(place.second)
        m_regions.push_back({r, is_hole ? (std::numeric_limits<double>::infinity)() : 0});
    }
    while(m_regions[r].parent != r)
      r = m_regions[r].parent = m_regions[m_regions[r].parent].parent;
    return r;
  }

  const Progressive_mesh& m_pm;
  const Index m_root;
  std::unordered_map<Index, Reached> m_reached; // by vertex
  std::vector<Index> m_settled;                 // vertices
  std::vector<Loop> m_loops;
  std::vector<Region> m_regions;
  std::unordered_map<Index, Index> m_region_of_face, m_region_of_hole; // the latter by ghost vertex
};

// The loops through a vertex of T^0 on the whole surface, see `Loops_at_vertex`.
inline std::vector<std::vector<Index>> loops_at_vertex(const Progressive_mesh& pm, Index root,
                                                       std::size_t maximum_number)
{
  return Loops_at_vertex(pm, root, (std::numeric_limits<std::size_t>::max)()).paths(maximum_number);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H
