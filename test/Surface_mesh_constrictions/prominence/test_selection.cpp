// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace test_selection {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using real_meshes::read;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;

// A constriction that is nothing but these figures.
Constriction figures(double prominence, double ratio = 0.1, std::vector<std::size_t> dominated_by = {},
                     std::vector<std::size_t> crosses = {})
{
  Constriction::Data data;
  data.prominence = prominence;
  data.isoperimetric_ratio = ratio;
  data.separating = ratio > 0;
  if(!dominated_by.empty())
    data.dominated_by = dominated_by[0];
  data.crosses = crosses;
  return Constriction(data);
}

// A constriction that does not separate, and is nothing but these figures.
Constriction cycle(double length, double prominence, std::vector<std::size_t> homology_class,
                   std::vector<std::size_t> crosses_oddly, std::vector<std::size_t> crosses = {})
{
  Constriction::Data data;
  data.length = length;
  data.prominence = prominence;
  data.homology_class = homology_class;
  data.crosses = crosses;
  data.crosses_oddly = crosses_oddly;
  return Constriction(data);
}

template <class NamedParameters>
std::vector<double> select(const std::vector<Constriction>& given, const NamedParameters& np)
{
  std::vector<Constriction> selected;
  SMC::select_by_prominence(given, std::back_inserter(selected), np);
  std::vector<double> result;
  for(const Constriction& c : selected)
    result.push_back(c.prominence());
  return result;
}

typedef std::vector<double> Doubles;

TEST(Selection, TheMostProminentComeFirstAndThresholdsAreInclusive)
{
  const std::vector<Constriction> given = {figures(0.3), figures(0.5), figures(0.049), figures(0.05), figures(2)};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{2, 0.5, 0.3, 0.05}));
  EXPECT_EQ(select(given, params::minimum_prominence(0.5)), (Doubles{2, 0.5}));
  EXPECT_EQ(select(given, params::maximum_number_of_constrictions(std::size_t(3))), (Doubles{2, 0.5, 0.3}));
  EXPECT_EQ(select(given, params::maximum_number_of_constrictions(std::size_t(0))), Doubles());
  EXPECT_EQ(select(given, params::all_constrictions(true)), (Doubles{2, 0.5, 0.3, 0.05, 0.049}));
}

// A constriction of length 1 that is nothing but these figures.
Constriction beside(std::size_t other, double isolation, double prominence)
{
  Constriction::Data data = figures(prominence, 0.1, {other}).data();
  data.length = 1;
  data.isolation = isolation;
  return Constriction(data);
}

// 1 and 2 lie beside one that is more prominent. 4 is more prominent than the one beside it; what comes next is far.
TEST(Selection, OfThoseThatLieBesideEachOtherTheMoreProminentIsSelected)
{
  const std::vector<Constriction> given = {figures(1), beside(0, 0.1, 0.5), beside(1, 0.1, 0.4), beside(0, 0.2, 0.3),
                                           beside(1, 0.1, 0.6)};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{1, 0.6, 0.3}));
  EXPECT_EQ(select(given, params::minimum_isolation(0.)), (Doubles{1, 0.6, 0.5, 0.4, 0.3}));
  EXPECT_EQ(select(given, params::minimum_isolation(0.25)), (Doubles{1}));
  EXPECT_EQ(select(given, params::all_constrictions(true)), (Doubles{1, 0.6, 0.5, 0.4, 0.3}));
  EXPECT_EQ(select(given, params::maximum_number_of_constrictions(std::size_t(2))), (Doubles{1, 0.6}));
  std::vector<Constriction> selected;
  SMC::select_by_prominence(given, std::back_inserter(selected));
  ASSERT_EQ(selected.size(), 3u);
  EXPECT_DOUBLE_EQ(selected[1].isolation(), 0.2);
  EXPECT_EQ(selected[1].dominated_by(), std::optional<std::size_t>(0));
}

// 2 lies beside one that is hardly less prominent and is selected, 3 beside one that is not, and farther from the next.
TEST(Selection, WhatLiesBesideASelectedOneThatIsHardlyLessProminentIsNotSelected)
{
  for(double unit : {1., 1e-200, 1e200})
  {
    std::vector<Constriction> given;
    for(const Constriction& c : {figures(1), beside(0, 0.2, 0.5), beside(1, 0.1, 0.55), beside(2, 0.1, 0.6)})
    {
      Constriction::Data data = c.data();
      data.length = unit;
      given.push_back(Constriction(data));
    }
    EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{1, 0.6, 0.5})) << unit;
    EXPECT_EQ(select(given, params::minimum_isolation(0.05)), (Doubles{1, 0.6, 0.55, 0.5})) << unit;
  }
}

