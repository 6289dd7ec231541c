// SPDX-License-Identifier: GPL-3.0-or-later
// The parts for a number of parts are nested in those for any smaller one.
#include "include/grid_torus.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/nested_parts.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace test_nested_parts {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;

typedef SMC::Constriction<Mesh> Curve;
typedef grid_torus::Grid_torus<Mesh> Torus;
typedef std::set<std::size_t> Set;

template <class NamedParameters = CGAL::parameters::Default_named_parameters>
SMC::Surface_parts parts_of(const Mesh& mesh, const std::vector<Curve>& curves,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<std::size_t> part_of_face(mesh.num_faces());
  return SMC::segment_by_constrictions(mesh, curves, CGAL::make_property_map(part_of_face), np);
}

Set used(const SMC::Surface_parts& parts)
{
  Set result;
  for(std::size_t c = 0; c < parts.outcomes.size(); ++c)
    if(parts.outcomes[c].is_used)
      result.insert(c);
  return result;
}

Set used_with(const SMC::Surface_parts& parts, std::size_t n)
{
  Set result;
  for(const SMC::Nested_cut& c : parts.nested_cuts)
    if(c.number_of_parts <= n)
      result.insert(c.curve);
  return result;
}

// The areas of the parts that are united to n, ascending.
std::vector<double> areas_of_united(const SMC::Surface_parts& parts, std::size_t n)
{
  const std::vector<std::size_t> united = SMC::nested_parts(parts, n);
  std::vector<double> result;
  for(std::size_t p = 0; p < united.size(); ++p)
  {
    EXPECT_LE(united[p], result.size()); // counted in the order of their first parts
    if(united[p] == result.size())
      result.push_back(0);
    result[united[p]] += parts.parts[p].area;
  }
  std::sort(result.begin(), result.end());
  return result;
}

// One call gives what calls with each number of parts give.
void expect_nested(const Mesh& mesh, const std::vector<Curve>& curves, const std::vector<std::size_t>& numbers)
{
  const SMC::Surface_parts all = parts_of(mesh, curves);
  EXPECT_EQ(used_with(all, all.parts.size()), used(all));
  EXPECT_EQ(all.nested_cuts.size(), used(all).size());
  EXPECT_TRUE(std::is_sorted(all.nested_cuts.begin(), all.nested_cuts.end(),
                             [](const auto& a, const auto& b) { return a.number_of_parts < b.number_of_parts; }));
  Set before;
  for(std::size_t n : numbers)
  {
    SCOPED_TRACE(n);
    const SMC::Surface_parts some = parts_of(mesh, curves, SMC::parameters::maximum_number_of_parts(n));
    const Set cuts = used(some);
    EXPECT_TRUE(std::includes(cuts.begin(), cuts.end(), before.begin(), before.end()));
    EXPECT_EQ(cuts, used_with(all, n));
    EXPECT_EQ(some.nested_cuts.size(), all.nested_cuts.size());
    const std::vector<double> united = areas_of_united(all, n);
    ASSERT_EQ(united.size(), some.parts.size());
    std::vector<double> areas;
    for(const SMC::Surface_part& p : some.parts)
      areas.push_back(p.area);
    std::sort(areas.begin(), areas.end());
    for(std::size_t p = 0; p < areas.size(); ++p)
      EXPECT_NEAR(united[p], areas[p], 1e-9 * areas.back());
    before = cuts;
  }
}

std::vector<std::size_t> numbers_to(std::size_t n)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i <= n; ++i)
    result.push_back(i);
  return result;
}

