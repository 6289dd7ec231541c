// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/clean_faces.h"

#include "input/disjoint_sets.h"
#include "input/edge_groups.h"
#include "input/point_grid.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/splitmix64.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::null_index;

std::string edge_of_face(Index u, Index v, std::size_t face)
{
  return "the edge between vertices " + std::to_string(u) + " and " + std::to_string(v) + " of face " +
         std::to_string(face);
}

class Face_cleaner
{
public:
  Face_cleaner(const Polygon_soup& soup, Mesh_findings& findings)
    : m_soup(soup), m_findings(findings), m_same(soup.points.size())
  {}

  Clean_faces clean(double merging_distance, bool closes_seams)
  {
    if(merging_distance > 0)
      merge_near(merging_distance);
    collapse_edges();
    m_result.twin.assign(m_soup.number_of_faces(), null_index);
    set_faces();
    std::vector<Border_edge> border = border_edges();
    m_result.border_edges = border.size();
    // where faces are left out there may be a new border, and so a new seam
    bool has_new_border = true;
    while(has_new_border)
    {
      if(closes_seams && close_seams(border))
        set_faces();
      has_new_border = leave_out_duplicates() && closes_seams;
      if(has_new_border)
        border = border_edges();
    }
    tell_of_degenerate_faces();
    for(Index v = 0; v < m_soup.points.size(); ++v)
      m_result.stand_in.push_back(m_same.find(v));
    return std::move(m_result);
  }

private:
  // Each vertex into the first one near that has not been merged into another: what is merged does not drift away.
  void merge_near(double distance)
  {
    Point_grid grid(distance);
    for(Index v = 0; v < m_soup.points.size(); ++v)
    {
      Index nearest = null_index;
      grid.for_each_near(m_soup.points[v], [&](Index u) {
        if(CGAL::squared_distance(m_soup.points[u], m_soup.points[v]) <= distance * distance)
          nearest = (std::min)(nearest, u);
      });
      if(nearest == null_index)
        grid.add(m_soup.points[v], v);
      else
        merge(v, nearest);
    }
  }

  void merge(Index v, Index into)
  {
    if(m_same.unite(v, into))
      m_findings.add(Finding::MERGED_VERTICES,
                     [&] { return "vertex " + std::to_string(v) + " is merged into vertex " + std::to_string(into); });
  }

  void collapse_edges()
  {
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
      for(std::size_t c = m_soup.begin(f), end = m_soup.begin(f + 1); c < end; ++c)
      {
        const Index u = m_soup.corners[c], v = m_soup.corners[c + 1 == end ? m_soup.begin(f) : c + 1];
        if(u != v && m_soup.points[u] == m_soup.points[v] && m_same.unite(u, v))
          m_findings.add(Finding::COLLAPSED_EDGES,
                         [&] { return "degenerate face: " + edge_of_face(u, v, f) + " has length zero"; });
      }
  }

  // The faces that have three different corners, with the vertices that stand for others. Corners that follow each
  // other are different, and so are those on both sides of one.
  void set_faces()
  {
    m_result.corners.clear();
    m_result.begins.assign(1, 0);
    m_result.face.clear();
    m_degenerate.clear();
    std::vector<Index> corners;
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
    {
      if(m_result.twin[f] != null_index)
        continue;
      corners.clear();
      for(std::size_t c = m_soup.begin(f); c < m_soup.begin(f + 1); ++c)
        corners.push_back(m_same.find(m_soup.corners[c]));
      remove_spikes(corners);
      if(corners.size() < 3)
      {
        m_degenerate.push_back(f);
        continue;
      }
      m_result.corners.insert(m_result.corners.end(), corners.begin(), corners.end());
      m_result.begins.push_back(m_result.corners.size());
      m_result.face.push_back(static_cast<Index>(f));
    }
  }

  static void remove_spikes(std::vector<Index>& corners)
  {
    for(std::size_t i = 0; i < corners.size();)
    {
      const std::size_t n = corners.size(), next = (i + 1) % n;
      if(n == 1)
        return;
      const bool is_repeated = corners[i] == corners[next];
      if(is_repeated || corners[(i + n - 1) % n] == corners[next])
      {
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
        i = i > 1 ? i - 2 : 0;
      }
      else
        ++i;
    }
  }