TEST(Selection, TheIsoperimetricRatioCountsForSeparatingCurvesOnly)
{
  const std::vector<Constriction> given = {figures(1, 0.3), figures(0.9, 0.25), figures(0.8, 0)};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{0.9, 0.8}));
  EXPECT_EQ(select(given, params::maximum_isoperimetric_ratio(0.5)), (Doubles{1, 0.9, 0.8}));
  EXPECT_EQ(select(given, params::maximum_isoperimetric_ratio(0.1)), (Doubles{0.8}));
}

TEST(Selection, OfTwoThatCrossTheMoreProminentIsSelected)
{
  // 1 crosses 0 and 2, which do not cross; 3 crosses 1, which is not selected
  const std::vector<Constriction> given = {figures(1), figures(0.9, 0.1, {}, {0, 2}), figures(0.8),
                                           figures(0.7, 0.1, {}, {1})};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{1, 0.8, 0.7}));
  EXPECT_EQ(select(given, params::crossing_constrictions(true)), (Doubles{1, 0.9, 0.8, 0.7}));
  EXPECT_EQ(select(given, params::all_constrictions(true)), (Doubles{1, 0.9, 0.8, 0.7}));
}

// A constriction that is nothing but these figures.
Constriction rival(double prominence, std::vector<std::size_t> rivals, std::vector<std::size_t> crosses)
{
  Constriction::Data data = figures(prominence, 0.1, {}, crosses).data();
  data.rivals = rivals;
  return Constriction(data);
}

TEST(Selection, OfTwoRivalsNeitherIsSelected)
{
  // 0 and 1; 2 crosses 1 alone
  const std::vector<Constriction> given = {rival(1, {1}, {}), rival(0.9, {0}, {0}), rival(0.5, {}, {1})};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{0.5}));
  EXPECT_EQ(select(given, params::crossing_constrictions(true)), (Doubles{1, 0.9, 0.5}));
  EXPECT_EQ(select(given, params::minimum_prominence(0.95)), (Doubles{1})); // the other one is not there
}

// A cross of cubes has nothing else: around its middle several run aslant.
TEST(Selection, WhereThereAreOnlyRivalsTheMostProminentIsSelected)
{
  const std::vector<Constriction> given = {rival(1, {1}, {}), rival(0.9, {0}, {0})};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{1}));
}

TEST(Selection, ARivalThatCrossesASelectedOneDoesNotCount)
{
  // 2 crosses 0, which is selected
  const std::vector<Constriction> given = {rival(1, {}, {}), rival(0.5, {2}, {}), rival(0.45, {1}, {0, 1})};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{1, 0.5}));
}

TEST(Selection, RoundOnesComeBeforeThoseThatLieAslant)
{
  std::vector<Constriction> given;
  for(const double roundness : {0.5, 0.9, 0.9})
  {
    Constriction::Data data = figures(given.empty() ? 1 : 0.6).data();
    data.length = static_cast<double>(given.size());
    data.roundness = roundness;
    given.push_back(Constriction(data));
  }
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{0.6, 0.6, 1}));
  EXPECT_EQ(select(given, params::maximum_number_of_constrictions(std::size_t(1))), (Doubles{0.6}));
  std::vector<Constriction> selected;
  SMC::select_by_prominence(given, std::back_inserter(selected));
  ASSERT_EQ(selected.size(), 3u);
  EXPECT_EQ(selected[0].length(), 1); // those of the same rank in their former order
}

