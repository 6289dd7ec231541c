// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace test_boundary_parts {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using test_meshes::Mesh;
using test_meshes::Soup;

typedef SMC::Constriction<Mesh> Constriction;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Marks;

const int around = 12;

Soup waisted_tube()
{
  return open_meshes::open_tube(around, {{{2, -1}}, {{1.5, -0.5}}, {{1, 0}}, {{1.5, 0.5}}, {{2, 1}}});
}

// What a loop along the vertices of a height is tightened to.
Constriction tightened_ring(const Mesh& mesh, double height)
{
  std::vector<Mesh::Vertex_index> ring;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(mesh.point(v).z() == height && !mesh.is_isolated(v))
      ring.push_back(v);
  std::sort(ring.begin(), ring.end(), [&mesh](Mesh::Vertex_index u, Mesh::Vertex_index v) {
    return std::atan2(mesh.point(u).y(), mesh.point(u).x()) < std::atan2(mesh.point(v).y(), mesh.point(v).x());
  });
  const auto result = SMC::tighten_closed_curve(mesh, ring);
  EXPECT_EQ(result.verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
  return result.curve;
}

std::size_t number_of_holes(const Mesh& mesh)
{
  std::size_t holes = 0;
  std::vector<bool> is_seen(mesh.num_halfedges(), false);
  for(Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) && !is_seen[h])
    {
      ++holes;
      for(Mesh::Halfedge_index b : mesh.halfedges_around_face(h))
        is_seen[b] = true;
    }
  return holes;
}

// The segmentation, and the split mesh, whose parts are the same.
struct Cut
{
  SMC::Surface_parts parts;
  Mesh split;
  Marks marks;

  Cut(const Mesh& mesh, const std::vector<Constriction>& curves) : split(mesh)
  {
    Mesh copy = mesh;
    const auto patch = copy.add_property_map<Mesh::Face_index, std::size_t>("f:patch", 0).first;
    parts = SMC::segment_by_constrictions(mesh, curves, patch);
    marks = split.add_property_map<Mesh::Edge_index, bool>("e:mark", false).first;
    SMC::split_along_constrictions(split, curves, CGAL::parameters::edge_is_constrained_map(marks));
    std::vector<std::size_t> component(split.num_faces());
    const std::size_t n = PMP::connected_components(split, CGAL::make_property_map(component),
                                                    CGAL::parameters::edge_is_constrained_map(marks));
    EXPECT_EQ(n, parts.parts.size());
    std::vector<double> areas(n, 0), expected;
    for(Mesh::Face_index f : split.faces())
      areas[component[f]] += PMP::face_area(f, split);
    for(const SMC::Surface_part& p : parts.parts)
      expected.push_back(p.area);
    std::sort(areas.begin(), areas.end());
    std::sort(expected.begin(), expected.end());
    for(std::size_t i = 0; i < std::min(areas.size(), expected.size()); ++i)
      EXPECT_NEAR(areas[i], expected[i], 1e-9);
  }

  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<Mesh> extract(const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    std::vector<Mesh> result;
    SMC::extract_parts(split, marks, std::back_inserter(result), np);
    return result;
  }
};

TEST(Boundary_parts, TheEndsOfATubeStayOpen)
{
  const Mesh mesh = test_meshes::make_mesh(waisted_tube());
  const Cut cut(mesh, {tightened_ring(mesh, 0)});
  ASSERT_EQ(cut.parts.parts.size(), 2u);
  for(const SMC::Surface_part& p : cut.parts.parts)
  {
    EXPECT_EQ(p.number_of_boundaries, 2u); // the cut and the end
    EXPECT_EQ(p.genus, 0u);
    EXPECT_NEAR(p.area, PMP::area(mesh) / 2, 1e-9);
  }
  ASSERT_EQ(cut.parts.adjacencies.size(), 1u);
  EXPECT_NEAR(cut.parts.adjacencies[0].length, 2 * around * std::sin(CGAL_PI / around), 1e-9);

  for(const Mesh& part : cut.extract())
    EXPECT_EQ(number_of_holes(part), 1u);
  for(const Mesh& part : cut.extract(SMC::parameters::with_caps(false)))
    EXPECT_EQ(number_of_holes(part), 2u);
  // the volumes with the holes closed by cones, as the faces are oriented
  EXPECT_NEAR(cut.parts.parts[0].volume, cut.parts.parts[1].volume, 1e-9);
}

// A rim cuts nothing off: the surface is one part, with the boundaries that it had.
TEST(Boundary_parts, ARimCutsNothingOff)
{
  const Mesh mesh = test_meshes::make_mesh(open_meshes::open_tube(8, {{{1, 0}}, {{1.5, 1}}, {{2, 2}}}));
  const Constriction rim = tightened_ring(mesh, 2);
  ASSERT_TRUE(rim.is_rim());
  const Cut cut(mesh, {rim});
  ASSERT_EQ(cut.parts.parts.size(), 1u);
  EXPECT_EQ(cut.parts.parts[0].number_of_boundaries, 2u);
  EXPECT_TRUE(cut.parts.adjacencies.empty());
}

// The neck goes around the hole: the hole belongs to one part, and the parts meet where the neck does not run along it.
TEST(Boundary_parts, ANeckAroundAHole)
{
  const Soup tube = waisted_tube();
  std::size_t on_ring = 0;
  while(tube.points[on_ring][2] != 0)
    ++on_ring;
  const Mesh mesh = test_meshes::make_mesh(open_meshes::without_star(tube, on_ring));
  const Constriction neck = tightened_ring(mesh, 0.5);
  ASSERT_GT(neck.boundary_share(), 0);
  ASSERT_FALSE(neck.is_rim());
  const Cut cut(mesh, {neck});
  ASSERT_EQ(cut.parts.parts.size(), 2u);
  EXPECT_NEAR(cut.parts.parts[0].area + cut.parts.parts[1].area, PMP::area(mesh), 1e-9);
  double meeting = 0;
  for(const auto& a : cut.parts.adjacencies)
    meeting += a.length;
  EXPECT_NEAR(meeting, neck.length() * (1 - neck.boundary_share()), 1e-9);
  // where the neck runs along the hole there is nothing to cap on the side of the hole
  std::size_t holes = 0;
  for(const Mesh& part : cut.extract())
    holes += number_of_holes(part);
  EXPECT_EQ(holes, 3u); // two ends, and that of the neck and the hole
}

} // namespace test_boundary_parts
