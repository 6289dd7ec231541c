// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_ARRANGEMENT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_ARRANGEMENT_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Arc_order.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Surface_arc.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Curves on a mesh that do not cross, closed or from one pivot to another: on each edge the order of their crossings, in
// each face their strands. Arcs that curves share are stored once. Curves may touch at pivots, and end at those of
// others.
template <class TriangleMesh>
class Curve_arrangement
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  typedef Surface_arc<TriangleMesh> Arc;
  typedef typename Constriction<TriangleMesh>::Location Location;

  // An arc as part of a curve.
  struct Arc_use
  {
    std::size_t arc;
    bool is_forward;
  };

  struct Crossing
  {
    std::size_t arc, position; // the place in the arc
    std::size_t edge;
    std::size_t rank; // among the crossings of the edge
  };

  // A crossed edge. Nothing crosses it if a curve that did has been refused.
  struct Edge
  {
    halfedge_descriptor halfedge;       // the one that stands for the edge
    std::vector<std::size_t> crossings; // in order along the halfedge
  };

  // The piece of an arc before its crossing `position`; after the last one, `position` is their number.
  struct Strand
  {
    std::size_t arc, position;
  };

  struct Face
  {
    face_descriptor face;
    std::vector<Strand> strands;
  };

  explicit Curve_arrangement(const TriangleMesh& tm) : m_tm(tm), m_order(tm, m_arcs) {}
  Curve_arrangement(const Curve_arrangement&) = delete;
  Curve_arrangement& operator=(const Curve_arrangement&) = delete;

  // Inserts a curve unless it crosses an inserted one, or itself. Returns the number of the crossed curve, or `none`.
  // Numbers are the user's. Throws Invalid_input for a curve that is not closed, and then inserts nothing.
  // Linear in the number of crossings, times the number of crossings of one edge and of strands in one face; plus, for
  // each stretch on which two arcs cross the same edges, its length times the logarithm of the number of crossings.
  std::optional<std::size_t> insert(const Constriction<TriangleMesh>& constriction, std::size_t number)
  {
    return insert(constriction.locations(), number, true);
  }

  // As above, of a curve that is given by its points; one that is not closed begins and ends at a pivot.
  std::optional<std::size_t> insert(const std::vector<Location>& locations, std::size_t number, bool is_closed)
  {
    const std::size_t old_arcs = m_arcs.size(), old_crossings = m_crossings.size();
    Curve curve = {number, is_closed, {}};
    for(Arc& arc : surface_arcs(m_tm, locations, number, is_closed))
      add_arc(std::move(arc), curve);
    std::optional<std::size_t> crossed = crossed_by_arcs(old_arcs, curve);
    m_curves.push_back(std::move(curve));
    for(std::size_t i = m_curves.back().first_passage(); i < m_curves.back().uses.size(); ++i)
      if(!m_arcs[m_curves.back().uses[i].arc].is_closed)
        m_visits[start(m_curves.back().uses[i])].push_back({m_curves.size() - 1, i});
    if(!crossed)
      crossed = crossed_at_pivots();
    if(crossed)
      remove_last(old_arcs, old_crossings);
    return crossed;
  }

  const std::vector<Arc>& arcs() const { return m_arcs; }
  const std::vector<Crossing>& crossings() const { return m_crossings; }
  const std::vector<Edge>& edges() const { return m_edges; }
  const std::vector<Face>& faces() const { return m_faces; }

  // the number of the first curve that an arc belongs to
  std::size_t curve_of_arc(std::size_t arc) const { return m_curve_of_arc[arc]; }

  // the crossing at a place of an arc
  std::size_t crossing(std::size_t arc, std::size_t position) const { return m_first_crossing[arc] + position; }

  std::size_t number_of_curves() const { return m_curves.size(); }
  std::size_t curve_number(std::size_t curve) const { return m_curves[curve].number; }
  const std::vector<Arc_use>& curve(std::size_t curve) const { return m_curves[curve].uses; }

  // the parameter of a crossing along the halfedge of its edge, as the curve has it
  double parameter(std::size_t crossing) const
  {
    const Crossing& c = m_crossings[crossing];
    const double t = m_arcs[c.arc].parameters[c.position];
    return m_arcs[c.arc].crossings[c.position] == m_edges[c.edge].halfedge ? t : 1 - t;
  }

  // the crossings before and after a strand; none where the arc begins or ends
  std::pair<std::optional<std::size_t>, std::optional<std::size_t>> ends(const Strand& s) const
  {
    const Arc& arc = m_arcs[s.arc];
    const std::size_t n = arc.crossings.size();
    std::pair<std::optional<std::size_t>, std::optional<std::size_t>> result;
    if(arc.is_closed || s.position > 0)
      result.first = crossing(s.arc, (s.position + n - 1) % n);
    if(s.position < n)
      result.second = crossing(s.arc, s.position);
    return result;
  }

  // A place on the boundary of a face, counted counterclockwise from the source of `base`: the corner before side
  // `side`, or, if `rank` is greater than 0, the crossing of that rank on the side.
  struct Boundary_place
  {
    std::size_t side, rank;

    friend bool operator==(const Boundary_place& a, const Boundary_place& b)
    {
      return a.side == b.side && a.rank == b.rank;
    }
    friend bool operator<(const Boundary_place& a, const Boundary_place& b)
    {
      return a.side != b.side ? a.side < b.side : a.rank < b.rank;
    }
  };

  // the two ends of a strand
  std::pair<Boundary_place, Boundary_place> boundary_places(const Strand& s, halfedge_descriptor base) const
  {
    const auto [before, after] = ends(s);
    return {before ? place_of(*before, base) : corner(m_arcs[s.arc].from, base),
            after ? place_of(*after, base) : corner(m_arcs[s.arc].to, base)};
  }

