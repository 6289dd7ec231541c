// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of certificates on random surfaces and random curves.
#include "include/detect.h"
#include "include/exact_models.h"
#include "include/random_hull.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_simplicity.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/exact_arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_certificate_properties {

using namespace CGAL::Surface_mesh_constrictions;
using detection::detect;
using detection::detect_all;
using exact_models::Position;
using exact_models::Soup;
using test_meshes::Mesh;

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Exact_mesh;
typedef internal::Graph_surface<Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>> Surface;
typedef internal::Exact_arc<Surface> Arc;

Constriction<Mesh> curve_of_arcs(const std::vector<Arc>& arcs)
{
  Constriction<Mesh>::Data data;
  for(const Arc& a : arcs)
  {
    data.locations.push_back({true, a.from, Mesh::Halfedge_index(), 0});
    for(Mesh::Halfedge_index h : a.crossings)
      data.locations.push_back({false, Mesh::Vertex_index(), h, 0.5});
  }
  return Constriction<Mesh>(data);
}

// The curve led past one of its pivots on the given side instead of through it.
Constriction<Mesh> led_past_pivot(const Mesh& mesh, const Constriction<Mesh>& curve, std::size_t pivot, Curve_side side)
{
  const Surface surface(mesh, mesh.points());
  internal::Sign_prover<Surface> prover(surface);
  std::vector<Arc> arcs = internal::exact_arcs_of_locations(prover, curve.locations()).arcs;
  std::rotate(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(pivot), arcs.end());
  Arc joined = arcs.back();
  internal::append_fan(surface, arcs.back(), arcs.front(), side, true, joined.crossings);
  joined.crossings.insert(joined.crossings.end(), arcs.front().crossings.begin(), arcs.front().crossings.end());
  joined.to = arcs.front().to;
  std::vector<Arc> result(arcs.begin() + 1, arcs.end() - 1);
  result.push_back(joined);
  return curve_of_arcs(result);
}

TEST(CertificateProperties, CurvesOneCombinatorialStepAsideAreRefused)
{
  std::size_t refused = 0;
  for(unsigned seed = 1; seed <= 4; ++seed)
    for(const Soup& soup :
        {test_meshes::torus(0.1, seed), test_meshes::dumbbell(0.05, seed), test_meshes::boxes_with_tube(2)})
    {
      const Mesh mesh = test_meshes::make_mesh(soup);
      for(const auto& c : detect_all(mesh))
      {
        ASSERT_TRUE(certify_constriction(mesh, c).is_certified());
        if(c.pivots().size() < 3)
          continue;
        for(std::size_t p = 0; p < c.pivots().size(); ++p)
          for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
          {
            const Certificate certificate = certify_constriction(mesh, led_past_pivot(mesh, c, p, side));
            EXPECT_FALSE(certificate.is_certified()) << certificate;
            ++refused;
          }
      }
    }
  EXPECT_GT(refused, 200u);
}

// 10,000 loops around a square tube, each with a side angle that differs from pi by 1e-15 or so: too small, and the
// loop is refused; or too great, and it is strict.
TEST(CertificateProperties, NearTiesOf1e14AreNeverMistaken)
{
  std::mt19937 random(17);
  const Soup soup = test_meshes::boxes_with_tube(3);
  std::size_t refused = 0, accepted = 0;
  for(int round = 0; round < 10000; ++round)
  {
    // stretched along the axes by small integers, moved by integers, scaled by a power of two
    std::uniform_int_distribution<int> integer(1, 9), shift(-20, 20), exponent(-30, 30);
    const int stretch[3] = {integer(random), integer(random), integer(random)},
              offset[3] = {shift(random), shift(random), shift(random)};
    const double scale = std::ldexp(1., exponent(random));
    Soup moved = soup;
    for(Position& p : moved.points)
      for(int i = 0; i < 3; ++i)
        p[i] = scale * (stretch[i] * p[i] + offset[i]);

    // a corner of the tube's second ring is moved across the tube by some units in the last place
    const double y = random() % 2 + 1, z = random() % 2 + 1;
    const std::size_t corner = exact_models::vertices_at(soup, {{{3, y, z}}})[0];
    const int axis = 1 + static_cast<int>(random() % 2);
    const bool inward = random() % 2 == 0;
    const bool is_low = (axis == 1 ? y : z) == 1;
    for(int ulps = 1 + static_cast<int>(random() % 4); ulps > 0; --ulps)
      moved.points[corner][axis] = std::nextafter(moved.points[corner][axis], inward == is_low ? 1e300 : -1e300);

    const Mesh mesh = test_meshes::make_mesh(moved);
    const auto curve = exact_models::curve_of_loop(
        mesh, exact_models::vertices_at(soup, {{{2, 1, 1}}, {{2, 2, 1}}, {{2, 2, 2}}, {{2, 1, 2}}}));
    const Certificate c = certify_constriction(mesh, curve);
    ASSERT_EQ(c.verdict, inward ? Certificate_verdict::ANGLE_BELOW_PI : Certificate_verdict::STRICT_CONSTRICTION) << c;
    (inward ? refused : accepted) += 1;
  }
  EXPECT_GT(refused, 4500u);
  EXPECT_GT(accepted, 4500u);
}

