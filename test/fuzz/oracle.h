// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_ORACLE_H
#define FUZZ_ORACLE_H

// Decides with 2000 digits whether a closed curve on a triangle mesh is a constriction. Shares no code with the package:
// neither headers, nor the structure of the mesh, nor the formulas. Faces are unfolded by divisions and square roots,
// side angles are sums of angles, and what is nearer to zero than 10^-1800 of its surroundings is zero. That is no proof
// of a tie, but no two numbers made of a few hundred doubles that somebody has met are so close. The least double is
// 10^-323, and along a strip several such differences may be multiplied.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {

typedef boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<2000, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>
    Real;

// Points and triangles. Each directed edge is in one triangle at most, and the triangles at a vertex are one fan.
struct Body
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> faces; // counterclockwise, seen from outside
};

// One point of a curve: a vertex, if `vertex` is not negative; else the crossing of an edge, out of the triangle that
// has it as `from`, `to`. So `to` is on the left.
struct Node
{
  int vertex, from, to;
};

enum class Finding
{
  STRICT,
  CONSTRICTION, // held in a flat band
  LEAKS,
  NOT_CLOSED,
  NOT_STRAIGHT,
  SMALL_ANGLE,
  NOT_SIMPLE,
  UNKNOWN // a curve without vertices, or a band without an end
};

class Oracle
{
public:
  struct Answer
  {
    Finding finding = Finding::UNKNOWN;
    std::set<std::pair<std::size_t, bool>> small_angles; // by node, and whether it is on the left
    std::set<std::pair<std::size_t, bool>> wrong_ends;   // crossings whose edge ends on the wrong side; is it the left
    bool repeats_vertex = false;                         // passes through a vertex twice
    bool crosses = false;                                // in a face or on an edge
    Real length = 0;
    Real least_angle = 100; // on a side of the curve, if it is straight between its vertices
  };

  explicit Oracle(const Body& body) : m_body(body), m_rings(body.points.size())
  {
    for(std::size_t f = 0; f < body.faces.size(); ++f)
      for(std::size_t i = 0; i < 3; ++i)
        m_face[{body.faces[f][i], body.faces[f][(i + 1) % 3]}] = static_cast<int>(f);
  }

  Answer examine(const std::vector<Node>& curve)
  {
    Answer answer;
    if(!is_closed(curve))
    {
      answer.finding = Finding::NOT_CLOSED;
      return answer;
    }
    const std::optional<std::vector<Arc>> arcs = unfold(curve, &answer);
    if(!arcs)
      return answer;
    if(!answer.wrong_ends.empty())
    {
      answer.finding = Finding::NOT_STRAIGHT;
      return answer;
    }
    std::array<bool, 2> is_strict = {{false, false}};
    for(std::size_t i = 0; i < arcs->size(); ++i)
    {
      const Arc &before = (*arcs)[(i + arcs->size() - 1) % arcs->size()], &after = (*arcs)[i];
      const std::array<std::optional<Real>, 2> angles = side_angles(after.from, after.out, before.back);
      for(std::size_t side = 0; side < 2; ++side)
      {
        if(angles[side])
          answer.least_angle = (std::min)(answer.least_angle, *angles[side]);
        if(turns_back(after.from, after.out, before.back))
        {
          answer.small_angles.emplace(after.node, side == 0); // either may be called the side of the angle of zero
          answer.least_angle = 0;
        }
        else if(!angles[side] || *angles[side] > pi() + epsilon())
          is_strict[side] = true;
        else if(*angles[side] < pi() - epsilon())
          answer.small_angles.emplace(after.node, side == 0);
      }
    }
    if(!answer.small_angles.empty())
    {
      answer.finding = Finding::SMALL_ANGLE;
      return answer;
    }
    find_meetings(curve, *arcs, answer);
    if(answer.repeats_vertex || answer.crosses)
    {
      answer.finding = Finding::NOT_SIMPLE;
      return answer;
    }
    answer.finding = is_strict[0] && is_strict[1] ? Finding::STRICT : Finding::CONSTRICTION;
    if(!is_strict[0])
      answer.finding = follow_band(*arcs, answer.length);
    if(!is_strict[1] && answer.finding == Finding::CONSTRICTION)
    {
      std::vector<Node> reversed(curve.rbegin(), curve.rend());
      for(Node& n : reversed)
        std::swap(n.from, n.to);
      answer.finding = follow_band(*unfold(reversed, nullptr), answer.length);
    }
    return answer;
  }

