// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh that is simplified: a face graph, and the same to edge_collapse() as CGAL's Surface_mesh.

#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/concept/assert.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <unordered_set>
#include <vector>

namespace test_simplification_mesh {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef SMC::Simplification_mesh Mesh;

BOOST_CONCEPT_ASSERT((boost::GraphConcept<Mesh>));
BOOST_CONCEPT_ASSERT((CGAL::MutableHalfedgeGraphConcept<Mesh>));
BOOST_CONCEPT_ASSERT((CGAL::MutableFaceGraphConcept<Mesh>));
BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Mesh>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Mesh>));

template <class Range>
std::vector<SMC::Index> numbers(const Range& range)
{
  return std::vector<SMC::Index>(range.begin(), range.end());
}

// A tetrahedron on which a corner is put: vertex 4 inside face 0 1 2.
Mesh five_vertices()
{
  test_meshes::Soup soup;
  soup.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, -1}}, {{0.3, 0.3, 0.5}}};
  soup.faces = {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 0, 4}}, {{1, 0, 3}}, {{2, 1, 3}}, {{0, 2, 3}}};
  return test_meshes::make_graph<Mesh>(soup);
}

TEST(SimplificationMesh, IsAPolygonMesh)
{
  const Mesh mesh = five_vertices();
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(numbers(vertices(mesh)), (std::vector<SMC::Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(num_vertices(mesh), 5u);
  EXPECT_EQ(num_halfedges(mesh), 18u);
  EXPECT_EQ(num_edges(mesh), 9u);
  EXPECT_EQ(num_faces(mesh), 6u);
  EXPECT_EQ(degree(Mesh::Vertex_index(4), mesh), 3u);
  EXPECT_EQ(degree(Mesh::Vertex_index(0), mesh), 4u);
  EXPECT_EQ(degree(Mesh::Face_index(0), mesh), 3u);
  EXPECT_EQ(get(CGAL::vertex_point, mesh, Mesh::Vertex_index(1)), Mesh::Point(1, 0, 0));

  const auto there = edge(Mesh::Vertex_index(0), Mesh::Vertex_index(4), mesh);
  ASSERT_TRUE(there.second);
  EXPECT_EQ(source(there.first, mesh) + target(there.first, mesh), 4u);
  EXPECT_FALSE(edge(Mesh::Vertex_index(3), Mesh::Vertex_index(4), mesh).second);
  EXPECT_EQ(std::unordered_set<Mesh::Vertex_index>(vertices(mesh).begin(), vertices(mesh).end()).size(), 5u);
}

TEST(SimplificationMesh, RemovedElementsAreSkippedInBothDirections)
{
  Mesh mesh = five_vertices();
  const auto collapsed = edge(Mesh::Vertex_index(4), Mesh::Vertex_index(0), mesh);
  ASSERT_TRUE(collapsed.second);
  const Mesh::Vertex_index kept = CGAL::Euler::collapse_edge(collapsed.first, mesh);
  EXPECT_TRUE(kept == Mesh::Vertex_index(0) || kept == Mesh::Vertex_index(4));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(num_vertices(mesh), 5u);
  EXPECT_EQ(vertices(mesh).size(), 4u);
  EXPECT_EQ(halfedges(mesh).size(), 12u);
  EXPECT_EQ(edges(mesh).size(), 6u);
  EXPECT_EQ(faces(mesh).size(), 4u);
  for(const auto f : faces(mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      EXPECT_EQ(face(h, mesh), f);

  const std::vector<SMC::Index> there = numbers(halfedges(mesh));
  std::vector<SMC::Index> back;
  for(auto it = halfedges(mesh).end(); it != halfedges(mesh).begin();)
    back.push_back(*--it);
  EXPECT_EQ(back, std::vector<SMC::Index>(there.rbegin(), there.rend()));
}

template <class Graph>
SMC::Collapse_record collapses(Graph graph)
{
  return record_collapses::record_collapses(graph, SMS::LindstromTurk_cost<Graph>(),
                                            SMS::LindstromTurk_placement<Graph>(), get(CGAL::vertex_point, graph));
}

void expect_same_collapses(const Mesh& ours, const test_meshes::Mesh& theirs)
{
  const SMC::Collapse_record record = collapses(ours);
  EXPECT_GE(record.collapses.size(), 90u);
  record_collapses::expect_same(record, collapses(theirs));
}

// The sets of edges around a collapse give them in the same order.
TEST(SimplificationMesh, CollapsesLikeASurfaceMesh)
{
  for(const test_meshes::Soup& soup : {test_meshes::torus(0.1, 5), test_meshes::box(7, 5, 4)})
    expect_same_collapses(test_meshes::make_graph<Mesh>(soup), test_meshes::make_mesh(soup));
  expect_same_collapses(test_meshes::torus_with_border<Mesh>(), test_meshes::torus_with_border<test_meshes::Mesh>());
}

// edge_collapse() takes edges out of the set of those of length zero while it goes through it.
TEST(SimplificationMesh, EdgesOfLengthZeroCollapseLikeThoseOfASurfaceMesh)
{
  test_meshes::Soup soup = test_meshes::torus(0.1, 5);
  for(std::size_t f = 0; f + 8 < soup.faces.size(); f += 8)
    soup.points[soup.faces[f][0]] = soup.points[soup.faces[f][1]] = soup.points[soup.faces[f][2]];
  expect_same_collapses(test_meshes::make_graph<Mesh>(soup), test_meshes::make_mesh(soup));
}

} // namespace test_simplification_mesh
