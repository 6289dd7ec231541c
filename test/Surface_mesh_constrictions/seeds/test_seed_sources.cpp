// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/random_hull.h"
#include "include/statistics_taker.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Sections.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/find_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Shortest_path_tree.h>
#include <CGAL/Surface_mesh_constrictions/section_seeds.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace test_seed_sources {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Seed_curve;
using SMC::Seed_origin;
using statistics_taker::Statistics_taker;

void expect_closed_path(const SMC::Progressive_mesh& pm, const Seed_curve& seed)
{
  ASSERT_EQ(seed.level, pm.level());
  ASSERT_GE(seed.vertices.size(), 3u);
  for(std::size_t i = 0; i < seed.vertices.size(); ++i)
    ASSERT_NE(pm.halfedge(seed.vertices[i], seed.vertices[(i + 1) % seed.vertices.size()]), SMC::null_index);
}

double edge_length(const SMC::Progressive_mesh& pm, Index u, Index v)
{
  return std::sqrt(CGAL::squared_distance(pm.point(u), pm.point(v)));
}

double length(const SMC::Progressive_mesh& pm, const std::vector<Index>& loop)
{
  double sum = 0;
  for(std::size_t i = 0; i < loop.size(); ++i)
    sum += edge_length(pm, loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

std::vector<Seed_curve> loops_at(const SMC::Progressive_mesh& pm, Index root)
{
  std::vector<Seed_curve> seeds;
  SMC::cut_locus_seeds_at_vertex(pm, root, std::back_inserter(seeds));
  return seeds;
}

// By Bellman and Ford.
std::vector<double> distances(const SMC::Progressive_mesh& pm, Index root)
{
  std::vector<double> d(pm.number_of_vertex_ids(), (std::numeric_limits<double>::infinity)());
  d[root] = 0;
  for(bool changed = true; changed;)
  {
    changed = false;
    for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
    {
      const double via = d[pm.source(h)] + edge_length(pm, pm.source(h), pm.target(h));
      if(via < d[pm.target(h)])
      {
        d[pm.target(h)] = via;
        changed = true;
      }
    }
  }
  return d;
}

TEST(CutLocusSeeds, EachLoopIsTwoShortestPathsFromTheRootAndAnEdge)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::torus(0.2, 3, 9, 6));
  std::size_t loops = 0;
  for(Index root = 0; root < pm.number_of_vertex_ids(); ++root)
  {
    const std::vector<double> d = distances(pm, root);
    for(const Seed_curve& seed : loops_at(pm, root))
    {
      expect_closed_path(pm, seed);
      EXPECT_EQ(seed.origin, Seed_origin::CUT_LOCUS);
      std::vector<Index> loop = seed.vertices;
      ASSERT_EQ(std::count(loop.begin(), loop.end(), root), 1);
      std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), root), loop.end());
      // some edge of the loop closes it: the distances of its ends and its length add up to the length of the loop
      const double total = length(pm, loop);
      bool closes = false;
      for(std::size_t i = 1; i + 1 < loop.size(); ++i)
      {
        const double closed = d[loop[i]] + edge_length(pm, loop[i], loop[i + 1]) + d[loop[i + 1]];
        closes = closes || std::abs(closed - total) < 1e-12 * total;
      }
      EXPECT_TRUE(closes);
      EXPECT_EQ(std::set<Index>(loop.begin(), loop.end()).size(), loop.size());
      ++loops;
    }
  }
  EXPECT_GT(loops, pm.number_of_vertex_ids());
}

TEST(CutLocusSeeds, TheLoopAroundATubeIsFoundFromEachOfItsVertices)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(4));
  std::size_t on_tube = 0;
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
  {
    if(pm.point(v).x() != 4)
      continue;
    ++on_tube;
    const std::vector<Seed_curve> seeds = loops_at(pm, v);
    EXPECT_TRUE(std::any_of(seeds.begin(), seeds.end(), [&](const Seed_curve& s) {
      return s.vertices.size() == 4 &&
             std::all_of(s.vertices.begin(), s.vertices.end(), [&](Index u) { return pm.point(u).x() == 4; });
    }));
  }
  EXPECT_EQ(on_tube, 4u);
}