  // Of all corners of faces at a vertex.
  Real total_angle(int v)
  {
    Real sum = 0;
    for(const Real& corner : ring(v).corners)
      sum += corner;
    return sum;
  }

  bool is_on_boundary(int v) { return !ring(v).is_closed; }

private:
  struct Point
  {
    Real x = 0, y = 0;
  };

  // A direction at a vertex: in the face between neighbours `place` and `place` + 1 of its ring, at an angle from the
  // former.
  struct Direction
  {
    std::size_t place = 0;
    Real angle = 0;
  };

  struct Arc
  {
    int from, to;
    std::size_t node; // where it starts
    Direction out, back;
    std::vector<std::pair<int, int>> crossed;
    std::vector<Real> parameters; // of the crossings, from the right end to the left one
  };

  // The neighbours of a vertex, counterclockwise, and the corners between each and the next. Open at the boundary.
  struct Ring
  {
    std::vector<int> neighbours;
    std::vector<Real> corners;
    bool is_closed = false;
  };

  static const Real& pi()
  {
    static const Real value = boost::math::constants::pi<Real>();
    return value;
  }

  static const Real& epsilon()
  {
    static const Real value("1e-1800");
    return value;
  }

  static Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  static Real cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
  static Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
  static Real norm(const Point& a) { return sqrt(dot(a, a)); }
  static Real angle_between(const Point& a, const Point& b) { return atan2(cross(a, b), dot(a, b)); }

  int face_of(int a, int b) const
  {
    const auto it = m_face.find({a, b});
    return it == m_face.end() ? -1 : it->second;
  }

  // The third vertex of the face that has this directed edge; -1 if there is none.
  int third(int a, int b) const
  {
    const int f = face_of(a, b);
    if(f < 0)
      return -1;
    for(int v : m_body.faces[static_cast<std::size_t>(f)])
      if(v != a && v != b)
        return v;
    return -1;
  }

  // The way from one vertex to another one. No rounding, if the coordinates are of moderate size.
  std::array<Real, 3> way(int a, int b) const
  {
    std::array<Real, 3> result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = Real(m_body.points[static_cast<std::size_t>(b)][k]) - m_body.points[static_cast<std::size_t>(a)][k];
    return result;
  }

