// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Face_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
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
SMC::Collapse_record simplified(const test_meshes::Mesh& mesh, const Block_simplification& in_blocks,
                                const Policies& policies)
{
  Imported copy = imported(mesh);
  return SMC::internal::simplify<CGAL::Sequential_tag>(copy, policies, true, false, in_blocks,
                                                       SMC::Detection_visitor_base());
}

SMC::Progressive_mesh progressive(const test_meshes::Mesh& mesh)
{
  Imported copy = imported(mesh);
  return SMC::Progressive_mesh(std::move(copy.table), std::move(copy.points));
}

Block_simplification no_blocks()
{
  Block_simplification result;
  result.whole_faces = std::numeric_limits<std::size_t>::max();
  return result;
}

// Rounds with many small blocks.
Block_simplification small_blocks()
{
  Block_simplification result;
  result.whole_faces = 300;
  result.block_faces = result.rest_faces = 64;
  return result;
}

std::vector<test_meshes::Soup> soups()
{
  return {test_meshes::torus(0.1, 1),
          test_meshes::chain_of_necks(0.05, 2),
          test_meshes::relabelled(test_meshes::torus(0.05, 3), 3),
          test_meshes::branches(3),
          test_meshes::joined(test_meshes::dumbbell(0.05, 4), test_meshes::torus(0.1, 5), 30),
          open_meshes::with_random_holes(test_meshes::torus(0.1, 6), 6, 6)};
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
    do
    {
      neighbours.insert(pm.target(k));
      k = pm.ccw(k);
    } while(k != h);
    std::size_t common = 0;
    const Index begin = k = pm.opposite(h);
    do
    {
      common += neighbours.count(pm.target(k));
      k = pm.ccw(k);
    } while(k != begin);
    ASSERT_EQ(common, 2u);
    pm.append_collapse(c);
  }
}

std::vector<Index> all_faces(const Imported& surface)
{
  std::vector<Index> faces(surface.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  return faces;
}

// The blocks of a surface without one of its faces, or of all of it, as sets of faces.
std::set<std::vector<Index>> blocks_without(const Imported& surface, std::optional<Index> left_out,
                                            std::size_t block_faces)
{
  std::vector<Index> faces = all_faces(surface);
  if(left_out)
    faces.erase(faces.begin() + *left_out);
  const SMC::internal::Halved_faces halved(surface.table, surface.points, faces, block_faces);
  std::set<std::vector<Index>> result;
  for(std::size_t b = 0; b + 1 < halved.first().size(); ++b)
  {
    const std::vector<Index> block(halved.order().begin() + halved.first()[b],
                                   halved.order().begin() + halved.first()[b + 1]);
    EXPECT_LE(block.size(), block_faces);
    result.insert(block);
  }
  return result;
}

TEST(BlockSimplification, WhereAFaceIsLeftOutTheOtherBlocksStayTheSame)
{
  std::size_t changed = 0, tries = 0;
  const Imported surface = imported(test_meshes::make_mesh(test_meshes::torus(0.05, 1, 200, 80)));
  const std::set<std::vector<Index>> whole = blocks_without(surface, std::nullopt, 1024);
  EXPECT_GE(whole.size(), 32u);
  for(Index f = 0; f < surface.table.halfedges.size() / 3; f += 1001)
  {
    ++tries;
    const std::set<std::vector<Index>> without = blocks_without(surface, f, 1024);
    for(const std::vector<Index>& block : whole)
      changed += without.count(block) == 0;
  }
  EXPECT_GE(changed, tries);         // the block that the face was in
  EXPECT_LE(changed, tries * 3 / 2); // seldom another one, where a median lies between two places of a cut
}

TEST(BlockSimplification, CollapsesKeepAManifoldAndGoOnToTheEnd)
{
  for(const test_meshes::Soup& soup : soups())
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const SMC::Collapse_record whole = simplified(mesh, no_blocks(), SMC::Garland_heckbert_policies());
    const SMC::Collapse_record blocks = simplified(mesh, small_blocks(), SMC::Garland_heckbert_policies());
    SMC::Progressive_mesh pm = progressive(mesh);
    expect_collapses_keep_a_manifold(pm, blocks.collapses);
    // where the last collapses are refused depends on their order, but not by much
    EXPECT_GT(blocks.collapses.size() + 20, whole.collapses.size());
  }
}

