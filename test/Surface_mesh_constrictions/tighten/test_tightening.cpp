// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/exact_models.h"
#include "include/geodesic_check.h"
#include "include/random_loops.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/tighten_paths.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_tightening {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::tighten_closed_curve;
using SMC::tighten_closed_curves;
using SMC::Tightening_verdict;
using test_meshes::Mesh;
typedef std::vector<Mesh::Vertex_index> Loop;

Loop loop_of(const Mesh& mesh, const std::vector<test_meshes::Position>& positions)
{
  Loop loop;
  for(const test_meshes::Position& p : positions)
    for(auto v : mesh.vertices())
      if(mesh.point(v) == Mesh::Point(p[0], p[1], p[2]))
        loop.push_back(v);
  EXPECT_EQ(loop.size(), positions.size());
  return loop;
}

double length_of(const Mesh& mesh, const Loop& loop)
{
  double length = 0;
  for(std::size_t i = 0; i < loop.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(mesh.point(loop[i]), mesh.point(loop[(i + 1) % loop.size()])));
  return length;
}

Loop random_loop(const Mesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  return random_loops::random_loop(mesh, random);
}

TEST(Tightening, ALoopAroundASharpConeIsDegenerate)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::sharp_cone());
  Loop loop;
  for(Index v = 1; v <= 12; ++v)
    loop.push_back(Mesh::Vertex_index(v));
  EXPECT_EQ(tighten_closed_curve(mesh, loop).verdict, Tightening_verdict::DEGENERATE);
  std::reverse(loop.begin(), loop.end());
  EXPECT_EQ(tighten_closed_curve(mesh, loop).verdict, Tightening_verdict::DEGENERATE);
  EXPECT_EQ(tighten_closed_curve(mesh, Loop{loop[0], loop[1], Mesh::Vertex_index(0)}).verdict,
            Tightening_verdict::DEGENERATE);
}

TEST(Tightening, TheBeltOfABoxLeaksAway)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(3, 2, 2));
  const Loop belt = loop_of(
      mesh, {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}}, {{1, 0, 2}}, {{1, 0, 1}}});
  EXPECT_EQ(tighten_closed_curve(mesh, belt).verdict, Tightening_verdict::DEGENERATE);
}

TEST(Tightening, AFlatBandIsRepresentedByTheEndWithTheSmallerVertex)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  std::vector<std::set<Mesh::Vertex_index>> pivots;
  for(double x : {2, 3, 4, 5, 6})
  {
    const Loop square = loop_of(mesh, {{{x, 1, 1}}, {{x, 2, 1}}, {{x, 2, 2}}, {{x, 1, 2}}});
    const auto result = tighten_closed_curve(mesh, square);
    ASSERT_EQ(result.verdict, Tightening_verdict::CLOSED_GEODESIC);
    EXPECT_NEAR(result.curve.length(), 4, 4e-12);
    EXPECT_NEAR(result.curve.flat_band_width(), 4, 1e-12);
    geodesic_check::expect_closed_geodesic(mesh, result.curve);
    pivots.emplace_back();
    for(const auto& p : result.curve.pivots())
      pivots.back().insert(p.vertex);
    EXPECT_EQ(pivots.back(), pivots.front());
  }
  const Loop one = loop_of(mesh, {{{2, 1, 1}}, {{2, 2, 1}}, {{2, 2, 2}}, {{2, 1, 2}}});
  const Loop other = loop_of(mesh, {{{6, 1, 1}}, {{6, 2, 1}}, {{6, 2, 2}}, {{6, 1, 2}}});
  const Loop& smaller =
      *std::min_element(one.begin(), one.end()) < *std::min_element(other.begin(), other.end()) ? one : other;
  EXPECT_EQ(pivots.front(), std::set<Mesh::Vertex_index>(smaller.begin(), smaller.end()));
}

TEST(Tightening, BandsAreTheSameWithoutCertificates)
{
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    const test_meshes::Soup soup = test_meshes::relabelled(test_meshes::boxes_with_tube(4), seed);
    const Mesh mesh = test_meshes::make_mesh(soup);
    for(double x : {2, 4, 6})
    {
      const Loop square = loop_of(mesh, {{{x, 1, 1}}, {{x, 2, 1}}, {{x, 2, 2}}, {{x, 1, 2}}});
      const auto certified = tighten_closed_curve(mesh, square);
      const auto result = tighten_closed_curve(mesh, square, SMC::parameters::certify(false));
      ASSERT_EQ(result.verdict, Tightening_verdict::CLOSED_GEODESIC);
      EXPECT_NEAR(result.curve.flat_band_width(), 4, 1e-12);
      std::set<Mesh::Vertex_index> pivots, expected;
      for(const auto& p : result.curve.pivots())
        pivots.insert(p.vertex);
      for(const auto& p : certified.curve.pivots())
        expected.insert(p.vertex);
      EXPECT_EQ(pivots, expected);
    }
  }
}

