// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as people draw them: washers, counterbores and pipes around regular polygons, where ties are exact; and boxes
// rotated in doubles, where what was flat is bent by rounding, either way.
#include "include/curve_to_settle.h"
#include "include/detect.h"
#include "include/exact_models.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Root_sum.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <type_traits>
#include <vector>

namespace test_structured_bodies {

using namespace CGAL::Surface_mesh_constrictions;
using curve_to_settle::Curve;
using curve_to_settle::loop_of;
using curve_to_settle::Point_map;
using exact_models::Position;
using exact_models::Soup;
using internal::Rational;
using internal::Root_sum;

typedef std::vector<std::array<double, 2>> Profile; // of (radius, height)

// The surface that a closed profile sweeps around a regular polygon of n corners. Vertex i of ring r is r n + i.
Soup lathe(int n, const Profile& profile)
{
  Soup soup;
  const std::size_t around = static_cast<std::size_t>(n), rings = profile.size();
  for(const auto& p : profile)
    for(int i = 0; i < n; ++i)
      soup.points.push_back({{p[0] * std::cos(2 * CGAL_PI * i / n), p[0] * std::sin(2 * CGAL_PI * i / n), p[1]}});
  for(std::size_t r = 0; r < rings; ++r)
    for(std::size_t i = 0; i < around; ++i)
    {
      const std::size_t a = r * around + i, b = r * around + (i + 1) % around;
      const std::size_t c = (r + 1) % rings * around + (i + 1) % around, d = (r + 1) % rings * around + i;
      soup.faces.push_back({{a, c, b}});
      soup.faces.push_back({{a, d, c}});
    }
  return soup;
}

std::vector<Index> ring_of(int n, std::size_t ring)
{
  std::vector<Index> result;
  for(int i = 0; i < n; ++i)
    result.push_back(static_cast<Index>(ring * static_cast<std::size_t>(n)) + static_cast<Index>(i));
  return result;
}

// As files hold it: moved and scaled, and rounded to single precision.
Soup as_in_a_file(Soup soup, std::mt19937& random)
{
  std::uniform_real_distribution<double> shift(-20, 20), factor(0.1, 10);
  const double scale = factor(random);
  const Position by = {{shift(random), shift(random), shift(random)}};
  for(Position& p : soup.points)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] = static_cast<float>(scale * p[i] + by[i]);
  return soup;
}

double ring_length(const Soup& soup, const std::vector<Index>& ring)
{
  double sum = 0;
  for(std::size_t i = 0; i < ring.size(); ++i)
  {
    const Position &p = soup.points[ring[i]], &q = soup.points[ring[(i + 1) % ring.size()]];
    sum += std::hypot(q[0] - p[0], std::hypot(q[1] - p[1], q[2] - p[2]));
  }
  return sum;
}

// The rotation about an axis by an angle, both drawn, in doubles.
Soup rotated(Soup soup, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double q[4], norm = 0;
  for(double& x : q)
  {
    x = normal(random);
    norm += x * x;
  }
  for(double& x : q)
    x /= std::sqrt(norm);
  const double a = q[0], b = q[1], c = q[2], d = q[3];
  for(Position& p : soup.points)
    p = {{(a * a + b * b - c * c - d * d) * p[0] + 2 * (b * c - a * d) * p[1] + 2 * (b * d + a * c) * p[2],
          2 * (b * c + a * d) * p[0] + (a * a - b * b + c * c - d * d) * p[1] + 2 * (c * d - a * b) * p[2],
          2 * (b * d - a * c) * p[0] + 2 * (c * d + a * b) * p[1] + (a * a - b * b - c * c + d * d) * p[2]}};
  return soup;
}

// What has been decided step by step is what one examination of the result finds.
void expect_verdict_anew(const Curve& curve, Certificate_verdict verdict)
{
  typedef internal::Imported_surface<test_meshes::Mesh, Point_map> Surface;
  const Surface surface(curve.pm, curve.imported, curve.mesh.points());
  internal::Certifier<Surface> certifier(surface);
  std::vector<internal::Exact_arc<Surface>> arcs;
  for(const internal::Arc& a : internal::arcs_of_curve(curve.network, curve.id))
    arcs.push_back({{a.from, a.to, a.along, {a.crossings.begin(), a.crossings.end()}}, 0});
  EXPECT_EQ(certifier.examine(arcs).certificate.verdict, verdict);
}