// Two loops of a root whose closing edges are two apart along the cut locus differ by the course of the edges only.
TEST(CutLocusSeeds, OfLoopsThatCloseAFewEdgesApartTheShortestIsASeed)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::torus(0.2, 3, 30, 20));
  const SMC::internal::Edge_graph graph(pm);
  SMC::internal::Shortest_path_tree tree(graph);
  const std::vector<SMC::internal::Edge_graph::Edge>& edges = graph.edges();
  const double infinity = std::numeric_limits<double>::infinity();
  for(Index root = 0; root < graph.number_of_vertices(); ++root)
  {
    tree.grow(root);
    std::vector<double> loop_of; // length of the loop that an edge closes, by edge
    for(const auto& e : edges)
    {
      const Index u = tree.branch(e.ends[0]), v = tree.branch(e.ends[1]);
      const bool closes = u != v && u != SMC::null_index && v != SMC::null_index;
      loop_of.push_back(closes ? tree.distance(e.ends[0]) + e.length + tree.distance(e.ends[1]) : infinity);
    }
    for(const Seed_curve& seed : loops_at(pm, graph.id(root)))
    {
      const double total = length(pm, seed.vertices);
      for(std::size_t e = 0; e < edges.size(); ++e)
      {
        std::set<Index> loop(seed.vertices.begin(), seed.vertices.end());
        if(std::abs(loop_of[e] - total) > 1e-12 * total || loop.count(graph.id(edges[e].ends[0])) == 0 ||
           loop.count(graph.id(edges[e].ends[1])) == 0)
          continue;
        for(Index next : edges[e].around)
          if(loop_of[next] < infinity)
            for(Index second : edges[next].around)
            {
              const bool is_at_root = edges[second].apexes[0] == root || edges[second].apexes[1] == root;
              EXPECT_TRUE(is_at_root || loop_of[second] >= total * (1 - 1e-12));
            }
      }
    }
  }
}

TEST(CutLocusSeeds, ALoopThatBoundsAFaceIsNotASeed)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::tetrahedron());
  for(Index root = 0; root < 4; ++root)
    EXPECT_TRUE(loops_at(pm, root).empty());
}

TEST(CutLocusSeeds, AllRootsTogetherGiveEachLoopOnceAndTheUnionOfTheRoots)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::dumbbell(0.1, 5, 10, 7));
  std::set<std::vector<Index>> by_root;
  for(Index root = 0; root < pm.number_of_vertex_ids(); ++root)
    for(const Seed_curve& s : loops_at(pm, root))
      by_root.insert(s.vertices);
  std::vector<Seed_curve> seeds;
  SMC::cut_locus_seeds(pm, std::back_inserter(seeds));
  std::set<std::vector<Index>> together;
  for(const Seed_curve& s : seeds)
    EXPECT_TRUE(together.insert(s.vertices).second);
  EXPECT_EQ(together, by_root);
}

TEST(CutLocusSeeds, FewerRootsGiveASubset)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::torus(0.2, 1, 12, 7));
  std::set<std::vector<Index>> all;
  std::vector<Seed_curve> seeds, fewer;
  SMC::cut_locus_seeds(pm, std::back_inserter(seeds));
  for(const Seed_curve& s : seeds)
    all.insert(s.vertices);
  SMC::cut_locus_seeds(pm, std::back_inserter(fewer), 10);
  EXPECT_LT(fewer.size(), seeds.size());
  EXPECT_FALSE(fewer.empty());
  for(const Seed_curve& s : fewer)
    EXPECT_EQ(all.count(s.vertices), 1u);
}