  struct Border_edge
  {
    Index from, to; // from is at the smaller point
  };

  std::vector<Border_edge> border_edges() const
  {
    const auto& points = m_soup.points;
    std::vector<Border_edge> border;
    Edge_groups(points.size(), m_result.corners, m_result.begins)
        .for_each([&](Index u, const Edge_groups::Side* begin, const Edge_groups::Side* end) {
          if(end - begin == 1)
            border.push_back(points[u] < points[begin->to] ? Border_edge{u, begin->to} : Border_edge{begin->to, u});
        });
    return border;
  }

  // Merges the ends of border edges that have the same ends in space.
  bool close_seams(std::vector<Border_edge>& border)
  {
    const auto& points = m_soup.points;
    const auto compare = [&points](Index a, Index b) {
      return points[a] < points[b] ? -1 : points[b] < points[a] ? 1 : 0;
    };
    std::stable_sort(border.begin(), border.end(), [&](const Border_edge& a, const Border_edge& b) {
      const int from = compare(a.from, b.from);
      return from != 0 ? from < 0 : compare(a.to, b.to) < 0;
    });
    bool is_any_merged = false;
    for(std::size_t i = 1; i < border.size(); ++i)
      if(compare(border[i].from, border[i - 1].from) == 0 && compare(border[i].to, border[i - 1].to) == 0)
        for(const auto& [v, w] :
            {std::make_pair(border[i].from, border[i - 1].from), std::make_pair(border[i].to, border[i - 1].to)})
        {
          const Index a = m_same.find(v), b = m_same.find(w);
          is_any_merged = is_any_merged || a != b;
          merge((std::max)(a, b), (std::min)(a, b));
        }
    return is_any_merged;
  }

  void tell_of_degenerate_faces()
  {
    for(std::size_t f : m_degenerate)
      m_findings.add(Finding::DEGENERATE_FACES, [f] {
        return "degenerate face: face " + std::to_string(f) + " has fewer than three different corners";
      });
  }

  // The corners of a face from the smallest on, in the direction of its smaller neighbour, and whether that is the
  // direction of the face.
  bool sorted_corners(std::size_t i, std::vector<Index>& corners) const
  {
    const auto begin = m_result.corners.begin();
    corners.assign(begin + static_cast<std::ptrdiff_t>(m_result.begins[i]),
                   begin + static_cast<std::ptrdiff_t>(m_result.begins[i + 1]));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const bool is_forth = corners[1] < corners.back();
    if(!is_forth)
      std::reverse(corners.begin() + 1, corners.end());
    return is_forth;
  }

  struct Pair
  {
    std::size_t first, second; // of one face and the same one turned round
  };

  // Returns whether there were any.
  bool leave_out_duplicates()
  {
    const std::size_t n = m_result.size();
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    std::vector<Index> corners, others;
    for(std::size_t i = 0; i < n; ++i)
    {
      sorted_corners(i, corners);
      std::uint64_t hash = 0;
      for(Index c : corners)
        hash = CGAL::Surface_mesh_constrictions::internal::splitmix64(hash ^ c);
      order.emplace_back(hash, i);
    }
    std::sort(order.begin(), order.end());

    std::vector<bool> is_left_out(n, false);
    std::vector<Pair> pairs;
    for(std::size_t begin = 0; begin < n;)
    {
      std::size_t end = begin + 1;
      while(end < n && order[end].first == order[begin].first)
        ++end;
      for(std::size_t a = begin; a < end; ++a)
      {
        const std::size_t i = order[a].second;
        if(is_left_out[i])
          continue;
        const bool is_forth = sorted_corners(i, corners);
        std::size_t opposite = n;
        for(std::size_t b = a + 1; b < end; ++b)
        {
          const std::size_t j = order[b].second;
          const bool is_same_direction = sorted_corners(j, others) == is_forth;
          if(is_left_out[j] || corners != others)
            continue;
          if(is_same_direction || opposite != n)
            leave_out(j, is_same_direction ? i : opposite, is_left_out);
          else
            opposite = j;
        }
        if(opposite != n)
          pairs.push_back({i, opposite});
      }
      begin = end;
    }
    resolve_pairs(pairs, is_left_out);
    remove(is_left_out);
    return m_result.size() < n;
  }

