// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/exact_models.h"
#include "include/random_hull.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Quotient.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Finite_field_number.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_disc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Radical_number.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Rational.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Side_angle.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Square_root_basis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_exact_arithmetic {

using namespace CGAL::Surface_mesh_constrictions;
using namespace CGAL::Surface_mesh_constrictions::internal;

Rational fraction(int n, int d) { return Rational(Integer(n), Integer(d)); }

TEST(ExactRational, OfEveryKindOfNumber)
{
  EXPECT_EQ(*exact_rational(0.1), Rational(0.1));
  EXPECT_EQ(*exact_rational(7), Rational(7));
  typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Lazy;
  EXPECT_EQ(*exact_rational(Lazy(1) / Lazy(3)), fraction(1, 3));
  EXPECT_EQ(*exact_rational(CGAL::Quotient<CGAL::MP_Float>(2, 7)), fraction(2, 7));
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT Root;
  EXPECT_EQ(*exact_rational(Root(0.1)), Rational(0.1));
  EXPECT_EQ(*exact_rational(Root(-5) / Root(7)), fraction(-5, 7));
  EXPECT_EQ(*exact_rational(CGAL::sqrt(Root(9)) / Root(4)), fraction(9, 12));
  EXPECT_FALSE(exact_rational(CGAL::sqrt(Root(2))));
  EXPECT_FALSE(exact_rational(Root(1e20) + Root(1) / Root(3))); // whose neighbouring integers are no doubles
}

// A turned box grows by a factor each time; a disc does not.
TEST(MultiprecisionDisc, HoldsTheExactPointAndStaysSmallWhereItIsTurned)
{
  for(mpfr_prec_t precision : {128, 256, 600, 4000})
  {
    const auto interval = [precision](const Rational& x) { return Multiprecision_interval(x, precision); };
    typedef Planar<Multiprecision_interval> Disc;
    std::mt19937 random(1);
    std::uniform_int_distribution<int> integer(-20, 20);
    Planar<Rational> exact(1, 0), exact_sum(0, 0);
    Disc disc(interval(1), interval(0)), sum(interval(0), interval(0));
    for(int i = 0; i < 300; ++i)
    {
      // a rotation by a rational point of the circle
      const int m = integer(random), n = 21 + integer(random) / 2, square = m * m + n * n;
      const Rational x = fraction(n * n - m * m, square), y = fraction(2 * m * n, square);
      exact = exact * Planar<Rational>(x, y);
      disc = disc * Disc(interval(x), interval(y));
      exact_sum = exact_sum + conjugate(exact);
      sum = sum - (Disc(interval(0), interval(0)) - conjugate(disc));
    }
    const Rational small = 1 / Rational(Integer(1) << static_cast<unsigned>(precision - 20));
    for(const auto& difference : {std::make_pair(disc.x(), exact.x()), std::make_pair(disc.y(), exact.y()),
                                  std::make_pair(sum.x(), exact_sum.x()), std::make_pair(sum.y(), exact_sum.y())})
    {
      EXPECT_EQ((difference.first - interval(difference.second)).certain_sign(), 0);
      EXPECT_EQ((difference.first - interval(difference.second + small)).certain_sign(), -1);
      EXPECT_EQ((difference.first - interval(difference.second - small)).certain_sign(), 1);
    }
  }
}

TEST(SquareRootBasis, ReducesToSquareClasses)
{
  // 12 = 3 * 2^2, 27 = 3 * 3^2, 18 = 2 * 3^2, 24 = 2 * 3 * 2^2, 25 = 5^2
  Work_budget budget;
  const Square_root_basis basis({12, 27, 18, 24, 25, 0, fraction(3, 4)}, budget);
  EXPECT_TRUE(basis.is_valid());
  ASSERT_EQ(basis.basis().size(), 2u);
  EXPECT_EQ(basis.root(12).coefficient, 1);
  EXPECT_EQ(basis.root(27).mask, basis.root(12).mask);
  EXPECT_EQ(basis.root(27).coefficient, fraction(3, 2)); // sqrt 27 = 3/2 sqrt 12
  EXPECT_EQ(basis.root(24).mask, basis.root(12).mask | basis.root(18).mask);
  EXPECT_EQ(basis.root(24).coefficient, fraction(1, 3)); // sqrt 24 = sqrt 12 sqrt 18 / 3
  EXPECT_EQ(basis.root(25).mask, 0u);
  EXPECT_EQ(basis.root(25).coefficient, 5);
  EXPECT_EQ(basis.root(0).coefficient, 0);
  EXPECT_EQ(basis.root(fraction(3, 4)).coefficient, fraction(1, 4)); // sqrt(3/4) = sqrt 12 / 4
}