TEST(RootSum, IsZeroOnlyIfEachSquareClassCancels)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> number(1, 1000);
  for(int round = 0; round < 20; ++round)
  {
    Root_sum sum, more, less;
    for(int k = 0; k < 100; ++k)
    {
      // q sqrt(r a^2) + q' sqrt(r b^2) + q'' sqrt(r), with q a + q' b + q'' = 0
      const Rational r = Rational(number(random)) / number(random);
      const Rational a = Rational(number(random)) / number(random), b = Rational(number(random)) / number(random);
      const Rational q = number(random) - 500, p = Rational(number(random)) / 7;
      for(Root_sum* s : {&sum, &more, &less})
      {
        s->add(q, r * a * a);
        s->add(p, r * b * b);
        s->add(-q * a - p * b, r);
      }
    }
    EXPECT_EQ(sum.sign(), 0);
    // by far less than intervals of 256 bits can see
    Rational tiny = 1;
    for(int i = 0; i < 12; ++i)
      tiny /= Rational(1e100);
    more.add(tiny, 2);
    less.add(-tiny, 3);
    EXPECT_EQ(more.sign(), 1);
    EXPECT_EQ(less.sign(), -1);
  }
  EXPECT_EQ(Root_sum().sign(), 0);
}

// What a prismatic strip says of three corners is what the unfolded strip says, whose coordinates are products of
// roots.
TEST(PrismaticStrip, TurnsAsTheUnfoldedStripDoes)
{
  typedef internal::Imported_surface<test_meshes::Mesh, Point_map> Surface;
  std::mt19937 random(7);
  int zeros = 0;
  for(int n : {3, 4, 5, 6})
  {
    const auto polygon = exact_models::polygon(n);
    std::vector<std::vector<Position>> rings;
    for(int r = 0; r < 5; ++r)
      rings.push_back(exact_models::ring(polygon, 1, 300 * r));
    const Curve mesh(exact_models::tube(rings), {});
    const Surface surface(mesh.pm, mesh.imported, mesh.mesh.points());
    internal::Sign_prover<Surface> prover(surface);
    for(int round = 0; round < 120; ++round)
    {
      // around the wall by its diagonals and its upright edges, through one or another row
      std::vector<Index> strip = {static_cast<Index>(random() % (3 * mesh.mesh.number_of_faces()))};
      for(std::size_t length = 2 + random() % 8; strip.size() < length;)
      {
        const Index o = mesh.pm.opposite(strip.back());
        strip.push_back(random() % 2 == 0 ? mesh.pm.next(o) : mesh.pm.prev(o));
      }
      const auto prism = internal::Prismatic_strip<Surface>::make(surface, strip);
      if(!prism)
        continue;
      const auto corners = internal::strip_corners(surface, strip);
      for(int k = 0; k < 10; ++k)
      {
        internal::Strip_corner c[3];
        for(auto& x : c)
          x = corners[random() % corners.size()];
        const auto sign = prover.sign([&](const auto& arithmetic, auto& value) {
          typedef typename std::decay_t<decltype(arithmetic)>::NT NT;
          const internal::Planar<NT> one(arithmetic.number(1), arithmetic.number(0));
          const internal::Planar<NT> zero(arithmetic.number(0), arithmetic.number(0));
          const auto unfolded = internal::unfold(surface, arithmetic, {one, zero}, strip);
          const auto at = [&](int i) { return unfolded.portals[c[i].portal].end(c[i].side); };
          value[0] = internal::determinant(at(1) - at(0), at(2) - at(1));
        });
        const auto place = [&](int i) { return prism->corner(c[i].portal, c[i].side); };
        EXPECT_EQ(prism->turn(place(0), place(1), place(2)), sign);
        zeros += sign == internal::Proved_sign::ZERO && c[0].portal != c[1].portal && c[1].portal != c[2].portal &&
                 c[0].portal != c[2].portal;
      }
    }
  }
  EXPECT_GT(zeros, 40);
}

