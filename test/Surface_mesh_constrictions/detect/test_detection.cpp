// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/geodesic_check.h"
#include "include/random_hull.h"
#include "include/statistics_taker.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace test_detection {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
using SMC::Seed_detection;
using SMC::Tightening_schedule;
using statistics_taker::Statistics_taker;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;

const std::vector<Seed_detection> detections = {Seed_detection::ON_APPEARANCE, Seed_detection::ON_REFUSED_COLLAPSE};
const std::vector<Tightening_schedule> schedules = {Tightening_schedule::EVERY_LEVEL, Tightening_schedule::AT_THE_END};

std::vector<Constriction> detect(const Mesh& mesh, Seed_detection detection = Seed_detection::ON_APPEARANCE,
                                 Tightening_schedule schedule = Tightening_schedule::AT_THE_END)
{
  SMC::Detection_statistics s;
  std::vector<Constriction> result;
  SMC::detect_constrictions(mesh, std::back_inserter(result),
                            SMC::parameters::all_constrictions(
                                true, SMC::parameters::seed_detection(
                                          detection, SMC::parameters::tightening_schedule(
                                                         schedule, CGAL::parameters::visitor(Statistics_taker(s))))));
  EXPECT_EQ(s.not_selected, 0u);
  EXPECT_EQ(s.seeds + s.barriers, s.degenerate + s.not_simple + s.merged + result.size());
  std::size_t seeds = 0;
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    geodesic_check::expect_closed_geodesic(mesh, result[i]);
    seeds += result[i].seeds().size();
    EXPECT_TRUE(i == 0 || result[i - 1].prominence() * result[i - 1].roundness() >=
                              result[i].prominence() * result[i].roundness());
  }
  EXPECT_EQ(seeds, s.merged + result.size());
  return result;
}

std::vector<double> lengths(const std::vector<Constriction>& curves)
{
  std::vector<double> result;
  for(const Constriction& c : curves)
    result.push_back(c.length());
  std::sort(result.begin(), result.end());
  return result;
}

void expect_none(const test_meshes::Soup& soup, const std::string& name)
{
  const Mesh mesh = test_meshes::make_mesh(soup);
  for(Seed_detection detection : detections)
    for(Tightening_schedule schedule : schedules)
      EXPECT_TRUE(detect(mesh, detection, schedule).empty()) << name;
}

TEST(Detection, AConvexPolyhedronHasNoConstriction)
{
  expect_none(test_meshes::tetrahedron(), "tetrahedron");
  expect_none(test_meshes::box(1, 1, 1), "cube");
  expect_none(test_meshes::box(4, 4, 4), "subdivided cube");
  expect_none(test_meshes::box(9, 2, 3, {{1, 0.7, 0.3}}), "long box");
  for(int n = 3; n <= 12; ++n)
  {
    expect_none(test_meshes::prism(n, 0.5), "flat prism");
    expect_none(test_meshes::prism(n, 10), "long prism");
  }
  for(unsigned seed = 0; seed < 30; ++seed)
    expect_none(test_meshes::random_hull(seed, 20 + 10 * static_cast<int>(seed % 5)), "hull");
}

TEST(Detection, TwoBoxesJoinedByASquareTubeHaveOneConstriction)
{
  for(int length : {1, 2, 5, 12})
    for(Seed_detection detection : detections)
      for(Tightening_schedule schedule : schedules)
      {
        const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(length));
        const std::vector<Constriction> curves = detect(mesh, detection, schedule);
        ASSERT_EQ(curves.size(), 1u) << length;
        EXPECT_NEAR(curves[0].length(), 4, 4e-12);
        EXPECT_NEAR(curves[0].flat_band_width(), length, 1e-12);
        EXPECT_TRUE(curves[0].is_separating());
        EXPECT_EQ(curves[0].side(), SMC::Side::OBJECT);
        // the curve is one end of the tube: a box of 2 x 3 x 3 less the opening is 41 on its side
        EXPECT_NEAR((std::min)(curves[0].areas()[0], curves[0].areas()[1]), 41, 1e-12);
        EXPECT_NEAR(curves[0].areas()[0] + curves[0].areas()[1], 82 + 4 * length, 1e-11);
        EXPECT_NEAR(curves[0].isoperimetric_ratio(), 16 / (4 * CGAL_PI * 41), 1e-12);
      }
}

