// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Side_of_triangle_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace test_side {

namespace SMC = CGAL::Surface_mesh_constrictions;
using detection::detect;
using real_meshes::read;
using test_meshes::Mesh;
typedef Mesh::Point Point;
typedef SMC::Constriction<Mesh> Constriction;
typedef CGAL::Side_of_triangle_mesh<Mesh, test_meshes::Kernel> Side_of_mesh;

// The share of a surface spanned by the curve that lies in the solid: of points on the chords from the points of the
// curve to their mean, without the ends, where the surface begins.
double share_inside(const Mesh& mesh, const Side_of_mesh& side_of_mesh, const Constriction& curve)
{
  std::vector<Point> points;
  curve.points(mesh, std::back_inserter(points));
  test_meshes::Kernel::Vector_3 sum(0, 0, 0);
  for(const Point& p : points)
    sum = sum + (p - CGAL::ORIGIN);
  const Point center = CGAL::ORIGIN + sum / static_cast<double>(points.size());
  std::size_t inside = 0, all = 0;
  for(const Point& p : points)
    for(double t : {0.15, 0.3, 0.45, 0.6, 0.75, 0.9})
    {
      const CGAL::Bounded_side side = side_of_mesh(p + t * (center - p));
      inside += side == CGAL::ON_BOUNDED_SIDE;
      all += side != CGAL::ON_BOUNDARY;
    }
  return static_cast<double>(inside) / static_cast<double>(all);
}

struct Counts
{
  std::size_t object = 0, complement = 0;
};

// The side is found from the curvature along the curve; what the curve spans is a check that knows nothing of it.
Counts expect_spanned_surface_on_its_side(const Mesh& mesh)
{
  const Side_of_mesh side_of_mesh(mesh);
  Counts counts;
  for(const Constriction& c : detect(mesh))
  {
    if(c.side() == SMC::Side::MIXED)
      continue;
    const double share = share_inside(mesh, side_of_mesh, c);
    if(c.side() == SMC::Side::OBJECT)
    {
      ++counts.object;
      EXPECT_GT(share, 0.5) << "object, of length " << c.length();
    }
    else
    {
      ++counts.complement;
      EXPECT_LT(share, 0.5) << "complement, of length " << c.length();
    }
  }
  return counts;
}

// The neck of the inner wall separates the surface, and what it chokes is the space inside the bottle.
TEST(Side, TheNeckOfAHollowBottleChokesTheComplement)
{
  for(unsigned seed = 0; seed < 2; ++seed)
    for(bool inside_out : {false, true})
    {
      const test_meshes::Soup soup = test_meshes::bottle(0.01, seed);
      const Mesh mesh = test_meshes::make_mesh(inside_out ? test_meshes::inside_out(soup) : soup);
      const Side_of_mesh side_of_mesh(mesh);
      std::size_t necks = 0;
      for(const Constriction& c : detect(mesh))
      {
        if(std::abs(c.length() - 2 * CGAL_PI * 0.3) > 0.1)
          continue;
        ++necks;
        EXPECT_TRUE(c.is_separating());
        EXPECT_EQ(c.side(), SMC::Side::COMPLEMENT);
        EXPECT_EQ(share_inside(mesh, side_of_mesh, c), 0);
      }
      EXPECT_EQ(necks, 1u);
    }
}

// Two boxes with a tube, around `middle`.
test_meshes::Soup boxes(double scale, const test_meshes::Position& middle = {{0, 0, 0}})
{
  test_meshes::Soup soup = test_meshes::boxes_with_tube(2);
  for(test_meshes::Position& p : soup.points)
    p = {{(p[0] - 3) * scale + middle[0], (p[1] - 1.5) * scale + middle[1], (p[2] - 1.5) * scale + middle[2]}};
  return soup;
}

// A box from -size to size in each direction.
test_meshes::Soup box_around_origin(int size)
{
  test_meshes::Soup soup = test_meshes::box(2 * size, 2 * size, 2 * size);
  for(test_meshes::Position& p : soup.points)
    for(double& x : p)
      x -= size;
  return soup;
}