TEST(CertificateProperties, RotationScalingAndRelabellingChangeNoVerdict)
{
  std::mt19937 random(23);
  struct Case
  {
    Soup soup;
    std::vector<Position> loop;
    Certificate_verdict verdict;
  };
  const auto p5 = exact_models::polygon(5);
  const std::vector<Case> cases = {
      {test_meshes::boxes_with_tube(2),
       {{{2, 1, 1}}, {{2, 2, 1}}, {{2, 2, 2}}, {{2, 1, 2}}},
       Certificate_verdict::CONSTRICTION},
      {exact_models::waist(2), exact_models::ring(exact_models::square(), 2, 5),
       Certificate_verdict::STRICT_CONSTRICTION},
      {exact_models::twisted_cylinder(),
       {{{2, 0, 0}}, {{0, 2, 0}}, {{-2, 0, 0}}, {{0, -2, 0}}},
       Certificate_verdict::STRICT_CONSTRICTION},
      {exact_models::prism_chain(5, 400), exact_models::ring(p5, 1, 900), Certificate_verdict::CONSTRICTION},
      {exact_models::tube(
           {exact_models::ring(p5, 1, 0), exact_models::ring(p5, 1, 200), exact_models::ring(p5, 1, 500)}),
       exact_models::ring(p5, 1, 200), Certificate_verdict::LEAKY_BAND}};
  for(const Case& c : cases)
    for(unsigned round = 0; round < 10; ++round)
    {
      const Soup soup = test_meshes::relabelled(c.soup, round);
      Exact_mesh mesh = test_meshes::make_graph<Exact_mesh>(soup);
      exact_models::rotate(mesh, random, std::ldexp(1., static_cast<int>(random() % 100) - 50));
      std::vector<std::size_t> loop = exact_models::vertices_at(soup, c.loop);
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()), loop.end());
      if(random() % 2 == 0)
        std::reverse(loop.begin(), loop.end());
      const Certificate certificate = certify_constriction(mesh, exact_models::curve_of_loop(mesh, loop));
      EXPECT_EQ(certificate.verdict, c.verdict) << certificate;
      EXPECT_EQ(certificate.signs.unproved, 0u);
    }
}

TEST(CertificateProperties, NothingIsCertifiedOnConvexPolyhedra)
{
  std::vector<Soup> convex = {test_meshes::box(1, 1, 1), test_meshes::box(3, 2, 1), test_meshes::tetrahedron()};
  for(int n = 3; n <= 12; ++n)
    convex.push_back(exact_models::tube(
        {exact_models::ring(exact_models::polygon(n), 1, 0), exact_models::ring(exact_models::polygon(n), 1, 700)}));
  for(unsigned seed = 0; seed < 100; ++seed)
    convex.push_back(test_meshes::random_hull(seed, 30));
  std::mt19937 random(7);
  for(const Soup& soup : convex)
  {
    const Mesh mesh = test_meshes::make_mesh(soup);
    for(Seed_detection when : {Seed_detection::ON_APPEARANCE, Seed_detection::ON_REFUSED_COLLAPSE})
      EXPECT_TRUE(detect(mesh, parameters::seed_detection(when, parameters::all_constrictions(true))).empty());
    // random walks that close
    for(int walk = 0; walk < 20; ++walk)
    {
      std::vector<std::size_t> path = {random() % mesh.number_of_vertices()};
      while(path.size() < 40)
      {
        const Mesh::Vertex_index v(static_cast<Mesh::size_type>(path.back()));
        std::vector<std::size_t> around;
        for(Mesh::Vertex_index w : vertices_around_target(mesh.halfedge(v), mesh))
          around.push_back(w.idx());
        path.push_back(around[random() % around.size()]);
        if(path.size() > 3 && path.back() == path.front())
          break;
      }
      if(path.back() != path.front())
        continue;
      path.pop_back();
      EXPECT_FALSE(certify_constriction(mesh, exact_models::curve_of_loop(mesh, path)).is_certified());
    }
  }
}