TEST(Detection, ADumbbellHasItsNeckAndTheAreasAddUp)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.02, seed));
    const std::vector<Constriction> curves = detect(mesh);
    ASSERT_FALSE(curves.empty());
    const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh));
    for(const Constriction& c : curves)
    {
      EXPECT_TRUE(c.is_separating());
      EXPECT_NEAR(c.areas()[0] + c.areas()[1], area, 1e-12 * area);
      EXPECT_NEAR(c.length(), 2 * CGAL_PI * 0.4, 0.3);
      EXPECT_EQ(c.side(), SMC::Side::OBJECT);
    }
  }
}

TEST(Detection, ATorusHasMeridiansThatChokeTheObjectAndAnInnerEquatorThatChokesTheHole)
{
  for(bool inside_out : {false, true})
  {
    const test_meshes::Soup soup = test_meshes::torus(0.01, 2);
    const Mesh mesh = test_meshes::make_mesh(inside_out ? test_meshes::inside_out(soup) : soup);
    std::size_t meridians = 0, equators = 0;
    for(const Constriction& c : detect(mesh))
    {
      EXPECT_FALSE(c.is_separating());
      EXPECT_EQ(c.areas()[0], c.areas()[1]);
      if(std::abs(c.length() - 2 * CGAL_PI) < 0.4)
      {
        ++meridians;
        EXPECT_EQ(c.side(), SMC::Side::OBJECT);
      }
      if(std::abs(c.length() - 4 * CGAL_PI) < 0.4)
      {
        ++equators;
        EXPECT_EQ(c.side(), SMC::Side::COMPLEMENT);
      }
    }
    EXPECT_GE(meridians, 1u);
    EXPECT_GE(equators, 1u);
  }
}

// The noise makes all edge costs different, so the order of the collapses does not depend on labels.
TEST(Detection, LabelsAndRotationsDoNotMatter)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const test_meshes::Soup soup = seed % 2 == 0 ? test_meshes::dumbbell(0.1, seed) : test_meshes::torus(0.1, seed);
    const std::vector<double> expected = lengths(detect(test_meshes::make_mesh(soup)));
    ASSERT_FALSE(expected.empty());
    test_meshes::Soup turned = soup; // x -> y -> z -> x, and by an angle about z
    for(test_meshes::Position& p : turned.points)
    {
      std::rotate(p.begin(), p.begin() + 2, p.end());
      p = {{0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]}};
    }
    for(const test_meshes::Soup& other : {test_meshes::relabelled(soup, 5), test_meshes::relabelled(soup, 6), turned})
    {
      const std::vector<double> found = lengths(detect(test_meshes::make_mesh(other)));
      ASSERT_EQ(found.size(), expected.size());
      for(std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-10 * expected[i]);
    }
  }
}

TEST(Detection, TheSameInputGivesTheSameOutput)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 3));
  EXPECT_EQ(lengths(detect(mesh)), lengths(detect(mesh)));
}

TEST(Detection, NoTwoResultsAreEqual)
{
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    const std::vector<Constriction> curves = detect(test_meshes::make_mesh(test_meshes::torus(0.15, seed)));
    std::set<std::vector<std::size_t>> seen;
    for(const Constriction& c : curves)
    {
      std::vector<std::size_t> nodes;
      for(const auto& l : c.locations())
        nodes.push_back(l.is_pivot ? 2 * l.vertex.idx() : 2 * (l.halfedge.idx() / 2) + 1);
      std::sort(nodes.begin(), nodes.end());
      EXPECT_TRUE(seen.insert(nodes).second);
    }
  }
}

TEST(Detection, ComponentsAreIndependent)
{
  const test_meshes::Soup a = test_meshes::dumbbell(0.1, 1), b = test_meshes::boxes_with_tube(3);
  std::vector<double> expected = lengths(detect(test_meshes::make_mesh(a)));
  expected.push_back(4);
  std::sort(expected.begin(), expected.end());
  const std::vector<double> found = lengths(detect(test_meshes::make_mesh(test_meshes::joined(a, b, 20))));
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-10);
}

