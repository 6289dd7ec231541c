// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Level_lengths.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace test_prominence {

namespace SMC = CGAL::Surface_mesh_constrictions;
using detection::detect;
using detection::detect_all;
using detection::detect_all_from_triangles;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;

// Linear between heights 0, 1/n, ..., 1.
double profile(const std::vector<double>& radii, double s)
{
  const double x = s * static_cast<double>(radii.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(x), radii.size() - 2);
  return radii[i] + (x - static_cast<double>(i)) * (radii[i + 1] - radii[i]);
}

// The perimeter of a regular 24-gon of radius 1.
const double around = 48 * std::sin(CGAL_PI / 24);

// A surface of revolution with these radii at equal distances, each circle a regular 24-gon.
Mesh revolution(const std::vector<double>& radii)
{
  return test_meshes::make_mesh(test_meshes::revolution([&](double s) { return profile(radii, s); },
                                                        3. * static_cast<double>(radii.size() - 1),
                                                        8 * static_cast<int>(radii.size() - 1), 24, 0, 0));
}

TEST(Prominence, TheBarrierOfANeckIsTheLowerOfTheBulgesBesideIt)
{
  const std::vector<Constriction> curves = detect(revolution({0.5, 1, 0.4, 0.8, 0.5}));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(curves[0].length(), 0.4 * around, 0.01);
  EXPECT_NEAR(curves[0].prominence(), 0.8 / 0.4 - 1, 0.03);
  EXPECT_FALSE(curves[0].dominated_by());
}

// On a noisy neck of many edges there are dozens of vertices that the curve may pass on either side, at nearly the same
// length, each on its own. Of the 2^n curves one stands for all.
TEST(Prominence, OneOfManyCurvesThatPassVerticesOnEitherSideStandsForAll)
{
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const std::vector<Constriction> curves =
        detect(test_meshes::make_mesh(test_meshes::chain_of_necks(0.004, seed, 120, 110)));
    EXPECT_EQ(curves.size(), 4u) << seed;
  }
}

// From the neck of radius 0.5 the bulge of 0.7 leads to the one of 0.3; from that, the end of 0.9 is the lower one.
TEST(Prominence, AShallowNeckSlidesToADeeperOneOverTheBulgeBetweenThem)
{
  const std::vector<Constriction> curves = detect(revolution({0.5, 1, 0.5, 0.7, 0.3, 0.9, 0.5}));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_NEAR(curves[0].length(), 0.3 * around, 0.01);
  EXPECT_NEAR(curves[0].prominence(), 0.9 / 0.3 - 1, 0.05);
  EXPECT_FALSE(curves[0].dominated_by());
  EXPECT_NEAR(curves[1].length(), 0.5 * around, 0.01);
  EXPECT_NEAR(curves[1].prominence(), 0.7 / 0.5 - 1, 0.03);
  ASSERT_TRUE(curves[1].dominated_by());
  EXPECT_EQ(*curves[1].dominated_by(), 0u);
}

// The shortest belts of a box of 2 x 3 x 3 have length 10, the longest 12; the level sets come over the edges of its
// square face before they come to the corners, and are longer.
TEST(Prominence, TheSquareTubeBetweenTwoBoxesIsHeldByTheBoxes)
{
  for(int length : {1, 5})
  {
    const std::vector<Constriction> curves = detect(test_meshes::make_mesh(test_meshes::boxes_with_tube(length)));
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_GT(curves[0].prominence(), 1);
    EXPECT_LT(curves[0].prominence(), 4);
    EXPECT_FALSE(curves[0].dominated_by());
  }
}

TEST(Prominence, LabelsUnitsAndTheDirectionOfTheFacesDoNotMatter)
{
  const test_meshes::Soup soup = test_meshes::dumbbell(0.1, 3);
  const std::vector<Constriction> expected = detect_all(test_meshes::make_mesh(soup));
  ASSERT_FALSE(expected.empty());
  for(const test_meshes::Soup& other :
      {test_meshes::relabelled(soup, 7), test_meshes::inside_out(soup), test_meshes::scaled(soup, 1e150)})
  {
    const std::vector<Constriction> found = detect_all(test_meshes::make_mesh(other));
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].prominence(), expected[i].prominence(), 0.01 * (1 + expected[i].prominence()));
  }
}

