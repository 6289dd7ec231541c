// SPDX-License-Identifier: GPL-3.0-or-later
// The caps that close parts: the same on both sides of a cut, and whether they cut their part.
#include "include/grid_torus.h"
#include "include/random_loops.h"
#include "include/real_meshes.h"
#include "include/sanitizers.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_caps {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using test_meshes::Mesh;

typedef SMC::Constriction<Mesh> Curve;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Marks;

Marks marks_of(Mesh& mesh) { return mesh.add_property_map<Mesh::Edge_index, bool>("e:mark", false).first; }

// The closed parts of a mesh, with their caps.
struct Parts
{
  std::vector<Mesh> meshes;
  std::vector<SMC::Part_cap<Mesh>> caps;

  Parts(const Mesh& mesh, Marks marks)
  {
    SMC::extract_parts(mesh, marks, std::back_inserter(meshes),
                       SMC::parameters::cap_output_iterator(std::back_inserter(caps)));
    for(const Mesh& m : meshes)
    {
      EXPECT_TRUE(CGAL::is_closed(m));
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(m));
    }
  }

  double volume() const
  {
    double sum = 0;
    for(const Mesh& m : meshes)
      sum += PMP::volume(m);
    return sum;
  }

  std::size_t number_of_intersecting_caps() const
  {
    return static_cast<std::size_t>(
        std::count_if(caps.begin(), caps.end(), [](const auto& c) { return c.intersects_part; }));
  }
};

// Cuts along all curves that can cut, and returns how far the volumes of the parts, as told and as extracted, are from
// adding up, relative to that of the mesh.
double relative_error_of_volumes(Mesh mesh, const std::vector<Curve>& curves)
{
  const double volume = PMP::volume(mesh);
  std::map<Mesh::Face_index, std::size_t> patch;
  double told = 0;
  for(const auto& p : SMC::segment_by_constrictions(mesh, curves, boost::make_assoc_property_map(patch)).parts)
    told += p.volume;
  const Marks marks = marks_of(mesh);
  SMC::split_along_constrictions(mesh, curves, CGAL::parameters::edge_is_constrained_map(marks));
  const double extracted = Parts(mesh, marks).volume();
  return (std::max)(std::abs(told - volume), std::abs(extracted - volume)) / std::abs(volume);
}

TEST(Caps, VolumesOfPartsAddUpOnRealMeshes)
{
  for(const char* name : {"armadillo.off", "elephant.off", "man.off", "cactus.off", "eight.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = real_meshes::read(name);
    std::vector<Curve> selected, all;
    SMC::detect_constrictions(mesh, std::back_inserter(selected), SMC::parameters::certify(false));
    EXPECT_FALSE(selected.empty());
    EXPECT_LT(relative_error_of_volumes(mesh, selected), 1e-9);
    if(mesh.number_of_faces() > (sanitizers::are_on ? 3000u : 20000u))
      continue;
    SMC::detect_constrictions(mesh, std::back_inserter(all),
                              SMC::parameters::certify(false, SMC::parameters::crossing_constrictions(
                                                                  true, SMC::parameters::minimum_prominence(0.01))));
    EXPECT_LT(relative_error_of_volumes(mesh, all), 1e-9); // with many that touch each other or share edges
  }
}

TEST(Caps, VolumesOfPartsAddUpOnSeededBodies)
{
  for(unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = test_meshes::make_mesh(seed % 3 == 0   ? test_meshes::chain_of_necks(0.2, seed, 30, 9)
                                             : seed % 3 == 1 ? test_meshes::torus(0.3, seed, 9, 6)
                                                             : test_meshes::dumbbell(0.3, seed, 10, 6));
    std::mt19937 random(seed);
    std::vector<random_loops::Loop<Mesh>> loops;
    for(int i = 0; i < 12; ++i)
      loops.push_back(random_loops::random_loop(mesh, random));
    std::vector<SMC::Tightened_curve<Mesh>> tightened;
    SMC::tighten_closed_curves(mesh, loops, std::back_inserter(tightened), SMC::parameters::certify(false));
    std::vector<Curve> curves;
    for(const auto& t : tightened)
      if(t.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC)
        curves.push_back(t.curve);
    EXPECT_LT(relative_error_of_volumes(mesh, curves), 1e-9);
  }
}

// Paths that touch a meridian at a vertex, at two, share an edge with it, or two stretches.
TEST(Caps, VolumesOfPartsAddUpWhereCurvesTouchAndShareEdges)
{
  typedef std::vector<std::array<int, 2>> Path;
  for(const Path& path :
      {Path{{{1, 0}}, {{2, 1}}, {{3, 2}}, {{3, 3}}, {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}},
       Path{{{1, 0}}, {{2, 1}}, {{2, 2}}, {{1, 2}}, {{2, 3}}, {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}},
       Path{{{1, 0}}, {{1, 1}}, {{1, 2}}, {{2, 3}}, {{3, 4}}, {{3, 5}}, {{2, 5}}, {{2, 6}}},
       Path{{{1, 0}}, {{1, 1}}, {{2, 2}}, {{2, 3}}, {{1, 3}}, {{1, 4}}, {{2, 5}}, {{2, 6}}}})
  {
    grid_torus::Grid_torus<Mesh> torus(6, 6);
    const std::vector<Curve> curves = {torus.meridian(1), torus.path(path)};
    EXPECT_LT(relative_error_of_volumes(torus.mesh, curves), 1e-13);
  }
}

// The triangles at a cut are in one part and, turned over, in the other.
TEST(Caps, ThoseOfOneCutAreTheSameSurface)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 3));
  std::vector<Curve> curves;
  SMC::detect_constrictions(mesh, std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 1u);
  const Marks marks = marks_of(mesh);
  const auto split = SMC::split_along_constrictions(mesh, curves, CGAL::parameters::edge_is_constrained_map(marks));
  const std::size_t n = split.halfedges[0].size();
  const Parts parts(mesh, marks);
  ASSERT_EQ(parts.meshes.size(), 2u);
  ASSERT_EQ(parts.caps.size(), 2u);
  for(const auto& c : parts.caps)
  {
    EXPECT_EQ(c.border.size(), n);
    EXPECT_FALSE(c.intersects_part);
  }
  typedef std::array<Mesh::Point, 3> Triangle;
  const auto triangles = [](const Mesh& m, bool turned) {
    std::set<Triangle> result;
    for(auto f : m.faces())
    {
      Triangle t;
      std::size_t i = 0;
      for(auto v : m.vertices_around_face(m.halfedge(f)))
        t[i++] = m.point(v);
      if(turned)
        std::swap(t[1], t[2]);
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.insert(t);
    }
    return result;
  };
  const std::set<Triangle> first = triangles(parts.meshes[0], false), second = triangles(parts.meshes[1], true);
  std::vector<Triangle> common;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(common));
  EXPECT_EQ(common.size(), n - 2);
  EXPECT_EQ(mesh.number_of_faces() + 2 * (n - 2),
            parts.meshes[0].number_of_faces() + parts.meshes[1].number_of_faces());
}