TEST(SquareRootBasis, EachRootSquaredIsItsRadicand)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> integer(1, 60);
  std::vector<Rational> radicands;
  for(int i = 0; i < 40; ++i)
    radicands.push_back(fraction(integer(random), integer(random)));
  Work_budget budget;
  const Square_root_basis basis(radicands, budget);
  for(const Rational& r : radicands)
  {
    Rational square = basis.root(r).coefficient * basis.root(r).coefficient;
    for(std::size_t i = 0; i < basis.basis().size(); ++i)
      if((basis.root(r).mask >> i) & 1)
        square *= basis.basis()[i];
    EXPECT_EQ(square, r);
    EXPECT_GT(basis.root(r).coefficient, 0);
  }
}

TEST(SquareRootBasis, MoreThan64ClassesAreTooMany)
{
  std::vector<Rational> primes;
  for(int p = 2; primes.size() < 70; ++p)
  {
    bool is_prime = true;
    for(int d = 2; d * d <= p; ++d)
      is_prime = is_prime && p % d != 0;
    if(is_prime)
      primes.emplace_back(p);
  }
  Work_budget budget;
  EXPECT_FALSE(Square_root_basis(primes, budget).is_valid());
  primes.resize(60);
  EXPECT_TRUE(Square_root_basis(primes, budget).is_valid());
  EXPECT_EQ(Square_root_basis(primes, budget).basis().size(), 60u);
}

// sqrt 2, sqrt 3 and sqrt 6 as elements of a field with two roots.
struct RootsOfSix : public ::testing::Test
{
  Work_budget budget;
  Square_root_basis basis = Square_root_basis({2, 3, 6}, budget);
  Radical_field field = Radical_field(basis.basis(), budget);

  Radical_number radical(int r) { return Radical_number(basis.root(r).coefficient, basis.root(r).mask, field); }
  Radical_number radical_integer(int n) { return Radical_number(n, 0, field); }

  Finite_field_number modular(int r) const
  {
    Finite_field_number result = *Finite_field_number::image(basis.root(r).coefficient);
    for(std::size_t i = 0; i < basis.basis().size(); ++i)
      if((basis.root(r).mask >> i) & 1)
        result = result * Finite_field_number::square_root(basis.basis()[i]);
    return result;
  }
};

TEST_F(RootsOfSix, ZeroIsProvedByTheBasis)
{
  const Radical_number sum = radical(2) + radical(3);
  EXPECT_TRUE((sum * sum - radical_integer(5) - radical_integer(2) * radical(6)).is_zero());
  EXPECT_FALSE((sum * sum - radical_integer(5) - radical(6)).is_zero());
  EXPECT_FALSE((radical(2) * radical(3) + radical(6)).is_zero());
}

TEST_F(RootsOfSix, FiniteFieldRespectsEveryRelation)
{
  const Finite_field_number sum = modular(2) + modular(3), two = *Finite_field_number::image(2),
                            five = *Finite_field_number::image(5);
  EXPECT_TRUE((sum * sum - five - two * modular(6)).is_zero());
  EXPECT_FALSE((sum * sum - five - modular(6)).is_zero());
  EXPECT_FALSE(Finite_field_number::image(Rational(Integer(1), Integer(Finite_field_number::prime))));
}

TEST_F(RootsOfSix, TooManyStepsAreGivenUp)
{
  field.steps_left = 3;
  EXPECT_THROW((radical(2) + radical(3)) * (radical(2) + radical(3)), Too_many_steps);
}

