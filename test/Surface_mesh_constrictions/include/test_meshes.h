// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TEST_MESHES_H
#define TEST_MESHES_H

// Small closed triangle meshes whose constrictions are known, as points and faces.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace test_meshes {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef std::array<double, 3> Position;
typedef std::array<std::size_t, 3> Triangle;

struct Soup
{
  std::vector<Position> points;
  std::vector<Triangle> faces;
};

// Any mutable face graph with Point_3 = (x, y, z).
template <class Graph>
Graph make_graph(const Soup& soup)
{
  typedef typename boost::property_traits<typename boost::property_map<Graph, CGAL::vertex_point_t>::type>::value_type
      Point;
  Graph graph;
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> vertices;
  for(const Position& p : soup.points)
  {
    vertices.push_back(add_vertex(graph));
    put(get(CGAL::vertex_point, graph), vertices.back(), Point(p[0], p[1], p[2]));
  }
  for(const Triangle& t : soup.faces)
    CGAL::Euler::add_face(
        std::array<typename boost::graph_traits<Graph>::vertex_descriptor, 3>{
            {vertices[t[0]], vertices[t[1]], vertices[t[2]]}},
        graph);
  return graph;
}

inline Mesh make_mesh(const Soup& soup) { return make_graph<Mesh>(soup); }

inline CGAL::Surface_mesh_constrictions::Progressive_mesh make_progressive(const Soup& soup)
{
  using namespace CGAL::Surface_mesh_constrictions;
  std::vector<Index> corners;
  for(const Triangle& t : soup.faces)
    for(std::size_t v : t)
      corners.push_back(static_cast<Index>(v));
  std::vector<Progressive_mesh::Point> points;
  for(const Position& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  return Progressive_mesh(internal::make_corner_table(points.size(), corners), points);
}

// Collects quadrilaterals and triangles whose corners are given by position; equal positions are one vertex.
class Soup_builder
{
public:
  std::size_t vertex(const Position& p)
  {
    const auto it = m_vertices.emplace(p, soup.points.size());
    if(it.second)
      soup.points.push_back(p);
    return it.first->second;
  }

  void triangle(const Position& a, const Position& b, const Position& c)
  {
    soup.faces.push_back({{vertex(a), vertex(b), vertex(c)}});
  }

  // The quadrilateral a b c d, cut along a c, or along b d.
  void quad(const Position& a, const Position& b, const Position& c, const Position& d, bool other_diagonal = false)
  {
    if(other_diagonal)
    {
      triangle(a, b, d);
      triangle(b, c, d);
    }
    else
    {
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }

  Soup soup;

private:
  std::map<Position, std::size_t> m_vertices;
};

// The boundary of a set of unit cells of the integer grid, each square split by a diagonal; `scale` stretches the axes.
template <class Is_inside>
Soup voxels(const std::array<int, 3>& size, Is_inside is_inside, const Position& scale = {{1, 1, 1}})
{
  Soup_builder b;
  const auto inside = [&](int i, int j, int k) {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2] && is_inside(i, j, k);
  };
  const auto at = [&](int i, int j, int k) { return Position{{i * scale[0], j * scale[1], k * scale[2]}}; };
  for(int i = 0; i < size[0]; ++i)
    for(int j = 0; j < size[1]; ++j)
      for(int k = 0; k < size[2]; ++k)
      {
        if(!inside(i, j, k))
          continue;
        const bool d = (i + 2 * j + 3 * k) % 2 == 0;
        if(!inside(i + 1, j, k))
          b.quad(at(i + 1, j, k), at(i + 1, j + 1, k), at(i + 1, j + 1, k + 1), at(i + 1, j, k + 1), d);
        if(!inside(i - 1, j, k))
          b.quad(at(i, j, k), at(i, j, k + 1), at(i, j + 1, k + 1), at(i, j + 1, k), d);
        if(!inside(i, j + 1, k))
          b.quad(at(i, j + 1, k), at(i, j + 1, k + 1), at(i + 1, j + 1, k + 1), at(i + 1, j + 1, k), d);
        if(!inside(i, j - 1, k))
          b.quad(at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1), d);
        if(!inside(i, j, k + 1))
          b.quad(at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1), d);
        if(!inside(i, j, k - 1))
          b.quad(at(i, j, k), at(i, j + 1, k), at(i + 1, j + 1, k), at(i + 1, j, k), d);
      }
  return b.soup;
}

// A box of nx x ny x nz unit cells: every face is subdivided, and only the eight corners are not flat.
inline Soup box(int nx, int ny, int nz, const Position& scale = {{1, 1, 1}})
{
  return voxels(
      {{nx, ny, nz}}, [](int, int, int) { return true; }, scale);
}

// Two boxes of 3 x 3 cross-section joined by a square tube of side 1 that is `length` long. The one constriction is a
// square around the tube, of length 4.
inline Soup boxes_with_tube(int length)
{
  return voxels({{4 + length, 3, 3}},
                [length](int i, int j, int k) { return i < 2 || i >= 2 + length || (j == 1 && k == 1); });
}

