// SPDX-License-Identifier: GPL-3.0-or-later

// The step-by-step examples of the paper, Figures 8 and 9, on meshes of the same sizes.

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace test_paper_figures {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
typedef SMC::Progressive_mesh::Point Point;
typedef std::vector<Index> Path;

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q))); }

// The smallest of all rotations of a cycle and of its reverse.
Path canonical(Path cycle)
{
  Path best = cycle;
  for(int direction = 0; direction < 2; ++direction)
  {
    for(std::size_t i = 0; i < cycle.size(); ++i)
    {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      best = (std::min)(best, cycle);
    }
    std::reverse(cycle.begin(), cycle.end());
  }
  return best;
}

// Writes down the curve of one seed on each level.
struct Recorder : public SMC::Refinement_visitor_base
{
  std::map<std::size_t, SMC::Closed_curve> changes;

  template <class Curve>
  void on_curve(std::size_t level, const std::vector<std::size_t>&, const Curve& curve)
  {
    changes[level] = curve();
  }
};

// The pivots of a curve; fails if the curve crosses a face.
Path edge_cycle(const SMC::Closed_curve& curve)
{
  Path pivots;
  for(const auto& node : curve.nodes)
  {
    EXPECT_TRUE(node.is_pivot());
    pivots.push_back(node.pivot);
  }
  return canonical(pivots);
}

std::vector<SMC::Seed_curve> seeds_of(const SMC::Progressive_mesh& pm)
{
  std::vector<SMC::Seed_curve> seeds;
  SMC::non_face_triangles(pm, std::back_inserter(seeds));
  return seeds;
}

SMC::Progressive_mesh make_mesh(const std::vector<Point>& points, const std::vector<Path>& faces)
{
  Path corners;
  for(const Path& f : faces)
    corners.insert(corners.end(), f.begin(), f.end());
  return SMC::Progressive_mesh(SMC::internal::make_corner_table(points.size(), corners), points);
}

Point middle(const Point& p, const Point& q) { return CGAL::midpoint(p, q); }

double length_of_cycle(const SMC::Progressive_mesh& pm, const Path& cycle)
{
  double length = 0;
  for(std::size_t i = 0; i < cycle.size(); ++i)
    length += distance(pm.point(cycle[i]), pm.point(cycle[(i + 1) % cycle.size()]));
  return length;
}

// Two wings, joined at a pentagon r0 ... r4 in the plane x = 0. Every edge of a wing leaves the pentagon outwards, so
// that the surface has more than a half turn on both sides of each of its vertices: the pentagon is a geodesic.
enum Butterfly_vertex : Index
{
  R0,
  R1,
  R2,
  R3,
  R4,
  A0,
  A1,
  B0,
  B1,
  B2
};

SMC::Progressive_mesh butterfly()
{
  return make_mesh({Point(0, -1, 1), Point(0, 1, 1), Point(0, 2, -1), Point(0, 0, -2), Point(0, -2, -1),
                    Point(-8, 20, 8), Point(-8, -20, -8), Point(8, 0, 20), Point(8, 18, -12), Point(8, -18, -12)},
                   {{A0, R1, R0},
                    {A0, R2, R1},
                    {A0, R3, R2},
                    {A1, R4, R3},
                    {A1, R0, R4},
                    {A0, A1, R3},
                    {A0, R0, A1},
                    {B0, R0, R1},
                    {B0, R1, R2},
                    {B0, R2, B1},
                    {B1, R2, R3},
                    {B1, R3, B2},
                    {B2, R3, R4},
                    {B2, R4, R0},
                    {B2, R0, B0},
                    {B0, B1, B2}});
}

class Paper_figures : public testing::TestWithParam<SMC::Tightening_schedule>
{};

TEST_P(Paper_figures, ButterflyHasTheSizeOfFigure8)
{
  const SMC::Progressive_mesh pm = butterfly();
  EXPECT_EQ(pm.number_of_vertex_ids(), 10u);
  EXPECT_EQ(pm.number_of_face_ids(), 16u);
}

TEST_P(Paper_figures, ButterflyShowsItsFirstSeedAfterTwoCollapsesAndEachSplitCreatesAPivot)
{
  SMC::Progressive_mesh pm = butterfly();
  const Point r0 = pm.point(R0), r1 = pm.point(R1), r3 = pm.point(R3), r4 = pm.point(R4);
  EXPECT_TRUE(seeds_of(pm).empty());
  pm.append_collapse({R1, R0, middle(r0, r1)});
  EXPECT_TRUE(seeds_of(pm).empty());
  pm.append_collapse({R4, R3, middle(r3, r4)});
  // the neck, and a triangle that cuts off the single vertex A1: a wing of two vertices on a triangle always has such a
  // one, since there is only one triangulated sphere of five vertices
  std::vector<SMC::Seed_curve> seeds = seeds_of(pm);
  ASSERT_EQ(seeds.size(), 2u);
  EXPECT_EQ(canonical(seeds[0].vertices), canonical({R0, R2, R3}));
  EXPECT_EQ(canonical(seeds[1].vertices), canonical({R0, R3, A0}));
  EXPECT_EQ(seeds[0].level, 2u);
  seeds.pop_back();

  Recorder recorder;
  std::vector<SMC::Refined_curve> result;
  refine_seed_curves(pm, seeds, GetParam(), std::back_inserter(result), recorder);

  // beta_2: the seed. beta_1: R3 was the vertex that is split; the arc from R2 to R0 gets the two pivots R3 and R4
  // instead of it. beta_0: R0 is split, and the arc from R4 to R2 gets R0 and R1.
  EXPECT_EQ(recorder.changes.size(), 3u);
  EXPECT_EQ(edge_cycle(recorder.changes[2]), canonical({R0, R2, R3}));
  EXPECT_EQ(edge_cycle(recorder.changes[1]), canonical({R0, R2, R3, R4}));
  EXPECT_EQ(edge_cycle(recorder.changes[0]), canonical({R0, R1, R2, R3, R4}));
  ASSERT_EQ(result.size(), 1u);
  EXPECT_EQ(edge_cycle(result[0].curve), canonical({R0, R1, R2, R3, R4}));
  // 2 + 4 sqrt 5, read off the coordinates
  EXPECT_DOUBLE_EQ(length_of_cycle(pm, edge_cycle(result[0].curve)), 2 + 4 * std::sqrt(5.0));
}