TEST_F(RootsOfSix, LongCoefficientsTakeMoreSteps)
{
  const auto steps = [this](const Radical_number& x, const Radical_number& y, const auto& operation) {
    const std::size_t before = budget.algebra_steps_left, left = field.steps_left;
    operation(x, y);
    EXPECT_EQ(left - field.steps_left, before - budget.algebra_steps_left);
    return before - budget.algebra_steps_left;
  };
  const auto times = [](const Radical_number& x, const Radical_number& y) { return x * y; };
  const auto plus = [](const Radical_number& x, const Radical_number& y) { return x + y; };
  const auto minus = [](const Radical_number& x, const Radical_number& y) { return x - y; };
  // as long as a product of a dozen coordinates near 1 and a dozen that are subnormal
  const Rational thousands = 1 + 1 / Rational(Integer(1) << 12 * 1074);
  const Radical_number long_one(thousands, 0, field), long_root(thousands, 1, field);
  const std::size_t long_product = steps(long_one, long_one, times), short_product = 1;
  EXPECT_GT(long_product, 100u);
  EXPECT_EQ(steps(long_one, long_one, plus) + short_product, long_product);
  EXPECT_EQ(steps(long_one, long_one, minus) + short_product, long_product);
  EXPECT_EQ(steps(long_one, long_root, plus), 0u) << "nothing is added";
  EXPECT_GT(steps(long_root, long_root, times), long_product) << "the root squared is a factor";
  EXPECT_EQ(steps(radical(2), radical(3), times), short_product);

  field.steps_left = long_product - 1;
  EXPECT_THROW(long_one * long_one, Too_many_steps);
  field.steps_left = Radical_field::max_steps;
  budget.algebra_steps_left = long_product - 1;
  EXPECT_THROW(long_one * long_one, Too_many_steps);
  EXPECT_FALSE((radical(2) * radical(3)).is_zero()) << "short coefficients need little";
  budget.algebra_steps_left = long_product - 2;
  EXPECT_THROW(long_one + long_one, Too_many_steps);
  budget.algebra_steps_left = long_product;
  EXPECT_FALSE((long_one * long_one).is_zero());
}

TEST(MultiprecisionInterval, EnclosesRootsAndProducts)
{
  for(mpfr_prec_t precision : {2, 24, 53, 300})
  {
    const auto root = Multiprecision_interval::square_root(2, precision);
    const auto error = root * root - Multiprecision_interval(2, precision);
    EXPECT_EQ(error.certain_sign(), 0) << precision;
    EXPECT_EQ((root - Multiprecision_interval(fraction(1, 8), precision)).certain_sign(), 1);
    EXPECT_EQ((Multiprecision_interval(-1, precision) * root).certain_sign(), -1);
  }
  const Rational tiny = fraction(1, 1 << 30) * fraction(1, 1 << 30) * fraction(1, 1 << 30);
  EXPECT_EQ((Multiprecision_interval(1 + tiny, 60) - Multiprecision_interval(1, 60)).certain_sign(), 0);
  EXPECT_EQ((Multiprecision_interval(1 + tiny, 200) - Multiprecision_interval(1, 200)).certain_sign(), 1);
}

TEST(PlanarDisc, EnclosesProductsSumsAndDeterminants)
{
  typedef CGAL::Interval_nt<false> Interval;
  Interval::Protector upward;
  std::mt19937 random(11);
  std::uniform_int_distribution<int> integer(-1000, 1000);
  const auto contains = [](const Interval& i, const Rational& q) {
    return Rational(i.inf()) <= q && q <= Rational(i.sup()) && i.sup() - i.inf() < 1e-9 * (1 + std::abs(i.sup()));
  };
  const auto number = [](int n, int d) {
    return Interval(n) / Interval(d); // rounded, so the discs are not points
  };
  for(int round = 0; round < 2000; ++round)
  {
    // the same random computation on discs and on exact complex numbers
    Planar<Interval> z(Interval(1), Interval(0));
    Planar<Rational> exact(Rational(1), Rational(0));
    for(int step = 0; step < 12; ++step)
    {
      const int a = integer(random), b = integer(random), d = 1 + std::abs(integer(random));
      const Planar<Interval> f(number(a, d), number(b, d));
      const Planar<Rational> g(fraction(a, d), fraction(b, d));
      switch(integer(random) & 3)
      {
      case 0:
        z = z + f, exact = exact + g;
        break;
      case 1:
        z = z - f, exact = exact - g;
        break;
      case 2:
        z = conjugate(z), exact = conjugate(exact);
        break;
      default:
        if(a != 0 || b != 0)
          z = z * f, exact = exact * g;
      }
      ASSERT_TRUE(contains(z.x(), exact.x()) && contains(z.y(), exact.y()));
      ASSERT_TRUE(contains(determinant(z, f), determinant(exact, g)));
    }
  }
}

