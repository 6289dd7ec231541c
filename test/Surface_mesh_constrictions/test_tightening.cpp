// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/geodesic_check.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_tightening {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Tightening_verdict;
using SMC::tighten_closed_curve;
using SMC::tighten_closed_curves;
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

// Fewest edges, by breadth-first search.
Loop path(const Mesh& mesh, Mesh::Vertex_index from, Mesh::Vertex_index to)
{
  std::vector<Mesh::Vertex_index> previous(mesh.num_vertices(), Mesh::null_vertex());
  std::deque<Mesh::Vertex_index> queue = {to};
  previous[to] = to;
  while(previous[from] == Mesh::null_vertex())
  {
    const Mesh::Vertex_index v = queue.front();
    queue.pop_front();
    for(auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
      if(previous[w] == Mesh::null_vertex())
      {
        previous[w] = v;
        queue.push_back(w);
      }
  }
  Loop result;
  for(auto v = from; v != to; v = previous[v])
    result.push_back(v);
  return result;
}

// A closed walk through some random vertices; it may cross itself and run to and fro.
Loop random_loop(const Mesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  Loop loop;
  while(loop.size() < 3)
  {
    std::vector<Mesh::Vertex_index> corners;
    for(int i = 0; i < 4; ++i)
      corners.push_back(Mesh::Vertex_index(static_cast<Index>(random() % mesh.num_vertices())));
    loop.clear();
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const Loop piece = path(mesh, corners[i], corners[(i + 1) % corners.size()]);
      loop.insert(loop.end(), piece.begin(), piece.end());
    }
  }
  return loop;
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
  const Loop belt = loop_of(mesh, {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}},
                                   {{1, 0, 2}}, {{1, 0, 1}}});
  EXPECT_EQ(tighten_closed_curve(mesh, belt).verdict, Tightening_verdict::DEGENERATE);
}

TEST(Tightening, AFlatBandIsRepresentedByTheEndWithTheSmallerVertex)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  std::vector<std::set<Mesh::Vertex_index> > pivots;
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
  const Loop& smaller = *std::min_element(one.begin(), one.end()) < *std::min_element(other.begin(), other.end()) ? one
                                                                                                                : other;
  EXPECT_EQ(pivots.front(), std::set<Mesh::Vertex_index>(smaller.begin(), smaller.end()));
}

TEST(Tightening, SpursAndOverlapsAreShortenedAway)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(4));
  const Loop square = loop_of(mesh, {{{4, 1, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}});
  const Loop detour = loop_of(mesh, {{{4, 1, 1}}, {{3, 1, 1}}, {{2, 1, 1}}, {{3, 1, 1}}, {{4, 1, 1}}, {{4, 2, 1}},
                                     {{4, 2, 2}}, {{4, 1, 2}}});
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
  const Loop good = loop_of(mesh, {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}},
                                   {{1, 0, 2}}, {{1, 0, 1}}});
  const Loop jump = {good[0], good[1], good[5]};
  const Loop short_one = {good[0], good[1]};
  std::vector<SMC::Tightened_curve<Mesh> > out;
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
