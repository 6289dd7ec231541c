// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/grid_torus.h"
#include "include/test_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_segmentation {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using detection::detect;
using SMC::Cut_outcome;
using SMC::segment_by_constrictions;
using SMC::Surface_parts;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Curve;
typedef grid_torus::Grid_torus<Mesh> Torus;

struct Segmentation
{
  std::map<Mesh::Face_index, std::size_t> patch;
  Surface_parts result;

  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Segmentation(const Mesh& mesh, const std::vector<Curve>& curves,
               const NamedParameters& np = CGAL::parameters::default_values())
    : result(segment_by_constrictions(mesh, curves, boost::make_assoc_property_map(patch), np))
  {}

  std::size_t size() const { return result.parts.size(); }
  const SMC::Surface_part& part(std::size_t i) const { return result.parts[i]; }
  bool is_used(std::size_t i) const { return result.outcomes[i].is_used; }
};

void expect_topology(const SMC::Surface_part& part, std::size_t genus, std::size_t boundaries)
{
  EXPECT_EQ(part.genus, genus);
  EXPECT_EQ(part.number_of_boundaries, boundaries);
}

TEST(Segmentation, WithoutCurvesPartsAreComponents)
{
  const Mesh mesh =
      test_meshes::make_mesh(test_meshes::joined(test_meshes::box(2, 2, 2), test_meshes::torus(0, 1), 30));
  const Segmentation s(mesh, {});
  ASSERT_EQ(s.size(), 2u);
  expect_topology(s.part(0), 0, 0);
  expect_topology(s.part(1), 1, 0);
  EXPECT_NEAR(s.part(0).area, 24, 1e-12);
  EXPECT_NEAR(s.part(0).volume, 8, 1e-12);
  EXPECT_EQ(s.part(0).number_of_faces, 48u);
  EXPECT_TRUE(s.result.adjacencies.empty());
}

// The curve is a square around the tube, at one of its ends: boxes of volume 2 * 3 * 3, and a tube of 2.
TEST(Segmentation, ATubeBelongsToOneOfItsBoxes)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(2));
  const std::vector<Curve> curves = detect(mesh);
  ASSERT_EQ(curves.size(), 1u);
  const Segmentation s(mesh, curves);
  ASSERT_EQ(s.size(), 2u);
  EXPECT_NEAR(s.part(0).area, 41, 1e-12);
  EXPECT_NEAR(s.part(1).area, 49, 1e-12);
  EXPECT_NEAR(s.part(0).volume, 18, 1e-12);
  EXPECT_NEAR(s.part(1).volume, 20, 1e-12);
  expect_topology(s.part(0), 0, 1);
  expect_topology(s.part(1), 0, 1);
  EXPECT_EQ(s.part(0).number_of_faces, 82u);
  EXPECT_EQ(s.part(1).number_of_faces, 98u);
  ASSERT_EQ(s.result.adjacencies.size(), 1u);
  EXPECT_EQ(s.result.adjacencies[0].curve, 0u);
  EXPECT_NE(s.result.adjacencies[0].parts[0], s.result.adjacencies[0].parts[1]);
  EXPECT_NEAR(s.result.adjacencies[0].length, 4, 1e-12);
  for(auto f : mesh.faces())
  {
    const double x =
        CGAL::centroid(mesh.point(mesh.source(mesh.halfedge(f))), mesh.point(mesh.target(mesh.halfedge(f))),
                       mesh.point(mesh.target(mesh.next(mesh.halfedge(f)))))
            .x();
    EXPECT_EQ(s.patch.at(f), x <= 2 ? 0u : 1u);
  }
}

TEST(Segmentation, AreasAreThoseThatTheCurveIsKnownToPart)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 3));
  const std::vector<Curve> curves = detect(mesh);
  ASSERT_EQ(curves.size(), 1u);
  const Segmentation s(mesh, curves);
  ASSERT_EQ(s.size(), 2u);
  const auto& [left, right] = s.result.adjacencies.at(0).parts;
  EXPECT_NEAR(s.part(left).area, curves[0].areas()[0], 1e-12 * curves[0].areas()[0]);
  EXPECT_NEAR(s.part(right).area, curves[0].areas()[1], 1e-12 * curves[0].areas()[1]);
  EXPECT_NEAR(s.part(0).volume + s.part(1).volume, PMP::volume(mesh), 1e-12);
  EXPECT_NEAR(s.result.adjacencies[0].length, curves[0].length(), 1e-12);
}

// Along x a plate with one hole, a bar, a plate with two holes, a bar, and a box without.
test_meshes::Soup plates_on_bars()
{
  return test_meshes::voxels({{27, 5, 3}}, [](int i, int j, int k) {
    const bool is_bar = j == 2 && k == 1, is_hole = (i == 2 || i == 11 || i == 15) && j == 2;
    const bool is_plate = i < 5 || (i >= 9 && i < 18) || i >= 22;
    return is_plate ? !is_hole && (k == 1 || i >= 22) : is_bar;
  });
}