// Below the belt a prism ends with a face; above it, at a shelf with a thinner one that is a neck, 3 high.
TEST(Tightening, ACurveThatLeaksOverAShelfIsHeldByTheNeckBehindIt)
{
  const auto square = exact_models::square();
  const Mesh mesh = test_meshes::make_mesh(exact_models::tube(
      {exact_models::ring(square, 3, 0), exact_models::ring(square, 3, 2), exact_models::ring(square, 3, 5),
       exact_models::ring(square, 1, 5), exact_models::ring(square, 1, 8), exact_models::ring(square, 3, 8),
       exact_models::ring(square, 3, 12)}));
  const Loop belt = loop_of(mesh, exact_models::ring(square, 3, 2)); // with the shelf on its left
  const auto result = tighten_closed_curve(mesh, belt, SMC::parameters::certify(false));
  ASSERT_EQ(result.verdict, Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_NEAR(result.curve.length(), 8, 8e-12);
  EXPECT_NEAR(result.curve.flat_band_width(), 3, 1e-12);
}

// A torus without curvature: a prism's side, and the same from inside, joined at both ends. The band of a curve around
// the prism has no end.
TEST(Tightening, ABandThatClosesInItselfIsRepresentedByTheSmallestVertex)
{
  const std::size_t n = 5;
  test_meshes::Soup torus;
  for(double z : {0., 300., 600., 300.})
    for(const test_meshes::Position& p : exact_models::ring(exact_models::polygon(n), 1, z))
      torus.points.push_back(p);
  for(std::size_t r = 0; r < 4; ++r)
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t j = (i + 1) % n, a = n * r, b = n * ((r + 1) % 4);
      torus.faces.push_back({{a + i, a + j, b + j}});
      torus.faces.push_back({{a + i, b + j, b + i}});
    }
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    // which place each vertex got
    test_meshes::Soup numbered = torus;
    for(std::size_t v = 0; v < numbered.points.size(); ++v)
      numbered.points[v] = {{double(v), 0, 0}};
    std::vector<Mesh::Vertex_index> place(torus.points.size());
    const test_meshes::Soup names = test_meshes::relabelled(numbered, seed);
    for(std::size_t v = 0; v < names.points.size(); ++v)
      place[static_cast<std::size_t>(names.points[v][0])] = Mesh::Vertex_index(static_cast<Index>(v));

    const Mesh mesh = test_meshes::make_mesh(test_meshes::relabelled(torus, seed));
    for(std::size_t r = 0; r < 4; ++r)
    {
      const Loop ring(place.begin() + static_cast<std::ptrdiff_t>(n * r),
                      place.begin() + static_cast<std::ptrdiff_t>(n * (r + 1)));
      const auto result = tighten_closed_curve(mesh, ring, SMC::parameters::certify(false));
      ASSERT_EQ(result.verdict, Tightening_verdict::CLOSED_GEODESIC);
      std::set<Mesh::Vertex_index> pivots;
      for(const auto& p : result.curve.pivots())
        pivots.insert(p.vertex);
      EXPECT_EQ(pivots.count(Mesh::Vertex_index(0)), 1u);
    }
  }
}

TEST(LengthUnit, IsAShareOfTheDiagonalWhereverTheSurfaceIs)
{
  SMC::internal::Arc arc;
  arc.length = 13;
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    test_meshes::Soup soup = test_meshes::relabelled(test_meshes::box(3, 4, 12), seed);
    for(test_meshes::Position& p : soup.points)
      p = {{p[0] + 10, p[1] - 40, p[2] + 5}};
    const SMC::internal::Length_unit unit(test_meshes::make_progressive(soup));
    EXPECT_EQ(unit(arc), std::int64_t(1) << 53);
    EXPECT_EQ(unit(std::vector<SMC::internal::Arc>(3, arc)), 3 * (std::int64_t(1) << 53));
  }
}

