// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Detected_hierarchy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/pinches.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

// What a curve slides to.
namespace test_ends {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using SMC::Index;
using SMC::null_index;
using test_meshes::Mesh;
using test_meshes::Soup;
typedef SMC::Constriction<Mesh> Constriction;

const int columns = 9, rows = 6; // of vertices

// Of the grid, where x is from -1 to 7 and y is from -1 to 4.
Index at(int x, int y) { return static_cast<Index>((y + 1) % rows * columns + (x + 1) % columns); }

// Unit squares, each with a diagonal to the upper right. The last row and column are joined to the first ones, so that
// the surface is closed. The ends of the middle one of the vertical edges with x = 3 are moved outwards by this much.
SMC::Progressive_mesh grid(double moved)
{
  Soup soup;
  for(int y = -1; y < rows - 1; ++y)
    for(int x = -1; x < columns - 1; ++x)
      soup.points.push_back({{static_cast<double>(x), static_cast<double>(y), 0}});
  soup.points[static_cast<std::size_t>(at(3, 1))][1] -= moved;
  soup.points[static_cast<std::size_t>(at(3, 2))][1] += moved;
  const auto corner = [](int x, int y) { return static_cast<std::size_t>(at(x, y)); };
  for(int y = -1; y < rows - 1; ++y)
    for(int x = -1; x < columns - 1; ++x)
    {
      soup.faces.push_back({{corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)}});
      soup.faces.push_back({{corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)}});
    }
  return test_meshes::make_progressive(soup);
}

typedef std::vector<internal::Trace_point> Trace;

void pass(Trace& trace, const std::vector<std::array<int, 2>>& vertices)
{
  for(const auto& v : vertices)
    trace.push_back({at(v[0], v[1]), null_index, 0});
}

// Around two rooms of 2 by 3 squares, on the left, and the corridor between them, of which these are the lower and the
// upper side.
Trace around_two_rooms(const Trace& lower, const Trace& upper)
{
  Trace trace;
  pass(trace, {{0, 0}, {1, 0}, {2, 0}, {2, 1}});
  trace.insert(trace.end(), lower.begin(), lower.end());
  pass(trace, {{4, 1}, {4, 0}, {5, 0}, {6, 0}, {6, 1}, {6, 2}, {6, 3}, {5, 3}, {4, 3}, {4, 2}});
  trace.insert(trace.end(), upper.begin(), upper.end());
  pass(trace, {{2, 2}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}});
  return trace;
}

// The only pinch is that of the corridor. It leaves a curve in each room.
double rise_in_corridor(const SMC::Progressive_mesh& pm, const Trace& trace)
{
  internal::Pinch_finder finder(pm);
  const std::vector<internal::Pinch> pinches = finder(trace);
  EXPECT_EQ(pinches.size(), 1u);
  if(pinches.size() != 1 || pinches[0].parts.size() != 2)
    return -1;
  Trace from_elsewhere = trace;
  for(std::size_t i = 1; i < trace.size(); ++i)
  {
    std::rotate(from_elsewhere.begin(), from_elsewhere.begin() + 1, from_elsewhere.end());
    const std::vector<internal::Pinch> same = finder(from_elsewhere);
    EXPECT_EQ(same.size(), 1u) << i;
    EXPECT_NEAR(same.front().rise, pinches[0].rise, 1e-12) << i;
    EXPECT_EQ(same.front().parts[0].size() + same.front().parts[1].size(),
              pinches[0].parts[0].size() + pinches[0].parts[1].size())
        << i;
  }
  bool is_left[2];
  for(std::size_t i = 0; i < 2; ++i)
  {
    std::size_t left = 0, ends = 0;
    for(Index h : pinches[0].parts[i])
      for(Index v : {pm.source(h), pm.target(h)})
      {
        ++ends;
        left += pm.point(v).x() < 3;
      }
    EXPECT_GT(ends, 0u);
    EXPECT_TRUE(left == 0 || left == ends);
    is_left[i] = left > 0;
  }
  EXPECT_NE(is_left[0], is_left[1]);
  return pinches[0].rise;
}

