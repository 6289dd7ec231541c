// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Boundary_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_sweep.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Front_start.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// The boundaries of the regions around a curve.
namespace test_sweeps {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Strip;
using SMC::Index;
using SMC::null_index;
using test_meshes::Soup;

// A torus of rings of n vertices, made uneven.
Soup uneven_torus(int rings, int n, double unevenness, std::size_t seed)
{
  seeded_random::Random random(seed);
  Soup soup = test_meshes::torus(0, 1, rings, n);
  for(auto& p : soup.points)
    for(double& x : p)
      x += random.real(-unevenness, unevenness);
  return soup;
}

// The halfedges that a curve around a set of vertices crosses, from their face to the opposite one, from one that leads
// out of the set.
template <class IsInside>
Strip around(const SMC::Progressive_mesh& pm, Index h, const IsInside& is_inside)
{
  const Index first = h;
  Strip strip;
  do
  {
    strip.push_back(pm.opposite(h));
    h = pm.opposite(is_inside(pm.target(pm.next(h))) ? pm.next(h) : pm.prev(h));
  } while(h != first);
  return strip;
}

// Between a ring of a torus and the one before.
Strip before_ring(const SMC::Progressive_mesh& pm, int rings, int n, int ring)
{
  const Index begin = static_cast<Index>(ring * n), before = static_cast<Index>((ring + rings - 1) % rings * n);
  return around(pm, pm.halfedge(begin, before),
                [&](Index v) { return v >= begin && v < begin + static_cast<Index>(n); });
}

TEST(BoundaryTightener, ABoundaryOfSeveralCurvesIsNoneOfThem)
{
  const int rings = 12, n = 5;
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(uneven_torus(rings, n, 0, 0));
  const internal::Corner_angles angles(pm);
  internal::Boundary_tightener tightener(pm, angles);
  const Strip one = before_ring(pm, rings, n, 1), other = before_ring(pm, rings, n, 7),
              around_a_vertex = around(pm, pm.outgoing(3 * n), [](Index v) { return v == 3 * n; });
  const double infinity = (std::numeric_limits<double>::infinity)();
  const double length = tightener.tighten({one}, infinity, infinity).length;
  ASSERT_GT(length, 1);
  EXPECT_NEAR(tightener.tighten({other}, infinity, infinity).length, length, 1e-9);

  // longer than the limit, which is when the tightener stops, but not before it knows whether there are several
  const double limit = length / 2;
  for(const std::vector<Strip>& strips : {std::vector<Strip>{one, other}, {one, around_a_vertex, other}})
  {
    const internal::Tightened_boundary both = tightener.tighten(strips, infinity, limit);
    EXPECT_NEAR(both.length, 2 * length, 1e-9);
    EXPECT_NEAR(tightener.length(both.longest), length, 1e-9);
  }
  const internal::Tightened_boundary single = tightener.tighten({one, around_a_vertex}, infinity, limit);
  EXPECT_NEAR(single.length, length, 1e-9);
}

// The boundaries of three rings and a part of a fourth one. Of a boundary that is longer than it is said to be, the
// shortest loop through any of its corners is tightened, and otherwise that through its foremost corner, which is the
// shortest one.
TEST(BoundaryTightener, TheShortestLoopOfABoundaryIsTightened)
{
  const int rings = 8, n = 6;
  std::size_t boundaries = 0;
  for(std::size_t seed = 0; seed < 20; ++seed)
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(uneven_torus(rings, n, 0.5, seed));
    const internal::Corner_angles angles(pm);
    internal::Boundary_tightener tightener(pm, angles);
    seeded_random::Random random(seed);
    std::vector<bool> is_inside;
    for(int v = 0; v < rings * n; ++v)
      is_inside.push_back(v < 3 * n || (v < 4 * n && random.integer(2) == 0));
    for(Index h = 0; h < pm.number_of_halfedge_ids(); h += 7)
    {
      if(!is_inside[pm.source(h)] || is_inside[pm.target(h)])
        continue;
      const Strip strip = around(pm, h, [&](Index v) { return is_inside[v]; });
      const double infinity = (std::numeric_limits<double>::infinity)();
      EXPECT_EQ(tightener.tighten({strip}, 0, infinity).longest, tightener.tighten({strip}, infinity, infinity).longest)
          << "seed " << seed << ", halfedge " << h;
      ++boundaries;
    }
  }
  EXPECT_GT(boundaries, 50u);
}

