// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/repair_fixture.h"

#include "input/pair_sides.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What becomes of files whose faces are no closed triangle mesh.
namespace test_repair {

using namespace repair_fixture;

TEST_F(Repair, leaves_a_closed_triangle_mesh_alone)
{
  const Mesh mesh = repaired(off(octahedron()));
  EXPECT_FALSE(record.findings.has_repairs());
  EXPECT_EQ(constrictions::summary_of(record.findings), "");
  EXPECT_TRUE(record.numbering.face.empty());
  EXPECT_EQ(record.numbering.faces, 8u);
}

TEST_F(Repair, polygons_keep_their_numbers)
{
  std::vector<Position> points;
  Faces faces;
  add_cube(0, 0, 0, points, faces);
  const Mesh mesh = repaired(off_of(points, faces));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_EQ(record.numbering.faces, 6u);
  EXPECT_EQ(count(Finding::TRIANGULATED), 6u);
  for(Mesh::Face_index f : mesh.faces())
  {
    EXPECT_TRUE(record.numbering.is_piece_of_polygon(f));
    const std::vector<int>& polygon = faces[record.numbering.face_of(f)];
    for(std::size_t v : corners(mesh, f))
      EXPECT_NE(std::find(polygon.begin(), polygon.end(), static_cast<int>(v)), polygon.end());
  }
  EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::volume(mesh), 1);
}

TEST_F(Repair, polygons_that_are_not_convex_are_cut_inside)
{
  // a prism over an L: the area is right only if no triangle lies outside of the L
  std::vector<Position> points;
  for(double z : {0., 1.})
    for(const std::array<double, 2>& p :
        std::vector<std::array<double, 2>>{{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1}}, {{1, 3}}, {{0, 3}}})
      points.push_back({{p[0], p[1], z}});
  Faces faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for(int i = 0; i < 6; ++i)
    faces.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  const Mesh mesh = repaired(off_of(points, faces));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::area(mesh), 2 * 5 + 12);
  EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::volume(mesh), 5);
}

TEST_F(Repair, no_diagonal_runs_beside_an_edge)
{
  // a quadrangle over two triangles that have one of its diagonals as their edge, whichever that is
  const std::vector<Position> points = {{{0, 0, 0}}, {{1, 0, 0.1}}, {{1, 1, 0}}, {{0, 1, 0.1}}};
  for(const Faces& faces : {Faces{{0, 1, 2, 3}, {0, 3, 1}, {1, 3, 2}}, Faces{{0, 1, 2, 3}, {0, 2, 1}, {0, 3, 2}}})
  {
    const Mesh mesh = repaired(off_of(points, faces));
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(mesh.number_of_faces(), 4u);
    EXPECT_EQ(constrictions::summary_of(record.findings), "1 polygon triangulated");
  }
}

TEST_F(Repair, duplicate_faces_are_left_out)
{
  Soup soup = octahedron();
  soup.triangles.push_back(soup.triangles[3]);
  std::rotate(soup.triangles.back().begin(), soup.triangles.back().begin() + 1, soup.triangles.back().end());
  soup.triangles.push_back({{soup.triangles[5][0], soup.triangles[5][2], soup.triangles[5][1]}}); // turned round
  const Mesh mesh = repaired(off(soup));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(count(Finding::DUPLICATE_FACES), 2u);
  EXPECT_EQ(record.numbering.triangle_at(8), record.numbering.triangle_at(3));
}

TEST_F(Repair, degenerate_faces_are_left_out)
{
  Soup soup = octahedron();
  soup.triangles.insert(soup.triangles.begin() + 2, {{1, 1, 4}});
  const Mesh mesh = repaired(off(soup));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(count(Finding::DEGENERATE_FACES), 1u);
  EXPECT_EQ(record.numbering.face_of(2), 3u);
  EXPECT_NE(record.numbering.triangle_at(2), CGAL::Surface_mesh_constrictions::null_index);
}

