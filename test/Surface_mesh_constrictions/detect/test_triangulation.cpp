// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/triangulate_with_face_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_triangulation {

namespace SMC = CGAL::Surface_mesh_constrictions;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Prisms over regular polygons, one above the other, joined: a dumbbell whose sides are quadrangles, and whose ends are
// polygons of n corners.
Mesh lathe(int n, const std::vector<std::array<double, 2>>& profile)
{
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> rings;
  for(const std::array<double, 2>& p : profile)
  {
    rings.emplace_back();
    for(int i = 0; i < n; ++i)
    {
      const double angle = 2 * std::acos(-1.) * i / n;
      rings.back().push_back(mesh.add_vertex(Point(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1])));
    }
  }
  for(std::size_t r = 0; r + 1 < rings.size(); ++r)
    for(std::size_t i = 0; i < rings[r].size(); ++i)
    {
      const std::size_t j = (i + 1) % rings[r].size();
      mesh.add_face(rings[r][i], rings[r][j], rings[r + 1][j], rings[r + 1][i]);
    }
  mesh.add_face(std::vector<Mesh::Vertex_index>(rings.front().rbegin(), rings.front().rend()));
  mesh.add_face(rings.back());
  return mesh;
}

Mesh dumbbell() { return lathe(10, {{{3, 0}}, {{3, 2}}, {{1, 4}}, {{3, 6}}, {{3, 8}}}); }

TEST(Triangulation, refused_with_the_name_of_the_function)
{
  std::vector<SMC::Constriction<Mesh>> found;
  try
  {
    SMC::detect_constrictions(dumbbell(), std::back_inserter(found));
    ADD_FAILURE() << "no error";
  }
  catch(const SMC::Invalid_input& e)
  {
    EXPECT_EQ(e.defect(), SMC::Input_defect::NOT_TRIANGULAR);
    EXPECT_NE(std::string(e.what()).find("triangulate_with_face_map()"), std::string::npos) << e.what();
  }
}

TEST(Triangulation, tells_the_polygon_of_each_triangle)
{
  const Mesh polygons = dumbbell();
  Mesh triangles;
  auto polygon = triangles.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:polygon").first;
  SMC::triangulate_with_face_map(polygons, triangles, polygon);
  EXPECT_TRUE(triangles.is_valid(false));
  EXPECT_TRUE(CGAL::is_triangle_mesh(triangles));
  EXPECT_TRUE(CGAL::is_closed(triangles));
  EXPECT_EQ(triangles.number_of_vertices(), polygons.number_of_vertices());
  std::map<Mesh::Face_index, double> areas;
  std::map<Mesh::Face_index, std::size_t> pieces;
  for(Mesh::Face_index f : triangles.faces())
  {
    ++pieces[polygon[f]];
    areas[polygon[f]] += CGAL::Polygon_mesh_processing::face_area(f, triangles);
  }
  for(Mesh::Face_index f : polygons.faces())
    EXPECT_EQ(pieces[f], polygons.degree(f) - 2) << f;
  // the ends are regular decagons
  const double decagon = 10. / 2 * 9 * std::sin(2 * std::acos(-1.) / 10);
  for(std::size_t f : {polygons.number_of_faces() - 2, polygons.number_of_faces() - 1})
    EXPECT_NEAR(areas[Mesh::Face_index(static_cast<Mesh::size_type>(f))], decagon, 1e-12 * decagon);

  std::vector<SMC::Constriction<Mesh>> found;
  SMC::detect_constrictions(triangles, std::back_inserter(found));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].length(), 20 * std::sin(std::acos(-1.) / 10), 1e-12); // 6.18034
}

// Named parameters of copy_face_graph() reach it.
TEST(Triangulation, tells_the_copies_of_vertices)
{
  const Mesh polygons = dumbbell();
  Mesh triangles;
  auto polygon = triangles.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:polygon").first;
  std::vector<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> copies;
  SMC::triangulate_with_face_map(polygons, triangles, polygon,
                                 CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(copies)));
  ASSERT_EQ(copies.size(), polygons.number_of_vertices());
  for(const auto& [of, copy] : copies)
    EXPECT_EQ(polygons.point(of), triangles.point(copy));
}

TEST(Triangulation, triangles_stay_and_types_may_differ)
{
  typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0), Point(0, 0, 1), tetrahedron);
  Polyhedron copy;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, Mesh::Face_index> polygon;
  SMC::triangulate_with_face_map(tetrahedron, copy, boost::make_assoc_property_map(polygon));
  EXPECT_EQ(num_faces(copy), 4u);
  EXPECT_EQ(polygon.size(), 4u);
}

TEST(Triangulation, of_a_polygon_that_is_neither_plane_nor_convex)
{
  // a star that goes up and down: its corners on the inside are never cut off
  std::vector<Point> star;
  for(int i = 0; i < 12; ++i)
  {
    const double angle = std::acos(-1.) * i / 6, radius = i % 2 == 0 ? 3 : 1;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), i % 3 == 0 ? 0.1 : 0);
  }
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  for(const auto& triangles :
      {SMC::internal::triangulate_polygon(star, allowed), SMC::internal::cut_off_ears(star, allowed)})
  {
    ASSERT_EQ(triangles.size(), 10u);
    double area = 0; // of the projections, with sign: all run the same way round
    for(const SMC::internal::Polygon_triangle& t : triangles)
    {
      const double a = CGAL::cross_product(star[t[1]] - star[t[0]], star[t[2]] - star[t[0]]).z() / 2;
      EXPECT_GT(a, 0);
      area += a;
    }
    EXPECT_NEAR(area, 12 * 0.5 * 3 * std::sin(std::acos(-1.) / 6), 1e-12);
  }
}

