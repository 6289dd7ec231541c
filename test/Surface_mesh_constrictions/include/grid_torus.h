// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GRID_TORUS_H
#define GRID_TORUS_H

// Curves of known kind on a torus whose faces are halves of the squares of a grid.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace grid_torus {

template <class Mesh>
class Grid_torus
{
public:
  typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Curve;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor Vertex;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;

  // Squares along and around.
  Grid_torus(int along, int around)
    : mesh(test_meshes::make_graph<Mesh>(test_meshes::torus(0, 1, along, around))), m_along(along), m_around(around),
      m_vertices(vertices(mesh).begin(), vertices(mesh).end())
  {}

  Vertex vertex(int i, int j) const
  {
    return m_vertices[static_cast<std::size_t>((i % m_along) * m_around + j % m_around)];
  }

  // along edges
  Curve path(const std::vector<std::array<int, 2>>& grid_points,
             double prominence = std::numeric_limits<double>::quiet_NaN()) const
  {
    typename Curve::Data data;
    data.prominence = prominence;
    for(const auto& p : grid_points)
      data.locations.push_back({true, vertex(p[0], p[1]), Halfedge(), 0});
    return Curve(data);
  }

  // around the tube, and around the hole
  Curve meridian(int i, double prominence = std::numeric_limits<double>::quiet_NaN()) const
  {
    std::vector<std::array<int, 2>> points;
    for(int j = 0; j < m_around; ++j)
      points.push_back({{i, j}});
    return path(points, prominence);
  }
  Curve equator(int j, double prominence = std::numeric_limits<double>::quiet_NaN()) const
  {
    std::vector<std::array<int, 2>> points;
    for(int i = 0; i < m_along; ++i)
      points.push_back({{i, j}});
    return path(points, prominence);
  }

  // The straight line, in the plane of the grid, that starts at (x, 0) and winds p times around the hole and q times
  // around the tube. p and q have no common divisor, and the line passes through no vertex. With a round parameter all
  // parameters are this.
  Curve line(double x, int p, int q, double round_parameter = -1) const
  {
    const double dx = p * m_along, dy = q * m_around;
    std::vector<double> times;
    for(int k = 0; k < q * m_around; ++k)
      times.push_back(k / dy);
    for(int k = 1; k <= p * m_along; ++k)
      times.push_back((k - x) / dx);
    const double shear = dx - dy; // diagonals are where the difference of the coordinates is an integer
    for(double k = std::floor((std::min)(x, x + shear)); k <= (std::max)(x, x + shear); ++k)
      if(shear != 0 && (k - x) / shear > 0 && (k - x) / shear < 1)
        times.push_back((k - x) / shear);
    std::sort(times.begin(), times.end());

    typename Curve::Data data;
    for(std::size_t i = 0; i < times.size(); ++i)
    {
      const double before = i == 0 ? times.back() - 1 : times[i - 1];
      const double t = times[i], u = x + dx * t + 1e-9, v = dy * t + 1e-9;
      const double mx = x + dx * (t + before) / 2 + m_along, my = dy * (t + before) / 2 + m_around;
      const int a = static_cast<int>(mx), b = static_cast<int>(my); // the square that the line comes from
      const bool is_lower = mx - a > my - b;
      const std::array<Vertex, 3> face = {{vertex(a, b), is_lower ? vertex(a + 1, b) : vertex(a + 1, b + 1),
                                           is_lower ? vertex(a + 1, b + 1) : vertex(a, b + 1)}};
      // which of its sides: the one on whose line the point is
      const std::array<double, 2> f = {{u + m_along - a, v + m_around - b}};
      const double low = std::abs(f[1]), high = std::abs(f[1] - 1), left = std::abs(f[0]), right = std::abs(f[0] - 1),
                   diagonal = std::abs(f[0] - f[1]);
      int side = 0;
      double parameter = 0;
      if(is_lower)
      {
        side = diagonal < low && diagonal < right ? 2 : low < right ? 0 : 1;
        parameter = side == 0 ? f[0] : side == 1 ? f[1] : 1 - f[0];
      }
      else
      {
        side = diagonal < high && diagonal < left ? 0 : high < left ? 1 : 2;
        parameter = side == 0 ? f[0] : side == 1 ? 1 - f[0] : 1 - f[1];
      }
      const Halfedge h = halfedge(face[side], face[(side + 1) % 3], mesh).first;
      data.locations.push_back({false, Vertex(), h, round_parameter >= 0 ? round_parameter : parameter});
    }
    return Curve(data);
  }

  Mesh mesh;

private:
  int m_along, m_around;
  std::vector<Vertex> m_vertices;
};

} // namespace grid_torus

#endif // GRID_TORUS_H