// The parts are found by cutting the mesh, and their topology by counting in what is left.
TEST(Segmentation, GeneraAreThoseThatTheCurveIsKnownToPart)
{
  std::vector<test_meshes::Soup> soups;
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const test_meshes::Soup soup =
        test_meshes::relabelled(test_meshes::jittered(plates_on_bars(), 0.12 * seed / 4, seed), seed);
    soups.push_back(soup);
    soups.push_back(test_meshes::joined(test_meshes::torus(0.05, seed), test_meshes::inside_out(soup), 30));
  }
  std::set<std::array<std::size_t, 2>> separating, cutting;
  for(const test_meshes::Soup& soup : soups)
  {
    const Mesh mesh = test_meshes::make_mesh(soup);
    const std::vector<Curve> curves = detection::detect_all(mesh);
    for(const Curve& c : curves)
    {
      const Segmentation s(mesh, {c});
      ASSERT_TRUE(s.is_used(0));
      const auto& [left, right] = s.result.adjacencies.at(0).parts;
      EXPECT_EQ(c.is_separating(), left != right);
      EXPECT_EQ(c.genera(), (std::array<std::size_t, 2>{{s.part(left).genus, s.part(right).genus}}));
      (c.is_separating() ? separating : cutting).insert(c.genera());
    }
  }
  typedef std::set<std::array<std::size_t, 2>> Pairs;
  for(const Pairs::value_type& pair : Pairs{{{0, 3}}, {{1, 2}}, {{2, 1}}, {{3, 0}}})
    EXPECT_TRUE(separating.count(pair)) << pair[0] << " and " << pair[1];
  EXPECT_EQ(cutting, (Pairs{{{0, 0}}, {{2, 2}}}));
}

TEST(Segmentation, CoordinatesOfAnySize)
{
  for(double unit : {1e-130, 1e90})
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::scaled(test_meshes::boxes_with_tube(2), unit));
    const Segmentation s(mesh, detect(mesh));
    ASSERT_EQ(s.size(), 2u);
    EXPECT_NEAR(s.part(0).area / unit / unit, 41, 1e-10);
    const double unit_of_volume = unit * unit * unit; // the small one is less than any double
    EXPECT_NEAR(s.part(1).volume, 20 * unit_of_volume, 1e-10 * unit_of_volume);
  }
}

TEST(Segmentation, AMeridianLeavesOnePartOfATorus)
{
  const Torus torus(8, 6);
  const Segmentation s(torus.mesh, {torus.meridian(2)});
  ASSERT_EQ(s.size(), 1u);
  expect_topology(s.part(0), 0, 2);
  EXPECT_NEAR(s.part(0).area, PMP::area(torus.mesh), 1e-12 * s.part(0).area);
  EXPECT_NEAR(s.part(0).volume, PMP::volume(torus.mesh), 1e-12 * s.part(0).area);
  ASSERT_EQ(s.result.adjacencies.size(), 1u);
  EXPECT_EQ(s.result.adjacencies[0].parts, (std::array<std::size_t, 2>{{0, 0}}));
}

TEST(Segmentation, TwoMeridiansPartATorus)
{
  const Torus torus(8, 6);
  const Segmentation s(torus.mesh, {torus.meridian(2), torus.meridian(4)});
  ASSERT_EQ(s.size(), 2u);
  for(std::size_t i = 0; i < 2; ++i)
    expect_topology(s.part(i), 0, 2);
  EXPECT_NEAR(s.part(1).area / s.part(0).area, 1. / 3, 1e-9);
}

TEST(Segmentation, OfCurvesThatCrossTheMoreProminentCuts)
{
  const Torus torus(8, 6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const auto& [first, second] : std::vector<std::array<double, 2>>{
          {{0.1, 0.2}}, {{0.2, 0.1}}, {{0.1, 0.1}}, {{nan, nan}}, {{nan, 0}}, {{0, nan}}})
  {
    const Segmentation s(torus.mesh, {torus.meridian(2, first), torus.equator(1, second)});
    const std::size_t used = second > first || (std::isnan(first) && !std::isnan(second)) ? 1 : 0;
    EXPECT_TRUE(s.is_used(used));
    EXPECT_EQ(s.result.outcomes[used].crossed_curve, std::size_t(Cut_outcome::none));
    EXPECT_FALSE(s.is_used(1 - used));
    EXPECT_EQ(s.result.outcomes[1 - used].crossed_curve, used);
    EXPECT_EQ(s.size(), 1u);
  }
}

