// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_bad_input {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Input_defect;
using test_meshes::Mesh;

template <class Function>
void expect_defect(Input_defect defect, std::size_t element, const std::vector<std::string>& parts, Function function)
{
  try
  {
    function();
    ADD_FAILURE() << "accepted";
  }
  catch(const SMC::Invalid_input& e)
  {
    const std::string message = e.what();
    EXPECT_EQ(e.defect(), defect) << message;
    EXPECT_EQ(e.element(), element) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    for(const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
}

std::vector<double> detect(const Mesh& mesh)
{
  std::vector<SMC::Constriction<Mesh>> curves;
  SMC::detect_constrictions(mesh, std::back_inserter(curves));
  std::vector<double> lengths;
  for(const auto& c : curves)
    lengths.push_back(c.length());
  return lengths;
}

void expect_mesh_defect(Input_defect defect, std::size_t element, const std::vector<std::string>& parts,
                        const Mesh& mesh)
{
  expect_defect(defect, element, parts, [&mesh]() { detect(mesh); });
}

void expect_table_defect(Input_defect defect, std::size_t element, const std::vector<std::string>& parts,
                         std::size_t vertices, const std::vector<Index>& corners)
{
  expect_defect(defect, element, parts, [&]() { SMC::internal::make_corner_table(vertices, corners); });
}

TEST(Bad_input, EmptyMesh) { expect_mesh_defect(Input_defect::EMPTY_MESH, 0, {"empty"}, Mesh()); }

// Where a closed surface is needed.
TEST(Bad_input, HoleNamesItsEdge)
{
  expect_table_defect(Input_defect::NOT_CLOSED, 0, {"not closed", "vertices 0 and 2", "face 0"}, 4,
                      {0, 2, 1, 0, 1, 3, 1, 2, 3});
}

// Surfaces that touch at a vertex are none, with holes or without.
TEST(Bad_input, VertexOfTwoHoles)
{
  // two triangles that share vertex 0, and a triangle at a vertex of a tetrahedron
  expect_mesh_defect(Input_defect::NON_MANIFOLD_VERTEX, 0, {"non-manifold vertex", "vertex 0"},
                     test_meshes::make_mesh({{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{-1, 0, 0}}, {{0, -1, 1}}},
                                             {{{0, 1, 2}}, {{0, 3, 4}}}}));
  for(bool with_border : {false, true})
    expect_defect(with_border ? Input_defect::NON_MANIFOLD_VERTEX : Input_defect::NOT_CLOSED, with_border ? 3 : 4, {},
                  [&] {
                    SMC::internal::make_corner_table(6, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 3, 4, 5}, with_border);
                  });
}

TEST(Bad_input, FaceOfFourCorners)
{
  CGAL::Polyhedron_3<test_meshes::Kernel> cube;
  CGAL::make_hexahedron(CGAL::Point_3<test_meshes::Kernel>(0, 0, 0), CGAL::Point_3<test_meshes::Kernel>(1, 0, 0),
                        CGAL::Point_3<test_meshes::Kernel>(1, 1, 0), CGAL::Point_3<test_meshes::Kernel>(0, 1, 0),
                        CGAL::Point_3<test_meshes::Kernel>(0, 1, 1), CGAL::Point_3<test_meshes::Kernel>(0, 0, 1),
                        CGAL::Point_3<test_meshes::Kernel>(1, 0, 1), CGAL::Point_3<test_meshes::Kernel>(1, 1, 1), cube);
  std::vector<SMC::Constriction<CGAL::Polyhedron_3<test_meshes::Kernel>>> out;
  expect_defect(Input_defect::NOT_TRIANGULAR, 0, {"face 0"},
                [&]() { SMC::detect_constrictions(cube, std::back_inserter(out)); });
}

TEST(Bad_input, CoordinatesThatAreNoNumbers)
{
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()})
  {
    test_meshes::Soup soup = test_meshes::box(2, 2, 2);
    soup.points[7][1] = bad;
    expect_mesh_defect(Input_defect::NON_FINITE_COORDINATE, 7, {"vertex 7", "y = "}, test_meshes::make_mesh(soup));
  }
}

TEST(Bad_input, CoordinatesOfWhichTheSquareOverflowsOrVanishes)
{
  for(double scale : {1e200, 1e-200})
  {
    const std::vector<double> lengths =
        detect(test_meshes::make_mesh(test_meshes::scaled(test_meshes::boxes_with_tube(2), scale)));
    ASSERT_EQ(lengths.size(), 1u);
    EXPECT_NEAR(lengths[0] / scale, 4, 1e-12);
  }
}

