// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/open_meshes.h"
#include "include/random_loops.h"
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>

#include <CGAL/Polygon_mesh_processing/repair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace test_measuring_levels {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Progressive_mesh;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;

// A mesh and the collapses of its shortest edges.
Progressive_mesh simplified(const Mesh& mesh)
{
  Mesh copy = mesh;
  Progressive_mesh pm = SMC::make_progressive_mesh(mesh, {});
  for(const SMC::Edge_collapse& c : record_collapses::record_collapses(copy).collapses)
    pm.append_collapse(c);
  return pm;
}

TEST(PathsToInput, KeepTheirHomologyClassAndAreJoinedByEdges)
{
  std::mt19937 random(1);
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const test_meshes::Soup torus = test_meshes::torus(0.1, seed);
    Mesh mesh = test_meshes::make_mesh(seed % 2 == 0 ? torus : open_meshes::with_random_holes(torus, 6, seed));
    CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
    mesh.collect_garbage();
    Progressive_mesh pm = simplified(mesh);
    pm.go_to_level(pm.number_of_collapses() / 2);
    const SMC::internal::Level_copy level(pm);
    pm.go_to_level(0);
    const SMC::internal::Surface_cycles cycles(pm);
    SMC::internal::Paths_to_finer_level to_input(pm);
    std::size_t essential = 0;
    for(int i = 0; i < 50; ++i)
    {
      std::vector<Index> loop;
      for(Mesh::Vertex_index v : random_loops::random_loop(mesh, random))
        loop.push_back(static_cast<Index>(v));
      const std::vector<Index> there = level.path(loop), back = to_input(level, there);
      EXPECT_EQ(cycles.homology_class(back), cycles.homology_class(loop));
      essential += !cycles.homology_class(loop).empty();
      for(std::size_t j = 0; j < back.size() && back.size() > 2; ++j)
      {
        EXPECT_FALSE(pm.is_ghost_vertex(back[j]));
        EXPECT_NE(pm.halfedge(back[j], back[(j + 1) % back.size()]), SMC::null_index);
      }
      // there again, it is the path that it comes from
      std::vector<Index> again = level.path(back), expected = there;
      ASSERT_EQ(again.size(), expected.size());
      std::sort(again.begin(), again.end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(again, expected);
    }
    EXPECT_GT(essential, 5u);
  }
}

TEST(PathsBetweenLevels, KeepTheirHomologyClassAndAreTheSameTheSecondTime)
{
  std::mt19937 random(2);
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, seed));
    Progressive_mesh pm = simplified(mesh);
    pm.go_to_level(2 * pm.number_of_collapses() / 3);
    const SMC::internal::Level_copy coarse(pm);
    pm.go_to_level(pm.number_of_collapses() / 3);
    const SMC::internal::Level_copy fine(pm);
    pm.go_to_level(0);
    const SMC::internal::Surface_cycles cycles(pm);
    SMC::internal::Paths_to_finer_level to_fine(fine.surface()), to_input(pm);
    SMC::internal::Paths_from_level from_coarse(to_fine, coarse, &fine), from_fine(to_input, fine);
    for(int i = 0; i < 50; ++i)
    {
      std::vector<Index> loop;
      for(Mesh::Vertex_index v : random_loops::random_loop(mesh, random))
        loop.push_back(static_cast<Index>(v));
      const std::vector<Index> there = coarse.path(loop), between = from_coarse(there);
      EXPECT_EQ(between, to_fine(coarse, fine, there));
      EXPECT_EQ(between, from_coarse(there));
      for(std::size_t j = 0; j < between.size() && between.size() > 2; ++j)
        EXPECT_NE(fine.surface().halfedge(between[j], between[(j + 1) % between.size()]), SMC::null_index);
      EXPECT_EQ(cycles.homology_class(from_fine(between)), cycles.homology_class(loop));
    }
  }
}

TEST(MeasuringLevels, OnlyALargeSurfaceHasThem)
{
  for(int around : {60, 180})
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0, 1, 160, around));
    Progressive_mesh pm = simplified(mesh);
    pm.go_to_level(0);
    const std::deque<SMC::internal::Measuring_level> levels = SMC::internal::measuring_levels(pm);
    EXPECT_EQ(pm.level(), 0u);
    ASSERT_EQ(levels.size(), around == 60 ? 0u : 1u);
    for(const SMC::internal::Measuring_level& level : levels)
    {
      EXPECT_EQ(level.copy.surface().number_of_vertices(), SMC::internal::least_measuring_vertices);
    }
  }
}

// The pleats of a surface vanish from a coarser level, as the steps of voxels do, and with them part of the area.
TEST(MeasuringLevels, APleatedSurfaceHasNone)
{
  const int along = 180;
  for(double depth : {0., 0.03})
  {
    const auto radius = [&](double s) { return std::lround(s * along) % 2 == 0 ? 1 - depth : 1 + depth; };
    Progressive_mesh pm = simplified(test_meshes::make_mesh(test_meshes::revolution(radius, 10, along, 160, 0, 0)));
    pm.go_to_level(0);
    EXPECT_EQ(SMC::internal::measuring_levels(pm).size(), depth == 0 ? 1u : 0u);
  }
}

// Each neck once, whatever the noise, as prominent as on the input: the bulge beside it is the barrier.
TEST(MeasuringLevels, TheNecksOfALargeSurfaceAreAsProminentAsMeasuredOnTheInput)
{
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(seed == 0 ? 0. : 0.004, seed, 180, 160));
    ASSERT_GT(mesh.number_of_vertices(), 3 * SMC::internal::least_measuring_vertices);
    const std::vector<Constriction> curves = detection::detect(mesh);
    ASSERT_EQ(curves.size(), 4u);
    std::vector<Constriction> measured;
    SMC::compute_prominences(mesh, curves, std::back_inserter(measured));
    ASSERT_EQ(measured.size(), curves.size());
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      EXPECT_NEAR(curves[i].prominence() / measured[i].prominence(), 1, 0.03) << i;
      EXPECT_EQ(curves[i].dominated_by().has_value(), measured[i].dominated_by().has_value()) << i;
    }
    for(double radius : {0.3, 0.4, 0.5, 0.6})
      EXPECT_EQ(std::count_if(
                    curves.begin(), curves.end(),
                    [&](const Constriction& c) { return std::abs(c.length() / (2 * CGAL_PI * radius) - 1) < 0.02; }),
                1)
          << radius;
  }
}

} // namespace test_measuring_levels