// A frame of square cross-section around a hole: genus 1.
inline Soup square_ring()
{
  return voxels({{5, 5, 1}}, [](int i, int j, int) { return i == 0 || i == 4 || j == 0 || j == 4; });
}

inline Soup tetrahedron()
{
  return {{{{0, 0, 0}}, {{2, 0, 0}}, {{0, 3, 0}}, {{0, 0, 4}}}, {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}}};
}

inline Soup prism(int n, double height)
{
  Soup_builder b;
  const auto at = [&](int i, double z) {
    const double phi = 2 * CGAL_PI * (i % n) / n;
    return Position{{std::cos(phi), std::sin(phi), z}};
  };
  for(int i = 0; i < n; ++i)
    b.quad(at(i, 0), at(i + 1, 0), at(i + 1, height), at(i, height));
  for(int i = 1; i + 1 < n; ++i)
  {
    b.triangle(at(0, 0), at(i + 1, 0), at(i, 0));
    b.triangle(at(0, height), at(i, height), at(i + 1, height));
  }
  return b.soup;
}

// A surface of revolution about the z axis with caps, with seeded noise of the given size. The rings of the profile
// have radius and height; below the first and above the last one are the apexes `bottom` and `top`.
inline Soup revolution_of_profile(const std::vector<std::array<double, 2>>& profile, double bottom, double top,
                                  int around, double noise, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  const int along = static_cast<int>(profile.size()) - 1;
  Soup soup;
  for(int i = 0; i <= along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const double phi = 2 * CGAL_PI * (j + 0.5 * (i % 2)) / around;
      const double r = profile[static_cast<std::size_t>(i)][0] * (1 + uniform(random));
      const double z = profile[static_cast<std::size_t>(i)][1] * (1 + 1e-3 * uniform(random));
      soup.points.push_back({{r * std::cos(phi), r * std::sin(phi), z}});
    }
  const auto at = [around](int i, int j) { return static_cast<std::size_t>(i * around + (j + around) % around); };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const int shift = i % 2;
      soup.faces.push_back({{at(i, j), at(i, j + 1), at(i + 1, j + shift)}});
      soup.faces.push_back({{at(i, j + 1 - shift), at(i + 1, j + 1), at(i + 1, j)}});
    }
  const std::size_t first = soup.points.size(), last = first + 1;
  soup.points.push_back({{0, 0, bottom}});
  soup.points.push_back({{0, 0, top}});
  for(int j = 0; j < around; ++j)
  {
    soup.faces.push_back({{at(0, j + 1), at(0, j), first}});
    soup.faces.push_back({{at(along, j), at(along, j + 1), last}});
  }
  return soup;
}

// As above, with radius(s) for s in [0, 1].
template <class Radius>
Soup revolution(Radius radius, double height, int along, int around, double noise, unsigned seed)
{
  std::vector<std::array<double, 2>> profile;
  for(int i = 0; i <= along; ++i)
  {
    const double s = static_cast<double>(i) / along;
    profile.push_back({{radius(s), height * s}});
  }
  return revolution_of_profile(profile, -0.2, height + 0.2, around, noise, seed);
}

// A hollow bottle: a straight outer wall of radius 1.2, joined at the rim to an inner wall with a neck of radius 0.3 at
// the height 2, below it the belly and above it the mouth. Closed, of genus 0.
inline Soup bottle(double noise, unsigned seed, int around = 18)
{
  std::vector<std::array<double, 2>> profile;
  for(int i = 0; i <= 16; ++i)
    profile.push_back({{1.2, 0.2 * i}});
  for(int i = 15; i >= 2; --i)
  {
    const double z = 0.2 * i;
    profile.push_back({{1 - 0.7 * std::exp(-4 * (z - 2) * (z - 2)), z}});
  }
  return revolution_of_profile(profile, -0.2, 0.3, around, noise, seed);
}

// Necks of radius 0.3, 0.4, 0.5 and 0.6 at the heights 2, 4, 6 and 8, between bulges of radius 1.
inline Soup chain_of_necks(double noise, unsigned seed, int along = 60, int around = 20)
{
  const auto radius = [](double s) {
    const double place = 5 * s, neck = std::min(std::max(std::round(place), 1.0), 4.0);
    const double distance = std::abs(place - neck);
    return 1 - (0.8 - 0.1 * neck) * (distance < 0.5 ? 0.5 * (1 + std::cos(2 * CGAL_PI * distance)) : 0);
  };
  return revolution(radius, 10, along, around, noise, seed);
}

// One neck, of radius about 0.4, between two bulges of radius about 1.
inline Soup dumbbell(double noise, unsigned seed, int along = 24, int around = 18)
{
  return revolution([](double s) { return 0.7 - 0.3 * std::cos(4 * CGAL_PI * (s - 0.5)) + 1e-3 * s; }, 6, along, around,
                    noise, seed);
}

