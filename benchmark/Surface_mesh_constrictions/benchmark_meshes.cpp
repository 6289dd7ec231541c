// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmark_meshes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_utils.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace benchmark_meshes {

namespace {

typedef Mesh::Vertex_index Vertex;

// A number of about the given size that is as good as random, the same for the same arguments.
double wobble(int i, int j, double size) { return size * std::sin(37.0 * i + 91.0 * j + 0.1 * i * j); }

// The profile of a mushroom, radius and height in its cell of size 2, from the ground at its foot (0) to the top (1).
std::array<double, 2> mushroom(double s)
{
  static const std::array<std::array<double, 3>, 7> corners = {{{{0, 0.95, 0}},
                                                                {{0.25, 0.45, 0.05}},
                                                                {{0.4, 0.3, 0.35}},
                                                                {{0.55, 0.3, 0.7}},
                                                                {{0.7, 0.75, 0.85}},
                                                                {{0.85, 0.5, 1.25}},
                                                                {{1, 0, 1.4}}}};
  std::size_t i = 1;
  while(i + 1 < corners.size() && corners[i][0] < s)
    ++i;
  const double t = (s - corners[i - 1][0]) / (corners[i][0] - corners[i - 1][0]);
  return {{(1 - t) * corners[i - 1][1] + t * corners[i][1], (1 - t) * corners[i - 1][2] + t * corners[i][2]}};
}

} // namespace

Mesh chain_of_necks(int faces, int necks)
{
  const int around = static_cast<int>(std::lround(std::sqrt(faces / 8.0))), along = faces / (2 * around);
  Mesh mesh;
  std::vector<Vertex> vertices;
  for(int i = 0; i <= along; ++i)
  {
    const double s = (i + 0.5) / (along + 1), wave = std::cos(2 * (necks + 1) * CGAL_PI * s);
    const double radius = std::sqrt(std::sin(CGAL_PI * s)) * (1 + 0.6 * (necks == 1 ? -wave : wave));
    for(int j = 0; j < around; ++j)
    {
      const double noise = wobble(i, j, 1e-3), phi = 2 * CGAL_PI * (j + 0.5 * (i % 2)) / around;
      vertices.push_back(mesh.add_vertex(
          Kernel::Point_3((1 + noise) * radius * std::cos(phi), (1 + noise) * radius * std::sin(phi), 12 * s)));
    }
  }
  const auto at = [&](int i, int j) { return vertices[static_cast<std::size_t>(i * around + j % around)]; };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const int shift = i % 2;
      mesh.add_face(at(i, j), at(i, j + 1), at(i + 1, j + shift));
      mesh.add_face(at(i, j + 1 - shift), at(i + 1, j + 1), at(i + 1, j));
    }
  const Vertex bottom = mesh.add_vertex(Kernel::Point_3(0, 0, -0.05)),
               top = mesh.add_vertex(Kernel::Point_3(0, 0, 12.05));
  for(int j = 0; j < around; ++j)
  {
    mesh.add_face(at(0, j + 1), at(0, j), bottom);
    mesh.add_face(at(along, j), at(along, j + 1), top);
  }
  return mesh;
}

