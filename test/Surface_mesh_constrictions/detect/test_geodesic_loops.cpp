// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loops_at_location.h>

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_geodesic_loops {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using real_meshes::read;
using test_meshes::Mesh;
using test_meshes::Position;
using test_meshes::Soup;
typedef Mesh::Point Point;
typedef SMC::Geodesic_loop<Mesh> Loop;

template <class TriangleMesh, class Location, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<SMC::Geodesic_loop<TriangleMesh>> loops(const TriangleMesh& mesh, const Location& location,
                                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<SMC::Geodesic_loop<TriangleMesh>> result;
  SMC::geodesic_loops_at_location(mesh, location, std::back_inserter(result), np);
  return result;
}

// The shortest loops, also those that are folded at the location.
template <class Location>
std::vector<Loop> first_loops(const Mesh& mesh, const Location& location, std::size_t number)
{
  return loops(mesh, location, params::maximum_number_of_loops(number).minimum_loop_angle(0.0));
}

std::vector<Point> points(const Mesh& mesh, const Loop& loop)
{
  std::vector<Point> result;
  loop.points(mesh, std::back_inserter(result));
  return result;
}

std::set<Mesh::Face_index> faces_at(const Mesh& mesh, const Loop::Face_location& l)
{
  std::set<Mesh::Face_index> result = {l.first};
  Mesh::Halfedge_index h = mesh.halfedge(l.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
  {
    if(l.second[i] == 1)
      for(Mesh::Face_index f : mesh.faces_around_target(mesh.prev(h)))
        result.insert(f);
    if(l.second[(i + 2) % 3] == 0)
      result.insert(mesh.face(mesh.opposite(h)));
  }
  result.erase(Mesh::null_face());
  return result;
}

// What holds for each loop: it starts at the place, goes from face to face, is as long as it is said to be, and each
// vertex but the first has side angles of no less than pi.
void check(const Mesh& mesh, const Loop& loop, const Point& place)
{
  const std::vector<Point> p = points(mesh, loop);
  ASSERT_GE(p.size(), 2u);
  EXPECT_LE(std::sqrt(CGAL::squared_distance(p[0], place)), 1e-5 * loop.length);
  double length = 0;
  for(std::size_t i = 0; i < p.size(); ++i)
  {
    const std::size_t j = (i + 1) % p.size();
    length += std::sqrt(CGAL::squared_distance(p[i], p[j]));
    const std::set<Mesh::Face_index> a = faces_at(mesh, loop.locations[i]), b = faces_at(mesh, loop.locations[j]);
    std::vector<Mesh::Face_index> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    EXPECT_FALSE(both.empty()) << "points " << i << " and " << j << " are not in one face";
  }
  EXPECT_NEAR(length, loop.length, 1e-9 * length);
  for(const Loop::Pivot& pivot : loop.pivots)
  {
    EXPECT_EQ(p[pivot.location], mesh.point(pivot.vertex));
    if(pivot.location != 0)
    {
      EXPECT_GE(std::min(pivot.left_angle, pivot.right_angle), CGAL_PI - 1e-9);
    }
  }
  EXPECT_EQ(loop.is_closed_geodesic, std::min(loop.left_angle, loop.right_angle) > CGAL_PI - 1e-9);
  EXPECT_EQ(loop.let_go.locations().empty(), loop.verdict != SMC::Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_LE(loop.let_go.length(), loop.length * (1 + 1e-9));
}

// On a face, on an edge along the prism, and on what cuts its sides into triangles.
TEST(Geodesic_loops, AroundAPrismTheGirthIsThePerimeter)
{
  for(int n : {3, 4, 6, 200})
  {
    SCOPED_TRACE(n);
    const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(n, 20));
    const double phi = 2 * CGAL_PI / n, perimeter = 2 * n * std::sin(phi / 2);
    for(double z : {10.0, 9.1})
      for(double share : {0.5, 0.0})
      {
        const Point place(1 - share + share * std::cos(phi), share * std::sin(phi), z);
        const std::vector<Loop> found = loops(mesh, place);
        ASSERT_EQ(found.size(), 1u);
        check(mesh, found[0], place);
        EXPECT_NEAR(found[0].length, perimeter, 1e-11);
        EXPECT_TRUE(found[0].is_closed_geodesic);
        EXPECT_TRUE(found[0].separating);
        EXPECT_TRUE(found[0].encloses_tip()); // it slips off over the end of the prism
        EXPECT_NEAR(found[0].centroid[2], z, 1e-9);
        EXPECT_NEAR(std::abs(found[0].normal[2]), 1, 1e-9);
      }
  }
}

// A cone of n faces whose angles at the apex add up to `angle`, 10 long, in rings, open at its base. The apex is at the
// origin.
Soup cone(int n, double angle, int rings)
{
  const double r = 10 * std::sin(angle / (2 * n)) / std::sin(CGAL_PI / n), h = std::sqrt(100 - r * r);
  Soup soup;
  soup.points.push_back({{0, 0, 0}});
  for(int k = 1; k <= rings; ++k)
    for(int i = 0; i < n; ++i)
    {
      const double phi = 2 * CGAL_PI * i / n, s = static_cast<double>(k) / rings;
      soup.points.push_back({{s * r * std::cos(phi), s * r * std::sin(phi), -s * h}});
    }
  const auto at = [n](int k, int i) { return static_cast<std::size_t>(1 + (k - 1) * n + i % n); };
  for(int i = 0; i < n; ++i)
  {
    soup.faces.push_back({{0, at(1, i), at(1, i + 1)}});
    for(int k = 1; k < rings; ++k)
    {
      soup.faces.push_back({{at(k, i), at(k + 1, i), at(k + 1, i + 1)}});
      soup.faces.push_back({{at(k, i), at(k + 1, i + 1), at(k, i + 1)}});
    }
  }
  return soup;
}

// The point of a cone at this distance from its apex, in its first face.
Point on_cone(const Soup& soup, int n, double distance, double share)
{
  const Position &a = soup.points[soup.points.size() - static_cast<std::size_t>(n)],
                 &b = soup.points[soup.points.size() - static_cast<std::size_t>(n) + 1];
  const CGAL::Vector_3<test_meshes::Kernel> v((1 - share) * a[0] + share * b[0], (1 - share) * a[1] + share * b[1],
                                              (1 - share) * a[2] + share * b[2]);
  return CGAL::ORIGIN + distance / std::sqrt(v.squared_length()) * v;
}

// The loop is a chord of the sector that the cone unfolds to.
TEST(Geodesic_loops, AroundATipTheGirthIsAChordOfTheUnfoldedCone)
{
  for(double angle : {0.5, 2.0, 3.0})
    for(int n : {5, 40})
      for(int rings : {1, 12})
      {
        SCOPED_TRACE(angle);
        const Soup soup = cone(n, angle, rings);
        const Mesh mesh = test_meshes::make_mesh(soup);
        for(double distance : {2.0, 7.0})
          for(double share : {0.0, 0.8})
          {
            const Point place = on_cone(soup, n, distance, share);
            const std::vector<Loop> found = first_loops(mesh, place, 10);
            ASSERT_EQ(found.size(), 1u) << n << ' ' << rings << ' ' << distance << ' ' << share;
            check(mesh, found[0], place);
            EXPECT_NEAR(found[0].length, 2 * distance * std::sin(angle / 2), 1e-9);
            EXPECT_NEAR(std::min(found[0].left_angle, found[0].right_angle), CGAL_PI - angle, 1e-7);
            EXPECT_TRUE(found[0].encloses_tip());
            EXPECT_FALSE(found[0].is_closed_geodesic);
            // on a blunt cone it is nearly the way to the apex and back
            EXPECT_EQ(loops(mesh, place).size(), CGAL_PI - angle > CGAL_PI / 4 ? 1u : 0u);
          }
      }
}

TEST(Geodesic_loops, ABluntTipAndAPlateHaveNone)
{
  for(double angle : {3.2, 4.0, 6.0})
  {
    const Soup soup = cone(40, angle, 12);
    EXPECT_TRUE(first_loops(test_meshes::make_mesh(soup), on_cone(soup, 40, 4, 0.5), 10).empty()) << angle;
  }
  Soup plate;
  for(int i = 0; i <= 8; ++i)
    for(int j = 0; j <= 8; ++j)
      plate.points.push_back({{i + 0.1 * j, 1.0 * j, 0}});
  for(std::size_t i = 0; i < 8; ++i)
    for(std::size_t j = 0; j < 8; ++j)
    {
      plate.faces.push_back({{9 * i + j, 9 * i + j + 9, 9 * i + j + 10}});
      plate.faces.push_back({{9 * i + j, 9 * i + j + 10, 9 * i + j + 1}});
    }
  EXPECT_TRUE(first_loops(test_meshes::make_mesh(plate), Point(4, 4, 0), 10).empty());
}

TEST(Geodesic_loops, ThroughTheOuterEquatorOfATorusItIsTheMeridian)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0, 1, 90, 40));
  for(double u : {0.0, 1.0, 2.5})
  {
    const Point place(4 * std::cos(u), 4 * std::sin(u), 0);
    const std::vector<Loop> found = loops(mesh, place);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].length, 2 * CGAL_PI, 0.05);
    EXPECT_FALSE(found[0].separating);
    EXPECT_FALSE(found[0].encloses_tip());
    EXPECT_EQ(found[0].genera, (std::array<std::size_t, 2>{{0, 0}}));
    EXPECT_NEAR(found[0].centroid[0], 3 * std::cos(u), 0.05);
    EXPECT_NEAR(found[0].centroid[1], 3 * std::sin(u), 0.05);
  }
}

