// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_TRIANGULATE_POLYGON_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_TRIANGULATE_POLYGON_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef std::array<std::size_t, 3> Polygon_triangle; // places in the polygon, in its order of running round

typedef Exact_predicates_inexact_constructions_kernel::Point_3 Polygon_point;
typedef Exact_predicates_inexact_constructions_kernel::Vector_3 Polygon_vector;

// The exponent of the power of two that is greater than all coordinates of points or vectors, and at most twice as great
// as the largest.
template <class Coordinates>
int exponent_of_largest(const std::vector<Coordinates>& all)
{
  double largest = 0;
  for(const Coordinates& c : all)
    largest = (std::max)({largest, std::abs(c.x()), std::abs(c.y()), std::abs(c.z())});
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

// A point or vector times a power of two: nothing is rounded, but for coordinates that are nearly zero beside others.
template <class Coordinates>
Coordinates scaled(const Coordinates& c, int exponent)
{
  return Coordinates(std::ldexp(c.x(), exponent), std::ldexp(c.y(), exponent), std::ldexp(c.z(), exponent));
}

// Of a polygon that need not be plane: the sum of the cross products of its edges.
inline Polygon_vector polygon_normal(const std::vector<Polygon_point>& points)
{
  Polygon_vector sum(0, 0, 0);
  for(std::size_t i = 1; i + 1 < points.size(); ++i)
    sum = sum + cross_product(points[i] - points[0], points[i + 1] - points[0]);
  return sum;
}

// The constrained Delaunay triangulation of a polygon in its projection along the normal. Nothing if the polygon crosses
// or touches itself there, or if its normal is zero or too large for a double.
//
// CGAL's `triangulate_face()` does the same in release 5.5, but tells whether a polygon crosses itself by the number of
// vertices of its triangulation. This number is right by chance where as many corners fall on others as edges cross;
// then it reads outside of its mesh.
inline std::vector<Polygon_triangle> delaunay_triangulation(const std::vector<Polygon_point>& points)
{
  typedef Projection_traits_3<Exact_predicates_inexact_constructions_kernel> Traits;
  typedef Triangulation_data_structure_2<
      Triangulation_vertex_base_with_info_2<std::size_t, Traits>,
      Constrained_triangulation_face_base_2<Traits, Triangulation_face_base_with_info_2<bool, Traits>>>
      Data_structure;
  typedef Constrained_Delaunay_triangulation_2<Traits, Data_structure, No_constraint_intersection_tag> Triangulation;

  std::vector<Polygon_triangle> result;
  const Polygon_vector normal = polygon_normal(points);
  if(normal == Polygon_vector(0, 0, 0) || !std::isfinite(normal.x()) || !std::isfinite(normal.y()) ||
     !std::isfinite(normal.z()))
    return result;
  const std::size_t n = points.size();
  // CGAL multiplies the normal by itself, and an exact number that is made of the infinite one ends the program
  Triangulation triangulation{Traits(scaled(normal, -exponent_of_largest(std::vector<Polygon_vector>{normal})))};
  std::vector<typename Triangulation::Vertex_handle> corners;
  try
  {
    for(std::size_t i = 0; i < n; ++i)
    {
      corners.push_back(triangulation.insert(points[i]));
      if(triangulation.number_of_vertices() != i + 1)
        return result;
      corners[i]->info() = i;
      if(i > 0)
        triangulation.insert_constraint(corners[i - 1], corners[i]);
    }
    triangulation.insert_constraint(corners[n - 1], corners[0]);
  }
  catch(const typename Triangulation::Intersection_of_constraints_exception&)
  {
    return result;
  }
  if(triangulation.dimension() != 2)
    return result;

  for(auto f : triangulation.all_face_handles())
    f->info() = false; // whether it is known to be outside
  std::vector<typename Triangulation::Face_handle> outside = {triangulation.infinite_face()};
  outside.back()->info() = true;
  while(!outside.empty())
  {
    const auto f = outside.back();
    outside.pop_back();
    for(int i = 0; i < 3; ++i)
    {
      const auto neighbour = f->neighbor(i);
      if(neighbour->info() || f->is_constrained(i))
        continue;
      neighbour->info() = true;
      outside.push_back(neighbour);
    }
  }
  for(auto f : triangulation.finite_face_handles())
    if(!f->info())
      result.push_back({{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}});
  return result.size() == n - 2 ? result : std::vector<Polygon_triangle>();
}

// Cuts off ears: corners whose diagonal is allowed, lies inside in the projection along the normal, and has no other
// corner in its triangle; of these the one of the best shape. Where there is none the best of the rest is cut off, so
// the result is a triangulation in any case. Cubic at worst.
template <class IsAllowed>
std::vector<Polygon_triangle> cut_off_ears(const std::vector<Polygon_point>& points, IsAllowed is_allowed)
{
  const Polygon_vector normal = polygon_normal(points);
  std::vector<std::size_t> left(points.size());
  for(std::size_t i = 0; i < left.size(); ++i)
    left[i] = i;
  const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
    return cross_product(points[b] - points[a], points[c] - points[a]) * normal;
  };
  const auto shape = [&](std::size_t a, std::size_t b, std::size_t c) {
    const double edges = squared_distance(points[a], points[b]) + squared_distance(points[b], points[c]) +
                         squared_distance(points[c], points[a]);
    const Polygon_vector area = cross_product(points[b] - points[a], points[c] - points[a]);
    return edges > 0 ? std::sqrt(area.squared_length()) / edges : 0.;
  };
  std::vector<Polygon_triangle> result;
  while(left.size() > 3)
  {
    const std::size_t n = left.size();
    std::size_t best = 0;
    double best_rank = -std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      const double turn = side(a, b, c);
      bool is_ear = turn > 0;
      for(std::size_t j = 0; j < n && is_ear; ++j)
      {
        const std::size_t p = left[j];
        const bool is_corner = points[p] == points[a] || points[p] == points[b] || points[p] == points[c];
        is_ear = is_corner || !(side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0);
      }
      // shapes are at most 1 / (4 sqrt 3)
      const double rank = shape(a, b, c) + (is_allowed(a, c) ? 4 : 0) + (is_ear ? 2 : turn >= 0 ? 1 : 0);
      if(rank > best_rank)
      {
        best_rank = rank;
        best = i;
      }
    }
    result.push_back({{left[(best + n - 1) % n], left[best], left[(best + 1) % n]}});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  result.push_back({{left[0], left[1], left[2]}});
  return result;
}

