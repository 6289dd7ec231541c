// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/carry_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/carry/Edge_paths.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossing_filter.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Homology_basis.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/merge_seed_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace test_seed_merging {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;

SMC::Progressive_mesh simplified(const test_meshes::Soup& soup)
{
  test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
  const test_meshes::Mesh input = mesh;
  return SMC::make_progressive_mesh(input, record_collapses::record_collapses(mesh).collapses);
}

std::vector<SMC::Seed_curve> cut_locus_loops(SMC::Progressive_mesh& pm, std::size_t level)
{
  pm.go_to_level(level);
  std::vector<SMC::Seed_curve> seeds;
  SMC::cut_locus_seeds(pm, std::back_inserter(seeds));
  return seeds;
}

std::vector<std::size_t> all_seeds(const std::vector<SMC::Merged_seed>& merged)
{
  std::vector<std::size_t> numbers;
  for(const SMC::Merged_seed& m : merged)
    numbers.insert(numbers.end(), m.seeds.begin(), m.seeds.end());
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(EdgePaths, StayClosedPathsOfEdgesAtEveryLevel)
{
  SMC::Progressive_mesh pm = simplified(test_meshes::torus(0.2, 2, 20, 12));
  std::vector<SMC::Seed_curve> seeds = cut_locus_loops(pm, pm.number_of_collapses() - 20);
  ASSERT_FALSE(seeds.empty());
  SMC::internal::Edge_paths paths(pm);
  for(const SMC::Seed_curve& s : seeds)
    paths.add(s.vertices);
  while(pm.level() > 0)
  {
    paths.split();
    for(std::size_t i = 0; i < paths.size(); ++i)
    {
      const std::vector<Index> path = paths.path(i);
      for(std::size_t j = 0; j < path.size(); ++j)
      {
        ASSERT_TRUE(pm.is_vertex(path[j]));
        ASSERT_NE(pm.halfedge(path[j], path[(j + 1) % path.size()]), SMC::null_index);
      }
    }
  }
}

TEST(MergeSeedCurves, HandsOnEverySeedOnceAndKeepsPathsOfEdges)
{
  SMC::Progressive_mesh pm = simplified(test_meshes::torus(0.2, 7, 20, 12));
  std::vector<SMC::Seed_curve> seeds = cut_locus_loops(pm, pm.number_of_collapses() - 30);
  const std::vector<SMC::Seed_curve> finer = cut_locus_loops(pm, 20);
  seeds.insert(seeds.begin(), finer.begin(), finer.begin() + 5);
  const std::size_t level = pm.number_of_collapses() - 80;
  std::vector<SMC::Merged_seed> merged;
  SMC::Merging_parameters parameters;
  parameters.kept = 3;
  SMC::merge_seed_curves(pm, seeds, level, parameters, std::back_inserter(merged));
  EXPECT_EQ(pm.level(), level);
  const std::vector<std::size_t> numbers = all_seeds(merged);
  ASSERT_EQ(numbers.size(), seeds.size());
  for(std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(numbers[i], i);
  EXPECT_LT(merged.size(), seeds.size());
  for(const SMC::Merged_seed& m : merged)
  {
    pm.go_to_level(m.curve.level);
    for(std::size_t i = 0; i < m.curve.vertices.size(); ++i)
      EXPECT_NE(pm.halfedge(m.curve.vertices[i], m.curve.vertices[(i + 1) % m.curve.vertices.size()]), SMC::null_index);
  }
}

// On the input seeds that meet give the same curve, so one of each is enough.
TEST(MergeSeedCurves, OnTheInputOneSeedIsKeptOfThoseThatMeet)
{
  SMC::Progressive_mesh pm = simplified(test_meshes::boxes_with_tube(4));
  std::vector<SMC::Seed_curve> seeds = cut_locus_loops(pm, 0);
  std::vector<SMC::Merged_seed> merged;
  SMC::merge_seed_curves(pm, seeds, 0, SMC::Merging_parameters(), std::back_inserter(merged));
  std::size_t living = 0;
  for(const SMC::Merged_seed& m : merged)
    living += !m.curve.vertices.empty();
  EXPECT_GT(living, 0u);
  EXPECT_LT(living, 20u); // the bands of the tube's four faces, and what crosses them
  EXPECT_EQ(all_seeds(merged).size(), seeds.size());
}

// Around the tube, around the hole, and around both: the last is composed of the other two, which it crosses. Of a mesh
// that has few curves it is kept, too.
TEST(MergeSeedCurves, WhatIsComposedOfShorterOnesIsKeptOnlyIfAskedForOrIfThereAreFew)
{
  SMC::Progressive_mesh pm = simplified(test_meshes::torus(0.2, 7, 20, 12));
  std::vector<SMC::Seed_curve> seeds = cut_locus_loops(pm, 0);
  const SMC::internal::Surface_cycles cycles(pm);
  const auto kept_classes = [&](bool crossing, std::size_t most_swept_faces = 0) {
    SMC::Merging_parameters parameters;
    parameters.minimum_prominence = 0.01;
    parameters.crossing = crossing;
    parameters.most_swept_faces = most_swept_faces;
    std::vector<SMC::Merged_seed> merged;
    SMC::merge_seed_curves(pm, seeds, 0, parameters, std::back_inserter(merged));
    EXPECT_EQ(all_seeds(merged).size(), seeds.size());
    std::set<std::vector<Index>> classes;
    for(const SMC::Merged_seed& m : merged)
      if(m.verdict == SMC::Merging_verdict::KEPT && !cycles.homology_class(m.curve.vertices).empty())
        classes.insert(cycles.homology_class(m.curve.vertices));
    return classes;
  };
  EXPECT_EQ(kept_classes(true).size(), 3u);
  EXPECT_EQ(kept_classes(false).size(), 2u);
  EXPECT_EQ(kept_classes(false, 1000000).size(), 3u);
  EXPECT_EQ(kept_classes(false, 1000).size(), 2u);
}

TEST(CrossingFilter, ACurveThatCrossesManyShorterOnesDoesNotPass)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(4));
  std::vector<SMC::internal::Trace_point> trace; // around a corner
  for(Index v : {pm.target(0), pm.target(pm.next(0)), pm.source(0)})
    trace.push_back({v, SMC::null_index, 0});
  const SMC::internal::Surface_sides sides(pm);
  SMC::internal::Crossing_filter filter(pm, sides);
  EXPECT_TRUE(filter.passes(0, trace, {}));
  EXPECT_TRUE(filter.passes(0, trace, std::vector<Index>(23, 0)));
  EXPECT_FALSE(filter.passes(0, trace, std::vector<Index>(24, 0)));
}

