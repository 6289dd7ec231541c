// SPDX-License-Identifier: GPL-3.0-or-later

// The package's parameters, included before anything of CGAL's; the other order is in parameters_after_cgal.cpp.

#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include "include/chained_parameters.h"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace parameters_after_cgal {

void expect_any_order();

}

namespace test_parameters {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

Mesh tetrahedron()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(6, 0, 0), Point(0, 6, 0), Point(0, 0, 6), mesh);
  return mesh;
}

TEST(Parameters, AreChainedInAnyOrder) { chained_parameters::expect_any_order(); }

TEST(Parameters, AreChainedWithHeadersInTheOtherOrder) { parameters_after_cgal::expect_any_order(); }

TEST(Parameters, AreTakenByFunctionsOfCgal)
{
  Mesh mesh = tetrahedron();
  auto [scaled, created] = mesh.add_property_map<Mesh::Vertex_index, Point>("v:scaled");
  ASSERT_TRUE(created);
  for(Mesh::Vertex_index v : mesh.vertices())
    scaled[v] = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  auto [index, is_new] = mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:reversed");
  ASSERT_TRUE(is_new);
  for(Mesh::Vertex_index v : mesh.vertices())
    index[v] = mesh.number_of_vertices() - 1 - v;

  const auto np = CGAL::parameters::certify(false).vertex_point_map(scaled).vertex_index_map(index).with_caps(true);
  EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::volume(mesh, np), 8 * CGAL::Polygon_mesh_processing::volume(mesh));
  const auto vim = CGAL::get_initialized_vertex_index_map(mesh, np);
  EXPECT_EQ(get(vim, *vertices(mesh).begin()), 3u);

  Mesh copy;
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> faces;
  CGAL::copy_face_graph(mesh, copy, np.face_to_face_output_iterator(std::back_inserter(faces)));
  EXPECT_EQ(faces.size(), 4u);
  EXPECT_DOUBLE_EQ(CGAL::Polygon_mesh_processing::volume(copy), 8 * CGAL::Polygon_mesh_processing::volume(mesh));
}

// CGAL's type of the same parameters is the base: what was compiled for it takes the chain.
TEST(Parameters, AreOfCgalsType)
{
  typedef CGAL::Named_function_parameters<bool, CGAL::internal_np::certify_t> Certify;
  typedef CGAL::Named_function_parameters<int, CGAL::internal_np::visitor_t, Certify> Visitor;
  const auto np = CGAL::parameters::certify(false).visitor(7);
  static_assert(std::is_base_of_v<Visitor, std::decay_t<decltype(np)>>);
  const Visitor& cgal = np;
  EXPECT_EQ(CGAL::parameters::get_parameter(cgal, CGAL::internal_np::visitor), 7);
  EXPECT_FALSE(CGAL::parameters::get_parameter(cgal, CGAL::internal_np::certify));
}

TEST(Parameters, AreReferredTo)
{
  int value = 1;
  const auto np = CGAL::parameters::certify(false).visitor(std::ref(value)).with_caps(true);
  CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor) = 2;
  EXPECT_EQ(value, 2);
}

namespace names {

using namespace CGAL;
using namespace CGAL::Surface_mesh_constrictions;

// Both namespaces are one, so the name is not ambiguous.
TEST(Parameters, HaveOneNamespace)
{
  const auto np = parameters::with_caps(false).visitor(7);
  EXPECT_FALSE(parameters::get_parameter(np, CGAL::internal_np::with_caps));
  static_assert(std::is_same_v<decltype(Surface_mesh_constrictions::parameters::certify(true).visitor(1)),
                               decltype(CGAL::parameters::certify(true).visitor(1))>);
}

} // namespace names
} // namespace test_parameters
