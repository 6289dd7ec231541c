// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/plane_section_at_location.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace test_plane_section {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
typedef Mesh::Point Point;
typedef test_meshes::Kernel::Vector_3 Vector;
typedef SMC::Plane_section<Mesh> Section;

// What holds for each section: it passes through the place, is in the plane, and is as long as it is said to be; the
// loop is not longer.
void check(const Mesh& mesh, const Section& section, const Point& place, const Vector& axis)
{
  std::vector<Point> points;
  section.points(mesh, std::back_inserter(points));
  if(section.kind == SMC::Section_kind::POINT)
  {
    EXPECT_TRUE(points.empty());
    EXPECT_EQ(section.length, 0);
    EXPECT_EQ(section.number_of_curves, 0u);
    EXPECT_FALSE(section.loop);
    return;
  }
  ASSERT_FALSE(points.empty());
  EXPECT_GT(section.number_of_curves, 0u);
  double length = 0, nearest = std::numeric_limits<double>::infinity();
  const std::size_t segments = points.size() - (section.kind == SMC::Section_kind::OPEN ? 1 : 0);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(i < segments)
      length += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
    nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(points[i], place)));
    EXPECT_NEAR((points[i] - place) * axis / std::sqrt(axis.squared_length()), 0, 1e-5 * section.length);
  }
  EXPECT_LE(nearest, 1e-5 * section.length);
  EXPECT_NEAR(length, section.length, 1e-9 * length);
  EXPECT_TRUE(section.kind == SMC::Section_kind::CLOSED || !section.loop);
  if(section.loop)
  {
    EXPECT_LE(section.loop->length, section.length * (1 + 1e-12));
  }
}

template <class Location>
Section section(const Mesh& mesh, const Location& location, const Vector& axis)
{
  return SMC::plane_section_at_location(mesh, location, axis);
}

// The perimeter of the polygon in which a plane cuts a long prism.
double perimeter_of_section(int n, const Point& place, const Vector& axis)
{
  std::vector<Point> points;
  for(int i = 0; i < n; ++i)
  {
    const double x = std::cos(2 * CGAL_PI * i / n), y = std::sin(2 * CGAL_PI * i / n);
    points.emplace_back(x, y, place.z() - (axis.x() * (x - place.x()) + axis.y() * (y - place.y())) / axis.z());
  }
  double length = 0;
  for(int i = 0; i < n; ++i)
    length += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % n]));
  return length;
}

TEST(Plane_section, OfAPrismItIsAPolygonAndTheLoopItsPerimeter)
{
  for(int n : {3, 4, 7})
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(n, 40));
    const double x = std::cos(2 * CGAL_PI / n), y = std::sin(2 * CGAL_PI / n);
    for(const Point& place : {Point(0.3 + 0.7 * x, 0.7 * y, 20), Point(x, y, 19)})
      for(const Vector& axis : {Vector(0, 0, 1), Vector(0.1, -0.4, 1), Vector(-3, 2, -2.5)})
      {
        SCOPED_TRACE(testing::Message() << n << " sides, at " << place << ", along " << axis);
        const Section s = section(mesh, place, axis);
        check(mesh, s, place, axis);
        EXPECT_EQ(s.kind, SMC::Section_kind::CLOSED);
        EXPECT_EQ(s.number_of_curves, 1u);
        EXPECT_NEAR(s.length, perimeter_of_section(n, place, axis), 1e-5);
        ASSERT_TRUE(s.loop);
        EXPECT_NEAR(s.loop->length, 2 * n * std::sin(CGAL_PI / n), 1e-9);
      }
  }
}

TEST(Plane_section, OfACylinderItIsAnEllipse)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(1000, 40));
  for(double slope : {0., 0.5, 2.})
  {
    const Vector axis(slope, 0, 1);
    const Section s = section(mesh, Point(0, 1, 20), axis);
    check(mesh, s, Point(0, 1, 20), axis);
    const double a = std::sqrt(1 + slope * slope);
    EXPECT_NEAR(s.length, 4 * a * std::comp_ellint_2(std::sqrt(1 - 1 / (a * a))), 1e-4);
    ASSERT_TRUE(s.loop);
    EXPECT_NEAR(s.loop->length, 2 * CGAL_PI, 1e-4);
  }
}

TEST(Plane_section, BothOrientationsAndAllLengthsOfTheAxisGiveTheSame)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(3, 3, 9));
  for(const Point& place : {Point(3, 1, 5), Point(3, 1.25, 4.5), Point(0, 0, 9), Point(1, 1, 9)})
  {
    const Section expected = section(mesh, place, Vector(0.2, 0.3, 1));
    for(double factor : {-1., std::ldexp(1., 600), std::ldexp(-1., -600)})
      EXPECT_EQ(section(mesh, place, factor * Vector(0.2, 0.3, 1)).locations, expected.locations);
  }
}