TEST(Selection, BoundsOfTheLengthAreLookedAtLast)
{
  // 0 is crossed by 1; 2 slides to 3, which slides to 0
  std::vector<Constriction> given;
  const auto add = [&given](double length, const Constriction& c) {
    Constriction::Data data = c.data();
    data.length = length;
    data.isolation = std::numeric_limits<double>::infinity();
    given.push_back(Constriction(data));
  };
  add(2, figures(0.9));
  add(4, figures(0.8, 0.1, {}, {0}));
  add(6, figures(0.7, 0.1, {3}));
  add(5, figures(0.6, 0.1, {0}));
  add(8, figures(0.01));
  EXPECT_EQ(select(given, CGAL::parameters::default_values()), (Doubles{0.9, 0.7, 0.6}));
  EXPECT_EQ(select(given, params::minimum_curve_length(5.)), (Doubles{0.7, 0.6})); // not 0.8 instead of 0.9
  EXPECT_EQ(select(given, params::maximum_curve_length(5.)), (Doubles{0.9, 0.6}));
  EXPECT_EQ(select(given, params::minimum_curve_length(3.).maximum_curve_length(4.)), Doubles());
  EXPECT_EQ(select(given, params::minimum_curve_length(5.).maximum_number_of_constrictions(std::size_t(1))),
            (Doubles{0.7}));
  EXPECT_EQ(select(given, params::minimum_curve_length(4.).all_constrictions(true)), (Doubles{0.8, 0.7, 0.6, 0.01}));
  EXPECT_EQ(select(given, params::minimum_curve_length(5.).maximum_curve_length(4.)), Doubles());

  // what dominates a curve is passed over if it is left out
  std::vector<Constriction> selected;
  SMC::select_by_prominence(given, std::back_inserter(selected),
                            params::minimum_curve_length(5.5).crossing_constrictions(true));
  ASSERT_EQ(selected.size(), 1u);
  EXPECT_FALSE(selected[0].dominated_by());
  selected.clear();
  SMC::select_by_prominence(given, std::back_inserter(selected), params::minimum_curve_length(5.));
  ASSERT_EQ(selected.size(), 2u);
  EXPECT_EQ(selected[0].dominated_by(), std::optional<std::size_t>(1));
}

// Lengths that no bound meets exactly divide the result in two.
TEST(Selection, TheShorterAndTheLongerOnesTogetherAreAll)
{
  const Mesh mesh = read("homer.off");
  const auto lengths = [&mesh](const auto& np) {
    std::vector<Constriction> selected;
    SMC::detect_constrictions(mesh, std::back_inserter(selected), np);
    Doubles result;
    for(const Constriction& c : selected)
      result.push_back(c.length());
    return result;
  };
  const Doubles all = lengths(params::certify(false));
  ASSERT_GT(all.size(), 3u);
  Doubles sorted = all;
  std::sort(sorted.begin(), sorted.end());
  const double middle = (sorted[1] + sorted[2]) / 2;
  Doubles shorter, longer;
  std::copy_if(all.begin(), all.end(), std::back_inserter(shorter), [=](double l) { return l < middle; });
  std::copy_if(all.begin(), all.end(), std::back_inserter(longer), [=](double l) { return l > middle; });
  EXPECT_EQ(lengths(params::certify(false).maximum_curve_length(middle)), shorter);
  EXPECT_EQ(lengths(params::certify(false).minimum_curve_length(middle)), longer);
}

// A sash from a shoulder to under the other arm and its mirror image are as firm, and there is nothing to prefer one.
TEST(Selection, OfABearThatIsEvenlyBuiltItIsEven)
{
  const Mesh mesh = read("bear.off");
  std::vector<Constriction> selected, with_crossing;
  SMC::detect_constrictions(mesh, std::back_inserter(selected), params::certify(false));
  SMC::detect_constrictions(mesh, std::back_inserter(with_crossing),
                            params::certify(false).crossing_constrictions(true).minimum_isolation(0.));
  ASSERT_EQ(selected.size(), 8u); // neck, chest, arms, legs, ears
  EXPECT_EQ(with_crossing.size(), 10u);
  std::size_t with_rivals = 0;
  for(const Constriction& c : with_crossing)
    with_rivals += !c.rivals().empty();
  EXPECT_EQ(with_rivals, 2u);
  Doubles lengths;
  for(const Constriction& c : selected)
  {
    EXPECT_TRUE(c.rivals().empty());
    EXPECT_GT(c.roundness(), 0.8);
    EXPECT_LE(c.roundness(), 1);
    lengths.push_back(c.length());
  }
  std::sort(lengths.begin(), lengths.end());
  for(std::size_t i = 0; i < 6; i += 2) // ears, arms, legs: one and its mirror image
    EXPECT_NEAR(lengths[i], lengths[i + 1], 0.05 * lengths[i]);
}

