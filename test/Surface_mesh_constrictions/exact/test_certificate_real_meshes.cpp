// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of what is found on real meshes.
#include "include/detect.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Corner_arithmetic.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/exact_arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_certificate_real_meshes {

using namespace CGAL::Surface_mesh_constrictions;
using detection::detect;
using detection::detect_all_in_time;
using real_meshes::read;
using test_meshes::Mesh;

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Exact_mesh;

// The combinatorics of what is found.
template <class AnyMesh>
std::vector<std::vector<std::size_t>> combinatorial_curves(const AnyMesh& mesh)
{
  std::vector<std::vector<std::size_t>> result;
  for(const auto& c : detect_all_in_time(mesh))
  {
    result.emplace_back();
    for(const auto& l : c.locations())
    {
      result.back().push_back(l.is_pivot ? std::size_t(l.vertex) : std::size_t(source(l.halfedge, mesh)));
      result.back().push_back(l.is_pivot ? std::size_t(l.vertex) : std::size_t(target(l.halfedge, mesh)));
    }
  }
  return result;
}

class TwentyMeshes : public ::testing::TestWithParam<const char*>
{};

TEST_P(TwentyMeshes, SameCombinatorialCurvesWithInexactAndExactPoints)
{
  const auto expected = combinatorial_curves(read<Mesh>(GetParam()));
  EXPECT_EQ(combinatorial_curves(read<Exact_mesh>(GetParam())), expected);
}

INSTANTIATE_TEST_SUITE_P(Certificates, TwentyMeshes,
                         ::testing::Values("cactus.off", "eight.off", "elephant.off", "hand.off", "cow.off", "bull.off",
                                           "homer.off", "knot.off", "pipe.off", "joint.off", "anchor.off", "rotor.off",
                                           "pinion.off", "spool.off", "couplingdown.off", "helmet.off", "elk.off",
                                           "triceratops.off", "femur.off", "oblong.off"));

class FoundCurves : public ::testing::TestWithParam<const char*>
{};