Mesh bed_of_mushrooms(int faces, int mushrooms)
{
  const int cells = (std::max)(1, static_cast<int>(std::lround(std::sqrt(mushrooms / 2.0))));
  const int steps = (std::max)(8, static_cast<int>(std::lround(std::sqrt(faces / 4.0) / cells))); // of a cell
  const int n = cells * steps;
  Mesh mesh;
  // two sheets of (n + 1) x (n + 1) vertices, which share those at their border
  std::array<std::vector<Vertex>, 2> sheets;
  for(std::size_t side = 0; side < 2; ++side)
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j)
      {
        const bool is_border = i == 0 || j == 0 || i == n || j == n;
        if(side == 1 && is_border)
        {
          sheets[1].push_back(sheets[0][sheets[1].size()]);
          continue;
        }
        const double u = 2.0 * (i % steps) / steps - 1, v = 2.0 * (j % steps) / steps - 1; // in the cell
        const double r = std::hypot(u, v);
        double x = 2.0 * i / steps, y = 2.0 * j / steps, z = is_border ? 0 : 0.2;
        if(r < 0.95)
        {
          const std::array<double, 2> p = mushroom(1 - r / 0.95);
          x += r > 0 ? u * (p[0] / r - 1) : 0;
          y += r > 0 ? v * (p[0] / r - 1) : 0;
          z += p[1];
        }
        const int seed = side == 0 ? 0 : 7919;
        sheets[side].push_back(mesh.add_vertex(
            Kernel::Point_3(x + wobble(i, j + seed, 1e-3), y + wobble(j + seed, i, 1e-3), (side == 0 ? 1 : -1) * z)));
      }
  for(std::size_t side = 0; side < 2; ++side)
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
      {
        const auto at = [&](int a, int b) { return sheets[side][static_cast<std::size_t>((i + a) * (n + 1) + j + b)]; };
        // corners of the sheets are cut off by a diagonal between the two sheets' own vertices
        const bool is_turned = (i == 0 && j == n - 1) || (i == n - 1 && j == 0) ? false : (i + j) % 2 == 1;
        const bool diagonal = (i == 0 && j == 0) || (i == n - 1 && j == n - 1) || is_turned;
        std::array<std::array<Vertex, 3>, 2> triangles;
        if(diagonal)
          triangles = {{{{at(0, 0), at(1, 0), at(1, 1)}}, {{at(0, 0), at(1, 1), at(0, 1)}}}};
        else
          triangles = {{{{at(0, 0), at(1, 0), at(0, 1)}}, {{at(1, 0), at(1, 1), at(0, 1)}}}};
        for(const std::array<Vertex, 3>& t : triangles)
          side == 0 ? mesh.add_face(t[0], t[1], t[2]) : mesh.add_face(t[0], t[2], t[1]);
      }
  return mesh;
}

Mesh flat_boxes(int faces)
{
  typedef std::array<int, 3> Position; // of a cube, or of a vertex: its coordinates
  const auto is_cube = [](const Position& c) {
    const bool is_bar = c[0] == 3 || c[0] == 4;
    const int least = is_bar ? 1 : 0, greatest = is_bar ? 1 : 2;
    return c[0] >= 0 && c[0] <= 7 && c[1] >= least && c[1] <= greatest && c[2] >= least && c[2] <= greatest;
  };
  constexpr int squares = 114; // of cubes, at the surface
  const int n = (std::max)(1, static_cast<int>(std::lround(std::sqrt(faces / (2.0 * squares)))));
  Mesh mesh;
  std::map<Position, Vertex> vertices;
  const auto vertex_at = [&](const Position& p) {
    const auto found = vertices.emplace(p, Vertex());
    if(found.second)
      found.first->second = mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
    return found.first->second;
  };
  // The square of a cube on one of its sides. Directions u and v, in this order, turn around its normal.
  const auto add_square = [&](const Position& cube, std::size_t axis, bool is_upper) {
    const std::size_t u = (axis + (is_upper ? 1 : 2)) % 3, v = (axis + (is_upper ? 2 : 1)) % 3;
    const auto at = [&](int a, int b) {
      Position p = {{n * cube[0], n * cube[1], n * cube[2]}};
      p[axis] += is_upper ? n : 0;
      p[u] += a;
      p[v] += b;
      return vertex_at(p);
    };
    for(int a = 0; a < n; ++a)
      for(int b = 0; b < n; ++b)
      {
        const Vertex p = at(a, b), q = at(a + 1, b), r = at(a + 1, b + 1), s = at(a, b + 1);
        const bool is_from_p = (a + b) % 2 == 1; // the diagonal
        mesh.add_face(p, q, is_from_p ? r : s);
        mesh.add_face(is_from_p ? p : q, r, s);
      }
  };
  for(int x = 0; x < 8; ++x)
    for(int y = 0; y < 3; ++y)
      for(int z = 0; z < 3; ++z)
        for(std::size_t axis = 0; axis < 3; ++axis)
          for(const bool is_upper : {false, true})
          {
            const Position cube = {{x, y, z}};
            Position neighbour = cube;
            neighbour[axis] += is_upper ? 1 : -1;
            if(is_cube(cube) && !is_cube(neighbour))
              add_square(cube, axis, is_upper);
          }
  return mesh;
}

Mesh subdivided(const std::string& file, int subdivisions)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    return Mesh();
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  mesh.collect_garbage();
  return mesh;
}

} // namespace benchmark_meshes