// A meridian, an equator, and curves that wind around a torus both ways, once and twice around the meridian.
TEST(Selection, WhatWindsAroundATorusBothWaysIsComposed)
{
  const std::vector<Constriction> given = {cycle(4, 0.9, {0, 1}, {1, 2}), cycle(3, 0.5, {1}, {2}),
                                           cycle(1, 0.4, {0}, {}), cycle(5, 0.3, {1}, {0, 2}, {1}),
                                           cycle(2, 0.2, {0}, {0, 1, 3})};
  EXPECT_EQ(select(given, CGAL::parameters::default_values()),
            (Doubles{0.5, 0.4, 0.2})); // the last is another meridian
  EXPECT_EQ(select(given, params::crossing_constrictions(true)), (Doubles{0.9, 0.5, 0.4, 0.3, 0.2}));
}

// Four tubes between two bodies, genus 3: the four holes between neighbouring tubes are independent but for one, which
// crosses none of the others; it crosses two of the tubes.
TEST(Selection, ASumOfOthersThatItDoesNotCrossIsNotComposed)
{
  std::vector<Constriction> given;
  for(std::size_t i = 0; i < 3; ++i) // meridians of three tubes; that of the fourth is their sum
    given.push_back(cycle(1 + 0.01 * static_cast<double>(i), 2, {i}, {}));
  given.push_back(cycle(1.5, 2, {0, 1, 2}, {}));
  for(std::size_t i = 0; i < 3; ++i)
    given.push_back(cycle(2 + 0.01 * static_cast<double>(i), 1, {3 + i}, {i, (i + 1) % 4}));
  given.push_back(cycle(2.5, 1, {3, 4, 5}, {3, 0}));
  EXPECT_EQ(select(given, CGAL::parameters::default_values()).size(), 8u);
  given.push_back(cycle(2.6, 1, {3, 4, 5}, {3, 0}, {5})); // as the last one, but it crosses a hole that it is a sum of
  EXPECT_EQ(select(given, CGAL::parameters::default_values()).size(), 8u);
}

// The longest one is given first. Four that are just firm are enough.
TEST(Selection, WhatCrossesFourFirmShorterOnesIsOfAFamily)
{
  const double firm = SMC::internal::firm_prominence;
  std::vector<Constriction> given(1, cycle(2, 1, {}, {}, {1, 2, 3, 4}));
  given.resize(5, cycle(1, firm, {}, {}));
  EXPECT_EQ(SMC::internal::family_constrictions(given, {0, 1, 2, 3, 4}),
            std::vector<bool>({true, false, false, false, false}));
  given[4] = cycle(1, 0.99 * firm, {}, {});
  EXPECT_EQ(SMC::internal::family_constrictions(given, {0, 1, 2, 3, 4}), std::vector<bool>(5, false));
}

TEST(Selection, PlacesInTheHierarchySkipThoseThatAreNotSelected)
{
  // 4 -> 3 -> 2 -> 0 and 1 -> 3
  const std::vector<Constriction> given = {figures(0.2), figures(0.3, 0.1, {3}), figures(0.01, 0.1, {0}),
                                           figures(0.02, 0.1, {2}), figures(0.4, 0.1, {3})};
  std::vector<Constriction> selected;
  SMC::select_by_prominence(given, std::back_inserter(selected));
  ASSERT_EQ(selected.size(), 3u); // 4, 1 and 0
  ASSERT_TRUE(selected[0].dominated_by());
  EXPECT_EQ(*selected[0].dominated_by(), 2u);
  ASSERT_TRUE(selected[1].dominated_by());
  EXPECT_EQ(*selected[1].dominated_by(), 2u);
  EXPECT_FALSE(selected[2].dominated_by());
}

std::size_t number_of_equals(const std::vector<Constriction>& a, const std::vector<Constriction>& b)
{
  return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&b](const Constriction& c) {
    return std::any_of(b.begin(), b.end(), [&c](const Constriction& d) {
      return std::abs(c.length() - d.length()) < 1e-2 * c.length() && std::abs(c.prominence() - d.prominence()) < 0.05;
    });
  }));
}