// The lengths of the boundaries on a side, from the distances of all vertices.
internal::Level_lengths lengths_from_distances(const SMC::Progressive_mesh& pm, const internal::Edge_lengths& lengths,
                                               const std::vector<internal::Trace_point>& trace, std::size_t s,
                                               const internal::Level_scale& scale)
{
  internal::Distance_front front(pm, lengths);
  front.restart();
  std::array<internal::Front_start, 2> starts;
  internal::start_front(pm, trace, front, starts[0], starts[1]);
  for(;;)
    if(front.settle_next(front.next_distance(1 - s) < front.next_distance(s) ? 1 - s : s) == null_index)
      break;

  internal::Level_lengths result;
  for(const internal::Front_start::Piece& piece : starts[s].pieces)
  {
    internal::Level_lengths::Triangle t;
    for(std::size_t i = 0; i < 3; ++i)
      t[i] = {piece[i].point, piece[i].vertex != null_index ? front.distance(piece[i].vertex, s) : 0};
    result.add(scale, t);
  }
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
  {
    if(front.is_barred(f))
      continue;
    internal::Level_lengths::Triangle t;
    std::array<double, 3> others;
    int here = 0, there = 0;
    for(Index i = 0; i < 3; ++i)
    {
      const Index v = pm.source(3 * f + i);
      t[i] = {internal::position(pm, v), front.distance(v, s)};
      others[i] = front.distance(v, 1 - s);
      here += front.belongs_to(v, s);
      there += front.belongs_to(v, 1 - s);
    }
    if(here == 3)
      result.add(scale, t);
    else if(there != 3)
      result.add(scale, t, others);
  }
  return result;
}

// On coarse tori the sides of a curve meet at once, also in faces beside the curve.
TEST(DistanceSweep, WhereSidesMeetEachLevelIsCompleteWhenItIsRead)
{
  std::size_t levels = 0;
  for(std::size_t seed = 0; seed < 200; ++seed)
  {
    seeded_random::Random random(seed);
    const int rings = 3 + random.integer(3), n = 3 + random.integer(4);
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(uneven_torus(rings, n, 3, seed));
    const internal::Edge_lengths lengths(pm);
    std::vector<internal::Trace_point> trace;
    if(random.integer(2) == 0) // along the edges of a ring
      for(Index v = 0; v < static_cast<Index>(n); ++v)
        trace.push_back({v, null_index, 0});
    else // between two rings
      for(Index h : before_ring(pm, rings, n, 1))
        trace.push_back({null_index, h, random.real(0.2, 0.8)});
    double length = 0;
    for(std::size_t i = 0; i < trace.size(); ++i)
      length +=
          internal::norm(internal::position(pm, trace[(i + 1) % trace.size()]) - internal::position(pm, trace[i]));
    for(std::size_t s = 0; s < 2; ++s)
    {
      internal::Level_lengths expected = lengths_from_distances(pm, lengths, trace, s, internal::Level_scale(length));
      internal::Distance_sweep sweep(pm, lengths);
      sweep.start(trace, length, true);
      while(!sweep.is_used_up(s))
      {
        const double measured = sweep.advance(s);
        ASSERT_NEAR(measured, expected.length(sweep.level(s)), 1e-9 * length)
            << "seed " << seed << ", side " << s << ", level " << sweep.level(s);
        ++levels;
      }
    }
  }
  EXPECT_GT(levels, 10000u);
}

} // namespace test_sweeps
