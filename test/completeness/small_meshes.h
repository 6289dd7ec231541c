// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SMALL_MESHES_H
#define SMALL_MESHES_H

// Seeded random closed meshes of at most 300 faces.

#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace small_meshes {

using seeded_random::Random;
using test_meshes::Mesh;
using test_meshes::Position;
using test_meshes::Soup;

const std::size_t most_faces = 300;

inline Soup jittered(Soup soup, double size, Random& random)
{
  for(Position& p : soup.points)
    for(double& x : p)
      x += random.real(-size, size);
  return soup;
}

// The convex hull, its vertices and faces in the order of the points: that of CGAL depends on addresses.
inline Soup hull(const std::vector<Position>& points)
{
  std::vector<test_meshes::Kernel::Point_3> p;
  for(const Position& q : points)
    p.emplace_back(q[0], q[1], q[2]);
  Mesh mesh;
  CGAL::convex_hull_3(p.begin(), p.end(), mesh);
  const auto position = [&](Mesh::Vertex_index v) {
    return Position{{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}};
  };
  std::set<Position> is_vertex;
  for(auto v : mesh.vertices())
    is_vertex.insert(position(v));
  std::map<Position, std::size_t> number;
  Soup soup;
  for(const Position& q : points)
    if(is_vertex.count(q) > 0 && number.emplace(q, soup.points.size()).second)
      soup.points.push_back(q);
  for(auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    test_meshes::Triangle t = {{number.at(position(mesh.source(h))), number.at(position(mesh.target(h))),
                                number.at(position(mesh.target(mesh.next(h))))}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    soup.faces.push_back(t);
  }
  std::sort(soup.faces.begin(), soup.faces.end());
  return soup;
}

inline Position random_point(Random& random) { return {{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}}; }

// Random points on a sphere, triangulated as their hull and then moved along their rays.
inline Mesh noisy_sphere(Random& random)
{
  std::vector<Position> points;
  for(int n = 40 + random.integer(112); n > 0;)
  {
    Position p = random_point(random);
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    if(r < 0.1 || r > 1)
      continue;
    for(double& x : p)
      x /= r;
    points.push_back(p);
    --n;
  }
  Soup result = hull(points);
  const double noise = random.real(0.1, 0.5);
  for(Position& p : result.points)
  {
    const double share = 1 - random.real(0, noise);
    for(double& x : p)
      x *= share;
  }
  return test_meshes::make_mesh(result);
}

// A random polytope each vertex of which is pressed towards the middle.
inline Mesh dented_hull(Random& random)
{
  std::vector<Position> points;
  for(int n = 60 + random.integer(400); n > 0; --n)
  {
    Position p = random_point(random);
    p[2] *= 2;
    points.push_back(p);
  }
  Soup result = hull(points);
  for(Position& p : result.points)
  {
    const double share = random.integer(3) == 0 ? random.real(0.2, 0.7) : 1;
    for(double& x : p)
      x *= share;
  }
  return test_meshes::make_mesh(result);
}

inline bool is_small_mesh(const Soup& soup)
{
  return soup.faces.size() <= most_faces && CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.faces);
}

inline Position random_scale(Random& random) { return {{1, random.real(0.6, 1.8), random.real(0.6, 1.8)}}; }

// Boxes glued to each other one after the other, each at a side of one that is there.
inline Mesh glued_boxes(Random& random)
{
  const int size = 7;
  for(;;)
  {
    std::array<bool, size* size* size> is_inside = {};
    const auto cell = [&](int i, int j, int k) -> bool& {
      return is_inside[static_cast<std::size_t>((i * size + j) * size + k)];
    };
    std::array<int, 3> at = {{3, 3, 3}};
    for(int boxes = 3 + random.integer(6); boxes > 0; --boxes)
    {
      std::array<int, 3> extent;
      for(int& e : extent)
        e = 1 + random.integer(3) / 2 + random.integer(2);
      for(int i = at[0]; i < at[0] + extent[0] && i < size; ++i)
        for(int j = at[1]; j < at[1] + extent[1] && j < size; ++j)
          for(int k = at[2]; k < at[2] + extent[2] && k < size; ++k)
            cell(i, j, k) = true;
      do
      {
        for(int& x : at)
          x = random.integer(size);
      } while(!cell(at[0], at[1], at[2]));
      int& x = at[static_cast<std::size_t>(random.integer(3))];
      x = (std::max)(0, x - random.integer(3));
    }
    const Soup soup = test_meshes::voxels(
        {{size, size, size}}, [&](int i, int j, int k) { return cell(i, j, k); }, random_scale(random));
    if(soup.faces.size() >= 60 && is_small_mesh(soup))
      return test_meshes::make_mesh(jittered(soup, random.integer(4) == 0 ? 0 : 0.15, random));
  }
}

// A plate with up to the given number of square holes, some of which may have become one.
inline Mesh drilled_plate(int most_holes, Random& random)
{
  const int width = 5 + random.integer(4), depth = 3 + random.integer(4);
  for(;;)
  {
    std::array<bool, 100> is_hole = {};
    for(int holes = 1 + random.integer(most_holes); holes > 0; --holes)
      is_hole[static_cast<std::size_t>((1 + random.integer(width - 2)) * 10 + 1 + random.integer(depth - 2))] = true;
    const Soup soup = test_meshes::voxels(
        {{width, depth, 1}}, [&](int i, int j, int) { return !is_hole[static_cast<std::size_t>(i * 10 + j)]; },
        random_scale(random));
    if(is_small_mesh(soup))
      return test_meshes::make_mesh(jittered(soup, random.integer(4) == 0 ? 0 : 0.15, random));
  }
}

inline Mesh plate_with_few_holes(Random& random) { return drilled_plate(2, random); }
inline Mesh plate_with_many_holes(Random& random) { return drilled_plate(6, random); }

inline Mesh torus(Random& random)
{
  const int around = 5 + random.integer(6), along = 150 / around - random.integer(4);
  const double radius = random.real(1.5, 4), noise = random.real(0.05, 0.3);
  Soup soup;
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const double u = 2 * CGAL_PI * i / along, v = 2 * CGAL_PI * j / around, r = 1 + random.real(-noise, noise);
      soup.points.push_back(
          {{(radius + r * std::cos(v)) * std::cos(u), (radius + r * std::cos(v)) * std::sin(u), r * std::sin(v)}});
    }
  const auto at = [&](int i, int j) { return static_cast<std::size_t>((i % along) * around + j % around); };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      soup.faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      soup.faces.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return test_meshes::make_mesh(soup);
}

// A surface of revolution of a random profile, with noise.
inline Mesh revolution(Random& random)
{
  const int around = 5 + random.integer(6), along = 140 / around - random.integer(4);
  double radius = 1;
  std::vector<std::array<double, 2>> profile;
  for(int i = 0; i <= along; ++i)
  {
    radius = (std::min)(1.5, (std::max)(0.3, radius * random.real(0.6, 1.6)));
    profile.push_back({{radius, 0.4 * i}});
  }
  Soup soup = test_meshes::revolution_of_profile(profile, -0.2, 0.4 * along + 0.2, around, 0, 0);
  return test_meshes::make_mesh(jittered(soup, random.real(0, 0.15), random));
}

} // namespace small_meshes

#endif // SMALL_MESHES_H
