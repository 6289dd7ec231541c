// SPDX-License-Identifier: GPL-3.0-or-later
// The exact correction of curves, alone: floating point does not tighten them first, so every step of it is needed.
#include "include/curve_to_settle.h"
#include "include/exact_models.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_string_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_exact_settler {

using namespace CGAL::Surface_mesh_constrictions;
using exact_models::Position;
using exact_models::Soup;
using test_meshes::Mesh;

using curve_to_settle::Curve;
using curve_to_settle::loop_of;
using curve_to_settle::Point_map;

TEST(ExactSettler, SpursAndDetoursAreShortenedAway)
{
  const Soup soup = test_meshes::boxes_with_tube(4);
  for(const std::vector<Position>& loop : std::vector<std::vector<Position>>{
          {{{4, 1, 1}}, {{3, 1, 1}}, {{2, 1, 1}}, {{3, 1, 1}}, {{4, 1, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}},
          {{{4, 1, 1}}, {{3, 1, 1}}, {{3, 2, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{4, 1, 2}}},
          {{{4, 1, 1}}, {{5, 1, 1}}, {{5, 2, 1}}, {{4, 2, 1}}, {{4, 2, 2}}, {{3, 2, 2}}, {{3, 1, 2}}, {{4, 1, 2}}}})
    for(bool is_reversed : {false, true})
    {
      std::vector<Index> path = loop_of(soup, loop);
      if(is_reversed)
        std::reverse(path.begin(), path.end());
      Curve curve(soup, path);
      EXPECT_EQ(curve.settle(), Certificate_verdict::CONSTRICTION);
      EXPECT_NEAR(curve.length(), 4, 4e-12);
      EXPECT_EQ(curve.settler.number_of_corrections(), 1u);
    }
}

TEST(ExactSettler, ABandIsRepresentedByTheEndWithTheSmallerVertex)
{
  for(unsigned seed = 0; seed < 8; ++seed)
  {
    const Soup soup = test_meshes::relabelled(test_meshes::boxes_with_tube(3), seed);
    const auto ring = [&soup](double x) { return loop_of(soup, {{{x, 1, 1}}, {{x, 2, 1}}, {{x, 2, 2}}, {{x, 1, 2}}}); };
    std::vector<Index> begin = ring(2), end = ring(5);
    const Index smallest =
        std::min(*std::min_element(begin.begin(), begin.end()), *std::min_element(end.begin(), end.end()));
    for(double x : {2, 3, 4, 5})
    {
      Curve curve(soup, ring(x));
      EXPECT_EQ(curve.settle(), Certificate_verdict::CONSTRICTION);
      Index first = null_index;
      for(const internal::Arc& a : internal::arcs_of_curve(curve.network, curve.id))
        first = std::min(first, a.from);
      EXPECT_EQ(first, smallest);
      EXPECT_EQ(curve.settler.number_of_corrections(), 0u);
    }
  }
}

TEST(ExactSettler, WhatSlipsOffDegeneratesAndTheSignsThatShowedItCount)
{
  const auto expect_degenerate = [](Curve& curve) {
    const Certificate certificate = curve.settler.settle(curve.network, curve.id);
    EXPECT_TRUE(curve.is_degenerate());
    EXPECT_EQ(certificate.verdict, Certificate_verdict::NOT_COMPUTED);
    EXPECT_GT(certificate.signs.interval + certificate.signs.algebra, 0u);
  };
  std::vector<Index> around_apex;
  for(Index v = 1; v <= 12; ++v)
    around_apex.push_back(v);
  Curve cone(test_meshes::sharp_cone(), around_apex);
  expect_degenerate(cone);

  const Soup box = test_meshes::box(3, 2, 2);
  Curve belt(
      box,
      loop_of(
          box,
          {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 0}}, {{1, 2, 1}}, {{1, 2, 2}}, {{1, 1, 2}}, {{1, 0, 2}}, {{1, 0, 1}}}));
  expect_degenerate(belt);

  const Soup tube = test_meshes::boxes_with_tube(4);
  Curve to_and_fro(tube, loop_of(tube, {{{4, 1, 1}}, {{3, 1, 1}}, {{2, 1, 1}}, {{3, 1, 1}}}));
  expect_degenerate(to_and_fro);
}

