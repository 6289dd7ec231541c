// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/seeds/Redundant_triangles.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace test_redundant_triangles {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::Seed_curve;
using SMC::Seed_origin;

const std::size_t fine = 1000; // vertices

// A tube along z with triangles of these circumradii as sections, and tips. Vertices 3i, 3i + 1 and 3i + 2 are section i.
// Between two sections one corner after the other can be led over two faces from the one to the other.
test_meshes::Soup triangular_tube(const std::vector<double>& radii)
{
  test_meshes::Soup soup;
  const double step = 0.1;
  for(std::size_t i = 0; i < radii.size(); ++i)
    for(int j = 0; j < 3; ++j)
    {
      const double phi = 2 * CGAL_PI * j / 3;
      soup.points.push_back({{radii[i] * std::cos(phi), radii[i] * std::sin(phi), step * static_cast<double>(i)}});
    }
  const std::size_t tip = soup.points.size(), last = tip - 3;
  soup.points.push_back({{0, 0, -1}});
  soup.points.push_back({{0, 0, step * static_cast<double>(radii.size()) + 1}});
  for(std::size_t a = 0; a < last; a += 3)
  {
    const std::size_t b = a + 3;
    soup.faces.insert(soup.faces.end(), {{{a, a + 1, b}},
                                         {{a + 1, b + 1, b}},
                                         {{a + 1, a + 2, b + 1}},
                                         {{a + 2, b + 2, b + 1}},
                                         {{a + 2, a, b}},
                                         {{a + 2, b, b + 2}}});
  }
  for(std::size_t j = 0; j < 3; ++j)
  {
    soup.faces.push_back({{(j + 1) % 3, j, tip}});
    soup.faces.push_back({{last + j, last + (j + 1) % 3, tip + 1}});
  }
  return soup;
}

std::vector<Seed_curve> triangles_of(const SMC::Progressive_mesh& pm)
{
  std::vector<Seed_curve> seeds;
  SMC::Non_face_triangle_seeds()(pm, {pm.number_of_vertices(), 0, SMC::null_index, nullptr}, std::back_inserter(seeds));
  return seeds;
}

std::vector<Index> sorted(std::vector<Index> vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

TEST(RedundantTriangles, OfAllBesideANeckTheShortestIsLeft)
{
  const SMC::Progressive_mesh pm =
      test_meshes::make_progressive(triangular_tube({1, 0.9, 0.8, 0.9, 1, 0.85, 0.7, 0.85, 1}));
  std::vector<Seed_curve> seeds = triangles_of(pm);
  EXPECT_EQ(seeds.size(), 25u); // the sections, and two on the way from each to the next
  SMC::internal::Redundant_triangles().remove(pm, fine, 0, seeds);
  std::vector<std::vector<Index>> left;
  for(const Seed_curve& s : seeds)
    left.push_back(sorted(s.vertices));
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::vector<Index>>{{6, 7, 8}, {18, 19, 20}}));
}

TEST(RedundantTriangles, OnCoarseLevelsAllAreLeft)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(triangular_tube({1, 0.8, 1}));
  std::vector<Seed_curve> seeds = triangles_of(pm);
  const std::size_t n = seeds.size();
  SMC::internal::Redundant_triangles().remove(pm, fine - 1, 0, seeds);
  EXPECT_EQ(seeds.size(), n);
}

// A source of the caller's may leave out the shorter one.
TEST(RedundantTriangles, WhereTheShorterOneIsNoSeedTheLongerOneIsLeft)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(triangular_tube({1, 0.8, 1}));
  std::vector<Seed_curve> seeds = {{0, {0, 1, 2}, Seed_origin::NON_FACE_TRIANGLE}};
  SMC::internal::Redundant_triangles().remove(pm, fine, 0, seeds);
  EXPECT_EQ(seeds.size(), 1u);
}

// A triangle is found again when a corner has moved, maybe from another corner. Loops of other sources are none of it.
TEST(RedundantTriangles, ATriangleIsOneSeedHoweverOftenItIsFound)
{
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(triangular_tube({1, 0.8, 1}));
  SMC::internal::Redundant_triangles redundant;
  std::vector<Seed_curve> seeds = {{0, {3, 4, 5}, Seed_origin::NON_FACE_TRIANGLE}};
  redundant.remove(pm, fine, 0, seeds);
  EXPECT_EQ(seeds.size(), 1u);
  seeds.push_back({200, {5, 3, 4}, Seed_origin::NON_FACE_TRIANGLE});
  seeds.push_back({200, {3, 4, 5}, Seed_origin::CUT_LOCUS});
  redundant.remove(pm, fine, 1, seeds);
  ASSERT_EQ(seeds.size(), 2u);
  EXPECT_EQ(seeds[1].origin, Seed_origin::CUT_LOCUS);
}

} // namespace test_redundant_triangles
