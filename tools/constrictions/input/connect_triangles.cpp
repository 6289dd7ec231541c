// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/connect_triangles.h"

#include "input/edge_groups.h"
#include "input/join_faces.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <unordered_map>
#include <utility>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::Input_defect;
using CGAL::Surface_mesh_constrictions::Invalid_input;
using CGAL::Surface_mesh_constrictions::null_index;
using CGAL::Surface_mesh_constrictions::internal::Corner_table;
using CGAL::Surface_mesh_constrictions::internal::edge_name;

class Connector
{
public:
  Connector(const std::vector<Point>& points, Triangles& triangles, Mesh_findings& findings)
    : m_points(points), m_triangles(triangles), m_findings(findings)
  {}

  void connect()
  {
    find_edges();
    if(leave_out_flat_triangles())
      find_edges();
    orient();
    join();
    while(leave_out_vanished_bodies())
    {
      find_edges();
      join();
    }
    m_triangles.opposite = std::move(m_opposite);
  }

private:
  typedef Edge_groups::Side Side;

  Index next(Index h) const { return Corner_table::next(h); }
  Index corner(Index h) const { return m_triangles.corners[h]; }

  void find_edges()
  {
    std::vector<std::size_t> begins(m_triangles.size() + 1);
    for(std::size_t t = 0; t < begins.size(); ++t)
      begins[t] = 3 * t;
    m_opposite.assign(m_triangles.corners.size(), null_index);
    m_faces_at.assign(m_triangles.corners.size(), 0);
    m_crowded.clear();
    Edge_groups(m_points.size(), m_triangles.corners, begins)
        .for_each([this](Index u, const Side* begin, const Side* end) {
          for(const Side* s = begin; s != end; ++s)
            m_faces_at[s->side] = static_cast<Index>(end - begin);
          const bool meet = end - begin == 2 && (!m_is_oriented || begin[0].is_forth != begin[1].is_forth);
          if(meet)
          {
            m_opposite[begin[0].side] = begin[1].side;
            m_opposite[begin[1].side] = begin[0].side;
          }
          else if(end - begin > 1)
            m_crowded.push_back({u, begin->to, std::vector<Side>(begin, end)});
        });
  }

