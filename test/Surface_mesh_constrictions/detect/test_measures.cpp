// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/measure_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace test_measures {

namespace SMC = CGAL::Surface_mesh_constrictions;
using detection::detect;
using real_meshes::read;
using test_meshes::Mesh;
typedef std::array<double, 3> Triple;
typedef SMC::Constriction<Mesh> Constriction;
typedef test_meshes::Kernel::Vector_3 Vector;

Vector as_vector(const Triple& t) { return Vector(t[0], t[1], t[2]); }

void expect_near(const Triple& a, const Triple& b, double tolerance)
{
  for(std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(Measures, OfTheSquareNeckBetweenTwoBoxes)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(2));
  const std::vector<Constriction> found = detect(mesh);
  ASSERT_EQ(found.size(), 1u);
  const Constriction& c = found[0];
  EXPECT_NEAR(c.length(), 4, 1e-12);
  EXPECT_DOUBLE_EQ(c.diameter(), c.length() / std::acos(-1.));
  EXPECT_NEAR(c.roundness(), std::atan(1.), 1e-12);
  EXPECT_NEAR(c.centroid()[1], 1.5, 1e-12);
  EXPECT_NEAR(c.centroid()[2], 1.5, 1e-12);
  EXPECT_GE(c.centroid()[0], 2);
  EXPECT_LE(c.centroid()[0], 4);
  expect_near(c.normal(), {{c.normal()[0] > 0 ? 1. : -1., 0, 0}}, 1e-12);
}

// From the points that a user gets: many steps along the curve, each counted alike.
TEST(Measures, OfRealCurvesFromManySteps)
{
  for(const char* name : {"cactus.off", "eight.off", "homer.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = read(name);
    for(const Constriction& c : detect(mesh, SMC::parameters::certify(false)))
    {
      std::vector<Mesh::Point> points;
      c.points(mesh, std::back_inserter(points));
      const double step = c.length() / 20000;
      Vector sum(0, 0, 0), area(0, 0, 0);
      std::size_t steps = 0;
      double rest = 0; // to the next step, from the end of the last segment
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        const Mesh::Point &p = points[i], &q = points[(i + 1) % points.size()];
        const double length = std::sqrt(CGAL::squared_distance(p, q));
        double at = rest;
        for(; at < length; at += step, ++steps)
          sum = sum + (p + at / length * (q - p) - CGAL::ORIGIN);
        rest = at - length;
        area = area + CGAL::cross_product(p - points[0], q - points[0]) / 2;
      }
      const Vector centroid = sum / static_cast<double>(steps);
      EXPECT_NEAR(std::sqrt((centroid - as_vector(c.centroid())).squared_length()), 0, 1e-3 * c.length());
      const double size = std::sqrt(area.squared_length());
      EXPECT_NEAR(std::sqrt((area / size - as_vector(c.normal())).squared_length()), 0, 1e-9);
      EXPECT_NEAR(4 * CGAL_PI * size / (c.length() * c.length()), c.roundness(), 1e-9);
    }
  }
}

// Far from the origin, and in units in which products of coordinates overflow.
TEST(Measures, MoveAndGrowWithTheMesh)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(2));
  const Constriction c = detect(mesh).at(0);
  for(const double scale : {1., std::ldexp(1., 600), std::ldexp(1., -600)})
    for(const Triple& shift : {Triple{{0, 0, 0}}, Triple{{1024, -2048, 512}}})
    {
      Mesh moved = mesh;
      for(Mesh::Vertex_index v : moved.vertices())
      {
        const Mesh::Point p = mesh.point(v);
        moved.point(v) =
            Mesh::Point(scale * (p.x() + shift[0]), scale * (p.y() + shift[1]), scale * (p.z() + shift[2]));
      }
      const std::vector<Constriction> found = detect(moved);
      ASSERT_EQ(found.size(), 1u);
      const Triple at = found[0].centroid();
      expect_near({{at[0] / scale - shift[0], at[1] / scale - shift[1], at[2] / scale - shift[2]}}, c.centroid(), 1e-9);
      expect_near(found[0].normal(), c.normal(), 1e-12);
      EXPECT_NEAR(found[0].diameter() / scale, c.diameter(), 1e-12);
    }
}

// Both sides of a sheet in the shape of a bow tie, as a surface: the curve across its middle encloses nothing.
TEST(Measures, ACurveWithoutAreaHasNoNormal)
{
  Mesh mesh;
  const std::vector<std::array<double, 2>> outline = {{{-2, -2}}, {{0, -0.7}}, {{2.1, -2}},
                                                      {{2, 2.3}}, {{0, 0.6}},  {{-2, 2}}};
  std::vector<Mesh::Vertex_index> border;
  for(const auto& p : outline)
    border.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], p[0] / 3 + p[1] / 7)));
  const Mesh::Vertex_index front = mesh.add_vertex(Mesh::Point(0, 0, 0)), back = mesh.add_vertex(Mesh::Point(0, 0, 0));
  for(std::size_t i = 0; i < border.size(); ++i)
  {
    mesh.add_face(front, border[i], border[(i + 1) % border.size()]);
    mesh.add_face(back, border[(i + 1) % border.size()], border[i]);
  }
  const std::vector<Mesh::Vertex_index> loop = {border[1], front, border[4], back};
  const SMC::Tightened_curve<Mesh> tightened = SMC::tighten_closed_curve(mesh, loop, SMC::parameters::certify(false));
  ASSERT_EQ(tightened.verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_NEAR(tightened.curve.length(), 2 * 1.3 * std::sqrt(1 + 1 / 49.), 1e-12);
  EXPECT_EQ(tightened.curve.normal(), (Triple{{0, 0, 0}}));
  EXPECT_NEAR(tightened.curve.roundness(), 0, 1e-12);
  expect_near(tightened.curve.centroid(), {{0, -0.05, -0.05 / 7}}, 1e-12);
}

