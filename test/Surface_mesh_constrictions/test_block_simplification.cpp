// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/internal/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace test_block_simplification {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::internal::Block_simplification;
typedef SMC::internal::Imported_mesh<test_meshes::Mesh> Imported;

Imported imported(const test_meshes::Mesh& mesh)
{
  return Imported(mesh, mesh.points(), get(boost::vertex_index, mesh));
}

template <class Policies>
SMC::Collapse_record simplified(const test_meshes::Mesh& mesh, const std::optional<Block_simplification>& in_blocks,
                                const Policies& policies)
{
  return SMC::internal::simplify<CGAL::Sequential_tag>(imported(mesh), policies, true, false, in_blocks,
                                                       SMC::Detection_visitor_base());
}

SMC::Progressive_mesh progressive(const test_meshes::Mesh& mesh)
{
  Imported copy = imported(mesh);
  return SMC::Progressive_mesh(std::move(copy.table), std::move(copy.points));
}

// Rounds with many small blocks.
Block_simplification small_blocks()
{
  Block_simplification result;
  result.whole_faces = 300;
  result.block_faces = 64;
  return result;
}

std::vector<test_meshes::Soup> soups()
{
  return {test_meshes::torus(0.1, 1), test_meshes::chain_of_necks(0.05, 2),
          test_meshes::relabelled(test_meshes::torus(0.05, 3), 3), test_meshes::branches(3),
          test_meshes::joined(test_meshes::dumbbell(0.05, 4), test_meshes::torus(0.1, 5), 30)};
}

// Applies the collapses one by one; each must be one of an edge whose ends share two neighbours, those opposite to it.
void expect_collapses_keep_a_manifold(SMC::Progressive_mesh& pm, const std::vector<SMC::Edge_collapse>& collapses)
{
  for(const SMC::Edge_collapse& c : collapses)
  {
    ASSERT_TRUE(pm.is_vertex(c.kept));
    ASSERT_TRUE(pm.is_vertex(c.removed));
    const Index h = pm.halfedge(c.removed, c.kept);
    ASSERT_NE(h, SMC::null_index);
    std::set<Index> neighbours;
    Index k = h;
    do {
      neighbours.insert(pm.target(k));
      k = pm.ccw(k);
    } while(k != h);
    std::size_t common = 0;
    const Index begin = k = pm.opposite(h);
    do {
      common += neighbours.count(pm.target(k));
      k = pm.ccw(k);
    } while(k != begin);
    ASSERT_EQ(common, 2u);
    pm.append_collapse(c);
  }
}

TEST(BlockSimplification, CollapsesKeepAManifoldAndGoOnToTheEnd)
{
  for(const test_meshes::Soup& soup : soups())
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const SMC::Collapse_record whole = simplified(mesh, std::nullopt, SMC::Garland_heckbert_policies());
    const SMC::Collapse_record blocks = simplified(mesh, small_blocks(), SMC::Garland_heckbert_policies());
    SMC::Progressive_mesh pm = progressive(mesh);
    expect_collapses_keep_a_manifold(pm, blocks.collapses);
    // where the last collapses are refused depends on their order, but not by much
    EXPECT_GT(blocks.collapses.size() + 20, whole.collapses.size());
  }
}

TEST(BlockSimplification, WorksWithAllPolicies)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 7));
  for(const SMC::Collapse_record& record : {simplified(mesh, small_blocks(), SMC::Lindstrom_turk_policies()),
                                            simplified(mesh, small_blocks(), SMC::Edge_length_policies())})
  {
    SMC::Progressive_mesh pm = progressive(mesh);
    expect_collapses_keep_a_manifold(pm, record.collapses);
    EXPECT_GT(record.collapses.size(), mesh.number_of_vertices() / 2);
  }
}

bool are_equal(const SMC::Collapse_record& a, const SMC::Collapse_record& b)
{
  return std::equal(a.collapses.begin(), a.collapses.end(), b.collapses.begin(), b.collapses.end(),
                    [](const SMC::Edge_collapse& c, const SMC::Edge_collapse& d) {
                      return c.removed == d.removed && c.kept == d.kept && c.point == d.point;
                    });
}

