// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

// Barriers around belts of square tubes with spikes. All coordinates are integers.
namespace test_barriers {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Barrier;
using internal::Barrier_end;
using SMC::Index;
using SMC::null_index;
using test_meshes::Position;
using test_meshes::Soup;

const double infinity = std::numeric_limits<double>::infinity();

// The cells with x, y and z from the first three numbers to the last three.
typedef std::array<int, 6> Box;

// A vertex, and how far it is drawn along an axis.
struct Spike
{
  Position at;
  std::size_t axis;
  double by;
};

Soup union_of(const std::vector<Box>& boxes, const Position& scale)
{
  return test_meshes::voxels(
      {{24, 12, 24}},
      [&](int i, int j, int k) {
        return std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) {
          return b[0] <= i && i < b[3] && b[1] <= j && j < b[4] && b[2] <= k && k < b[5];
        });
      },
      scale);
}

std::size_t place(const Soup& soup, const Position& p)
{
  const auto at = std::find(soup.points.begin(), soup.points.end(), p);
  EXPECT_NE(at, soup.points.end());
  return static_cast<std::size_t>(at - soup.points.begin());
}

Soup with_spikes(Soup soup, const std::vector<Spike>& spikes)
{
  for(const Spike& s : spikes)
    soup.points[place(soup, s.at)][s.axis] += s.by;
  return soup;
}

class Body
{
public:
  // `scale` stretches the axes.
  explicit Body(const std::vector<Box>& boxes, const std::vector<Spike>& spikes = {},
                const Position& scale = {{1, 1, 1}})
    : m_scale(scale), m_soup(union_of(boxes, scale)), m_pm(test_meshes::make_progressive(with_spikes(m_soup, spikes))),
      m_lengths(m_pm), m_angles(m_pm), m_search(m_pm, m_lengths, m_angles)
  {}

  const SMC::Progressive_mesh& surface() const { return m_pm; }
  internal::Barrier_search& search() { return m_search; }

  // where there may be a spike
  Index vertex(const Position& p) const { return static_cast<Index>(place(m_soup, p)); }

  // The number of the curve that a belt at a height becomes, given by the x and y of its corners, counterclockwise.
  Index belt(const std::vector<std::array<int, 2>>& corners, int z)
  {
    std::vector<Index> path;
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::array<int, 2>&from = corners[i], &to = corners[(i + 1) % corners.size()];
      const int steps = std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]);
      for(int k = 0; k < steps; ++k)
        path.push_back(vertex({{(from[0] + (to[0] - from[0]) / steps * k) * m_scale[0],
                                (from[1] + (to[1] - from[1]) / steps * k) * m_scale[1], z * m_scale[2]}}));
    }
    return m_search.tightener().tighten_path(path);
  }

  double length(Index c) { return m_search.tightener().length(c); }

  Barrier barrier(Index c, double greatest_length = infinity, bool with_ties = true, bool separates = true)
  {
    const std::vector<internal::Arc> arcs = m_search.tightener().arcs(c);
    return m_search.search(arcs, internal::trace(m_pm, arcs), separates, greatest_length, with_ties);
  }

  Barrier barrier_of_vertices(Index c, double greatest_length = infinity, bool with_ties = true)
  {
    return m_search.search_vertices(m_search.tightener().arcs(c), true, greatest_length, with_ties);
  }

private:
  Position m_scale;
  Soup m_soup; // without spikes
  SMC::Progressive_mesh m_pm;
  internal::Edge_lengths m_lengths;
  internal::Corner_angles m_angles;
  internal::Barrier_search m_search;
};

// Whether the strip behind a barrier becomes its curve.
bool strip_becomes_curve(Body& b, const Barrier& barrier)
{
  return b.search().tightener().tighten({barrier.strip}, infinity, infinity).longest == barrier.curve;
}

Index least_pivot(Body& b, Index c)
{
  Index result = null_index;
  for(const internal::Arc& a : b.search().tightener().arcs(c))
    result = (std::min)(result, a.from);
  return result;
}

// A tube of 4 x 4 with z from 5 to 7, on the front of which there is a spike. Above it is a box.
const Box above = {{0, 0, 7, 6, 6, 12}}, tube = {{1, 1, 5, 5, 5, 7}};
const std::vector<std::array<int, 2>> around_tube = {{{1, 1}}, {{5, 1}}, {{5, 5}}, {{1, 5}}};
const Position foot = {{3, 1, 6}};

// The belt above or below the spike gets over it when it passes its tip, on a straight line around the tube.
double over_spike(double height) { return 14 + 2 * std::sqrt(1 + height * height); }