TEST(PlanarDisc, StaysNarrowInLongProducts)
{
  typedef CGAL::Interval_nt<false> Interval;
  Interval::Protector upward;
  const Planar<Interval> turn(Interval(3) / Interval(5), Interval(4) / Interval(5));
  Planar<Interval> z(Interval(1), Interval(0));
  for(int i = 0; i < 1000; ++i)
    z = z * turn;
  EXPECT_LT(z.x().sup() - z.x().inf(), 1e-11);
}

typedef test_meshes::Mesh Mesh;
typedef Graph_surface<Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>> Surface;

TEST(SignProver, EachStageDecidesWhatItIsFor)
{
  // right triangles with legs 1 and 1: every corner is a multiple of 45 degrees
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(1, 1, 1));
  const Surface surface(mesh, mesh.points());
  Sign_prover<Surface> prover(surface);
  const Mesh::Halfedge_index h = *halfedges(mesh).begin();

  // the three angles of a triangle add up to pi
  const auto sine_of_sum = [&](const auto& arithmetic, auto& values) {
    const auto sum = arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h));
    values[0] = sum.y();
    values[1] = sum.x();
  };
  const std::vector<Proved_sign> signs = prover.signs(2, sine_of_sum);
  EXPECT_EQ(signs[0], Proved_sign::ZERO);
  EXPECT_EQ(signs[1], Proved_sign::NEGATIVE);
  EXPECT_EQ(prover.statistics().interval, 1u);
  EXPECT_EQ(prover.statistics().algebra, 1u);
}

// All faces around a vertex lie in a plane of integers, so that its angles compare with pi as edges turn in the plane.
TEST(SideAngle, InAPlaneItIsThatFromOneEdgeToTheOther)
{
  const std::vector<std::pair<int, int>> directions = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                                       {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const std::size_t n = directions.size();
  for(unsigned seed = 1; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> component(-9, 9), multiple(1, 5);
    const std::array<double, 3> e = {{1.0 * component(random), 1.0 * component(random), 10.}},
                                f = {{1.0 * component(random), 10., 0.5 * component(random)}};
    test_meshes::Soup soup;
    std::vector<std::pair<int, int>> star;
    soup.points.push_back({{0, 0, 0}});
    for(const std::pair<int, int>& d : directions)
    {
      const int m = multiple(random);
      star.emplace_back(m * d.first, m * d.second);
      soup.points.push_back({});
      for(std::size_t k = 0; k < 3; ++k)
        soup.points.back()[k] = star.back().first * e[k] + star.back().second * f[k];
    }
    soup.points.push_back({{100, -100, 0}});
    for(std::size_t i = 0; i < n; ++i)
    {
      soup.faces.push_back({{0, 1 + i, 1 + (i + 1) % n}});
      soup.faces.push_back({{n + 1, 1 + (i + 1) % n, 1 + i}});
    }
    const Mesh mesh = test_meshes::make_mesh(soup);
    const Surface surface(mesh, mesh.points());
    const auto arc = [&](std::size_t from, std::size_t to) {
      const Mesh::Vertex_index a(static_cast<Mesh::size_type>(from)), b(static_cast<Mesh::size_type>(to));
      Exact_arc<Surface> result;
      result.from = a;
      result.to = b;
      result.along = mesh.halfedge(a, b);
      return result;
    };
    std::size_t straight = 0;
    Sign_prover<Surface> prover(surface);
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < n; ++j)
      {
        if(i == j)
          continue;
        // from the outgoing edge counterclockwise to the incoming one
        const int turn = star[j].first * star[i].second - star[j].second * star[i].first;
        const Exact_arc<Surface> incoming = arc(1 + i, 0), outgoing = arc(0, 1 + j);
        EXPECT_EQ(Side_angle<Surface>(prover, incoming, outgoing, Curve_side::LEFT).sign_beyond_pi(),
                  proved_sign(-turn));
        EXPECT_EQ(Side_angle<Surface>(prover, incoming, outgoing, Curve_side::RIGHT).sign_beyond_pi(),
                  proved_sign(turn));
        straight += turn == 0;
      }
    EXPECT_EQ(straight, n);
    EXPECT_EQ(prover.statistics().algebra, 2 * n);
    EXPECT_EQ(prover.statistics().multiprecision, 0u);
  }
}

