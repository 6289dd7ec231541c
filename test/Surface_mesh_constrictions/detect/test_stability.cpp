// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/subdivision_method_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace test_stability {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using real_meshes::read;
using test_meshes::Mesh;
using test_meshes::Soup;
typedef Mesh::Point Point;
typedef SMC::Constriction<Mesh> Constriction;

struct Neck
{
  double length, band_width, prominence;
  Point center;
};

// Necks are compared from this prominence on; in the other mesh they may be a third less prominent.
const double least_prominence = 0.2;

std::vector<Neck> necks(const Mesh& mesh)
{
  std::vector<Constriction> curves;
  SMC::detect_constrictions(mesh, std::back_inserter(curves), params::minimum_prominence(least_prominence));
  std::vector<Neck> result;
  for(const Constriction& c : curves)
  {
    std::vector<Point> points;
    c.points(mesh, std::back_inserter(points));
    // the mean along the curve: points are as dense as the mesh
    CGAL::Vector_3<test_meshes::Kernel> sum(0, 0, 0);
    double length = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const Point &p = points[i], &q = points[(i + 1) % points.size()];
      const double l = std::sqrt(CGAL::squared_distance(p, q));
      sum = sum + l * (CGAL::midpoint(p, q) - CGAL::ORIGIN);
      length += l;
    }
    result.push_back({length, c.flat_band_width(), c.prominence(), CGAL::ORIGIN + sum / length});
  }
  return result;
}

// The same length within five percent, and the same place within the radius of a circle of that length; anywhere in the
// flat band if there is one.
bool match(const Neck& a, const Neck& b)
{
  return std::abs(a.length - b.length) <= 0.05 * a.length && std::sqrt(CGAL::squared_distance(a.center, b.center)) <=
                                                                 a.length / (2 * CGAL_PI) + a.band_width + b.band_width;
}

std::size_t count_matches(const Neck& neck, const std::vector<Neck>& others)
{
  return static_cast<std::size_t>(
      std::count_if(others.begin(), others.end(), [&](const Neck& n) { return match(neck, n); }));
}

// Each neck of at least the given prominence of one mesh is one of the other mesh, and the other way round.
void expect_same_necks(const std::vector<Neck>& necks, const std::vector<Neck>& others, std::size_t expected,
                       double prominence = 0.3)
{
  std::size_t prominent = 0;
  for(const Neck& n : necks)
    if(n.prominence >= prominence)
    {
      ++prominent;
      EXPECT_GE(count_matches(n, others), 1u) << "lost: length " << n.length << " at " << n.center;
    }
  for(const Neck& n : others)
    if(n.prominence >= prominence)
    {
      EXPECT_GE(count_matches(n, necks), 1u) << "new: length " << n.length << " at " << n.center;
    }
  EXPECT_GE(prominent, expected);
}

// Each vertex moved at random by at most the given share of the mean length of its edges.
Mesh with_noise(const Mesh& mesh, double share, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mesh result = mesh;
  for(auto v : mesh.vertices())
  {
    double length = 0;
    for(auto h : CGAL::halfedges_around_target(v, mesh))
      length += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(mesh.source(h))));
    const double size = share * length / mesh.degree(v);
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    result.point(v) = mesh.point(v) + size * CGAL::Vector_3<test_meshes::Kernel>(x, y, z);
  }
  return result;
}

// With one percent of noise, in two triangulations.
template <class Make>
void expect_stable(Make make, std::size_t expected, double prominence = 0.3)
{
  const std::vector<Neck> without_noise = necks(test_meshes::make_mesh(make(0, 0, 0)));
  for(unsigned seed = 1; seed <= 2; ++seed)
    for(int triangulation = 0; triangulation < 2; ++triangulation)
    {
      SCOPED_TRACE(std::to_string(triangulation) + ", noise " + std::to_string(seed));
      expect_same_necks(without_noise, necks(test_meshes::make_mesh(make(0.01, seed, triangulation))), expected,
                        prominence);
    }
}

TEST(Stability, OfADumbbell)
{
  expect_stable(
      [](double noise, unsigned seed, int triangulation) {
        return triangulation == 0 ? test_meshes::dumbbell(noise, seed) : test_meshes::dumbbell(noise, seed, 35, 25);
      },
      1);
}

TEST(Stability, OfAChainOfNecks)
{
  expect_stable(
      [](double noise, unsigned seed, int triangulation) {
        return triangulation == 0 ? test_meshes::chain_of_necks(noise, seed)
                                  : test_meshes::chain_of_necks(noise, seed, 75, 27);
      },
      4);
}

TEST(Stability, OfATorusWithItsMeridianAndItsEquator)
{
  expect_stable(
      [](double noise, unsigned seed, int triangulation) {
        return triangulation == 0 ? test_meshes::torus(noise, seed, 30, 14, 0.3)
                                  : test_meshes::torus(noise, seed, 41, 19, 0.3);
      },
      2);
}

// Less prominent are belts around the body, which is a cube: where they run, noise decides.
TEST(Stability, OfATreeOfBoxes)
{
  expect_stable(
      [](double noise, unsigned seed, int triangulation) {
        return test_meshes::jittered(test_meshes::branches(1 + triangulation), noise, seed);
      },
      3, 0.5);
}

TEST(Stability, OfARealMeshWithNoise)
{
  const Mesh camel = read("camel.off");
  expect_same_necks(necks(camel), necks(with_noise(camel, 0.01, 1)), 12);
}

TEST(Stability, OfARealMeshInAnotherTriangulation)
{
  const Mesh dino = read("dino.off");
  Mesh finer = with_noise(dino, 0.01, 2);
  CGAL::Subdivision_method_3::Loop_subdivision(finer, CGAL::parameters::number_of_iterations(1));
  EXPECT_EQ(finer.number_of_faces(), 4 * dino.number_of_faces());
  expect_same_necks(necks(dino), necks(finer), 5);
}

} // namespace test_stability