TEST(SectionSeeds, PlanesAndDistancesCutATubeAround)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(6));
  for(const bool by_planes : {true, false})
  {
    std::vector<Seed_curve> seeds;
    if(by_planes)
      SMC::plane_section_seeds(pm, std::back_inserter(seeds));
    else
      SMC::distance_section_seeds(pm, std::back_inserter(seeds));
    std::set<std::vector<Index>> distinct;
    bool around = false;
    for(const Seed_curve& s : seeds)
    {
      expect_closed_path(pm, s);
      EXPECT_EQ(s.origin, Seed_origin::SECTION);
      EXPECT_TRUE(distinct.insert(s.vertices).second);
      around = around || std::all_of(s.vertices.begin(), s.vertices.end(), [&](Index v) {
                 return pm.point(v).x() >= 2 && pm.point(v).x() <= 8 && std::abs(pm.point(v).y() - 1.5) <= 0.5 &&
                        std::abs(pm.point(v).z() - 1.5) <= 0.5;
               });
    }
    EXPECT_TRUE(around);
  }
}

// Four necks at the heights 2, 4, 6 and 8, and the bulges between them: of the sections across the axis those are given
// that lie where the radius hardly changes, at each neck one at least, and each seventh level; none else on the flanks.
TEST(SectionSeeds, AlongATubeTheShortestAroundAndEachSeventhLevelAreGiven)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::chain_of_necks(0, 1));
  const SMC::internal::Edge_graph graph(pm);
  std::vector<double> heights;
  for(Index v = 0; v < graph.number_of_vertices(); ++v)
    heights.push_back(pm.point(graph.id(v)).z());
  const double low = *std::min_element(heights.begin(), heights.end());
  const double high = *std::max_element(heights.begin(), heights.end());
  const int levels = 52;
  // the loops lie below their levels, by no more than the distance of two rings of vertices
  std::vector<double> sampled;
  for(int i = 3; i < levels; i += 7)
    sampled.push_back(low + (high - low) * (i + 0.5) / levels);
  SMC::internal::Sections sections(pm, graph);
  std::vector<std::vector<Index>> loops;
  sections.cut(heights, levels, [&loops](std::vector<Index> loop) { loops.push_back(std::move(loop)); });
  EXPECT_LE(loops.size(), 4u + 3u + sampled.size());
  std::set<int> necks;
  std::set<std::size_t> samples;
  for(const std::vector<Index>& loop : loops)
  {
    expect_closed_path(pm, Seed_curve{0, loop, Seed_origin::SECTION});
    double z = 0;
    for(Index v : loop)
      z += pm.point(v).z() / static_cast<double>(loop.size());
    const double neck = std::min(std::max(2 * std::round(z / 2), 2.), 8.);
    if(std::abs(z - neck) < 0.2)
      necks.insert(static_cast<int>(neck));
    bool is_sample = false;
    for(std::size_t i = 0; i < sampled.size(); ++i)
      if(sampled[i] - 0.4 < z && z <= sampled[i] + 1e-9)
      {
        is_sample = true;
        samples.insert(i);
      }
    EXPECT_TRUE(is_sample || !(0.25 < std::abs(z - neck) && std::abs(z - neck) < 0.75)) << z;
  }
  EXPECT_EQ(necks.size(), 4u);
  EXPECT_EQ(samples.size(), sampled.size());
}

// A cone cut aslant: every section is longer than the one below it, though the edges beside them zigzag.
TEST(SectionSeeds, LoopsAreComparedByTheLevelSetsBesideThem)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(
      test_meshes::revolution([](double s) { return 0.5 + 0.3 * s; }, 10, 60, 24, 0.02, 1));
  const SMC::internal::Edge_graph graph(pm);
  std::vector<double> heights;
  for(Index v = 0; v < graph.number_of_vertices(); ++v)
    heights.push_back(pm.point(graph.id(v)).z() + 0.5 * pm.point(graph.id(v)).x());
  const std::size_t levels = 52;
  SMC::internal::Sections sections(pm, graph);
  std::vector<std::vector<Index>> loops;
  sections.cut(heights, levels, [&loops](std::vector<Index> loop) { loops.push_back(std::move(loop)); });
  std::size_t inside = 0;
  for(const std::vector<Index>& loop : loops)
    inside +=
        std::all_of(loop.begin(), loop.end(), [&](Index v) { return pm.point(v).z() > 0.5 && pm.point(v).z() < 9.5; });
  EXPECT_GE(inside, 6u);
  EXPECT_LE(inside, (levels + 3) / 7 + 1);
}

