// SPDX-License-Identifier: GPL-3.0-or-later
// Where straight lines meet the edges that they cross, compared with what is known by construction, and with 300
// digits.
#include "include/random_loops.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Double_double.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace test_accurate_trace {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Index;
using SMC::null_index;
using SMC::internal::Arc;
using SMC::internal::Double_double;
using SMC::internal::Trace_point;
using test_meshes::Mesh;

typedef boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>, boost::multiprecision::et_off> Number;

TEST(AccurateTrace, DoubleDoublesHaveAHundredBits)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  const auto draw = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  for(int i = 0; i < 20000; ++i)
  {
    const double p = draw(), q = draw(), r = draw(), s = draw();
    const Double_double a = Double_double::difference(p, q), b = Double_double::difference(r, s);
    const Number x = Number(p) - Number(q), y = Number(r) - Number(s);
    const auto error = [](const Double_double& computed, const Number& exact) {
      const double high = static_cast<double>(computed), low = static_cast<double>(computed - Double_double(high));
      return static_cast<double>(abs(Number(high) + Number(low) - exact));
    };
    const double bound = std::ldexp(1.0, -100);
    const Number sum = x + y, difference = x - y, product = x * y, quotient = x / y, root = sqrt(abs(x));
    EXPECT_EQ(error(a, x), 0);
    EXPECT_LE(error(a + b, sum), bound * static_cast<double>(abs(sum)));
    EXPECT_LE(error(a - b, difference), bound * static_cast<double>(abs(difference)));
    EXPECT_LE(error(a * b, product), bound * static_cast<double>(abs(product)));
    EXPECT_LE(error(a / b, quotient), bound * static_cast<double>(abs(quotient)));
    EXPECT_LE(error(sqrt(x < 0 ? -a : a), root), bound * static_cast<double>(root));
  }
}

// A band of triangles in the plane z = 0 around the x axis, closed below by a cone, and the arc that runs along the
// axis. Edges join (i, below[i]) to (i + 1, above[i]) and that to (i + 1, below[i + 1]), so that with small heights
// they are nearly parallel to the axis, every second one.
struct Band
{
  test_meshes::Soup soup;
  std::vector<double> parameters; // of the crossings, from right to left

  Band(std::size_t n, const std::vector<double>& below, const std::vector<double>& above, double stretch)
  {
    soup.points.push_back({{0, 0, 0}});
    for(std::size_t i = 0; i < n; ++i)
    {
      const double x = stretch * static_cast<double>(i + 1);
      soup.points.push_back({{x, -below[i], 0}});
      soup.points.push_back({{x + stretch / 2, above[i], 0}});
    }
    soup.points.push_back({{stretch * static_cast<double>(n + 2), 0, 0}});
    soup.points.push_back({{stretch * static_cast<double>(n) / 2, 0, -1}});
    const std::size_t end = 2 * n + 1, apex = end + 1;
    soup.faces.push_back({{0, 1, 2}});
    for(std::size_t v = 1; v + 2 < end; ++v)
      soup.faces.push_back(v % 2 == 1 ? test_meshes::Triangle{{v, v + 2, v + 1}}
                                      : test_meshes::Triangle{{v, v + 1, v + 2}});
    soup.faces.push_back({{end - 2, end, end - 1}});
    const auto close = [&](std::size_t from, std::size_t to) { soup.faces.push_back({{to, from, apex}}); };
    close(0, 1);
    for(std::size_t v = 1; v + 2 < end; v += 2)
      close(v, v + 2);
    close(end - 2, end);
    close(end, end - 1);
    for(std::size_t v = end - 1; v > 2; v -= 2)
      close(v, v - 2);
    close(2, 0);
    for(std::size_t v = 1; v + 1 < end; ++v)
    {
      const Number right = -Number(soup.points[v + (v % 2 == 0)][1]), left = soup.points[v + (v % 2 == 1)][1];
      parameters.push_back(static_cast<double>(Number(right / (right + left))));
    }
  }

  Arc arc(const SMC::Progressive_mesh& pm) const
  {
    Arc result;
    result.from = 0;
    result.to = static_cast<Index>(soup.points.size() - 2);
    for(std::size_t v = 1; v + 2 < soup.points.size() - 1; ++v)
    {
      const std::size_t right = v + (v % 2 == 0), left = v + (v % 2 == 1);
      result.crossings.push_back(pm.halfedge(static_cast<Index>(right), static_cast<Index>(left)));
    }
    SMC::internal::measure(pm, result);
    return result;
  }
};

