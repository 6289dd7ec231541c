// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SPLIT_TESTS_H
#define SPLIT_TESTS_H

// Splitting along curves, tested for a type of mesh. Each type has a file of its own, since each takes long to compile.

#include "grid_torus.h"
#include "parts_check.h"
#include "random_geodesics.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <gtest/gtest.h>

#include <array>
#include <iterator>
#include <map>
#include <random>
#include <vector>

namespace split_tests {

namespace SMC = CGAL::Surface_mesh_constrictions;
using parts_check::expect_parts;
using random_geodesics::random_geodesics;

template <class T>
class Split : public testing::Test
{};

TYPED_TEST_SUITE_P(Split);

TYPED_TEST_P(Split, RandomSurfacesAlongRandomGeodesics)
{
  std::size_t used = 0, crossing = 0;
  for(unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(seed);
    TypeParam mesh = test_meshes::make_graph<TypeParam>(seed % 3 == 0   ? test_meshes::dumbbell(0.2, seed, 8, 7)
                                                        : seed % 3 == 1 ? test_meshes::torus(0.3, seed, 9, 6)
                                                                        : test_meshes::square_ring());
    const auto parts = expect_parts(mesh, random_geodesics(mesh, seed));
    for(const SMC::Cut_outcome& o : parts.curves.outcomes)
      ++(o.is_used ? used : crossing);
  }
  EXPECT_GT(used, 300u);
  EXPECT_GT(crossing, 200u);
}

// Whatever the parameters, nothing is flipped, and the parts are those of the combinatorial curves.
TYPED_TEST_P(Split, ParametersOfAnyValue)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> parameter(0, 4);
  for(unsigned seed = 1; seed < 60; seed += 3)
  {
    SCOPED_TRACE(seed);
    TypeParam mesh = test_meshes::make_graph<TypeParam>(test_meshes::torus(0.3, seed, 9, 6));
    std::vector<SMC::Constriction<TypeParam>> curves;
    for(const auto& c : random_geodesics(mesh, seed))
    {
      typename SMC::Constriction<TypeParam>::Data data = c.data();
      for(auto& l : data.locations)
        l.parameter = l.is_pivot ? 0 : parameter(random) / 4.;
      curves.push_back(SMC::Constriction<TypeParam>(data));
    }
    expect_parts(mesh, curves, false);
  }
}

TYPED_TEST_P(Split, AFaceThatIsCrossedManyTimes)
{
  for(const auto& [p, q] : std::vector<std::array<int, 2>>{{{1, 4}}, {{1, 9}}, {{2, 5}}, {{5, 3}}})
  {
    grid_torus::Grid_torus<TypeParam> torus(4, 3);
    const auto parts = expect_parts(
        torus.mesh, std::vector<SMC::Constriction<TypeParam>>{torus.line(0.11, p, q), torus.line(0.12, p, q)});
    EXPECT_EQ(parts.number_of_parts, 2u);
  }
}

// The order of the crossings follows from the halfedges that are crossed, not from their parameters.
TYPED_TEST_P(Split, ParametersThatCoincide)
{
  for(double parameter : {0., 0.5, 1.})
  {
    grid_torus::Grid_torus<TypeParam> torus(4, 3);
    const auto parts =
        expect_parts(torus.mesh, std::vector<SMC::Constriction<TypeParam>>{torus.line(0.11, 2, 5, parameter)});
    EXPECT_EQ(parts.number_of_parts, 1u);
    EXPECT_TRUE(parts.curves.outcomes[0].is_used);
  }
}