TEST(Geodesic_loops, OnTheTubeOfADumbbellItIsAsLongAsTheConstriction)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(5));
  for(const Point& place : {Point(4.5, 1.3, 1), Point(4.25, 1, 1.5), Point(4, 1, 1), Point(3.1, 2, 1.9)})
  {
    SCOPED_TRACE(place);
    const std::vector<Loop> found = loops(mesh, place);
    ASSERT_EQ(found.size(), 1u);
    check(mesh, found[0], place);
    EXPECT_NEAR(found[0].length, 4, 1e-12);
    EXPECT_TRUE(found[0].is_closed_geodesic);
    EXPECT_EQ(found[0].verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
    EXPECT_TRUE(found[0].let_go.certificate().is_certified());
    EXPECT_NEAR(found[0].let_go.length(), 4, 1e-12);
    EXPECT_EQ(found[0].side, SMC::Side::OBJECT);
  }
}

// At its vertices, and between them.
TEST(Geodesic_loops, APlaceOnAConstrictionHasThat)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1));
  for(int neck = 1; neck <= 4; ++neck)
  {
    std::vector<SMC::Constriction<Mesh>> curves;
    SMC::detect_constrictions_near(mesh, Point(0, 0.2 + 0.1 * neck, 2 * neck), std::back_inserter(curves),
                                   params::maximum_number_of_constrictions(std::size_t(1)));
    ASSERT_EQ(curves.size(), 1u);
    for(std::size_t i = 0; i < curves[0].pivots().size(); i += 4)
    {
      const std::vector<Loop> found = loops(mesh, curves[0].pivots()[i].vertex);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_NEAR(found[0].length, curves[0].length(), 1e-12);
      EXPECT_TRUE(found[0].is_closed_geodesic);
      EXPECT_EQ(found[0].let_go.certificate().verdict, SMC::Certificate_verdict::STRICT_CONSTRICTION);
      EXPECT_NEAR(found[0].let_go.length(), curves[0].length(), 1e-12);
    }
    std::vector<Point> p;
    curves[0].points(mesh, std::back_inserter(p));
    for(std::size_t i = 0; i < p.size(); i += 15)
    {
      const Point middle = CGAL::midpoint(p[i], p[(i + 1) % p.size()]);
      const std::vector<Loop> found = loops(mesh, middle);
      ASSERT_EQ(found.size(), 1u);
      check(mesh, found[0], middle);
      EXPECT_NEAR(found[0].length, curves[0].length(), 1e-9);
    }
  }
}

