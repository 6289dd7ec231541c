// SPDX-License-Identifier: GPL-3.0-or-later

// The edge profiles that the simplification is run with, against those of CGAL.

#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Lean_edge_profile.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace test_edge_profile {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef SMC::Simplification_mesh Mesh;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef SMS::Edge_profile<Mesh, SMC::internal::Lean_point_map, Kernel> Lean_profile;
typedef SMS::Edge_profile<Mesh, SMC::internal::Simplification_point_map, Kernel> Full_profile;

template <class Profile>
std::vector<std::array<Mesh::Vertex_index, 3>> triangles(const Profile& profile)
{
  std::vector<std::array<Mesh::Vertex_index, 3>> result;
  for(const auto& t : profile.triangles())
    result.push_back({{t.v0, t.v1, t.v2}});
  return result;
}

TEST(EdgeProfile, TheLeanOneAnswersLikeThatOfCGAL)
{
  Mesh mesh = test_meshes::torus_with_border<Mesh>();
  const SMC::internal::Simplification_point_map points = get(CGAL::vertex_point, mesh);
  const SMC::internal::Lean_point_map lean_points(points);
  const Kernel traits;
  std::size_t with_border = 0, along_border = 0;
  for(const Mesh::Halfedge_index h : mesh.halfedges())
  {
    const Lean_profile lean(h, mesh, traits, 0, lean_points, 0, true);
    const Full_profile full(h, mesh, traits, 0, points, 0, true);
    EXPECT_EQ(lean.v0_v1(), full.v0_v1());
    EXPECT_EQ(lean.v1_v0(), full.v1_v0());
    EXPECT_EQ(lean.v0(), full.v0());
    EXPECT_EQ(lean.v1(), full.v1());
    EXPECT_EQ(lean.p0(), full.p0());
    EXPECT_EQ(lean.p1(), full.p1());
    EXPECT_EQ(lean.vL(), full.vL());
    EXPECT_EQ(lean.v1_vL(), full.v1_vL());
    EXPECT_EQ(lean.vL_v0(), full.vL_v0());
    EXPECT_EQ(lean.vR(), full.vR());
    EXPECT_EQ(lean.v0_vR(), full.v0_vR());
    EXPECT_EQ(lean.vR_v1(), full.vR_v1());
    EXPECT_EQ(lean.is_v0_v1_a_border(), full.is_v0_v1_a_border());
    EXPECT_EQ(lean.is_v1_v0_a_border(), full.is_v1_v0_a_border());
    EXPECT_EQ(lean.left_face_exists(), full.left_face_exists());
    EXPECT_EQ(lean.right_face_exists(), full.right_face_exists());
    EXPECT_EQ(triangles(lean), triangles(full));
    EXPECT_EQ(lean.link(), full.link());
    EXPECT_EQ(lean.border_edges(), full.border_edges());
    EXPECT_EQ(&lean.surface_mesh(), &mesh);
    with_border += !full.border_edges().empty();
    along_border += full.is_v0_v1_a_border();
  }
  EXPECT_GT(along_border, 100u);
  EXPECT_GT(with_border, along_border);
}

template <class PointMap>
SMC::Collapse_record collapses(Mesh mesh)
{
  return record_collapses::record_collapses(mesh, SMS::LindstromTurk_cost<Mesh>(), SMS::LindstromTurk_placement<Mesh>(),
                                            PointMap(get(CGAL::vertex_point, mesh)));
}

// Lindstrom and Turk ask for triangles, link and borders.
TEST(EdgeProfile, TheLeanOneLeadsToTheSameCollapses)
{
  for(const Mesh& mesh :
      {test_meshes::make_graph<Mesh>(test_meshes::torus(0.1, 5)), test_meshes::torus_with_border<Mesh>()})
  {
    const SMC::Collapse_record lean = collapses<SMC::internal::Lean_point_map>(mesh);
    EXPECT_GT(lean.collapses.size(), 90u);
    record_collapses::expect_same(lean, collapses<SMC::internal::Simplification_point_map>(mesh));
  }
}

} // namespace test_edge_profile