// A closed path that touches a meridian at one vertex: the part between them is pinched there.
TEST(Segmentation, CurvesThatTouchAtAPivot)
{
  const Torus torus(6, 6);
  const Curve touching = torus.path({{{1, 0}}, {{2, 1}}, {{3, 2}}, {{3, 3}}, {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}});
  for(const std::vector<Curve>& curves :
      {std::vector<Curve>{torus.meridian(1), touching}, std::vector<Curve>{touching, torus.meridian(1)}})
  {
    const Segmentation s(torus.mesh, curves);
    EXPECT_TRUE(s.is_used(0) && s.is_used(1));
    ASSERT_EQ(s.size(), 2u);
    const std::size_t pinched = s.part(0).number_of_boundaries == 1 ? 0 : 1;
    expect_topology(s.part(pinched), 0, 1);
    expect_topology(s.part(1 - pinched), 0, 2);
  }
}

TEST(Segmentation, CurvesThatShareEdges)
{
  const Torus torus(6, 6);
  const std::vector<std::array<int, 2>> path = {{{1, 0}}, {{1, 1}}, {{1, 2}}, {{2, 3}},
                                                {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}};
  const std::vector<std::array<int, 2>> reversed(path.rbegin(), path.rend());
  for(const Curve& sharing : {torus.path(path), torus.path(reversed)})
    for(bool first : {true, false})
    {
      const Segmentation s(torus.mesh, first ? std::vector<Curve>{sharing, torus.meridian(1)}
                                             : std::vector<Curve>{torus.meridian(1), sharing});
      EXPECT_TRUE(s.is_used(0) && s.is_used(1));
      ASSERT_EQ(s.size(), 2u);
      expect_topology(s.part(0), 0, s.part(0).number_of_boundaries);
      EXPECT_EQ(s.part(0).number_of_boundaries + s.part(1).number_of_boundaries, 3u);
      // on the shared edges the curve that was first meets the part between the two on neither side
      EXPECT_EQ(s.result.adjacencies.size(), 3u);
    }
  const Segmentation same(torus.mesh, {torus.meridian(1), torus.meridian(1)});
  EXPECT_TRUE(same.is_used(0) && same.is_used(1));
  EXPECT_EQ(same.size(), 1u);
}

TEST(Segmentation, CurvesThatCrossAlongSharedEdges)
{
  const Torus torus(6, 6);
  const std::vector<std::array<int, 2>> path = {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{1, 2}}, {{2, 2}},
                                                {{3, 2}}, {{4, 2}}, {{5, 2}}, {{5, 1}}, {{5, 0}}};
  const std::vector<std::array<int, 2>> reversed(path.rbegin(), path.rend());
  for(const Curve& crossing : {torus.path(path), torus.path(reversed)})
    for(bool first : {true, false})
    {
      const Segmentation s(torus.mesh, first ? std::vector<Curve>{crossing, torus.meridian(1)}
                                             : std::vector<Curve>{torus.meridian(1), crossing});
      EXPECT_TRUE(s.is_used(0));
      EXPECT_FALSE(s.is_used(1));
      EXPECT_EQ(s.result.outcomes[1].crossed_curve, 0u);
    }
}

TEST(Segmentation, ACurveThatRunsAlongAnEdgeCrossesOneThatCrossesTheEdge)
{
  const Torus torus(6, 6);
  for(bool first : {true, false})
  {
    const Curve line = torus.line(0.3, 1, 1);
    const Segmentation s(torus.mesh, first ? std::vector<Curve>{line, torus.meridian(1)}
                                           : std::vector<Curve>{torus.meridian(1), line});
    EXPECT_TRUE(s.is_used(0));
    EXPECT_FALSE(s.is_used(1));
  }
}

TEST(Segmentation, ACurveThatCrossesItselfDoesNotCut)
{
  const Torus torus(6, 6);
  std::vector<Curve> curves;
  curves.push_back(torus.path({{{0, 0}}, {{1, 0}}, {{2, 0}}, {{2, 1}}, {{1, 1}}, {{1, 0}}, {{1, 5}}, {{0, 5}}}));
  curves.push_back(torus.path({{{0, 0}}, {{1, 0}}}));                                         // there and back
  curves.push_back(torus.path({{{3, 3}}, {{4, 3}}, {{4, 4}}, {{5, 4}}, {{4, 4}}, {{3, 4}}})); // with a spur
  curves.push_back(torus.meridian(3));
  const Segmentation s(torus.mesh, curves);
  for(std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_FALSE(s.is_used(i));
    EXPECT_EQ(s.result.outcomes[i].crossed_curve, i);
  }
  EXPECT_TRUE(s.is_used(3));
}