private:
  struct Curve
  {
    std::size_t number;
    bool is_closed;
    std::vector<Arc_use> uses;

    // the first use that begins at a pivot which the curve passes through
    std::size_t first_passage() const { return is_closed ? 0 : 1; }
  };

  // The pivot at which an arc of a curve begins.
  struct Visit
  {
    std::size_t curve, use;
  };

  // An arc, as seen from one of its pivots.
  struct Ray
  {
    std::size_t arc;
    bool is_forward;

    friend bool operator==(const Ray& a, const Ray& b) { return a.arc == b.arc && a.is_forward == b.is_forward; }
  };

  vertex_descriptor start(const Arc_use& use) const
  {
    return use.is_forward ? m_arcs[use.arc].from : m_arcs[use.arc].to;
  }

  // Finds the arc among the inserted ones, or inserts it.
  void add_arc(Arc&& arc, Curve& curve)
  {
    const std::size_t a = m_arcs.size();
    m_arcs.push_back(std::move(arc));
    const Arc& added = m_arcs.back();
    if(const std::optional<Arc_use> same = find(a))
    {
      m_arcs.pop_back();
      // shared with another curve, or there and back in this one, which is found to cross itself
      curve.uses.push_back(*same);
      return;
    }
    curve.uses.push_back({a, true});
    m_curve_of_arc.push_back(curve.number);
    m_first_crossing.push_back(m_crossings.size());
    if(added.is_edge())
    {
      m_runs.emplace(edge(added.along, m_tm), a);
      return;
    }
    for(std::size_t i = 0; i < added.crossings.size(); ++i)
      add_crossing(a, i);
    for(std::size_t i = 0; i < added.number_of_strands(); ++i)
      m_faces[face_index(face_of_strand(added, i))].strands.push_back({a, i});
  }

  std::optional<Arc_use> find(std::size_t a) const
  {
    const Arc& arc = m_arcs[a];
    if(arc.is_edge())
    {
      const auto run = m_runs.find(edge(arc.along, m_tm));
      if(run == m_runs.end())
        return std::nullopt;
      return Arc_use{run->second, m_arcs[run->second].along == arc.along};
    }
    const auto crossed = m_edge_index.find(edge(arc.crossings[0], m_tm));
    if(crossed == m_edge_index.end())
      return std::nullopt;
    for(std::size_t c : m_edges[crossed->second].crossings)
    {
      const Crossing& other = m_crossings[c];
      if(m_order.is_same({a, 0}, {other.arc, other.position}))
        return Arc_use{other.arc, m_arcs[other.arc].crossings[other.position] == arc.crossings[0]};
    }
    return std::nullopt;
  }

  void add_crossing(std::size_t a, std::size_t position)
  {
    const auto inserted = m_edge_index.emplace(edge(m_arcs[a].crossings[position], m_tm), m_edges.size());
    if(inserted.second)
      m_edges.push_back({m_arcs[a].crossings[position], {}});
    const std::size_t e = inserted.first->second;
    const halfedge_descriptor h = m_edges[e].halfedge;
    m_crossings.push_back({a, position, e, 0});
    std::vector<std::size_t>& list = m_edges[e].crossings;
    std::optional<std::size_t> rank;
    // at the first edge of a closed arc there may be others between, as the strand that comes in there is still missing
    if(position > 0 && !(m_arcs[a].is_closed && m_crossings[m_first_crossing[a]].edge == e))
      rank = rank_beside_neighbour(a, position);
    if(!rank)
    {
      const auto is_before = [&](std::size_t c, std::size_t d) {
        return m_order.is_before(h, {m_crossings[c].arc, m_crossings[c].position},
                                 {m_crossings[d].arc, m_crossings[d].position});
      };
      rank = std::upper_bound(list.begin(), list.end(), m_crossings.size() - 1, is_before) - list.begin();
    }
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(*rank), m_crossings.size() - 1);
    number(list);
  }

  // The place of an arc's crossing on an edge, if an arc that was beside it at the edge before goes the same way: then
  // they are still side by side. None if there is no such arc. To follow arcs that run together for long, crossing by
  // crossing, would take quadratic time.
  std::optional<std::size_t> rank_beside_neighbour(std::size_t a, std::size_t position) const
  {
    const halfedge_descriptor from = m_arcs[a].crossings[position - 1], to = m_arcs[a].crossings[position];
    const Crossing& before = m_crossings[crossing(a, position - 1)];
    const Edge& edge_before = m_edges[before.edge];
    for(const bool is_lower : {true, false})
    {
      if(before.rank == (is_lower ? 0 : edge_before.crossings.size() - 1))
        continue;
      const Crossing& beside = m_crossings[edge_before.crossings[is_lower ? before.rank - 1 : before.rank + 1]];
      const Arc& arc = m_arcs[beside.arc];
      const std::size_t n = arc.crossings.size();
      const bool is_forward = arc.crossings[beside.position] == from;
      if(!arc.is_closed && beside.position == (is_forward ? n - 1 : 0))
        continue;
      const std::size_t next = (beside.position + (is_forward ? 1 : n - 1)) % n;
      if((is_forward ? arc.crossings[next] : opposite(arc.crossings[next], m_tm)) != to ||
         (beside.arc == a && next >= position))
        continue;
      const Crossing& neighbour = m_crossings[crossing(beside.arc, next)];
      // nearer to the source of one crossed halfedge is nearer to the source of the next
      const bool is_nearer_to_source = is_lower == (edge_before.halfedge == from);
      return neighbour.rank + (is_nearer_to_source == (m_edges[neighbour.edge].halfedge == to) ? 1 : 0);
    }
    return std::nullopt;
  }

  void number(const std::vector<std::size_t>& list)
  {
    for(std::size_t i = 0; i < list.size(); ++i)
      m_crossings[list[i]].rank = i;
  }

  // of an arc with crossings
  face_descriptor face_of_strand(const Arc& arc, std::size_t i) const
  {
    return face(i < arc.crossings.size() ? arc.crossings[i] : opposite(arc.crossings.back(), m_tm), m_tm);
  }

  std::size_t face_index(face_descriptor f)
  {
    const auto inserted = m_face_index.emplace(f, m_faces.size());
    if(inserted.second)
      m_faces.push_back({f, {}});
    return inserted.first->second;
  }

  Boundary_place corner(vertex_descriptor v, halfedge_descriptor base) const
  {
    return {source(base, m_tm) == v ? std::size_t(0) : target(base, m_tm) == v ? std::size_t(1) : std::size_t(2), 0};
  }

  Boundary_place place_of(std::size_t crossing, halfedge_descriptor base) const
  {
    const Edge& edge = m_edges[m_crossings[crossing].edge];
    const std::size_t rank = m_crossings[crossing].rank, n = edge.crossings.size();
    const halfedge_descriptor o = opposite(edge.halfedge, m_tm);
    halfedge_descriptor h = base;
    for(std::size_t side = 0;; ++side, h = next(h, m_tm))
    {
      if(h == edge.halfedge)
        return {side, 1 + rank};
      if(h == o)
        return {side, n - rank};
    }
  }

  bool cross(const Strand& s, const Strand& t, halfedge_descriptor base) const
  {
    auto [a, b] = boundary_places(s, base);
    auto [c, d] = boundary_places(t, base);
    if(b < a)
      std::swap(a, b);
    const auto side = [a = a, b = b](const Boundary_place& p) {
      return p == a || p == b ? 0 : a < p && p < b ? 1 : -1;
    };
    return side(c) * side(d) < 0;
  }

  // The curve that the newest arcs, of the curve that is not yet in the list, cross outside of pivots.
  std::optional<std::size_t> crossed_by_arcs(std::size_t old_arcs, const Curve& curve) const
  {
    std::vector<std::size_t> used;
    for(const Arc_use& use : curve.uses)
      used.push_back(use.arc);
    std::sort(used.begin(), used.end());
    if(std::adjacent_find(used.begin(), used.end()) != used.end())
      return curve.number;

    for(std::size_t a = old_arcs; a < m_arcs.size(); ++a)
    {
      const Arc& arc = m_arcs[a];
      if(arc.is_edge())
      {
        const auto beneath = m_edge_index.find(edge(arc.along, m_tm));
        if(beneath != m_edge_index.end() && !m_edges[beneath->second].crossings.empty())
          return m_curve_of_arc[m_crossings[m_edges[beneath->second].crossings.front()].arc];
        continue;
      }
      for(halfedge_descriptor h : arc.crossings)
      {
        const auto run = m_runs.find(edge(h, m_tm));
        if(run != m_runs.end())
          return m_curve_of_arc[run->second];
      }
      for(std::size_t i = 0; i < arc.number_of_strands(); ++i)
      {
        const face_descriptor f = face_of_strand(arc, i);
        const halfedge_descriptor base = halfedge(f, m_tm);
        for(const Strand& s : m_faces[m_face_index.at(f)].strands)
          if(cross({a, i}, s, base))
            return m_curve_of_arc[s.arc];
      }
    }
    return std::nullopt;
  }

  // The curve that the newest one crosses where they share pivots or arcs.
  std::optional<std::size_t> crossed_at_pivots() const
  {
    const std::size_t c = m_curves.size() - 1;
    for(std::size_t i = m_curves[c].first_passage(); i < m_curves[c].uses.size(); ++i)
    {
      if(m_arcs[m_curves[c].uses[i].arc].is_closed)
        continue;
      for(const Visit& v : m_visits.at(start(m_curves[c].uses[i])))
        if((v.curve != c || v.use != i) && cross_from(i, v))
          return m_curves[v.curve].number;
    }
    return std::nullopt;
  }

  // the ray out of the pivot at which use i of a curve begins, and the one back to where the curve comes from
  Ray ray_out(std::size_t curve, std::size_t i) const
  {
    const Arc_use& use = m_curves[curve].uses[i];
    return {use.arc, use.is_forward};
  }
  Ray ray_back(std::size_t curve, std::size_t i) const
  {
    const std::vector<Arc_use>& uses = m_curves[curve].uses;
    const Arc_use& use = uses[(i + uses.size() - 1) % uses.size()];
    return {use.arc, !use.is_forward};
  }

  // Whether the newest curve, which joins another at a pivot, leaves it on the other side than it has come from. It does
  // not if one of them ends before.
  bool cross_from(std::size_t i, Visit v) const
  {
    const std::size_t c = m_curves.size() - 1, n = m_curves[c].uses.size(), m = m_curves[v.curve].uses.size();
    const Ray from = ray_back(c, i);
    if(from == ray_back(v.curve, v.use) || from == ray_out(v.curve, v.use))
      return false; // it has joined before
    const bool comes_from_left = is_left(from, v);
    bool same_direction = true;
    for(std::size_t steps = 0; steps <= n; ++steps)
    {
      const Ray out = ray_out(c, i);
      if(out == ray_out(v.curve, v.use) && (steps == 0 || same_direction))
      {
        same_direction = true;
        v.use = (v.use + 1) % m;
        if(v.use < m_curves[v.curve].first_passage())
          return false;
      }
      else if(out == ray_back(v.curve, v.use) && (steps == 0 || !same_direction))
      {
        same_direction = false;
        v.use = (v.use + m - 1) % m;
        if(v.use < m_curves[v.curve].first_passage())
          return false;
      }
      else
        return is_left(out, v) != comes_from_left;
      i = (i + 1) % n;
      if(i < m_curves[c].first_passage())
        return false;
    }
    return false;
  }

  // Whether a ray out of a pivot is on the left of a curve that passes through.
  bool is_left(const Ray& ray, const Visit& v) const
  {
    const vertex_descriptor pivot = start(m_curves[v.curve].uses[v.use]);
    const auto out = direction(pivot, ray_out(v.curve, v.use)), back = direction(pivot, ray_back(v.curve, v.use)),
               d = direction(pivot, ray);
    return out < back ? out < d && d < back : out < d || d < back;
  }

  // The place of a ray among all around its pivot, counterclockwise.
  std::pair<std::size_t, std::size_t> direction(vertex_descriptor pivot, const Ray& ray) const
  {
    const Arc& arc = m_arcs[ray.arc];
    halfedge_descriptor outgoing;
    std::size_t rank = 0;
    if(arc.is_edge())
      outgoing = ray.is_forward ? arc.along : opposite(arc.along, m_tm);
    else
    {
      const std::size_t position = ray.is_forward ? 0 : arc.crossings.size() - 1;
      const halfedge_descriptor h = ray.is_forward ? arc.crossings.front() : opposite(arc.crossings.back(), m_tm);
      outgoing = prev(h, m_tm);
      rank = place_of(crossing(ray.arc, position), h).rank;
    }
    std::size_t turn = 0;
    for(halfedge_descriptor o = opposite(halfedge(pivot, m_tm), m_tm); o != outgoing; o = opposite(prev(o, m_tm), m_tm))
      ++turn;
    return {turn, rank};
  }

  // Undoes the insertion of the newest curve.
  void remove_last(std::size_t old_arcs, std::size_t old_crossings)
  {
    for(const Arc_use& use : m_curves.back().uses)
      if(!m_arcs[use.arc].is_closed)
      {
        std::vector<Visit>& visits = m_visits[start(use)];
        while(!visits.empty() && visits.back().curve == m_curves.size() - 1)
          visits.pop_back();
      }
    m_curves.pop_back();
    for(std::size_t c = m_crossings.size(); c-- > old_crossings;)
    {
      std::vector<std::size_t>& list = m_edges[m_crossings[c].edge].crossings;
      list.erase(std::find(list.begin(), list.end(), c));
      number(list);
    }
    m_crossings.resize(old_crossings);
    for(; m_arcs.size() > old_arcs; m_arcs.pop_back())
    {
      const Arc& arc = m_arcs.back();
      if(arc.is_edge())
        m_runs.erase(edge(arc.along, m_tm));
      for(halfedge_descriptor h : arc.crossings)
        for(face_descriptor f : {face(h, m_tm), face(opposite(h, m_tm), m_tm)})
        {
          std::vector<Strand>& strands = m_faces[m_face_index.at(f)].strands;
          while(!strands.empty() && strands.back().arc >= old_arcs)
            strands.pop_back();
        }
    }
    m_curve_of_arc.resize(old_arcs);
    m_first_crossing.resize(old_arcs);
  }

  const TriangleMesh& m_tm;
  std::vector<Arc> m_arcs;
  std::vector<std::size_t> m_curve_of_arc, m_first_crossing;
  Arc_order<TriangleMesh> m_order;
  std::vector<Crossing> m_crossings;
  std::vector<Edge> m_edges;
  std::vector<Face> m_faces;
  std::vector<Curve> m_curves;
  std::unordered_map<edge_descriptor, std::size_t> m_edge_index, m_runs;
  std::unordered_map<face_descriptor, std::size_t> m_face_index;
  std::unordered_map<vertex_descriptor, std::vector<Visit>> m_visits;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CURVE_ARRANGEMENT_H