  static Real dot(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // Twice the area of the triangle between them; zero if they are parallel, without a rounding error.
  static Real area(const std::array<Real, 3>& a, const std::array<Real, 3>& b)
  {
    const std::array<Real, 3> normal = {
        {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    return sqrt(dot(normal, normal));
  }

  Real length_of_edge(int a, int b) const
  {
    const std::array<Real, 3> edge = way(a, b);
    return sqrt(dot(edge, edge));
  }

  // In the plane, the third corner of a triangle on the left of the way from p to q.
  Point corner(int a, int b, int c, const Point& p, const Point& q) const
  {
    const std::array<Real, 3> ab = way(a, b), ac = way(a, c);
    const Real square = dot(ab, ab);
    const Real along = dot(ab, ac) / square, height = area(ab, ac) / square; // in multiples of ab
    const Point d = minus(q, p);
    return {p.x + along * d.x - height * d.y, p.y + along * d.y + height * d.x};
  }

  const Ring& ring(int v)
  {
    std::optional<Ring>& result = m_rings[static_cast<std::size_t>(v)];
    if(result)
      return *result;
    result.emplace();
    if(m_spokes.empty())
      for(const auto& edge : m_face)
        m_spokes[edge.first.first].push_back(edge.first.second);
    const std::vector<int>& spokes = m_spokes[v];
    int first = spokes.front();
    for(int w : spokes)
      if(face_of(w, v) < 0) // no face clockwise of this one
        first = w;
    int w = first;
    do
    {
      result->neighbours.push_back(w);
      const int next = third(v, w);
      if(next < 0)
        break;
      const std::array<Real, 3> a = way(v, w), b = way(v, next);
      result->corners.push_back(atan2(area(a, b), dot(a, b)));
      w = next;
    } while(w != first);
    result->is_closed = w == first;
    return *result;
  }

  bool is_closed(const std::vector<Node>& curve)
  {
    const std::size_t n = curve.size();
    if(n < 2)
      return false;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Node &p = curve[i], &q = curve[(i + 1) % n];
      for(const Node& e : {p, q})
        if(e.vertex < 0 && (face_of(e.from, e.to) < 0 || face_of(e.to, e.from) < 0))
          return false;
      bool fits;
      if(p.vertex >= 0 && q.vertex >= 0)
        fits = face_of(p.vertex, q.vertex) >= 0 || face_of(q.vertex, p.vertex) >= 0;
      else if(p.vertex >= 0)
        fits = third(q.from, q.to) == p.vertex;
      else if(q.vertex >= 0)
        fits = third(p.to, p.from) == q.vertex;
      else
        fits = face_of(p.to, p.from) == face_of(q.from, q.to) && !(q.from == p.to && q.to == p.from);
      if(!fits)
        return false;
    }
    return true;
  }

  Direction along_edge(int v, int to)
  {
    const Ring& r = ring(v);
    const auto place = std::find(r.neighbours.begin(), r.neighbours.end(), to);
    return {static_cast<std::size_t>(place - r.neighbours.begin()), 0};
  }

  // The arcs from vertex to vertex; none if there is no vertex. Adds to the answer, if there is one, the length, and the
  // ends of edges that an arc passes on the wrong side.
  std::optional<std::vector<Arc>> unfold(const std::vector<Node>& curve, Answer* answer)
  {
    const std::size_t n = curve.size();
    std::size_t first = 0;
    while(first < n && curve[first].vertex < 0)
      ++first;
    if(first == n)
      return std::nullopt;
    std::vector<Arc> arcs;
    for(std::size_t k = 0; k < n; ++k)
    {
      const Node& node = curve[(first + k) % n];
      if(node.vertex >= 0)
      {
        arcs.emplace_back();
        arcs.back().from = node.vertex;
        arcs.back().node = (first + k) % n;
      }
      else
        arcs.back().crossed.emplace_back(node.from, node.to);
    }
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      Arc& arc = arcs[i];
      arc.to = arcs[(i + 1) % arcs.size()].from;
      if(arc.crossed.empty())
      {
        arc.out = along_edge(arc.from, arc.to);
        arc.back = along_edge(arc.to, arc.from);
        if(answer != nullptr)
          answer->length += length_of_edge(arc.from, arc.to);
        continue;
      }
      std::vector<Point> lefts, rights;
      Point right = {length_of_edge(arc.from, arc.crossed.front().first), 0},
            left = corner(arc.from, arc.crossed.front().first, arc.crossed.front().second, Point(), right), end;
      for(std::size_t c = 0; c < arc.crossed.size(); ++c)
      {
        lefts.push_back(left);
        rights.push_back(right);
        const auto [r, l] = arc.crossed[c];
        const int apex = third(l, r);
        const Point p = corner(l, r, apex, left, right);
        if(c + 1 == arc.crossed.size())
          end = p;
        else if(arc.crossed[c + 1].first == r)
          left = p;
        else
          right = p;
      }
      Real size = 0;
      for(std::size_t c = 0; c < lefts.size(); ++c)
        size = (std::max)({size, norm(lefts[c]), norm(rights[c])});
      if(norm(end) < epsilon() * size)
        end = Point(); // the strip leads back to where it starts, as around a flat vertex: no edge is between its ends
      const Real length = norm(end);
      for(std::size_t c = 0; c < lefts.size(); ++c)
      {
        const Real to_left = cross(end, lefts[c]), to_right = -cross(end, rights[c]);
        if(answer != nullptr && !(to_left > epsilon() * length * norm(lefts[c])))
          answer->wrong_ends.emplace((arc.node + 1 + c) % n, true);
        if(answer != nullptr && !(to_right > epsilon() * length * norm(rights[c])))
          answer->wrong_ends.emplace((arc.node + 1 + c) % n, false);
        arc.parameters.push_back(to_right + to_left == 0 ? Real(0) : Real(to_right / (to_right + to_left)));
      }
      if(answer != nullptr)
        answer->length += length;
      arc.out = along_edge(arc.from, arc.crossed.front().first);
      arc.out.angle = angle_between(rights.front(), end);
      arc.back = along_edge(arc.to, arc.crossed.back().second);
      arc.back.angle = angle_between(minus(lefts.back(), end), minus(Point(), end));
    }
    return arcs;
  }

  // Whether a curve leaves in the direction that it came from.
  bool turns_back(int v, const Direction& out, const Direction& back)
  {
    const Real turn = abs(place(v, back) - place(v, out));
    return turn < epsilon() || (!is_on_boundary(v) && turn > total_angle(v) - epsilon());
  }

  // The angle from the first neighbour to a direction.
  Real place(int v, const Direction& d)
  {
    Real sum = d.angle;
    for(std::size_t i = 0; i < d.place; ++i)
      sum += ring(v).corners[i];
    return sum;
  }

  // On the left and on the right of a curve that comes from `back` and goes to `out`; none on the side of a hole.
  std::array<std::optional<Real>, 2> side_angles(int v, const Direction& out, const Direction& back)
  {
    const Real turn = place(v, back) - place(v, out), total = total_angle(v);
    if(is_on_boundary(v))
      return turn > 0 ? std::array<std::optional<Real>, 2>{{turn, std::nullopt}}
                      : std::array<std::optional<Real>, 2>{{std::nullopt, Real(-turn)}};
    const Real left = turn < 0 ? Real(turn + total) : turn;
    return {{left, Real(total - left)}};
  }

  void find_meetings(const std::vector<Node>& curve, const std::vector<Arc>& arcs, Answer& answer)
  {
    std::set<int> vertices;
    for(const Node& n : curve)
      if(n.vertex >= 0 && !vertices.insert(n.vertex).second)
        answer.repeats_vertex = true;
    // each piece in a face is a chord, whose ends have places along the border of the face
    std::map<int, std::vector<std::array<Real, 2>>> chords;
    const auto place = [this](int f, int from, int to, const Real& parameter) -> Real {
      const auto& corners = m_body.faces[static_cast<std::size_t>(f)];
      for(int i = 0; i < 3; ++i)
      {
        const int a = corners[static_cast<std::size_t>(i)], b = corners[static_cast<std::size_t>((i + 1) % 3)];
        if(a == from && b == to)
          return i + parameter;
        if(a == to && b == from)
          return i + (1 - parameter);
      }
      return -1;
    };
    const auto place_of_vertex = [this](int f, int v) -> Real {
      const auto& corners = m_body.faces[static_cast<std::size_t>(f)];
      return Real(std::find(corners.begin(), corners.end(), v) - corners.begin());
    };
    for(const Arc& arc : arcs)
      for(std::size_t c = 0; c <= arc.crossed.size() && !arc.crossed.empty(); ++c)
      {
        const bool begins = c == 0, ends = c == arc.crossed.size();
        const int f = ends ? face_of(arc.crossed[c - 1].second, arc.crossed[c - 1].first)
                           : face_of(arc.crossed[c].first, arc.crossed[c].second);
        chords[f].push_back(
            {{begins ? place_of_vertex(f, arc.from)
                     : place(f, arc.crossed[c - 1].first, arc.crossed[c - 1].second, arc.parameters[c - 1]),
              ends ? place_of_vertex(f, arc.to)
                   : place(f, arc.crossed[c].first, arc.crossed[c].second, arc.parameters[c])}});
      }
    for(const auto& in_face : chords)
      for(std::size_t i = 0; i < in_face.second.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
        {
          std::array<Real, 2> a = in_face.second[i];
          const std::array<Real, 2>& b = in_face.second[j];
          std::sort(a.begin(), a.end());
          int inside = 0;
          bool meets = false;
          for(const Real& end : b)
          {
            inside += end > a[0] && end < a[1];
            // at a corner they have a vertex in common, which is known
            for(const Real& other : a)
              meets = meets || (abs(end - other) < epsilon() && abs(end - round(end)) > epsilon());
          }
          const bool common_vertex = std::any_of(b.begin(), b.end(), [&a](const Real& end) {
            return abs(end - a[0]) < epsilon() || abs(end - a[1]) < epsilon();
          });
          answer.crosses = answer.crosses || meets || (inside == 1 && !common_vertex);
        }
  }

  // Of the flat band on the left of a curve, all of whose angles there are pi.
  Finding follow_band(const std::vector<Arc>& arcs, const Real& length)
  {
    // the edges that a copy close to the curve crosses
    std::vector<std::pair<int, int>> strip;
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      strip.insert(strip.end(), arcs[i].crossed.begin(), arcs[i].crossed.end());
      const int v = arcs[i].to;
      const Direction &out = arcs[(i + 1) % arcs.size()].out, &back = arcs[i].back;
      const Ring& r = ring(v);
      const std::size_t n = r.neighbours.size();
      std::vector<int> passed; // counterclockwise from `out` to `back`
      if(out.place != back.place || back.angle <= out.angle)
      {
        std::size_t k = (out.place + 1) % n;
        for(; k != back.place; k = (k + 1) % n)
          passed.push_back(r.neighbours[k]);
        if(back.angle > 0)
          passed.push_back(r.neighbours[k]);
      }
      for(auto w = passed.rbegin(); w != passed.rend(); ++w)
        strip.emplace_back(v, *w);
    }
    for(int end = 0; end < 1000; ++end)
    {
      const std::size_t n = strip.size();
      std::vector<Point> lefts, rights;
      Point right, left = {0, length_of_edge(strip[0].first, strip[0].second)};
      for(std::size_t i = 0; i < n; ++i)
      {
        lefts.push_back(left);
        rights.push_back(right);
        const auto [r, l] = strip[i];
        const Point p = corner(l, r, third(l, r), left, right);
        (strip[(i + 1) % n].first == r ? left : right) = p;
      }
      const Point way = minus(right, rights[0]);
      const Real way_length = norm(way);
      if(abs(way_length - length) > epsilon() * length)
        return Finding::UNKNOWN; // not a band
      const auto height = [&](const Point& p) { return Real(cross(way, p) / way_length); };
      Real top = height(lefts[0]);
      for(const Point& p : lefts)
        top = (std::min)(top, height(p));
      std::vector<bool> is_met(n);
      bool leaks = false, holds = false;
      for(std::size_t i = 0; i < n; ++i)
      {
        is_met[i] = height(lefts[i]) < top + epsilon() * length;
        if(!is_met[i])
          continue;
        const int v = strip[i].second;
        const Real total = is_on_boundary(v) ? Real(100) : total_angle(v);
        leaks = leaks || total < 2 * pi() - epsilon();
        holds = holds || total > 2 * pi() + epsilon();
      }
      if(leaks || holds)
        return leaks ? Finding::LEAKS : Finding::CONSTRICTION;
      strip = beyond(strip, is_met);
      if(strip.empty())
        return Finding::UNKNOWN;
    }
    return Finding::UNKNOWN;
  }

  // The edges that copies cross on the other side of the vertices that are met; none if that is a single vertex.
  std::vector<std::pair<int, int>> beyond(const std::vector<std::pair<int, int>>& strip,
                                          const std::vector<bool>& is_met)
  {
    const std::size_t n = strip.size();
    std::size_t first = 0;
    while(first < n && is_met[first] && is_met[(first + n - 1) % n] &&
          strip[first].second == strip[(first + n - 1) % n].second)
      ++first;
    if(first == n)
      return {};
    std::vector<std::pair<int, int>> result;
    for(std::size_t k = 0; k < n;)
    {
      const auto edge = strip[(first + k) % n];
      if(!is_met[(first + k) % n])
      {
        result.push_back(edge);
        ++k;
        continue;
      }
      // a run of edges that end at one vertex v on the left: go around it on the other side, so that v is on the right
      const int v = edge.second;
      std::size_t last = k;
      while(last + 1 < n && is_met[(first + last + 1) % n] && strip[(first + last + 1) % n].second == v)
        ++last;
      const int until = strip[(first + last) % n].first; // the last edge is left into the face of v, until
      // from the face left of which the run came: (edge.first, v, x) has the edge from v to x, out of which it goes
      for(int x = third(edge.first, v); x != until; x = third(x, v))
        result.emplace_back(v, x);
      k = last + 1;
    }
    // what is crossed to and fro
    std::vector<std::pair<int, int>> kept;
    for(const auto& edge : result)
      if(!kept.empty() && kept.back() == std::make_pair(edge.second, edge.first))
        kept.pop_back();
      else
        kept.push_back(edge);
    while(kept.size() > 1 && kept.front() == std::make_pair(kept.back().second, kept.back().first))
    {
      kept.erase(kept.begin());
      kept.pop_back();
    }
    return kept;
  }

  const Body& m_body;
  std::map<std::pair<int, int>, int> m_face; // of a directed edge
  std::map<int, std::vector<int>> m_spokes;
  std::vector<std::optional<Ring>> m_rings;
};

} // namespace fuzz

#endif // FUZZ_ORACLE_H