// Strips that are bent about more than one direction, or folded back, are none.
TEST(PrismaticStrip, IsNoneAroundACornerOrOnACone)
{
  typedef internal::Imported_surface<test_meshes::Mesh, Point_map> Surface;
  const auto polygon = exact_models::polygon(5);
  for(double factor : {1., 1.001})
  {
    const Soup soup = exact_models::tube({exact_models::ring(polygon, 1, 0), exact_models::ring(polygon, factor, 500)});
    const Curve mesh(soup, {});
    const Surface surface(mesh.pm, mesh.imported, mesh.mesh.points());
    std::vector<Index> strip;
    const auto cross = [&](std::size_t u, std::size_t v) {
      strip.push_back(mesh.pm.halfedge(static_cast<Index>(u), static_cast<Index>(v)));
    };
    const auto at = [&](std::size_t i, double f, double z) {
      return exact_models::vertices_at(soup, {exact_models::ring(polygon, f, z)[i]}).front();
    };
    cross(at(1, 1, 0), at(1, factor, 500));
    cross(at(1, 1, 0), at(2, factor, 500));
    cross(at(2, 1, 0), at(2, factor, 500));
    EXPECT_EQ(static_cast<bool>(internal::Prismatic_strip<Surface>::make(surface, strip)), factor == 1.);
    // over the rim
    strip.pop_back();
    cross(at(1, 1, 0), at(2, 1, 0));
    EXPECT_FALSE(internal::Prismatic_strip<Surface>::make(surface, strip));
  }
}

// The bore of a washer is a flat band, whose ends are its rims. Each ring of it is held, whatever the number of sides.
TEST(StructuredBodies, TheBoreOfAWasherIsABandForAnyNumberOfSides)
{
  std::mt19937 random(2);
  for(int n : {3, 4, 5, 7, 16, 45, 90, 192, 512})
    for(bool is_from_file : {false, true})
    {
      Soup soup = lathe(n, {{1.3, 0}, {1.3, 0.6}, {1.3, 1.7}, {1.3, 2.1}, {2.9, 2.1}, {2.9, 0}});
      if(is_from_file)
        soup = as_in_a_file(soup, random);
      const double height = soup.points[static_cast<std::size_t>(3 * n)][2] - soup.points[0][2];
      for(std::size_t r = 0; r < 4; ++r)
      {
        Curve curve(soup, ring_of(n, r));
        const Certificate certificate = curve.settler.settle(curve.network, curve.id);
        EXPECT_EQ(certificate.verdict, Certificate_verdict::CONSTRICTION) << n << ' ' << r << ' ' << certificate;
        EXPECT_EQ(certificate.signs.unproved, 0u);
        EXPECT_EQ(curve.settler.number_of_corrections(), 0u);
        EXPECT_NEAR(curve.length(), ring_length(soup, ring_of(n, 0)), 1e-12 * curve.length());
        EXPECT_NEAR(certificate.flat_band_width, height, 1e-9 * height);
      }
    }
}

// Of a counterbore the narrow bore is held at the face below and at the shelf.
TEST(StructuredBodies, TheThroatOfACounterboreIsABandForAnyNumberOfSides)
{
  std::mt19937 random(3);
  for(int n : {3, 6, 33, 90, 128, 512})
    for(bool is_from_file : {false, true})
    {
      Soup soup = lathe(n, {{4.1, 0}, {4.1, 3}, {9.25, 3}, {9.25, 4}, {14, 4}, {14, 0}});
      if(is_from_file)
        soup = as_in_a_file(soup, random);
      for(std::size_t r = 0; r < 2; ++r)
      {
        Curve curve(soup, ring_of(n, r));
        const Certificate certificate = curve.settler.settle(curve.network, curve.id);
        EXPECT_EQ(certificate.verdict, Certificate_verdict::CONSTRICTION) << n << ' ' << r << ' ' << certificate;
        EXPECT_EQ(certificate.signs.unproved, 0u);
      }
    }
}