// A cup of radius 3 and height 3 with a column in it, cut along the inner edge of its rim.
struct Cup
{
  Mesh mesh;
  Marks marks;

  explicit Cup(double height_of_column)
    : mesh(test_meshes::make_mesh(test_meshes::revolution_of_profile(
          {{{3, 0}}, {{3, 3}}, {{2, 3}}, {{2, 1}}, {{1, 1}}, {{1, height_of_column}}}, 0, height_of_column, 12, 0, 1))),
      marks(marks_of(mesh))
  {
    for(Mesh::Edge_index e : mesh.edges())
    {
      const auto is_on_ring = [](Mesh::Vertex_index v) { return v.idx() >= 24 && v.idx() < 36; };
      marks[e] = is_on_ring(mesh.vertex(e, 0)) && is_on_ring(mesh.vertex(e, 1));
    }
  }
};

TEST(Caps, OneThatCutsItsPartIsFlagged)
{
  for(double height : {2., 4.})
  {
    const Cup cup(height);
    const Parts parts(cup.mesh, cup.marks);
    ASSERT_EQ(parts.meshes.size(), 2u);
    ASSERT_EQ(parts.caps.size(), 2u);
    for(const auto& c : parts.caps)
    {
      const bool is_inside = PMP::volume(parts.meshes[c.part]) < PMP::volume(parts.meshes[1 - c.part]);
      EXPECT_EQ(c.intersects_part, is_inside && height > 3);
    }
    EXPECT_NEAR(parts.volume(), PMP::volume(cup.mesh), 1e-12 * parts.volume());
  }
}

// What the cap over the opening encloses is outside of the cup.
TEST(Caps, TheVolumeOfACavityIsNegative)
{
  const Cup cup(1.5);
  const Parts parts(cup.mesh, cup.marks);
  ASSERT_EQ(parts.meshes.size(), 2u);
  const double a = PMP::volume(parts.meshes[0]), b = PMP::volume(parts.meshes[1]);
  const double circle = 12 * std::sin(CGAL_PI / 12) * std::cos(CGAL_PI / 12); // of a regular polygon of radius 1
  EXPECT_LT((std::min)(a, b), -circle * 4);
  EXPECT_GT((std::min)(a, b), -circle * 8);
  EXPECT_GT((std::max)(a, b), circle * 24);
  EXPECT_EQ(parts.number_of_intersecting_caps(), 0u);
}

// On the torus of seven vertices all pairs of them are joined by an edge, so that no triangulation without new vertices
// fits into the hole that the star of one of them leaves.
TEST(Caps, WhereNoTriangleFitsACone)
{
  test_meshes::Soup soup = {
      {{{3, -3, 0}}, {{3, 3, 0}}, {{1, 2, 3}}, {{-1, -2, 3}}, {{-3, -3, 1}}, {{-3, 3, 1}}, {{0, 0, 15}}}, {}};
  for(std::size_t i = 0; i < 7; ++i)
  {
    soup.faces.push_back({{i, (i + 1) % 7, (i + 3) % 7}});
    soup.faces.push_back({{i, (i + 3) % 7, (i + 2) % 7}});
  }
  Mesh mesh = test_meshes::make_mesh(soup);
  const Marks marks = marks_of(mesh);
  for(Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(Mesh::Vertex_index(6))))
    marks[mesh.edge(mesh.prev(h))] = true;
  const Parts parts(mesh, marks);
  ASSERT_EQ(parts.meshes.size(), 2u);
  for(const Mesh& m : parts.meshes)
    EXPECT_EQ(m.number_of_faces(), m.number_of_vertices() == 8 ? 12u : 14u);
  EXPECT_NEAR(parts.volume(), PMP::volume(mesh), 1e-12 * std::pow(PMP::area(mesh), 1.5));
}

// Each face a part.
TEST(Caps, PartsOfOneFace)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::tetrahedron());
  const Marks marks = marks_of(mesh);
  for(Mesh::Edge_index e : mesh.edges())
    marks[e] = true;
  const Parts parts(mesh, marks);
  EXPECT_EQ(parts.meshes.size(), 4u);
  EXPECT_NEAR(parts.volume(), PMP::volume(mesh), 1e-15);
}

} // namespace test_caps