TYPED_TEST_P(Split, TouchingAndSharing)
{
  typedef std::vector<SMC::Constriction<TypeParam>> Curves;
  grid_torus::Grid_torus<TypeParam> a(6, 6), b(6, 6), c(6, 6);
  const std::vector<std::array<int, 2>> touching = {{{1, 0}}, {{2, 1}}, {{3, 2}}, {{3, 3}},
                                                    {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}};
  const std::vector<std::array<int, 2>> sharing = {{{1, 0}}, {{1, 1}}, {{1, 2}}, {{2, 3}},
                                                   {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}};
  EXPECT_EQ(expect_parts(a.mesh, Curves{a.meridian(1), a.path(touching)}).number_of_parts, 2u);
  EXPECT_EQ(expect_parts(b.mesh, Curves{b.meridian(1), b.path(sharing)}).number_of_parts, 2u);
  EXPECT_EQ(expect_parts(c.mesh, Curves{c.meridian(1), c.equator(1), c.meridian(1)}).number_of_parts, 1u);
}

TYPED_TEST_P(Split, KnownParts)
{
  TypeParam boxes = test_meshes::make_graph<TypeParam>(test_meshes::boxes_with_tube(2));
  std::vector<SMC::Constriction<TypeParam>> curves;
  SMC::detect_constrictions(boxes, std::back_inserter(curves));
  EXPECT_EQ(expect_parts(boxes, curves).number_of_parts, 2u);

  TypeParam dumbbell = test_meshes::make_graph<TypeParam>(test_meshes::dumbbell(0.1, 3));
  curves.clear();
  SMC::detect_constrictions(dumbbell, std::back_inserter(curves));
  const auto parts = expect_parts(dumbbell, curves);
  EXPECT_EQ(parts.number_of_parts, 2u);
  EXPECT_EQ(parts.curves.halfedges[0].size(), curves[0].locations().size());
}

TYPED_TEST_P(Split, WithoutCurvesNothingChanges)
{
  TypeParam mesh = test_meshes::make_graph<TypeParam>(test_meshes::torus(0.1, 1));
  const std::size_t before = edges(mesh).size();
  EXPECT_EQ(expect_parts(mesh, std::vector<SMC::Constriction<TypeParam>>()).number_of_parts, 1u);
  EXPECT_EQ(edges(mesh).size(), before);
}

// What is already marked stays marked, piece by piece.
TYPED_TEST_P(Split, MarksAreKept)
{
  grid_torus::Grid_torus<TypeParam> torus(6, 6);
  typedef typename boost::graph_traits<TypeParam>::edge_descriptor Edge;
  std::map<Edge, bool> mark;
  const auto marked = edge(torus.vertex(1, 0), torus.vertex(2, 0), torus.mesh).first;
  mark[marked] = true;
  const auto curves = std::vector<SMC::Constriction<TypeParam>>{torus.line(1.5, 1, 1)};
  const auto split = SMC::split_along_constrictions(
      torus.mesh, curves, CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(mark)));
  std::size_t marks = 0;
  for(const auto& m : mark)
    marks += m.second;
  EXPECT_EQ(marks, split.halfedges[0].size() + 2);
}

// The mesh is as it was when a curve does not fit.
TYPED_TEST_P(Split, ABadCurveLeavesTheMeshAlone)
{
  grid_torus::Grid_torus<TypeParam> torus(6, 6);
  const std::size_t before = edges(torus.mesh).size();
  const auto curves =
      std::vector<SMC::Constriction<TypeParam>>{torus.line(0.3, 1, 1), torus.path({{{0, 0}}, {{1, 0}}, {{3, 0}}})};
  EXPECT_THROW(SMC::split_along_constrictions(torus.mesh, curves), SMC::Invalid_input);
  EXPECT_EQ(edges(torus.mesh).size(), before);
}

REGISTER_TYPED_TEST_SUITE_P(Split, RandomSurfacesAlongRandomGeodesics, ParametersOfAnyValue,
                            AFaceThatIsCrossedManyTimes, ParametersThatCoincide, TouchingAndSharing, KnownParts,
                            WithoutCurvesNothingChanges, MarksAreKept, ABadCurveLeavesTheMeshAlone);

} // namespace split_tests

#endif // SPLIT_TESTS_H