TEST(Detection, PoliciesOfTheUserAreUsed)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 9));
  std::vector<Constriction> lindstrom_turk, edge_length;
  SMC::detect_constrictions(mesh, std::back_inserter(lindstrom_turk),
                            CGAL::parameters::get_cost(SMS::LindstromTurk_cost<SMC::Simplification_mesh>())
                                .get_placement(SMS::LindstromTurk_placement<SMC::Simplification_mesh>()));
  SMC::detect_constrictions(mesh, std::back_inserter(edge_length),
                            SMC::parameters::tightening_schedule(Tightening_schedule::EVERY_LEVEL)
                                .get_cost(SMS::Edge_length_cost<SMC::Simplification_mesh>())
                                .get_placement(SMS::Midpoint_placement<SMC::Simplification_mesh>()));
  EXPECT_FALSE(lindstrom_turk.empty());
  EXPECT_FALSE(edge_length.empty());
}

// Found from seeds of different simplifications, the same curve has the same locations.
TEST(Detection, TheStartAndTheDirectionOfACurveDoNotDependOnTheSearch)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.15, 11));
  const auto find = [&mesh](const auto& policies) {
    std::vector<Constriction> result;
    SMC::detect_constrictions(
        mesh, std::back_inserter(result),
        SMC::parameters::all_constrictions(true, SMC::parameters::simplification_policies(policies)));
    return result;
  };
  const std::vector<Constriction> garland = find(SMC::Garland_heckbert_policies()),
                                  others = find(SMC::Edge_length_policies());
  std::size_t same = 0;
  for(const Constriction& c : garland)
  {
    EXPECT_EQ(c.pivots().front().location, 0u);
    for(const Constriction::Pivot& p : c.pivots())
      EXPECT_LE(c.locations().front().vertex, p.vertex);
    for(const Constriction& d : others)
    {
      if(std::abs(c.length() - d.length()) > 1e-12 * c.length())
        continue;
      ++same;
      EXPECT_EQ(c.length(), d.length());
      ASSERT_EQ(c.locations().size(), d.locations().size());
      for(std::size_t i = 0; i < c.locations().size(); ++i)
      {
        EXPECT_EQ(c.locations()[i].vertex, d.locations()[i].vertex);
        EXPECT_EQ(c.locations()[i].halfedge, d.locations()[i].halfedge);
        EXPECT_EQ(c.locations()[i].parameter, d.locations()[i].parameter);
      }
    }
  }
  EXPECT_GT(same, 5u);
}

// Seeds of all simplifications are followed, and each curve is found once. Levels are those of a seed's own
// simplification.
TEST(Detection, SeveralPoliciesFindWhatEachOfThemFinds)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.15, 11));
  const auto find = [&mesh](const auto& policies, SMC::Detection_statistics& s) {
    std::vector<Constriction> result;
    SMC::detect_constrictions(
        mesh, std::back_inserter(result),
        SMC::parameters::all_constrictions(
            true, SMC::parameters::simplification_policies(
                      policies, SMC::parameters::seed_detection(Seed_detection::ON_APPEARANCE,
                                                                CGAL::parameters::visitor(Statistics_taker(s))))));
    EXPECT_EQ(s.seeds + s.barriers, s.degenerate + s.not_simple + s.merged + result.size());
    return lengths(result);
  };
  SMC::Detection_statistics g, l, e, all, alone;
  const std::vector<double> garland = find(SMC::Garland_heckbert_policies(), g);
  std::vector<double> expected = garland;
  for(double length : find(SMC::Lindstrom_turk_policies(), l))
    expected.push_back(length);
  for(double length : find(SMC::Edge_length_policies(), e))
    expected.push_back(length);
  std::sort(expected.begin(), expected.end());
  const auto is_same = [](double a, double b) { return b - a < 1e-12 * b; };
  expected.erase(std::unique(expected.begin(), expected.end(), is_same), expected.end());
  std::vector<double> found = find(
      std::make_tuple(SMC::Garland_heckbert_policies(), SMC::Lindstrom_turk_policies(), SMC::Edge_length_policies()),
      all);
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_GT(found.size(), garland.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-12 * expected[i]);
  EXPECT_EQ(all.seeds, g.seeds + l.seeds + e.seeds);
  EXPECT_EQ(all.collapses, g.collapses + l.collapses + e.collapses);
  EXPECT_EQ(find(std::make_tuple(SMC::Garland_heckbert_policies()), alone), garland);
}