std::vector<Constriction> measured(const Mesh& mesh)
{
  std::vector<Constriction> result;
  SMC::measure_constrictions(mesh, detect(mesh), std::back_inserter(result));
  return result;
}

// Two bellies of radius 1 and 2, joined by a neck of radius 1/2: parallel curves are rings.
test_meshes::Soup two_bellies(int around = 64)
{
  std::vector<std::array<double, 2>> profile;
  const std::vector<std::array<double, 2>> corners = {{{0.5, -3}}, {{1, -2}}, {{0.5, 0}}, {{2, 4}}, {{1, 5}}};
  for(std::size_t i = 0; i + 1 < corners.size(); ++i)
    for(int k = 0; k < 8; ++k)
      profile.push_back({{corners[i][0] + k * (corners[i + 1][0] - corners[i][0]) / 8,
                          corners[i][1] + k * (corners[i + 1][1] - corners[i][1]) / 8}});
  profile.push_back(corners.back());
  return test_meshes::revolution_of_profile(profile, -3.2, 5.3, around, 0, 1);
}

TEST(Measures, OfANeckBetweenTwoBelliesThatAreRings)
{
  const Mesh mesh = test_meshes::make_mesh(two_bellies());
  const double pi = std::acos(-1.);
  const std::vector<Constriction> found = measured(mesh);
  ASSERT_EQ(found.size(), 1u);
  const Constriction& c = found[0];
  EXPECT_NEAR(c.length(), pi, 0.01);
  EXPECT_NEAR(c.cap_area(), pi / 4, 0.01);
  EXPECT_NEAR((std::min)(c.side_girths()[0], c.side_girths()[1]), 2 * pi, 0.06);
  EXPECT_NEAR((std::max)(c.side_girths()[0], c.side_girths()[1]), 4 * pi, 0.12);
}

TEST(Measures, OfACapWithHundredsOfCorners)
{
  const Constriction c = measured(test_meshes::make_mesh(two_bellies(300))).at(0);
  EXPECT_GT(c.locations().size(), 256u);
  EXPECT_NEAR(c.cap_area(), std::acos(-1.) / 4, 5e-3);
}

// Left and right are those of the areas.
TEST(Measures, TheGirthOfASideIsThatOfTheLargerBellyWhereTheAreaIsLarger)
{
  const Constriction c = measured(test_meshes::make_mesh(two_bellies())).at(0);
  EXPECT_EQ(c.areas()[0] > c.areas()[1], c.side_girths()[0] > c.side_girths()[1]);
}

TEST(Measures, OfCapsAndSidesScaleWithTheMesh)
{
  const Constriction one = measured(test_meshes::make_mesh(two_bellies())).at(0);
  for(int exponent : {-300, 5, 300})
  {
    const Constriction c =
        measured(test_meshes::make_mesh(test_meshes::scaled(two_bellies(), std::ldexp(1, exponent)))).at(0);
    EXPECT_DOUBLE_EQ(c.cap_area(), std::ldexp(one.cap_area(), 2 * exponent));
    for(std::size_t s = 0; s < 2; ++s)
      EXPECT_DOUBLE_EQ(c.side_girths()[s], std::ldexp(one.side_girths()[s], exponent));
  }
}

// Around the tube of a torus the parallel curves of a meridian come from both sides, and meet opposite to it.
TEST(Measures, SidesThatMeetAreMeasuredUpToThere)
{
  for(const Constriction& c : measured(test_meshes::make_mesh(test_meshes::torus(0, 1, 60, 24, 0.4))))
    for(double girth : c.side_girths())
    {
      EXPECT_GE(girth, c.length());
      EXPECT_LT(girth, 3 * c.length());
    }
}

TEST(Measures, OfRealCurvesSidesAreNoNarrowerThanTheCurve)
{
  for(const char* name : {"cactus.off", "elephant.off", "mushroom.off"})
    for(const Constriction& c : measured(read(name)))
    {
      EXPECT_GE(c.side_girths()[0], c.length()) << name;
      EXPECT_GE(c.side_girths()[1], c.length()) << name;
      EXPECT_GT(c.cap_area(), 0) << name;
      EXPECT_LT(c.cap_area(), c.length() * c.length() / (4 * std::acos(-1.)) * 1.3) << name;
    }
}

} // namespace test_measures