TEST(CrossingFilter, ACurveThatCrossesSomeFirmOnesDoesNotPass)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(4));
  std::vector<SMC::internal::Trace_point> trace; // around a corner
  for(Index v : {pm.target(0), pm.target(pm.next(0)), pm.source(0)})
    trace.push_back({v, SMC::null_index, 0});
  const SMC::internal::Surface_sides sides(pm);
  SMC::internal::Crossing_filter filter(pm, sides);
  for(Index i = 0; i < 8; ++i)
  {
    EXPECT_TRUE(filter.passes(i, trace, {}));
    filter.keep(i, trace, i < 6 ? 0.3 : 0.29);
  }
  EXPECT_TRUE(filter.passes(8, trace, {0, 1, 2, 3, 4, 6, 7}));
  EXPECT_FALSE(filter.passes(8, trace, {0, 1, 2, 3, 4, 5}));
}

// The path around the tube that goes forth along it and back beside is tightened to the same curve as the one that goes
// straight around, which has a third of its length and is asked for.
TEST(MergeSeedCurves, ASeedThatIsFarTooLongIsNotTightened)
{
  SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::dumbbell(0, 1, 36, 24));
  const auto ring = [](Index row, Index column) { return row * 24 + column % 24; };
  std::vector<SMC::Seed_curve> seeds(2, SMC::Seed_curve{0, {}, SMC::Seed_origin::USER});
  for(Index j = 0; j < 24; ++j)
    seeds[0].vertices.push_back(ring(18, j));
  for(Index j = 0; j < 24; ++j) // a comb of six teeth
  {
    const Index top = 26;
    if(j % 4 == 1)
      for(Index row = 18; row < top; ++row)
        seeds[1].vertices.push_back(ring(row, j));
    else if(j % 4 == 2)
      for(Index row = top; row-- > 18;)
        seeds[1].vertices.push_back(ring(row, j));
    else
      seeds[1].vertices.push_back(ring(18, j));
  }
  const auto verdicts = [&](double ratio) {
    SMC::Merging_parameters parameters;
    parameters.maximum_isoperimetric_ratio = ratio;
    std::vector<SMC::Merged_seed> merged;
    SMC::merge_seed_curves(pm, seeds, 0, parameters, std::back_inserter(merged));
    std::vector<SMC::Merging_verdict> result(2);
    for(const SMC::Merged_seed& m : merged)
      for(std::size_t i : m.seeds)
        result[i] = m.verdict;
    return result;
  };
  using SMC::Merging_verdict;
  EXPECT_EQ(verdicts(0.1), (std::vector<Merging_verdict>{Merging_verdict::KEPT, Merging_verdict::DISCARDED}));
  EXPECT_EQ(verdicts(10), (std::vector<Merging_verdict>{Merging_verdict::KEPT, Merging_verdict::KEPT}));
}

