// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_BODIES_H
#define FUZZ_BODIES_H

// Small triangle meshes that bytes describe: a body of one of several kinds, then changes of it. Any bytes describe
// something; where they end, zeros follow. So a fuzzer can change a byte and get a similar body.

#include "oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {

class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_next(data), m_end(data + size) {}

  bool is_empty() const { return m_next == m_end; }
  unsigned next() { return m_next == m_end ? 0u : *m_next++; }
  int below(int n) { return static_cast<int>(next()) % n; }
  bool flag() { return next() % 2 == 1; }

private:
  const std::uint8_t *m_next, *m_end;
};

const std::size_t most_faces = 320;

// Makes faces of positions; equal positions are one vertex.
class Body_builder
{
public:
  typedef std::array<double, 3> Position;

  int vertex(const Position& p)
  {
    const auto it = m_vertices.emplace(p, static_cast<int>(body.points.size()));
    if(it.second)
      body.points.push_back(p);
    return it.first->second;
  }

  void triangle(const Position& a, const Position& b, const Position& c)
  {
    body.faces.push_back({{vertex(a), vertex(b), vertex(c)}});
  }

  void quad(const Position& a, const Position& b, const Position& c, const Position& d, bool other_diagonal)
  {
    triangle(a, b, other_diagonal ? d : c);
    if(other_diagonal)
      triangle(b, c, d);
    else
      triangle(a, c, d);
  }

  Body body;

private:
  std::map<Position, int> m_vertices;
};

typedef Body_builder::Position Position;

// Corner i of a polygon with n corners that is close to a circle: integers, or rounded where they fall.
inline std::array<double, 2> polygon_corner(int i, int n, bool is_integer)
{
  const double angle = 2 * 3.14159265358979323846 * i / n, c = std::cos(angle), s = std::sin(angle);
  return is_integer ? std::array<double, 2>{{std::round(24 * c), std::round(24 * s)}} : std::array<double, 2>{{c, s}};
}

// Rings one above the other, as an extruded or a turned body has them, or closed to a torus.
inline Body stack_of_rings(Bytes& bytes)
{
  const int n = 3 + bytes.below(6), m = 2 + bytes.below(6);
  const unsigned kind = bytes.next();
  const bool is_integer = kind & 1u, is_turned = kind & 2u, is_torus = (kind & 4u) && m >= 3, other = kind & 8u;
  const bool is_open_below = kind & 16u, is_open_above = kind & 32u;
  std::vector<std::vector<Position>> rings;
  double z = 0;
  for(int r = 0; r < m; ++r)
  {
    const unsigned b = bytes.next();
    const double radius = 1 + b % 8;
    z += r > 0 ? 1 + (b >> 3) % 8 : 0;
    std::vector<Position> ring;
    for(int i = 0; i < n; ++i)
    {
      // every other ring of a turned body is half a step further
      const std::array<double, 2> c =
          is_turned ? polygon_corner(2 * i + r % 2, 2 * n, is_integer) : polygon_corner(i, n, is_integer);
      if(is_torus)
      {
        const std::array<double, 2> d = polygon_corner(r, m, is_integer);
        const double far = (is_integer ? 24 : 1) * 12 + radius * c[0];
        ring.push_back({{far * d[0], -far * d[1], (is_integer ? 24 : 1) * radius * c[1]}});
      }
      else
        ring.push_back({{radius * c[0], radius * c[1], (is_integer ? 24 : 1) * z}});
    }
    rings.push_back(ring);
  }
  Body_builder b;
  for(int r = 0; r + (is_torus ? 0 : 1) < m; ++r)
    for(int i = 0; i < n; ++i)
    {
      const auto &low = rings[static_cast<std::size_t>(r)], &high = rings[static_cast<std::size_t>((r + 1) % m)];
      const auto here = static_cast<std::size_t>(i), there = static_cast<std::size_t>((i + 1) % n);
      b.quad(low[here], low[there], high[there], high[here], other != (is_turned && r % 2 == 1));
    }
  if(is_torus)
    return b.body;
  for(std::size_t i = 1; i + 1 < static_cast<std::size_t>(n); ++i)
  {
    if(!is_open_below)
      b.triangle(rings.front()[0], rings.front()[i + 1], rings.front()[i]);
    if(!is_open_above)
      b.triangle(rings.back()[0], rings.back()[i], rings.back()[i + 1]);
  }
  return b.body;
}