TEST(Bad_input, EdgeOfLengthZero)
{
  test_meshes::Soup soup = test_meshes::tetrahedron();
  soup.points[3] = soup.points[1];
  expect_mesh_defect(Input_defect::ZERO_LENGTH_EDGE, 1, {"length zero", "vertices 1 and 3", "face 1"},
                     test_meshes::make_mesh(soup));
}

TEST(Bad_input, VertexBetweenTwoFans)
{
  // two tetrahedra that share vertex 0
  expect_table_defect(Input_defect::NON_MANIFOLD_VERTEX, 0, {"non-manifold vertex", "vertex 0"}, 7,
                      {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 0, 5, 4, 0, 4, 6, 4, 5, 6, 0, 6, 5});
}

TEST(Bad_input, EdgeOfFourFaces)
{
  // two tetrahedra that share the edge between vertices 0 and 1
  expect_table_defect(Input_defect::NON_MANIFOLD_EDGE, 0, {"non-manifold edge", "vertices 1 and 0", "4 faces"}, 6,
                      {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 0, 4, 1, 0, 1, 5, 1, 4, 5, 0, 5, 4});
}

TEST(Bad_input, NeighboursOfOppositeOrientation)
{
  expect_table_defect(Input_defect::INCONSISTENT_ORIENTATION, 0, {"orientation", "face 0"}, 4,
                      {0, 2, 1, 0, 3, 1, 1, 2, 3, 0, 3, 2});
}

TEST(Bad_input, VertexThatDoesNotExist)
{
  expect_table_defect(Input_defect::INVALID_VERTEX_INDEX, 1, {"face 1", "vertex 9 of 4"}, 4,
                      {0, 2, 1, 0, 1, 9, 1, 2, 3, 0, 3, 2});
}

TEST(Bad_input, FaceThatUsesAVertexTwice)
{
  expect_table_defect(Input_defect::ZERO_LENGTH_EDGE, 1, {"face 1", "vertex 1 twice"}, 4,
                      {0, 2, 1, 0, 1, 1, 1, 2, 3, 0, 3, 2});
}

TEST(Good_input, FacesOfAreaZeroAreHandled)
{
  // the needle: the edge between vertices a and b of two faces gets a vertex in its middle on one side only
  const test_meshes::Soup soup = test_meshes::boxes_with_tube(3);
  test_meshes::Soup needles = soup;
  std::size_t made = 0;
  for(std::size_t f = 0; f < soup.faces.size(); f += 5)
  {
    const test_meshes::Triangle t = soup.faces[f];
    test_meshes::Position middle;
    for(std::size_t i = 0; i < 3; ++i)
      middle[i] = (soup.points[t[0]][i] + soup.points[t[1]][i]) / 2;
    const std::size_t m = needles.points.size();
    needles.points.push_back(middle);
    needles.faces[f] = {{t[0], m, t[2]}};
    needles.faces.push_back({{m, t[1], t[2]}});
    needles.faces.push_back({{t[0], t[1], m}}); // three points on a line
    ++made;
  }
  EXPECT_GT(made, 10u);
  const std::vector<double> lengths = detect(test_meshes::make_mesh(needles));
  ASSERT_EQ(lengths.size(), 1u);
  EXPECT_NEAR(lengths[0], 4, 1e-12);
}

TEST(Good_input, IsolatedVerticesAreIgnored)
{
  test_meshes::Soup soup = test_meshes::boxes_with_tube(3);
  soup.points.push_back({{100, 100, 100}});
  soup.points.insert(soup.points.begin(), {{0, 0, 0}});
  for(test_meshes::Triangle& t : soup.faces)
    for(std::size_t& v : t)
      ++v;
  const std::vector<double> lengths = detect(test_meshes::make_mesh(soup));
  ASSERT_EQ(lengths.size(), 1u);
  EXPECT_NEAR(lengths[0], 4, 1e-12);
}

TEST(Good_input, TheInputIsNotChanged)
{
  const Mesh before = test_meshes::make_mesh(test_meshes::torus(0.1, 1));
  const Mesh mesh = before;
  detect(mesh);
  ASSERT_EQ(mesh.num_faces(), before.num_faces());
  for(auto v : mesh.vertices())
    EXPECT_EQ(mesh.point(v), before.point(v));
  for(auto h : mesh.halfedges())
  {
    EXPECT_EQ(mesh.target(h), before.target(h));
    EXPECT_EQ(mesh.next(h), before.next(h));
  }
}

} // namespace test_bad_input
