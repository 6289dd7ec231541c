// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/bound_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Surface_metric.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Window_distances.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_prominence_bounds {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace internal = SMC::internal;
using test_meshes::Mesh;
using test_meshes::Soup;
typedef SMC::Constriction<Mesh> Constriction;

std::vector<Constriction> detect_bounded(const Mesh& mesh)
{
  return detection::detect(mesh, SMC::parameters::prove_prominence(true));
}

// A chain of prisms over regular polygons, and what is between two of them; each ring has radius and height. Closed by
// flat caps.
Soup prisms(int sides, const std::vector<std::array<double, 2>>& rings)
{
  Soup soup;
  for(const auto& ring : rings)
    for(int j = 0; j < sides; ++j)
      soup.points.push_back(
          {{ring[0] * std::cos(2 * CGAL_PI * j / sides), ring[0] * std::sin(2 * CGAL_PI * j / sides), ring[1]}});
  const auto at = [sides](std::size_t i, int j) {
    return i * static_cast<std::size_t>(sides) + static_cast<std::size_t>(j % sides);
  };
  for(std::size_t i = 0; i + 1 < rings.size(); ++i)
    for(int j = 0; j < sides; ++j)
    {
      soup.faces.push_back({{at(i, j), at(i, j + 1), at(i + 1, j + 1)}});
      soup.faces.push_back({{at(i, j), at(i + 1, j + 1), at(i + 1, j)}});
    }
  const std::size_t bottom = soup.points.size(), last = rings.size() - 1;
  soup.points.push_back({{0, 0, rings.front()[1]}});
  soup.points.push_back({{0, 0, rings.back()[1]}});
  for(int j = 0; j < sides; ++j)
  {
    soup.faces.push_back({{at(0, j + 1), at(0, j), bottom}});
    soup.faces.push_back({{at(last, j), at(last, j + 1), bottom + 1}});
  }
  return soup;
}

// Around a thick prism no closed curve is shorter than the prism, and the curve that has come so far slides off at its
// end.
TEST(ProminenceBounds, ANeckBetweenTwoLongPrismsHoldsUntilItIsAsLongAsTheThinnerOne)
{
  for(int sides : {3, 4, 5, 6, 7, 8, 12})
  {
    const std::vector<Constriction> curves = detect_bounded(test_meshes::make_mesh(prisms(
        sides, {{{1.1, 0}}, {{1.1, 2}}, {{1.1, 4}}, {{0.5, 4.5}}, {{0.5, 5.5}}, {{1, 6}}, {{1, 8}}, {{1, 10}}})));
    ASSERT_EQ(curves.size(), 1u) << sides;
    EXPECT_NEAR(curves[0].prominence_interval()[0], 1, 1e-8) << sides;
    EXPECT_NEAR(curves[0].prominence_interval()[1], 1, 1e-2) << sides;
  }
}

// The points have integer coordinates. A finger of the curve that reaches three units down the sides of the boxes makes
// it longer by eight.
TEST(ProminenceBounds, ASquareTubeHoldsUntilItIsAsLongAsTheBeltOfALongBox)
{
  for(int length : {1, 2})
  {
    const std::vector<Constriction> curves =
        detect_bounded(test_meshes::make_mesh(test_meshes::voxels({{12 + length, 3, 3}}, [length](int i, int j, int k) {
          return i < 6 || i >= 6 + length || (j == 1 && k == 1);
        })));
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].prominence_interval()[0], 12. / 4 - 1, 1e-8);
    EXPECT_GE(curves[0].prominence_interval()[1], 12. / 4 - 1);
  }
}

// A square frame with two thick sides and two thin ones, of perimeter 4 and 6.
TEST(ProminenceBounds, AHandleSlidesOverTheThickPartOfARing)
{
  const std::vector<Constriction> curves =
      detect_bounded(test_meshes::make_mesh(test_meshes::voxels({{9, 18, 3}}, [](int i, int j, int k) {
        if(i < 3 || i >= 6)
          return true;
        return (j == 1 && k == 1) || (j == 16 && (k == 1 || k == 2));
      })));
  ASSERT_FALSE(curves.empty());
  std::size_t found = 0;
  for(const Constriction& c : curves)
  {
    if(std::abs(c.length() - 6) > 1e-9 || c.is_separating())
      continue;
    ++found;
    EXPECT_NEAR(c.prominence_interval()[0], 12. / 6 - 1, 1e-8);
    EXPECT_GE(c.prominence_interval()[1], 12. / 6 - 1);
  }
  EXPECT_EQ(found, 1u);
}