// The meridians of a bumpy torus slide along it into the shortest; level sets of the distance alone would lag behind on
// the outside.
TEST(Prominence, OfTheMeridiansOfABumpyTorusFewAreProminent)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.05, 2));
  std::size_t meridians = 0, prominent = 0;
  for(const Constriction& c : detect_all(mesh))
    if(std::abs(c.length() - 2 * CGAL_PI) < 0.5)
    {
      ++meridians;
      prominent += c.prominence() >= SMC::default_minimum_prominence;
    }
  EXPECT_GE(meridians, 5u);
  EXPECT_GE(prominent, 1u);
  EXPECT_LE(prominent, 3u);
}

// From non-face triangles, which are the same whatever other components there are.
// Meridians of a torus of twelve squares along the hole.
TEST(Prominence, TheAreaBetweenTwoCurvesIsThatOfTheShorterWay)
{
  const std::size_t along = 12, across = 8;
  const SMC::Progressive_mesh pm =
      test_meshes::make_progressive(test_meshes::torus(0, 1, static_cast<int>(along), static_cast<int>(across)));
  const SMC::internal::Surface_sides sides(pm);
  const auto meridian = [=](std::size_t i) {
    std::vector<SMC::internal::Trace_point> result;
    for(std::size_t j = 0; j < across; ++j)
      result.push_back({static_cast<SMC::Index>(i * across + j), SMC::null_index, 0});
    return result;
  };
  const double whole = sides.part(meridian(0)).areas[0];
  for(std::size_t i = 0; i < along; ++i)
    EXPECT_NEAR(sides.area_between(meridian(0), meridian(i)),
                whole * static_cast<double>((std::min)(i, along - i)) / 12, 1e-12 * whole);
}

TEST(Prominence, CurvesOfOtherComponentsDoNotMatter)
{
  const test_meshes::Soup a = test_meshes::dumbbell(0.1, 1), b = test_meshes::boxes_with_tube(3);
  std::multiset<double> expected;
  for(const test_meshes::Soup& soup : {a, b})
    for(const Constriction& c : detect_all_from_triangles(test_meshes::make_mesh(soup)))
      expected.insert(c.prominence());
  std::multiset<double> found;
  for(const Constriction& c : detect_all_from_triangles(test_meshes::make_mesh(test_meshes::joined(a, b, 20))))
    found.insert(c.prominence());
  ASSERT_EQ(found.size(), expected.size());
  for(auto x = found.begin(), y = expected.begin(); x != found.end(); ++x, ++y)
    EXPECT_NEAR(*x, *y, 1e-6);
}

// Their necks are as long and as prominent as each other, and at different places.
TEST(Prominence, EachOfTwoEqualBodiesHasItsNeck)
{
  const test_meshes::Soup body = test_meshes::boxes_with_tube(3);
  std::vector<Constriction> selected;
  SMC::select_by_prominence(detect_all(test_meshes::make_mesh(test_meshes::joined(body, body, 20))),
                            std::back_inserter(selected));
  ASSERT_EQ(selected.size(), 2u);
  for(const Constriction& c : selected)
    EXPECT_FALSE(c.dominated_by());
}

TEST(Prominence, ComputedAfterwardsItIsWhatTheDetectionComputes)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 3));
  const std::vector<Constriction> curves = detect_all(mesh);
  std::vector<Constriction> again;
  SMC::compute_prominences(mesh, curves, std::back_inserter(again));
  ASSERT_EQ(again.size(), curves.size());
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    EXPECT_NEAR(again[i].prominence(), curves[i].prominence(), 1e-9);
    EXPECT_EQ(again[i].dominated_by(), curves[i].dominated_by());
    EXPECT_EQ(again[i].crosses().size(), curves[i].crosses().size());
  }
}

