// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/statistics_taker.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Local_boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_near {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using real_meshes::read;
using statistics_taker::Statistics_taker;
using test_meshes::Mesh;
typedef Mesh::Point Point;
typedef SMC::Constriction<Mesh> Constriction;

template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Constriction> near(const Mesh& mesh, const Point& location,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Constriction> result;
  SMC::detect_constrictions_near(mesh, location, std::back_inserter(result), np);
  return result;
}

// The mean of the points of a curve.
Point center(const Mesh& mesh, const Constriction& c)
{
  std::vector<Point> points;
  c.points(mesh, std::back_inserter(points));
  CGAL::Vector_3<test_meshes::Kernel> sum(0, 0, 0);
  for(const Point& p : points)
    sum = sum + (p - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / static_cast<double>(points.size());
}

TEST(Near, OnANeckOfAChainThatNeckComesFirst)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1));
  for(int neck = 1; neck <= 4; ++neck)
  {
    const double radius = 0.2 + 0.1 * neck;
    for(double height : {2.0 * neck, 2.0 * neck - 0.3, 2.0 * neck + 0.3})
    {
      const std::vector<Constriction> curves = near(mesh, Point(0, radius, height));
      ASSERT_FALSE(curves.empty());
      EXPECT_NEAR(center(mesh, curves[0]).z(), 2 * neck, 0.1);
      EXPECT_NEAR(curves[0].length(), 2 * CGAL_PI * radius, 0.1);
      EXPECT_TRUE(curves[0].certificate().is_certified());
      EXPECT_EQ(curves[0].seeds().front().origin, SMC::Seed_origin::CUT_LOCUS);
    }
  }
}

TEST(Near, OnAnArmOfTheCactusItsRingComesFirstAndOnTheTrunkTheTrunks)
{
  const Mesh mesh = read("cactus.off");
  struct Place
  {
    Point location;
    double length, tolerance, x; // of the ring, and the x coordinate of its center
  };
  const std::vector<Place> places = {
      {Point(0.34, 0.07, -0.02), 0.295, 0.005, 0.3},    {Point(0.18, -0.08, -0.05), 0.291, 0.002, 0.14},
      {Point(0.38, 0.29, 0.00), 0.295, 0.01, 0.33},     {Point(-0.30, 0.17, 0.00), 0.29, 0.01, -0.27},
      {Point(-0.32, 0.29, 0.09), 0.295, 0.01, -0.3},    {Point(0.02, 0.33, -0.08), 0.597, 0.003, -0.02},
      {Point(-0.10, -0.52, 0.05), 0.597, 0.003, -0.02}, {Point(-0.06, 0.51, 0.05), 0.597, 0.003, -0.02}};
  for(const Place& p : places)
  {
    SCOPED_TRACE(p.location);
    const std::vector<Constriction> curves = near(mesh, p.location);
    ASSERT_FALSE(curves.empty());
    EXPECT_NEAR(curves[0].length(), p.length, p.tolerance);
    EXPECT_NEAR(center(mesh, curves[0]).x(), p.x, 0.06);
  }
}

TEST(Near, OnALegOfTheCamelThatLegsConstrictionComesFirst)
{
  const Mesh mesh = read("camel.off");
  for(double x : {-0.04, 0.04})
    for(double z : {0.02, -0.45})
      for(double y : {-0.2, -0.25, -0.3, -0.35, -0.4})
      {
        const Point location(x, y, z);
        SCOPED_TRACE(location);
        const std::vector<Constriction> curves = near(mesh, location);
        ASSERT_FALSE(curves.empty());
        EXPECT_LT(curves[0].length(), 0.2);
        const Point c = center(mesh, curves[0]);
        EXPECT_EQ(c.x() > 0, x > 0);
        EXPECT_EQ(c.z() > -0.2, z > -0.2);
      }
}

TEST(Near, TheNumberIsThatOfTheNearestAndPlacesFollow)
{
  const Mesh mesh = read("cactus.off");
  const Point location(0.3, 0.13, 0);
  const std::vector<Constriction> all = near(mesh, location);
  ASSERT_GE(all.size(), 5u);
  for(const Constriction& c : all)
    if(c.dominated_by())
    {
      ASSERT_LT(*c.dominated_by(), all.size());
      EXPECT_LE(all[*c.dominated_by()].length(), c.length());
    }
  for(std::size_t n = 0; n < 5; ++n)
  {
    const std::vector<Constriction> some = near(mesh, location, params::maximum_number_of_constrictions(n));
    ASSERT_EQ(some.size(), n);
    for(std::size_t i = 0; i < n; ++i)
    {
      EXPECT_EQ(some[i].length(), all[i].length());
      EXPECT_LT(some[i].dominated_by().value_or(0), n);
    }
  }
  for(const Constriction& c : near(mesh, location, params::minimum_prominence(0.05)))
    EXPECT_GE(c.prominence(), 0.05);
}