TEST(SignProver, NumbersBelow256BitsAreProvedNonzeroAndGetTheirSign)
{
  // the face of the tetrahedron whose area is irrational
  const Mesh mesh = test_meshes::make_mesh(test_meshes::tetrahedron());
  const Surface surface(mesh, mesh.points());
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(2));
  const auto expression = [&](int sign) {
    return [&mesh, h, sign](const auto& arithmetic, auto& values) {
      const auto sum = arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h));
      auto power = arithmetic.number(sign);
      for(int i = 0; i < 2000; ++i)
        power = power * arithmetic.ratio(h).x();
      values[0] = sum.y() + power; // 0, or a positive or negative number far below 256 bits
    };
  };
  Sign_prover<Surface> prover(surface);
  EXPECT_EQ(prover.sign(expression(1)), Proved_sign::POSITIVE);
  EXPECT_EQ(prover.sign(expression(-1)), Proved_sign::NEGATIVE);
  EXPECT_EQ(prover.sign(expression(0)), Proved_sign::ZERO);
  EXPECT_EQ(prover.statistics().finite_field, 2u);
  EXPECT_EQ(prover.statistics().algebra, 1u);
}

TEST(SignProver, AllSignsOfACurveHaveOneBudget)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::tetrahedron());
  const Surface surface(mesh, mesh.points());
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(2));
  const auto cosine_of_sum = [&](const auto& arithmetic) {
    return (arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h))).x();
  };
  // positive, and below 256 bits
  const auto small = [&](const auto& arithmetic, auto& values) {
    const auto sum = arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h));
    auto power = arithmetic.number(1);
    for(int i = 0; i < 2000; ++i)
      power = power * arithmetic.ratio(h).x();
    values[0] = sum.y() + power;
  };
  Sign_prover<Surface> prover(surface);
  std::size_t n = 0;
  while(n < 1000 && prover.sign(small) == Proved_sign::POSITIVE)
    ++n;
  EXPECT_GT(n, 2u);
  EXPECT_LT(n, 1000u);
  EXPECT_EQ(prover.statistics().finite_field, n);
  EXPECT_EQ(prover.statistics().unproved, 1u);
  EXPECT_EQ(prover.sign(small), Proved_sign::UNPROVED);
  EXPECT_EQ(prover.sign([&](const auto& arithmetic, auto& values) { values[0] = cosine_of_sum(arithmetic); }),
            Proved_sign::NEGATIVE)
      << "which needs no budget";
  std::size_t attempts = 0, attempts_of_another = 0;
  const auto give_up = [&](std::size_t& count) {
    return prover.decide_by_intervals([&](const auto& arithmetic) {
      cosine_of_sum(arithmetic);
      ++count;
      return false;
    });
  };
  EXPECT_FALSE(give_up(attempts));
  prover.begin_curve();
  EXPECT_FALSE(give_up(attempts_of_another));
  EXPECT_LT(attempts, attempts_of_another);
  prover.begin_curve();
  EXPECT_EQ(prover.sign(small), Proved_sign::POSITIVE);
}

TEST(SquareRootBasis, LongRadicandsTakeMoreSteps)
{
  const auto steps = [](const std::vector<Rational>& radicands) {
    Work_budget budget;
    const Square_root_basis basis(radicands, budget);
    return Work_budget::max_steps - budget.steps_left;
  };
  const Rational long_one = 2 + 1 / Rational(Integer(1) << 12 * 1074);
  EXPECT_GT(steps({2, 3}), 0u);
  EXPECT_GT(steps({long_one, 3}), 2 * steps({2, 3}));
  Work_budget budget;
  budget.steps_left = steps({2, 3}) - 1;
  EXPECT_THROW(Square_root_basis({2, 3}, budget), Too_many_steps);
}