TEST(ExactSettler, AnArcThatIsNotStraightIsPulledBack)
{
  const Soup soup = exact_models::twisted_cylinder();
  const std::vector<Index> middle = loop_of(soup, {{{2, 0, 0}}, {{0, 2, 0}}, {{-2, 0, 0}}, {{0, -2, 0}}});
  for(std::size_t pivot = 0; pivot < 4; ++pivot)
    for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
    {
      Curve curve(soup, middle);
      std::vector<internal::Arc> arcs = internal::arcs_of_curve(curve.network, curve.id);
      std::rotate(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(pivot), arcs.end());
      // past the pivot between the last arc and the first instead of through it
      internal::Strip strip;
      internal::append_fan(curve.pm, arcs.back(), arcs.front(), side, strip);
      internal::Arc past;
      past.from = arcs.back().from;
      past.to = arcs.front().to;
      past.crossings.assign(strip.begin(), strip.end());
      internal::measure(curve.pm, past);
      arcs.front() = past;
      arcs.pop_back();
      curve.network.set_arcs(curve.id, arcs);

      EXPECT_EQ(curve.settle(), Certificate_verdict::STRICT_CONSTRICTION);
      EXPECT_EQ(curve.settler.number_of_corrections(), 1u);
      std::vector<Index> pivots;
      for(const internal::Arc& a : internal::arcs_of_curve(curve.network, curve.id))
        pivots.push_back(a.from);
      std::rotate(pivots.begin(), std::find(pivots.begin(), pivots.end(), middle[0]), pivots.end());
      EXPECT_EQ(pivots, middle);
    }
}

// Below the belt a prism ends with a face; above it, at a shelf with a thinner one that is a neck.
TEST(ExactSettler, ACurveThatLeaksOverAShelfIsHeldByTheNeckBehindIt)
{
  const auto square = exact_models::square();
  const Soup soup = exact_models::tube({exact_models::ring(square, 3, 0), exact_models::ring(square, 3, 2),
                                        exact_models::ring(square, 3, 5), exact_models::ring(square, 1, 5),
                                        exact_models::ring(square, 1, 8), exact_models::ring(square, 3, 8),
                                        exact_models::ring(square, 3, 12)});
  std::vector<Index> belt = loop_of(soup, exact_models::ring(square, 3, 2));
  // the shelf is on the left, and the left is looked at first
  Curve up(soup, belt);
  EXPECT_EQ(up.settle(), Certificate_verdict::CONSTRICTION);
  ASSERT_FALSE(up.is_degenerate());
  EXPECT_NEAR(up.length(), 8, 8e-12);
  std::reverse(belt.begin(), belt.end());
  Curve down(soup, belt);
  down.settle();
  EXPECT_TRUE(down.is_degenerate());
}

// A loop with one pivot has a closed strip, and several corners of it to go to.
TEST(ExactSettler, ALoopThroughOneVertexSlipsToTheNarrowerEndOfThePrism)
{
  for(int n = 3; n <= 8; ++n)
    for(double factor : {1 + 1e-3, 1 - 1e-3, 1.5})
      for(bool is_clockwise : {false, true})
      {
        const Soup soup = exact_models::prism_with_one_vertex(n, factor);
        const Index v = static_cast<Index>(exact_models::vertex_at_height(soup, 650));
        Curve curve(soup, {});
        const internal::Imported_surface<Mesh, Point_map> surface(curve.pm, curve.imported, curve.mesh.points());
        internal::Arc arc;
        arc.from = arc.to = v;
        for(Index h : exact_models::crossings_at_height_of(
                surface, v, [&soup](Index w) { return soup.points[w][2]; }, is_clockwise))
          arc.crossings.push_back(h);
        internal::measure(curve.pm, arc);
        std::vector<internal::Arc> arcs = {arc};
        curve.network.set_arcs(curve.id, arcs);

        const auto end = exact_models::ring(exact_models::polygon(n), std::min(factor, 1.), factor < 1 ? 900 : 500);
        double perimeter = 0;
        for(std::size_t i = 0; i < end.size(); ++i)
          perimeter += std::hypot(end[(i + 1) % end.size()][0] - end[i][0], end[(i + 1) % end.size()][1] - end[i][1]);
        EXPECT_EQ(curve.settle(), Certificate_verdict::STRICT_CONSTRICTION);
        EXPECT_NEAR(curve.length(), perimeter, 1e-12 * perimeter);
        EXPECT_EQ(internal::arcs_of_curve(curve.network, curve.id).size(), end.size());
      }
}