double greatest_difference(const std::vector<Trace_point>& trace, const std::vector<double>& parameters)
{
  double result = 0;
  for(std::size_t i = 0; i < parameters.size(); ++i)
    result = (std::max)(result, std::abs(trace[i + 1].parameter - parameters[i]));
  return result;
}

TEST(AccurateTrace, EdgesNearlyParallelToTheLine)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.01, 1);
  double worst_in_doubles = 0;
  for(std::size_t n : {1u, 2u, 9u, 60u})
    for(double height : {1., 1e-6, 1e-10, 1e-14, 1e-20, 1e-40})
      for(double stretch : {1., 0.37, 4096.})
      {
        SCOPED_TRACE(std::to_string(n) + " " + std::to_string(std::log10(height)));
        std::vector<double> below, above;
        for(std::size_t i = 0; i < n; ++i)
        {
          below.push_back(height * uniform(random));
          above.push_back(height * uniform(random));
        }
        below[0] = above[0] = stretch; // so that what is unfolded first is not parallel to the axis
        const Band band(n, below, above, stretch);
        const SMC::Progressive_mesh pm = test_meshes::make_progressive(band.soup);
        const Arc arc = band.arc(pm);
        const std::vector<Trace_point> accurate = SMC::internal::accurate_trace(pm, {arc});
        ASSERT_EQ(accurate.size(), band.parameters.size() + 1);
        EXPECT_LE(greatest_difference(accurate, band.parameters), 4e-16);
        worst_in_doubles =
            (std::max)(worst_in_doubles, greatest_difference(SMC::internal::trace(pm, {arc}), band.parameters));
      }
  EXPECT_GT(worst_in_doubles, 0.01); // or the test would be too easy
}

// The edges reach far beyond the arc on both sides.
TEST(AccurateTrace, LengthsOfArcsThatCrossFarLongerEdges)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0.01, 1);
  double worst_in_doubles = 0;
  for(std::size_t n : {2u, 9u, 60u})
    for(double height : {1., 1e6, 1e12})
    {
      std::vector<double> below, above;
      for(std::size_t i = 0; i < n; ++i)
      {
        below.push_back(height * uniform(random));
        above.push_back(height * uniform(random));
      }
      const Band band(n, below, above, 1);
      const SMC::Progressive_mesh pm = test_meshes::make_progressive(band.soup);
      const Arc arc = band.arc(pm);
      const double length = static_cast<double>(n + 2);
      EXPECT_NEAR(SMC::internal::accurate_length(pm, arc), length, 1e-15 * length);
      worst_in_doubles = (std::max)(worst_in_doubles, std::abs(arc.length / length - 1));
    }
  EXPECT_GT(worst_in_doubles, 1e-9); // or the test would be too easy
}

// Numbers of 106 bits do not do for these: what is returned is computed with more, and the bound of the error knows it.
TEST(AccurateTrace, TheBoundOfTheErrorAsksForMoreDigits)
{
  std::vector<double> heights(40, 1e-40);
  heights[0] = 1;
  const Band band(40, heights, heights, 1);
  const SMC::Progressive_mesh pm = test_meshes::make_progressive(band.soup);
  const auto in_double_doubles =
      SMC::internal::accurate_parameters<SMC::internal::Double_double_precision>(pm, band.arc(pm));
  const auto in_many_digits = SMC::internal::accurate_parameters<SMC::internal::Multiprecision>(pm, band.arc(pm));
  EXPECT_FALSE(in_double_doubles.are_accurate);
  EXPECT_TRUE(in_many_digits.are_accurate);
  for(std::size_t i = 0; i < band.parameters.size(); ++i)
    EXPECT_NEAR(in_many_digits.values[i], band.parameters[i], 2e-16);
}

// A point of the plane, and the apex of a triangle over an edge of it that is unfolded to p q, to the left of p q, from
// the lengths of the sides: with nothing in common with what is tested.
typedef std::array<Number, 2> Plane_point;

Number squared_distance(const Mesh::Point& p, const Mesh::Point& q)
{
  const Number x = Number(p.x()) - Number(q.x()), y = Number(p.y()) - Number(q.y()), z = Number(p.z()) - Number(q.z());
  return x * x + y * y + z * z;
}