TEST(SignProver, AZeroOfTooManyTermsStaysUnprovedAndDoesNotHinderOthers)
{
  // the areas of twenty faces of a random hull have independent roots, and their product has 2^20 terms
  const Mesh mesh = test_meshes::make_mesh(test_meshes::random_hull(1, 30));
  const Surface surface(mesh, mesh.points());
  const Mesh::Halfedge_index h = *halfedges(mesh).begin();
  const auto expression = [&](const auto& arithmetic, auto& values) {
    values[0] = (arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h))).y();
    if(!values.wants(1))
      return;
    auto product = arithmetic.number(1);
    for(Mesh::Face_index f : mesh.faces())
      if(static_cast<std::size_t>(f) < 20)
        product = product * (arithmetic.number(1) + arithmetic.corner(mesh.halfedge(f)).y());
    values[1] = product - product;
  };
  Sign_prover<Surface> prover(surface);
  EXPECT_EQ(prover.signs(2, expression), (std::vector<Proved_sign>{Proved_sign::ZERO, Proved_sign::UNPROVED}));
  EXPECT_EQ(prover.statistics().algebra, 1u);
  EXPECT_EQ(prover.statistics().unproved, 1u);
}

TEST(SignProver, WhatHasNoImageInTheFiniteFieldIsProvedByTheBasis)
{
  // coordinates whose denominators are the prime of the field
  typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Exact_mesh;
  Exact_mesh mesh = test_meshes::make_graph<Exact_mesh>(test_meshes::tetrahedron());
  const Kernel::FT prime = Kernel::FT(static_cast<double>(std::uint64_t(1) << 61)) - 1;
  for(auto v : vertices(mesh))
  {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(p.x() / prime, p.y() / prime, p.z() / prime);
  }
  typedef Graph_surface<Exact_mesh, Exact_mesh::Property_map<Exact_mesh::Vertex_index, Kernel::Point_3>> Exact_surface;
  const Exact_surface surface(mesh, mesh.points());
  Sign_prover<Exact_surface> prover(surface);
  const Exact_mesh::Halfedge_index h = *halfedges(mesh).begin();
  const auto sine_of_sum = [&](const auto& arithmetic, auto& values) {
    values[0] = (arithmetic.corner(h) * arithmetic.corner(mesh.next(h)) * arithmetic.corner(mesh.prev(h))).y();
  };
  EXPECT_EQ(prover.sign(sine_of_sum), Proved_sign::ZERO);
  EXPECT_EQ(prover.statistics().finite_field, 0u);
  EXPECT_EQ(prover.statistics().algebra, 1u);
}

TEST(SignProver, WithTooManyRootsForABasisPrecisionGrowsUntilTheSignShows)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 1, 8, 8));
  ASSERT_GT(mesh.number_of_faces(), 100u);
  const Surface surface(mesh, mesh.points());
  // seen from its source, the third vertex of its face lies before the middle of it
  const auto base = *std::find_if(halfedges(mesh).begin(), halfedges(mesh).end(), [&mesh](Mesh::Halfedge_index h) {
    const auto a = mesh.point(mesh.source(h));
    const auto u = mesh.point(mesh.target(h)) - a, v = mesh.point(mesh.target(mesh.next(h))) - a;
    return u * v > 0.1 * (u * u) && u * v < 0.5 * (u * u);
  });
  const auto expression = [&mesh, base](int sign) {
    return [&mesh, base, sign](const auto& arithmetic, auto& values) {
      auto sum = arithmetic.number(0), power = arithmetic.number(sign);
      for(Mesh::Face_index f : mesh.faces())
        sum = sum + arithmetic.corner(mesh.halfedge(f)).y();
      for(int i = 0; i < 200; ++i)
        power = power * arithmetic.ratio(base).x();
      values[0] = sum - sum + power; // far below 128 bits
    };
  };
  Sign_prover<Surface> prover(surface);
  EXPECT_EQ(prover.sign(expression(1)), Proved_sign::POSITIVE);
  EXPECT_EQ(prover.statistics().multiprecision, 1u);
  EXPECT_EQ(prover.sign(expression(0)), Proved_sign::UNPROVED);
  EXPECT_EQ(prover.statistics().unproved, 1u);
}