TEST(Detection, EverySeedIsAccountedForWhenSomeAreDiscardedEarly)
{
  for(const test_meshes::Soup& soup : {test_meshes::torus(0.15, 4, 60, 20), test_meshes::dumbbell(0.1, 3, 60, 40)})
  {
    SMC::Detection_statistics s;
    std::vector<Constriction> result;
    SMC::detect_constrictions(test_meshes::make_mesh(soup), std::back_inserter(result),
                              CGAL::parameters::visitor(Statistics_taker(s)));
    EXPECT_GT(s.discarded, 0u);
    EXPECT_EQ(s.not_certified, 0u);
    EXPECT_EQ(s.seeds + s.barriers,
              s.degenerate + s.discarded + s.not_simple + s.merged + s.not_selected + result.size());
  }
}

TEST(Detection, WithoutProminencesTheCurvesOfTheSeedsAreWrittenTheShortestFirst)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.15, 4, 10, 6));
  std::vector<Constriction> all, curves;
  SMC::detect_constrictions(mesh, std::back_inserter(all), SMC::parameters::all_constrictions(true));
  SMC::detect_constrictions(mesh, std::back_inserter(curves), SMC::parameters::measure_prominence(false));
  ASSERT_FALSE(curves.empty());
  std::multiset<double> lengths;
  for(const Constriction& c : all)
    lengths.insert(c.length());
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    EXPECT_TRUE(std::isnan(curves[i].prominence()) && std::isnan(curves[i].isolation()));
    EXPECT_FALSE(curves[i].dominated_by() || curves[i].slides_off());
    EXPECT_TRUE(curves[i].certificate().is_certified());
    EXPECT_TRUE(i == 0 || curves[i - 1].length() <= curves[i].length());
    EXPECT_EQ(lengths.count(curves[i].length()), 1u);
  }
}

TEST(Detection, OfASmallMeshNoSeedIsDiscardedAndTheSelectionIsThatOfAll)
{
  for(const test_meshes::Soup& soup : {test_meshes::torus(0.15, 4, 10, 6), test_meshes::torus(0.15, 4, 12, 8)})
  {
    const Mesh mesh = test_meshes::make_mesh(soup);
    SMC::Detection_statistics s;
    std::vector<Constriction> result, all, selected;
    SMC::detect_constrictions(mesh, std::back_inserter(result), CGAL::parameters::visitor(Statistics_taker(s)));
    SMC::detect_constrictions(mesh, std::back_inserter(all), SMC::parameters::all_constrictions(true));
    SMC::select_by_prominence(all, std::back_inserter(selected));
    EXPECT_EQ(s.discarded, 0u);
    EXPECT_GT(all.size(), selected.size());
    ASSERT_EQ(result.size(), selected.size());
    EXPECT_FALSE(result.empty());
    for(std::size_t i = 0; i < result.size(); ++i)
    {
      EXPECT_EQ(result[i].length(), selected[i].length());
      EXPECT_EQ(result[i].prominence(), selected[i].prominence());
    }
  }
}

// How many curves are to be certified.
struct Certification_size : public Statistics_taker
{
  std::size_t* curves;

  Certification_size(SMC::Detection_statistics& s, std::size_t& curves) : Statistics_taker(s), curves(&curves) {}
  void on_stage_begin(SMC::Detection_stage stage, std::size_t steps) const
  {
    if(stage == SMC::Detection_stage::CERTIFICATION)
      *curves = steps;
  }
};

// Two circles of a dumbbell are given as seeds on the input, which early merging does not see.
TEST(Detection, CurvesThatAreTooLongToBeSelectedAreNotCertified)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 3, 60, 40));
  std::vector<std::vector<SMC::Index>> circles(2);
  for(SMC::Index j = 0; j < 40; ++j)
  {
    circles[0].push_back(30 * 40 + j);
    circles[1].push_back(28 * 40 + j);
  }
  const auto certified = [&](double ratio, bool all) {
    SMC::Detection_statistics s;
    std::size_t curves = 0;
    std::vector<Constriction> result;
    SMC::detect_constrictions(
        mesh, std::back_inserter(result),
        SMC::parameters::seed_sources(SMC::Given_seeds(circles),
                                      SMC::parameters::maximum_isoperimetric_ratio(
                                          ratio, SMC::parameters::all_constrictions(
                                                     all, CGAL::parameters::visitor(Certification_size(s, curves))))));
    EXPECT_EQ(s.seeds + s.barriers, s.degenerate + s.merged + s.not_selected + result.size());
    EXPECT_EQ(s.discarded, 0u);
    return curves;
  };
  EXPECT_GT(certified(0.25, false), 0u);
  EXPECT_EQ(certified(0.001, false), 0u);
  EXPECT_EQ(certified(0.001, true), certified(0.25, true));
}

