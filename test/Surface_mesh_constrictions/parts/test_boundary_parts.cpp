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
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_boundary_parts {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using test_meshes::Mesh;
using test_meshes::Soup;

typedef SMC::Constriction<Mesh> Constriction;
typedef Mesh::Point Point;
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
  const std::vector<Mesh> closed = cut.extract(SMC::parameters::with_filled_holes(true));
  ASSERT_EQ(closed.size(), 2u);
  for(const Mesh& part : closed)
  {
    EXPECT_TRUE(CGAL::is_closed(part));
    EXPECT_TRUE(part.is_valid(false));
    // a ring of the tube has as many corners as the cut, and a cap two triangles less
    EXPECT_EQ(part.number_of_faces(), cut.split.number_of_faces() / 2 + 2 * (around - 2));
  }
  // the ends are plane, so that what they are filled with does not matter
  EXPECT_NEAR(std::abs(cut.parts.parts[0].volume), std::abs(PMP::volume(closed[0])), 1e-9);
  EXPECT_NEAR(PMP::volume(closed[0]), PMP::volume(closed[1]), 1e-9);
  // the ends only
  for(const Mesh& part : cut.extract(SMC::parameters::with_filled_holes(true, SMC::parameters::with_caps(false))))
  {
    EXPECT_EQ(number_of_holes(part), 1u);
    for(Mesh::Vertex_index v : part.vertices())
      EXPECT_EQ(part.is_border(v), std::abs(part.point(v).z()) < 0.1);
  }
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
  // there is nothing to cap; filled are both ends, of which the curve runs along one
  for(const Mesh& part : cut.extract())
    EXPECT_EQ(number_of_holes(part), 2u);
  for(const Mesh& part : cut.extract(SMC::parameters::with_filled_holes(true)))
    EXPECT_TRUE(CGAL::is_closed(part));
}

// The volume of the cones from a point over the faces of a mesh, with sign.
double volume_with_cone(const Mesh& mesh, const Point& apex)
{
  double result = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result += CGAL::volume(apex, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                           mesh.point(mesh.target(mesh.next(h))));
  }
  return result;
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

  // One part has the neck, the other what is left of the neck and of the hole: both are closed by cones to one point.
  double volume = 0;
  std::set<Point> added;
  for(const Mesh& part : cut.extract(SMC::parameters::with_filled_holes(true)))
  {
    EXPECT_TRUE(CGAL::is_closed(part));
    EXPECT_TRUE(part.is_valid(false));
    volume += PMP::volume(part);
    for(Mesh::Vertex_index v : part.vertices())
      added.insert(part.point(v));
  }
  for(Mesh::Vertex_index v : cut.split.vertices())
    added.erase(cut.split.point(v));
  ASSERT_EQ(added.size(), 1u);
  // the cone over the hole has its tip there; what is missing are the cones over the flat ends, of together height 2
  const double end_area = around * 4 * std::sin(2 * CGAL_PI / around) / 2;
  const double expected = volume_with_cone(cut.split, *added.begin()) + std::copysign(2 * end_area / 3, volume);
  EXPECT_NEAR(volume, expected, 1e-9);
}

std::vector<Mesh> parts_without_curves(const Mesh& mesh, bool with_filled_holes,
                                       std::vector<SMC::Part_cap<Mesh>>* caps = nullptr)
{
  Mesh copy = mesh;
  const Marks marks = copy.add_property_map<Mesh::Edge_index, bool>("e:none", false).first;
  std::vector<Mesh> result;
  std::vector<SMC::Part_cap<Mesh>> told;
  SMC::extract_parts(copy, marks, std::back_inserter(result),
                     SMC::parameters::with_filled_holes(
                         with_filled_holes, SMC::parameters::cap_output_iterator(std::back_inserter(told))));
  if(caps != nullptr)
    *caps = told;
  return result;
}

// What has been taken away is given back, up to where the surface bends.
TEST(Boundary_parts, HolesOfTheMeshAreFilledWhenAsked)
{
  const Soup body = test_meshes::dumbbell(0.01, 1);
  for(unsigned seed = 0; seed < 10; ++seed)
  {
    const Mesh mesh = test_meshes::make_mesh(open_meshes::with_random_holes(body, 5, seed));
    const std::size_t holes = number_of_holes(mesh);
    ASSERT_GT(holes, 0u);
    const std::vector<Mesh> open = parts_without_curves(mesh, false);
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(number_of_holes(open[0]), holes);
    EXPECT_EQ(open[0].number_of_faces(), mesh.number_of_faces());

    std::vector<SMC::Part_cap<Mesh>> caps;
    const std::vector<Mesh> closed = parts_without_curves(mesh, true, &caps);
    ASSERT_EQ(closed.size(), 1u);
    EXPECT_TRUE(CGAL::is_closed(closed[0]));
    EXPECT_TRUE(closed[0].is_valid(false));
    EXPECT_EQ(closed[0].number_of_vertices(), open[0].number_of_vertices());
    EXPECT_EQ(caps.size(), holes);
    std::size_t triangles = 0;
    for(const SMC::Part_cap<Mesh>& c : caps)
    {
      EXPECT_EQ(c.part, 0u);
      EXPECT_FALSE(c.intersects_part);
      for(Mesh::Halfedge_index h : c.border)
        EXPECT_TRUE(mesh.is_border(mesh.opposite(h)));
      triangles += c.border.size() - 2;
    }
    EXPECT_EQ(closed[0].number_of_faces(), mesh.number_of_faces() + triangles);
    EXPECT_GT(PMP::volume(closed[0]), 0.9 * PMP::volume(test_meshes::make_mesh(body)));
  }
}