// Along the corridor the curve passes a pivot on each side. Its sides, of length 2 and at the distance 1, are straight,
// and become its diagonals.
TEST(Pinches, ACorridorIsPinchedInItsMiddleWhereverItsSidesPassVertices)
{
  const SMC::Progressive_mesh pm = grid(0);
  Trace lower, upper;
  pass(lower, {{3, 1}});
  pass(upper, {{3, 2}});
  EXPECT_NEAR(rise_in_corridor(pm, around_two_rooms(lower, upper)), 2 * std::sqrt(5) - 4, 1e-12);
}

// Where its sides are bent in the middle, it is two trapezoids of height 1, with parallel sides of length 1 and 2.
TEST(Pinches, ABentCorridorIsPinchedBetweenItsBends)
{
  const SMC::Progressive_mesh pm = grid(0.5);
  Trace lower, upper;
  pass(lower, {{3, 1}});
  pass(upper, {{3, 2}});
  EXPECT_NEAR(rise_in_corridor(pm, around_two_rooms(lower, upper)), 2 * std::sqrt(3.25) - 2 * std::sqrt(1.25), 1e-12);
}

// The same where no vertices are on its sides.
TEST(Pinches, ACorridorWithoutPivotsIsPinchedInItsMiddle)
{
  const SMC::Progressive_mesh pm = grid(0.5);
  const Trace lower = {{null_index, pm.halfedge(at(3, 1), at(3, 2)), 0.25},
                       {null_index, pm.halfedge(at(3, 1), at(4, 2)), 1. / 3}};
  const Trace upper = {{null_index, pm.halfedge(at(3, 2), at(3, 1)), 0.25},
                       {null_index, pm.halfedge(at(3, 2), at(2, 1)), 1. / 3}};
  EXPECT_NEAR(rise_in_corridor(pm, around_two_rooms(lower, upper)), 2 * std::sqrt(5) - 4, 1e-12);
}

// The curve is drawn out to the middle of the edge and back, from both of its ends.
TEST(Pinches, ADoorOfOneEdgeIsPinchedOnThatEdge)
{
  Trace trace;
  pass(trace, {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {6, 1}, {6, 2},
               {6, 3}, {5, 3}, {4, 3}, {3, 3}, {2, 2}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}});
  const SMC::Progressive_mesh pm = grid(0);
  const std::vector<internal::Pinch> pinches = internal::Pinch_finder(pm)(trace);
  ASSERT_EQ(pinches.size(), 1u);
  EXPECT_NEAR(pinches[0].rise, 2, 1e-12);
}

// On the other side only the edges that cut off a corner lie between two pivots; that is no pinch.
TEST(Pinches, TheOutsideOfACorridorHasNone)
{
  const SMC::Progressive_mesh pm = grid(0);
  Trace lower, upper;
  pass(lower, {{3, 1}});
  pass(upper, {{3, 2}});
  const Trace trace = internal::reversed(pm, around_two_rooms(lower, upper));
  EXPECT_TRUE(internal::Pinch_finder(pm)(trace).empty());
}

// A torus of three pentagons, the smallest of which has the radius 3. A curve on a torus that separates bounds a disc.
// On its other side, where the handle is, there may be no vertex; that side is no point that it slides off over, and
// does not come for free.
TEST(Ends, OnACoarseTorusWhatSeparatesHasAnEndAndABarrier)
{
  const std::array<double, 3> radii = {{8, 4, 3}};
  Soup soup;
  for(std::size_t i = 0; i < 3; ++i)
    for(int j = 0; j < 5; ++j)
    {
      const double u = -2 * CGAL_PI / 3 * static_cast<double>(i), v = 2 * CGAL_PI / 5 * j;
      const double distance = 12 + radii[i] * std::cos(v);
      soup.points.push_back({{distance * std::cos(u), distance * std::sin(u), radii[i] * std::sin(v)}});
    }
  const auto corner = [](std::size_t i, std::size_t j) { return i % 3 * 5 + j % 5; };
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 5; ++j)
    {
      soup.faces.push_back({{corner(i, j), corner(i, j + 1), corner(i + 1, j)}});
      soup.faces.push_back({{corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)}});
    }
  std::size_t separating = 0;
  for(const Constriction& c : detection::detect_all(test_meshes::make_mesh(soup)))
    if(c.is_separating())
    {
      ++separating;
      EXPECT_TRUE(c.dominated_by() || c.slides_off()) << c.length();
      EXPECT_GT(c.prominence(), 0.001) << c.length();
    }
  EXPECT_GT(separating, 0u);
}

