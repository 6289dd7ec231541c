// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PATHS_TO_FINER_LEVEL_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PATHS_TO_FINER_LEVEL_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Zeroed_array.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/remove_spurs.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Leads closed paths of edges of a coarser level back to a finer one, or to T^0, without the levels between. The
// vertices that have been merged into one of the coarser level are connected, and so are those of two neighbours;
// either fill a disc. So the shortest path through them is homotopic to the edge, whatever its way.
class Paths_to_finer_level
{
public:
  explicit Paths_to_finer_level(const Progressive_mesh& fine) : m_fine(fine), m_reached(fine.number_of_vertex_ids()) {}

  // A closed path on T^0, which is the finer surface, for one of a level, which must have been copied from it. Fewer
  // than three vertices if it is a point or an edge forth and back. O(m log m) for m vertices of T^0 that have been
  // merged into those of the path.
  std::vector<Index> operator()(const Level_copy& level, const std::vector<Index>& path)
  {
    std::vector<Index> result = with_spurs(
        path, [&level](Index v) { return level.original(v); }, [&level](Index v) { return level.vertex(v); });
    remove_spurs(result);
    return result;
  }

  // The same between two levels of one mesh.
  std::vector<Index> operator()(const Level_copy& coarse, const Level_copy& fine, const std::vector<Index>& path)
  {
    std::vector<Index> result = with_spurs(
        path, [&](Index v) { return fine.vertex(coarse.original(v)); },
        [&](Index v) { return coarse.vertex(fine.original(v)); });
    remove_spurs(result);
    return result;
  }

  // The closed path for one of a coarser level, with what runs to and fro. standing_for(v) is the vertex here that
  // stands for one of the coarser level, merged_into(v) the vertex there that one from here has been merged into, or
  // null_index. Empty if the vertices of an edge of the path are not connected here.
  template <class StandingFor, class MergedInto>
  std::vector<Index> with_spurs(const std::vector<Index>& path, const StandingFor& standing_for,
                                const MergedInto& merged_into)
  {
    std::vector<Index> result;
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      const Index u = path[i], v = path[(i + 1) % path.size()];
      if(!append(
             standing_for(u), standing_for(v),
             [&](Index x) {
               const Index merged = merged_into(x);
               return merged == u || merged == v;
             },
             result))
        return {};
    }
    return result;
  }

  // Appends the shortest path of edges past vertices that are allowed, without its end. False if there is none.
  template <class IsAllowed>
  bool append(Index begin, Index end, const IsAllowed& is_allowed, std::vector<Index>& path)
  {
    ++m_search;
    m_heap.clear();
    reach(end, null_index, 0);
    bool is_found = false;
    while(!m_heap.empty() && !is_found)
    {
      std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
      const Entry nearest = m_heap.back();
      m_heap.pop_back();
      const Index w = nearest.second;
      is_found = w == begin;
      if(is_found || nearest.first > m_reached[w].distance)
        continue;
      const Index first = m_fine.outgoing(w);
      Index h = first;
      do
      {
        const Index x = m_fine.target(h);
        if(!m_fine.is_ghost_vertex(x) && is_allowed(x))
        {
          const double distance = nearest.first + norm(vector(m_fine.point(w), m_fine.point(x)));
          if(m_reached[x].search != m_search || distance < m_reached[x].distance)
            reach(x, w, distance);
        }
        h = m_fine.ccw(h);
      } while(h != first);
    }
    for(Index w = begin; is_found && w != end; w = m_reached[w].from)
      path.push_back(w);
    return is_found;
  }

private:
  struct Reached
  {
    Index search; // in which it was reached last; the first one is number 1
    Index from;
    double distance;
  };

  typedef std::pair<double, Index> Entry; // distance and vertex

  void reach(Index v, Index from, double distance)
  {
    m_reached[v] = {m_search, from, distance};
    m_heap.emplace_back(distance, v);
    std::push_heap(m_heap.begin(), m_heap.end(), std::greater<Entry>());
  }

  const Progressive_mesh& m_fine;
  Zeroed_array<Reached> m_reached; // by vertex
  std::vector<Entry> m_heap;
  Index m_search = 0;
};

// Leads closed paths of edges of one level back to a finer one. Curves that lie near each other pass the same edges, so
// the way of each edge is searched once. Memory: in proportion to the ways of the edges that were passed.
class Paths_from_level
{
public:
  // `to_finer` leads to T^0, from which the level must have been copied, or to a finer level of the same mesh.
  Paths_from_level(Paths_to_finer_level& to_finer, const Level_copy& level, const Level_copy* finer = nullptr)
    : m_to_finer(to_finer), m_level(level), m_finer(finer)
  {}

  // As `Paths_to_finer_level`, with the same result.
  std::vector<Index> operator()(const std::vector<Index>& path)
  {
    std::vector<Index> result;
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      const std::vector<Index>& way = this->way(path[i], path[(i + 1) % path.size()]);
      if(way.empty())
        return {};
      result.insert(result.end(), way.begin(), way.end());
    }
    remove_spurs(result);
    return result;
  }

private:
  // From one end of an edge to the other, without that; empty if they are not connected.
  const std::vector<Index>& way(Index u, Index v)
  {
    const auto [at, is_new] = m_ways.try_emplace((static_cast<std::uint64_t>(u) << 32) | v);
    if(is_new)
      m_to_finer.append(
          standing_for(u), standing_for(v),
          [this, u, v](Index x) {
            const Index merged = m_level.vertex(m_finer == nullptr ? x : m_finer->original(x));
            return merged == u || merged == v;
          },
          at->second);
    return at->second;
  }

  // The vertex of the finer level that stands for one of the level.
  Index standing_for(Index v) const
  {
    const Index original = m_level.original(v);
    return m_finer == nullptr ? original : m_finer->vertex(original);
  }

  Paths_to_finer_level& m_to_finer;
  const Level_copy& m_level;
  const Level_copy* m_finer;                                    // null if that is T^0
  std::unordered_map<std::uint64_t, std::vector<Index>> m_ways; // by the numbers of the two ends
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PATHS_TO_FINER_LEVEL_H