std::vector<SMC::Side> sides_by_length(const test_meshes::Soup& soup)
{
  std::vector<Constriction> found = detect(test_meshes::make_mesh(soup));
  std::sort(found.begin(), found.end(),
            [](const Constriction& a, const Constriction& b) { return a.length() < b.length(); });
  std::vector<SMC::Side> result;
  for(const Constriction& c : found)
    result.push_back(c.side());
  return result;
}

// The sides of the constrictions of these surfaces together, which do not depend on which way all normals point.
void expect_sides(const std::vector<test_meshes::Soup>& surfaces, const std::vector<SMC::Side>& expected)
{
  test_meshes::Soup soup;
  for(const test_meshes::Soup& s : surfaces)
    soup = test_meshes::joined(soup, s, 0);
  EXPECT_EQ(sides_by_length(soup), expected);
  EXPECT_EQ(sides_by_length(test_meshes::inside_out(soup)), expected);
}

TEST(Side, TheNeckOfACavityChokesTheComplement)
{
  const SMC::Side object = SMC::Side::OBJECT, complement = SMC::Side::COMPLEMENT;
  using test_meshes::inside_out;
  expect_sides({box_around_origin(4), inside_out(boxes(1))}, {complement});
  // the outer surface comes last, and has a neck itself
  expect_sides({inside_out(boxes(0.2, {{-2, 0, 0}})), boxes(1)}, {complement, object});
  // a solid in the cavity of another one
  expect_sides({boxes(1), box_around_origin(5), inside_out(box_around_origin(4))}, {object});
  // a solid in a surface of the same orientation
  expect_sides({box_around_origin(4), boxes(1)}, {object});
}

// Files have solids whose normals point inside beside others whose normals do not.
TEST(Side, WhatIsNotEnclosedIsNoCavity)
{
  const SMC::Side object = SMC::Side::OBJECT;
  using test_meshes::inside_out;
  expect_sides({box_around_origin(2), inside_out(boxes(0.5, {{9, 0, 0}}))}, {object});
  // between two boxes, and so in the bounding box: beside their tube, above it and below it
  for(const test_meshes::Position& middle : {test_meshes::Position{{0, 1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}})
    expect_sides({inside_out(boxes(0.1, middle)), boxes(1)}, {object, object});
  // in a box with a hole
  test_meshes::Soup open = box_around_origin(4);
  open.faces.pop_back();
  expect_sides({open, inside_out(boxes(1))}, {object});
}

TEST(Side, TheSpannedSurfaceIsOnTheSideOfGeneratedMeshes)
{
  const Counts dumbbell = expect_spanned_surface_on_its_side(test_meshes::make_mesh(test_meshes::dumbbell(0.02, 1)));
  EXPECT_GE(dumbbell.object, 1u);
  EXPECT_EQ(dumbbell.complement, 0u);
  for(bool inside_out : {false, true})
  {
    const test_meshes::Soup soup = test_meshes::torus(0.01, 2, 30, 14, 0.3);
    const Counts torus =
        expect_spanned_surface_on_its_side(test_meshes::make_mesh(inside_out ? test_meshes::inside_out(soup) : soup));
    EXPECT_GE(torus.object, 1u);
    EXPECT_GE(torus.complement, 1u);
  }
  const Counts bottle = expect_spanned_surface_on_its_side(test_meshes::make_mesh(test_meshes::bottle(0.01, 3)));
  EXPECT_GE(bottle.complement, 1u);
}

TEST(Side, TheSpannedSurfaceIsOnTheSideOfRealMeshes)
{
  const Counts camel = expect_spanned_surface_on_its_side(read("camel.off"));
  EXPECT_GE(camel.object, 10u);
  const Counts eight = expect_spanned_surface_on_its_side(read("eight.off"));
  EXPECT_GE(eight.object, 1u);
  EXPECT_GE(eight.complement, 1u);
}

} // namespace test_side
