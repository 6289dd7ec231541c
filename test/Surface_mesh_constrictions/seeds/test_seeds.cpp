// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <vector>

namespace test_seeds {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
typedef std::set<std::array<Index, 3>> Triangles;

std::array<Index, 3> sorted(const std::vector<Index>& v)
{
  std::array<Index, 3> t = {{v[0], v[1], v[2]}};
  std::sort(t.begin(), t.end());
  return t;
}

// Over all triples of vertices.
Triangles brute_force(const SMC::Progressive_mesh& pm)
{
  std::vector<Index> vertices;
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    if(pm.is_vertex(v))
      vertices.push_back(v);
  Triangles faces, result;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
    if(pm.is_face(f))
      faces.insert(sorted({pm.source(3 * f), pm.source(3 * f + 1), pm.source(3 * f + 2)}));
  for(std::size_t i = 0; i < vertices.size(); ++i)
    for(std::size_t j = i + 1; j < vertices.size(); ++j)
      if(pm.halfedge(vertices[i], vertices[j]) != SMC::null_index)
        for(std::size_t k = j + 1; k < vertices.size(); ++k)
          if(pm.halfedge(vertices[i], vertices[k]) != SMC::null_index &&
             pm.halfedge(vertices[j], vertices[k]) != SMC::null_index)
          {
            const std::array<Index, 3> t = {{vertices[i], vertices[j], vertices[k]}};
            if(faces.count(t) == 0)
              result.insert(t);
          }
  return result;
}

// Adds the seeds and expects that each is new.
void add(const std::vector<SMC::Seed_curve>& seeds, std::size_t level, Triangles& triangles)
{
  for(const SMC::Seed_curve& s : seeds)
  {
    EXPECT_EQ(s.level, level);
    EXPECT_EQ(s.origin, SMC::Seed_origin::NON_FACE_TRIANGLE);
    EXPECT_TRUE(triangles.insert(sorted(s.vertices)).second);
  }
}

TEST(Seeds, AllTrianglesThatAppearAreFoundAtTheMergedVertex)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(seed % 2 == 0 ? test_meshes::dumbbell(0.1, seed, 10, 6)
                                                                        : test_meshes::torus(0.2, seed, 9, 5));
    test_meshes::Mesh simplified = mesh;
    const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
    SMC::Progressive_mesh pm = SMC::make_progressive_mesh(mesh, std::vector<SMC::Edge_collapse>());
    std::vector<SMC::Seed_curve> seeds;
    SMC::non_face_triangles(pm, std::back_inserter(seeds));
    Triangles before;
    add(seeds, 0, before);
    EXPECT_EQ(before, brute_force(pm));
    std::size_t appeared = 0;
    for(const SMC::Edge_collapse& c : record.collapses)
    {
      pm.append_collapse(c);
      seeds.clear();
      SMC::non_face_triangles_at_vertex(pm, c.kept, std::back_inserter(seeds));
      Triangles found;
      add(seeds, pm.level(), found);
      const Triangles now = brute_force(pm);
      for(const std::array<Index, 3>& t : now)
      {
        const bool at_merged_vertex = std::count(t.begin(), t.end(), c.kept) == 1;
        ASSERT_EQ(found.count(t) == 1, at_merged_vertex) << "level " << pm.level();
        ASSERT_TRUE(at_merged_vertex || before.count(t) == 1) << "level " << pm.level();
        appeared += before.count(t) == 0;
      }
      before = now;
    }
    EXPECT_GT(appeared, 0u);
  }
}

TEST(Seeds, ARefusedCollapseGivesNonFaceTrianglesOfItsLevelEachOnce)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.2, 1, 12, 6));
  test_meshes::Mesh simplified = mesh;
  const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
  ASSERT_FALSE(record.refused_seeds.empty());
  SMC::Progressive_mesh pm = SMC::make_progressive_mesh(mesh, record.collapses);
  Triangles seen;
  for(const SMC::Seed_curve& s : record.refused_seeds)
  {
    pm.go_to_level(s.level);
    EXPECT_EQ(brute_force(pm).count(sorted(s.vertices)), 1u);
    EXPECT_TRUE(seen.insert(sorted(s.vertices)).second);
  }
}

} // namespace test_seeds
