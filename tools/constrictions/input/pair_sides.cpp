// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/pair_sides.h"

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

namespace constrictions {

namespace {

// Where a half-plane at the edge lies, seen from the first one: counterclockwise around the edge, looking against its
// direction. Exact.
class Angular_order
{
public:
  Angular_order(const Point& u, const Point& v, const Point& first) : m_u(u), m_v(v), m_first(first) {}

  // 0 beside the first, 1 less than half a turn, 2 half a turn, 3 more than that
  int sector(const Point& p) const
  {
    const CGAL::Orientation o = CGAL::orientation(m_u, m_v, m_first, p);
    if(o != CGAL::COPLANAR)
      return o == CGAL::POSITIVE ? 1 : 3;
    if(CGAL::collinear(m_u, m_v, m_first) || CGAL::collinear(m_u, m_v, p))
      return 0;
    return CGAL::coplanar_orientation(m_u, m_v, m_first, p) == CGAL::POSITIVE ? 0 : 2;
  }

  // -1, 0 or 1
  int compare(const Point& p, const Point& q) const
  {
    const int s = sector(p), t = sector(q);
    if(s != t)
      return s < t ? -1 : 1;
    if(s % 2 == 0)
      return 0;
    const CGAL::Orientation o = CGAL::orientation(m_u, m_v, p, q);
    return o == CGAL::POSITIVE ? -1 : o == CGAL::COPLANAR ? 0 : 1;
  }

private:
  const Point &m_u, &m_v, &m_first;
};

// Matches each opening with the closing that follows it around the edge, as parentheses.
std::vector<Side_pair> matched(const std::vector<Side_at_edge>& sides, bool forth_closes)
{
  std::deque<Index> open;
  std::vector<Index> unmatched;
  std::vector<Side_pair> result;
  for(const Side_at_edge& s : sides)
    if(s.is_forth != forth_closes)
      open.push_back(s.side);
    else if(open.empty())
      unmatched.push_back(s.side);
    else
    {
      result.push_back({{open.back(), s.side}});
      open.pop_back();
    }
  // over the beginning
  for(std::size_t i = 0; i < unmatched.size() && !open.empty(); ++i, open.pop_back())
    result.push_back({{open.back(), unmatched[i]}});
  return result;
}

// All ways to pair some sides, those of more pairs first.
std::vector<std::vector<Side_pair>> all_matchings(const std::vector<Side_at_edge>& sides)
{
  std::vector<std::vector<Side_pair>> result = {{}};
  for(const Side_at_edge& s : sides)
    if(s.is_forth)
    {
      const std::vector<std::vector<Side_pair>> shorter = result;
      for(const std::vector<Side_pair>& pairs : shorter)
        for(const Side_at_edge& t : sides)
          if(!t.is_forth &&
             std::none_of(pairs.begin(), pairs.end(), [&t](const Side_pair& p) { return p[1] == t.side; }))
          {
            result.push_back(pairs);
            result.back().push_back({{s.side, t.side}});
          }
    }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return result;
}

bool has_pairs_of(const std::vector<Side_pair>& a, const std::vector<Side_pair>& b)
{
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&b](const Side_pair& p) {
           return std::any_of(b.begin(), b.end(), [&p](const Side_pair& q) {
             return (std::min)(p[0], p[1]) == (std::min)(q[0], q[1]) &&
                    (std::max)(p[0], p[1]) == (std::max)(q[0], q[1]);
           });
         });
}

} // namespace

std::vector<std::vector<Side_pair>> ways_to_pair(const Point& u, const Point& v, const std::vector<Side_at_edge>& sides,
                                                 bool is_inside_out)
{
  // The normal of a face that runs forth points counterclockwise around the edge: the inside, if there is one, ends
  // there.
  const Angular_order order(u, v, sides.front().apex);
  const auto in_order = [&](bool forth_closes) {
    std::vector<Side_at_edge> result = sides;
    std::stable_sort(result.begin(), result.end(), [&](const Side_at_edge& a, const Side_at_edge& b) {
      const int c = order.compare(a.apex, b.apex);
      // of faces in one place the one where an inside ends comes first: bodies that share it stay apart
      return c != 0 ? c < 0 : (a.is_forth == forth_closes) && (b.is_forth != forth_closes);
    });
    return result;
  };
  std::vector<std::vector<Side_pair>> result;
  for(bool forth_closes : {!is_inside_out, is_inside_out})
    result.push_back(matched(in_order(forth_closes), forth_closes));
  const std::size_t few = 6; // of these there are 34 ways at most
  if(sides.size() > few)
    for(std::size_t way = 0; way < 2; ++way)
      for(std::size_t left_out = result[way].size(); left_out-- > 0;)
      {
        std::vector<Side_pair> pairs = result[way];
        pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(left_out));
        result.push_back(std::move(pairs));
      }
  if(sides.size() > few)
    result.emplace_back();
  else
    for(std::vector<Side_pair>& pairs : all_matchings(sides))
      if(!has_pairs_of(result[0], pairs) && !has_pairs_of(result[1], pairs))
        result.push_back(std::move(pairs));
  return result;
}

} // namespace constrictions