// The boundary of some of the cells of a grid.
inline Body voxels(Bytes& bytes)
{
  const std::array<int, 3> size = {{2 + bytes.below(3), 2 + bytes.below(2), 2 + bytes.below(2)}};
  const bool other = bytes.flag();
  std::set<std::array<int, 3>> cells;
  unsigned bits = 0;
  int left = 0;
  for(int i = 0; i < size[0]; ++i)
    for(int j = 0; j < size[1]; ++j)
      for(int k = 0; k < size[2]; ++k, --left, bits /= 2)
      {
        if(left == 0)
        {
          bits = bytes.next();
          left = 8;
        }
        if(bits % 2 == 1)
          cells.insert({{i, j, k}});
      }
  Body_builder b;
  const auto at = [](int i, int j, int k) {
    return Position{{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}};
  };
  for(const auto& [i, j, k] : cells)
  {
    const bool d = other != ((i + 2 * j + 3 * k) % 2 == 0);
    if(cells.count({{i + 1, j, k}}) == 0)
      b.quad(at(i + 1, j, k), at(i + 1, j + 1, k), at(i + 1, j + 1, k + 1), at(i + 1, j, k + 1), d);
    if(cells.count({{i - 1, j, k}}) == 0)
      b.quad(at(i, j, k), at(i, j, k + 1), at(i, j + 1, k + 1), at(i, j + 1, k), d);
    if(cells.count({{i, j + 1, k}}) == 0)
      b.quad(at(i, j + 1, k), at(i, j + 1, k + 1), at(i + 1, j + 1, k + 1), at(i + 1, j + 1, k), d);
    if(cells.count({{i, j - 1, k}}) == 0)
      b.quad(at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1), d);
    if(cells.count({{i, j, k + 1}}) == 0)
      b.quad(at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1), d);
    if(cells.count({{i, j, k - 1}}) == 0)
      b.quad(at(i, j, k), at(i, j + 1, k), at(i + 1, j + 1, k), at(i + 1, j, k), d);
  }
  return b.body;
}

inline Body octahedron()
{
  Body_builder b;
  const Position east = {{1, 0, 0}}, west = {{-1, 0, 0}}, north = {{0, 1, 0}}, south = {{0, -1, 0}}, up = {{0, 0, 1}},
                 down = {{0, 0, -1}};
  const std::array<Position, 4> belt = {{east, north, west, south}};
  for(std::size_t i = 0; i < 4; ++i)
  {
    b.triangle(belt[i], belt[(i + 1) % 4], up);
    b.triangle(belt[(i + 1) % 4], belt[i], down);
  }
  return b.body;
}

inline std::size_t some_face(const Body& body, Bytes& bytes)
{
  const std::size_t n = bytes.next();
  return (n + 256 * (body.faces.size() > 256 ? bytes.next() : 0)) % body.faces.size();
}