// From loops of edges that wind through the mesh the exact steps alone reach what can be certified, or nothing.
TEST(ExactSettler, EveryLoopEndsInAConstrictionOrShrinksOrMeetsItself)
{
  std::size_t certified = 0, degenerate = 0;
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    const Soup soup = seed % 2 == 0 ? test_meshes::torus(0.1, seed, 12, 8) : test_meshes::dumbbell(0.05, seed, 10, 8);
    const Mesh mesh = test_meshes::make_mesh(soup);
    // a random walk until it comes back to where it has been
    std::mt19937 random(seed);
    std::vector<Index> walk = {static_cast<Index>(random() % mesh.num_vertices())};
    for(std::size_t begin = 0;; begin = 0)
    {
      std::vector<Index> neighbours;
      for(auto w : CGAL::vertices_around_target(mesh.halfedge(Mesh::Vertex_index(walk.back())), mesh))
        if(walk.size() < 2 || w != Mesh::Vertex_index(walk[walk.size() - 2]))
          neighbours.push_back(w);
      const Index next = neighbours[random() % neighbours.size()];
      while(begin < walk.size() && walk[begin] != next)
        ++begin;
      if(begin < walk.size() && walk.size() - begin >= 3)
      {
        walk.erase(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(begin));
        break;
      }
      walk.push_back(next);
    }
    Curve curve(soup, walk);
    const double before = curve.length();
    const Certificate_verdict verdict = curve.settle();
    if(curve.is_degenerate())
    {
      ++degenerate;
      continue;
    }
    EXPECT_LE(curve.length(), before * (1 + 1e-14));
    const bool is_certified =
        verdict == Certificate_verdict::STRICT_CONSTRICTION || verdict == Certificate_verdict::CONSTRICTION;
    EXPECT_TRUE(is_certified || verdict == Certificate_verdict::TOUCHES_ITSELF ||
                verdict == Certificate_verdict::CROSSES_ITSELF)
        << "seed " << seed << ", verdict " << static_cast<int>(verdict);
    certified += is_certified;
  }
  EXPECT_GT(certified + degenerate, 6u);
}

// Whatever strip a string is pulled in, exact numbers find the bends that floating point finds with its tolerance: on a
// surface without ties, and on one where most lines between vertices run through others.
TEST(ExactStringPuller, BendsWhereFloatingPointDoes)
{
  for(const Soup& soup : {test_meshes::torus(0.1, 5, 12, 8), test_meshes::box(4, 4, 4), test_meshes::box(6, 3, 1)})
  {
    Curve curve(soup, {});
    const Progressive_mesh& pm = curve.pm;
    typedef internal::Imported_surface<Mesh, Point_map> Surface;
    const Surface surface(pm, curve.imported, curve.mesh.points());
    internal::Sign_prover<Surface> prover(surface);
    internal::Exact_string_puller<Surface> exact_puller(prover);
    internal::String_puller puller(pm);
    std::mt19937 random(1);
    for(int round = 0; round < 1000; ++round)
    {
      const Index out = static_cast<Index>(random() % (3 * soup.faces.size()));
      const Index u = pm.source(out);
      internal::Strip strip = {pm.next(out)};
      for(int n = static_cast<int>(random() % 12); n > 0; --n)
      {
        const Index o = pm.opposite(strip.back());
        strip.push_back(random() % 2 == 0 ? pm.next(o) : pm.prev(o));
      }
      const Index w = pm.target(pm.next(pm.opposite(strip.back())));
      std::vector<internal::Arc> arcs;
      puller.pull(u, strip, w, arcs);
      if(strip.empty())
        continue;
      std::vector<internal::Exact_arc<Surface>> exact_arcs;
      ASSERT_TRUE(exact_puller.pull(u, strip, w, exact_arcs));
      ASSERT_EQ(exact_arcs.size(), arcs.size());
      for(std::size_t i = 0; i < arcs.size(); ++i)
      {
        EXPECT_EQ(exact_arcs[i].from, arcs[i].from);
        EXPECT_EQ(exact_arcs[i].to, arcs[i].to);
        EXPECT_EQ(exact_arcs[i].crossings, internal::Strip(arcs[i].crossings.begin(), arcs[i].crossings.end()));
        if(arcs[i].is_edge())
        {
          EXPECT_EQ(exact_arcs[i].along, arcs[i].along);
        }
      }
    }
  }
}

} // namespace test_exact_settler