bool are_equal(const SMC::Collapse_record& a, const SMC::Collapse_record& b)
{
  return std::equal(a.collapses.begin(), a.collapses.end(), b.collapses.begin(), b.collapses.end(),
                    [](const SMC::Edge_collapse& c, const SMC::Edge_collapse& d) {
                      return c.removed == d.removed && c.kept == d.kept && c.point == d.point;
                    });
}

// Passes know the costs of Garland and Heckbert only.
TEST(BlockSimplification, WithOtherPoliciesAMeshIsSimplifiedAsAWhole)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 7));
  const auto expect_the_same = [&mesh](const auto& policies) {
    const SMC::Collapse_record record = simplified(mesh, small_blocks(), policies);
    EXPECT_TRUE(are_equal(record, simplified(mesh, no_blocks(), policies)));
    SMC::Progressive_mesh pm = progressive(mesh);
    expect_collapses_keep_a_manifold(pm, record.collapses);
    EXPECT_GT(record.collapses.size(), mesh.number_of_vertices() / 2);
  };
  expect_the_same(SMC::Lindstrom_turk_policies());
  expect_the_same(SMC::Edge_length_policies());
  const SMC::Garland_heckbert_policies passes;
  EXPECT_FALSE(are_equal(simplified(mesh, small_blocks(), passes), simplified(mesh, no_blocks(), passes)));
}

// How large a mesh must be to be divided says nothing of how far that goes on.
TEST(BlockSimplification, WhatIsLeftOfBlocksIsDividedUntilFewFacesAreLeft)
{
  const SMC::Garland_heckbert_policies policies;
  const Block_simplification sooner = small_blocks();
  Block_simplification later = sooner, not_so_far = sooner;
  later.whole_faces = 800;
  not_so_far.rest_faces = 800; // one round
  const test_meshes::Mesh large = test_meshes::make_mesh(test_meshes::torus(0.1, 6));
  ASSERT_GT(large.number_of_faces(), 800u);
  EXPECT_TRUE(are_equal(simplified(large, sooner, policies), simplified(large, later, policies)));
  EXPECT_FALSE(are_equal(simplified(large, sooner, policies), simplified(large, not_so_far, policies)));

  const test_meshes::Mesh small = test_meshes::make_mesh(test_meshes::torus(0.1, 6, 14, 10));
  ASSERT_LT(small.number_of_faces(), 300u);
  ASSERT_GT(small.number_of_faces(), 64u);
  EXPECT_TRUE(are_equal(simplified(small, sooner, policies), simplified(small, no_blocks(), policies)));
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
  const SMC::internal::Halved_faces halved(whole.table, whole.points, all_faces(whole), 100);
  std::vector<Index> faces = halved.order();
  for(std::size_t b = 0; b + 1 < halved.first().size(); ++b)
  {
    const auto begin = faces.begin() + halved.first()[b], end = faces.begin() + halved.first()[b + 1];
    EXPECT_LE(end - begin, 100);
    EXPECT_GE(end - begin, 50);
    EXPECT_TRUE(std::is_sorted(begin, end));
  }
  EXPECT_EQ(halved.first().back(), mesh.number_of_faces());
  std::sort(faces.begin(), faces.end());
  for(Index f = 0; f < faces.size(); ++f)
    EXPECT_EQ(faces[f], f);
  EXPECT_EQ(faces.size(), mesh.number_of_faces());
}