TEST(ProminenceBounds, TheLowerBoundIsNoGreaterThanTheUpperOne)
{
  for(unsigned seed = 1; seed < 2; ++seed)
    for(const Soup& soup : {test_meshes::dumbbell(0.1, seed), test_meshes::chain_of_necks(0.05, seed),
                            test_meshes::bottle(0.02, seed), test_meshes::torus(0.1, seed)})
      for(const Constriction& c : detect_bounded(test_meshes::make_mesh(soup)))
      {
        EXPECT_GE(c.prominence_interval()[0], 0);
        EXPECT_LE(c.prominence_interval()[0], c.prominence_interval()[1]);
        EXPECT_GE(c.prominence_interval()[1], c.prominence());
      }
}

TEST(ProminenceBounds, TheyAreNotComputedUnlessAskedFor)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 1));
  const std::vector<Constriction> curves = detection::detect(mesh), asked = detect_bounded(mesh);
  ASSERT_FALSE(curves.empty());
  EXPECT_TRUE(std::isnan(curves[0].prominence_interval()[0]));
  std::vector<Constriction> bounded;
  SMC::bound_prominences(mesh, curves, std::back_inserter(bounded));
  ASSERT_EQ(bounded.size(), asked.size());
  for(std::size_t i = 0; i < bounded.size(); ++i)
    EXPECT_EQ(bounded[i].prominence_interval(), asked[i].prominence_interval());
}

// A square of n x n squares with moved points, and its left side, the halfedges of which come first in their faces.
struct Sheet
{
  std::vector<SMC::Index> corners;
  std::vector<internal::Vector3> points;
  std::vector<SMC::Index> left;
};

template <class Height>
Sheet sheet(int n, unsigned seed, const Height& height)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  Sheet result;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      const bool is_inside = i > 0 && i < n && j > 0 && j < n;
      const double x = i + (is_inside ? uniform(random) : 0), y = j + (is_inside ? uniform(random) : 0);
      result.points.push_back({x, y, height(x, y)});
    }
  const auto at = [n](int i, int j) { return static_cast<SMC::Index>(i * (n + 1) + j); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      if(i == 0)
        result.left.push_back(static_cast<SMC::Index>(result.corners.size()));
      for(SMC::Index v : {at(i, j + 1), at(i, j), at(i + 1, j + 1), at(i, j), at(i + 1, j), at(i + 1, j + 1)})
        result.corners.push_back(v);
    }
  return result;
}

double least_at(const std::vector<internal::Wave>& waves, double x)
{
  double result = (std::numeric_limits<double>::infinity)();
  for(const internal::Wave& w : waves)
    if(w.begin - 1e-9 <= x && x <= w.end + 1e-9)
      result = (std::min)(result, w.value(x));
  return result;
}

TEST(ProminenceBounds, InThePlaneDistancesFromAStraightChainAreThoseOfALine)
{
  const Sheet s = sheet(8, 1, [](double, double) { return 0.; });
  const internal::Surface_metric metric(s.corners, s.points);
  internal::Window_distances distances(metric);
  distances.compute_from_chain(s.left, 100);
  for(SMC::Index v = 0; v < s.points.size(); ++v)
    EXPECT_NEAR(distances.distance(v), s.points[v].x, 1e-12);
  for(SMC::Index h = 0; h < metric.number_of_halfedges(); ++h)
  {
    if(metric.edge(h) != h)
      continue;
    std::vector<internal::Wave> waves;
    distances.waves(h, waves);
    const double from = s.points[metric.source(h)].x, to = s.points[metric.target(h)].x;
    for(double t : {0.1, 0.5, 0.8})
      EXPECT_NEAR(least_at(waves, t * metric.length(h)), from + t * (to - from), 1e-12);
  }
}

TEST(ProminenceBounds, DistancesOfVerticesAreThoseOfShortestPaths)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> Traits;
  for(unsigned seed = 1; seed < 4; ++seed)
  {
    const Sheet s =
        sheet(7, seed, [seed](double x, double y) { return 1.5 * std::sin(0.9 * x + seed) * std::cos(1.1 * y); });
    const internal::Surface_metric metric(s.corners, s.points);
    internal::Window_distances distances(metric);
    Mesh mesh;
    for(const internal::Vector3& p : s.points)
      mesh.add_vertex(Mesh::Point(p.x, p.y, p.z));
    for(std::size_t i = 0; i < s.corners.size(); i += 3)
      mesh.add_face(Mesh::Vertex_index(s.corners[i]), Mesh::Vertex_index(s.corners[i + 1]),
                    Mesh::Vertex_index(s.corners[i + 2]));
    for(SMC::Index from : {0u, 20u, 35u})
    {
      CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
      paths.add_source_point(Mesh::Vertex_index(from));
      for(SMC::Index to = 0; to < s.points.size(); ++to)
        EXPECT_NEAR(distances.between_vertices(from, to, 100),
                    paths.shortest_distance_to_source_points(Mesh::Vertex_index(to)).first, 1e-12);
    }
  }
}

} // namespace test_prominence_bounds