TEST(Near, TheStatisticsAddUp)
{
  const Mesh mesh = read("cactus.off");
  SMC::Detection_statistics s;
  const std::vector<Constriction> curves =
      near(mesh, Point(0.3, 0.13, 0),
           params::maximum_number_of_constrictions(std::size_t(2), CGAL::parameters::visitor(Statistics_taker(s))));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_GT(s.not_selected, 0u);
  EXPECT_EQ(s.seeds + s.barriers,
            s.degenerate + s.discarded + s.not_simple + s.not_certified + s.merged + s.not_selected + 2);
}

std::set<Mesh::Vertex_index> pivots(const Constriction& c)
{
  std::set<Mesh::Vertex_index> result;
  for(const Constriction::Pivot& p : c.pivots())
    result.insert(p.vertex);
  return result;
}

// Bodies with a hole: at the hole, its rim comes first if rims are asked for, as `detect_constrictions()` finds it.
TEST(Near, AtAHoleItsRimComesFirstIfRimsAreAskedFor)
{
  for(const test_meshes::Soup& soup :
      {test_meshes::dumbbell(0.003, 1), test_meshes::dumbbell(0.003, 1, 60, 40)}) // below and above 1000 vertices
    for(double height : {0.5, 1.5, 2.5})
    {
      SCOPED_TRACE(height);
      std::size_t taken = 0;
      const auto distance = [&](std::size_t v) {
        const test_meshes::Position& p = soup.points[v];
        return std::hypot(p[0] - 1, p[1], p[2] - height);
      };
      for(std::size_t v = 0; v < soup.points.size(); ++v)
        if(distance(v) < distance(taken))
          taken = v;
      const Mesh mesh = test_meshes::make_mesh(open_meshes::without_star(soup, taken));
      const test_meshes::Position& p = soup.points[taken];
      const Point location(p[0], p[1], p[2]);
      std::vector<Constriction> rims;
      for(const Constriction& c : detection::detect(mesh, params::rim_constrictions(true)))
        if(c.is_rim())
          rims.push_back(c);
      ASSERT_EQ(rims.size(), 1u);
      const std::vector<Constriction> curves = near(mesh, location, params::rim_constrictions(true));
      ASSERT_FALSE(curves.empty());
      EXPECT_TRUE(curves[0].is_rim());
      EXPECT_TRUE(curves[0].certificate().is_certified());
      EXPECT_EQ(pivots(curves[0]), pivots(rims[0]));
      for(const Constriction& c : near(mesh, location, params::rim_constrictions(false)))
        EXPECT_FALSE(c.is_rim());
    }
}

std::vector<SMC::Seed_curve> boundaries_near(const SMC::Progressive_mesh& pm, SMC::Index vertex, std::size_t max_holes)
{
  const SMC::Seed_level level = {pm.number_of_vertices(), 0, SMC::null_index, nullptr};
  std::vector<SMC::Seed_curve> result;
  SMC::Local_boundary_seeds(vertex, 1000, max_holes)(pm, level, std::back_inserter(result));
  return result;
}

// The hole that a vertex lies on is the nearest; there are no more than there are, and none on another component.
TEST(Near, TheHolesOfTheSeedsAreTheNearest)
{
  const test_meshes::Soup closed = test_meshes::dumbbell(0.003, 1, 60, 40);
  const test_meshes::Soup body = open_meshes::with_random_holes(closed, 30, 1);
  const SMC::Progressive_mesh pm =
      SMC::make_progressive_mesh(test_meshes::make_mesh(test_meshes::joined(body, closed, 20)), {});
  std::vector<SMC::Seed_curve> all;
  SMC::boundary_seeds(pm, std::back_inserter(all));
  ASSERT_GE(all.size(), 20u);
  for(const SMC::Seed_curve& hole : all)
    for(SMC::Index v : hole.vertices)
    {
      const std::vector<SMC::Seed_curve> some = boundaries_near(pm, v, 3);
      ASSERT_EQ(some.size(), 3u);
      EXPECT_EQ(some[0].vertices, hole.vertices);
      EXPECT_EQ(some[0].origin, SMC::Seed_origin::BOUNDARY);
      EXPECT_NE(some[1].vertices, some[2].vertices);
      EXPECT_EQ(boundaries_near(pm, v, 1).size(), 1u);
      EXPECT_EQ(boundaries_near(pm, v, 1000).size(), all.size());
    }
  const SMC::Index on_other_component = static_cast<SMC::Index>(body.points.size());
  EXPECT_TRUE(boundaries_near(pm, on_other_component, 3).empty());
}

// The seeds pass through the location, so nothing is found on the other component.
TEST(Near, OnlyTheComponentOfTheLocationIsSearched)
{
  const test_meshes::Soup tube = test_meshes::boxes_with_tube(3);
  const Mesh mesh = test_meshes::make_mesh(test_meshes::joined(tube, tube, 20));
  for(double x : {3.5, 23.5})
  {
    const std::vector<Constriction> curves = near(mesh, Point(x, 1, 1));
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length(), 4, 1e-12);
    EXPECT_EQ(center(mesh, curves[0]).x() > 15, x > 15);
  }
}

