// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace test_refinement {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Progressive_mesh;
using SMC::Tightening_schedule;
typedef std::vector<std::size_t> Seeds;

Progressive_mesh simplified(const test_meshes::Mesh& mesh, std::vector<SMC::Seed_curve>& seeds)
{
  test_meshes::Mesh copy = mesh;
  const SMC::Collapse_record record = record_collapses::record_collapses(copy);
  Progressive_mesh pm = SMC::make_progressive_mesh(mesh, std::vector<SMC::Edge_collapse>());
  for(const SMC::Edge_collapse& c : record.collapses)
  {
    pm.append_collapse(c);
    SMC::non_face_triangles_at_vertex(pm, c.kept, std::back_inserter(seeds));
  }
  return pm;
}

// The face that the curve is in between two consecutive nodes, or null_index if they are no neighbours.
Index face_between(const Progressive_mesh& pm, const SMC::Closed_curve::Node& a, const SMC::Closed_curve::Node& b)
{
  if(a.is_pivot() && b.is_pivot())
  {
    const Index h = pm.halfedge(a.pivot, b.pivot);
    return h == SMC::null_index ? h : pm.face(h);
  }
  const Index f = a.is_pivot() ? pm.face(b.halfedge) : pm.face(pm.opposite(a.halfedge));
  if(!b.is_pivot())
    return pm.face(b.halfedge) == f ? f : SMC::null_index;
  for(Index h = 3 * f; h < 3 * f + 3; ++h)
    if(pm.source(h) == b.pivot)
      return f;
  return SMC::null_index;
}

// Checks every curve on every level on which it appears or changes.
struct Checker : public SMC::Refinement_visitor_base
{
  const Progressive_mesh* pm;
  std::size_t checked = 0;

  void expect_legal(const SMC::Closed_curve& c)
  {
    ++checked;
    ASSERT_TRUE(c.nodes.empty() || c.nodes.front().is_pivot());
    for(std::size_t i = 0; i < c.nodes.size(); ++i)
    {
      const auto &a = c.nodes[i], &b = c.nodes[(i + 1) % c.nodes.size()];
      if(a.is_pivot())
        ASSERT_TRUE(pm->is_vertex(a.pivot));
      else
        ASSERT_TRUE(pm->is_face(pm->face(a.halfedge)));
      ASSERT_NE(face_between(*pm, a, b), SMC::null_index);
    }
  }

  template <class Curve>
  void on_curve(std::size_t level, const Seeds& seeds, const Curve& curve)
  {
    EXPECT_EQ(level, pm->level());
    EXPECT_FALSE(seeds.empty());
    expect_legal(curve());
  }
};

class Refinement : public testing::TestWithParam<Tightening_schedule>
{};

TEST_P(Refinement, CurvesAreLegalOnEveryLevelAndEverySeedIsAccountedForOnce)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const test_meshes::Mesh mesh =
        test_meshes::make_mesh(seed % 2 == 0 ? test_meshes::dumbbell(0.1, seed) : test_meshes::torus(0.1, seed));
    std::vector<SMC::Seed_curve> seeds;
    Progressive_mesh pm = simplified(mesh, seeds);
    ASSERT_GT(seeds.size(), 3u);
    Checker checker;
    checker.pm = &pm;
    std::vector<SMC::Refined_curve> curves;
    SMC::refine_seed_curves(pm, seeds, GetParam(), std::back_inserter(curves), checker);
    EXPECT_EQ(pm.level(), 0u);
    EXPECT_GT(checker.checked, seeds.size());
    Seeds all;
    for(const SMC::Refined_curve& c : curves)
    {
      checker.expect_legal(c.curve);
      EXPECT_FALSE(c.seeds.empty());
      all.insert(all.end(), c.seeds.begin(), c.seeds.end());
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), seeds.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(all[i], i);
  }
}

TEST_P(Refinement, SeedsOfAnyLengthAreCarriedToTheInput)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 4));
  std::vector<SMC::Seed_curve> triangles;
  Progressive_mesh pm = simplified(mesh, triangles);
  pm.go_to_level(pm.number_of_collapses() / 2);
  // the paths around single vertices
  std::vector<SMC::Seed_curve> seeds;
  for(Index v = 0; v < pm.number_of_vertex_ids() && seeds.size() < 20; ++v)
  {
    if(!pm.is_vertex(v))
      continue;
    SMC::Seed_curve link = {pm.level(), {}, SMC::Seed_origin::USER};
    const Index begin = pm.outgoing(v);
    Index h = begin;
    do
    {
      link.vertices.push_back(pm.target(h));
      h = pm.ccw(h);
    } while(h != begin);
    if(link.vertices.size() > 4)
      seeds.push_back(link);
  }
  ASSERT_FALSE(seeds.empty());
  Checker checker;
  checker.pm = &pm;
  std::vector<SMC::Refined_curve> curves;
  SMC::refine_seed_curves(pm, seeds, GetParam(), std::back_inserter(curves), checker);
  std::size_t all = 0;
  for(const SMC::Refined_curve& c : curves)
    all += c.seeds.size();
  EXPECT_EQ(all, seeds.size());
}

TEST_P(Refinement, EqualSeedsAreMergedAtOnce)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 5));
  std::vector<SMC::Seed_curve> seeds;
  Progressive_mesh pm = simplified(mesh, seeds);
  const SMC::Seed_curve s = seeds.back();
  const std::vector<SMC::Seed_curve> twice = {s, {s.level, {s.vertices[2], s.vertices[1], s.vertices[0]}, s.origin}};
  std::vector<SMC::Refined_curve> curves;
  SMC::refine_seed_curves(pm, twice, GetParam(), std::back_inserter(curves));
  std::size_t alive = 0;
  for(const SMC::Refined_curve& c : curves)
    if(!c.curve.nodes.empty())
    {
      ++alive;
      EXPECT_EQ(c.seeds, (Seeds{0, 1}));
    }
  EXPECT_LE(alive, 1u);
}

TEST_P(Refinement, WithoutSeedsTheMeshIsRewound)
{
  std::vector<SMC::Seed_curve> seeds;
  Progressive_mesh pm = simplified(test_meshes::make_mesh(test_meshes::dumbbell(0.1, 6)), seeds);
  std::vector<SMC::Refined_curve> curves;
  SMC::refine_seed_curves(pm, std::vector<SMC::Seed_curve>(), GetParam(), std::back_inserter(curves));
  EXPECT_EQ(pm.level(), 0u);
  EXPECT_TRUE(curves.empty());
}

INSTANTIATE_TEST_SUITE_P(Schedules, Refinement,
                         testing::Values(Tightening_schedule::EVERY_LEVEL, Tightening_schedule::AT_THE_END));

} // namespace test_refinement