TEST(Detection, TheFirstSeedAloneGivesAtMostOneCurve)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  for(Seed_detection detection : detections)
  {
    SMC::Detection_statistics s;
    std::vector<Constriction> result;
    SMC::detect_constrictions(
        mesh, std::back_inserter(result),
        SMC::parameters::first_constriction_only(
            true, SMC::parameters::seed_detection(detection, CGAL::parameters::visitor(Statistics_taker(s)))));
    EXPECT_EQ(s.seeds, 1u);
    EXPECT_EQ(result.size() + s.degenerate + s.not_simple + s.not_selected, 1u);
  }
}

TEST(Detection, ChainedParametersMeanWhatNestedOnesMean)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  std::vector<Constriction> nested, chained, one;
  SMC::detect_constrictions(
      mesh, std::back_inserter(nested),
      SMC::parameters::all_constrictions(
          true, SMC::parameters::certify(false, CGAL::parameters::vertex_point_map(mesh.points()))));
  SMC::detect_constrictions(mesh, std::back_inserter(chained),
                            CGAL::parameters::all_constrictions(true).vertex_point_map(mesh.points()).certify(false));
  ASSERT_GT(chained.size(), 1u);
  ASSERT_EQ(chained.size(), nested.size());
  for(std::size_t i = 0; i < chained.size(); ++i)
  {
    EXPECT_EQ(chained[i].length(), nested[i].length());
    EXPECT_FALSE(chained[i].certificate().is_certified());
  }
  SMC::select_by_prominence(chained, std::back_inserter(one),
                            CGAL::parameters::all_constrictions(true).maximum_number_of_constrictions(std::size_t(1)));
  EXPECT_EQ(one.size(), 1u);
}

// Writes down what it is told.
struct Listener
{
  std::vector<std::string>* events;
  std::vector<std::size_t>* last;

  static std::string name(SMC::Detection_stage s) { return std::to_string(static_cast<int>(s)); }
  void on_stage_begin(SMC::Detection_stage s, std::size_t) const
  {
    events->push_back("begin " + name(s));
    last->push_back(0);
  }
  void on_step(SMC::Detection_stage, std::size_t done) const
  {
    EXPECT_GT(done, last->back());
    last->back() = done;
  }
  void on_stage_end(SMC::Detection_stage s) const { events->push_back("end " + name(s)); }
  void on_end(const SMC::Detection_statistics&) const { events->push_back("statistics"); }
};

TEST(Detection, TheVisitorHearsOfTheStagesInOrder)
{
  std::vector<std::string> events;
  std::vector<std::size_t> last;
  std::vector<Constriction> result;
  SMC::detect_constrictions(test_meshes::make_mesh(test_meshes::dumbbell(0.05, 2)), std::back_inserter(result),
                            CGAL::parameters::visitor(Listener{&events, &last}));
  EXPECT_EQ(events, (std::vector<std::string>{"begin 0", "end 0", "begin 1", "end 1", "begin 2", "end 2", "begin 3",
                                              "end 3", "begin 4", "end 4", "begin 5", "end 5", "statistics"}));
  ASSERT_EQ(last.size(), 6u);
  EXPECT_GT(last[0], 100u);
  EXPECT_EQ(last[1], last[0]);
  EXPECT_EQ(last[2], last[0]);
  EXPECT_GT(last[3], 0u);
  EXPECT_GT(last[5], result.size()); // it tells how far the measuring of a curve is
}

TEST(Detection, FaceLocationsAreThePoints)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 8));
  for(const Constriction& c : detect(mesh))
  {
    std::vector<Mesh::Point> points;
    std::vector<Constriction::Face_location> locations;
    c.points(mesh, std::back_inserter(points));
    c.face_locations(mesh, std::back_inserter(locations));
    ASSERT_EQ(points.size(), locations.size());
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const auto h = mesh.halfedge(locations[i].first);
      const auto& b = locations[i].second;
      const Mesh::Point p = CGAL::barycenter(mesh.point(mesh.source(h)), b[0], mesh.point(mesh.target(h)), b[1],
                                             mesh.point(mesh.target(mesh.next(h))), b[2]);
      EXPECT_LE(CGAL::squared_distance(p, points[i]), 1e-28);
    }
  }
}

} // namespace test_detection