TEST(Prominence, LocationsThatAreNoClosedCurveOnTheMeshAreRefused)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 3));
  std::vector<Constriction> curves = detect_all(mesh);
  ASSERT_GE(curves.size(), 2u);
  Constriction::Data data = curves[1].data();
  data.locations.pop_back();
  curves[1] = Constriction(data);
  std::vector<Constriction> again;
  try
  {
    SMC::compute_prominences(mesh, curves, std::back_inserter(again));
    FAIL() << "a gap";
  }
  catch(const SMC::Invalid_input& e)
  {
    EXPECT_EQ(e.defect(), SMC::Input_defect::INVALID_LOOP);
    EXPECT_EQ(e.element(), 1u);
    EXPECT_NE(std::string(e.what()).find("curve 1: point "), std::string::npos) << e.what();
  }
  EXPECT_TRUE(again.empty());
}

// The triangle (0,0) (2,0) (0,2) with values 0, 1, 2: the level set of 1 is the line from (2,0) to (0,1).
SMC::internal::Level_lengths::Triangle triangle()
{
  using SMC::internal::Vector3;
  return {{{Vector3{0, 2, 0}, 2.}, {Vector3{0, 0, 0}, 0.}, {Vector3{2, 0, 0}, 1.}}};
}

TEST(Prominence, LevelSetsOfATriangleAreMeasuredExactly)
{
  const SMC::internal::Level_scale scale(1);
  SMC::internal::Level_lengths lengths;
  lengths.add(scale, triangle());
  for(std::size_t k = 0; k < 600; ++k)
  {
    const double d = scale.level(k);
    const double expected = d <= 1 ? d * std::sqrt(5.) : d <= 2 ? (2 - d) * std::sqrt(5.) : 0;
    EXPECT_NEAR(lengths.length(k), expected, 1e-12) << d;
    EXPECT_EQ(scale.first_above(d), k + 1);
  }
}

// Also beyond the levels that are tabulated, and next to a level, where rounding may lead to its neighbour.
TEST(Prominence, TheFirstLevelAboveADistanceIsTheNextOne)
{
  for(double unit : {1., 0.7, 3.})
  {
    const SMC::internal::Level_scale scale(unit);
    for(std::size_t k = 1; k < 3000; ++k)
    {
      EXPECT_EQ(scale.first_above(scale.level(k)), k + 1);
      EXPECT_EQ(scale.first_above(std::nextafter(scale.level(k), 0)), k);
    }
  }
}

// With the other function 2 - f the domain ends at the level set of 1, which is left for good.
TEST(Prominence, WhereTwoSidesMeetTheEndOfTheDomainStays)
{
  const SMC::internal::Level_scale scale(1);
  SMC::internal::Level_lengths lengths;
  lengths.add(scale, triangle(), {{0, 2, 1.00001}});
  for(std::size_t k = 1; k < 600; ++k)
  {
    const double d = scale.level(k);
    EXPECT_NEAR(lengths.length(k), (d <= 1 ? d : 1) * std::sqrt(5.), 1e-4) << d;
  }
}

// Of two holes of nearly the same length the shorter one may be the less prominent one by less than they differ.
TEST(LevelEndless, NoneIsLessProminentThanItsLengthAllows)
{
  namespace internal = SMC::internal;
  const std::vector<double> lengths = {1, 1.0005, 2};
  std::vector<internal::Hierarchy_entry> entries(3);
  const std::vector<double> prominences = {0.0001, 0.5, 0.25};
  for(std::size_t i = 0; i < 3; ++i)
    entries[i] = {prominences[i], std::nullopt, SMC::null_index, false};
  internal::level_endless(
      lengths, [](std::size_t, std::size_t) { return true; }, entries);
  EXPECT_NEAR(entries[0].prominence, 0.0001, 1e-15);
  EXPECT_EQ(entries[1].prominence, 0);
  EXPECT_NEAR(entries[2].prominence, 0.25, 1e-15);
}

