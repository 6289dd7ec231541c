// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/join_faces.h"

#include "input/pair_sides.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::null_index;
using CGAL::Surface_mesh_constrictions::internal::Corner_table;

// Things at vertices, one vertex after the other.
class At_vertices
{
public:
  // for_each(f) calls f(vertex, thing), in the order that the things of a vertex get
  template <class ForEach>
  At_vertices(std::size_t vertices, ForEach for_each) : m_first(vertices + 1, 0)
  {
    for_each([this](Index v, Index) { ++m_first[v + std::size_t(1)]; });
    for(std::size_t v = 0; v < vertices; ++v)
      m_first[v + 1] += m_first[v];
    m_things.resize(m_first.back());
    std::vector<std::size_t> end(m_first.begin(), m_first.end() - 1);
    for_each([&](Index v, Index thing) { m_things[end[v]++] = thing; });
  }

  const Index* begin(Index v) const { return m_things.data() + m_first[v]; }
  const Index* end(Index v) const { return m_things.data() + m_first[v + std::size_t(1)]; }

private:
  std::vector<std::size_t> m_first;
  std::vector<Index> m_things;
};

class Joiner
{
public:
  Joiner(const std::vector<Point>& points, const std::vector<Index>& corners, const std::vector<Crowded_edge>& edges,
         bool is_inside_out, std::vector<Index>& opposite)
    : m_corners(corners), m_edges(edges), m_opposite(opposite),
      m_corners_at(points.size(),
                   [&corners](auto f) {
                     for(std::size_t c = 0; c < corners.size(); ++c)
                       f(corners[c], static_cast<Index>(c));
                   }),
      m_edges_at(points.size(),
                 [&edges](auto f) {
                   for(std::size_t e = 0; e < edges.size(); ++e)
                   {
                     f(edges[e].u, static_cast<Index>(e));
                     f(edges[e].v, static_cast<Index>(e));
                   }
                 }),
      m_is_crowded(corners.size(), false), m_way(edges.size(), 0), m_excess(edges.size(), 0)
  {
    for(const Crowded_edge& edge : edges)
    {
      std::vector<Side_at_edge> sides;
      for(const Edge_groups::Side& s : edge.sides)
      {
        sides.push_back({s.side, s.is_forth, points[corners[prev(s.side)]]});
        m_is_crowded[s.side] = true;
      }
      m_ways.push_back(ways_to_pair(points[edge.u], points[edge.v], sides, is_inside_out));
    }
  }

  void join()
  {
    m_fan_of.assign(m_corners.size(), null_index);
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      set_pairs(e);
    for(Index c = 0; c < m_corners.size(); ++c)
      if(m_fan_of[c] == null_index)
        label_fans(m_corners[c]);
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      update_excess(e);
    take_next_ways();
    take_better_ways();
    take_earlier_ways();
    while(!m_failing.empty())
      cut_beside(*m_failing.begin());
  }

private:
  static Index next(Index h) { return Corner_table::next(h); }
  static Index prev(Index h) { return Corner_table::prev(h); }

  // One of the edges that a crowded edge becomes: the fans at its ends, and a side of it.
  struct Copy
  {
    Index fan_at_u, fan_at_v, side;

    bool has_ends_of(const Copy& c) const { return fan_at_u == c.fan_at_u && fan_at_v == c.fan_at_v; }
  };

  void set_pairs(std::size_t e)
  {
    for(const Edge_groups::Side& s : m_edges[e].sides)
      m_opposite[s.side] = null_index;
    for(const Side_pair& p : m_ways[e][m_way[e]])
    {
      m_opposite[p[0]] = p[1];
      m_opposite[p[1]] = p[0];
    }
  }

  void set_way(std::size_t e, std::size_t way)
  {
    m_way[e] = way;
    set_pairs(e);
    for(Index v : {m_edges[e].u, m_edges[e].v})
      update(v);
  }

  // What the fans at a vertex are when something has been changed there.
  void update(Index v)
  {
    label_fans(v);
    for(const Index* e = m_edges_at.begin(v); e != m_edges_at.end(v); ++e)
      update_excess(*e);
  }