TEST(Geodesic_loops, BesideANeckTheLoopIsLongerAndSlidesToIt)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.003, 1));
  for(double z : {2.6, 2.75, 3.2, 3.4})
  {
    const Point place(0.5, 0, z);
    const std::vector<Loop> found = loops(mesh, place);
    ASSERT_EQ(found.size(), 1u);
    const double radius = std::hypot(points(mesh, found[0])[0].x(), points(mesh, found[0])[0].y());
    EXPECT_LT(found[0].length, 2 * CGAL_PI * radius); // the circle is not straight
    EXPECT_EQ(found[0].verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
    EXPECT_LT(found[0].let_go.length(), found[0].length);
    EXPECT_NEAR(found[0].let_go.centroid()[2], 3, 0.1);
    EXPECT_TRUE(found[0].let_go.certificate().is_certified());
  }
}

// Every loop is what it is said to be, and the sides of one that encloses a tip, a disc, have the curvature that the
// theorem of Gauss and Bonnet says.
TEST(Geodesic_loops, OnRealMeshesEachIsStraightButAtThePlace)
{
  for(const char* name : {"hand.off", "cactus.off", "camel.off", "eight.off", "elephant-with-holes.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = read(name);
    std::mt19937 random(1);
    for(int i = 0; i < 8; ++i)
    {
      const Mesh::Face_index f(static_cast<Mesh::size_type>(random() % mesh.number_of_faces()));
      const double a = (1 + static_cast<double>(random() % 8)) / 10, b = (1 - a) / 3;
      const Loop::Face_location place(f, {{i % 3 == 0 ? 1 : a,
                                           i % 3 == 0   ? 0
                                           : i % 3 == 1 ? 1 - a
                                                        : b,
                                           i % 3 == 2 ? 1 - a - b : 0}});
      Loop at;
      at.locations.push_back(place);
      const std::vector<Loop> found = first_loops(mesh, place, 3);
      for(const Loop& loop : found)
        check(mesh, loop, points(mesh, at)[0]);
      for(std::size_t k = 1; k < found.size(); ++k)
        EXPECT_LE(found[k - 1].length, found[k].length);
    }
  }
}

TEST(Geodesic_loops, TheGirthOfALimbIsThatOfASection)
{
  struct Place
  {
    const char* mesh;
    Point place;
    double length;
  };
  for(const Place& p : {Place{"cactus.off", Point(0.02, 0.33, -0.08), 0.6},
                        {"cactus.off", Point(0.18, -0.08, -0.05), 0.29},
                        {"man.off", Point(0.0894, -0.0557, 0.1742), 0.154},
                        {"man.off", Point(-0.1764, 0.0681, 0.172), 0.152}})
  {
    SCOPED_TRACE(p.mesh);
    const std::vector<Loop> found = loops(read(p.mesh), p.place);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].length, p.length, 0.03 * p.length);
    EXPECT_GT(found[0].roundness, 0.9);
  }
}

