// SPDX-License-Identifier: GPL-3.0-or-later
// What the detection keeps of the curves that the exact side cannot certify.
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/found_curves.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_found_curves {

using namespace CGAL::Surface_mesh_constrictions;
using test_meshes::Position;
using test_meshes::Soup;

// Stands for an Exact_settler: says the same of every curve, and may degenerate it. Notes the pivot that it names.
struct Settler_that_says
{
  Certificate_verdict verdict;
  bool degenerates;
  Index* named;

  Certificate settle(internal::Curve_network& network, Index c)
  {
    if(degenerates)
    {
      std::vector<internal::Arc> none;
      network.set_arcs(c, none);
    }
    else
      *named = internal::arcs_of_curve(network, c)[1].from;
    Certificate result;
    result.verdict = verdict;
    result.location = 1;
    return result;
  }

  std::size_t number_of_corrections() const { return 0; }
};

// The curve in the middle of the tube between two boxes, and what becomes of it.
struct Tube
{
  Progressive_mesh pm = test_meshes::make_progressive(test_meshes::boxes_with_tube(2));
  internal::Curve_network network{pm, false};
  std::vector<Refined_curve> refined;
  std::vector<internal::Found_curve> found;
  Detection_statistics statistics;
  Index named = null_index; // by the certificate

  // `x` and the cells that the square at x encloses: 1 is the tube, 3 the belt of a box.
  Tube(double x, double low, double high)
  {
    const Soup soup = test_meshes::boxes_with_tube(2);
    std::vector<Index> loop;
    const auto add = [&](double y, double z) {
      for(std::size_t v = 0; v < soup.points.size(); ++v)
        if(soup.points[v] == Position{{x, y, z}})
          loop.push_back(static_cast<Index>(v));
    };
    for(double t = low; t < high; ++t)
      add(t, low);
    for(double t = low; t < high; ++t)
      add(high, t);
    for(double t = high; t > low; --t)
      add(t, high);
    for(double t = high; t > low; --t)
      add(low, t);
    Refined_curve curve;
    curve.seeds = {0};
    refined.push_back(curve);
    const Index c = network.add_curve(0, loop);
    found.push_back({c, network.length(c), 0, Certificate()});
  }

  void certify(Certificate_verdict verdict, bool keeps_open, bool degenerates = false)
  {
    internal::certify_found<CGAL::Sequential_tag>(
        network,
        [&] {
          return Settler_that_says{verdict, degenerates, &named};
        },
        internal::Coordinate_unit(), keeps_open, refined, found, statistics, [](std::size_t) {});
  }
};

TEST(FoundCurves, WhatIsOpenStaysWithTheReasonUnlessOnlyCertifiedOnesAreAskedFor)
{
  for(Certificate_verdict verdict :
      {Certificate_verdict::TIE_NOT_PROVED, Certificate_verdict::ANGLE_BELOW_PI, Certificate_verdict::NOT_STRAIGHT})
  {
    Tube kept(3, 1, 2);
    kept.certify(verdict, true);
    ASSERT_EQ(kept.found.size(), 1u);
    EXPECT_EQ(kept.found[0].certificate.verdict, verdict);
    EXPECT_EQ(kept.found[0].certificate.location, 1u);
    EXPECT_EQ(internal::arcs_of_curve(kept.network, kept.found[0].curve)[1].from, kept.named);
    EXPECT_NEAR(kept.found[0].length, 4, 1e-12);
    EXPECT_EQ(kept.statistics.not_certified, 0u);

    Tube left_out(3, 1, 2);
    left_out.certify(verdict, false);
    EXPECT_TRUE(left_out.found.empty());
    EXPECT_EQ(left_out.statistics.not_certified, 1u);
  }
}

TEST(FoundCurves, WhatIsCertifiedStays)
{
  for(bool keeps_open : {false, true})
    for(Certificate_verdict verdict : {Certificate_verdict::STRICT_CONSTRICTION, Certificate_verdict::CONSTRICTION})
    {
      Tube tube(3, 1, 2);
      tube.certify(verdict, keeps_open);
      ASSERT_EQ(tube.found.size(), 1u);
      EXPECT_EQ(tube.found[0].certificate.verdict, verdict);
    }
}

TEST(FoundCurves, WhatIsRefutedIsDropped)
{
  for(Certificate_verdict verdict : {Certificate_verdict::CROSSES_ITSELF, Certificate_verdict::TOUCHES_ITSELF})
  {
    Tube tube(3, 1, 2);
    tube.certify(verdict, true);
    EXPECT_TRUE(tube.found.empty());
    EXPECT_EQ(tube.statistics.not_simple, 1u);
  }
  Tube leaking(3, 1, 2);
  leaking.certify(Certificate_verdict::LEAKY_BAND, true);
  EXPECT_TRUE(leaking.found.empty());
  EXPECT_EQ(leaking.statistics.not_certified, 1u);
  Tube shrunk(3, 1, 2);
  shrunk.certify(Certificate_verdict::NOT_COMPUTED, true, true);
  EXPECT_TRUE(shrunk.found.empty());
  EXPECT_EQ(shrunk.statistics.degenerate, 1u);
}

// At the rim of a box the angles towards its face are far below pi: whatever stayed open, that is no geodesic.
TEST(FoundCurves, WhatIsNoClosedGeodesicUpToRoundingIsDropped)
{
  Tube rim(0, 0, 3);
  rim.certify(Certificate_verdict::TIE_NOT_PROVED, true);
  EXPECT_TRUE(rim.found.empty());
  EXPECT_EQ(rim.statistics.not_certified, 1u);
}

} // namespace test_found_curves