// From the neck of radius 0.5 the bulge of 0.7 leads to the one of 0.3, and over its end of 0.9 that slides off.
TEST(Ends, ACurveThatSlidesToOneThatIsDroppedIsFollowedToItsEnd)
{
  const std::array<double, 7> radii = {{0.5, 1, 0.5, 0.7, 0.3, 0.9, 0.5}};
  const int around = 24, per_radius = 8;
  const auto radius = [&](double s) {
    const double x = s * 6;
    const std::size_t i = (std::min)(static_cast<std::size_t>(x), std::size_t(5));
    return radii[i] + (x - static_cast<double>(i)) * (radii[i + 1] - radii[i]);
  };
  const SMC::Progressive_mesh pm =
      test_meshes::make_progressive(test_meshes::revolution(radius, 18, 6 * per_radius, around, 0, 0));
  std::vector<Index> neck;
  for(int j = 0; j < around; ++j)
    neck.push_back(static_cast<Index>(2 * per_radius * around + j));
  internal::Curve_network network(pm, false);
  const Index c = network.add_curve(0, neck);
  std::vector<internal::Found_curve> found = {{c, network.length(c), 0, SMC::Certificate()}};
  std::vector<SMC::Refined_curve> refined = {{internal::curve_of_arcs(arcs_of_curve(network, c)), {0}, false}};
  std::vector<SMC::Seed_curve> seeds = {{0, neck, SMC::Seed_origin::USER}};
  const std::deque<internal::Measuring_level> no_levels;
  const internal::Surface_sides sides(pm);
  internal::Detected_hierarchy hierarchy(pm, no_levels, sides, network);
  std::size_t dropped = 0;
  hierarchy.close<CGAL::Sequential_tag>(
      found, refined, seeds,
      [&](std::vector<internal::Found_curve>& curves) {
        for(const internal::Found_curve& f : curves)
          network.remove(f.curve);
        dropped += curves.size();
        curves.clear();
      },
      [](std::size_t) {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(dropped, 1u);
  const internal::Hierarchy_entry entry = hierarchy.entries(found).front();
  EXPECT_NEAR(entry.prominence, 0.7 / 0.5 - 1, 0.03);
  EXPECT_FALSE(entry.dominated_by);
  ASSERT_NE(entry.slides_off, null_index);
  EXPECT_GT(entry.slides_off, static_cast<Index>(4 * per_radius * around));
}

// Some necks of a surface of revolution, the others that they slide to, and what is told of all of them.
struct Necks
{
  std::vector<internal::Found_curve> found;
  std::vector<internal::Hierarchy_entry> entries;
  std::size_t passed; // number of seeds of those that are skipped
};

// The surface has these radii at equal distances; `necks` are places among them.
Necks necks(const std::vector<double>& radii, const std::vector<int>& places)
{
  const int around = 24, per_radius = 8;
  const auto radius = [&](double s) {
    const double x = s * static_cast<double>(radii.size() - 1);
    const std::size_t i = (std::min)(static_cast<std::size_t>(x), radii.size() - 2);
    return radii[i] + (x - static_cast<double>(i)) * (radii[i + 1] - radii[i]);
  };
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(
      test_meshes::revolution(radius, 3. * static_cast<double>(radii.size() - 1),
                              per_radius * static_cast<int>(radii.size() - 1), around, 0, 0));
  internal::Curve_network network(pm, false);
  Necks result;
  std::vector<SMC::Refined_curve> refined;
  std::vector<SMC::Seed_curve> seeds;
  for(int place : places)
  {
    std::vector<Index> ring;
    for(int j = 0; j < around; ++j)
      ring.push_back(static_cast<Index>(place * per_radius * around + j));
    const Index c = network.add_curve(seeds.size(), ring);
    result.found.push_back({c, network.length(c), 0, SMC::Certificate()});
    refined.push_back({internal::curve_of_arcs(arcs_of_curve(network, c)), {seeds.size()}, false});
    seeds.push_back({0, ring, SMC::Seed_origin::USER});
  }
  const std::deque<internal::Measuring_level> no_levels;
  const internal::Surface_sides sides(pm);
  internal::Detected_hierarchy hierarchy(pm, no_levels, sides, network);
  result.passed = hierarchy.close<CGAL::Sequential_tag>(
      result.found, refined, seeds, [](std::vector<internal::Found_curve>&) {}, [](std::size_t) {});
  result.entries = hierarchy.entries(result.found);
  return result;
}

// Behind the bulge of 0.7 there is a neck of radius 0.4, which a bulge of 0.402 parts from one of 0.3.
TEST(Ends, ANeckThatHardlyHoldsIsSkipped)
{
  const Necks n = necks({0.5, 1, 0.5, 0.7, 0.4, 0.402, 0.3, 0.9, 0.5}, {2});
  ASSERT_EQ(n.found.size(), 2u);
  EXPECT_EQ(n.passed, 1u);
  EXPECT_NEAR(n.found[0].length / n.found[1].length, 0.3 / 0.5, 1e-3);
  EXPECT_NEAR(n.entries[0].prominence, 0.9 / 0.3 - 1, 0.05);
  EXPECT_FALSE(n.entries[0].dominated_by);
  EXPECT_TRUE(n.entries[0].has_end);
  EXPECT_NE(n.entries[0].slides_off, null_index);
  EXPECT_NEAR(n.entries[1].prominence, 0.7 / 0.5 - 1, 0.03);
  ASSERT_TRUE(n.entries[1].dominated_by);
  EXPECT_EQ(*n.entries[1].dominated_by, 0u);
  EXPECT_TRUE(n.entries[1].has_end);
}

// Of two necks of radius 0.4 each slides to the other one over the bulge of 0.7, so one stands for both.
TEST(Ends, OfTwoEqualNecksOneDominatesTheOther)
{
  for(const std::vector<int>& places : {std::vector<int>{2, 4}, {4, 2}, {2}, {4}})
  {
    const Necks n = necks({0.5, 1, 0.4, 0.7, 0.4, 1, 0.5}, places);
    if(places.size() == 1 && n.found.size() == 1) // the one that stands for both does not slide to the other one
    {
      EXPECT_NEAR(n.entries[0].prominence, 1 / 0.4 - 1, 0.05);
      EXPECT_NE(n.entries[0].slides_off, null_index);
      continue;
    }
    ASSERT_EQ(n.found.size(), 2u);
    EXPECT_EQ(n.passed, 0u);
    const std::size_t first = n.entries[0].dominated_by ? 1 : 0, other = 1 - first;
    EXPECT_FALSE(n.entries[first].dominated_by);
    EXPECT_NE(n.entries[first].slides_off, null_index);
    EXPECT_NEAR(n.entries[first].prominence, 1 / 0.4 - 1, 0.05);
    ASSERT_TRUE(n.entries[other].dominated_by);
    EXPECT_EQ(*n.entries[other].dominated_by, first);
    EXPECT_NEAR(n.entries[other].prominence, 0.7 / 0.4 - 1, 0.03);
  }
}

// Behind a bulge of radius 1.005 there is a neck of 0.995, and far behind that a long one of 1.003, longer than the
// first one. All of that is within three hundredths of its length.
TEST(Ends, AShallowNeckIsFoundInFrontOfALongOne)
{
  std::vector<double> radii = {0.5, 1.2, 1, 1.005, 0.995, 1.01};
  for(int i = 1; i <= 6; ++i)
    radii.push_back(1.01 - i * 0.007 / 6);
  for(int i = 1; i <= 6; ++i)
    radii.push_back(1.003 + i * 0.009 / 6);
  radii.push_back(0.3);
  const Necks n = necks(radii, {2});
  ASSERT_EQ(n.found.size(), 2u);
  EXPECT_NEAR(n.found[0].length / n.found[1].length, 0.995, 1e-4);
  EXPECT_NEAR(n.entries[0].prominence, 1.012 / 0.995 - 1, 0.003);
  EXPECT_FALSE(n.entries[0].dominated_by);
  EXPECT_NEAR(n.entries[1].prominence, 0.005, 0.003);
  ASSERT_TRUE(n.entries[1].dominated_by);
  EXPECT_EQ(*n.entries[1].dominated_by, 0u);
}

} // namespace test_ends