TEST(Barriers, ABeltSlidesOffOverASpike)
{
  for(double height : {1.9, 2.})
  {
    Body b({above, tube}, {{foot, 1, -height}});
    const Index c = b.belt(around_tube, 7);
    ASSERT_NEAR(b.length(c), 16, 1e-12);
    const Barrier found[] = {b.barrier(c), b.barrier(c, over_spike(height) + 2), b.barrier_of_vertices(c)};
    for(const Barrier& over : found)
    {
      EXPECT_NEAR(over.length, over_spike(height), 1e-9);
      EXPECT_EQ(over.end, Barrier_end::POINT);
      EXPECT_EQ(over.curve, null_index);
      EXPECT_EQ(over.vertex, b.vertex(foot));
    }
  }
}

TEST(Barriers, UpToALengthBelowItNoneIsFound)
{
  Body b({above, tube}, {{foot, 1, -2.}});
  const Index c = b.belt(around_tube, 7);
  EXPECT_EQ(b.barrier_of_vertices(c, 17).end, Barrier_end::NONE);
  const Barrier beyond = b.barrier(c, 17);
  EXPECT_EQ(beyond.end, Barrier_end::BEYOND);
  EXPECT_GT(beyond.length, 17);
  EXPECT_LE(beyond.length, over_spike(2));
}

// While the belt gets over one, the others hold it, so that it is longer than over one alone.
TEST(Barriers, OverSpikesOnSeveralSidesABeltGetsOneByOne)
{
  const std::vector<Spike> spikes = {
      {foot, 1, -2.}, {{{3, 5, 6}}, 1, 1.9}, {{{1, 3, 6}}, 0, -1.8}, {{{5, 3, 6}}, 0, 1.7}};
  for(std::ptrdiff_t n = 2; n <= 4; ++n)
  {
    Body b({above, {{1, 1, 1, 5, 5, 7}}}, {spikes.begin(), spikes.begin() + n});
    const Index c = b.belt(around_tube, 7);
    ASSERT_NEAR(b.length(c), 16, 1e-12);
    for(const Barrier& over : {b.barrier(c), b.barrier_of_vertices(c)})
    {
      EXPECT_EQ(over.end, Barrier_end::POINT);
      EXPECT_GT(over.length, over_spike(2));
      EXPECT_LT(over.length, over_spike(2) + 1);
    }
  }
}

// Below the tube is a tube of 2 x 2, above the box one of 5 x 5, and behind each of these another box.
TEST(Barriers, ABeltSlidesOverASpikeToAShorterOne)
{
  Body b({above, tube, {{2, 2, 3, 4, 4, 5}}, {{0, 0, 0, 6, 6, 3}}, {{0, 0, 12, 5, 5, 14}}, {{0, 0, 14, 6, 6, 17}}},
         {{foot, 1, -2.}});
  const Index c = b.belt(around_tube, 7), longer = b.belt({{{0, 0}}, {{5, 0}}, {{5, 5}}, {{0, 5}}}, 13);
  ASSERT_NEAR(b.length(c), 16, 1e-12);
  ASSERT_NEAR(b.length(longer), 20, 1e-12);
  const Barrier over = b.barrier(c);
  EXPECT_NEAR(over.length, over_spike(2), 1e-9);
  ASSERT_EQ(over.end, Barrier_end::CURVE);
  EXPECT_NEAR(b.length(over.curve), 8, 1e-12);
  EXPECT_EQ(over.vertex, null_index);
  EXPECT_TRUE(strip_becomes_curve(b, over));
  // of curves that are known to lie behind a barrier only a shorter one is its end
  const Barrier same = b.search().behind_barrier(20, over.curve);
  EXPECT_EQ(same.end, Barrier_end::CURVE);
  EXPECT_EQ(same.curve, over.curve);
  EXPECT_EQ(same.length, 20);
  EXPECT_EQ(b.search().behind_barrier(20, c).end, Barrier_end::NONE);
  EXPECT_EQ(b.search().behind_barrier(20, longer).end, Barrier_end::NONE);
}