// A vertex in a face, at its centroid, moved along the normal by some part of the size of the face.
inline void raise_vertex(Body& body, std::size_t f, double height)
{
  const std::array<int, 3> t = body.faces[f];
  std::array<Position, 3> p;
  for(std::size_t i = 0; i < 3; ++i)
    p[i] = body.points[static_cast<std::size_t>(t[i])];
  Position u, v, middle;
  for(std::size_t k = 0; k < 3; ++k)
  {
    u[k] = p[1][k] - p[0][k];
    v[k] = p[2][k] - p[0][k];
    middle[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
  }
  const Position normal = {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  const double size = std::sqrt(std::hypot(normal[0], normal[1], normal[2]));
  for(std::size_t k = 0; k < 3 && size > 0; ++k)
    middle[k] += height * normal[k] / size;
  const int top = static_cast<int>(body.points.size());
  body.points.push_back(middle);
  body.faces[f] = {{t[0], t[1], top}};
  body.faces.push_back({{t[1], t[2], top}});
  body.faces.push_back({{t[2], t[0], top}});
}

// Cuts each face into four.
inline void subdivide(Body& body)
{
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto it = middles.emplace(std::minmax(a, b), static_cast<int>(body.points.size()));
    if(it.second)
    {
      const Position p = body.points[static_cast<std::size_t>(a)], q = body.points[static_cast<std::size_t>(b)];
      body.points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
    }
    return it.first->second;
  };
  std::vector<std::array<int, 3>> faces;
  for(const auto& t : body.faces)
  {
    const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    faces.push_back({{t[0], a, c}});
    faces.push_back({{t[1], b, a}});
    faces.push_back({{t[2], c, b}});
    faces.push_back({{a, b, c}});
  }
  body.faces.swap(faces);
}

// Takes two faces out, and joins the two holes by a tube: a handle, or, of two bodies, one body.
inline void join_faces(Body& body, std::size_t f, std::size_t g)
{
  const std::array<int, 3> a = body.faces[f], b = body.faces[g];
  for(int v : a)
    if(f == g || std::find(b.begin(), b.end(), v) != b.end())
      return;
  body.faces.erase(body.faces.begin() + static_cast<std::ptrdiff_t>((std::max)(f, g)));
  body.faces.erase(body.faces.begin() + static_cast<std::ptrdiff_t>((std::min)(f, g)));
  // the tube has the edges of each hole in the direction of the face that was there, and runs around the other way
  for(std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3, k = (3 - i) % 3, l = (5 - i) % 3;
    body.faces.push_back({{a[i], a[j], b[k]}});
    body.faces.push_back({{a[j], b[l], b[k]}});
  }
}

// A second copy, moved aside, which is joined to the first at faces of both.
inline void join_copy(Body& body, Bytes& bytes)
{
  double extent = 0;
  for(const Position& p : body.points)
    extent = (std::max)(extent, std::abs(p[0]));
  const std::size_t points = body.points.size(), faces = body.faces.size();
  for(std::size_t v = 0; v < points; ++v)
    body.points.push_back({{body.points[v][0] + 3 * extent + 1, body.points[v][1], body.points[v][2]}});
  for(std::size_t f = 0; f < faces; ++f)
  {
    std::array<int, 3> t = body.faces[f];
    for(int& v : t)
      v += static_cast<int>(points);
    body.faces.push_back(t);
  }
  join_faces(body, bytes.next() % faces, faces + bytes.next() % faces);
}

// Exchanges the diagonal of the two faces at side i of a face, if there are two and the other diagonal is no edge yet.
inline void flip_edge(Body& body, std::size_t f, std::size_t i)
{
  const int a = body.faces[f][i], b = body.faces[f][(i + 1) % 3], c = body.faces[f][(i + 2) % 3];
  for(std::size_t g = 0; g < body.faces.size(); ++g)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto t = body.faces[g];
      if(t[k] != b || t[(k + 1) % 3] != a)
        continue;
      const int d = t[(k + 2) % 3];
      for(const auto& other : body.faces)
        if(std::find(other.begin(), other.end(), c) != other.end() &&
           std::find(other.begin(), other.end(), d) != other.end())
          return;
      body.faces[f] = {{a, d, c}};
      body.faces[g] = {{d, b, c}};
      return;
    }
}

// By a rational rotation, from an integer quaternion; the results are rounded.
inline void rotate(Body& body, const std::array<int, 4>& q)
{
  const double w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + x * x + y * y + z * z;
  if(n == 0)
    return;
  for(Position& p : body.points)
    p = {{((w * w + x * x - y * y - z * z) * p[0] + 2 * (x * y - w * z) * p[1] + 2 * (x * z + w * y) * p[2]) / n,
          (2 * (x * y + w * z) * p[0] + (w * w - x * x + y * y - z * z) * p[1] + 2 * (y * z - w * x) * p[2]) / n,
          (2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] + (w * w - x * x - y * y + z * z) * p[2]) / n}};
}