  void remove_triangles(const std::vector<bool>& is_left_out)
  {
    std::size_t left = 0;
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      if(is_left_out[t])
        continue;
      for(std::size_t i = 0; i < 3; ++i)
        m_triangles.corners[3 * left + i] = m_triangles.corners[3 * t + i];
      if(!m_triangles.is_turned.empty())
        m_triangles.is_turned[left] = m_triangles.is_turned[t];
      m_triangles.face[left++] = m_triangles.face[t];
    }
    m_triangles.corners.resize(3 * left);
    m_triangles.face.resize(left);
    if(!m_triangles.is_turned.empty())
      m_triangles.is_turned.resize(left);
  }

  void tell_left_out(Finding finding, std::size_t t, const char* why)
  {
    const Index f = m_triangles.face[t];
    m_findings.add(finding, [f, why] { return "degenerate face: face " + std::to_string(f) + why; });
  }

  // Those at edges with more than two faces, if no edge is left with one face. Returns whether there were any.
  bool leave_out_flat_triangles()
  {
    std::vector<bool> is_left_out(m_triangles.size(), false);
    std::vector<Index> faces_at = m_faces_at;
    bool is_any = false;
    for(const Crowded_edge& edge : m_crowded)
      for(const Side& s : edge.sides)
      {
        const Index h = s.side - s.side % 3;
        if(is_left_out[h / 3] ||
           !CGAL::collinear(m_points[corner(h)], m_points[corner(h + 1)], m_points[corner(h + 2)]) ||
           std::any_of(faces_at.begin() + h, faces_at.begin() + h + 3, [](Index n) { return n == 2; }))
          continue;
        is_any = is_left_out[h / 3] = true;
        tell_left_out(Finding::DEGENERATE_FACES, h / 3, " has no area");
        for(Index i = h; i < h + 3; ++i)
          lower_count(i, faces_at);
      }
    if(is_any)
      remove_triangles(is_left_out);
    return is_any;
  }

  // One face less at the edge of side h.
  void lower_count(Index h, std::vector<Index>& faces_at) const
  {
    const Index u = (std::min)(corner(h), corner(next(h))), v = (std::max)(corner(h), corner(next(h)));
    const auto edge = std::lower_bound(
        m_crowded.begin(), m_crowded.end(), std::make_pair(u, v),
        [](const Crowded_edge& e, const std::pair<Index, Index>& key) { return std::make_pair(e.u, e.v) < key; });
    if(edge != m_crowded.end() && edge->u == u && edge->v == v)
      for(const Side& s : edge->sides)
        --faces_at[s.side];
  }

  // Triangles joined over edges with two faces are a patch, and have one orientation. Then patches are turned round
  // where that lets more faces meet in opposite directions at edges with more of them.
  void orient()
  {
    const std::size_t n = m_triangles.size();
    std::vector<Index> patch(n, null_index);
    std::vector<bool> is_turned(n, false);
    std::vector<std::vector<Index>> triangles_of; // of each patch
    for(Index first = 0; first < n; ++first)
    {
      if(patch[first] != null_index)
        continue;
      const Index p = static_cast<Index>(triangles_of.size());
      std::vector<Index> found = {first};
      patch[first] = p;
      std::size_t turned = 0;
      for(std::size_t i = 0; i < found.size(); ++i)
        for(Index h = 3 * found[i]; h < 3 * found[i] + 3; ++h)
        {
          const Index o = m_opposite[h];
          if(o == null_index)
            continue;
          const bool is_other_turned = is_turned[h / 3] != (corner(h) == corner(o));
          if(patch[o / 3] == null_index)
          {
            patch[o / 3] = p;
            is_turned[o / 3] = is_other_turned;
            turned += is_other_turned;
            found.push_back(o / 3);
          }
          else if(is_turned[o / 3] != is_other_turned)
            throw_one_sided(h);
        }
      if(2 * turned > found.size())
        for(Index t : found)
          is_turned[t] = !is_turned[t];
      triangles_of.push_back(std::move(found));
    }
    turn_patches(patch, triangles_of, is_turned);

    m_is_oriented = true;
    m_triangles.is_turned = is_turned;
    for(Index t = 0; t < n; ++t)
      if(is_turned[t])
        std::swap(m_triangles.corners[3 * t + 1], m_triangles.corners[3 * t + 2]);
    if(std::find(is_turned.begin(), is_turned.end(), true) != is_turned.end())
      find_edges();
  }

  [[noreturn]] void throw_one_sided(Index h) const
  {
    const Index f = m_triangles.face[h / 3];
    throw Invalid_input(Input_defect::INCONSISTENT_ORIENTATION, f,
                        "inconsistent orientation: the surface cannot be oriented, as a Moebius strip cannot: that "
                        "shows at " +
                            edge_name(corner(h), corner(next(h))) + " of face " + std::to_string(f));
  }

  void turn_patches(const std::vector<Index>& patch, const std::vector<std::vector<Index>>& triangles_of,
                    std::vector<bool>& is_turned) const
  {
    typedef std::unordered_map<std::size_t, long long> Shares; // by crowded edge: forth minus back
    std::vector<long long> balance(m_crowded.size(), 0);
    std::unordered_map<Index, Shares> shares; // by patch
    for(std::size_t e = 0; e < m_crowded.size(); ++e)
      for(const Side& s : m_crowded[e].sides)
      {
        const long long direction = s.is_forth != is_turned[s.side / 3] ? 1 : -1;
        balance[e] += direction;
        shares[patch[s.side / 3]][e] += direction;
      }
    const int rounds = 20;
    bool has_changed = true;
    for(int round = 0; round < rounds && has_changed; ++round)
    {
      has_changed = false;
      for(Index p = 0; p < triangles_of.size(); ++p)
      {
        const auto its_shares = shares.find(p);
        if(its_shares == shares.end())
          continue;
        long long gain = 0; // a sum: the order does not matter
        for(const auto& [e, share] : its_shares->second)
          gain += std::abs(balance[e]) - std::abs(balance[e] - 2 * share);
        if(gain <= 0)
          continue;
        has_changed = true;
        for(auto& [e, share] : its_shares->second)
        {
          balance[e] -= 2 * share;
          share = -share;
        }
        for(Index t : triangles_of[p])
          is_turned[t] = !is_turned[t];
      }
    }
  }

  // The volume, six times, of what the oriented triangles enclose; negative if they are inside out.
  double volume() const
  {
    const Point& o = m_points[corner(0)];
    double result = 0;
    for(Index h = 0; h < m_triangles.corners.size(); h += 3)
      result +=
          CGAL::cross_product(m_points[corner(h)] - o, m_points[corner(h + 1)] - o) * (m_points[corner(h + 2)] - o);
    return result;
  }

  void join() { join_faces(m_points, m_triangles.corners, m_crowded, !m_crowded.empty() && volume() < 0, m_opposite); }

  // Two triangles joined along all three edges.
  bool leave_out_vanished_bodies()
  {
    std::vector<bool> is_left_out(m_triangles.size(), false);
    bool is_any = false;
    for(Index h = 0; h < m_opposite.size(); h += 3)
    {
      const Index o = m_opposite[h];
      if(o == null_index || m_opposite[h + 1] == null_index || m_opposite[h + 2] == null_index ||
         m_opposite[h + 1] / 3 != o / 3 || m_opposite[h + 2] / 3 != o / 3)
        continue;
      is_any = is_left_out[h / 3] = true;
      tell_left_out(Finding::DEGENERATE_FACES, h / 3, " and the same face turned round enclose nothing");
    }
    if(is_any)
      remove_triangles(is_left_out);
    return is_any;
  }

  const std::vector<Point>& m_points;
  Triangles& m_triangles;
  Mesh_findings& m_findings;
  std::vector<Index> m_opposite; // by side
  std::vector<Index> m_faces_at; // by side, the number of faces at its edge
  std::vector<Crowded_edge> m_crowded;
  bool m_is_oriented = false;
};

} // namespace

void connect_triangles(const std::vector<Point>& points, Triangles& triangles, Mesh_findings& findings)
{
  Connector(points, triangles, findings).connect();
}

} // namespace constrictions
