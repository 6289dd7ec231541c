// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef EXACT_MODELS_H
#define EXACT_MODELS_H

// Surfaces with integer coordinates whose constrictions are known in closed form, with points of any kernel.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace exact_models {

using test_meshes::Position;
using test_meshes::Soup;
using test_meshes::Soup_builder;

// Rings of the same number of points, joined one to the next by quadrilaterals, and closed by a fan at both ends.
inline Soup tube(const std::vector<std::vector<Position>>& rings, bool is_twisted = false)
{
  Soup_builder b;
  const std::size_t n = rings.front().size();
  for(std::size_t r = 0; r + 1 < rings.size(); ++r)
    for(std::size_t i = 0; i < n; ++i)
      if(is_twisted && r % 2 == 1)
        b.quad(rings[r][i], rings[r][(i + 1) % n], rings[r + 1][(i + 1) % n], rings[r + 1][i], true);
      else
        b.quad(rings[r][i], rings[r][(i + 1) % n], rings[r + 1][(i + 1) % n], rings[r + 1][i]);
  for(std::size_t i = 1; i + 1 < n; ++i)
  {
    b.triangle(rings.front()[0], rings.front()[i + 1], rings.front()[i]);
    b.triangle(rings.back()[0], rings.back()[i], rings.back()[i + 1]);
  }
  return b.soup;
}

// A ring of points (factor * x, factor * y, z).
inline std::vector<Position> ring(const std::vector<std::array<int, 2>>& polygon, double factor, double z)
{
  std::vector<Position> result;
  for(const auto& p : polygon)
    result.push_back({{factor * p[0], factor * p[1], z}});
  return result;
}

inline std::vector<std::array<int, 2>> square() { return {{{1, -1}}, {{1, 1}}, {{-1, 1}}, {{-1, -1}}}; }

// A convex polygon with integer corners close to a circle.
inline std::vector<std::array<int, 2>> polygon(int n)
{
  std::vector<std::array<int, 2>> result;
  for(int i = 0; i < n; ++i)
    result.push_back({{static_cast<int>(std::lround(1000 * std::cos(2 * CGAL_PI * i / n))),
                       static_cast<int>(std::lround(1000 * std::sin(2 * CGAL_PI * i / n)))}});
  return result;
}

// Two prisms joined by one of a third of their width: its sides are flat bands `height` wide that hold at both ends.
inline Soup prism_chain(int n, double height)
{
  const auto p = polygon(n);
  return tube({ring(p, 3, 0), ring(p, 3, 500), ring(p, 1, 500), ring(p, 1, 500 + height), ring(p, 3, 500 + height),
               ring(p, 3, 1000 + height)});
}

// Two frusta joined at a square of side 2 a: a strict constriction of length 8 a.
inline Soup waist(int a) { return tube({ring(square(), 3 * a, 0), ring(square(), a, 5), ring(square(), 3 * a, 10)}); }

// Rings that are turned by 45 degrees from one to the next. The middle one, of length 8 sqrt(2), is a strict
// constriction: at each of its points three corners add up to more than pi on either side.
inline Soup twisted_cylinder()
{
  const std::vector<Position> wide = {{{2, -2, 0}}, {{2, 2, 0}}, {{-2, 2, 0}}, {{-2, -2, 0}}};
  std::vector<Position> low = wide, high = wide;
  for(Position& p : low)
    p[2] = -3;
  for(Position& p : high)
    p[2] = 3;
  const std::vector<Position> middle = {{{2, 0, 0}}, {{0, 2, 0}}, {{-2, 0, 0}}, {{0, -2, 0}}};
  Soup_builder b;
  for(std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t j = (i + 1) % 4;
    b.triangle(low[i], low[j], middle[i]);
    b.triangle(low[j], middle[j], middle[i]);
    b.triangle(middle[i], middle[j], high[j]);
    b.triangle(high[i], middle[i], high[j]);
  }
  for(std::size_t i = 1; i < 3; ++i)
  {
    b.triangle(low[0], low[i + 1], low[i]);
    b.triangle(high[0], high[i], high[i + 1]);
  }
  return b.soup;
}

// A tube between two rings with wider ones around them. The edge between the first points of the rings has a vertex, at
// 3/8 of its length: below the middle, so that above it is not the mirror image of below. Of the second half of the
// quadrilaterals the other diagonals are taken if `is_twisted`.
inline Soup tube_with_one_vertex(const std::vector<Position>& low, const std::vector<Position>& high,
                                 const std::vector<Position>& bottom, const std::vector<Position>& top,
                                 bool is_twisted = false)
{
  Position v;
  for(std::size_t k = 0; k < 3; ++k)
    v[k] = (5 * low[0][k] + 3 * high[0][k]) / 8;
  Soup_builder b;
  for(std::size_t i = 0; i < low.size(); ++i)
  {
    const std::size_t j = (i + 1) % low.size();
    b.quad(bottom[i], bottom[j], low[j], low[i]);
    b.quad(high[i], high[j], top[j], top[i]);
    if(i == 0)
    {
      b.triangle(low[i], low[j], v);
      b.triangle(low[j], high[j], v);
      b.triangle(v, high[j], high[i]);
    }
    else if(j == 0)
    {
      b.triangle(low[i], low[j], v);
      b.triangle(low[i], v, high[i]);
      b.triangle(high[i], v, high[j]);
    }
    else
      b.quad(low[i], low[j], high[j], high[i], is_twisted && 2 * i >= low.size());
  }
  for(std::size_t i = 1; i + 1 < low.size(); ++i)
  {
    b.triangle(bottom[0], bottom[i + 1], bottom[i]);
    b.triangle(top[0], top[i], top[i + 1]);
  }
  return b.soup;
}