TEST_F(Repair, edges_of_length_zero_are_collapsed)
{
  // vertex 6 at the place of vertex 2, with two faces between
  Soup soup = octahedron();
  soup.points.push_back(soup.points[2]);
  soup.triangles[0][2] = soup.triangles[1][2] = 6;
  soup.triangles.push_back({{6, 0, 2}});
  soup.triangles.push_back({{3, 6, 2}});
  std::swap(soup.triangles[8][0], soup.triangles[8][1]);
  std::swap(soup.triangles[9][0], soup.triangles[9][1]);
  const Mesh mesh = repaired(off(soup));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(count(Finding::COLLAPSED_EDGES), 1u);
  EXPECT_EQ(count(Finding::DEGENERATE_FACES), 2u);
}

TEST_F(Repair, bodies_that_share_an_edge_stay_apart)
{
  for(bool is_inside_out : {false, true})
  {
    std::vector<Position> points;
    Faces faces;
    add_cube(0, 0, 0, points, faces);
    add_cube(1, 1, 0, points, faces); // along the edge x = y = 1
    merge_positions(points, faces);
    if(is_inside_out)
      for(std::vector<int>& f : faces)
        std::reverse(f.begin(), f.end());
    const Mesh mesh = repaired(off_of(points, faces));
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(components(mesh), 2u);
    EXPECT_EQ(count(Finding::SPLIT_EDGES), 1u);
    EXPECT_EQ(count(Finding::SPLIT_VERTICES), 2u);
    EXPECT_EQ(mesh.number_of_vertices(), 16u);
    EXPECT_EQ(record.numbering.vertices, 14u);
    for(Mesh::Vertex_index v : mesh.vertices())
      EXPECT_EQ(mesh.point(v), mesh.point(Mesh::Vertex_index(record.numbering.vertex_of(v))));
  }
}

TEST_F(Repair, bodies_that_share_a_vertex_or_a_wall_stay_apart)
{
  for(const Position& place : {Position{{1, 1, 1}}, Position{{1, 0, 0}}})
  {
    std::vector<Position> points;
    Faces faces;
    add_cube(0, 0, 0, points, faces);
    add_cube(place[0], place[1], place[2], points, faces);
    merge_positions(points, faces);
    const Mesh mesh = repaired(off_of(points, faces));
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(components(mesh), 2u);
    EXPECT_EQ(mesh.number_of_vertices(), 16u);
    EXPECT_EQ(mesh.number_of_faces(), 24u);
    EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::volume(mesh), 2);
  }
}

TEST_F(Repair, faces_of_unknown_orientation_at_a_shared_edge)
{
  // every subset of the faces of two cubes turned round; each cube is found again
  std::vector<Position> points;
  Faces faces;
  add_cube(0, 0, 0, points, faces);
  add_cube(1, 1, 0, points, faces);
  merge_positions(points, faces);
  std::mt19937 random(7);
  for(int i = 0; i < 200; ++i)
  {
    Faces turned = faces;
    for(std::vector<int>& f : turned)
      if(random() % 3 == 0)
        std::reverse(f.begin(), f.end());
    const Mesh mesh = repaired(off_of(points, turned));
    EXPECT_TRUE(CGAL::is_closed(mesh)) << i;
    EXPECT_EQ(mesh.number_of_faces(), 24u) << i;
  }
}

TEST_F(Repair, a_wing_at_an_edge_becomes_a_piece_of_its_own)
{
  Soup soup = octahedron();
  soup.points.push_back({{2, 2, 0}});
  soup.triangles.push_back({{0, 1, 6}});
  const Mesh mesh = repaired(off(soup));
  EXPECT_EQ(mesh.number_of_faces(), 9u);
  EXPECT_EQ(components(mesh), 2u);
  EXPECT_EQ(count(Finding::HOLES), 1u);
  EXPECT_EQ(count(Finding::BORDER_EDGES), 3u);
  EXPECT_TRUE(mesh.is_valid(false));
}

TEST_F(Repair, a_surface_that_is_written_with_both_sides_keeps_one)
{
  Soup soup = octahedron();
  const std::vector<Triangle> front = soup.triangles;
  for(const Triangle& t : front)
    soup.triangles.push_back({{t[0], t[2], t[1]}});
  const Mesh mesh = repaired(off(soup));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(count(Finding::DUPLICATE_FACES), 8u);
  EXPECT_FALSE(record.numbering.is_turned_round(0));
}