// Between two boxes there are two belts of the same length, one on either side of the spike. The one that stands for
// both is held by the boxes, of perimeter 24, or where its finger gets over the edge of one.
TEST(Barriers, OfTwoBeltsOfTheSameLengthOneSlidesToTheOther)
{
  Body b({above, tube, {{0, 0, 0, 6, 6, 5}}}, {{foot, 1, -2.}});
  const std::array<Index, 2> belts = {{b.belt(around_tube, 5), b.belt(around_tube, 7)}};
  ASSERT_NE(belts[0], belts[1]);
  std::size_t sliding = 0;
  for(std::size_t i = 0; i < 2; ++i)
  {
    ASSERT_NEAR(b.length(belts[i]), 16, 1e-12);
    const Barrier with_ties = b.barrier(belts[i]), without = b.barrier(belts[i], infinity, false);
    EXPECT_EQ(without.end, Barrier_end::POINT);
    EXPECT_GT(without.length, over_spike(2) + 1);
    if(with_ties.end == Barrier_end::CURVE)
    {
      ++sliding;
      EXPECT_NEAR(with_ties.length, over_spike(2), 1e-9);
      EXPECT_EQ(with_ties.curve, belts[1 - i]);
      EXPECT_LT(least_pivot(b, belts[1 - i]), least_pivot(b, belts[i]));
    }
    else
      EXPECT_EQ(with_ties.length, without.length);
  }
  EXPECT_EQ(sliding, 1u);
}

// A closed tube with a spike below the belt and another one above it, on the other side.
TEST(Barriers, OfTwoSpikesTheLowerOneLetsABeltSlideOff)
{
  const Position other = {{3, 5, 8}};
  for(double height : {1.9, 2.1})
  {
    Body b({{{1, 1, 3, 5, 5, 11}}}, {{foot, 1, -height}, {other, 1, 2.}});
    const Index c = b.belt(around_tube, 7);
    ASSERT_NEAR(b.length(c), 16, 1e-12);
    const Barrier over = b.barrier(c);
    EXPECT_NEAR(over.length, over_spike((std::min)(height, 2.)), 1e-9);
    EXPECT_EQ(over.end, Barrier_end::POINT);
    EXPECT_EQ(over.vertex, b.vertex(height < 2 ? foot : other));
  }
}

// The box above is of 5 x 4 only.
TEST(Barriers, ALowBoxIsEasierThanAHighSpike)
{
  Body b({{{1, 1, 7, 6, 5, 12}}, tube}, {{foot, 1, -6.}});
  const Index c = b.belt(around_tube, 7);
  ASSERT_NEAR(b.length(c), 16, 1e-12);
  for(double greatest_length : {infinity, 19.5})
  {
    const Barrier over = b.barrier(c, greatest_length);
    EXPECT_EQ(over.end, Barrier_end::POINT);
    EXPECT_GE(over.length, 18 - 1e-9);
    EXPECT_LT(over.length, 19);
  }
}

// Two legs of 3 x 3, joined by a sheet of thickness 1, above z = 9. Below, the legs are thicker, but for the side where
// they face each other. The belt at z = 9 is held by a spike above it. It slides down as it is pinched below the sheet:
// its parallel sides, of the length of the sheet, become the diagonals between them.

Box leg(int x) { return {{x, 4, 9, x + 3, 7, 12}}; }
Box foot_of_leg(int x, int z) { return {{x, 2, z, x + 5, 9, 9}}; }
Box sheet(int x, int length) { return {{x, 5, 9, x + length, 6, 12}}; }
double over_pinch(double length) { return 2 * std::sqrt(length * length + 1) - 2 * length; }
const Spike on_left_leg = {{{3, 4, 10}}, 1, -2.};

std::vector<std::array<int, 2>> around_legs(const std::vector<int>& legs)
{
  std::vector<std::array<int, 2>> result;
  for(int x : legs)
    for(const std::array<int, 2>& p : {std::array<int, 2>{{x, 5}}, {{x, 4}}, {{x + 3, 4}}, {{x + 3, 5}}})
      result.push_back(p);
  for(auto x = legs.rbegin(); x != legs.rend(); ++x)
    for(const std::array<int, 2>& p : {std::array<int, 2>{{*x + 3, 6}}, {{*x + 3, 7}}, {{*x, 7}}, {{*x, 6}}})
      result.push_back(p);
  return result;
}

TEST(Barriers, ABeltOfTwoLegsPartsAtThePinchBetweenThem)
{
  Body b({leg(2), leg(7), sheet(5, 2), foot_of_leg(0, 5), foot_of_leg(7, 5)}, {on_left_leg});
  const Index c = b.belt(around_legs({2, 7}), 9);
  ASSERT_NEAR(b.length(c), 26, 1e-12);
  const Barrier over = b.barrier(c);
  EXPECT_NEAR(over.length, 26 + over_pinch(2), 1e-9);
  ASSERT_EQ(over.end, Barrier_end::CURVE);
  EXPECT_NEAR(b.length(over.curve), 12, 1e-12);
  EXPECT_EQ(over.vertex, null_index);
  EXPECT_TRUE(strip_becomes_curve(b, over));
}