// The straight arc between two grid points of the side z = 1 of box(n, n, 1), with no grid point between them.
Arc arc_on_grid(const Mesh& mesh, const Position& from, const Position& to)
{
  Arc arc;
  for(Mesh::Vertex_index v : vertices(mesh))
  {
    if(mesh.point(v) == Mesh::Point(from[0], from[1], from[2]))
      arc.from = v;
    if(mesh.point(v) == Mesh::Point(to[0], to[1], to[2]))
      arc.to = v;
  }
  arc.along = mesh.halfedge(arc.from, arc.to);
  if(arc.along.is_valid())
    return arc;
  const auto side = [&](Mesh::Vertex_index v) {
    return (to[0] - from[0]) * (mesh.point(v).y() - from[1]) - (to[1] - from[1]) * (mesh.point(v).x() - from[0]);
  };
  const auto is_crossed = [&](Mesh::Halfedge_index h) { return side(mesh.target(h)) > 0 && side(mesh.source(h)) < 0; };
  Mesh::Halfedge_index h;
  for(Mesh::Halfedge_index out : halfedges_around_source(arc.from, mesh))
  {
    const Mesh::Halfedge_index beyond = mesh.next(out);
    const auto p = mesh.point(mesh.source(beyond)), q = mesh.point(mesh.target(beyond));
    const bool is_ahead =
        ((p.x() + q.x()) / 2 - from[0]) * (to[0] - from[0]) + ((p.y() + q.y()) / 2 - from[1]) * (to[1] - from[1]) > 0;
    if(p.z() == 1 && q.z() == 1 && is_crossed(beyond) && is_ahead)
      h = beyond;
  }
  EXPECT_EQ(std::gcd(std::lround(to[0] - from[0]), std::lround(to[1] - from[1])), 1);
  while(arc.crossings.size() < 100)
  {
    arc.crossings.push_back(h);
    const Mesh::Halfedge_index o = mesh.opposite(h);
    if(mesh.target(mesh.next(o)) == arc.to)
      return arc;
    h = is_crossed(mesh.next(o)) ? mesh.next(o) : mesh.prev(o);
  }
  ADD_FAILURE() << "the line does not end";
  return arc;
}

// The verdict on a closed polygon of straight lines on a plane grid.
Certificate_verdict meeting_of_polygon(const std::vector<std::array<int, 2>>& corners)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(12, 12, 1));
  std::vector<Arc> arcs;
  std::size_t location = 0;
  for(std::size_t i = 0; i < corners.size(); ++i)
  {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    arcs.push_back(arc_on_grid(mesh, {{double(p[0]), double(p[1]), 1}}, {{double(q[0]), double(q[1]), 1}}));
    arcs.back().location = location;
    location += 1 + arcs.back().crossings.size();
  }
  const Surface surface(mesh, mesh.points());
  internal::Sign_prover<Surface> prover(surface);
  return internal::Exact_simplicity<Surface>(prover, arcs).find().verdict;
}

TEST(ExactSimplicity, TellsSimpleCrossingAndTouchingPolygonsApart)
{
  EXPECT_EQ(meeting_of_polygon({{{1, 1}}, {{10, 2}}, {{9, 11}}, {{2, 9}}}), Certificate_verdict::NOT_COMPUTED);
  EXPECT_EQ(meeting_of_polygon({{{1, 1}}, {{10, 2}}, {{2, 9}}, {{9, 10}}}), Certificate_verdict::CROSSES_ITSELF);
  // two triangles with a common corner: the curve passes it from south-west to east and from north-east to north-west;
  // from west to east and from south-west to north-west; from north-east to east and from north to west
  EXPECT_EQ(meeting_of_polygon({{{5, 5}}, {{10, 4}}, {{11, 10}}, {{5, 5}}, {{1, 8}}, {{2, 3}}}),
            Certificate_verdict::TOUCHES_ITSELF);
  EXPECT_EQ(meeting_of_polygon({{{5, 5}}, {{10, 4}}, {{1, 2}}, {{5, 5}}, {{2, 10}}, {{1, 6}}}),
            Certificate_verdict::CROSSES_ITSELF);
  EXPECT_EQ(meeting_of_polygon({{{5, 5}}, {{10, 4}}, {{3, 10}}, {{5, 5}}, {{1, 6}}, {{8, 9}}}),
            Certificate_verdict::TOUCHES_ITSELF);
}