// A string is the same from either end, also where it runs through vertices in a straight line.
TEST(StringPuller, TheWayBackIsTheSame)
{
  for(const test_meshes::Soup& soup : {test_meshes::torus(0.1, 5, 12, 8), test_meshes::box(4, 4, 4)})
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(soup);
    SMC::internal::String_puller puller(pm);
    std::mt19937 random(1);
    for(int round = 0; round < 1000; ++round)
    {
      const Index out = static_cast<Index>(random() % (3 * soup.faces.size()));
      SMC::internal::Strip strip = {pm.next(out)}, back;
      for(int n = static_cast<int>(random() % 12); n > 0; --n)
      {
        const Index o = pm.opposite(strip.back());
        strip.push_back(random() % 2 == 0 ? pm.next(o) : pm.prev(o));
      }
      const Index u = pm.source(out), w = pm.target(pm.next(pm.opposite(strip.back())));
      for(auto h = strip.rbegin(); h != strip.rend(); ++h)
        back.push_back(pm.opposite(*h));
      std::vector<SMC::internal::Arc> there, and_back;
      puller.pull(u, strip, w, there);
      puller.pull(w, back, u, and_back);
      ASSERT_EQ(there.size(), and_back.size());
      for(std::size_t i = 0; i < there.size(); ++i)
      {
        const SMC::internal::Arc &a = there[i], &b = and_back[there.size() - 1 - i];
        EXPECT_EQ(a.from, b.to);
        EXPECT_EQ(a.to, b.from);
        EXPECT_EQ(a.crossings.size(), b.crossings.size());
        EXPECT_NEAR(a.length, b.length, 1e-12);
      }
    }
  }
}

// The strip around a prism with one vertex between its ends, past that vertex on its upper side.
struct StripAroundPrism : public ::testing::Test
{
  static constexpr int n = 6;

  void SetUp() override { make(1); }

  void make(double factor)
  {
    soup = exact_models::prism_with_one_vertex(n, factor);
    pm.reset(new SMC::Progressive_mesh(test_meshes::make_progressive(soup)));
    vertex = static_cast<Index>(exact_models::vertex_at_height(soup, 650));
    arc = SMC::internal::Arc();
    arc.from = arc.to = vertex;
    const auto height = [this](Index v) { return pm->point(v).z(); };
    for(Index h : exact_models::crossings_at_height_of(*pm, vertex, height, false))
      arc.crossings.push_back(h);
    SMC::internal::measure(*pm, arc);
    strip.assign(arc.crossings.begin(), arc.crossings.end());
    SMC::internal::append_fan(*pm, arc, arc, SMC::Curve_side::LEFT, strip);
  }

  test_meshes::Soup soup;
  std::unique_ptr<SMC::Progressive_mesh> pm;
  Index vertex = 0;
  SMC::internal::Arc arc; // with the upper end on its left
  SMC::internal::Strip strip;
};