inline void change(Body& body, Bytes& bytes)
{
  const int deed = bytes.below(13);
  switch(deed)
  {
  case 0:
    if(4 * body.faces.size() <= most_faces)
      subdivide(body);
    break;
  case 1:
  {
    const std::size_t f = some_face(body, bytes);
    raise_vertex(body, f, (bytes.below(33) - 16) / 8.);
    break;
  }
  case 2:
  {
    const std::size_t f = some_face(body, bytes);
    flip_edge(body, f, static_cast<std::size_t>(bytes.below(3)));
    break;
  }
  case 3: // some units in the last place
  {
    Position& p = body.points[bytes.next() % body.points.size()];
    const unsigned b = bytes.next();
    for(unsigned i = 0; i <= b / 6 % 4; ++i)
      p[b % 3] = std::nextafter(p[b % 3], b / 3 % 2 == 0 ? -1e308 : 1e308);
    break;
  }
  case 4: // all, each by its own unit in the last place
  {
    unsigned state = bytes.next() + 1;
    for(Position& p : body.points)
      for(double& x : p)
      {
        state = state * 1103515245 + 12345;
        x = (state >> 16) % 3 == 0 ? x : std::nextafter(x, (state >> 16) % 3 == 1 ? -1e308 : 1e308);
      }
    break;
  }
  case 5:
  {
    std::array<int, 4> q;
    for(int& x : q)
      x = bytes.below(7) - 3;
    rotate(body, q);
    break;
  }
  case 6:
  {
    const double factor = std::ldexp(1., bytes.below(41) - 20);
    for(Position& p : body.points)
      for(double& x : p)
        x *= factor;
    break;
  }
  case 7: // rounds where the body is far away
  {
    const unsigned b = bytes.next();
    for(Position& p : body.points)
      p[b % 3] += std::ldexp(1., static_cast<int>(b % 40));
    break;
  }
  case 8: // one axis
  {
    const unsigned b = bytes.next();
    const double factor = std::ldexp(1 + (b / 3 % 4) / 3., static_cast<int>(b / 12) - 10);
    for(Position& p : body.points)
      p[b % 3] *= factor;
    break;
  }
  case 9: // a hole
    body.faces.erase(body.faces.begin() + static_cast<std::ptrdiff_t>(some_face(body, bytes)));
    break;
  case 10:
  {
    const std::size_t f = some_face(body, bytes), g = some_face(body, bytes);
    join_faces(body, f, g);
    break;
  }
  case 11:
    if(2 * body.faces.size() + 4 <= most_faces)
      join_copy(body, bytes);
    break;
  default: // noise
  {
    const double size = std::ldexp(1., -1 - bytes.below(60));
    unsigned state = bytes.next() + 1;
    for(Position& p : body.points)
      for(double& x : p)
      {
        state = state * 1103515245 + 12345;
        x += size * ((state >> 16) % 1024 / 512. - 1);
      }
  }
  }
}

// Leaves out the vertices of no face.
inline void drop_unused_vertices(Body& body)
{
  std::vector<int> number(body.points.size(), -1);
  std::vector<Position> points;
  for(auto& t : body.faces)
    for(int& v : t)
    {
      int& n = number[static_cast<std::size_t>(v)];
      if(n < 0)
      {
        n = static_cast<int>(points.size());
        points.push_back(body.points[static_cast<std::size_t>(v)]);
      }
      v = n;
    }
  body.points.swap(points);
}

// Whether each directed edge is in one face, the faces at each vertex are one fan, no edge joins equal points, and the
// coordinates are finite.
inline bool is_surface(const Body& body)
{
  std::map<std::pair<int, int>, int> third;
  std::map<int, int> corners;
  for(const auto& t : body.faces)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const int a = t[i], b = t[(i + 1) % 3];
      if(a == b || body.points[static_cast<std::size_t>(a)] == body.points[static_cast<std::size_t>(b)] ||
         !third.emplace(std::make_pair(a, b), t[(i + 2) % 3]).second)
        return false;
      ++corners[a];
    }
  for(const auto& [v, n] : corners)
  {
    // around v counterclockwise, from a border if there is one
    auto edge = third.lower_bound({v, -1});
    int first = edge->first.second;
    for(; edge != third.end() && edge->first.first == v; ++edge)
      if(third.count({edge->first.second, v}) == 0)
        first = edge->first.second;
    int fan = 0, w = first;
    do
    {
      const auto it = third.find({v, w});
      if(it == third.end())
        break;
      ++fan;
      w = it->second;
    } while(w != first);
    if(fan != n)
      return false;
  }
  for(const Position& p : body.points)
    for(double x : p)
      if(!std::isfinite(x))
        return false;
  return !body.faces.empty();
}

// None if the bytes describe no surface.
inline std::optional<Body> make_body(Bytes& bytes)
{
  Body body;
  const int kind = bytes.below(4);
  body = kind == 0 ? voxels(bytes) : kind == 1 ? octahedron() : stack_of_rings(bytes);
  for(int changes = bytes.below(8); changes > 0 && !body.faces.empty() && body.faces.size() <= most_faces; --changes)
    change(body, bytes);
  drop_unused_vertices(body);
  if(!is_surface(body))
    return std::nullopt;
  return body;
}

} // namespace fuzz

#endif // FUZZ_BODIES_H