TEST(Nested_parts, a_curve_that_makes_no_part_is_a_border_as_soon_as_the_next_that_does)
{
  const Torus torus(8, 6);
  const std::vector<Curve> curves = {torus.meridian(0, 0.4), torus.meridian(2, 0.3), torus.meridian(4, 0.2),
                                     torus.equator(1, 0.1)};
  const SMC::Surface_parts parts = parts_of(torus.mesh, curves);
  ASSERT_EQ(parts.nested_cuts.size(), 3u); // the equator crosses the others
  EXPECT_EQ(used_with(parts, 1), Set());
  EXPECT_EQ(used_with(parts, 2), (Set{0, 1}));
  EXPECT_EQ(used_with(parts, 3), (Set{0, 1, 2}));
  EXPECT_EQ(SMC::nested_parts(parts, 1), (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_EQ(SMC::nested_parts(parts, 3), (std::vector<std::size_t>{0, 1, 2}));
  expect_nested(torus.mesh, curves, numbers_to(5));
}

TEST(Nested_parts, a_last_curve_that_makes_no_part_is_a_border_of_all_parts)
{
  const Torus torus(8, 6);
  const SMC::Surface_parts parts = parts_of(torus.mesh, {torus.meridian(3)});
  ASSERT_EQ(parts.nested_cuts.size(), 1u);
  EXPECT_EQ(parts.nested_cuts[0].number_of_parts, 1u);
  expect_nested(torus.mesh, {torus.meridian(3)}, numbers_to(2));
}

// One that runs along two others by turns, and four times from one to the other, makes three parts at once.
TEST(Nested_parts, a_number_of_parts_that_no_curve_makes_is_left_out)
{
  const Torus torus(8, 6);
  const Curve beside_both =
      torus.path({{{1, 0}}, {{1, 1}}, {{2, 2}}, {{2, 3}}, {{1, 3}}, {{1, 4}}, {{2, 5}}, {{2, 6}}}, 0.1);
  const std::vector<Curve> curves = {torus.meridian(1, 0.3), torus.meridian(2, 0.2), beside_both};
  const SMC::Surface_parts parts = parts_of(torus.mesh, curves);
  Set numbers;
  for(const SMC::Nested_cut& c : parts.nested_cuts)
    numbers.insert(c.number_of_parts);
  EXPECT_EQ(numbers, (Set{2, 5}));
  expect_nested(torus.mesh, curves, numbers_to(8));
}

TEST(Nested_parts, components_are_parts_without_any_curve)
{
  const Mesh mesh =
      test_meshes::make_mesh(test_meshes::joined(test_meshes::boxes_with_tube(3), test_meshes::branches(), 30));
  std::vector<Curve> curves;
  SMC::detect_constrictions(mesh, std::back_inserter(curves), SMC::parameters::certify(false));
  EXPECT_GE(curves.size(), 4u); // the tube and the arms
  EXPECT_EQ(areas_of_united(parts_of(mesh, curves), 1).size(), 2u);
  expect_nested(mesh, curves, numbers_to(7));
}

TEST(Nested_parts, on_real_meshes)
{
  for(const char* name : {"cactus.off", "eight.off", "elephant.off", "man.off", "camel.off", "armadillo.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = real_meshes::read(name);
    std::vector<Curve> curves;
    SMC::detect_constrictions(mesh, std::back_inserter(curves),
                              SMC::parameters::certify(false, SMC::parameters::crossing_constrictions(
                                                                  true, SMC::parameters::minimum_prominence(0.01))));
    EXPECT_FALSE(curves.empty());
    const bool is_small = mesh.number_of_faces() < 10000;
    expect_nested(mesh, curves, is_small ? numbers_to(30) : std::vector<std::size_t>{2, 9, 30});
    // all numbers, from one call
    const SMC::Surface_parts all = parts_of(mesh, curves);
    for(std::size_t n = 1; n < 30; ++n)
    {
      const std::vector<std::size_t> coarse = SMC::nested_parts(all, n), fine = SMC::nested_parts(all, n + 1);
      EXPECT_LE(*std::max_element(coarse.begin(), coarse.end()), n - 1);
      std::vector<std::size_t> coarse_of_fine(fine.size(), fine.size());
      for(std::size_t p = 0; p < fine.size(); ++p)
      {
        if(coarse_of_fine[fine[p]] == fine.size())
          coarse_of_fine[fine[p]] = coarse[p];
        EXPECT_EQ(coarse_of_fine[fine[p]], coarse[p]);
      }
    }
  }
}

} // namespace test_nested_parts