// How large a mesh must be to be divided says nothing of how far that goes on.
TEST(BlockSimplification, WhatIsLeftOfBlocksIsDividedDownToTheSizeOfABlock)
{
  const SMC::Garland_heckbert_policies policies;
  const Block_simplification sooner = small_blocks();
  Block_simplification later = sooner, as_one = sooner;
  later.whole_faces = 800;
  as_one.block_faces = 300;
  const test_meshes::Mesh large = test_meshes::make_mesh(test_meshes::torus(0.1, 6));
  ASSERT_GT(large.number_of_faces(), 800u);
  EXPECT_TRUE(are_equal(simplified(large, sooner, policies), simplified(large, later, policies)));
  EXPECT_FALSE(are_equal(simplified(large, sooner, policies), simplified(large, as_one, policies)));

  const test_meshes::Mesh small = test_meshes::make_mesh(test_meshes::torus(0.1, 6, 14, 10));
  ASSERT_LT(small.number_of_faces(), 300u);
  ASSERT_GT(small.number_of_faces(), 64u);
  EXPECT_TRUE(are_equal(simplified(small, sooner, policies), simplified(small, std::nullopt, policies)));
}

TEST(BlockSimplification, RefusedSeedsAreClosedPathsOnTheirLevels)
{
  for(const test_meshes::Soup& soup : soups())
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const SMC::Collapse_record record = simplified(mesh, small_blocks(), SMC::Garland_heckbert_policies());
    EXPECT_TRUE(std::is_sorted(record.refused_seeds.begin(), record.refused_seeds.end(),
                               [](const SMC::Seed_curve& a, const SMC::Seed_curve& b) { return a.level < b.level; }));
    SMC::Progressive_mesh pm = progressive(mesh);
    for(const SMC::Edge_collapse& c : record.collapses)
      pm.append_collapse(c);
    for(const SMC::Seed_curve& s : record.refused_seeds)
    {
      pm.go_to_level(s.level);
      for(std::size_t i = 0; i < s.vertices.size(); ++i)
      {
        ASSERT_TRUE(pm.is_vertex(s.vertices[i]));
        ASSERT_NE(pm.halfedge(s.vertices[i], s.vertices[(i + 1) % s.vertices.size()]), SMC::null_index);
      }
    }
  }
}

TEST(BlockSimplification, BlocksHaveEachFaceOnceAndAreOfEqualSize)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.05, 8));
  const Imported whole = imported(mesh);
  const SMC::internal::Face_blocks blocks(whole.table, whole.points, 100);
  std::vector<int> seen(mesh.number_of_faces(), 0);
  for(std::size_t b = 0; b < blocks.size(); ++b)
  {
    EXPECT_LE(blocks.faces(b).size(), 100u);
    EXPECT_GE(blocks.faces(b).size(), 50u);
    for(Index f : blocks.faces(b))
    {
      ++seen[f];
      EXPECT_EQ(blocks.block_of_face(f), b);
      EXPECT_EQ(blocks.faces(b)[blocks.position(f)], f);
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

// Two fans of faces of a block that meet in one vertex at its border: what is around the vertex is found from each.
TEST(BlockSimplification, FansAtABorderVertexAreLinked)
{
  SMC::internal::Corner_table table;
  for(Index v : {0, 1, 2, 0, 3, 4})
    table.halfedges.push_back({v, SMC::null_index});
  table.outgoing = {0, 1, 2, 4, 5};
  const std::vector<test_meshes::Mesh::Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  test_meshes::Mesh mesh;
  SMC::internal::surface_mesh_from_corner_table(table, points, mesh);
  EXPECT_TRUE(mesh.is_valid(true));
  std::set<std::size_t> neighbours;
  for(auto v : vertices_around_target(mesh.halfedge(test_meshes::Mesh::Vertex_index(0)), mesh))
    neighbours.insert(v);
  EXPECT_EQ(neighbours, (std::set<std::size_t>{1, 2, 3, 4}));
}

} // namespace test_block_simplification
