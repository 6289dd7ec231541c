// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
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

// Loops of edges through one vertex, the root, one for each kind of geodesic loop at the root. Each consists of an edge
// and the shortest paths from the root to its two ends. On smooth surfaces, geodesic loops at a point go through the
// local minima of the distance from it along its cut locus, which are the saddles of the distance.
//
// The surface is processed from far to near. The processed part begins as a region around each tip and each hole. At a
// saddle two regions become one; the loop there encloses either of them. The persistence of this loop is how much
// longer, relative to it, the loops of edges further out in the lesser region are. Errors of paths along edges make
// loops of small persistence. Once all regions are one, a loop that joins this region to itself is not contractible.
// Such loops are a greedy homotopy basis (Erickson and Whittlesey 2005), and all of them are taken.
//
// Only the vertices nearest to the root along edges are looked at: at most `most_vertices`, and only those that are
// allowed. All that is beyond them is one region, like a hole. So a loop around a limb that leads out of the part that
// is looked at joins a region to itself, if the loop is shorter than twice the distance of what is beyond.
class Loops_at_vertex
{
public:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // O(n log n) for the n vertices that are looked at.
  Loops_at_vertex(const Progressive_mesh& pm, Index root, std::size_t most_vertices)
    : Loops_at_vertex(pm, root, most_vertices, infinity, [](Index) { return true; })
  {}

  // Looks only at vertices with is_allowed(v) that are not further away than the greatest distance. No path is longer
  // than twice this distance.
  template <class IsAllowed>
  Loops_at_vertex(const Progressive_mesh& pm, Index root, std::size_t most_vertices, double greatest_distance,
                  const IsAllowed& is_allowed)
    : m_pm(pm), m_root(root), m_greatest_length(2 * greatest_distance), m_number(pm.number_of_vertex_ids()),
      m_region_of_face(pm.number_of_face_ids())
  {
    grow(most_vertices, greatest_distance, is_allowed);
    find_loops();
    find_persistences();
  }

  // At most `maximum_number` loops, as paths of vertex ids that start at the root, which is not repeated. First come
  // the loops that join a region to itself or separate two holes, the shortest first; then the others, in the order of
  // their persistence. A path may begin and end with the same edges.
  std::vector<std::vector<Index>> paths(std::size_t maximum_number)
  {
    std::stable_sort(m_loops.begin(), m_loops.end(), [](const Loop& a, const Loop& b) {
      return a.persistence != b.persistence ? a.persistence > b.persistence : a.length < b.length;
    });
    std::vector<std::vector<Index>> result;
    for(std::size_t i = 0; i < m_loops.size() && result.size() < maximum_number; ++i)
    {
      if(m_loops[i].length > m_greatest_length)
        continue;
      std::vector<Index> path;
      for(Index v = m_pm.source(m_loops[i].halfedge); v != null_index; v = reached(v).parent)
        path.push_back(v);
      std::reverse(path.begin(), path.end());
      for(Index v = m_pm.target(m_loops[i].halfedge); v != m_root; v = reached(v).parent)
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
    double longest; // length of the loops in it, where it begins
  };

  // The record of a vertex that has been reached.
  Reached& reached(Index v) { return m_reached[m_number[v] - 1]; }

  bool is_settled(Index v) const { return m_number[v] != 0 && m_reached[m_number[v] - 1].is_settled; }

  template <class IsAllowed>
  void grow(std::size_t most_vertices, double greatest_distance, const IsAllowed& is_allowed)
  {
    typedef std::pair<double, Index> Entry; // distance and vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](Index v, double distance, Index parent) {
      if(m_number[v] == 0)
      {
        m_reached.push_back({infinity, null_index, false});
        m_number[v] = static_cast<Index>(m_reached.size());
      }
      if(distance < reached(v).distance)
      {
        reached(v) = {distance, parent, false};
        queue.emplace(distance, v);
      }
    };
    reach(m_root, 0, null_index);
    while(!queue.empty() && m_settled.size() < most_vertices && queue.top().first <= greatest_distance)
    {
      const auto [distance, u] = queue.top();
      queue.pop();
      if(is_settled(u))
        continue;
      reached(u).is_settled = true;
      m_settled.push_back(u);
      const Index begin = m_pm.outgoing(u);
      Index h = begin;
      do
      {
        const Index v = m_pm.target(h);
        if(!m_pm.is_ghost_vertex(v) && is_allowed(v))
          reach(v, distance + norm(vector(m_pm.point(u), m_pm.point(v))), u);
        h = m_pm.ccw(h);
      } while(h != begin);
    }
  }

  // Finds the loops, and sorts them from the longest to the shortest.
  void find_loops()
  {
    std::sort(m_settled.begin(), m_settled.end());
    for(Index u : m_settled)
    {
      const Reached& here = reached(u);
      const Index begin = m_pm.outgoing(u);
      Index h = begin;
      do
      {
        const Index v = m_pm.target(h);
        if(m_pm.edge(h) == h && !m_pm.is_ghost_vertex(v) && is_settled(v) && here.parent != v && reached(v).parent != u)
          m_loops.push_back({h, here.distance + norm(vector(m_pm.point(u), m_pm.point(v))) + reached(v).distance, 0});
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    std::sort(m_loops.begin(), m_loops.end(), [](const Loop& a, const Loop& b) {
      return a.length != b.length ? a.length > b.length : a.halfedge < b.halfedge;
    });
  }

  void find_persistences()
  {
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
      Index& known = is_hole ? m_region_of_hole[third] : m_region_of_face[f]; // 0 at first, which is what is beyond
      if(known == 0)
      {
        known = static_cast<Index>(m_regions.size());
        m_regions.push_back({known, is_hole ? infinity : 0});
      }
      r = known;
    }
    while(m_regions[r].parent != r)
      r = m_regions[r].parent = m_regions[m_regions[r].parent].parent;
    return r;
  }

  const Progressive_mesh& m_pm;
  const Index m_root;
  const double m_greatest_length;
  Zeroed_array<Index> m_number;   // by vertex: its number among those reached, from 1 on
  std::vector<Reached> m_reached; // by number - 1
  std::vector<Index> m_settled;   // vertices
  std::vector<Loop> m_loops;
  std::vector<Region> m_regions;
  Zeroed_array<Index> m_region_of_face;
  std::unordered_map<Index, Index> m_region_of_hole; // by ghost vertex
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
