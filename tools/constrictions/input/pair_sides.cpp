// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/pair_sides.h"

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <deque>

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
  result.emplace_back();
  return result;
}

} // namespace constrictions