  void leave_out(std::size_t i, std::size_t instead, std::vector<bool>& is_left_out)
  {
    const Index f = m_result.face[i], g = m_result.face[instead];
    is_left_out[i] = true;
    m_result.twin[f] = g;
    m_findings.add(Finding::DUPLICATE_FACES, [f, g] {
      return "duplicate face: face " + std::to_string(f) + " has the same corners as face " + std::to_string(g);
    });
  }

  // Neighbouring pairs are a region with two layers. At its rim other faces go on: an odd number of them at an edge
  // makes a surface with one layer, an even number with both, as where two bodies touch. A region without a rim has no
  // inside, and one layer is left, unless it is a pair alone, which is what a body leaves that has vanished.
  void resolve_pairs(const std::vector<Pair>& pairs, std::vector<bool>& is_left_out)
  {
    if(pairs.empty())
      return;
    std::vector<Index> pair_of(m_result.size(), null_index), face_of_corner(m_result.corners.size());
    for(std::size_t p = 0; p < pairs.size(); ++p)
      pair_of[pairs[p].first] = pair_of[pairs[p].second] = static_cast<Index>(p);
    for(std::size_t i = 0; i < m_result.size(); ++i)
      for(std::size_t c = m_result.begins[i]; c < m_result.begins[i + 1]; ++c)
        face_of_corner[c] = static_cast<Index>(i);

    Disjoint_sets regions(pairs.size());
    std::vector<std::array<std::size_t, 2>> rim; // a pair, and the number of other faces at an edge of it
    Edge_groups(m_soup.points.size(), m_result.corners, m_result.begins)
        .for_each([&](Index, const Edge_groups::Side* begin, const Edge_groups::Side* end) {
          std::size_t others = 0;
          Index pair = null_index;
          for(const Edge_groups::Side* s = begin; s != end; ++s)
          {
            const std::size_t i = face_of_corner[s->side];
            if(pair_of[i] == null_index)
              others += !is_left_out[i];
            else if(pair == null_index)
              pair = pair_of[i];
            else
              regions.unite(pair, pair_of[i]);
          }
          if(pair != null_index)
            rim.push_back({{pair, others}});
        });
    struct Votes
    {
      std::size_t odd = 0, even = 0, pairs = 0;
    };
    std::vector<Votes> votes(pairs.size());
    for(std::size_t p = 0; p < pairs.size(); ++p)
      ++votes[regions.find(static_cast<Index>(p))].pairs;
    for(const auto& [pair, others] : rim)
      if(others > 0)
        ++(others % 2 == 1 ? votes[regions.find(static_cast<Index>(pair))].odd
                           : votes[regions.find(static_cast<Index>(pair))].even);
    for(std::size_t p = 0; p < pairs.size(); ++p)
    {
      const Votes& v = votes[regions.find(static_cast<Index>(p))];
      if(v.odd <= v.even && v.odd + v.even > 0)
        continue;
      leave_out(pairs[p].second, pairs[p].first, is_left_out);
      if(v.odd + v.even == 0 && v.pairs == 1)
        leave_out(pairs[p].first, pairs[p].second, is_left_out);
    }
  }

  void remove(const std::vector<bool>& is_left_out)
  {
    std::size_t left = 0, corner = 0;
    for(std::size_t i = 0; i < m_result.face.size(); ++i)
    {
      if(is_left_out[i])
        continue;
      const std::size_t begin = m_result.begins[i], end = m_result.begins[i + 1];
      m_result.begins[left] = corner;
      for(std::size_t c = begin; c < end; ++c)
        m_result.corners[corner++] = m_result.corners[c];
      m_result.face[left++] = m_result.face[i];
    }
    m_result.begins[left] = corner;
    m_result.begins.resize(left + 1);
    m_result.corners.resize(corner);
    m_result.face.resize(left);
  }

  const Polygon_soup& m_soup;
  Mesh_findings& m_findings;
  Disjoint_sets m_same;
  std::vector<std::size_t> m_degenerate; // faces of the file
  Clean_faces m_result;
};

} // namespace

Clean_faces clean_faces(const Polygon_soup& soup, double merging_distance, bool closes_seams, Mesh_findings& findings)
{
  return Face_cleaner(soup, findings).clean(merging_distance, closes_seams);
}

} // namespace constrictions
