// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Level_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace test_ghosts {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Progressive_mesh;
using test_meshes::Mesh;

Mesh torus_with_holes(unsigned seed)
{
  return test_meshes::make_mesh(open_meshes::with_random_holes(test_meshes::torus(0.1, seed), 6, seed));
}

// Every face has three neighbours, each hole one ghost vertex; every ghost face has one, and one edge on the boundary.
void expect_filled(const Progressive_mesh& pm, std::size_t holes)
{
  EXPECT_EQ(pm.number_of_holes(), holes);
  std::set<Index> ghosts;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
  {
    if(!pm.is_face(f))
      continue;
    int ghost_corners = 0, boundary_edges = 0;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      ASSERT_EQ(pm.opposite(pm.opposite(h)), h);
      ASSERT_EQ(pm.source(pm.opposite(h)), pm.target(h));
      ASSERT_TRUE(pm.is_face(pm.face(pm.opposite(h))));
      if(pm.is_ghost_vertex(pm.source(h)))
      {
        ++ghost_corners;
        ghosts.insert(pm.source(h));
      }
      boundary_edges += pm.is_on_boundary(h);
      EXPECT_EQ(std::isinf(SMC::internal::corner_angle(pm, h)), pm.is_ghost_face(f));
    }
    EXPECT_EQ(ghost_corners, pm.is_ghost_face(f) ? 1 : 0);
    EXPECT_EQ(pm.is_ghost_face(f) ? boundary_edges : 1, 1);
  }
  EXPECT_EQ(ghosts.size(), holes);
}

TEST(Ghosts, EachHoleIsClosedByOneVertex)
{
  for(unsigned seed = 0; seed < 5; ++seed)
  {
    const Mesh mesh = torus_with_holes(seed);
    const Progressive_mesh pm = SMC::make_progressive_mesh(mesh, {});
    expect_filled(pm, 6);
    EXPECT_EQ(pm.number_of_vertex_ids(), mesh.number_of_vertices() + 6);
    EXPECT_GT(pm.number_of_face_ids(), mesh.number_of_faces());
  }
  const Progressive_mesh closed = test_meshes::make_progressive(test_meshes::tetrahedron());
  EXPECT_FALSE(closed.has_boundary());
  expect_filled(closed, 0);
}

// What edge_collapse() does to a surface with open holes are collapses of the surface with its holes filled.
TEST(Ghosts, CollapsesKeepTheHolesAndSplitsRestoreThem)
{
  for(unsigned seed = 0; seed < 5; ++seed)
  {
    const Mesh mesh = torus_with_holes(seed);
    Mesh simplified = mesh;
    const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
    ASSERT_GT(record.collapses.size(), 100u);
    Progressive_mesh pm = SMC::make_progressive_mesh(mesh, {});
    std::vector<Index> corners;
    for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
      corners.push_back(pm.source(h));
    for(const SMC::Edge_collapse& c : record.collapses)
    {
      pm.append_collapse(c);
      if(pm.level() % 16 == 0)
        expect_filled(pm, 6);
    }
    expect_filled(pm, 6);
    std::size_t faces = 0;
    for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      faces += pm.is_face(f) && !pm.is_ghost_face(f);
    simplified.collect_garbage();
    EXPECT_EQ(faces, simplified.number_of_faces());

    const SMC::internal::Level_copy copy(pm);
    expect_filled(copy.surface(), 6);
    std::size_t vertices = 0;
    for(Mesh::Vertex_index v : simplified.vertices())
      vertices += !simplified.is_isolated(v);
    EXPECT_EQ(copy.surface().number_of_vertices(), vertices);

    pm.go_to_level(0);
    for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
      ASSERT_EQ(pm.source(h), corners[h]);
    expect_filled(pm, 6);
  }
}

TEST(Ghosts, HaveNoAreaAndCountForNoGenus)
{
  const Mesh mesh = torus_with_holes(1);
  const Progressive_mesh pm = SMC::make_progressive_mesh(mesh, {});
  const SMC::internal::Surface_cycles cycles(pm);
  double area = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    area += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                         mesh.point(mesh.target(mesh.next(h)))));
  }
  EXPECT_NEAR(cycles.area_of_component(0), area, 1e-12 * area);
  EXPECT_EQ(cycles.genus_of_component(0), 1u);
}

TEST(Boundary_seeds, AreTheBoundariesOfTheHoles)
{
  const Mesh mesh = torus_with_holes(2);
  const Progressive_mesh pm = SMC::make_progressive_mesh(mesh, {});
  std::vector<SMC::Seed_curve> seeds;
  SMC::boundary_seeds(pm, std::back_inserter(seeds));
  ASSERT_EQ(seeds.size(), 6u);
  std::size_t edges = 0, border_edges = 0;
  for(const SMC::Seed_curve& s : seeds)
  {
    EXPECT_EQ(s.origin, SMC::Seed_origin::BOUNDARY);
    edges += s.vertices.size();
    for(std::size_t i = 0; i < s.vertices.size(); ++i)
      EXPECT_TRUE(pm.is_on_boundary(pm.halfedge(s.vertices[i], s.vertices[(i + 1) % s.vertices.size()])));
  }
  for(Mesh::Edge_index e : mesh.edges())
    border_edges += mesh.is_border(e);
  EXPECT_EQ(edges, border_edges);
}

TEST(Non_face_triangle_seeds, AHoleOfThreeEdgesIsOneAndAGhostIsInNone)
{
  const Progressive_mesh pm =
      SMC::make_progressive_mesh(test_meshes::make_mesh(open_meshes::without_face(test_meshes::sharp_cone(), 3)), {});
  std::vector<SMC::Seed_curve> seeds, at_vertices;
  SMC::non_face_triangles(pm, std::back_inserter(seeds));
  ASSERT_EQ(seeds.size(), 1u); // face 3 is 2 3 13
  EXPECT_EQ(seeds[0].vertices, (std::vector<Index>{2, 3, 13}));
  SMC::non_face_triangles_at_vertex(pm, 13, std::back_inserter(at_vertices));
  ASSERT_EQ(at_vertices.size(), 1u);
}

} // namespace test_ghosts
