// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SIMPLICITY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SIMPLICITY_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Whether a closed curve of straight arcs crosses or touches itself, decided exactly: the crossings of an edge are
// sorted along it, and the strands in a face cross if their ends alternate on its boundary.
template <class Surface>
class Exact_simplicity
{
public:
  typedef Exact_arc<Surface> Arc;
  typedef typename Surface::Vertex Vertex;
  typedef typename Surface::Halfedge Halfedge;

  // Where a curve meets itself.
  struct Meeting
  {
    Certificate_verdict verdict; // CROSSES_ITSELF, TOUCHES_ITSELF, TIE_NOT_PROVED; NOT_COMPUTED if it is simple
    std::size_t location, other_location;
  };

  Exact_simplicity(Sign_prover<Surface>& prover, const std::vector<Arc>& arcs) : m_prover(prover), m_arcs(arcs) {}

  // The first meeting found. O(n log n), plus the squared number of strands in each face, plus the comparisons of
  // crossings of the same edge, each linear in the arcs of the two.
  Meeting find()
  {
    if(!find_repeated_pivot())
      if(sort_crossings())
        find_crossing_strands();
    return m_meeting;
  }

private:
  // Crossing number `index` of an arc.
  struct Crossing
  {
    std::size_t arc, index;
  };

  // A straight piece inside a face, from place to place on the face's boundary. Corner i of the face is at i * m_step.
  struct Strand
  {
    Halfedge face; // the smallest of its halfedges
    std::size_t entry, exit;
    std::size_t location;

    friend bool operator<(const Strand& a, const Strand& b)
    {
      return a.face != b.face ? a.face < b.face : a.location < b.location;
    }
  };

  const Surface& surface() const { return m_prover.surface(); }

  void meet(Certificate_verdict verdict, std::size_t location, std::size_t other_location)
  {
    m_meeting = {verdict, (std::min)(location, other_location), (std::max)(location, other_location)};
  }

  bool find_repeated_pivot()
  {
    std::map<Vertex, std::size_t> first;
    for(std::size_t i = 0; i < m_arcs.size(); ++i)
    {
      const auto it = first.emplace(m_arcs[i].from, i);
      if(it.second)
        continue;
      const std::size_t j = it.first->second;
      switch(is_crossed_at_pivot(i, j))
      {
      case Proved_sign::UNPROVED:
        meet(Certificate_verdict::TIE_NOT_PROVED, m_arcs[j].location, m_arcs[i].location);
        break;
      case Proved_sign::POSITIVE:
        meet(Certificate_verdict::CROSSES_ITSELF, m_arcs[j].location, m_arcs[i].location);
        break;
      default:
        meet(Certificate_verdict::TOUCHES_ITSELF, m_arcs[j].location, m_arcs[i].location);
      }
      return true;
    }
    return false;
  }

  // A direction at a pivot: a halfedge, and the arc that runs along it or lies counterclockwise of it in its face.
  struct Ray
  {
    Halfedge halfedge;
    std::size_t arc;
    bool is_start; // whether at the start of the arc, not at its end
  };

  // Whether the two strands through the pivot where arcs i and j start cross there: whether the rays of one separate
  // those of the other. POSITIVE if they cross, NEGATIVE if they do not, or UNPROVED. Strands that run along each other
  // do not cross there.
  Proved_sign is_crossed_at_pivot(std::size_t i, std::size_t j)
  {
    const std::size_t n = m_arcs.size();
    const std::array<std::size_t, 4> strand_arcs = {{(i + n - 1) % n, i, (j + n - 1) % n, j}};
    std::vector<Ray> rays;
    for(int r = 0; r < 4; ++r)
    {
      const Arc& a = m_arcs[strand_arcs[r]];
      const bool is_start = r % 2 == 1;
      rays.push_back({is_start ? start_halfedge(surface(), a) : end_halfedge(surface(), a), strand_arcs[r], is_start});
    }
    std::vector<int> order; // of the rays, counterclockwise
    const Halfedge begin = rays[0].halfedge;
    Halfedge h = begin;
    do
    {
      std::vector<int> here;
      for(int r = 0; r < 4; ++r)
        if(rays[r].halfedge == h)
        {
          auto place = here.begin();
          for(; place != here.end(); ++place)
          {
            const Proved_sign turn = turn_between(rays[r], rays[*place]);
            if(turn == Proved_sign::UNPROVED)
              return turn;
            if(turn == Proved_sign::ZERO)
              return Proved_sign::NEGATIVE; // they run along each other
            if(turn == Proved_sign::POSITIVE)
              break;
          }
          here.insert(place, r);
        }
      order.insert(order.end(), here.begin(), here.end());
      h = ccw(surface(), h);
    } while(h != begin);
    const bool alternate = order[0] / 2 == order[2] / 2;
    return alternate ? Proved_sign::POSITIVE : Proved_sign::NEGATIVE;
  }

  // The sign of the angle from one ray to another in the same face.
  Proved_sign turn_between(const Ray& a, const Ray& b)
  {
    return m_prover.sign([&](const auto& arithmetic, auto& value) {
      const auto direction = [&](const Ray& r) {
        return r.is_start ? start_direction(surface(), arithmetic, m_arcs[r.arc])
                          : end_direction(surface(), arithmetic, m_arcs[r.arc]);
      };
      value[0] = determinant(direction(a), direction(b));
    });
  }