// Two loops of one curve that meet at a vertex, side by side.
TEST(Segmentation, ACurveMayTouchItself)
{
  const Torus torus(6, 6);
  const Curve eight = torus.path({{{2, 2}}, {{3, 2}}, {{3, 3}}, {{2, 2}}, {{1, 1}}, {{2, 1}}});
  const Segmentation s(torus.mesh, {eight});
  EXPECT_TRUE(s.is_used(0));
  EXPECT_EQ(s.size(), 3u);
}

// Each crosses every face several times.
TEST(Segmentation, LinesThatWindAroundATorus)
{
  const Torus torus(4, 3);
  for(const auto& [p, q] : std::vector<std::array<int, 2>>{{{1, 4}}, {{1, 7}}, {{2, 5}}, {{3, 1}}, {{5, 3}}})
  {
    const Segmentation one(torus.mesh, {torus.line(0.11, p, q)});
    EXPECT_TRUE(one.is_used(0));
    ASSERT_EQ(one.size(), 1u);
    expect_topology(one.part(0), 0, 2);
    const Segmentation two(torus.mesh, {torus.line(0.11, p, q), torus.line(0.12, p, q)});
    EXPECT_TRUE(two.is_used(0) && two.is_used(1));
    ASSERT_EQ(two.size(), 2u);
    for(std::size_t i = 0; i < 2; ++i)
      expect_topology(two.part(i), 0, 2);
    // in the plane of the grid the strip between the lines is 0.01 wide, of 4 / q
    EXPECT_LT((std::min)(two.part(0).area, two.part(1).area), 0.05 * PMP::area(torus.mesh) * q / 4);
    const Segmentation crossing(torus.mesh, {torus.line(0.11, p, q), torus.line(0.12, p, q + p)});
    EXPECT_FALSE(crossing.is_used(1));
  }
}

TEST(Segmentation, CurvesAreChosen)
{
  const Torus torus(8, 6);
  std::vector<Curve> curves;
  for(int i = 0; i < 4; ++i)
  {
    Curve::Data data = torus.meridian(2 * i, 0.1 * (i + 1)).data();
    data.side = i % 2 == 0 ? SMC::Side::OBJECT : SMC::Side::COMPLEMENT;
    curves.push_back(Curve(data));
  }
  namespace params = SMC::parameters;
  const auto used = [&](const auto& np) {
    const Segmentation s(torus.mesh, curves, np);
    std::set<std::size_t> result;
    for(std::size_t i = 0; i < 4; ++i)
      if(s.is_used(i))
        result.insert(i);
    EXPECT_EQ(s.size(), result.empty() ? 1 : result.size());
    return result;
  };
  typedef std::set<std::size_t> Set;
  EXPECT_EQ(used(CGAL::parameters::default_values()), (Set{0, 1, 2, 3}));
  EXPECT_EQ(used(params::minimum_prominence(0.25)), (Set{2, 3}));
  EXPECT_EQ(used(params::choked_side(SMC::Side::OBJECT)), (Set{0, 2}));
  EXPECT_EQ(used(params::choked_side(SMC::Side::MIXED)), Set());
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(3))), (Set{1, 2, 3}));
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(2))), (Set{2, 3}));
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(1))), Set());
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(0))), Set());
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(9))), (Set{0, 1, 2, 3}));
  EXPECT_EQ(used(params::maximum_number_of_parts((std::numeric_limits<std::size_t>::max)())), (Set{0, 1, 2, 3}));
  EXPECT_EQ(used(params::maximum_number_of_parts(std::size_t(2), params::choked_side(SMC::Side::OBJECT))), (Set{0, 2}));
}

TEST(Segmentation, WhatIsNoClosedCurveIsRefused)
{
  const Torus torus(6, 6);
  const Curve good = torus.line(0.3, 1, 1);
  std::vector<Curve> bad = {Curve(), torus.path({{{0, 0}}}), torus.path({{{0, 0}}, {{1, 0}}, {{3, 0}}}),
                            torus.path({{{0, 0}}, {{0, 0}}, {{1, 0}}})};
  for(double t : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
  {
    Curve::Data data = good.data();
    data.locations[1].parameter = t;
    bad.push_back(Curve(data));
  }
  Curve::Data data = good.data();
  data.locations.erase(data.locations.begin());
  bad.push_back(Curve(data));
  data = good.data();
  data.locations[0] = {true, torus.vertex(3, 3), Mesh::null_halfedge(), 0};
  bad.push_back(Curve(data));
  for(const Curve& c : bad)
    try
    {
      Segmentation s(torus.mesh, {good, c});
      ADD_FAILURE();
    }
    catch(const SMC::Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), SMC::Input_defect::INVALID_LOOP);
      EXPECT_EQ(e.element(), 1u);
      EXPECT_EQ(std::string(e.what()).find("curve 1: "), 0u);
    }
}

} // namespace test_segmentation
