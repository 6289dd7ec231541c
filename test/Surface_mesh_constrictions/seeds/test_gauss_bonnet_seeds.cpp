// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/shrinks_in_small_disc.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_gauss_bonnet_seeds {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::internal::shrinks_in_small_disc;
using test_meshes::Soup;

typedef std::vector<Index> Loop;

// Regular triangles around the z axis, one above the other, joined by bands, on a wide foot; corners of the last but one
// have the numbers from 3 on, and so on. The first triangle above the foot is the loop 0 1 2; towards the foot it is
// not convex.
Soup tower(std::vector<double> radii, bool with_top = true)
{
  radii.insert(radii.begin(), 10);
  Soup soup;
  const std::size_t n = radii.size(), foot = 3 * (n - 1), below = 3 * n;
  const auto corner = [foot](std::size_t i, std::size_t j) { return i == 0 ? foot + j % 3 : 3 * (i - 1) + j % 3; };
  soup.points.resize(below + 1);
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      const double angle = 2 * CGAL_PI * static_cast<double>(j) / 3;
      soup.points[corner(i, j)] = {
          {radii[i] * std::cos(angle), radii[i] * std::sin(angle), static_cast<double>(i) - 1}};
    }
  for(std::size_t i = 0; i + 1 < n; ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      soup.faces.push_back({{corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)}});
      soup.faces.push_back({{corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)}});
    }
  if(with_top)
    soup.faces.push_back({{corner(n - 1, 0), corner(n - 1, 1), corner(n - 1, 2)}});
  soup.points[below] = {{0, 0, -5}};
  for(std::size_t j = 0; j < 3; ++j)
    soup.faces.push_back({{corner(0, j + 1), corner(0, j), below}});
  return soup;
}

// The same with a point above the last triangle instead of a face.
Soup spire(const std::vector<double>& radii, double height)
{
  Soup soup = tower(radii, false);
  const std::size_t top = 3 * radii.size() - 3, tip = soup.points.size();
  soup.points.push_back({{0, 0, static_cast<double>(radii.size()) - 1 + height}});
  for(std::size_t j = 0; j < 3; ++j)
    soup.faces.push_back({{top + j, top + (j + 1) % 3, tip}});
  return soup;
}

bool shrinks(const Soup& soup, const Loop& loop = {0, 1, 2}, std::size_t most = 32)
{
  return shrinks_in_small_disc(test_meshes::make_progressive(soup), loop, most);
}

TEST(GaussBonnetSeeds, AroundOneVertexALoopShrinks)
{
  EXPECT_TRUE(shrinks(spire({1}, 0))); // flat
  EXPECT_TRUE(shrinks(spire({1}, 0.5)));
  EXPECT_TRUE(shrinks(spire({1}, 100))); // a needle: nearly 2 pi
}

TEST(GaussBonnetSeeds, AroundATowerALoopShrinksIfItGetsThinner)
{
  EXPECT_TRUE(shrinks(tower({1, 0.9})));
  EXPECT_TRUE(shrinks(tower({1, 0.9, 0.8, 0.7})));
  EXPECT_FALSE(shrinks(tower({1, 1})));   // the belt of a prism: 2 pi above it
  EXPECT_FALSE(shrinks(tower({1, 1.1}))); // it is not convex towards the top
}

TEST(GaussBonnetSeeds, BelowANeckALoopIsKept)
{
  // it gets shorter on the way up, but there is a neck, which holds it
  EXPECT_FALSE(shrinks(tower({1, 0.9, 1.2, 1.1})));
  EXPECT_FALSE(shrinks(spire({1, 0.9, 1.2, 1.1}, 1)));
  EXPECT_TRUE(shrinks(spire({1, 0.9, 0.85, 0.8}, 1)));
}

TEST(GaussBonnetSeeds, ALoopIsKeptIfTheDiscHasMoreFacesThanAreLookedAt)
{
  EXPECT_TRUE(shrinks(tower({1, 0.9}), {0, 1, 2}, 7));
  EXPECT_FALSE(shrinks(tower({1, 0.9}), {0, 1, 2}, 6));
}

TEST(GaussBonnetSeeds, TheStartAndTheDirectionOfALoopDoNotMatter)
{
  for(const Soup& soup : {tower({1, 0.9}), tower({1, 1.1}), tower({1, 0.9, 1.2, 1.1})})
  {
    const bool expected = shrinks(soup);
    for(const Loop& loop : {Loop{1, 2, 0}, Loop{2, 0, 1}, Loop{2, 1, 0}, Loop{0, 2, 1}})
      EXPECT_EQ(shrinks(soup, loop), expected);
  }
}

TEST(GaussBonnetSeeds, AroundAHoleALoopIsKept)
{
  const auto on_open_tower = [](bool with_top) {
    return shrinks_in_small_disc(SMC::make_progressive_mesh(test_meshes::make_mesh(tower({1, 0.9}, with_top)), {}),
                                 {0, 1, 2}, 32);
  };
  EXPECT_FALSE(on_open_tower(false));
  EXPECT_TRUE(on_open_tower(true));
}