TEST_F(StripAroundPrism, HasEachVertexOnceAsACorner)
{
  const SMC::internal::Closed_strip closed(*pm, strip);
  std::vector<Index> corners, expected = {vertex};
  for(const auto& corner : closed.corners())
    corners.push_back(corner.vertex);
  auto ring = exact_models::vertices_at(soup, exact_models::ring(exact_models::polygon(n), 1, 900));
  expected.insert(expected.end(), ring.begin(), ring.end());
  ring = exact_models::vertices_at(soup, exact_models::ring(exact_models::polygon(n), 1, 500));
  expected.insert(expected.end(), ring.begin() + 1, ring.end()); // the first is behind the vertex
  std::sort(corners.begin(), corners.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(corners, expected);
}

TEST_F(StripAroundPrism, IsAsHighAsFromTheVertexToTheUpperEnd)
{
  const SMC::internal::Closed_strip closed(*pm, strip);
  const auto up = closed.foremost_corner(SMC::Curve_side::LEFT), down = closed.foremost_corner(SMC::Curve_side::RIGHT);
  EXPECT_EQ(down.vertex, vertex);
  EXPECT_NEAR(closed.height(up, down), 250, 1e-9);
  EXPECT_NEAR(closed.height(down, up), -250, 1e-9);
}

TEST_F(StripAroundPrism, BendsAroundTheNarrowerEnd)
{
  make(0.9);
  EXPECT_EQ(SMC::internal::Closed_strip(*pm, strip).inner_side(), SMC::Curve_side::LEFT);
  make(1.1);
  EXPECT_EQ(SMC::internal::Closed_strip(*pm, strip).inner_side(), SMC::Curve_side::RIGHT);
}

TEST_F(StripAroundPrism, WhatIsCrossedForthAndBackAtItsEndsIsRemoved)
{
  const Index first = strip.front(), arrival = pm->opposite(strip.back());
  const Index third = pm->next(first) == arrival ? pm->prev(first) : pm->next(first);
  SMC::internal::Strip longer = {pm->opposite(third)};
  longer.insert(longer.end(), strip.begin(), strip.end());
  longer.push_back(third);
  const SMC::internal::Closed_strip closed(*pm, strip), same(*pm, longer);
  EXPECT_EQ(same.corners().size(), closed.corners().size());
  EXPECT_EQ(same.rotated(same.corners().front()), closed.rotated(closed.corners().front()));
}

// What a loop of one arc is tightened to, with the unit of length of a surface that may be another one.
std::vector<SMC::internal::Arc> tightened(const SMC::Progressive_mesh& pm, const SMC::internal::Arc& loop,
                                          const SMC::Progressive_mesh& unit_of)
{
  SMC::internal::Curve_network network(pm, false);
  const Index c = network.add_curve(0);
  std::vector<SMC::internal::Arc> arcs = {loop};
  network.set_arcs(c, arcs);
  SMC::internal::Tightener tightener(network, SMC::internal::Length_unit(unit_of));
  tightener.enqueue_all(c);
  tightener.run();
  return SMC::internal::arcs_of_curve(network, c);
}

// Up to the narrower end the loop gets shorter by 4 of 6000.
TEST_F(StripAroundPrism, AStepThatGainsLessThanAUnitIsNotTaken)
{
  make(0.999);
  const auto end = exact_models::ring(exact_models::polygon(n), 0.999, 900);
  double length_of_end = 0;
  for(std::size_t i = 0; i < end.size(); ++i)
    length_of_end += std::hypot(end[(i + 1) % n][0] - end[i][0], end[(i + 1) % n][1] - end[i][1]);
  double length = 0;
  for(const SMC::internal::Arc& a : tightened(*pm, arc, *pm))
    length += a.length;
  EXPECT_NEAR(length, length_of_end, 1e-9);

  // a box whose diagonal, 13 edges of its cells, is 10^4 * 2^53: the unit is 10^4
  const double edge = std::ldexp(1e4 / 13, 53);
  const std::vector<SMC::internal::Arc> left =
      tightened(*pm, arc, test_meshes::make_progressive(test_meshes::box(3, 4, 12, {{edge, edge, edge}})));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].from, vertex);
  EXPECT_EQ(left[0].length, arc.length);
  EXPECT_GT(arc.length, length_of_end + 3);
}

// A trapezium on the top of a box. Its corners have 45, 90, 90 and 135 degrees.
TEST(Tightening, TheSharpestPivotIsRoundedFirst)
{
  const test_meshes::Soup box = test_meshes::box(5, 3, 2);
  std::vector<Index> path;
  for(std::size_t v : exact_models::vertices_at(box, {{{2, 1, 2}}, {{3, 1, 2}}, {{4, 1, 2}}, {{4, 2, 2}}, {{3, 2, 2}}}))
    path.push_back(static_cast<Index>(v));
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(box);
  ASSERT_NE(pm.halfedge(path.front(), path.back()), SMC::null_index);
  for(std::size_t start = 0; start < path.size(); ++start, std::rotate(path.begin(), path.begin() + 1, path.end()))
  {
    SMC::internal::Curve_network network(pm, false);
    const Index c = network.add_curve(0, path);
    SMC::internal::Tightener tightener(network, SMC::internal::Length_unit(pm));
    tightener.enqueue_all(c);
    tightener.run([](Index) { return true; }); // one step
    std::set<Index> pivots;
    for(const SMC::internal::Arc& a : SMC::internal::arcs_of_curve(network, c))
      pivots.insert(a.from);
    const auto sharpest = exact_models::vertices_at(box, {{{2, 1, 2}}}),
               others = exact_models::vertices_at(box, {{{4, 1, 2}}, {{4, 2, 2}}, {{3, 2, 2}}});
    EXPECT_EQ(pivots.count(static_cast<Index>(sharpest[0])), 0u);
    for(std::size_t v : others)
      EXPECT_EQ(pivots.count(static_cast<Index>(v)), 1u);
  }
}