// Numbers 0 and 2 go around equal holes, numbers 1 and 3 around the body beside them.
TEST(LevelEndless, CurvesOfOtherShapesKeepTheirProminences)
{
  namespace internal = SMC::internal;
  const std::vector<double> lengths = {1, 1.0001, 1.0002, 1.0003};
  const std::vector<double> prominences = {0.5, 0.2, 0.4, 0.3};
  std::vector<internal::Hierarchy_entry> entries(4);
  for(std::size_t i = 0; i < 4; ++i)
    entries[i] = {prominences[i], std::nullopt, SMC::null_index, false};
  internal::level_endless(
      lengths, [](std::size_t i, std::size_t j) { return i % 2 == j % 2; }, entries);
  EXPECT_NEAR(entries[0].prominence, 1.4 * 1.0002 - 1, 1e-12);
  EXPECT_NEAR(entries[1].prominence, 0.2, 1e-12);
  EXPECT_NEAR(entries[2].prominence, 0.4, 1e-12);
  EXPECT_NEAR(entries[3].prominence, 1.2 * 1.0001 / 1.0003 - 1, 1e-12);
}

// At the places 0, 0.1, 0.5, 0.55, 0.6 of a line. The last one has an end.
TEST(LeadEndless, TheLongerOneOfTwoAtOnePlaceSlidesToTheOther)
{
  namespace internal = SMC::internal;
  const std::vector<double> lengths = {1.2, 1, 1.1, 1.3, 1}, places = {0, 0.1, 0.5, 0.55, 0.6};
  std::vector<internal::Hierarchy_entry> entries(5, {0.5, std::nullopt, SMC::null_index, false});
  entries[4].has_end = true;
  internal::lead_endless(
      lengths, [&](std::size_t i, std::size_t j) { return std::abs(places[i] - places[j]); }, entries);
  EXPECT_EQ(entries[0].dominated_by, 1u);
  EXPECT_FALSE(entries[1].dominated_by);
  EXPECT_FALSE(entries[2].dominated_by);
  EXPECT_EQ(entries[3].dominated_by, 2u);
  EXPECT_FALSE(entries[4].dominated_by);
}

// At the places 0, 0.1, 0.2, 0.5, 0.55, 0.6 of a line. Number 2 is less prominent, number 3 longer, and the last one
// slides to number 0, which is not at its place.
TEST(LeadTwins, TheLongerOneOfTwoAsProminentAtOnePlaceSlidesToTheOther)
{
  namespace internal = SMC::internal;
  const std::vector<double> lengths = {1.0002, 1, 1.0001, 1.1, 1.0003, 1.0004}, places = {0, 0.1, 0.2, 0.5, 0.55, 0.6};
  std::vector<internal::Hierarchy_entry> entries(6, {0.5, std::nullopt, 7, true});
  entries[2].prominence = 0.4;
  entries[5] = {0.5, 0, SMC::null_index, true};
  const auto lead = [&] {
    internal::lead_twins(
        lengths, [&](std::size_t i, std::size_t j) { return std::abs(places[i] - places[j]); }, entries);
  };
  lead();
  EXPECT_EQ(entries[0].dominated_by, 1u);
  EXPECT_EQ(entries[0].slides_off, SMC::null_index);
  EXPECT_EQ(entries[5].dominated_by, 4u);
  for(std::size_t i : {1, 2, 3, 4})
  {
    EXPECT_FALSE(entries[i].dominated_by) << i;
    EXPECT_EQ(entries[i].slides_off, 7u) << i;
  }

  entries[0].dominated_by.reset();
  entries[1].dominated_by = 0; // then the way would come back
  lead();
  EXPECT_FALSE(entries[0].dominated_by);
}

TEST(BreakRings, WaysThatComeBackEndAtTheFirstCurveOfTheRing)
{
  namespace internal = SMC::internal;
  std::vector<internal::Hierarchy_entry> entries(6, {0.5, std::nullopt, SMC::null_index, true});
  const std::vector<std::size_t> to = {3, 2, 3, 1, 5};
  for(std::size_t i = 0; i < to.size(); ++i)
    entries[i].dominated_by = to[i];
  internal::break_rings(entries); // 0 leads to the ring 3, 1, 2, and 4 to 5
  for(std::size_t i = 0; i < to.size(); ++i)
    if(i == 3)
      EXPECT_FALSE(entries[i].dominated_by);
    else
      EXPECT_EQ(entries[i].dominated_by, to[i]);
}

} // namespace test_prominence
