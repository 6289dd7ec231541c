// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/geodesic_loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace test_loop_through {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
typedef Mesh::Point Point;
typedef SMC::Loop_through_locations<Mesh> Loop;

std::vector<Point> points(const Mesh& mesh, const Loop& loop)
{
  std::vector<Point> result;
  loop.points(mesh, std::back_inserter(result));
  return result;
}

// The loop passes the places in their order, and is as long as it is said to be.
void check(const Mesh& mesh, const Loop& loop, const std::vector<Point>& places)
{
  const std::vector<Point> p = points(mesh, loop);
  ASSERT_EQ(loop.held.size(), places.size());
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_LE(std::sqrt(CGAL::squared_distance(p.at(loop.held[i]), places[i])), 1e-9);
    EXPECT_TRUE(i == 0 || loop.held[i - 1] < loop.held[i]);
  }
  double length = 0;
  for(std::size_t i = 0; i < p.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(p[i], p[(i + 1) % p.size()]));
  EXPECT_NEAR(length, loop.length, 1e-9);
}

// The sides of the prism are squares of the plane when it is unrolled. Places in its sides, on its edges along it, on
// those that cut its sides into triangles, and two in one face.
TEST(Loop_through, AroundAPrismItIsAsLongAsInThePlane)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(4, 20));
  const double side = std::sqrt(2);
  const auto at = [&](double along, double z) { // along the perimeter, in sides
    const int i = static_cast<int>(along);
    const double t = along - i, phi = CGAL_PI / 2 * i, psi = CGAL_PI / 2 * (i + 1);
    return Point((1 - t) * std::cos(phi) + t * std::cos(psi), (1 - t) * std::sin(phi) + t * std::sin(psi), z);
  };
  struct Place
  {
    double along, z;
  };
  const std::vector<std::vector<Place>> cases = {{{0, 10}, {1, 11}, {2, 10}, {3, 9}},
                                                 {{0.5, 10}, {1.5, 11}, {2.5, 10}, {3.5, 9}},
                                                 {{0.25, 8}, {0.75, 8.5}, {1.8, 9}, {3, 9.5}},
                                                 {{0.2, 4}, {0.3, 4.2}, {1.5, 5}, {2.5, 5}, {3.5, 4.5}}};
  for(const std::vector<Place>& places : cases)
  {
    std::vector<Point> given;
    double length = 0;
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      given.push_back(at(places[i].along, places[i].z));
      const Place& next = places[(i + 1) % places.size()];
      const double turn = i + 1 < places.size() ? 0 : 4;
      length += std::hypot(side * (next.along + turn - places[i].along), next.z - places[i].z);
    }
    const Loop loop = SMC::geodesic_loop_through_locations(mesh, given);
    check(mesh, loop, given);
    EXPECT_NEAR(loop.length, length, 1e-9);
    EXPECT_TRUE(loop.is_simple);
    // a band around a prism leaks at neither end before it comes to an end of the prism, and slips off there
    EXPECT_EQ(loop.let_go.verdict, SMC::Tightening_verdict::DEGENERATE);
  }
}

TEST(Loop_through, LetGoOnATubeItIsTheConstriction)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const std::vector<Point> places = {Point(3.5, 1, 1.5), Point(4, 1.5, 1), Point(4.2, 2, 1.5), Point(3.7, 1.5, 2)};
  const Loop loop = SMC::geodesic_loop_through_locations(mesh, places);
  check(mesh, loop, places);
  EXPECT_GT(loop.length, 4);
  ASSERT_EQ(loop.let_go.verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_NEAR(loop.let_go.curve.length(), 4, 1e-12);
  EXPECT_TRUE(loop.let_go.curve.certificate().is_certified());
}

// An open path of edges is closed by the way back; given by all its vertices it is that loop.
TEST(Loop_through, AClosedPathOfEdgesBecomesWhatTighteningMakesOfIt)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.003, 1));
  for(int ring : {8, 12, 15})
  {
    std::vector<Mesh::Vertex_index> around;
    for(int j = 0; j < 18; ++j)
      around.emplace_back(static_cast<Mesh::size_type>(ring * 18 + j));
    const SMC::Tightened_curve<Mesh> expected = SMC::tighten_closed_curve(mesh, around);
    for(std::size_t left_out : {std::size_t(0), std::size_t(5)})
    {
      const std::vector<Mesh::Vertex_index> open(around.begin(), around.end() - static_cast<std::ptrdiff_t>(left_out));
      const Loop loop = SMC::geodesic_loop_through_locations(mesh, open);
      ASSERT_EQ(loop.let_go.verdict, expected.verdict);
      EXPECT_NEAR(loop.let_go.curve.length(), expected.curve.length(), 1e-9);
    }
  }
}

// Ghosts have other numbers after a point has been put in.
TEST(Loop_through, OnASurfaceWithHolesToo)
{
  const test_meshes::Soup soup = test_meshes::boxes_with_tube(3);
  const Mesh mesh = test_meshes::make_mesh(open_meshes::without_star(soup, 0));
  const std::vector<Point> places = {Point(3.5, 1, 1.5), Point(4, 1.5, 1), Point(4.2, 2, 1.5), Point(3.7, 1.5, 2)};
  const Loop loop = SMC::geodesic_loop_through_locations(mesh, places);
  check(mesh, loop, places);
  ASSERT_EQ(loop.let_go.verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_NEAR(loop.let_go.curve.length(), 4, 1e-12);
}

TEST(Loop_through, BadLocationsAreToldApart)
{
  const test_meshes::Soup tube = test_meshes::boxes_with_tube(3);
  const Mesh mesh = test_meshes::make_mesh(test_meshes::joined(tube, tube, 20));
  const Point a(3.5, 1, 1.5), b(4, 1.5, 1), c(4.2, 2, 1.5), nan(0, std::nan(""), 0);
  const auto element = [&](const std::vector<Point>& places, SMC::Input_defect defect) {
    try
    {
      SMC::geodesic_loop_through_locations(mesh, places);
    }
    catch(const SMC::Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), defect) << e.what();
      return e.element();
    }
    ADD_FAILURE() << "no exception";
    return std::size_t(99);
  };
  EXPECT_EQ(element({a, b}, SMC::Input_defect::INVALID_LOOP), 0u);
  EXPECT_EQ(element({a, b, b}, SMC::Input_defect::INVALID_LOOP), 2u);
  EXPECT_EQ(element({a, b, c, a}, SMC::Input_defect::INVALID_LOOP), 0u);
  EXPECT_EQ(element({a, b, Point(24, 1.5, 1)}, SMC::Input_defect::INVALID_LOOP), 2u);
  EXPECT_EQ(element({a, nan, b}, SMC::Input_defect::NON_FINITE_COORDINATE), 1u);
}

} // namespace test_loop_through