// A loop that winds around a tip, vertex 3, and crosses itself. The strip beside its pivot is so wide that it unfolds
// over its own centre: the loop through the corner furthest from the centre is no shorter than the one that is to be
// shortened, but others are.
TEST(Tightening, OfAStripThatUnfoldsOverItsCentreTheBestCornerIsTaken)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(
      {{{{0, -14, -49}}, {{-36, -19, -37}}, {{-25, -37, -8}}, {{-50, 0, 0}}, {{38, -28, -49}}},
       {{{1, 3, 0}}, {{2, 3, 1}}, {{1, 0, 4}}, {{0, 3, 4}}, {{3, 2, 4}}, {{2, 1, 4}}}});
  SMC::internal::Arc loop;
  loop.from = loop.to = 0;
  const std::vector<std::array<Index, 2>> crossed = {{{1, 3}}, {{2, 3}}, {{4, 3}}, {{0, 3}},
                                                     {{1, 3}}, {{1, 2}}, {{1, 4}}};
  for(const std::array<Index, 2>& edge : crossed)
    for(Index h = 0; h < 18; ++h)
      if(pm.source(h) == edge[0] && pm.target(h) == edge[1])
        loop.crossings.push_back(h);
  ASSERT_EQ(loop.crossings.size(), crossed.size());
  SMC::internal::measure(pm, loop);
  const auto angles = SMC::internal::side_angles(pm, loop, loop);
  EXPECT_LT(std::min(angles.left, angles.right), 0.5);
  EXPECT_GT(std::max(angles.left, angles.right), CGAL_PI);

  EXPECT_TRUE(tightened(pm, loop, pm).empty());
}

TEST(ClosedStrip, AroundOneVertexItIsDegenerate)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::sharp_cone());
  SMC::internal::Strip clockwise, counterclockwise;
  const Index begin = pm.outgoing(0); // of the apex
  for(Index h = begin; clockwise.empty() || h != begin; h = pm.next(pm.opposite(h)))
    clockwise.push_back(h);
  for(auto h = clockwise.rbegin(); h != clockwise.rend(); ++h)
    counterclockwise.push_back(pm.opposite(*h));
  EXPECT_EQ(clockwise.size(), 12u);
  EXPECT_TRUE(SMC::internal::Closed_strip(pm, clockwise).is_degenerate());
  EXPECT_TRUE(SMC::internal::Closed_strip(pm, counterclockwise).is_degenerate());
}

// The shortest loops through each corner of random closed strips, some of which are so wide that they unfold over the
// centre that they turn around.
TEST(Tightening, LoopsInAnyStripBecomeGeodesicsOrShrink)
{
  std::size_t loops = 0;
  for(const test_meshes::Soup& soup : {test_meshes::sharp_cone(), test_meshes::torus(0.3, 2, 8, 5),
                                       test_meshes::square_ring(), test_meshes::dumbbell(0.2, 3, 8, 6)})
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(soup);
    SMC::internal::String_puller puller(pm);
    std::mt19937 random(4);
    for(int round = 0; round < 500; ++round)
    {
      SMC::internal::Strip strip = {static_cast<Index>(random() % (3 * soup.faces.size()))};
      while(strip.size() < 60)
      {
        const Index o = pm.opposite(strip.back()), h = random() % 2 == 0 ? pm.next(o) : pm.prev(o);
        if(h == strip[0])
          break;
        strip.push_back(h);
      }
      if(strip.size() == 60)
        continue;
      const SMC::internal::Closed_strip closed(pm, strip);
      if(closed.is_degenerate())
        continue;
      for(const auto& corner : closed.corners())
      {
        std::vector<SMC::internal::Arc> arcs = closed.shortest_loop(corner, puller);
        if(arcs.empty())
          continue;
        ++loops;
        double before = 0;
        for(const SMC::internal::Arc& a : arcs)
          before += a.length;
        SMC::internal::Curve_network network(pm, false);
        const Index c = network.add_curve(0);
        network.set_arcs(c, arcs);
        SMC::internal::Tightener tightener(network, SMC::internal::Length_unit(pm));
        tightener.enqueue_all(c);
        tightener.run();
        if(network.is_empty(c))
          continue;
        EXPECT_LE(network.length(c), before * (1 + 1e-14));
        const std::vector<SMC::internal::Arc> tight = SMC::internal::arcs_of_curve(network, c);
        for(std::size_t i = 0; i < tight.size(); ++i)
        {
          const auto angles = SMC::internal::side_angles(pm, tight[i], tight[(i + 1) % tight.size()]);
          EXPECT_GE(std::min(angles.left, angles.right), CGAL_PI - 1e-9);
        }
      }
    }
  }
  EXPECT_GT(loops, 100u);
}