  void label_fans(Index v)
  {
    for(const Index* c = m_corners_at.begin(v); c != m_corners_at.end(v); ++c)
      m_fan_of[*c] = null_index;
    for(const Index* c = m_corners_at.begin(v); c != m_corners_at.end(v); ++c)
    {
      if(m_fan_of[*c] != null_index)
        continue;
      m_fan_of[*c] = *c;
      for(Index o = m_opposite[*c]; o != null_index && m_fan_of[next(o)] == null_index; o = m_opposite[next(o)])
        m_fan_of[next(o)] = *c;
      for(Index o = m_opposite[prev(*c)]; o != null_index && m_fan_of[o] == null_index; o = m_opposite[prev(o)])
        m_fan_of[o] = *c;
    }
  }

  // Corners around a vertex, each over its side from the one before.
  struct Fan
  {
    std::vector<Index> corners;
    bool is_closed;
  };

  Fan fan(Index corner) const
  {
    Index first = corner;
    Fan result = {{}, false};
    for(Index o = m_opposite[prev(first)]; o != null_index && !result.is_closed; o = m_opposite[prev(first)])
    {
      first = o;
      result.is_closed = first == corner;
    }
    for(Index c = first; result.corners.empty() || c != first; c = next(m_opposite[c]))
    {
      result.corners.push_back(c);
      if(m_opposite[c] == null_index)
        break;
    }
    return result;
  }

  // Sorted by the fans.
  std::vector<Copy> copies(std::size_t e) const
  {
    std::vector<Copy> result;
    for(const Edge_groups::Side& s : m_edges[e].sides)
    {
      if(m_opposite[s.side] != null_index && m_opposite[s.side] < s.side)
        continue;
      const Index from = m_fan_of[s.side], to = m_fan_of[next(s.side)];
      result.push_back({s.is_forth ? from : to, s.is_forth ? to : from, s.side});
    }
    std::sort(result.begin(), result.end(), [](const Copy& a, const Copy& b) {
      return std::tie(a.fan_at_u, a.fan_at_v, a.side) < std::tie(b.fan_at_u, b.fan_at_v, b.side);
    });
    return result;
  }

  // By how many its copies are more than the pairs of ends that they have.
  void update_excess(std::size_t e)
  {
    const std::vector<Copy> all = copies(e);
    std::size_t excess = 0;
    for(std::size_t i = 1; i < all.size(); ++i)
      excess += all[i].has_ends_of(all[i - 1]);
    m_sum_of_excess += excess - m_excess[e]; // modulo 2^64
    m_excess[e] = excess;
    if(excess > 0)
      m_failing.insert(e);
    else
      m_failing.erase(e);
  }

  // Each edge that fails takes its next way: of neighbours one at a time, as long as that does not take too long.
  void take_next_ways()
  {
    const int patience = 200;
    bool has_changed = true;
    for(int round = 0; has_changed; ++round)
    {
      has_changed = false;
      const std::vector<std::size_t> failures(m_failing.begin(), m_failing.end());
      std::unordered_set<Index> touched;
      for(std::size_t e : failures)
      {
        if(m_way[e] + 1 == m_ways[e].size())
          continue;
        const bool is_first = touched.insert(m_edges[e].u).second && touched.insert(m_edges[e].v).second;
        if(!is_first && round < patience)
          continue;
        set_way(e, m_way[e] + 1);
        has_changed = true;
      }
    }
  }

  // Where an edge fails in all of its ways those of its neighbours are looked through: each change makes fewer fail.
  void take_better_ways()
  {
    const std::size_t most_neighbours = 64;
    for(bool has_changed = true; has_changed;)
    {
      has_changed = false;
      const std::vector<std::size_t> failures(m_failing.begin(), m_failing.end());
      for(std::size_t e : failures)
      {
        if(m_excess[e] == 0)
          continue;
        std::vector<std::size_t> neighbours = {e};
        for(Index v : {m_edges[e].u, m_edges[e].v})
          neighbours.insert(neighbours.end(), m_edges_at.begin(v), m_edges_at.end(v));
        neighbours.resize((std::min)(neighbours.size(), most_neighbours));
        has_changed = take_best_of(neighbours) || has_changed;
      }
    }
  }

