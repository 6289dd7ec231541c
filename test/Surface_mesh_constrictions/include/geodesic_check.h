// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_CHECK_H
#define GEODESIC_CHECK_H

// Checks constrictions from their locations and the mesh's points alone, with none of the package's own geometry.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace geodesic_check {

typedef std::complex<double> Complex;

// Corner c of a triangle a b c in the plane, when a and b are there, c on the left of a -> b.
template <class Point>
Complex unfold(const Point& a, const Point& b, const Point& c, Complex za, Complex zb)
{
  const auto u = b - a, v = c - a;
  const double uu = u * u, uv = u * v, vv = v * v;
  return za + (zb - za) * Complex(uv, std::sqrt(std::max(0.0, uu * vv - uv * uv))) / uu;
}

// The curve is as long as its points say and passes no vertex twice. Both side angles of a pivot are at least pi and
// add up to its total angle, and between two pivots the crossings lie on a straight line in the unfolding.
template <class Mesh>
void expect_closed_geodesic(const Mesh& mesh, const CGAL::Surface_mesh_constrictions::Constriction<Mesh>& c,
                            double tolerance = 1e-9)
{
  typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
  typedef typename Constriction::halfedge_descriptor Halfedge;
  const auto vpm = get(CGAL::vertex_point, mesh);
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point;
  const auto point = [&](auto v) -> const Point& { return get(vpm, v); };

  std::vector<Point> points;
  c.points(mesh, std::back_inserter(points));
  double length = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
  EXPECT_NEAR(length, c.length(), 1e-12 * length);

  ASSERT_FALSE(c.pivots().empty());
  std::set<typename Constriction::vertex_descriptor> seen;
  for(const auto& pivot : c.pivots())
  {
    EXPECT_TRUE(seen.insert(pivot.vertex).second) << "touches itself";
    EXPECT_GE(pivot.left_angle, CGAL_PI - tolerance);
    EXPECT_GE(pivot.right_angle, CGAL_PI - tolerance);
    double total = 0;
    for(Halfedge h : CGAL::halfedges_around_target(pivot.vertex, mesh))
      if(CGAL::is_border(h, mesh))
        total = std::numeric_limits<double>::infinity();
    if(std::isinf(total))
    {
      EXPECT_NE(std::isinf(pivot.left_angle), std::isinf(pivot.right_angle)) << "the hole is on one side";
      continue;
    }
    for(Halfedge h : CGAL::halfedges_around_target(pivot.vertex, mesh))
      total +=
          CGAL::approximate_angle(point(source(h, mesh)), point(pivot.vertex), point(target(next(h, mesh), mesh))) *
          CGAL_PI / 180;
    EXPECT_NEAR(pivot.left_angle + pivot.right_angle, total, 1e-9);
  }

  // each strip between two pivots
  const auto& locations = c.locations();
  const std::size_t n = locations.size();
  for(const auto& pivot : c.pivots())
  {
    std::vector<Complex> crossings;
    std::size_t i = (pivot.location + 1) % n;
    if(locations[i].is_pivot)
      continue; // along an edge
    Halfedge h = locations[i].halfedge;
    ASSERT_EQ(target(next(h, mesh), mesh), pivot.vertex);
    Complex za = 0, zb = std::sqrt(CGAL::squared_distance(point(source(h, mesh)), point(target(h, mesh))));
    const Complex start = unfold(point(source(h, mesh)), point(target(h, mesh)), point(pivot.vertex), za, zb);
    for(;;)
    {
      crossings.push_back(za + locations[i].parameter * (zb - za));
      const Halfedge o = opposite(h, mesh);
      const Complex apex =
          unfold(point(source(o, mesh)), point(target(o, mesh)), point(target(next(o, mesh), mesh)), zb, za);
      i = (i + 1) % n;
      if(locations[i].is_pivot)
      {
        ASSERT_EQ(locations[i].vertex, target(next(o, mesh), mesh));
        crossings.push_back(apex);
        break;
      }
      h = locations[i].halfedge;
      if(h == next(o, mesh))
        zb = apex;
      else
      {
        ASSERT_EQ(h, next(next(o, mesh), mesh));
        za = apex;
      }
    }
    const Complex d = crossings.back() - start;
    for(const Complex& z : crossings)
      EXPECT_LE(std::abs(std::imag((z - start) * std::conj(d))) / std::abs(d), tolerance * c.length());
  }
}

} // namespace geodesic_check

#endif // GEODESIC_CHECK_H