// Of two components each is cut, and no path joins them.
TEST(SectionSeeds, ComponentsAreCutApart)
{
  const test_meshes::Soup tube = test_meshes::boxes_with_tube(3);
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::joined(tube, tube, 20));
  std::vector<Seed_curve> seeds;
  SMC::distance_section_seeds(pm, std::back_inserter(seeds));
  std::map<bool, std::size_t> count;
  for(const Seed_curve& s : seeds)
  {
    expect_closed_path(pm, s);
    ++count[s.vertices.front() < tube.points.size()];
  }
  EXPECT_GT(count[true], 0u);
  EXPECT_GT(count[false], 0u);
}

template <class Source>
std::vector<SMC::Constriction<test_meshes::Mesh>> detect(const test_meshes::Mesh& mesh, const Source& source,
                                                         SMC::Detection_statistics& statistics)
{
  std::vector<SMC::Constriction<test_meshes::Mesh>> result;
  SMC::detect_constrictions(
      mesh, std::back_inserter(result),
      SMC::parameters::all_constrictions(
          true, SMC::parameters::seed_sources(source, CGAL::parameters::visitor(Statistics_taker(statistics)))));
  return result;
}

TEST(SeedSources, EachSourceFindsTheNeckAndSaysSo)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.02, 1));
  const auto check = [&mesh](const auto& source, Seed_origin origin) {
    SMC::Detection_statistics statistics;
    const auto result = detect(mesh, source, statistics);
    ASSERT_FALSE(result.empty());
    EXPECT_NEAR(result.front().length(), 2 * CGAL_PI * 0.4, 0.2);
    for(const auto& c : result)
      for(const auto& s : c.seeds())
        EXPECT_EQ(s.origin, origin);
  };
  check(SMC::Non_face_triangle_seeds(), Seed_origin::NON_FACE_TRIANGLE);
  check(SMC::Cut_locus_seeds(), Seed_origin::CUT_LOCUS);
  check(SMC::Cut_locus_seeds(100, 20), Seed_origin::CUT_LOCUS);
  check(SMC::Section_seeds(200), Seed_origin::SECTION);
}

TEST(SeedSources, SeveralGiveWhatEachGives)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 4));
  SMC::Detection_statistics triangles, loops, both;
  detect(mesh, SMC::Non_face_triangle_seeds(), triangles);
  detect(mesh, SMC::Cut_locus_seeds(100), loops);
  detect(mesh,
         SMC::Seed_sources<SMC::Non_face_triangle_seeds, SMC::Cut_locus_seeds>(SMC::Non_face_triangle_seeds(),
                                                                               SMC::Cut_locus_seeds(100)),
         both);
  EXPECT_GT(triangles.seeds, 0u);
  EXPECT_GT(loops.seeds, 0u);
  EXPECT_EQ(both.seeds, triangles.seeds + loops.seeds);
}

// It is found again when a corner has moved, maybe from another corner. Loops of other sources are none of it.
TEST(RepeatedTriangles, OnFineLevelsATriangleIsOneSeedHoweverOftenItIsFound)
{
  SMC::internal::Repeated_triangles repeated;
  std::vector<Seed_curve> seeds = {{0, {1, 2, 3}, Seed_origin::NON_FACE_TRIANGLE},
                                   {0, {1, 2, 4}, Seed_origin::NON_FACE_TRIANGLE}};
  repeated.remove(seeds, 0, 1200);
  EXPECT_EQ(seeds.size(), 2u);
  seeds.push_back({200, {3, 1, 2}, Seed_origin::NON_FACE_TRIANGLE});
  seeds.push_back({200, {1, 2, 3}, Seed_origin::CUT_LOCUS});
  seeds.push_back({200, {2, 3, 4}, Seed_origin::NON_FACE_TRIANGLE});
  repeated.remove(seeds, 2, 1000);
  ASSERT_EQ(seeds.size(), 4u);
  EXPECT_EQ(seeds[2].origin, Seed_origin::CUT_LOCUS);
  EXPECT_EQ(seeds[3].vertices, (std::vector<Index>{2, 3, 4}));
  seeds.push_back({201, {2, 3, 1}, Seed_origin::NON_FACE_TRIANGLE});
  repeated.remove(seeds, 4, 999);
  EXPECT_EQ(seeds.size(), 5u);
}