// Without feet both parts slide off.
TEST(Barriers, BehindAPinchABeltMaySlideOff)
{
  Body b({leg(2), leg(7), sheet(5, 2), {{2, 4, 6, 5, 7, 9}}, {{7, 4, 6, 10, 7, 9}}}, {on_left_leg});
  const Index c = b.belt(around_legs({2, 7}), 9);
  ASSERT_NEAR(b.length(c), 26, 1e-12);
  const Barrier over = b.barrier(c);
  EXPECT_NEAR(over.length, 26 + over_pinch(2), 1e-9);
  ASSERT_EQ(over.end, Barrier_end::POINT);
  ASSERT_NE(over.vertex, null_index);
  EXPECT_LE(b.surface().point(over.vertex).z(), 9);
}

// The sheets between three legs, in either order, are 2 and 3 long. Where it is pinched at the longer one, a belt gets
// less long. It does the same where a handle joins what is below it to what is above it.
TEST(Barriers, OfTwoPinchesABeltPartsAtTheLowerOne)
{
  for(int first : {2, 3})
  {
    const int second = 5 - first, x = 5 + first, y = x + 3 + second; // of the legs after the first one
    const std::vector<Box> body = {leg(2),
                                   leg(x),
                                   leg(y),
                                   sheet(5, first),
                                   sheet(x + 3, second),
                                   foot_of_leg(0, 5),
                                   {{x, 2, 5, x + 3, 9, 9}},
                                   foot_of_leg(y, 5)};
    std::vector<Box> ring = body;
    ring.push_back({{2, 4, 12, y + 3, 7, 14}});
    ring.push_back({{2, 2, 14, y + 7, 9, 16}});
    ring.push_back({{y + 5, 2, 5, y + 7, 9, 14}});
    for(bool is_ring : {false, true})
    {
      Body b(is_ring ? ring : body, {on_left_leg});
      const Index c = b.belt(around_legs({2, x, y}), 9);
      ASSERT_NEAR(b.length(c), 42, 1e-12);
      const Barrier over = b.barrier(c, infinity, true, !is_ring);
      EXPECT_NEAR(over.length, 42 + over_pinch(3), 1e-9) << first << is_ring;
      ASSERT_EQ(over.end, Barrier_end::CURVE);
      EXPECT_NEAR(b.length(over.curve), 26, 1e-12); // of the other two legs
      EXPECT_EQ(over.vertex, null_index);
      EXPECT_TRUE(strip_becomes_curve(b, over));
    }
  }
}

// The sheet is as thick as the legs. Each of the curves around one leg is shorter than the belt, both are longer.
TEST(Barriers, ABeltDoesNotPartIntoTwoThatTogetherAreLonger)
{
  Body b({leg(2), leg(7), {{5, 4, 9, 7, 7, 12}}, foot_of_leg(0, 5), foot_of_leg(7, 5)}, {on_left_leg});
  const Index c = b.belt({{{2, 4}}, {{10, 4}}, {{10, 7}}, {{2, 7}}}, 9);
  ASSERT_NEAR(b.length(c), 22, 1e-12);
  const Barrier over = b.barrier(c);
  EXPECT_NEAR(over.length, 20 + 2 * std::sqrt(5), 1e-9);
  EXPECT_EQ(over.end, Barrier_end::POINT);
  EXPECT_EQ(over.vertex, b.vertex(on_left_leg.at));
}

// A plate with a low spike, below which the rest of the tube is so short that the first boundary of the sweep lies behind all of it.
TEST(Barriers, AtTheEndOfAThinPlateABeltSlidesOff)
{
  Body b({above, tube}, {{{{3, 1. / 512, 6. / 128}}, 1, -2. / 512}}, {{1, 1. / 512, 1. / 128}});
  const Index c = b.belt(around_tube, 7);
  ASSERT_NE(c, null_index);
  ASSERT_NEAR(b.length(c), 8 * (1 + 1. / 512), 1e-12);
  const Barrier over = b.barrier(c);
  EXPECT_NEAR(over.length, b.length(c), 1e-9);
  EXPECT_EQ(over.end, Barrier_end::POINT);
  ASSERT_NE(over.vertex, null_index);
  EXPECT_LT(b.surface().point(over.vertex).z(), 7. / 128);
}

} // namespace test_barriers