TEST(Geodesic_loops, APlaceMayBeAVertexALocationOrAPoint)
{
  const Mesh mesh = read("cactus.off");
  const Mesh::Vertex_index v(100);
  const Mesh::Halfedge_index h = mesh.halfedge(v);
  Loop::Face_location l(mesh.face(h), {{0, 0, 0}});
  Mesh::Halfedge_index around = mesh.halfedge(l.first);
  for(std::size_t i = 0; i < 3; ++i, around = mesh.next(around))
    if(mesh.source(around) == v)
      l.second[i] = 1;
  const std::vector<Loop> a = loops(mesh, v), b = loops(mesh, l), c = loops(mesh, mesh.point(v));
  ASSERT_EQ(a.size(), 1u);
  ASSERT_EQ(b.size(), 1u);
  ASSERT_EQ(c.size(), 1u);
  EXPECT_EQ(a[0].length, b[0].length);
  EXPECT_EQ(a[0].length, c[0].length);
  ASSERT_FALSE(a[0].pivots.empty());
  EXPECT_EQ(a[0].pivots[0].vertex, v);
  EXPECT_EQ(a[0].pivots[0].location, 0u);

  // off the surface, at the nearest point
  const Mesh tube = test_meshes::make_mesh(test_meshes::boxes_with_tube(5));
  const std::vector<Loop> off = loops(tube, Point(4.25, 1.4, 0.9));
  ASSERT_EQ(off.size(), 1u);
  check(tube, off[0], Point(4.25, 1.4, 1));
  EXPECT_TRUE(off[0].pivots.empty() || off[0].pivots[0].location != 0);
  EXPECT_EQ(loops(tube, Point(1e300, 0, 0)).size(), loops(tube, Point(1e3, 0, 0)).size());
}

