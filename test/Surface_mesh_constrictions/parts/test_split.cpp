// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/grid_torus.h"
#include "include/random_geodesics.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace test_split {

namespace SMC = CGAL::Surface_mesh_constrictions;
using random_geodesics::random_geodesics;
using test_meshes::Mesh;

// A curve that crosses another is refused whichever of them comes first.
TEST(Split_order, CrossingDoesNotDependOnTheOrder)
{
  for(unsigned seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh =
        test_meshes::make_mesh(seed % 2 == 0 ? test_meshes::square_ring() : test_meshes::torus(0.3, seed, 9, 6));
    const auto curves = random_geodesics(mesh, seed);
    for(std::size_t i = 0; i < curves.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
      {
        SMC::internal::Curve_arrangement<Mesh> forward(mesh), backward(mesh);
        EXPECT_FALSE(forward.insert(curves[i], i));
        EXPECT_FALSE(backward.insert(curves[j], j));
        EXPECT_EQ(forward.insert(curves[j], j).has_value(), backward.insert(curves[i], i).has_value());
      }
  }
}

TEST(Extract_parts, WithoutCapsHaveBorders)
{
  grid_torus::Grid_torus<Mesh> torus(6, 6);
  auto marks = torus.mesh.add_property_map<Mesh::Edge_index, bool>("e:mark", false).first;
  SMC::split_along_constrictions(torus.mesh, std::vector<SMC::Constriction<Mesh>>{torus.meridian(1)},
                                 CGAL::parameters::edge_is_constrained_map(marks));
  std::vector<Mesh> open, closed;
  SMC::extract_parts(torus.mesh, marks, std::back_inserter(open), SMC::parameters::with_caps(false));
  SMC::extract_parts(torus.mesh, marks, std::back_inserter(closed));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].number_of_vertices(), 42u);
  EXPECT_EQ(open[0].number_of_faces(), 72u);
  std::size_t border = 0;
  for(auto h : open[0].halfedges())
    border += open[0].is_border(h);
  EXPECT_EQ(border, 12u);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].number_of_faces(), 80u); // two hexagons
}

TEST(Split_parts, AreLimitedInNumber)
{
  for(std::size_t n = 1; n <= 4; ++n)
  {
    grid_torus::Grid_torus<Mesh> torus(8, 6);
    auto marks = torus.mesh.add_property_map<Mesh::Edge_index, bool>("e:mark", false).first;
    const auto curves = std::vector<SMC::Constriction<Mesh>>{torus.meridian(1), torus.meridian(3), torus.meridian(5)};
    SMC::split_along_constrictions(
        torus.mesh, curves,
        SMC::parameters::maximum_number_of_parts(n, CGAL::parameters::edge_is_constrained_map(marks)));
    std::vector<Mesh> parts;
    SMC::extract_parts(torus.mesh, marks, std::back_inserter(parts));
    EXPECT_EQ(parts.size(), (std::min)(n, std::size_t(3)));
  }
}

} // namespace test_split
