// SPDX-License-Identifier: GPL-3.0-or-later
// Where the floating-point arithmetic of a thread is not what the proofs rely on, nothing is certified.
#include "include/detect.h"
#include "include/exact_models.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/floating_point_defect.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <future>
#include <sstream>
#include <string>
#include <vector>

#if defined(__x86_64__) || defined(_M_X64)
#include <immintrin.h>
#define HAS_MXCSR
#endif

namespace test_floating_point {

using namespace CGAL::Surface_mesh_constrictions;
using internal::floating_point_defect;
using test_meshes::Mesh;

const std::vector<int> rounding_modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

// Runs a function with a rounding mode, which it must keep.
template <class Function>
void with_rounding(int mode, const Function& function)
{
  ASSERT_EQ(std::fesetround(mode), 0);
  function();
  const int after = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(after, mode);
}

// The square waist between two frusta, a strict constriction.
struct Waist
{
  exact_models::Soup soup = exact_models::waist(1);
  Mesh mesh = test_meshes::make_mesh(soup);
  Constriction<Mesh> curve = exact_models::curve_of_loop(
      mesh, exact_models::vertices_at(soup, exact_models::ring(exact_models::square(), 1, 5)));

  Certificate certify() const { return certify_constriction(mesh, curve); }
};

std::string text_of(const Certificate& certificate)
{
  std::ostringstream out;
  out << certificate;
  return out.str();
}

TEST(FloatingPoint, HasNoDefectInAnyRoundingMode)
{
  for(int mode : rounding_modes)
    with_rounding(mode, [] { EXPECT_EQ(floating_point_defect(), Certificate_verdict::NOT_COMPUTED); });
}

TEST(FloatingPoint, TheRoundingModeOfTheCallerDoesNotChangeACertificate)
{
  const Waist waist;
  for(int mode : rounding_modes)
    with_rounding(mode, [&] { EXPECT_EQ(waist.certify().verdict, Certificate_verdict::STRICT_CONSTRICTION); });
}

TEST(FloatingPoint, WhatIsFoundInAnotherRoundingModeIsCertified)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.02, 3));
  for(int mode : rounding_modes)
    with_rounding(mode, [&] {
      const auto found = detection::detect(mesh);
      EXPECT_GE(found.size(), 4u) << mode;
      std::fesetround(FE_TONEAREST);
      for(const Constriction<Mesh>& c : found)
      {
        EXPECT_TRUE(c.certificate().is_certified()) << mode << ": " << c.certificate();
        EXPECT_EQ(certify_constriction(mesh, c).verdict, c.certificate().verdict) << mode;
      }
      std::fesetround(mode);
    });
}

// Intervals without width: what Interval_nt computes under valgrind, which always rounds to the nearest.
class Nearest
{
public:
  Nearest(double x) : m_x(x) {}

  double inf() const { return m_x; }
  double sup() const { return m_x; }

  friend Nearest operator+(const Nearest& a, const Nearest& b) { return rounded(a, b, 0); }
  friend Nearest operator-(const Nearest& a, const Nearest& b) { return rounded(a, b, 1); }
  friend Nearest operator*(const Nearest& a, const Nearest& b) { return rounded(a, b, 2); }
  friend Nearest operator/(const Nearest& a, const Nearest& b) { return rounded(a, b, 3); }
  friend Nearest square(const Nearest& a) { return a * a; }
  friend Nearest sqrt(const Nearest& a) { return rounded(a, a, 4); }

private:
  static Nearest rounded(const Nearest& a, const Nearest& b, int operation)
  {
    const CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    const volatile double x = a.m_x, y = b.m_x;
    const volatile double result = operation == 0   ? x + y
                                   : operation == 1 ? x - y
                                   : operation == 2 ? x * y
                                   : operation == 3 ? x / y
                                                    : std::sqrt(x);
    return Nearest(result);
  }

  double m_x;
};