TEST(SeedSources, EverySeedIsAccountedFor)
{
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.15, seed, 24, 10));
    SMC::Detection_statistics s;
    const auto result = detect(mesh, SMC::Default_seed_sources(), s);
    EXPECT_EQ(s.seeds + s.barriers,
              s.degenerate + s.not_simple + s.not_certified + s.merged + s.not_selected + result.size());
    EXPECT_EQ(s.not_selected, 0u);
    std::size_t kept = 0;
    for(const auto& c : result)
      kept += c.seeds().size();
    EXPECT_EQ(kept, s.merged + result.size());
  }
}

TEST(SeedSources, SaddleConditionKeepsSeedsOfSaddlesOnly)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::prism(3, 2));
  const SMC::Seed_level level = {6, 0, SMC::null_index, nullptr};
  std::vector<Seed_curve> given, kept;
  const SMC::Given_seeds belt({{0, 1, 2}});
  belt(pm, level, std::back_inserter(given));
  SMC::Saddle_seeds<SMC::Given_seeds> filter(belt);
  filter(pm, level, std::back_inserter(kept));
  ASSERT_EQ(given.size(), 1u);
  EXPECT_TRUE(kept.empty()); // a convex surface has no saddle

  // the corners where a tube meets a box: three quarters of a turn and more
  const SMC::Progressive_mesh tube = test_meshes::make_progressive(test_meshes::boxes_with_tube(3));
  std::vector<Index> waist;
  for(const auto& yz :
      {std::array<int, 2>{{1, 1}}, std::array<int, 2>{{2, 1}}, std::array<int, 2>{{2, 2}}, std::array<int, 2>{{1, 2}}})
    for(Index v = 0; v < tube.number_of_vertex_ids(); ++v)
      if(tube.point(v).x() == 2 && tube.point(v).y() == yz[0] && tube.point(v).z() == yz[1])
        waist.push_back(v);
  ASSERT_EQ(waist.size(), 4u);
  SMC::Saddle_seeds<SMC::Given_seeds> saddles(SMC::Given_seeds({waist}));
  saddles(tube, level, std::back_inserter(kept));
  EXPECT_EQ(kept.size(), 1u);
}

TEST(SeedSources, AUserLoopIsTightened)
{
  const test_meshes::Soup soup = test_meshes::dumbbell(0.02, 2);
  const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
  std::vector<Index> ring;
  for(Index j = 0; j < 18; ++j)
    ring.push_back(10 * 18 + j); // beside the neck, which is ring 12
  SMC::Detection_statistics s;
  const auto result = detect(mesh, SMC::Given_seeds({ring}), s);
  ASSERT_EQ(result.size(), 1u);
  EXPECT_NEAR(result.front().length(), 2 * CGAL_PI * 0.4, 0.2);
  EXPECT_EQ(result.front().seeds().front().origin, Seed_origin::USER);
}

TEST(SeedSources, AUserLoopThatIsNoPathOfEdgesIsRefused)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.02, 2));
  SMC::Detection_statistics s;
  for(const std::vector<Index>& loop :
      {std::vector<Index>{0, 1}, std::vector<Index>{0, 1, 100}, std::vector<Index>{0, 1, 1000000000}})
    EXPECT_THROW(detect(mesh, SMC::Given_seeds({loop}), s), SMC::Invalid_input);
}

TEST(SeedSources, ConvexSurfacesHaveNoConstriction)
{
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    SMC::Detection_statistics s;
    const test_meshes::Mesh hull = test_meshes::make_mesh(test_meshes::random_hull(seed, 200));
    EXPECT_TRUE(detect(hull, SMC::Default_seed_sources(), s).empty());
    EXPECT_EQ(s.seeds + s.barriers, s.degenerate + s.not_simple + s.not_certified);
  }
}

} // namespace test_seed_sources