TEST(GaussBonnetSeeds, OnATorusALoopAroundTheTubeIsKept)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::torus(0, 1, 5, 3));
  std::size_t kept = 0, all = 0;
  for(const SMC::Seed_curve& s : [&pm] {
        std::vector<SMC::Seed_curve> seeds;
        SMC::non_face_triangles(pm, std::back_inserter(seeds));
        return seeds;
      }())
  {
    ++all;
    kept += !shrinks_in_small_disc(pm, s.vertices, 100);
  }
  EXPECT_EQ(all, 5u); // the five sections of the tube
  EXPECT_EQ(kept, 5u);
}

// The collapses of the default simplification to the end.
SMC::Collapse_record simplified(const Soup& soup)
{
  SMC::Simplification_mesh mesh = test_meshes::make_graph<SMC::Simplification_mesh>(soup);
  const auto policies = SMC::Garland_heckbert_policies()(mesh);
  SMC::Collapse_record record;
  const auto vim = get(boost::vertex_index, mesh);
  CGAL::Surface_mesh_simplification::edge_collapse(
      mesh, [](const auto&, const auto&, auto, auto) { return false; },
      CGAL::parameters::get_cost(policies.get_cost())
          .get_placement(policies.get_placement())
          .visitor(SMC::Collapse_recording_visitor<std::decay_t<decltype(vim)>>(record, vim)));
  return record;
}

// Whether a closed path of edges, tightened on the current level, shortens to a point.
bool degenerates(const SMC::Progressive_mesh& pm, const Loop& loop)
{
  SMC::internal::Curve_network network(pm, false);
  SMC::internal::Tightener tightener(network, SMC::internal::Length_unit(pm));
  const Index c = network.add_curve(0, loop);
  tightener.enqueue_all(c);
  tightener.run();
  return network.is_empty(c);
}

TEST(GaussBonnetSeeds, WhatIsLeftOutShortensToAPointOnItsLevel)
{
  const std::vector<Soup> soups = {test_meshes::dumbbell(0.05, 1), test_meshes::chain_of_necks(0.03, 2),
                                   test_meshes::bottle(0.03, 3),   test_meshes::torus(0.05, 4),
                                   test_meshes::box(8, 6, 4),      test_meshes::boxes_with_tube(4),
                                   test_meshes::branches(2)};
  std::size_t left_out = 0, kept = 0;
  for(const Soup& soup : soups)
  {
    SMC::Progressive_mesh pm = test_meshes::make_progressive(soup);
    const SMC::Collapse_record record = simplified(soup);
    pm.append_collapses(record.collapses, [&](const SMC::Edge_collapse& c) {
      std::vector<SMC::Seed_curve> seeds;
      SMC::non_face_triangles_at_vertex(pm, c.kept, std::back_inserter(seeds));
      for(const SMC::Seed_curve& s : seeds)
        if(shrinks_in_small_disc(pm, s.vertices, 32))
        {
          ++left_out;
          EXPECT_TRUE(degenerates(pm, s.vertices)) << "level " << pm.level();
        }
        else
          ++kept;
      return true;
    });
  }
  EXPECT_GT(left_out, 100u);
  EXPECT_GT(kept, 10u);
}

TEST(GaussBonnetSeeds, OfAFinelyMeshedBoxHardlyASeedIsLeft)
{
  const Soup soup = test_meshes::box(30, 20, 10);
  SMC::Progressive_mesh pm = test_meshes::make_progressive(soup);
  const SMC::Collapse_record record = simplified(soup);
  SMC::Seed_level level = {pm.number_of_vertices(), record.collapses.size(), SMC::null_index, &record.refused_seeds};
  const SMC::Gauss_bonnet_seeds<SMC::Non_face_triangle_seeds> filtered(SMC::Non_face_triangle_seeds(), 0),
      on_fine_levels(SMC::Non_face_triangle_seeds(), 500);
  std::vector<SMC::Seed_curve> all, left, left_on_fine_levels;
  std::size_t coarse = 0;
  pm.append_collapses(record.collapses, [&](const SMC::Edge_collapse& c) {
    --level.vertices;
    level.merged = c.kept;
    SMC::Non_face_triangle_seeds()(pm, level, std::back_inserter(all));
    filtered(pm, level, std::back_inserter(left));
    on_fine_levels(pm, level, std::back_inserter(left_on_fine_levels));
    if(level.vertices < 500)
      SMC::Non_face_triangle_seeds()(pm, level,
                                     boost::make_function_output_iterator([&coarse](const auto&) { ++coarse; }));
    return true;
  });
  const std::size_t fine_left =
      static_cast<std::size_t>(std::count_if(left.begin(), left.end(), [&pm](const SMC::Seed_curve& s) {
        return pm.number_of_vertices() + pm.level() - s.level >= 500;
      }));
  EXPECT_EQ(left_on_fine_levels.size(), fine_left + coarse); // on coarse levels all
  EXPECT_GT(coarse, 10u);
  EXPECT_GT(all.size(), 500u);
  EXPECT_LT(left.size(), all.size() / 20);
  for(const SMC::Seed_curve& s : left) // the same seeds, in their order
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&s](const SMC::Seed_curve& t) {
      return t.level == s.level && t.vertices == s.vertices && t.origin == s.origin;
    }));
}

} // namespace test_gauss_bonnet_seeds
