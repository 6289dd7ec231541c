// SPDX-License-Identifier: GPL-3.0-or-later
// The start and the direction of a closed curve.
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_canonical.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_make_canonical {

using namespace CGAL::Surface_mesh_constrictions;

void expect_equal(const Progressive_mesh& pm, const std::vector<internal::Arc>& a, const std::vector<internal::Arc>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].from, b[i].from);
    EXPECT_EQ(a[i].to, b[i].to);
    EXPECT_EQ(a[i].along, b[i].along);
    EXPECT_EQ(a[i].crossings, b[i].crossings);
    EXPECT_EQ(a[i].length, b[i].length);
    EXPECT_EQ(a[i].start_angle, b[i].start_angle);
    EXPECT_EQ(a[i].end_angle, b[i].end_angle);
    internal::Arc anew = a[i];
    internal::measure(pm, anew);
    EXPECT_NEAR(a[i].length, anew.length, 1e-12);
    EXPECT_NEAR(a[i].start_angle, anew.start_angle, 1e-12);
    EXPECT_NEAR(a[i].end_angle, anew.end_angle, 1e-12);
  }
}

// However the curve is given, it starts at its smallest pivot and has the same arcs with the same measures.
void expect_one_form(const Progressive_mesh& pm, const std::vector<internal::Arc>& arcs)
{
  internal::Curve_network network(pm, false);
  const auto canonical = [&](std::vector<internal::Arc> given) {
    const Index c = network.add_curve(0);
    network.set_arcs(c, given);
    internal::make_canonical(network, c);
    std::vector<internal::Arc> result = internal::arcs_of_curve(network, c);
    network.remove(c);
    return result;
  };
  const std::vector<internal::Arc> expected = canonical(arcs);
  for(const internal::Arc& a : expected)
    EXPECT_LE(expected[0].from, a.from);
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    std::vector<internal::Arc> turned = arcs;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(i), turned.end());
    expect_equal(pm, canonical(turned), expected);
    expect_equal(pm, canonical(internal::reversed(pm, turned)), expected);
  }
}

const Index around = 18; // vertices of a ring

Progressive_mesh neck() { return test_meshes::make_progressive(test_meshes::dumbbell(0.2, 1, 24, around)); }

Index ring(Index v) { return v / around; }

TEST(MakeCanonical, ACurveMayStartWithTheFirstArcThatItIsGiven)
{
  const Progressive_mesh pm = neck();
  internal::Curve_network network(pm, false);
  const Index c = network.add_curve(0, {around + 1, around, 0, 1});
  std::vector<internal::Arc> arcs = internal::arcs_of_curve(network, c);
  const Index first = arcs[0].from, second = arcs[1].from;
  network.set_arcs_in_order(c, arcs);
  const std::vector<internal::Arc> result = internal::arcs_of_curve(network, c);
  ASSERT_EQ(result.size(), 4u);
  EXPECT_EQ(result[0].from, first);
  EXPECT_EQ(result[1].from, second);
}

// The neighbours of the smallest pivot decide.
TEST(MakeCanonical, ACurveAlongEdgesHasOneStartAndOneDirection)
{
  const Progressive_mesh pm = neck();
  internal::Curve_network network(pm, false);
  expect_one_form(pm, internal::arcs_of_curve(network, network.add_curve(0, {around + 1, around, 0, 1})));
}

// From a vertex around the tube back to it, between two rings of vertices: only the crossed edges can decide.
TEST(MakeCanonical, ACurveWithOnePivotHasOneDirection)
{
  const Progressive_mesh pm = neck();
  const Index v = 12 * around, above = 13;
  const auto joins_rings = [&pm](Index h) {
    const Index a = ring(pm.source(h)), b = ring(pm.target(h));
    return std::min(a, b) + 1 == above && std::max(a, b) == above;
  };
  internal::Arc arc;
  arc.from = arc.to = v;
  Index h = pm.outgoing(v);
  while(!joins_rings(pm.next(h)))
    h = pm.ccw(h);
  arc.crossings.push_back(pm.next(h));
  for(;;)
  {
    const Index o = pm.opposite(arc.crossings.back());
    if(pm.source(pm.prev(o)) == v)
      break;
    arc.crossings.push_back(joins_rings(pm.next(o)) ? pm.next(o) : pm.prev(o));
    ASSERT_LE(arc.crossings.size(), 2 * around);
  }
  EXPECT_GE(arc.crossings.size(), around);
  internal::measure(pm, arc);
  expect_one_form(pm, {arc});
}

} // namespace test_make_canonical