// The tube is thinner by the share `pinch` where it crosses the positive x axis, and thicker on the other side.
inline Soup torus(double noise, unsigned seed, int along = 30, int around = 14, double pinch = 0)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  Soup soup;
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const double u = 2 * CGAL_PI * i / along, v = 2 * CGAL_PI * j / around;
      const double r = 1 - pinch * std::cos(u) + uniform(random);
      soup.points.push_back(
          {{(3 + r * std::cos(v)) * std::cos(u), (3 + r * std::cos(v)) * std::sin(u), r * std::sin(v)}});
    }
  const auto at = [&](int i, int j) { return static_cast<std::size_t>((i % along) * around + j % around); };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      soup.faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      soup.faces.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return soup;
}

// A torus with holes of one face and more.
template <class Graph>
Graph torus_with_border()
{
  Graph graph = make_graph<Graph>(torus(0.2, 7));
  for(unsigned f = 0; f < 40; ++f)
    CGAL::Euler::remove_face(halfedge(typename Graph::Face_index(3 * f), graph), graph);
  return graph;
}

// An apex 0 in the middle of a fan of twelve faces whose angles add up to less than pi, closed by a cap. The vertices
// 1 ... 12 are the loop around the apex.
inline Soup sharp_cone()
{
  Soup soup;
  soup.points.push_back({{0, 0, 10}});
  for(int i = 0; i < 12; ++i)
    soup.points.push_back({{std::cos(CGAL_PI * i / 6), std::sin(CGAL_PI * i / 6), 0}});
  soup.points.push_back({{0, 0, -1}});
  for(std::size_t i = 0; i < 12; ++i)
  {
    const std::size_t a = 1 + i, b = 1 + (i + 1) % 12;
    soup.faces.push_back({{a, b, 0}});
    soup.faces.push_back({{b, a, 13}});
  }
  return soup;
}

// The same surface with each coordinate moved by at most `size`.
inline Soup jittered(Soup soup, double size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  for(Position& p : soup.points)
    for(double& x : p)
      x += uniform(random);
  return soup;
}

// A body of 2 x 2 x 2 unit cells with three arms of one cell's width that end in boxes: three necks, of length 4.
inline Soup branches(int cells_per_unit = 1)
{
  const int n = cells_per_unit;
  const auto is_inside = [n](int x, int y, int z) {
    const int i = x / n, j = y / n, k = z / n;
    const auto in = [&](int a, int b, int c, int width, int depth, int height) {
      return i >= a && i < a + width && j >= b && j < b + depth && k >= c && k < c + height;
    };
    return in(3, 3, 3, 2, 2, 2) || in(1, 4, 4, 2, 1, 1) || in(0, 3, 3, 1, 2, 2) || in(5, 3, 3, 2, 1, 1) ||
           in(7, 3, 3, 1, 2, 2) || in(4, 5, 3, 1, 2, 1) || in(3, 7, 3, 2, 1, 2);
  };
  return voxels({{8 * n, 8 * n, 5 * n}}, is_inside, {{1.0 / n, 1.0 / n, 1.0 / n}});
}

// A plate with two square holes: genus 2.
inline Soup two_holes()
{
  return voxels({{9, 4, 1}}, [](int i, int j, int) { return i == 0 || i == 4 || i == 8 || j == 0 || j == 3; });
}

// The same surface in another unit.
inline Soup scaled(Soup soup, double factor)
{
  for(Position& p : soup.points)
    for(double& x : p)
      x *= factor;
  return soup;
}

// The same surface with vertices and faces in another order.
inline Soup relabelled(const Soup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> place(soup.points.size());
  std::iota(place.begin(), place.end(), std::size_t(0));
  std::shuffle(place.begin(), place.end(), random);
  Soup result;
  result.points.resize(soup.points.size());
  for(std::size_t v = 0; v < place.size(); ++v)
    result.points[place[v]] = soup.points[v];
  for(const Triangle& t : soup.faces)
  {
    Triangle u = {{place[t[0]], place[t[1]], place[t[2]]}};
    std::rotate(u.begin(), u.begin() + static_cast<int>(random() % 3), u.end());
    result.faces.push_back(u);
  }
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  return result;
}

inline Soup joined(const Soup& a, const Soup& b, double shift)
{
  Soup result = a;
  for(Position p : b.points)
  {
    p[0] += shift;
    result.points.push_back(p);
  }
  for(const Triangle& t : b.faces)
    result.faces.push_back({{t[0] + a.points.size(), t[1] + a.points.size(), t[2] + a.points.size()}});
  return result;
}

inline Soup inside_out(Soup soup)
{
  for(Triangle& t : soup.faces)
    std::swap(t[1], t[2]);
  return soup;
}

} // namespace test_meshes

#endif // TEST_MESHES_H
