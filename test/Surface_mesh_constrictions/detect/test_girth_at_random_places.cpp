// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

// Girths at random places of bodies on which they are known. On prisms and cones they are exact. On a body that is
// rounded it is that of the polyhedron, which is less by the square of the angle between neighbouring faces.
namespace test_girth_at_random_places {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
using test_meshes::Soup;
typedef Mesh::Point Point;
typedef SMC::Constriction_query<Mesh> Query;

// Of each kind of body.
int number_of_places() { return std::getenv("CONSTRICTIONS_ALL_PLACES") != nullptr ? 2000 : 12; }

void expect_girth(const Query& query, const Point& place, double length, double tolerance)
{
  const auto loop = query.girth(place);
  ASSERT_TRUE(loop) << place;
  EXPECT_NEAR(loop->length, length, tolerance * length) << place;
}

// A tube of radius 1 around an arc of a circle of radius `bend`, with flat ends.
Soup bent_tube(double bend, double arc, int along, int around)
{
  Soup soup;
  for(int i = 0; i <= along; ++i)
    for(int j = 0; j < around; ++j)
    {
      const double u = arc * i / along, v = 2 * CGAL_PI * j / around, r = bend + std::cos(v);
      soup.points.push_back({{r * std::cos(u), r * std::sin(u), std::sin(v)}});
    }
  const auto at = [around](int i, int j) { return static_cast<std::size_t>(i * around + j % around); };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < around; ++j)
    {
      soup.faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      soup.faces.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  for(int end : {0, along})
  {
    const double u = arc * end / along;
    soup.points.push_back({{bend * std::cos(u), bend * std::sin(u), 0}});
    for(int j = 0; j < around; ++j)
      if(end == 0)
        soup.faces.push_back({{at(0, j), at(0, j + 1), soup.points.size() - 1}});
      else
        soup.faces.push_back({{at(end, j + 1), at(end, j), soup.points.size() - 1}});
  }
  return soup;
}

TEST(GirthAtRandomPlaces, OfAPrismIsItsPerimeter)
{
  seeded_random::Random random(1);
  for(int n : {3, 5, 48})
  {
    SCOPED_TRACE(n);
    const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(n, 20));
    const Query query(mesh);
    const double phi = 2 * CGAL_PI / n;
    for(int i = 0; i < number_of_places(); i += 3)
    {
      const int side = random.integer(n);
      const double s = random.real(0, 1), a = phi * side, b = phi * (side + 1);
      expect_girth(
          query,
          Point((1 - s) * std::cos(a) + s * std::cos(b), (1 - s) * std::sin(a) + s * std::sin(b), random.real(7, 13)),
          2 * n * std::sin(phi / 2), 1e-11);
    }
  }
}

// A pyramid of 7 faces with an angle of 0.2 each at the apex: the loop is a chord of the sector that it unfolds to.
TEST(GirthAtRandomPlaces, OfAConeIsAChord)
{
  const int n = 7;
  const double angle = 0.2, slant = 10, radius = slant * std::sin(angle / 2) / std::sin(CGAL_PI / n),
               height = std::sqrt(slant * slant - radius * radius);
  Soup soup;
  soup.points.push_back({{0, 0, 0}});
  for(int j = 0; j < n; ++j)
    soup.points.push_back({{radius * std::cos(2 * CGAL_PI * j / n), radius * std::sin(2 * CGAL_PI * j / n), -height}});
  for(std::size_t j = 0; j < n; ++j)
    soup.faces.push_back({{0, 1 + j, 1 + (j + 1) % n}});
  const Mesh mesh = test_meshes::make_mesh(soup);
  const Query query(mesh);
  seeded_random::Random random(2);
  for(int i = 0; i < number_of_places(); ++i)
  {
    const std::size_t side = static_cast<std::size_t>(random.integer(n));
    const double s = random.real(0, 1), share = random.real(0.1, 0.7);
    std::array<double, 3> p = {};
    double squared = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      p[k] = share * ((1 - s) * soup.points[1 + side][k] + s * soup.points[1 + (side + 1) % n][k]);
      squared += p[k] * p[k];
    }
    expect_girth(query, Point(p[0], p[1], p[2]), 2 * std::sqrt(squared) * std::sin(n * angle / 2), 1e-9);
  }
}

TEST(GirthAtRandomPlaces, OfATorusAndABentTubeIsTheMeridian)
{
  const double arc = 4;
  const Mesh torus = test_meshes::make_mesh(test_meshes::torus(0, 1, 120, 60)),
             tube = test_meshes::make_mesh(bent_tube(3, arc, 80, 60));
  const Query on_torus(torus), on_tube(tube);
  seeded_random::Random random(3);
  for(int i = 0; i < number_of_places(); ++i)
  {
    const double v = random.real(0, 2 * CGAL_PI), r = 3 + std::cos(v);
    const auto place = [&](double u) { return Point(r * std::cos(u), r * std::sin(u), std::sin(v)); };
    expect_girth(on_torus, place(random.real(0, 2 * CGAL_PI)), 2 * CGAL_PI, 5e-3);
    expect_girth(on_tube, place(arc * random.real(0.4, 0.6)), 2 * CGAL_PI, 5e-3);
  }
}

// With axes 3, 1, 1: held at one point the equator is the shortest loop, as its conjugate points are further apart than
// it is long.
TEST(GirthAtRandomPlaces, OfALongEllipsoidAtItsEquatorIsTheEquator)
{
  Soup soup = test_meshes::revolution([](double s) { return std::sin(CGAL_PI * (0.01 + 0.98 * s)); }, 1, 81, 60, 0, 1);
  const double end = 3 * std::cos(CGAL_PI * 0.01);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
  {
    std::array<double, 3>& p = soup.points[i];
    const double s = p[2]; // of the parameter, but at the apexes
    p[2] = s < 0 ? -3 : s > 1 ? 3 : -end * std::cos(CGAL_PI * (0.01 + 0.98 * s)) / std::cos(CGAL_PI * 0.01);
  }
  const Mesh mesh = test_meshes::make_mesh(soup);
  const Query query(mesh);
  seeded_random::Random random(4);
  for(int i = 0; i < number_of_places(); ++i)
  {
    const double v = random.real(0, 2 * CGAL_PI);
    expect_girth(query, Point(std::cos(v), std::sin(v), 0), 2 * CGAL_PI, 5e-3);
  }
}

} // namespace test_girth_at_random_places