TEST(HomologyBasis, AClassIsTheSumOfThoseThatWereAdded)
{
  SMC::internal::Homology_basis basis;
  const auto add = [&](const std::vector<Index>& homology_class, std::size_t number) {
    SMC::internal::Homology_basis::Reduced reduced = basis.reduce(homology_class);
    ASSERT_FALSE(reduced.is_sum());
    basis.add(reduced, number);
  };
  add({1, 2}, 10);
  add({2, 3}, 11);
  add({4}, 12);
  EXPECT_FALSE(basis.reduce(std::vector<Index>{1}).is_sum());
  const auto sum = basis.reduce(std::vector<Index>{1, 3});
  EXPECT_TRUE(sum.is_sum());
  EXPECT_EQ(sum.members, (std::vector<std::size_t>{10, 11}));
  EXPECT_EQ(basis.reduce(std::vector<Index>{1, 2, 4}).members, (std::vector<std::size_t>{10, 12}));
}

TEST(CarrySeedCurves, HandsOnEverySeedOnceWithAndWithoutTighteningOnTheWay)
{
  for(const std::size_t tightening_vertices : {std::size_t(16384), std::size_t(150)})
  {
    SMC::Progressive_mesh pm = simplified(test_meshes::dumbbell(0.1, 3, 36, 24));
    std::vector<SMC::Seed_curve> seeds = cut_locus_loops(pm, pm.number_of_collapses() - 60);
    SMC::Carrying_parameters parameters;
    parameters.merging_vertices = 80;
    parameters.tightening_vertices = tightening_vertices;
    std::vector<SMC::Refined_curve> refined;
    SMC::Refinement_visitor_base visitor;
    SMC::carry_seed_curves(pm, seeds, parameters, std::back_inserter(refined), visitor);
    EXPECT_EQ(pm.level(), 0u);
    std::vector<std::size_t> numbers;
    bool is_one_alive = false;
    for(const SMC::Refined_curve& r : refined)
    {
      numbers.insert(numbers.end(), r.seeds.begin(), r.seeds.end());
      is_one_alive = is_one_alive || !r.curve.nodes.empty();
    }
    std::sort(numbers.begin(), numbers.end());
    ASSERT_EQ(numbers.size(), seeds.size());
    EXPECT_EQ(std::unique(numbers.begin(), numbers.end()), numbers.end());
    EXPECT_TRUE(is_one_alive);
  }
}

} // namespace test_seed_merging