TEST(FloatingPoint, ArithmeticThatIgnoresTheRoundingModeIsFound)
{
  EXPECT_EQ(floating_point_defect<Nearest>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  Certificate certificate;
  certificate.verdict = Certificate_verdict::NO_DIRECTED_ROUNDING;
  EXPECT_FALSE(certificate.is_certified());
  EXPECT_EQ(text_of(certificate).find("not_certified: floating-point operations do not round"), 0u);
}

// One operation of the intervals is wrong by more than it may be, or not rounded in one direction.
template <int operation>
class One_wrong : public CGAL::Interval_nt<false>
{
  typedef CGAL::Interval_nt<false> Base;

public:
  One_wrong(double x) : Base(x) {}

  friend One_wrong operator+(const One_wrong& a, const One_wrong& b) { return One_wrong(a.base() + b.base(), 0); }
  friend One_wrong operator-(const One_wrong& a, const One_wrong& b) { return One_wrong(a.base() - b.base(), 1); }
  friend One_wrong operator*(const One_wrong& a, const One_wrong& b) { return One_wrong(a.base() * b.base(), 2); }
  friend One_wrong operator/(const One_wrong& a, const One_wrong& b) { return One_wrong(a.base() / b.base(), 3); }
  friend One_wrong square(const One_wrong& a) { return One_wrong(CGAL::square(a.base()), 4); }
  friend One_wrong sqrt(const One_wrong& a) { return One_wrong(CGAL::sqrt(a.base()), 5); }

private:
  One_wrong(const Base& x, int o) : Base(o == operation ? Base(x.sup()) : x) {}

  const Base& base() const { return *this; }
};

TEST(FloatingPoint, EachOperationIsTried)
{
  EXPECT_EQ(floating_point_defect<One_wrong<-1>>(), Certificate_verdict::NOT_COMPUTED);
  EXPECT_EQ(floating_point_defect<One_wrong<0>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  EXPECT_EQ(floating_point_defect<One_wrong<1>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  EXPECT_EQ(floating_point_defect<One_wrong<2>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  EXPECT_EQ(floating_point_defect<One_wrong<3>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  EXPECT_EQ(floating_point_defect<One_wrong<4>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
  EXPECT_EQ(floating_point_defect<One_wrong<5>>(), Certificate_verdict::NO_DIRECTED_ROUNDING);
}

#ifdef HAS_MXCSR

const unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
const std::vector<unsigned> flags = {flush_to_zero, denormals_are_zero, flush_to_zero | denormals_are_zero};

// Runs a function in a thread of its own that has set these flags, as a library does that was linked with -Ofast.
template <class Function>
auto with_flags(unsigned flags, const Function& function)
{
  return std::async(std::launch::async, [flags, function] {
    _mm_setcsr(_mm_getcsr() | flags);
    return function();
  });
}

TEST(FloatingPoint, WhereSubnormalsAreFlushedNothingIsCertifiedAndOtherThreadsDoNotMind)
{
  const Waist waist;
  for(unsigned flag : flags)
  {
    auto flushed = with_flags(flag, [&] { return waist.certify(); });
    auto other = std::async(std::launch::async, [&] { return waist.certify(); });
    const Certificate refused = flushed.get();
    EXPECT_EQ(refused.verdict, Certificate_verdict::SUBNORMALS_FLUSHED) << flag;
    EXPECT_EQ(text_of(refused).find("not_certified: floating-point operations take subnormal numbers for zero"), 0u);
    EXPECT_EQ(refused.signs.interval, 0u);
    EXPECT_EQ(other.get().verdict, Certificate_verdict::STRICT_CONSTRICTION);
    EXPECT_EQ(waist.certify().verdict, Certificate_verdict::STRICT_CONSTRICTION);
  }
}

TEST(FloatingPoint, WhatIsFoundWhereSubnormalsAreFlushedIsReturnedWithTheReason)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.01, 1));
  const std::size_t expected = detection::detect(mesh).size();
  ASSERT_GE(expected, 1u);
  const auto found = with_flags(flush_to_zero | denormals_are_zero, [&] { return detection::detect(mesh); }).get();
  EXPECT_EQ(found.size(), expected);
  for(const Constriction<Mesh>& c : found)
  {
    EXPECT_EQ(c.certificate().verdict, Certificate_verdict::SUBNORMALS_FLUSHED);
    EXPECT_TRUE(certify_constriction(mesh, c).is_certified()) << "this thread has other arithmetic";
  }
  const auto only = [&] { return detection::detect(mesh, CGAL::parameters::certified_only(true)); };
  EXPECT_TRUE(with_flags(denormals_are_zero, only).get().empty());
}

TEST(FloatingPoint, ALoopThatIsTightenedWhereSubnormalsAreFlushedIsNotCertified)
{
  const Waist waist;
  std::vector<Mesh::Vertex_index> loop;
  for(const Constriction<Mesh>::Location& l : waist.curve.locations())
    loop.push_back(l.vertex);
  const auto tighten = [&] { return tighten_closed_curve(waist.mesh, loop); };
  const Tightened_curve<Mesh> refused = with_flags(flush_to_zero, tighten).get(), good = tighten();
  EXPECT_EQ(refused.verdict, Tightening_verdict::NOT_CERTIFIED);
  EXPECT_EQ(refused.certificate.verdict, Certificate_verdict::SUBNORMALS_FLUSHED);
  EXPECT_EQ(good.verdict, Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_EQ(good.certificate.verdict, Certificate_verdict::STRICT_CONSTRICTION);
}

#endif

} // namespace test_floating_point