TEST(SignProver, IntervalsThatNeverDecideAreGivenUp)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::tetrahedron());
  const Surface surface(mesh, mesh.points());
  Sign_prover<Surface> prover(surface);
  std::size_t attempts = 0;
  EXPECT_FALSE(prover.decide_by_intervals([&attempts](const auto&) {
    ++attempts;
    return false;
  }));
  EXPECT_GT(attempts, 2u);
  EXPECT_EQ(prover.statistics().unproved, 1u);
  // the first of the growing precisions
  EXPECT_TRUE(prover.decide_by_intervals([](const auto& arithmetic) {
    typedef typename std::decay_t<decltype(arithmetic)>::NT NT;
    return std::is_same<NT, Multiprecision_interval>::value;
  }));
  EXPECT_EQ(prover.statistics().multiprecision, 1u);
}

// Angles are compared with pi by intervals the same way as by summing them up.
TEST(AngleSum, AgreesWithTheSumOfTheAngles)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(1, 1, 1));
  const Surface surface(mesh, mesh.points());
  CGAL::Interval_nt<false>::Protector upward;
  const Interval_arithmetic<Surface> arithmetic(surface);
  typedef CGAL::Interval_nt<false> Interval;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, CGAL_PI);
  std::size_t decided = 0;
  for(int round = 0; round < 5000; ++round)
  {
    std::vector<Planar<Interval>> angles;
    double sum = 0;
    for(int n = 1 + static_cast<int>(random() % 6); n > 0; --n)
    {
      double a = angle(random);
      if(random() % 4 == 0)
        a = random() % 2 == 0 ? 0 : CGAL_PI; // corners of faces of area zero
      sum += a;
      angles.emplace_back(Interval(std::cos(a)), a == 0 || a == CGAL_PI ? Interval(0, 1e-16) : Interval(std::sin(a)));
    }
    const Angle_sum result = compare_angle_sum(arithmetic, angles);
    if(result == Angle_sum::UNKNOWN)
      continue;
    ++decided;
    if(std::abs(sum - CGAL_PI) > 1e-9)
    {
      EXPECT_EQ(result, sum < CGAL_PI ? Angle_sum::BELOW_PI : Angle_sum::ABOVE_PI) << sum;
    }
    else
      EXPECT_EQ(result, Angle_sum::AROUND_PI);
  }
  EXPECT_GT(decided, 4000u);
}

// Sums whose sine does not show its sign.
TEST(AngleSum, NearMultiplesOfPiTheCosineDecides)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(1, 1, 1));
  const Surface surface(mesh, mesh.points());
  typedef CGAL::Interval_nt<false> Interval;
  Interval::Protector upward;
  const Interval_arithmetic<Surface> arithmetic(surface);
  const Planar<Interval> zero(Interval(1), Interval(0, 1e-10)), pi(Interval(-1), Interval(-1e-10, 1e-10)),
      below_pi(Interval(-1), Interval(1e-12)), right(Interval(0), Interval(1)), any(Interval(-1, 1), Interval(-1, 1));
  EXPECT_EQ(compare_angle_sum(arithmetic, {zero, zero}), Angle_sum::BELOW_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {pi, zero}), Angle_sum::AROUND_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {right, right, zero}), Angle_sum::AROUND_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {below_pi, pi}), Angle_sum::ABOVE_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {pi, pi}), Angle_sum::ABOVE_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {below_pi, right}), Angle_sum::ABOVE_PI);
  EXPECT_EQ(compare_angle_sum(arithmetic, {any}), Angle_sum::UNKNOWN);
  EXPECT_EQ(compare_angle_sum(arithmetic, {pi, any}), Angle_sum::UNKNOWN);
}

} // namespace test_exact_arithmetic