// A helix of diagonals on the wall of a thin pipe comes down to its straight bore; on the way lines run exactly through
// vertices, in strips of as many planes as the polygon has sides.
TEST(StructuredBodies, StaircasesAroundAPrismArePulledIntoRings)
{
  for(int n : {5, 12, 70})
  {
    Profile profile;
    for(int r = 0; r < 6; ++r)
      profile.push_back({{2, r / 4.}});
    profile.push_back({{3, 1.25}});
    profile.push_back({{3, 0}});
    const Soup soup = lathe(n, profile);
    // up by the diagonals of four quadrilaterals, along the ring, down by four edges
    std::vector<Index> loop;
    const Index around = static_cast<Index>(n);
    for(Index i = 0; i <= 4; ++i)
      loop.push_back(i * around + i % around);
    for(Index i = 5; i <= around; ++i)
      loop.push_back(4 * around + i % around);
    for(Index r = 3; r >= 1; --r)
      loop.push_back(r * around);
    for(bool is_reversed : {false, true})
    {
      std::vector<Index> path = loop;
      if(is_reversed)
        std::reverse(path.begin(), path.end());
      Curve curve(soup, path);
      EXPECT_EQ(curve.settle(), Certificate_verdict::CONSTRICTION) << n;
      EXPECT_NEAR(curve.length(), ring_length(soup, ring_of(n, 0)), 1e-12 * curve.length());
      expect_verdict_anew(curve, Certificate_verdict::CONSTRICTION);
    }
  }
}

// In doubles the faces of a rotated tube are not quite planar, and the curve is held at one place of it, its length
// that of the flat band but for the last digits; or in a part of the band that has stayed flat.
TEST(StructuredBodies, TheTubeOfARotatedBoxHoldsACurve)
{
  for(int length : {1, 4, 20})
  {
    const Soup plain = test_meshes::boxes_with_tube(length);
    for(unsigned seed = 0; seed < 10; ++seed)
    {
      const Soup soup = rotated(plain, seed);
      for(double x = 2; x <= 2 + length; x += (std::max)(1., length / 3.))
      {
        const double at = std::floor(x);
        std::vector<Index> ring = loop_of(plain, {{{at, 1, 1}}, {{at, 2, 1}}, {{at, 2, 2}}, {{at, 1, 2}}});
        if(seed % 2 == 1)
          std::reverse(ring.begin(), ring.end());
        Curve curve(soup, ring);
        const Certificate certificate = curve.settler.settle(curve.network, curve.id);
        EXPECT_TRUE(certificate.is_certified()) << length << ' ' << seed << ' ' << x << ": " << certificate;
        ASSERT_FALSE(curve.is_degenerate());
        EXPECT_NEAR(curve.length(), 4, 1e-12);
        expect_verdict_anew(curve, certificate.verdict);
      }
    }
  }
}

// Hundreds of near ties along one curve: rings on the finely divided wall of a rotated pipe, and curves across many
// rows.
TEST(StructuredBodies, ARotatedBoreWithManyRowsHoldsACurve)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    const int n = seed % 2 == 0 ? 24 : 150;
    Profile profile;
    for(int r = 0; r <= 8; ++r)
      profile.push_back({{1, r / 8.}});
    profile.push_back({{2, 1}});
    profile.push_back({{2, 0}});
    const Soup plain = lathe(n, profile), soup = rotated(plain, seed);
    for(std::size_t r = 0; r <= 8; r += 2)
    {
      Curve curve(soup, ring_of(n, r));
      const Certificate certificate = curve.settler.settle(curve.network, curve.id);
      EXPECT_TRUE(certificate.is_certified()) << seed << ' ' << r << ": " << certificate;
      ASSERT_FALSE(curve.is_degenerate());
      EXPECT_NEAR(curve.length(), ring_length(plain, ring_of(n, 0)), 1e-11);
      expect_verdict_anew(curve, certificate.verdict);
    }
  }
}

// Points in a frame with these axes, moved.
void place(Soup& soup, const std::array<Position, 3>& axes, const Position& by)
{
  for(Position& p : soup.points)
  {
    Position q = by;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        q[i] += axes[i][j] * p[j];
    p = q;
  }
}