// A pentagonal waist M0 ... M4 between two quadrilaterals that are turned against each other. The upper one is closed
// by four triangles, the lower one by two.
enum Cylinder_vertex : Index
{
  M0,
  M1,
  M2,
  M3,
  M4,
  T0,
  T1,
  T2,
  T3,
  L0,
  L1,
  L2,
  L3,
  TOP
};

SMC::Progressive_mesh twisted_cylinder()
{
  return make_mesh({Point(2, -1, 0), Point(2, 1, 0), Point(-1, 2, 0), Point(-2, 0, 0), Point(-1, -2, 0),
                    Point(12, 4, 6), Point(-4, 12, 6), Point(-12, -4, 6), Point(4, -12, 6), Point(9, -2, -6),
                    Point(2, 9, -6), Point(-9, 2, -6), Point(-2, -9, -6), Point(0, 0, 6)},
                   {{M0, M1, T0},  {M1, T1, T0},  {M1, M2, T1},  {M2, T2, T1},  {M2, M3, T2}, {M3, T3, T2},
                    {M3, M4, T3},  {M4, M0, T3},  {M0, T0, T3},  {M1, M0, L0},  {L0, L1, M1}, {M2, M1, L1},
                    {L1, L2, M2},  {M3, M2, L2},  {M4, M3, L2},  {L2, L3, M4},  {M0, M4, L3}, {L3, L0, M0},
                    {T0, T1, TOP}, {T1, T2, TOP}, {T2, T3, TOP}, {T3, T0, TOP}, {L1, L0, L2}, {L2, L0, L3}});
}

TEST_P(Paper_figures, TwistedCylinderHasTheSizeOfFigure9)
{
  const SMC::Progressive_mesh pm = twisted_cylinder();
  EXPECT_EQ(pm.number_of_vertex_ids(), 14u);
  EXPECT_EQ(pm.number_of_face_ids(), 24u);
}

TEST_P(Paper_figures, TwistedCylinderShowsItsFirstSeedAfterFourCollapsesAndTheLastSplitsLeaveTheCurveAlone)
{
  SMC::Progressive_mesh pm = twisted_cylinder();
  const Point m0 = pm.point(M0), m1 = pm.point(M1), m3 = pm.point(M3), m4 = pm.point(M4);
  const SMC::Edge_collapse collapses[] = {{TOP, T0, pm.point(T0)},
                                          {L1, L0, middle(pm.point(L0), pm.point(L1))},
                                          {M1, M0, middle(m0, m1)},
                                          {M4, M3, middle(m3, m4)}};
  for(const SMC::Edge_collapse& c : collapses)
  {
    EXPECT_TRUE(seeds_of(pm).empty()) << "at level " << pm.level();
    pm.append_collapse(c);
  }
  const std::vector<SMC::Seed_curve> seeds = seeds_of(pm);
  ASSERT_EQ(seeds.size(), 1u);
  EXPECT_EQ(seeds[0].level, 4u);
  EXPECT_EQ(canonical(seeds[0].vertices), canonical({M0, M2, M3}));

  Recorder recorder;
  std::vector<SMC::Refined_curve> result;
  refine_seed_curves(pm, seeds, GetParam(), std::back_inserter(result), recorder);

  // beta_4: the seed. beta_3 and beta_2 get a pivot each. The ends are not touched by the curve:
  // beta_0 = beta_1 = beta_2.
  EXPECT_EQ(recorder.changes.size(), 3u);
  EXPECT_EQ(edge_cycle(recorder.changes[4]), canonical({M0, M2, M3}));
  EXPECT_EQ(edge_cycle(recorder.changes[3]), canonical({M0, M2, M3, M4}));
  EXPECT_EQ(edge_cycle(recorder.changes[2]), canonical({M0, M1, M2, M3, M4}));
  ASSERT_EQ(result.size(), 1u);
  EXPECT_EQ(edge_cycle(result[0].curve), canonical({M0, M1, M2, M3, M4}));
  // 2 + 2 sqrt 5 + 2 sqrt 10 - read off the coordinates: |M0 M1| = 2, |M1 M2| = |M4 M0| = sqrt 10, the others sqrt 5
  EXPECT_DOUBLE_EQ(length_of_cycle(pm, edge_cycle(result[0].curve)), 2 + 2 * std::sqrt(5.0) + 2 * std::sqrt(10.0));
}

INSTANTIATE_TEST_SUITE_P(Schedules, Paper_figures,
                         testing::Values(SMC::Tightening_schedule::EVERY_LEVEL, SMC::Tightening_schedule::AT_THE_END));

} // namespace test_paper_figures