TEST_F(Repair, a_triangle_without_area_in_a_closed_surface_stays)
{
  // the edge between 0 and 1 has a vertex in its middle on one side, and a flat triangle closes the gap
  Soup soup = octahedron();
  soup.points.push_back({{0.5, 0.5, 0}});
  soup.triangles[0] = {{0, 6, 2}};
  soup.triangles.push_back({{6, 1, 2}});
  soup.triangles.push_back({{0, 1, 6}});
  const Mesh mesh = repaired(off(soup));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 10u);
  EXPECT_FALSE(record.findings.has_repairs());
  // without it vertex 6 is named
  soup.triangles.pop_back();
  const Mesh open = repaired(off(soup));
  EXPECT_FALSE(CGAL::is_closed(open));
  ASSERT_EQ(count(Finding::T_VERTICES), 1u);
  EXPECT_EQ(record.findings.places(Finding::T_VERTICES).front(), "vertex 6 lies on the edge between vertices 0 and 1");
}

TEST_F(Repair, holes_are_counted)
{
  Soup soup = octahedron();
  soup.triangles.erase(soup.triangles.begin() + 6);
  soup.triangles.erase(soup.triangles.begin());
  repaired(off(soup));
  EXPECT_EQ(count(Finding::HOLES), 2u);
  EXPECT_EQ(count(Finding::BORDER_EDGES), 6u);
  EXPECT_EQ(constrictions::summary_of(record.findings), "2 holes, 6 edges");
}

TEST_F(Repair, vertices_that_differ_in_the_last_digit)
{
  // each face with corners of its own, which are off by up to 0.00002
  std::mt19937 random(3);
  std::vector<Position> points;
  Faces faces;
  for(const Triangle& t : octahedron().triangles)
  {
    faces.push_back({});
    for(std::uint32_t v : t)
    {
      faces.back().push_back(static_cast<int>(points.size()));
      points.push_back(octahedron().points[v]);
      for(double& x : points.back())
        x += 1e-5 * (static_cast<double>(random() % 3) - 1);
    }
  }
  const std::string text = off_of(points, faces);
  try
  {
    repaired(text);
    ADD_FAILURE() << "no error";
  }
  catch(const Invalid_input& e)
  {
    EXPECT_EQ(e.defect(), Input_defect::NOT_CLOSED);
    expect_message(e.what(), {"not closed", "1e-05", "--merge "});
  }
  Reading reading;
  reading.merging_distance = record.findings.merging_distance;
  const Mesh mesh = repaired(text, reading);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_EQ(count(Finding::MERGED_VERTICES), 18u);
}

TEST_F(Repair, faces_with_corners_of_their_own_are_joined)
{
  std::vector<Position> points;
  Faces faces;
  for(const Triangle& t : octahedron().triangles)
  {
    faces.push_back({});
    for(std::uint32_t v : t)
    {
      faces.back().push_back(static_cast<int>(points.size()));
      points.push_back(octahedron().points[v]);
    }
  }
  const Mesh mesh = repaired(off_of(points, faces));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_EQ(count(Finding::MERGED_VERTICES), 18u);
}

TEST_F(Repair, a_strip_with_one_side_is_refused_also_if_its_faces_are_written_apart)
{
  const int n = 12;
  std::vector<Position> points;
  Faces faces;
  for(int i = 0; i < n; ++i)
    for(double across : {-1., 1.})
    {
      const double turn = CGAL_PI * i / n;
      const double r = 3 + across * std::cos(turn);
      points.push_back({{r * std::cos(2 * turn), r * std::sin(2 * turn), across * std::sin(turn)}});
    }
  for(int i = 0; i < n; ++i)
  {
    const int next = (2 * i + 2) % (2 * n), is_last = i + 1 == n;
    faces.push_back({2 * i, 2 * i + 1, next + is_last});
    faces.push_back({2 * i + 1, next + 1 - is_last, next + is_last});
  }
  for(bool is_apart : {false, true})
    try
    {
      if(is_apart)
        write_apart(points, faces);
      repaired(off_of(points, faces));
      ADD_FAILURE() << "no error";
    }
    catch(const Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), Input_defect::INCONSISTENT_ORIENTATION);
      expect_message(e.what(), {"cannot be oriented"});
    }
}