// What non-face triangles lead to is all carried to the input, whatever is selected there.
TEST(Selection, FromAllThatWereFoundItIsWhatTheDetectionSelects)
{
  const Mesh mesh = read("dino.off");
  const auto triangles = params::seed_detection(SMC::Seed_detection::ON_APPEARANCE);
  std::vector<Constriction> all, direct, later;
  SMC::detect_constrictions(mesh, std::back_inserter(all), params::all_constrictions(true, triangles));
  SMC::detect_constrictions(mesh, std::back_inserter(direct), params::minimum_prominence(0.2, triangles));
  SMC::select_by_prominence(all, std::back_inserter(later), params::minimum_prominence(0.2));
  ASSERT_GE(direct.size(), 5u);
  ASSERT_EQ(later.size(), direct.size());
  for(std::size_t i = 0; i < direct.size(); ++i)
  {
    EXPECT_EQ(later[i].length(), direct[i].length());
    EXPECT_EQ(later[i].dominated_by(), direct[i].dominated_by());
    if(direct[i].dominated_by())
    {
      ASSERT_LT(*direct[i].dominated_by(), direct.size());
      EXPECT_LE(direct[*direct[i].dominated_by()].length(), direct[i].length());
    }
  }
}

TEST(Selection, OfProminencesMeasuredOnTheInputItIsNearlyThatOfTheDetection)
{
  const Mesh mesh = read("dino.off");
  std::vector<Constriction> all, direct, now;
  SMC::detect_constrictions(mesh, std::back_inserter(all), params::all_constrictions(true));
  SMC::detect_constrictions(mesh, std::back_inserter(direct), params::minimum_prominence(0.2));
  SMC::select_constrictions(mesh, all, std::back_inserter(now), params::minimum_prominence(0.2));
  ASSERT_GE(direct.size(), 10u);
  EXPECT_LE(direct.size(), now.size() + 2);
  EXPECT_LE(now.size(), direct.size() + 2);
  EXPECT_GE(number_of_equals(direct, now) + 2, direct.size());
  EXPECT_GE(number_of_equals(now, direct) + 2, now.size());
}

// On facets with noise a neck has closed geodesics that differ by the side on which they pass a vertex.
TEST(Selection, ANoisyNeckIsOneConstriction)
{
  for(unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    std::vector<Constriction> curves;
    SMC::detect_constrictions(test_meshes::make_mesh(test_meshes::dumbbell(0.1, seed)), std::back_inserter(curves));
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_GT(curves[0].prominence(), 1); // the bulges are twice as wide
  }
}

TEST(Selection, ACactusHasItsTrunkAndItsArms)
{
  std::vector<Constriction> curves;
  SMC::detect_constrictions(read("cactus.off"), std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_NEAR(curves[0].length(), 0.599, 0.001);
  EXPECT_NEAR(curves[1].length(), 0.284, 0.001);
  EXPECT_NEAR(curves[2].length(), 0.291, 0.001);
}

// Two rings that share a bar: the two holes, the bar, the thinnest places of the rings, and what goes around both
// holes. Of the last there are two lengths, and each has a mirror image, which may be found or not. Those that cross
// are not both selected.
TEST(Selection, AnEightHasItsHolesAndItsRings)
{
  std::vector<Constriction> curves;
  SMC::detect_constrictions(read("eight.off"), std::back_inserter(curves));
  std::size_t holes = 0, rings = 0, bars = 0, outlines = 0;
  std::set<std::vector<std::size_t>> classes_of_outlines;
  for(const Constriction& c : curves)
  {
    holes += c.side() == SMC::Side::COMPLEMENT && c.length() < 0.71;
    rings += c.side() == SMC::Side::OBJECT && c.length() < 0.44;
    bars += c.length() > 0.78 && c.length() < 0.8;
    if(c.length() > 1.7)
    {
      ++outlines;
      classes_of_outlines.emplace(c.homology_class().begin(), c.homology_class().end());
    }
    EXPECT_FALSE(c.is_separating());
    EXPECT_FALSE(c.homology_class().empty());
    EXPECT_TRUE(c.crosses().empty());
  }
  EXPECT_EQ(holes, 2u);
  EXPECT_EQ(rings, 4u);
  EXPECT_EQ(bars, 1u);
  EXPECT_LE(outlines, 2u);
  EXPECT_EQ(classes_of_outlines.size(), 1u);
  EXPECT_EQ(curves.size(), holes + rings + bars + outlines);
}

} // namespace test_selection
