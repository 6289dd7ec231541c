// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Boundary_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Descents.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/vertex_passes.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace test_vertex_passes {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using internal::Arc;
using internal::Strip;
using internal::Vertex_pass;
using SMC::Curve_side;
using SMC::Index;
using SMC::null_index;

const double infinity = std::numeric_limits<double>::infinity();

// A pass with all arcs of the curve at the vertex; none if there is no pass.
struct Whole_pass
{
  std::vector<Arc> arcs;
  double length;
  Index vertex;
  Curve_side far_side;
};

// The pass of an arc of a curve over a vertex that is an end of one of its crossings, or opposite to it; no arcs if
// that is none.
Whole_pass pass_over(const SMC::Progressive_mesh& pm, const std::vector<Arc>& curve, std::size_t i, Index vertex,
                     std::size_t crossing, Curve_side side)
{
  internal::String_puller puller(pm);
  const Arc& arc = curve[i];
  const auto at = arc.crossings.begin() + static_cast<std::ptrdiff_t>(crossing);
  Strip before(arc.crossings.begin(), at), behind(at, arc.crossings.end());
  std::vector<Arc> to, from;
  puller.pull(arc.from, before, vertex, to);
  puller.pull(vertex, behind, arc.to, from);
  for(const Arc& a : curve)
    if(a.from == vertex)
      return {{}, 0, vertex, side};
  if(to.empty() || from.empty())
    return {{}, 0, vertex, side};
  const internal::Side_angles angles = internal::side_angles(pm, to.back(), from.front());
  if((side == Curve_side::LEFT ? angles.left : angles.right) >= CGAL_PI)
    return {{}, 0, vertex, side};
  Whole_pass result = {curve, 0, vertex, side};
  const auto place = result.arcs.erase(result.arcs.begin() + static_cast<std::ptrdiff_t>(i));
  to.insert(to.end(), from.begin(), from.end());
  result.arcs.insert(place, to.begin(), to.end());
  result.length = internal::total_length(result.arcs);
  return result;
}

// All of them, each once, the shortest first.
std::vector<Whole_pass> all_passes(const SMC::Progressive_mesh& pm, const std::vector<Arc>& curve)
{
  std::vector<Whole_pass> result;
  for(std::size_t i = 0; i < curve.size(); ++i)
  {
    std::set<std::pair<Index, Curve_side>> tried;
    const auto attempt = [&](Index vertex, std::size_t crossing, Curve_side side) {
      if(!tried.insert({vertex, side}).second)
        return;
      Whole_pass pass = pass_over(pm, curve, i, vertex, crossing, side);
      if(!pass.arcs.empty())
        result.push_back(std::move(pass));
    };
    if(curve[i].is_edge())
    {
      const Index h = curve[i].along;
      attempt(pm.target(pm.next(h)), 0, Curve_side::LEFT);
      attempt(pm.target(pm.next(pm.opposite(h))), 0, Curve_side::RIGHT);
    }
    for(std::size_t k = curve[i].crossings.size(); k-- > 0;)
    {
      attempt(pm.target(curve[i].crossings[k]), k, Curve_side::LEFT);
      attempt(pm.source(curve[i].crossings[k]), k, Curve_side::RIGHT);
    }
  }
  std::sort(result.begin(), result.end(), [](const Whole_pass& p, const Whole_pass& q) { return p.length < q.length; });
  return result;
}

// The curves that the rings of a surface of revolution become, in the order of their numbers.
std::set<Index> curves_of_rings(internal::Boundary_tightener& tightener, int along, int around)
{
  std::set<Index> result;
  for(int ring = 0; ring <= along; ++ring)
  {
    std::vector<Index> path;
    for(int j = 0; j < around; ++j)
      path.push_back(static_cast<Index>(ring * around + j));
    const Index c = tightener.tighten_path(path);
    if(c != null_index && tightener.is_simple(c))
      result.insert(c);
  }
  return result;
}

TEST(VertexPasses, AreAllOverVerticesBesideACurveThatLetItBecomeShorter)
{
  std::size_t along_edges = 0, across = 0;
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::dumbbell(0.1, seed, 24, 18));
    const internal::Corner_angles angles(pm);
    internal::Boundary_tightener tightener(pm, angles);
    for(Index c : curves_of_rings(tightener, 24, 18))
    {
      const std::vector<Arc> curve = tightener.arcs(c);
      const std::vector<Whole_pass> expected = all_passes(pm, curve);
      for(std::size_t n = 0; n <= expected.size(); ++n)
      {
        const double greatest_length = n < expected.size() ? expected[n].length * (1 - 1e-9) : infinity;
        const std::vector<Vertex_pass> found =
            internal::vertex_passes(pm, angles, curve, greatest_length, tightener.puller());
        ASSERT_EQ(found.size(), n);
        for(std::size_t k = 0; k < n; ++k)
        {
          EXPECT_EQ(found[k].vertex, expected[k].vertex);
          EXPECT_EQ(found[k].far_side, expected[k].far_side);
          EXPECT_NEAR(found[k].length, expected[k].length, 1e-12);
          EXPECT_NEAR(internal::total_length(internal::drawn_to_vertex(curve, found[k])), found[k].length, 1e-12);
        }
      }
      for(const Arc& a : curve)
        (a.is_edge() ? along_edges : across) += expected.size();
    }
  }
  EXPECT_GT(along_edges, 0u);
  EXPECT_GT(across, 0u);
}