  // Changes the way of one edge, if that makes the sum of what fails less.
  bool take_best_of(const std::vector<std::size_t>& edges)
  {
    std::size_t least = m_sum_of_excess, best_edge = 0, best_way = 0;
    bool is_found = false;
    for(std::size_t e : edges)
    {
      const std::size_t old = m_way[e];
      for(std::size_t way = 0; way < m_ways[e].size(); ++way)
      {
        set_way(e, way);
        if(m_sum_of_excess >= least)
          continue;
        least = m_sum_of_excess;
        best_edge = e;
        best_way = way;
        is_found = true;
      }
      set_way(e, old);
    }
    if(is_found)
      set_way(best_edge, best_way);
    return is_found;
  }

  // The neighbours of an edge may have changed after it.
  void take_earlier_ways()
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
    {
      const std::size_t old = m_way[e], sum = m_sum_of_excess;
      for(std::size_t way = 0; way < old; ++way)
      {
        set_way(e, way);
        if(m_sum_of_excess <= sum)
          break;
        set_way(e, old);
      }
    }
  }

  // Copies of an edge with the same ends come to be in different fans of one end if the fan is cut open between each of
  // them and the next. As fans are only divided, no edge fails that did not before, but for those that are cut.
  void cut_beside(std::size_t e)
  {
    const std::vector<Copy> all = copies(e);
    const auto c =
        std::adjacent_find(all.begin(), all.end(), [](const Copy& a, const Copy& b) { return a.has_ends_of(b); });
    const std::vector<Index> at_u = sides_between(c->fan_at_u, m_edges[e].v, c->fan_at_v),
                             at_v = sides_between(c->fan_at_v, m_edges[e].u, c->fan_at_u);
    for(Index h : at_v.size() < at_u.size() ? at_v : at_u)
      cut(h);
  }

  // Where to cut the fan of a corner so that no two of its edges that lead to a fan of another vertex stay together:
  // the first edge between each two of them, if possible one with two faces.
  std::vector<Index> sides_between(Index corner, Index to, Index to_fan) const
  {
    struct Spoke
    {
      Index side, far_corner;
    };
    const Fan f = fan(corner);
    std::vector<Spoke> spokes;
    if(!f.is_closed)
      spokes.push_back({prev(f.corners.front()), prev(f.corners.front())});
    for(Index c : f.corners)
      spokes.push_back({c, next(c)});
    std::vector<std::size_t> there;
    for(std::size_t i = 0; i < spokes.size(); ++i)
      if(m_corners[spokes[i].far_corner] == to && m_fan_of[spokes[i].far_corner] == to_fan)
        there.push_back(i);
    if(f.is_closed)
      there.push_back(there.front() + spokes.size());
    std::vector<Index> result;
    for(std::size_t k = 0; k + 1 < there.size(); ++k)
    {
      // a triangle has one side with these ends only, so there is an edge in between
      std::size_t i = there[k] + 1;
      while(i < there[k + 1] && m_is_crowded[spokes[i % spokes.size()].side])
        ++i;
      result.push_back(spokes[(i == there[k + 1] ? there[k] + 1 : i) % spokes.size()].side);
    }
    return result;
  }

  void cut(Index h)
  {
    const Index o = m_opposite[h];
    m_opposite[h] = m_opposite[o] = null_index;
    update(m_corners[h]);
    update(m_corners[o]);
  }

  const std::vector<Index>& m_corners;
  const std::vector<Crowded_edge>& m_edges;
  std::vector<Index>& m_opposite;
  const At_vertices m_corners_at, m_edges_at;
  std::vector<bool> m_is_crowded;                          // by side
  std::vector<std::vector<std::vector<Side_pair>>> m_ways; // by edge
  std::vector<std::size_t> m_way, m_excess;                // by edge
  std::size_t m_sum_of_excess = 0;
  std::set<std::size_t> m_failing; // edges whose excess is not 0
  std::vector<Index> m_fan_of;     // by corner, the smallest one of its fan of triangles
};

} // namespace

void join_faces(const std::vector<Point>& points, const std::vector<Index>& corners,
                const std::vector<Crowded_edge>& edges, bool is_inside_out, std::vector<Index>& opposite)
{
  Joiner(points, corners, edges, is_inside_out, opposite).join();
}

} // namespace constrictions