// Vertices of which all faces are in one block are inside it.
TEST(BlockSimplification, BlocksKnowTheirFacesAndTheVerticesInside)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.05, 8));
  const Imported whole = imported(mesh);
  const Index left_out = 17;
  std::vector<Index> faces = all_faces(whole);
  faces.erase(faces.begin() + left_out);
  const SMC::internal::Halved_faces halved(whole.table, whole.points, faces, 200);
  const SMC::internal::Face_blocks blocks(whole.table, halved.order(), halved.first());
  std::vector<std::set<std::size_t>> around(whole.points.size());
  for(Index b = 0; b < blocks.size(); ++b)
  {
    EXPECT_EQ(blocks.place(b, left_out), SMC::null_index);
    for(Index i = 0; i < blocks.number_of_faces(b); ++i)
    {
      const Index f = blocks.face(b, i);
      for(Index other = 0; other < blocks.size(); ++other)
        EXPECT_EQ(blocks.place(other, f), other == b ? i : SMC::null_index);
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        around[whole.table.halfedges[h].source].insert(b);
    }
  }
  for(Index h = 3 * left_out; h < 3 * left_out + 3; ++h)
    around[whole.table.halfedges[h].source].insert(blocks.size());
  std::size_t inside = 0;
  for(Index v = 0; v < around.size(); ++v)
  {
    EXPECT_EQ(blocks.block_of_vertex(v), around[v].size() == 1 ? *around[v].begin() : SMC::null_index);
    inside += around[v].size() == 1;
  }
  EXPECT_GT(inside, around.size() / 2);
}

// With an isolated vertex, which has no halfedge.
TEST(BlockSimplification, FacesInAnotherOrderAreTheSameFaces)
{
  test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::relabelled(test_meshes::torus(0.2, 4), 4));
  mesh.add_vertex({9, 9, 9});
  const Imported before = imported(mesh);
  Imported after = imported(mesh);
  std::vector<Index> order(before.table.halfedges.size() / 3);
  std::iota(order.rbegin(), order.rend(), Index(0));
  std::swap(order[3], order[20]);
  after.reorder_faces(order);
  ASSERT_EQ(after.table.halfedges.size(), before.table.halfedges.size());
  for(Index i = 0; i < 3 * order.size(); ++i)
  {
    const Index h = 3 * order[i / 3] + i % 3, o = before.table.halfedges[h].opposite;
    EXPECT_EQ(after.halfedge_of(i), before.halfedge_of(h));
    EXPECT_EQ(after.table.halfedges[i].source, before.table.halfedges[h].source);
    EXPECT_EQ(after.halfedge_of(after.table.halfedges[i].opposite), before.halfedge_of(o));
  }
  for(Index v = 0; v < before.points.size(); ++v)
  {
    if(before.table.outgoing[v] == SMC::null_index)
      EXPECT_EQ(after.table.outgoing[v], SMC::null_index);
    else
      EXPECT_EQ(after.halfedge_of(after.table.outgoing[v]), before.halfedge_of(before.table.outgoing[v]));
  }
}

// Several policies simplify the same mesh: the first puts its faces in order, and the next finds them so.
TEST(BlockSimplification, FacesAreInOrderAfterTheFirstTime)
{
  for(const test_meshes::Soup& soup : soups())
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    Imported whole = imported(mesh);
    const auto simplify = [&whole] {
      return SMC::internal::simplify<CGAL::Sequential_tag>(whole, SMC::Garland_heckbert_policies(), true, false,
                                                           small_blocks(), SMC::Detection_visitor_base());
    };
    const SMC::Collapse_record first = simplify();
    const SMC::internal::Corner_table table = whole.table;
    const Imported before = imported(mesh);
    std::size_t moved = 0;
    for(Index f = 0; f < whole.number_of_faces(); ++f)
      moved += whole.halfedge_of(3 * f) != before.halfedge_of(3 * f);
    EXPECT_GT(moved, whole.number_of_faces() / 2);
    const SMC::Collapse_record second = simplify();
    for(Index h = 0; h < table.halfedges.size(); ++h)
      EXPECT_EQ(whole.table.halfedges[h].source, table.halfedges[h].source);
    ASSERT_EQ(first.collapses.size(), second.collapses.size());
    for(std::size_t i = 0; i < first.collapses.size(); ++i)
    {
      EXPECT_EQ(first.collapses[i].removed, second.collapses[i].removed);
      EXPECT_EQ(first.collapses[i].point, second.collapses[i].point);
    }
  }
}

} // namespace test_block_simplification