// A prism between two wider ones, its upper end `factor` times as wide as its lower one, with a vertex at height 650.
inline Soup prism_with_one_vertex(int n, double factor)
{
  const auto p = polygon(n);
  return tube_with_one_vertex(ring(p, 1, 500), ring(p, factor, 900), ring(p, 3, 500), ring(p, 3, 900));
}

// A tube of 2 m sides, one half of which gets narrower upwards and the other one wider: point i of a ring is minus
// point m + i of the other one, in all but the height. By what the strip around it turns in the one half it turns back
// in the other. The rings are no circles, so that the sides of a half have different widths. The vertex is in the
// middle of the first half, between flat sides.
inline Soup tube_that_turns_to_and_fro(int m)
{
  const auto p = polygon(2 * m);
  auto low = ring(p, 1, 500), high = ring(p, 1, 900), bottom = ring(p, 3, 500), top = ring(p, 3, 900);
  for(int i = 0; i < 2 * m; ++i)
  {
    Position& wider = ((i + m / 2) % (2 * m) < m ? low : high)[static_cast<std::size_t>(i)];
    wider[0] *= 1 + 1. / 64;
    wider[1] *= 1 + 1. / 64;
  }
  for(auto* r : {&low, &high, &bottom, &top})
    for(Position& q : *r)
      q[0] += q[1] / 4;
  return tube_with_one_vertex(low, high, bottom, top, true);
}

inline std::size_t vertex_at_height(const Soup& soup, double z)
{
  return static_cast<std::size_t>(
      std::find_if(soup.points.begin(), soup.points.end(), [z](const Position& p) { return p[2] == z; }) -
      soup.points.begin());
}

// What a curve crosses that starts at a vertex and stays at its height until it is back; height(w) is that of a vertex.
// Seen from above it runs clockwise, or the other way.
template <class Surface, class Vertex, class Height>
auto crossings_at_height_of(const Surface& s, Vertex v, const Height& height, bool is_clockwise)
{
  typedef decltype(s.outgoing(v)) Halfedge;
  const double z = height(v);
  const auto is_crossed = [&](Halfedge h) { // its target is on the left
    const double target = height(s.target(h)), source = height(s.source(h));
    return is_clockwise ? target < z && source > z : target > z && source < z;
  };
  Halfedge h = s.next(s.outgoing(v));
  while(!is_crossed(h))
    h = s.next(s.opposite(s.prev(s.prev(h))));
  std::vector<Halfedge> result = {h};
  while(s.target(s.next(s.opposite(result.back()))) != v)
  {
    const Halfedge n = s.next(s.opposite(result.back()));
    result.push_back(is_crossed(n) ? n : s.next(n));
  }
  return result;
}

// The closed path of edges through these vertices, in the order of vertices(mesh), as a curve.
template <class Mesh>
CGAL::Surface_mesh_constrictions::Constriction<Mesh> curve_of_loop(const Mesh& mesh,
                                                                   const std::vector<std::size_t>& loop)
{
  typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
  const std::vector<typename Constriction::vertex_descriptor> all(vertices(mesh).begin(), vertices(mesh).end());
  typename Constriction::Data data;
  for(std::size_t v : loop)
    data.locations.push_back({true, all[v], typename Constriction::halfedge_descriptor(), 0});
  return Constriction(data);
}

// Numbers of the vertices of a soup at the given positions.
inline std::vector<std::size_t> vertices_at(const Soup& soup, const std::vector<Position>& positions)
{
  std::vector<std::size_t> result;
  for(const Position& p : positions)
    result.push_back(
        static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), p) - soup.points.begin()));
  return result;
}

template <class Mesh>
CGAL::Surface_mesh_constrictions::Certificate certify_loop(const Soup& soup, const std::vector<Position>& loop)
{
  const Mesh mesh = test_meshes::make_graph<Mesh>(soup);
  return CGAL::Surface_mesh_constrictions::certify_constriction(mesh, curve_of_loop(mesh, vertices_at(soup, loop)));
}

// Moves all points by a rational rotation, from an integer quaternion, and a scaling; exact if FT is.
template <class Mesh>
void rotate(Mesh& mesh, std::mt19937& random, double scale)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;
  std::uniform_int_distribution<int> integer(-9, 9);
  int q[4];
  do
  {
    for(int& x : q)
      x = integer(random);
  } while(q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0);
  const int a = q[0], b = q[1], c = q[2], d = q[3], n = a * a + b * b + c * c + d * d;
  const int m[3][3] = {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                       {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
                       {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
  for(auto v : vertices(mesh))
  {
    const Point p = get(vpm, v);
    FT r[3];
    for(int i = 0; i < 3; ++i)
      r[i] = FT(scale) * (FT(m[i][0]) * p.x() + FT(m[i][1]) * p.y() + FT(m[i][2]) * p.z()) / FT(n);
    put(vpm, v, Point(r[0], r[1], r[2]));
  }
}

} // namespace exact_models

#endif // EXACT_MODELS_H
