// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_progressive_mesh {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Progressive_mesh;

// Connectivity and positions of the current surface, bit for bit (FNV-1a).
std::uint64_t hash(const Progressive_mesh& pm)
{
  std::uint64_t h = 14695981039346656037u;
  const auto add = [&h](const void* data, std::size_t size) {
    const unsigned char* const bytes = static_cast<const unsigned char*>(data);
    for(std::size_t i = 0; i < size; ++i)
      h = (h ^ bytes[i]) * 1099511628211u;
  };
  const auto add_index = [&](Index i) { add(&i, sizeof(i)); };
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
    if(pm.is_face(f))
      for(Index k = 3 * f; k < 3 * f + 3; ++k)
      {
        add_index(k);
        add_index(pm.source(k));
        add_index(pm.opposite(k));
      }
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    if(pm.is_vertex(v))
    {
      add_index(v);
      add_index(pm.outgoing(v));
      for(int i = 0; i < 3; ++i)
      {
        const double x = pm.point(v)[i];
        add(&x, sizeof(x));
      }
    }
  return h;
}

void expect_valid(const Progressive_mesh& pm)
{
  std::size_t vertices = 0, faces = 0;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
  {
    if(!pm.is_face(f))
      continue;
    ++faces;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      ASSERT_EQ(pm.opposite(pm.opposite(h)), h);
      ASSERT_EQ(pm.source(pm.opposite(h)), pm.target(h));
      ASSERT_TRUE(pm.is_face(pm.face(pm.opposite(h))));
      ASSERT_TRUE(pm.is_vertex(pm.source(h)));
    }
  }
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    if(pm.is_vertex(v))
    {
      ++vertices;
      ASSERT_EQ(pm.source(pm.outgoing(v)), v);
      ASSERT_TRUE(pm.is_face(pm.face(pm.outgoing(v))));
    }
  EXPECT_EQ(vertices, pm.number_of_vertex_ids() - pm.level());
  EXPECT_EQ(faces, pm.number_of_face_ids() - 2 * pm.level());
}

TEST(Progressive_mesh, RewindingRestoresEveryLevelBitForBit)
{
  for(unsigned seed = 0; seed < 6; ++seed)
  {
    const test_meshes::Soup soup = seed % 2 == 0 ? test_meshes::dumbbell(0.05, seed) : test_meshes::torus(0.1, seed);
    const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::relabelled(soup, seed));
    test_meshes::Mesh simplified = mesh;
    const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
    ASSERT_GT(record.collapses.size(), 200u);

    Progressive_mesh pm = SMC::make_progressive_mesh(mesh, std::vector<SMC::Edge_collapse>());
    std::vector<std::uint64_t> hashes = {hash(pm)};
    for(const SMC::Edge_collapse& c : record.collapses)
    {
      pm.append_collapse(c);
      hashes.push_back(hash(pm));
    }
    ASSERT_EQ(pm.level(), record.collapses.size());
    expect_valid(pm);
    while(pm.level() > 0)
    {
      const Progressive_mesh::Split next = pm.next_split(), done = pm.split();
      ASSERT_EQ(next.left, done.left);
      ASSERT_EQ(pm.source(done.left), done.removed);
      ASSERT_EQ(pm.target(done.left), done.kept);
      ASSERT_EQ(hash(pm), hashes[pm.level()]) << "down to level " << pm.level();
    }
    expect_valid(pm);
    while(pm.level() < pm.number_of_collapses())
    {
      pm.collapse();
      ASSERT_EQ(hash(pm), hashes[pm.level()]) << "up to level " << pm.level();
    }
    for(std::size_t level : {hashes.size() / 2, hashes.size() / 3, hashes.size() - 1, std::size_t(0)})
    {
      pm.go_to_level(level);
      ASSERT_EQ(hash(pm), hashes[level]);
    }
  }
}

TEST(Progressive_mesh, ReplayGivesTheMeshThatEdgeCollapseLeft)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 7));
  test_meshes::Mesh simplified = mesh;
  const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
  const Progressive_mesh pm = SMC::make_progressive_mesh(mesh, record.collapses);
  for(auto v : simplified.vertices())
  {
    ASSERT_TRUE(pm.is_vertex(v));
    EXPECT_EQ(pm.point(v), simplified.point(v));
  }
  std::size_t faces = 0;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
    faces += pm.is_face(f);
  EXPECT_EQ(faces, simplified.number_of_faces());
  for(auto h : simplified.halfedges())
  {
    const Index g = pm.halfedge(simplified.source(h), simplified.target(h));
    ASSERT_NE(g, SMC::null_index);
    EXPECT_EQ(pm.target(pm.next(g)), simplified.target(simplified.next(h)));
  }
}

TEST(Progressive_mesh, AppendingCollapsesEndsWhenTheFunctionSaysSo)
{
  test_meshes::Mesh simplified = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 7));
  Progressive_mesh one_by_one = test_meshes::make_progressive(test_meshes::dumbbell(0.05, 7)), appended = one_by_one;
  const SMC::Collapse_record record = record_collapses::record_collapses(simplified);
  const std::size_t half = record.collapses.size() / 2;
  for(std::size_t i = 0; i < half; ++i)
    one_by_one.append_collapse(record.collapses[i]);
  std::vector<Index> removed;
  appended.append_collapses(record.collapses, [&](const SMC::Edge_collapse& c) {
    removed.push_back(c.removed);
    return removed.size() < half;
  });
  EXPECT_EQ(hash(appended), hash(one_by_one));
  EXPECT_EQ(appended.number_of_collapses(), half);
  ASSERT_EQ(removed.size(), half);
  for(std::size_t i = 0; i < half; ++i)
    EXPECT_EQ(removed[i], record.collapses[i].removed);
}

TEST(Progressive_mesh, ACollapseTakes44Bytes) { EXPECT_EQ(Progressive_mesh::bytes_per_collapse(), 44u); }

} // namespace test_progressive_mesh