TEST(Tightening, SpursAndOverlapsAreShortenedAway)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  const Loop square = loop_of(mesh, {{{4, 1, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}});
  const Loop detour = loop_of(
      mesh, {{{4, 1, 1}}, {{3, 1, 1}}, {{2, 1, 1}}, {{3, 1, 1}}, {{4, 1, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}});
  const Loop to_and_fro = loop_of(mesh, {{{4, 1, 1}}, {{3, 1, 1}}, {{2, 1, 1}}, {{3, 1, 1}}});
  Loop twice_along_one_edge = square;
  twice_along_one_edge.insert(twice_along_one_edge.begin() + 1, {square[1], square[0]});
  EXPECT_NEAR(tighten_closed_curve(mesh, detour).curve.length(), 4, 4e-12);
  EXPECT_NEAR(tighten_closed_curve(mesh, twice_along_one_edge).curve.length(), 4, 4e-12);
  EXPECT_EQ(tighten_closed_curve(mesh, to_and_fro).verdict, Tightening_verdict::DEGENERATE);
}

TEST(Tightening, ALoopRunTwiceIsNotSimple)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  Loop square = loop_of(mesh, {{{4, 1, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}});
  square.insert(square.end(), square.begin(), square.begin() + 4);
  EXPECT_EQ(tighten_closed_curve(mesh, square).verdict, Tightening_verdict::NOT_SIMPLE);
}

TEST(Tightening, DirectionAndStartDoNotMatter)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 11));
  for(unsigned seed = 0; seed < 20; ++seed)
  {
    Loop loop = random_loop(mesh, seed);
    const auto result = tighten_closed_curve(mesh, loop);
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    const auto rotated = tighten_closed_curve(mesh, loop);
    std::reverse(loop.begin(), loop.end());
    const auto reversed = tighten_closed_curve(mesh, loop);
    ASSERT_EQ(result.verdict, rotated.verdict);
    ASSERT_EQ(result.verdict, reversed.verdict);
    EXPECT_NEAR(result.curve.length(), rotated.curve.length(), 1e-12);
    EXPECT_NEAR(result.curve.length(), reversed.curve.length(), 1e-12);
  }
}

// On a grid of squares many pivots are equally sharp.
TEST(Tightening, AmongEquallySharpPivotsDirectionAndStartDoNotMatter)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  for(unsigned seed = 0; seed < 40; ++seed)
  {
    Loop loop = random_loop(mesh, seed);
    const auto result = tighten_closed_curve(mesh, loop);
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      Loop reversed(loop.rbegin(), loop.rend());
      for(const Loop& l : {loop, reversed})
      {
        const auto other = tighten_closed_curve(mesh, l);
        ASSERT_EQ(result.verdict, other.verdict) << seed << ' ' << i;
        ASSERT_NEAR(result.curve.length(), other.curve.length(), 1e-12) << seed << ' ' << i;
      }
    }
  }
}

// The paths of edges are in one network, in which each is tightened after those before it.
TEST(Tightening, TheOrderOfPathsDoesNotMatter)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(4));
  std::vector<std::vector<Index>> paths;
  for(unsigned seed = 0; seed < 100; ++seed)
  {
    std::vector<Index> path;
    for(auto v : random_loop(mesh, seed))
      path.push_back(static_cast<Index>(v));
    paths.push_back(path);
  }
  const auto ends = [&pm, &paths](bool is_reversed) {
    SMC::internal::Curve_network network(pm, false);
    SMC::internal::tighten_paths<CGAL::Sequential_tag>(
        paths.size(), [&](std::size_t i) { return paths[is_reversed ? paths.size() - 1 - i : i]; }, network);
    std::multiset<std::uint64_t> result;
    for(Index c = 0; c < network.number_of_curve_ids(); ++c)
      if(!network.is_empty(c))
        result.insert(network.curve(c).hash);
    return result;
  };
  EXPECT_GT(ends(false).size(), 1u);
  EXPECT_EQ(ends(false), ends(true));
}