// Cuts a polygon, plane or not, convex or not, into n - 2 triangles without new points. `is_allowed(i, j)` tells
// whether points i and j may be joined by a diagonal: two edges between the same two vertices are no mesh. A diagonal
// that is not allowed is used only if no way is found without. Quadrangles are cut by the rule of CGAL's
// `triangulate_face()`, and other polygons by a constrained Delaunay triangulation; where there is none, or it needs a
// diagonal that is not allowed, ears are cut off. The unit of length does not matter, as products of coordinates
// neither overflow nor vanish.
template <class IsAllowed>
std::vector<Polygon_triangle> triangulate_polygon(const std::vector<Polygon_point>& polygon, IsAllowed is_allowed)
{
  const std::size_t n = polygon.size();
  if(n == 3)
    return {{{0, 1, 2}}};
  const int exponent = exponent_of_largest(polygon);
  std::vector<Polygon_point> points;
  for(const Polygon_point& p : polygon)
    points.push_back(scaled(p, -exponent));
  if(n == 4)
  {
    const auto& p = points;
    // triangles in one direction, of large area
    const double cut_13 = cross_product(p[2] - p[1], p[3] - p[2]) * cross_product(p[0] - p[3], p[1] - p[0]);
    const double cut_02 = cross_product(p[1] - p[0], p[1] - p[2]) * cross_product(p[3] - p[2], p[3] - p[0]);
    const bool prefers_02 = cut_02 > cut_13;
    if(is_allowed(0, 2) && (prefers_02 || !is_allowed(1, 3)))
      return {{{0, 1, 2}}, {{0, 2, 3}}};
    if(is_allowed(1, 3) || !prefers_02)
      return {{{1, 2, 3}}, {{1, 3, 0}}};
    return {{{0, 1, 2}}, {{0, 2, 3}}};
  }

  const auto number_of_refused = [&](const std::vector<Polygon_triangle>& triangles) {
    std::size_t result = 0;
    for(const Polygon_triangle& t : triangles)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t a = t[i], b = t[(i + 1) % 3];
        const bool is_side = (a + 1) % n == b || (b + 1) % n == a;
        result += !is_side && !is_allowed(a, b);
      }
    return result;
  };
  std::vector<Polygon_triangle> result = delaunay_triangulation(points);
  const std::size_t refused = number_of_refused(result);
  if(!result.empty() && refused == 0)
    return result;
  std::vector<Polygon_triangle> ears = cut_off_ears(points, is_allowed);
  return result.empty() || number_of_refused(ears) < refused ? ears : result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_TRIANGULATE_POLYGON_H