TEST(ExactSimplicity, AtACommonCornerDirectionsInOneFaceAreOrdered)
{
  // both strands come to (5, 5) from the east through the same face, the second one below the first; the first goes on
  // to the west, the second to the north or to the south
  EXPECT_EQ(meeting_of_polygon({{{1, 6}}, {{5, 5}}, {{10, 4}}, {{10, 3}}, {{5, 5}}, {{4, 11}}}),
            Certificate_verdict::CROSSES_ITSELF);
  EXPECT_EQ(meeting_of_polygon({{{1, 6}}, {{5, 5}}, {{10, 4}}, {{10, 3}}, {{5, 5}}, {{4, 2}}}),
            Certificate_verdict::TOUCHES_ITSELF);
}

TEST(ExactSimplicity, LinesThatCrossOnAnEdgeCross)
{
  // at (5.5, 5)
  EXPECT_EQ(meeting_of_polygon({{{5, 4}}, {{6, 6}}, {{10, 7}}, {{6, 4}}, {{5, 6}}, {{1, 5}}}),
            Certificate_verdict::CROSSES_ITSELF);
}

TEST(ExactSimplicity, AnEdgeThatIsRunAlongAndCrossedIsACrossing)
{
  // the edge from (5, 5) to (6, 5) lies across the line from (7, 8) to (5, 3)
  EXPECT_EQ(meeting_of_polygon({{{5, 5}}, {{6, 5}}, {{10, 10}}, {{7, 8}}, {{5, 3}}, {{1, 4}}}),
            Certificate_verdict::CROSSES_ITSELF);
}

TEST(ExactSimplicity, NarrowlyParallelLinesAreSortedOnEveryEdge)
{
  // a thin triangle of slope close to 1/9 has its long sides in the same faces
  EXPECT_EQ(meeting_of_polygon({{{1, 1}}, {{10, 2}}, {{11, 2}}}), Certificate_verdict::NOT_COMPUTED);
  EXPECT_EQ(meeting_of_polygon({{{1, 1}}, {{12, 2}}, {{1, 4}}, {{12, 1}}, {{11, 8}}}),
            Certificate_verdict::CROSSES_ITSELF);
}

// Two lines that meet, taken past their common point on the outer side: what lies between the line from end to end and
// the strip is that point, on the inner side.
TEST(Certifier, AnArcThatIsNotStraightNamesTheCornerThatItMisses)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(12, 12, 1));
  const Surface surface(mesh, mesh.points());
  internal::Certifier<Surface> certifier(surface);
  struct Case
  {
    std::array<double, 2> from, corner, to;
    Curve_side outer, missed;
  };
  for(const Case& c : {Case{{{1, 1}}, {{6, 3}}, {{11, 2}}, Curve_side::LEFT, Curve_side::RIGHT},
                       Case{{{1, 5}}, {{6, 3}}, {{11, 4}}, Curve_side::RIGHT, Curve_side::LEFT},
                       Case{{{11, 2}}, {{6, 3}}, {{1, 1}}, Curve_side::RIGHT, Curve_side::LEFT},
                       Case{{{11, 4}}, {{6, 3}}, {{1, 5}}, Curve_side::LEFT, Curve_side::RIGHT}})
  {
    Arc first = arc_on_grid(mesh, {{c.from[0], c.from[1], 1}}, {{c.corner[0], c.corner[1], 1}}),
        second = arc_on_grid(mesh, {{c.corner[0], c.corner[1], 1}}, {{c.to[0], c.to[1], 1}});
    first.location = 0;
    second.location = 1 + first.crossings.size();
    EXPECT_EQ(certifier.examine_arc({first, second}, 0).certificate.verdict, Certificate_verdict::NOT_COMPUTED);
    EXPECT_EQ(certifier.examine_arc({first, second}, 1).certificate.verdict, Certificate_verdict::NOT_COMPUTED);

    Arc joined = first;
    internal::append_fan(surface, first, second, c.outer, true, joined.crossings);
    joined.crossings.insert(joined.crossings.end(), second.crossings.begin(), second.crossings.end());
    joined.to = second.to;
    const Certificate certificate = certifier.examine_arc({joined}, 0).certificate;
    EXPECT_EQ(certificate.verdict, Certificate_verdict::NOT_STRAIGHT);
    ASSERT_GT(certificate.location, 0u);
    ASSERT_LE(certificate.location, joined.crossings.size());
    EXPECT_EQ(certificate.side, c.missed);
    // the corner that is named lies on the wrong side of the line
    const Mesh::Halfedge_index h = joined.crossings[certificate.location - 1];
    const auto v = mesh.point(internal::corner_vertex(surface, h, c.missed));
    const double side = (c.to[0] - c.from[0]) * (v.y() - c.from[1]) - (c.to[1] - c.from[1]) * (v.x() - c.from[0]);
    EXPECT_TRUE(c.missed == Curve_side::LEFT ? side <= 0 : side >= 0) << v;
  }
}

} // namespace test_certificate_properties
