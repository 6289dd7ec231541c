// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Around a bend the outside of a level set falls behind, and it gets over the next bulge aslant. From a longer curve
// behind the bend it does not.
namespace test_detours {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Barrier;
using internal::Barrier_end;
using SMC::Index;
using test_meshes::Soup;

const int around = 12; // vertices of a ring

// A ring of a pipe: its radius, how far it is from the one before, and by which angle it is turned against that.
struct Ring
{
  double radius, step, turn;
};

// A pipe that turns about the y axis, with an apex at either end.
Soup pipe(const std::vector<Ring>& rings)
{
  const int n = static_cast<int>(rings.size());
  Soup soup = test_meshes::revolution_of_profile(std::vector<std::array<double, 2>>(rings.size()), 0, 0, around, 0, 0);
  double x = 0, z = 0, turned = 0;
  for(int i = 0; i < n; ++i)
  {
    const Ring& ring = rings[static_cast<std::size_t>(i)];
    turned += ring.turn / 2;
    x += ring.step * std::sin(turned);
    z += ring.step * std::cos(turned);
    turned += ring.turn / 2;
    const auto place = [&](int vertex, double across, double y, double along) {
      soup.points[static_cast<std::size_t>(vertex)] = {{x + across * std::cos(turned) + along * std::sin(turned), y,
                                                        z - across * std::sin(turned) + along * std::cos(turned)}};
    };
    for(int j = 0; j < around; ++j)
    {
      const double phi = 2 * CGAL_PI * (j + 0.5 * (i % 2)) / around;
      place(i * around + j, ring.radius * std::cos(phi), ring.radius * std::sin(phi), 0);
    }
    if(i == 0)
      place(n * around, 0, 0, -0.2);
    if(i == n - 1)
      place(n * around + 1, 0, 0, 0.2);
  }
  return soup;
}

// From the neck of radius 0.5 the way leads around a quarter turn of radius 0.95, through a neck of 0.9, and over a
// bulge of 1.1. Behind that the pipe ends, or there is a neck of 0.4.
TEST(Detours, ABulgeBehindABendIsNoHigherThanItIsWide)
{
  for(bool ends : {true, false})
  {
    std::vector<Ring> rings = {{0.3, 0, 0}, {2, 1, 0}, {0.5, 2, 0}, {0.7, 1, 0}};
    for(int i = 0; i < 8; ++i)
      rings.push_back({0.95, 0.2, CGAL_PI / 16});
    rings.insert(rings.end(), {{0.95, 0.5, 0}, {0.9, 0.5, 0}, {1.1, 0.5, 0}});
    if(ends)
      rings.insert(rings.end(), {{0.9, 0.5, 0}, {0.3, 0.5, 0}});
    else
      rings.insert(rings.end(), {{0.4, 1, 0}, {2, 2, 0}, {0.3, 1, 0}});
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(pipe(rings));
    const internal::Edge_lengths lengths(pm);
    const internal::Corner_angles angles(pm);
    internal::Barrier_search search(pm, lengths, angles);
    std::vector<Index> neck;
    for(int j = 0; j < around; ++j)
      neck.push_back(static_cast<Index>(2 * around + j));
    const Index c = search.tightener().tighten_path(neck);
    const double length = search.tightener().length(c);
    ASSERT_NEAR(length, 2 * 0.5 * around * std::sin(CGAL_PI / around), 1e-9);
    const auto barrier = [&](std::size_t detours) {
      const std::vector<internal::Arc> arcs = search.tightener().arcs(c);
      return search.search(arcs, internal::trace(pm, arcs), true, std::numeric_limits<double>::infinity(), true,
                           detours);
    };
    const Barrier straight = barrier(0), found = barrier(16);
    EXPECT_EQ(found.end, ends ? Barrier_end::POINT : Barrier_end::CURVE);
    EXPECT_EQ(straight.end, found.end);
    EXPECT_GT(found.length / length, 0.95 / 0.5 + 0.1);
    EXPECT_LT(found.length / length, 1.1 / 0.5);
    EXPECT_GT(straight.length / length, 1.1 / 0.5 + 0.2);
    if(!ends)
    {
      EXPECT_NEAR(search.tightener().length(found.curve) / length, 0.4 / 0.5, 1e-9);
    }
  }
}

} // namespace test_detours