// The lowest pass of a curve of less than a hundredth behind which it is shorter, and what it becomes; no arcs if there
// is none.
std::pair<Whole_pass, internal::Tightened_boundary> step(internal::Boundary_tightener& tightener, Index c)
{
  const double length = tightener.length(c);
  for(const Whole_pass& pass : all_passes(tightener.surface(), tightener.arcs(c)))
  {
    const internal::Tightened_boundary b = tightener.let_go(pass.arcs, pass.vertex, pass.far_side);
    if(pass.length <= 1.01 * length && b.is_simple && b.length < length * (1 - 1e-9))
      return {pass, b};
  }
  return {{{}, 0, null_index, Curve_side::LEFT}, {}};
}

// In whichever order curves are asked about.
TEST(Descents, LeadOverLowPassesToACurveThatHasNone)
{
  std::size_t points = 0, far = 0;
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::chain_of_necks(0.03, seed));
    const internal::Corner_angles angles(pm);
    internal::Boundary_tightener tightener(pm, angles);
    const std::set<Index> curves = curves_of_rings(tightener, 60, 20);
    for(bool is_reversed : {false, true})
    {
      std::vector<Index> order(curves.begin(), curves.end());
      if(is_reversed)
        std::reverse(order.begin(), order.end());
      internal::Descents descents(tightener, angles);
      for(Index c : order)
      {
        std::size_t steps = 0;
        double height = 0;
        Whole_pass last = {{}, 0, null_index, Curve_side::LEFT};
        Index end = c;
        while(end != null_index)
        {
          const auto [pass, b] = step(tightener, end);
          if(pass.arcs.empty())
            break;
          last = pass;
          height = (std::max)(height, pass.length);
          end = b.longest;
          ++steps;
        }
        const internal::Descent* const found = descents.descent(c);
        ASSERT_EQ(found != nullptr, steps > 0);
        if(found == nullptr)
          continue;
        EXPECT_EQ(found->curve, end);
        EXPECT_NEAR(found->height, height, 1e-12);
        EXPECT_EQ(found->strip, internal::strip_beside(pm, last.arcs, last.far_side));
        EXPECT_EQ(found->vertex, end == null_index ? last.vertex : null_index);
        points += end == null_index;
        far += steps > 2;
      }
    }
  }
  EXPECT_GT(points, 0u);
  EXPECT_GT(far, 0u);
}

// On a fine tube with noise, where a curve has many passes.
TEST(Descents, OverManyVerticesLeadToAShorterCurve)
{
  std::size_t number = 0, at_once = 0;
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::dumbbell(0.01, seed, 300, 300));
    const internal::Corner_angles angles(pm);
    internal::Boundary_tightener tightener(pm, angles);
    internal::Descents descents(tightener, angles);
    for(int ring = 100; ring <= 200; ring += 5)
    {
      std::vector<Index> path;
      for(int j = 0; j < 300; ++j)
        path.push_back(static_cast<Index>(ring * 300 + j));
      const Index c = tightener.tighten_path(path);
      ASSERT_NE(c, null_index);
      const double length = tightener.length(c);
      if(internal::vertex_passes(pm, angles, tightener.arcs(c), 1.01 * length, tightener.puller()).size() < 32)
        continue;
      const internal::Descent* const d = descents.descent(c);
      ASSERT_NE(d, nullptr);
      ASSERT_NE(d->curve, null_index);
      EXPECT_TRUE(tightener.is_simple(d->curve));
      EXPECT_LT(tightener.length(d->curve), length);
      EXPECT_GT(d->height, tightener.length(d->curve));
      EXPECT_LE(d->height, 1.01 * length);
      at_once += d->curve - c <= 2; // each curve behind a pass that is tried by itself gets a number
      EXPECT_EQ(descents.descent(d->curve), nullptr);
      ++number;
    }
  }
  EXPECT_GT(number, 3u);
  EXPECT_GT(at_once, 0u);
}

TEST(Descents, ACurveBehindABarrierHasNone)
{
  std::size_t number = 0;
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const SMC::Progressive_mesh pm = test_meshes::make_progressive(test_meshes::chain_of_necks(0.03, seed));
    const internal::Corner_angles angles(pm);
    const internal::Edge_lengths lengths(pm);
    internal::Barrier_search search(pm, lengths, angles);
    internal::Descents descents(search.tightener(), angles);
    for(Index c : curves_of_rings(search.tightener(), 60, 20))
    {
      const internal::Barrier b = search.search_vertices(search.tightener().arcs(c), true, infinity);
      if(b.end != internal::Barrier_end::CURVE)
        continue;
      EXPECT_LE(search.tightener().length(b.curve), search.tightener().length(c) * (1 + 1e-9));
      EXPECT_EQ(descents.descent(b.curve), nullptr);
      ++number;
    }
  }
  EXPECT_GT(number, 5u);
}

} // namespace test_vertex_passes