const std::array<Position, 3> axes = {{{{0.10454287898179526, 0.6627097812339403, -0.7415433448633069}},
                                       {{0.3202172736720537, -0.7283516258765991, -0.6057762018476393}},
                                       {{-0.9415581150923374, -0.1741254000419744, -0.28835509526274616}}}};

// Rotated and rounded to single precision the meridians of a washer are twins, which correction moves: of those that
// are passed by each may then stand for the other.
TEST(StructuredBodies, AWasherOfWhichTwinsStandForEachOtherHasItsThroat)
{
  const double r = 0.5000012138511418, h = 3.614806257030315;
  Soup soup = lathe(64, {{{r, 0}}, {{r, h / 2}}, {{r, h}}, {{2 * r, h}}, {{2 * r, 0}}});
  place(soup, axes, {{-2.605762706563972, -0.360784119055392, -1.156461141611711}});
  for(Position& p : soup.points)
    for(double& x : p)
      x = static_cast<float>(x);
  const auto curves = detection::detect(test_meshes::make_mesh(soup));
  ASSERT_FALSE(curves.empty());
  EXPECT_NEAR(curves[0].length(), 128 * r * std::sin(CGAL_PI / 64), 1e-5);
}

// Correction moves the meridians of a rotated washer, which all have the same length. One stands for all of them, and
// not each for itself.
TEST(StructuredBodies, OneMeridianOfARotatedWasherStandsForAll)
{
  for(const int n : {48, 64})
  {
    Soup soup = lathe(n, {{{1, 0}}, {{1, 1.5}}, {{1, 3}}, {{2, 3}}, {{2, 0}}});
    place(soup, axes, {{0, 0, 0}});
    const auto curves = detection::detect(test_meshes::make_mesh(soup));
    ASSERT_EQ(curves.size(), 2u) << n;
    EXPECT_NEAR(curves[0].length(), 2 * n * std::sin(CGAL_PI / n), 1e-9);
    EXPECT_NEAR(curves[1].length(), 8, 0.1); // around the ring, a little shorter than straight along the axis
  }
}

// So do those of a counterbore, whose correction makes of one what stood for another.
TEST(StructuredBodies, OneMeridianOfACounterboreStandsForAll)
{
  for(const int n : {8, 12, 16})
  {
    const auto curves = detection::detect(
        test_meshes::make_mesh(lathe(n, {{{4, 0}}, {{4, 3}}, {{8, 3}}, {{8, 4}}, {{13, 4}}, {{13, 0}}})));
    ASSERT_FALSE(curves.empty());
    EXPECT_NEAR(curves[0].length(), 8 * n * std::sin(CGAL_PI / n), 1e-9) << n;
    EXPECT_EQ(std::count_if(curves.begin(), curves.end(),
                            [](const auto& c) { return 23 < c.length() && c.length() < 26 && c.roundness() < 0.7; }),
              1)
        << n;
  }
}

// Many meridians of nearly the same length: around each the next ones are longer by 4e-5, and rounding to floats makes
// lengths differ by 1e-8. The way to the shortest one leads past all of them.
TEST(StructuredBodies, AWayPastManyTwinsLeadsToTheOneThatStandsForAll)
{
  for(const bool is_rounded : {false, true})
  {
    Soup soup = lathe(96, {{{4, 0}}, {{4, 3}}, {{8, 3}}, {{8, 4}}, {{13, 4}}, {{13, 0}}});
    if(is_rounded)
      for(auto& p : soup.points)
        for(double& x : p)
          x = static_cast<float>(x);
    const auto curves = detection::detect(test_meshes::make_mesh(soup));
    ASSERT_FALSE(curves.empty());
    EXPECT_NEAR(curves[0].length(), 8 * 96 * std::sin(CGAL_PI / 96), 1e-5);
    EXPECT_LE(std::count_if(curves.begin(), curves.end(),
                            [](const auto& c) { return 23 < c.length() && c.length() < 26 && c.roundness() < 0.7; }),
              2);
  }
}

} // namespace test_structured_bodies