// Among these are machine parts with ties, and near ties that floating point gets wrong.
TEST_P(FoundCurves, AreCertifiedAndNoTieIsLeft)
{
  const Mesh mesh = read<Mesh>(GetParam());
  const std::vector<Constriction<Mesh>> found = detect_all_in_time(mesh);
  EXPECT_TRUE(!found.empty() || (sanitizers::are_on && mesh.number_of_faces() > 3000));
  for(const auto& c : found)
  {
    EXPECT_TRUE(c.certificate().is_certified()) << c.certificate();
    const Certificate again = certify_constriction(mesh, c);
    EXPECT_EQ(again.verdict, c.certificate().verdict) << again;
    EXPECT_EQ(again.signs.unproved, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Certificates, FoundCurves,
                         ::testing::Values("cactus.off", "eight.off", "elephant.off", "camel.off", "dino.off",
                                           "knot2.off", "pipe.off", "joint.off", "anchor.off", "turbine.off",
                                           "rotor_small.off", "pinion.off", "spool.off", "couplingdown.off",
                                           "mpi_triang.off"));

TEST(Certificates, ExactArithmeticCorrectsMachineParts)
{
  for(const char* name : {"couplingdown.off", "spool.off", "anchor.off"})
  {
    const Mesh mesh = read<Mesh>(name);
    if(sanitizers::are_on && mesh.number_of_faces() > 3000)
      continue;
    std::size_t refused = 0;
    for(const auto& c : detect(mesh, parameters::certify(false, parameters::all_constrictions(true))))
    {
      EXPECT_EQ(c.certificate().verdict, Certificate_verdict::NOT_COMPUTED);
      refused += !certify_constriction(mesh, c).is_certified();
    }
    EXPECT_GT(refused, 0u) << name;
  }
}

typedef CGAL::Interval_nt<false> Interval;
typedef internal::Graph_surface<Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>> Surface;

const Interval pi(CGAL_PI, std::nextafter(CGAL_PI, 4.)); // the double nearest to pi is less than pi

double arc_tangent(double y, double x, mpfr_rnd_t rounding)
{
  internal::Multiprecision_number a(53), b(53), result(53);
  mpfr_set_d(a.get(), y, MPFR_RNDN);
  mpfr_set_d(b.get(), x, MPFR_RNDN);
  mpfr_atan2(result.get(), a.get(), b.get(), rounding);
  return mpfr_get_d(result.get(), rounding);
}

// Bounds of the angle in [0, pi] of a complex number: with y not negative it is monotone in x, and in y.
Interval angle(const internal::Planar<Interval>& z)
{
  double low = 4, high = 0;
  for(double x : {z.x().inf(), z.x().sup()})
    for(double y : {(std::max)(z.y().inf(), 0.), (std::max)(z.y().sup(), 0.)})
    {
      low = (std::min)(low, arc_tangent(y, x, MPFR_RNDD));
      high = (std::max)(high, arc_tangent(y, x, MPFR_RNDU));
    }
  return Interval(low, high);
}

// Bounds of the side angles of a certified curve, added up over its pivots; each goes counterclockwise from one arc
// to the other.
Interval sum_of_side_angles(const Surface& surface, const internal::Interval_arithmetic<Surface>& arithmetic,
                            const std::vector<internal::Exact_arc<Surface>>& arcs, Curve_side side)
{
  Interval sum(0);
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    const auto &incoming = arcs[(i + arcs.size() - 1) % arcs.size()], &outgoing = arcs[i];
    auto first = internal::start_halfedge(surface, outgoing), last = internal::end_halfedge(surface, incoming);
    auto from = internal::start_direction(surface, arithmetic, outgoing),
         to = internal::end_direction(surface, arithmetic, incoming);
    if(side == Curve_side::RIGHT)
    {
      std::swap(first, last);
      std::swap(from, to);
    }
    sum += angle(relative(from, arithmetic.corner(first))) + angle(to);
    for(auto h = internal::ccw(surface, first); h != last; h = internal::ccw(surface, h))
      sum += angle(arithmetic.corner(h));
  }
  return sum;
}

class GenusZero : public ::testing::TestWithParam<const char*>
{};

// The angle defects inside each side of a curve on a sphere, and pi minus the side angles, add up to 2 pi; so the
// defects inside each side add up to at least that. By intervals, from the points and the combinatorial curve.
TEST_P(GenusZero, GaussBonnetHoldsOnBothSides)
{
  const Mesh mesh = read<Mesh>(GetParam());
  const std::vector<Constriction<Mesh>> found = detect_all_in_time(mesh);
  EXPECT_TRUE(!found.empty() || (sanitizers::are_on && mesh.number_of_faces() > 3000));
  const Surface surface(mesh, mesh.points());
  internal::Sign_prover<Surface> prover(surface);
  std::vector<std::vector<internal::Exact_arc<Surface>>> arcs;
  for(const auto& c : found)
    arcs.push_back(internal::exact_arcs_of_locations(prover, c.locations()).arcs);

  Interval::Protector upward;
  const internal::Interval_arithmetic<Surface> arithmetic(surface);
  std::vector<Interval> defect(mesh.number_of_vertices(), 2 * pi);
  for(Mesh::Halfedge_index h : mesh.halfedges())
    defect[mesh.source(h)] -= angle(arithmetic.corner(h));
  for(std::size_t number = 0; number < found.size(); ++number)
  {
    const auto& c = found[number];
    // the vertices that the curve leaves on either side of an edge, and those that can be reached from them
    enum
    {
      UNKNOWN,
      LEFT,
      RIGHT,
      PIVOT
    };
    std::vector<int> side(mesh.number_of_vertices(), UNKNOWN);
    std::map<std::pair<Mesh::size_type, Mesh::size_type>, std::vector<double>> crossings; // parameters, from either end
    std::vector<Mesh::Vertex_index> stack;
    const auto put_on = [&](Mesh::Vertex_index v, int s) {
      if(side[v] == PIVOT)
        return;
      EXPECT_TRUE(side[v] == UNKNOWN || side[v] == s) << "the sides meet";
      if(side[v] == UNKNOWN)
        stack.push_back(v);
      side[v] = s;
    };
    // the side of the end v of the edge from u to v, if this is the side of the edge at a parameter
    const auto side_at_end = [&](Mesh::Vertex_index u, Mesh::Vertex_index v, double parameter, int s) {
      const std::vector<double>& t = crossings[std::make_pair(u.idx(), v.idx())];
      const auto beyond = std::count_if(t.begin(), t.end(), [parameter](double x) { return x > parameter; });
      return beyond % 2 == 1 ? LEFT + RIGHT - s : s;
    };
    for(const auto& p : c.pivots())
      side[p.vertex] = PIVOT;
    for(const auto& l : c.locations())
      if(!l.is_pivot)
      {
        const Mesh::Vertex_index u = mesh.source(l.halfedge), v = mesh.target(l.halfedge);
        crossings[std::make_pair(u.idx(), v.idx())].push_back(l.parameter);
        crossings[std::make_pair(v.idx(), u.idx())].push_back(1 - l.parameter);
      }
    const std::size_t n = c.locations().size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const auto &l = c.locations()[i], &next = c.locations()[(i + 1) % n];
      if(!l.is_pivot)
      {
        const Mesh::Vertex_index u = mesh.source(l.halfedge), v = mesh.target(l.halfedge);
        put_on(v, side_at_end(u, v, l.parameter, LEFT));
        put_on(u, side_at_end(v, u, 1 - l.parameter, RIGHT));
      }
      else if(next.is_pivot)
      {
        const Mesh::Halfedge_index h = mesh.halfedge(l.vertex, next.vertex), o = mesh.opposite(h);
        const Mesh::Vertex_index left = mesh.target(mesh.next(h)), right = mesh.target(mesh.next(o));
        put_on(left, side_at_end(l.vertex, left, 0, LEFT));
        put_on(right, side_at_end(l.vertex, right, 0, RIGHT));
      }
    }
    while(!stack.empty())
    {
      const Mesh::Vertex_index v = stack.back();
      stack.pop_back();
      for(Mesh::Vertex_index w : vertices_around_target(mesh.halfedge(v), mesh))
        put_on(w, side_at_end(v, w, 0, side[v]));
    }
    Interval inside[2] = {0, 0};
    for(Mesh::Vertex_index v : mesh.vertices())
      if(side[v] == LEFT || side[v] == RIGHT)
        inside[side[v] - LEFT] += defect[v];
    for(Curve_side s : {Curve_side::LEFT, Curve_side::RIGHT})
    {
      const Interval defects = inside[s == Curve_side::LEFT ? 0 : 1];
      const Interval turning = pi * Interval(static_cast<double>(arcs[number].size())) -
                               sum_of_side_angles(surface, arithmetic, arcs[number], s);
      const Interval excess = defects + turning - 2 * pi;
      EXPECT_TRUE(excess.inf() <= 0 && 0 <= excess.sup()) << excess;
      EXPECT_LT(excess.sup() - excess.inf(), 1e-7);
      EXPECT_GE((defects - 2 * pi).sup(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Certificates, GenusZero,
                         ::testing::Values("cactus.off", "bull.off", "cow.off", "hand.off", "homer.off", "dino.off",
                                           "triceratops.off", "camel.off"));

} // namespace test_certificate_real_meshes