TEST(Triangulation, diagonals_that_are_not_allowed)
{
  // a convex hexagon, without the diagonals of corner 0
  std::vector<Point> hexagon;
  for(int i = 0; i < 6; ++i)
    hexagon.emplace_back(std::cos(std::acos(-1.) * i / 3), std::sin(std::acos(-1.) * i / 3), 0);
  for(std::size_t banned = 0; banned < 6; ++banned)
  {
    const auto triangles = SMC::internal::triangulate_polygon(
        hexagon, [banned](std::size_t i, std::size_t j) { return i != banned && j != banned; });
    ASSERT_EQ(triangles.size(), 4u);
    int at_corner = 0;
    for(const SMC::internal::Polygon_triangle& t : triangles)
      at_corner += t[0] == banned || t[1] == banned || t[2] == banned;
    EXPECT_EQ(at_corner, 1);
  }
}

TEST(Triangulation, polygons_that_cross_themselves_end)
{
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  const std::vector<Point> bow = {Point(0, 0, 0), Point(2, 2, 0), Point(2, 0, 0), Point(0, 2, 0), Point(-1, 1, 0)};
  EXPECT_EQ(SMC::internal::triangulate_polygon(bow, allowed).size(), 3u);
  const std::vector<Point> line = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0), Point(1, 0, 0)};
  EXPECT_EQ(SMC::internal::triangulate_polygon(line, allowed).size(), 3u);
  const std::vector<Point> nothing(5, Point(1, 1, 1));
  EXPECT_EQ(SMC::internal::triangulate_polygon(nothing, allowed).size(), 3u);
}

// The bow has one crossing, and comes to one corner twice: so it has as many places as corners.
TEST(Triangulation, a_polygon_whose_crossing_makes_up_for_a_double_corner_ends)
{
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  const std::vector<Point> bow = {Point(0, 1, 0), Point(2, 0, 0), Point(0, 0, 0), Point(1, 1, 0), Point(1, 1, 0)};
  EXPECT_TRUE(SMC::internal::delaunay_triangulation(bow).empty());
  EXPECT_EQ(SMC::internal::triangulate_polygon(bow, allowed).size(), 3u);
}

TEST(Triangulation, polygons_that_touch_themselves_have_no_delaunay_triangulation)
{
  // corner 3 lies on the side from 0 to 1, or on corner 0
  for(const Point& p : {Point(2, 0, 0), Point(0, 0, 0)})
    EXPECT_TRUE(
        SMC::internal::delaunay_triangulation({Point(0, 0, 0), Point(4, 0, 0), Point(4, 4, 0), p, Point(0, 4, 0)})
            .empty());
}

TEST(Triangulation, polygons_whose_normal_is_no_double_end)
{
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  const std::vector<Point> large = {Point(0, 0, 0), Point(1e200, 0, 0), Point(2e200, 1e200, 0), Point(1e200, 2e200, 0),
                                    Point(0, 1e200, 0)};
  EXPECT_TRUE(SMC::internal::delaunay_triangulation(large).empty());
  EXPECT_EQ(SMC::internal::triangulate_polygon(large, allowed).size(), 3u);
}

// The normal is a double, but its square is not. CGAL made an exact number of what is infinite, which ends a program.
TEST(Triangulation, polygons_whose_normal_has_no_square_end)
{
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  const std::vector<Point> large = {Point(1, 0, 0), Point(1, 0, 1), Point(0, 0, 0), Point(0, 1e308, 0), Point(1, 1, 0)};
  EXPECT_EQ(SMC::internal::delaunay_triangulation(large).size(), 3u);
  EXPECT_EQ(SMC::internal::triangulate_polygon(large, allowed).size(), 3u);
}

// Products of three and four coordinates would overflow, or be zero.
TEST(Triangulation, the_unit_of_a_polygon_does_not_matter)
{
  const auto allowed = [](std::size_t, std::size_t) { return true; };
  std::vector<Point> arrow = {Point(0, 0, 0), Point(4, -1, 0), Point(1, 0, 0), Point(4, 1, 0)}, hook = arrow;
  hook.insert(hook.begin() + 2, Point(2, 0, 0.5));
  for(const std::vector<Point>& polygon : {arrow, hook})
  {
    const auto triangles = SMC::internal::triangulate_polygon(polygon, allowed);
    for(int exponent : {-1000, -400, -40, 40, 400, 1000})
    {
      std::vector<Point> in_other_unit;
      for(const Point& p : polygon)
        in_other_unit.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                                   std::ldexp(p.z(), exponent));
      EXPECT_EQ(SMC::internal::triangulate_polygon(in_other_unit, allowed), triangles) << exponent;
    }
  }
  EXPECT_EQ(SMC::internal::triangulate_polygon(arrow, allowed)[0], (SMC::internal::Polygon_triangle{{0, 1, 2}}))
      << "the diagonal from the reflex corner";
}

} // namespace test_triangulation