// Two holes that touch at a vertex are two loops, and the vertex is one again when both are filled.
TEST(Boundary_parts, HolesThatTouchAreFilledEach)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.01, 1));
  const double volume = PMP::volume(mesh);
  const std::size_t nf = mesh.number_of_faces(), nv = mesh.number_of_vertices();
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(0));
  const Mesh::Halfedge_index across = mesh.opposite(mesh.next(mesh.opposite(mesh.next(h))));
  for(Mesh::Face_index f : {mesh.face(h), mesh.face(across)})
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  ASSERT_EQ(number_of_holes(mesh), 2u);
  const std::vector<Mesh> closed = parts_without_curves(mesh, true);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(CGAL::is_closed(closed[0]));
  EXPECT_TRUE(closed[0].is_valid(false));
  EXPECT_EQ(closed[0].number_of_faces(), nf);
  EXPECT_EQ(closed[0].number_of_vertices(), nv);
  EXPECT_NEAR(PMP::volume(closed[0]), volume, 1e-12);
}

// Holes that touch in many places, several of them at a vertex, and some in two vertices: no two caps have an edge in
// common, which would make a part no manifold.
TEST(Boundary_parts, HolesThatTouchInManyPlacesAreFilledEach)
{
  const Soup torus = test_meshes::torus(0.05, 1, 14, 7), body = test_meshes::dumbbell(0.05, 1, 12, 6);
  std::size_t doubled = 0, touching_twice = 0;
  for(unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Mesh mesh = test_meshes::make_mesh(seed % 2 == 0 ? torus : body);
    std::mt19937 random(seed);
    const unsigned most = 5 + 10 * (seed % 5);
    std::vector<Mesh::Face_index> taken;
    for(Mesh::Face_index f : mesh.faces())
      if(random() % 100 < most)
        taken.push_back(f);
    for(Mesh::Face_index f : taken)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    mesh.collect_garbage();
    std::map<Mesh::Vertex_index, std::size_t> holes_at;
    std::map<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>, std::size_t> common;
    std::map<Mesh::Halfedge_index, Mesh::Halfedge_index> hole_of;
    for(Mesh::Halfedge_index h : mesh.halfedges())
      if(mesh.is_border(h))
      {
        ++holes_at[mesh.target(h)];
        const auto around = mesh.halfedges_around_face(h);
        hole_of[h] = *std::min_element(around.begin(), around.end());
      }
    for(const auto& [h, hole] : hole_of)
      for(const auto& [other, other_hole] : hole_of)
        if(mesh.target(h) == mesh.target(other) && hole < other_hole)
          touching_twice += ++common[{hole, other_hole}] == 2;
    for(const auto& at : holes_at)
      doubled += at.second > 1;

    std::vector<SMC::Part_cap<Mesh>> caps;
    const std::vector<Mesh> closed = parts_without_curves(mesh, true, &caps);
    std::size_t faces = 0;
    for(const Mesh& part : closed)
    {
      EXPECT_TRUE(CGAL::is_closed(part));
      EXPECT_TRUE(part.is_valid(false));
      faces += part.number_of_faces();
    }
    std::size_t triangles = 0;
    std::set<Mesh::Halfedge_index> capped;
    for(const SMC::Part_cap<Mesh>& c : caps)
    {
      triangles += c.border.size() - 2;
      for(Mesh::Halfedge_index h : c.border)
        EXPECT_TRUE(capped.insert(h).second);
    }
    EXPECT_EQ(capped.size(), hole_of.size());
    // a cone has two triangles more than the triangulation of its polygon
    EXPECT_GE(faces, mesh.number_of_faces() + triangles);
    EXPECT_LE(faces, mesh.number_of_faces() + triangles + 2 * caps.size());
    EXPECT_EQ((faces - mesh.number_of_faces() - triangles) % 2, 0u);
  }
  EXPECT_GT(doubled, 500u);
  EXPECT_GT(touching_twice, 20u);
}

// A triangle alone cannot be closed by a triangle.
TEST(Boundary_parts, ATriangleIsClosedByACone)
{
  Mesh mesh;
  const Mesh::Vertex_index a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
                           c = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c);
  const std::vector<Mesh> closed = parts_without_curves(mesh, true);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(CGAL::is_closed(closed[0]));
  EXPECT_EQ(closed[0].number_of_faces(), 4u);
  EXPECT_EQ(parts_without_curves(mesh, false).front().number_of_faces(), 1u);
}

} // namespace test_boundary_parts