// Through a tube that is open at both ends, along it; and from a place on a boundary.
TEST(Plane_section, IsOpenWhereItMeetsABoundary)
{
  const Mesh mesh = test_meshes::make_mesh(open_meshes::square_tube(4, 11));
  for(const Point& place : {Point(4, 1, 5), Point(4, 1.5, 5.25), Point(4, 1, 0)})
  {
    const Section s = section(mesh, place, Vector(0, 1, 0));
    check(mesh, s, place, Vector(0, 1, 0));
    EXPECT_EQ(s.kind, SMC::Section_kind::OPEN);
    EXPECT_EQ(s.number_of_curves, 1u);
    EXPECT_NEAR(s.length, 11, 1e-12);
  }
  const Section across = section(mesh, Point(4, 1, 5), Vector(0, 0, 1));
  EXPECT_EQ(across.kind, SMC::Section_kind::CLOSED);
  EXPECT_NEAR(across.length, 16, 1e-12);
}

TEST(Plane_section, IsAPointWhereThePlaneTouches)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(3, 3, 9));
  for(const Point& place : {Point(1, 1, 9), Point(1.25, 1.5, 9), Point(1, 1, 0)})
  {
    const Section s = section(mesh, place, Vector(0, 0, 1));
    check(mesh, s, place, Vector(0, 0, 1));
    EXPECT_EQ(s.kind, SMC::Section_kind::POINT);
  }
  EXPECT_EQ(section(mesh, Point(0, 0, 0), Vector(1, 1, 1)).kind, SMC::Section_kind::POINT);
  // along the rim of a face that is in the plane
  const Section rim = section(mesh, Point(0, 1, 9), Vector(0, 0, 1));
  EXPECT_EQ(rim.kind, SMC::Section_kind::CLOSED);
  EXPECT_NEAR(rim.length, 12, 1e-12);
}

// At a saddle of the height two closed curves meet; the shorter one is taken.
TEST(Plane_section, OfCurvesThatMeetTheShortestIsTaken)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0, 1, 40, 20));
  const Vector axis(1, 0, 0);
  const Section s = section(mesh, Point(2, 0, 0), axis);
  check(mesh, s, Point(2, 0, 0), axis);
  EXPECT_EQ(s.kind, SMC::Section_kind::CLOSED);
  EXPECT_EQ(s.number_of_curves, 2u);
  // half of the section of the torus with x = 2
  double half = 0;
  Point before(2, 0, 0);
  for(int i = 1; i <= 100000; ++i)
  {
    const double v = CGAL_PI - CGAL_PI * i / 50000, rho = 3 + std::cos(v);
    const Point p(2, std::sqrt(std::max(rho * rho - 4, 0.)), std::sin(v));
    half += std::sqrt(CGAL::squared_distance(before, p));
    before = p;
  }
  EXPECT_NEAR(s.length, half, 0.002 * half);
}

TEST(Plane_section, OfTheQueryIsThatOfTheFunction)
{
  const Mesh mesh = real_meshes::read("cactus.off");
  const SMC::Constriction_query<Mesh> query(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t closed = 0, loops = 0;
  for(int i = 0; i < 20; ++i)
  {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices()));
    const Point place = i % 2 == 0 ? mesh.point(v) : mesh.point(v) + 1e-3 * Vector(uniform(random), uniform(random), 1);
    const Vector axis(uniform(random), uniform(random), uniform(random));
    SCOPED_TRACE(testing::Message() << place << ", along " << axis);
    const Section s = query.plane_section(place, axis), expected = section(mesh, place, axis);
    std::vector<Point> points;
    s.points(mesh, std::back_inserter(points));
    check(mesh, s, points.empty() ? place : points.front(), axis);
    EXPECT_EQ(s.locations, expected.locations);
    EXPECT_EQ(s.length, expected.length);
    ASSERT_EQ(s.loop.has_value(), expected.loop.has_value());
    closed += s.kind == SMC::Section_kind::CLOSED;
    if(s.loop)
    {
      ++loops;
      EXPECT_EQ(s.loop->locations, expected.loop->locations);
    }
  }
  EXPECT_GE(closed, 18u);
  EXPECT_GT(loops, 0u);
}

TEST(Plane_section, AnAxisThatIsNoneIsRefused)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(1, 1, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto defect = [&](const Vector& axis) {
    try
    {
      section(mesh, Point(0, 0, 0), axis);
    }
    catch(const SMC::Invalid_input& e)
    {
      return e.defect();
    }
    ADD_FAILURE() << "no exception";
    return SMC::Input_defect::EMPTY_MESH;
  };
  EXPECT_EQ(defect(Vector(0, 0, 0)), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(Vector(0, nan, 0)), SMC::Input_defect::NON_FINITE_COORDINATE);
}

} // namespace test_plane_section