TEST_F(Repair, bodies_that_touch_stay_apart_when_their_faces_are_written_apart)
{
  // seams are closed all over the two bodies, and those of the edge that both have in pairs
  std::vector<Position> points;
  Faces faces;
  add_cube(0, 0, 0, points, faces);
  add_cube(1, 1, 0, points, faces);
  write_apart(points, faces);
  const Mesh mesh = repaired(off_of(points, faces));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(components(mesh), 2u);
  EXPECT_EQ(count(Finding::SPLIT_EDGES), 1u);
}

TEST_F(Repair, a_seam_that_shows_when_faces_are_left_out_is_closed)
{
  // the upper half twice, so that it has no border, and the lower half with vertices of its own
  Soup soup = octahedron();
  for(const Position& p : octahedron().points)
    soup.points.push_back(p);
  for(std::size_t t = 4; t < 8; ++t)
    for(std::uint32_t& v : soup.triangles[t])
      v += 6;
  for(std::size_t t = 0; t < 4; ++t)
    soup.triangles.push_back(Triangle(soup.triangles[t]));
  const Mesh mesh = repaired(off(soup));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(mesh.number_of_faces(), 8u);
  EXPECT_EQ(count(Finding::DUPLICATE_FACES), 4u);
  EXPECT_EQ(count(Finding::MERGED_VERTICES), 4u);
}

TEST_F(Repair, strict_refuses)
{
  Reading strict;
  strict.is_strict = true;
  std::vector<Position> points;
  Faces faces;
  add_cube(0, 0, 0, points, faces);
  const auto expect_refused = [&](Input_defect defect, const std::string& content, const std::string& part) {
    try
    {
      repaired(content, strict);
      ADD_FAILURE() << "no error, but expected: " << part;
    }
    catch(const Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), defect);
      expect_message(e.what(), {part, "--strict"});
    }
  };
  expect_refused(Input_defect::NOT_TRIANGULAR, off_of(points, faces), "face 0 has 4 vertices");
  Soup soup = octahedron();
  soup.triangles.push_back(soup.triangles[3]);
  expect_refused(Input_defect::NON_MANIFOLD_EDGE, off(soup), "face 8 has the same corners as face 3");
  soup.triangles.back() = {{1, 1, 4}};
  expect_refused(Input_defect::ZERO_LENGTH_EDGE, off(soup), "face 8");
  // what has always been mended
  Soup turned = octahedron();
  std::swap(turned.triangles[1][1], turned.triangles[1][2]);
  EXPECT_TRUE(CGAL::is_closed(repaired(off(turned), strict)));
}

TEST(Pair_sides, joins_across_the_inside)
{
  using namespace constrictions;
  // four quarter planes at the z axis, inside in the first and the third quadrant
  const Point u(0, 0, 0), v(0, 0, 1), x(1, 0, 0), y(0, 1, 0), minus_x(-1, 0, 0), minus_y(0, -1, 0);
  // in the first quadrant the inside begins at x, whose normal is -y: it runs back
  const std::vector<Side_at_edge> sides = {{0, false, x}, {1, true, y}, {2, false, minus_x}, {3, true, minus_y}};
  // both pairs, inside or outside, each without one of its pairs, and none
  ASSERT_EQ(ways_to_pair(u, v, sides, false).size(), 7u);
  EXPECT_TRUE(ways_to_pair(u, v, sides, false).back().empty());
  const auto pairs_of = [&](bool is_inside_out, std::size_t way) {
    std::set<std::set<Index>> result;
    const std::vector<std::vector<Side_pair>> ways = ways_to_pair(u, v, sides, is_inside_out);
    for(const Side_pair& p : ways.at(way))
      result.insert({p[0], p[1]});
    return result;
  };
  const std::set<std::set<Index>> inside = {{0, 1}, {2, 3}}, outside = {{1, 2}, {3, 0}};
  EXPECT_EQ(pairs_of(false, 0), inside);
  EXPECT_EQ(pairs_of(false, 1), outside);
  EXPECT_EQ(pairs_of(true, 0), outside);
}

} // namespace test_repair