  // Ranks the crossings of each edge. False if two of them are the same point, or an arc runs along the edge.
  bool sort_crossings()
  {
    std::map<Halfedge, std::vector<Crossing>> of_edge;
    for(std::size_t a = 0; a < m_arcs.size(); ++a)
      for(std::size_t i = 0; i < m_arcs[a].crossings.size(); ++i)
        of_edge[edge(surface(), m_arcs[a].crossings[i])].push_back({a, i});
    for(const Arc& arc : m_arcs)
    {
      const auto it = arc.is_edge() ? of_edge.find(edge(surface(), arc.along)) : of_edge.end();
      if(it != of_edge.end())
      {
        meet(Certificate_verdict::CROSSES_ITSELF, arc.location, location(it->second.front()));
        return false;
      }
    }
    m_rank.resize(m_arcs.size());
    for(std::size_t a = 0; a < m_arcs.size(); ++a)
      m_rank[a].assign(m_arcs[a].crossings.size(), 0);
    for(auto& entry : of_edge)
    {
      std::vector<Crossing> sorted;
      for(const Crossing& c : entry.second)
      {
        auto place = sorted.begin();
        for(; place != sorted.end(); ++place)
        {
          const Proved_sign sign = compare(c, *place);
          if(sign == Proved_sign::UNPROVED || sign == Proved_sign::ZERO)
          {
            meet(sign == Proved_sign::ZERO ? Certificate_verdict::CROSSES_ITSELF : Certificate_verdict::TIE_NOT_PROVED,
                 location(c), location(*place));
            return false;
          }
          if(sign == Proved_sign::NEGATIVE)
            break;
        }
        sorted.insert(place, c);
      }
      m_step = (std::max)(m_step, sorted.size() + 1);
      for(std::size_t r = 0; r < sorted.size(); ++r)
      {
        // counted along the halfedge that is crossed
        const bool along = m_arcs[sorted[r].arc].crossings[sorted[r].index] == entry.first;
        m_rank[sorted[r].arc][sorted[r].index] = along ? r + 1 : sorted.size() - r;
        m_count[entry.first] = sorted.size();
      }
    }
    return true;
  }

  std::size_t location(const Crossing& c) const { return m_arcs[c.arc].location + 1 + c.index; }

  // The sign of the difference of the places of two crossings along the smaller halfedge of their edge.
  Proved_sign compare(const Crossing& a, const Crossing& b)
  {
    return m_prover.sign([&](const auto& arithmetic, auto& value) {
      typedef typename std::decay_t<decltype(arithmetic)>::NT NT;
      const auto parts = [&](const Crossing& c) {
        const Arc& arc = m_arcs[c.arc];
        const Unfolded_strip<NT> strip = unfold(surface(), arithmetic, arc);
        const Exact_portal<NT>& portal = strip.portals[c.index];
        // the crossing divides the halfedge in the ratio of these two positive numbers
        std::pair<NT, NT> result(determinant(portal.right, strip.apex), determinant(strip.apex, portal.left));
        if(arc.crossings[c.index] != edge(surface(), arc.crossings[c.index]))
          std::swap(result.first, result.second);
        return result;
      };
      const std::pair<NT, NT> p = parts(a), q = parts(b);
      value[0] = p.first * q.second - q.first * p.second;
    });
  }

  Halfedge smallest_halfedge(Halfedge h) const
  {
    return (std::min)(h, (std::min)(surface().next(h), surface().prev(h)));
  }

  // The place, on the boundary of the face of h, of the crossing of h with this rank along h; or of source(h) if the
  // rank is 0.
  std::size_t place(Halfedge h, std::size_t rank) const
  {
    const Halfedge first = smallest_halfedge(h);
    const std::size_t corner = h == first ? 0 : h == surface().next(first) ? 1 : 2;
    return corner * m_step + rank;
  }

  void find_crossing_strands()
  {
    std::vector<Strand> strands;
    for(std::size_t a = 0; a < m_arcs.size(); ++a)
    {
      const Arc& arc = m_arcs[a];
      if(arc.is_edge())
        continue;
      Halfedge at = start_halfedge(surface(), arc);
      std::size_t entry = place(at, 0);
      for(std::size_t i = 0; i < arc.crossings.size(); ++i)
      {
        const Halfedge h = arc.crossings[i], o = surface().opposite(h);
        const std::size_t rank = m_rank[a][i];
        strands.push_back({smallest_halfedge(h), entry, place(h, rank), arc.location + i});
        entry = place(o, m_count.at(edge(surface(), h)) + 1 - rank);
      }
      const Halfedge end = end_halfedge(surface(), arc);
      strands.push_back({smallest_halfedge(end), entry, place(end, 0), arc.location + arc.crossings.size()});
    }
    std::sort(strands.begin(), strands.end());
    // x strictly between a and b, counterclockwise from a
    const auto between = [](std::size_t a, std::size_t b, std::size_t x) {
      return a < b ? a < x && x < b : x > a || x < b;
    };
    for(std::size_t i = 0; i < strands.size(); ++i)
      for(std::size_t j = i + 1; j < strands.size() && strands[j].face == strands[i].face; ++j)
      {
        const Strand &s = strands[i], &t = strands[j];
        const bool share_corner = s.entry == t.entry || s.entry == t.exit || s.exit == t.entry || s.exit == t.exit;
        if(share_corner || between(s.entry, s.exit, t.entry) == between(s.entry, s.exit, t.exit))
          continue;
        meet(Certificate_verdict::CROSSES_ITSELF, s.location, t.location);
        return;
      }
  }

  Sign_prover<Surface>& m_prover;
  const std::vector<Arc>& m_arcs;
  Meeting m_meeting = {Certificate_verdict::NOT_COMPUTED, 0, 0};
  std::vector<std::vector<std::size_t>> m_rank; // of each arc's crossings, from 1, along the halfedge crossed
  std::map<Halfedge, std::size_t> m_count;      // of the crossings of an edge
  std::size_t m_step = 2;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_SIMPLICITY_H