Plane_point apex_over(const Plane_point& p, const Plane_point& q, const Mesh::Point& a, const Mesh::Point& b,
                      const Mesh::Point& c)
{
  const Number ab = squared_distance(a, b), ac = squared_distance(a, c), bc = squared_distance(b, c);
  const Number along = (ab + ac - bc) / (2 * ab), height = sqrt(ac / ab - along * along);
  const Number x = q[0] - p[0], y = q[1] - p[1];
  return {{p[0] + along * x - height * y, p[1] + along * y + height * x}};
}

// Of all points of an arc: the greatest distance from the line in the unfolding, compared to the length of the curve,
// and the greatest error of a parameter.
struct Deviation
{
  double distance = 0, parameter = 0;
};

// Location `first` is a pivot that is followed by a crossing.
Deviation deviation(const Mesh& mesh, const SMC::Constriction<Mesh>& curve, std::size_t first)
{
  const auto& locations = curve.locations();
  const auto at = [&](std::size_t i) -> const auto& { return locations[i % locations.size()]; };
  struct Crossing
  {
    Plane_point left, right;
    double parameter;
  };
  std::vector<Crossing> crossings;
  Mesh::Halfedge_index h = at(first + 1).halfedge;
  const Mesh::Point& start = mesh.point(at(first).vertex);
  Plane_point right = {{sqrt(squared_distance(start, mesh.point(mesh.source(h)))), 0}};
  Plane_point left = apex_over({{0, 0}}, right, start, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  Plane_point end;
  for(std::size_t i = first + 1;; ++i)
  {
    h = at(i).halfedge;
    crossings.push_back({left, right, at(i).parameter});
    const Mesh::Halfedge_index o = mesh.opposite(h);
    end = apex_over(left, right, mesh.point(mesh.source(o)), mesh.point(mesh.target(o)),
                    mesh.point(mesh.target(mesh.next(o))));
    if(at(i + 1).is_pivot)
      break;
    (at(i + 1).halfedge == mesh.next(o) ? left : right) = end;
  }
  const Number length = sqrt(end[0] * end[0] + end[1] * end[1]);
  Deviation result;
  for(const Crossing& c : crossings)
  {
    const auto distance = [&](const Plane_point& p) { return Number((end[0] * p[1] - end[1] * p[0]) / length); };
    const Number to_right = distance(c.right), width = distance(c.left) - to_right;
    result.distance = (std::max)(
        result.distance, static_cast<double>(Number(abs(to_right + Number(c.parameter) * width) / curve.length())));
    result.parameter =
        (std::max)(result.parameter, static_cast<double>(Number(abs(Number(c.parameter) + to_right / width))));
  }
  return result;
}

Deviation deviation(const Mesh& mesh, const std::vector<SMC::Constriction<Mesh>>& curves)
{
  Deviation result;
  for(const SMC::Constriction<Mesh>& c : curves)
    for(std::size_t i = 0; i < c.locations().size(); ++i)
      if(c.locations()[i].is_pivot && !c.locations()[(i + 1) % c.locations().size()].is_pivot)
      {
        const Deviation d = deviation(mesh, c, i);
        result.distance = (std::max)(result.distance, d.distance);
        result.parameter = (std::max)(result.parameter, d.parameter);
      }
  return result;
}

// Certified curves on real meshes, as they are and stretched along an axis, which makes needles of their faces.
TEST(AccurateTrace, CurvesOnRealMeshesAreStraight)
{
  for(const char* name : {"cow.off", "cactus.off", "eight.off", "elephant.off"})
    for(double stretch : {1., 1e3, 1e4})
    {
      SCOPED_TRACE(name + std::string(" ") + std::to_string(stretch));
      Mesh mesh = real_meshes::read(name);
      for(Mesh::Vertex_index v : mesh.vertices())
      {
        Mesh::Point& p = mesh.point(v);
        p = Mesh::Point(stretch * p.x(), p.y(), p.z());
      }
      std::mt19937 random(7);
      std::vector<random_loops::Loop<Mesh>> loops;
      for(int i = 0; i < 24; ++i)
        loops.push_back(random_loops::random_loop(mesh, random));
      std::vector<SMC::Tightened_curve<Mesh>> tightened;
      SMC::tighten_closed_curves(mesh, loops, std::back_inserter(tightened));
      std::vector<SMC::Constriction<Mesh>> curves;
      for(const auto& t : tightened)
        if(t.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC && t.curve.certificate().is_certified())
          curves.push_back(t.curve);
      EXPECT_FALSE(curves.empty());
      const Deviation d = deviation(mesh, curves);
      EXPECT_LE(d.distance, 1e-12);
      EXPECT_LE(d.parameter, 4e-16);
    }
}

} // namespace test_accurate_trace
