// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/geodesic_check.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

namespace test_real_meshes {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;

// What is found on it without a selection takes a minute.
bool is_slow(const Mesh& mesh)
{
  return mesh.number_of_faces() > 50000 && std::getenv("CONSTRICTIONS_ALL_CURVES") == nullptr;
}

std::vector<Constriction> detect(const std::string& name)
{
  const Mesh mesh = real_meshes::read(name);
  std::vector<Constriction> curves;
  SMC::detect_constrictions(mesh, std::back_inserter(curves), SMC::parameters::all_constrictions(!is_slow(mesh)));
  for(const Constriction& c : curves)
    geodesic_check::expect_closed_geodesic(mesh, c, 1e-7);
  return curves;
}

std::size_t count_near(const std::vector<Constriction>& curves, double length, double tolerance)
{
  return static_cast<std::size_t>(std::count_if(
      curves.begin(), curves.end(), [=](const Constriction& c) { return std::abs(c.length() - length) <= tolerance; }));
}

// The paper's own program missed the trunk.
TEST(Real_meshes, CactusHasConstrictionsAroundItsArmsAndItsTrunk)
{
  const std::vector<Constriction> curves = detect("cactus.off");
  EXPECT_GE(count_near(curves, 0.293, 0.010), 2u);
  EXPECT_GE(count_near(curves, 0.597, 0.003), 1u);
  for(const Constriction& c : curves)
    EXPECT_TRUE(c.is_separating());
}

TEST(Real_meshes, TheHandHasItsThumb) { EXPECT_GE(detect("hand.off").size(), 1u); }

TEST(Real_meshes, OnGenusTwoSomeCurvesDoNotSeparate)
{
  const std::vector<Constriction> curves = detect("eight.off");
  EXPECT_GE(std::count_if(curves.begin(), curves.end(), [](const Constriction& c) { return !c.is_separating(); }), 4);
}

TEST(Real_meshes, AllCurvesOfLargerMeshesAreClosedGeodesics)
{
  EXPECT_GE(detect("elephant.off").size(), 20u);
  EXPECT_GE(detect("camel.off").size(), 10u);
  EXPECT_GE(detect("armadillo.off").size(), 10u);
}

TEST(Real_meshes, ConvexOnesHaveNone)
{
  for(const char* name : {"cube.off", "cube-meshed.off", "icosahedron.off", "octahedron.off", "tetrahedron.off",
                          "sphere.off", "ellipsoid.off"})
    EXPECT_TRUE(detect(name).empty()) << name;
}

} // namespace test_real_meshes