TEST(Tightening, NeverLengthensAndEndsInASimpleClosedGeodesic)
{
  std::size_t geodesics = 0;
  for(unsigned seed = 0; seed < 60; ++seed)
  {
    const Mesh mesh = test_meshes::make_mesh(seed % 3 == 0   ? test_meshes::dumbbell(0.1, seed)
                                             : seed % 3 == 1 ? test_meshes::torus(0.1, seed)
                                                             : test_meshes::square_ring());
    const Loop loop = random_loop(mesh, seed);
    const auto result = tighten_closed_curve(mesh, loop);
    if(result.verdict != Tightening_verdict::CLOSED_GEODESIC)
      continue;
    ++geodesics;
    EXPECT_LE(result.curve.length(), length_of(mesh, loop) * (1 + 1e-14));
    geodesic_check::expect_closed_geodesic(mesh, result.curve);
  }
  EXPECT_GT(geodesics, 10u);
}

// A torus that is stretched so far that its edges are 2^60 times as long as the curves around its tube, which lie in
// planes across: the ends of the edges that these cross are rounded to much more than their length. Detection finds the
// same curves.
TEST(Tightening, LengthsAreAccurateWhereTheEdgesThatAreCrossedAreFarLonger)
{
  test_meshes::Soup soup = test_meshes::torus(0.05, 5);
  for(test_meshes::Position& p : soup.points)
    p[0] = std::ldexp(p[0], 60);
  const Mesh mesh = test_meshes::make_mesh(soup);
  const auto detected = detection::detect_all_from_triangles(mesh);
  const std::size_t around = 14;
  std::size_t short_curves = 0;
  for(std::size_t ring = 0; ring < soup.points.size(); ring += around)
  {
    Loop loop;
    for(std::size_t i = 0; i < around; ++i)
      loop.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(ring + i)));
    const auto result = tighten_closed_curve(mesh, loop);
    if(result.verdict != Tightening_verdict::CLOSED_GEODESIC || result.curve.length() > 100)
      continue;
    ++short_curves;
    EXPECT_TRUE(std::any_of(detected.begin(), detected.end(), [&](const auto& c) {
      return std::abs(c.length() - result.curve.length()) <= 1e-12 * c.length();
    })) << result.curve.length();
  }
  EXPECT_GT(short_curves, 0u);
}

TEST(Tightening, ATightCurveDoesNotMove)
{
  for(unsigned seed = 0; seed < 10; ++seed)
  {
    const test_meshes::Soup soup = test_meshes::torus(0.1, seed);
    const Mesh mesh = test_meshes::make_mesh(soup);
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(soup);
    SMC::internal::Curve_network network(pm, false);
    const SMC::internal::Corner_angles angles(pm);
    SMC::internal::Curve_settler settler(network, SMC::internal::Length_unit(pm), angles);
    std::vector<Index> path;
    for(auto v : random_loop(mesh, seed))
      path.push_back(v);
    const Index c = network.add_curve(0, path);
    if(settler.settle(c) == Tightening_verdict::DEGENERATE)
      continue;
    const auto before = SMC::internal::curve_of_arcs(SMC::internal::arcs_of_curve(network, c));
    const double length = network.length(c);
    settler.settle(c);
    EXPECT_EQ(network.length(c), length);
    const auto after = SMC::internal::curve_of_arcs(SMC::internal::arcs_of_curve(network, c));
    EXPECT_EQ(before.nodes, after.nodes);
  }
}

TEST(Tightening, LoopsThatAreNoClosedPathsAreRefused)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(2, 2, 2));
  const Loop good = loop_of(
      mesh, {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}}, {{1, 0, 2}}, {{1, 0, 1}}});
  const Loop jump = {good[0], good[1], good[5]};
  const Loop short_one = {good[0], good[1]};
  std::vector<SMC::Tightened_curve<Mesh>> out;
  for(const Loop& bad : {jump, short_one, Loop()})
    try
    {
      tighten_closed_curves(mesh, std::vector<Loop>{good, bad}, std::back_inserter(out));
      ADD_FAILURE();
    }
    catch(const SMC::Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), SMC::Input_defect::INVALID_LOOP);
      EXPECT_EQ(e.element(), 1u);
      EXPECT_NE(std::string(e.what()).find("loop 1"), std::string::npos);
    }
}

} // namespace test_tightening