TEST(Geodesic_loops, TheNumberAndTheAngleAreBounds)
{
  const Mesh mesh = read("hand.off");
  const Point place(0.396, 0.00885, -0.0863);
  const std::vector<Loop> all = first_loops(mesh, place, 1000);
  ASSERT_GE(all.size(), 4u);
  for(std::size_t n : {0, 1, 3})
  {
    const std::vector<Loop> some = first_loops(mesh, place, n);
    ASSERT_EQ(some.size(), n);
    for(std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(some[i].length, all[i].length);
  }
  EXPECT_LT(std::min(all[0].left_angle, all[0].right_angle), CGAL_PI / 4);
  double longest = all[0].length;
  for(double angle : {CGAL_PI / 4, 1.0, 1.5})
  {
    const std::vector<Loop> wide = loops(mesh, place, params::minimum_loop_angle(angle));
    ASSERT_EQ(wide.size(), 1u);
    EXPECT_GE(wide[0].length, longest);
    EXPECT_GE(std::min(wide[0].left_angle, wide[0].right_angle), angle);
    longest = wide[0].length;
  }
  EXPECT_GT(longest, all[0].length);
  const std::vector<Loop> by_default = loops(mesh, place);
  ASSERT_EQ(by_default.size(), 1u);
  EXPECT_EQ(by_default[0].length, loops(mesh, place, params::minimum_loop_angle(CGAL_PI / 4))[0].length);
}

TEST(Geodesic_loops, HolesAreGoneAroundAndNotOver)
{
  Soup tube = test_meshes::prism(12, 6);
  tube.faces.resize(24); // without the ends
  const Mesh mesh = test_meshes::make_mesh(tube);
  const double x = std::cos(CGAL_PI / 6), y = std::sin(CGAL_PI / 6);
  for(const Point& place : {Point(1, 0, 0), Point(1, 0, 2), Point(1, 0, 6), Point((1 + x) / 2, y / 2, 0),
                            Point((1 + x) / 2, y / 2, 2), Point((1 + x) / 2, y / 2, 6)})
  {
    SCOPED_TRACE(place);
    const std::vector<Loop> found = loops(mesh, place);
    ASSERT_EQ(found.size(), 1u);
    check(mesh, found[0], place);
    EXPECT_NEAR(found[0].length, 24 * std::sin(CGAL_PI / 12), 1e-12);
    EXPECT_EQ(found[0].verdict, SMC::Tightening_verdict::CLOSED_GEODESIC); // the rim holds it
    EXPECT_NEAR(found[0].boundary_share, place.z() == 2 ? 0 : 1, 1e-9);
  }
}

TEST(Geodesic_loops, CoordinatesMayBeLargeOrSmall)
{
  for(double unit : {1e-200, 1e200})
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::scaled(test_meshes::prism(6, 20), unit));
    const std::vector<Loop> found = loops(mesh, Point(0.75 * unit, 0.4330127018922193 * unit, 9 * unit));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].length / unit, 6, 1e-9);
  }
}

TEST(Geodesic_loops, ThePolyhedronHasTheSame)
{
  typedef CGAL::Polyhedron_3<test_meshes::Kernel> Polyhedron;
  const Soup soup = test_meshes::chain_of_necks(0.005, 1);
  const Mesh mesh = test_meshes::make_mesh(soup);
  const Polyhedron polyhedron = test_meshes::make_graph<Polyhedron>(soup);
  for(double z : {2.0, 3.1, 4.4, 8.3})
  {
    const auto number = params::maximum_number_of_loops(std::size_t(3));
    const std::vector<Loop> found = loops(mesh, Point(1, 0.2, z), number);
    const auto same = loops(polyhedron, Point(1, 0.2, z), number);
    ASSERT_EQ(found.size(), same.size());
    ASSERT_FALSE(found.empty());
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i].length, same[i].length);
  }
  EXPECT_EQ(loops(polyhedron, *vertices(polyhedron).begin()).size(), loops(mesh, Mesh::Vertex_index(0)).size());
}

template <class Location>
SMC::Input_defect defect(const Mesh& mesh, const Location& location)
{
  try
  {
    loops(mesh, location);
  }
  catch(const SMC::Invalid_input& e)
  {
    EXPECT_NE(std::string(e.what()).find("location"), std::string::npos) << e.what();
    return e.defect();
  }
  ADD_FAILURE() << "no exception";
  return SMC::Input_defect::EMPTY_MESH;
}

TEST(Geodesic_loops, BadLocationsAreToldApart)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(9, 9, 9));
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Mesh::Face_index f(0);
  EXPECT_EQ(defect(mesh, isolated), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(mesh, Mesh::null_vertex()), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(mesh, Mesh::Vertex_index(1000000)), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(mesh, Point(0, nan, 0)), SMC::Input_defect::NON_FINITE_COORDINATE);
  EXPECT_EQ(defect(mesh, Point(0, 0, inf)), SMC::Input_defect::NON_FINITE_COORDINATE);
  EXPECT_EQ(defect(mesh, Loop::Face_location(f, {{nan, 0, 0}})), SMC::Input_defect::NON_FINITE_COORDINATE);
  EXPECT_EQ(defect(mesh, Loop::Face_location(f, {{0.5, 0.5, 0.5}})), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(mesh, Loop::Face_location(f, {{1.5, -0.5, 0}})), SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect(mesh, Loop::Face_location(Mesh::Face_index(1000000), {{1, 0, 0}})),
            SMC::Input_defect::INVALID_LOCATION);
  EXPECT_THROW(loops(Mesh(), Point(0, 0, 0)), SMC::Invalid_input);
}

} // namespace test_geodesic_loops