// The unit of the coordinates does not matter, even where their squares overflow or vanish.
TEST(Near, CoordinatesMayBeLargeOrSmall)
{
  for(double unit : {1e-200, 1e200})
  {
    const test_meshes::Soup soup = test_meshes::scaled(test_meshes::chain_of_necks(0.005, 1), unit);
    const std::vector<Constriction> curves =
        near(test_meshes::make_mesh(soup), Point(0, 0.5 * unit, 6 * unit), params::certify(false));
    ASSERT_FALSE(curves.empty());
    EXPECT_NEAR(curves[0].length() / unit, 2 * CGAL_PI * 0.5, 0.1);
  }
}

TEST(Near, IsolatedVerticesAreNotNear)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const Point location(3.5, 1.5, 1.1);
  mesh.add_vertex(location);
  const std::vector<Constriction> curves = near(mesh, location);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(curves[0].length(), 4, 1e-12);
}

// A neck of radius 0.7 at the height 1.5, and a horn that tapers from radius 1 at the height 3 to a tip.
test_meshes::Soup horn()
{
  std::vector<std::array<double, 2>> profile;
  for(int i = 0; i <= 30; ++i)
    profile.push_back({{0.85 + 0.15 * std::cos(2 * CGAL_PI * i / 30), 0.1 * i}});
  for(int i = 1; i <= 25; ++i)
    profile.push_back({{1 - 0.032 * i, 3 + 0.1 * i}});
  return test_meshes::revolution_of_profile(profile, -0.2, 5.7, 24, 0.002, 1);
}

// The loop around the horn slides off it. What loops that pass there lead to is the neck, which is no further away than
// it is long, but more than 1.5 times as long as the girth.
TEST(Near, WhereNothingIsNarrowThereIsNone)
{
  const Mesh mesh = test_meshes::make_mesh(horn());
  for(double height : {4.8, 5.0, 5.2})
  {
    SCOPED_TRACE(height);
    const Point location(1 - 0.32 * (height - 3), 0, height);
    SMC::Detection_statistics s;
    EXPECT_TRUE(near(mesh, location, CGAL::parameters::visitor(Statistics_taker(s))).empty());
    EXPECT_GT(s.not_selected, 0u);
    const std::vector<Constriction> all = near(mesh, location, params::all_constrictions(true));
    ASSERT_FALSE(all.empty());
    EXPECT_NEAR(all[0].length(), 2 * CGAL_PI * 0.7, 0.1);
  }
  const std::vector<Constriction> at_its_root = near(mesh, Point(0.93, 0, 3.2));
  ASSERT_EQ(at_its_root.size(), 1u);
  EXPECT_NEAR(at_its_root[0].length(), 2 * CGAL_PI * 0.7, 0.1);
}

// No loop holds at a blunt tip. The neck that cuts it off is the answer, those behind it are not.
TEST(Near, AtABluntTipTheNeckThatCutsItOffComesFirst)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1));
  const std::vector<Constriction> curves = near(mesh, Point(0, 0, -0.3));
  ASSERT_FALSE(curves.empty());
  EXPECT_NEAR(center(mesh, curves[0]).z(), 2, 0.1);
}

TEST(Near, AConvexPolyhedronHasNoConstriction)
{
  EXPECT_TRUE(near(test_meshes::make_mesh(test_meshes::box(4, 4, 4)), Point(0, 1, 1)).empty());
}

TEST(Near, BadInputIsToldApart)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for(double x : bad)
    try
    {
      near(mesh, Point(0, x, 0));
      ADD_FAILURE() << "no exception";
    }
    catch(const SMC::Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), SMC::Input_defect::NON_FINITE_COORDINATE);
      EXPECT_NE(std::string(e.what()).find("location has y"), std::string::npos) << e.what();
    }
  try
  {
    near(Mesh(), Point(0, 0, 0));
    ADD_FAILURE() << "no exception";
  }
  catch(const SMC::Invalid_input& e)
  {
    EXPECT_EQ(e.defect(), SMC::Input_defect::EMPTY_MESH);
  }
}

TEST(Near, RepresentativesFollowTheMerges)
{
  SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::box(3, 3, 3));
  const SMC::Index n = static_cast<SMC::Index>(pm.number_of_vertex_ids());
  const SMC::Index a = pm.source(0), b = pm.target(0);
  pm.append_collapse({a, b, pm.point(b)});
  const SMC::Index c = pm.target(pm.outgoing(b));
  for(SMC::Index v = 0; v < n; ++v)
    EXPECT_EQ(pm.representative(v), v == a ? b : v);
  pm.append_collapse({b, c, pm.point(c)});
  for(SMC::Index v = 0; v < n; ++v)
    EXPECT_EQ(pm.representative(v), v == a || v == b ? c : v);
  pm.go_to_level(1);
  for(SMC::Index v = 0; v < n; ++v)
    EXPECT_EQ(pm.representative(v), v == a ? b : v);
  pm.go_to_level(0);
  for(SMC::Index v = 0; v < n; ++v)
    EXPECT_EQ(pm.representative(v), v);
}

} // namespace test_near
