// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/enumerate_constrictions.h"
#include "include/geodesic_check.h"
#include "include/open_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_boundary {

namespace SMC = CGAL::Surface_mesh_constrictions;
using enumerate_constrictions::Enumeration;
using test_meshes::Mesh;
using test_meshes::Soup;

typedef SMC::Constriction<Mesh> Constriction;

// What is asked for, all with one type of named parameters: each type is a long compilation.
struct Asked
{
  bool all = false, rims = false;
  SMC::Tightening_schedule schedule = SMC::Tightening_schedule::UNSTRAIGHTENED;
};

auto parameters(const Asked& asked)
{
  return SMC::parameters::all_constrictions(
      asked.all, SMC::parameters::rim_constrictions(asked.rims, SMC::parameters::tightening_schedule(asked.schedule)));
}

std::vector<Constriction> detect(const Mesh& mesh, const Asked& asked = Asked())
{
  return detection::detect(mesh, parameters(asked));
}

std::vector<Constriction> detect_all(const Mesh& mesh) { return detect(mesh, {true}); }
std::vector<Constriction> detect_with_rims(const Mesh& mesh) { return detect(mesh, {false, true}); }

// The certificate of each curve holds on the mesh itself, and two witnesses that share no code with it agree.
void expect_proved(const Mesh& mesh, const std::vector<Constriction>& curves)
{
  for(const Constriction& c : curves)
  {
    EXPECT_TRUE(c.certificate().is_certified());
    EXPECT_EQ(SMC::certify_constriction(mesh, c).verdict, c.certificate().verdict);
    geodesic_check::expect_closed_geodesic(mesh, c);
    EXPECT_TRUE(SMC::verify_with_shortest_paths(mesh, c).is_confirmed());
  }
}

TEST(Boundary, AnOpenTubeIsOneBandAsWideAsTheTube)
{
  for(int n = 3; n <= 9; n += 3)
    for(int length = 1; length <= 3; ++length)
    {
      std::vector<std::array<double, 2>> profile;
      for(int i = 0; i <= length; ++i)
        profile.push_back({{1, static_cast<double>(i)}});
      const Mesh mesh = test_meshes::make_mesh(open_meshes::open_tube(n, profile));
      const std::vector<Constriction> curves = detect_all(mesh);
      ASSERT_EQ(curves.size(), 1u);
      EXPECT_NEAR(curves[0].length(), 2 * n * std::sin(CGAL_PI / n), 1e-12);
      EXPECT_NEAR(curves[0].flat_band_width(), length, 1e-9);
      EXPECT_TRUE(curves[0].is_rim());
      EXPECT_NEAR(curves[0].boundary_share(), 1, 1e-12);
      EXPECT_TRUE(detect(mesh).empty());
      EXPECT_EQ(detect_with_rims(mesh).size(), 1u);
    }
}

// With exact coordinates the tie at each vertex of the band is proved, and so is that it holds at both ends.
TEST(Boundary, ABandThatEndsAtTheBoundaryIsProvedToHold)
{
  const Mesh mesh = test_meshes::make_mesh(open_meshes::square_tube(2, 3));
  const std::vector<Constriction> curves = detect_all(mesh);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].certificate().verdict, SMC::Certificate_verdict::CONSTRICTION);
  EXPECT_NEAR(curves[0].certificate().flat_band_width, 3, 1e-12);
  EXPECT_EQ(curves[0].length(), 8);
  expect_proved(mesh, curves);
}

// Closed at one end it leaks there: a rubber band slips off a box.
TEST(Boundary, ABandThatLeaksAtOneEndIsNone)
{
  const Soup box = test_meshes::box(2, 2, 3);
  const Mesh mesh = test_meshes::make_mesh(open_meshes::without_faces(box, [&box](const test_meshes::Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&box](std::size_t v) { return box.points[v][2] == 3; });
  }));
  EXPECT_TRUE(detect_all(mesh).empty());
}

TEST(Boundary, AConeFrustumHasItsNarrowRimOnly)
{
  for(int n = 3; n <= 12; n += 3)
  {
    const Mesh mesh = test_meshes::make_mesh(open_meshes::open_tube(n, {{{1, 0}}, {{1.5, 1}}, {{2, 2}}}));
    const std::vector<Constriction> curves = detect_all(mesh);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length(), 2 * n * std::sin(CGAL_PI / n), 1e-12);
    EXPECT_TRUE(curves[0].is_rim());
    EXPECT_EQ(curves[0].certificate().verdict, SMC::Certificate_verdict::STRICT_CONSTRICTION);
    EXPECT_EQ(std::min(curves[0].areas()[0], curves[0].areas()[1]), 0);
    EXPECT_EQ(curves[0].isoperimetric_ratio(), std::numeric_limits<double>::infinity());
    for(const Constriction::Pivot& p : curves[0].pivots())
      EXPECT_TRUE(std::isinf(p.left_angle) != std::isinf(p.right_angle));
    EXPECT_TRUE(detect(mesh).empty());
    const std::vector<Constriction> rims = detect_with_rims(mesh);
    ASSERT_EQ(rims.size(), 1u);
    EXPECT_EQ(rims[0].length(), curves[0].length());
    expect_proved(mesh, curves);
  }
}

TEST(Boundary, ADiscHasNone)
{
  for(unsigned seed = 0; seed < 4; ++seed)
  {
    // flat, and with the one face of a triangle
    const Soup cone = test_meshes::sharp_cone();
    EXPECT_TRUE(detect_all(test_meshes::make_mesh(open_meshes::without_star(cone, 13))).empty());
    EXPECT_TRUE(detect_all(test_meshes::make_mesh({{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}}})).empty());
  }
}

// The cyclic sequence of a curve's pivots and crossed edges by their vertices, the same for both directions and every
// start.
typedef std::vector<std::array<std::size_t, 2>> Key;

Key key(const Mesh& mesh, const Constriction& curve)
{
  Key nodes, least;
  for(const Constriction::Location& l : curve.locations())
  {
    const std::size_t u = l.is_pivot ? l.vertex.idx() : mesh.source(l.halfedge).idx();
    const std::size_t v = l.is_pivot ? l.vertex.idx() : mesh.target(l.halfedge).idx();
    nodes.push_back({{std::min(u, v), std::max(u, v)}});
  }
  for(int direction = 0; direction < 2; ++direction)
  {
    for(std::size_t i = 0; i < nodes.size(); ++i)
    {
      std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
      if(least.empty() || nodes < least)
        least = nodes;
    }
    std::reverse(nodes.begin(), nodes.end());
  }
  return least;
}

// The points of each selected curve, too.
std::map<Key, std::set<test_meshes::Position>> selected_curves(const Soup& soup)
{
  const Mesh mesh = test_meshes::make_mesh(soup);
  std::map<Key, std::set<test_meshes::Position>> curves;
  for(const Constriction& c : detect(mesh))
  {
    std::vector<Mesh::Point> points;
    c.points(mesh, std::back_inserter(points));
    for(const Mesh::Point& p : points)
      curves[key(mesh, c)].insert({{p.x(), p.y(), p.z()}});
  }
  return curves;
}

// Necks far from a hole are the same curves as without it, bit for bit: a face, a patch or an end may be missing.
TEST(Boundary, OpenVersionsKeepTheNecks)
{
  const Soup closed = test_meshes::chain_of_necks(0.02, 1);
  const std::map<Key, std::set<test_meshes::Position>> necks = selected_curves(closed);
  ASSERT_EQ(necks.size(), 4u);
  const std::size_t bottom = closed.points.size() - 2, top = bottom + 1;
  for(const Soup& open : {open_meshes::without_face(closed, 10), open_meshes::without_star(closed, 25),
                          open_meshes::without_star(open_meshes::without_star(closed, top), bottom)})
    EXPECT_EQ(selected_curves(open), necks);
}

// A narrow ring of vertices on a circle of radius 1; a vertex of the ring is missing.
TEST(Boundary, AHoleTouchedByANeckBendsItAroundTheHole)
{
  const int n = 12;
  const Soup tube = open_meshes::open_tube(n, {{{2, -1}}, {{1.05, -0.1}}, {{1, 0}}, {{1.05, 0.1}}, {{2, 1}}});
  std::size_t on_ring = 0;
  while(tube.points[on_ring][2] != 0)
    ++on_ring;
  const Mesh mesh = test_meshes::make_mesh(open_meshes::without_star(tube, on_ring));
  const std::vector<Constriction> curves = detect_all(mesh);
  expect_proved(mesh, curves);
  std::size_t bent = 0;
  for(const Constriction& c : curves)
  {
    if(c.is_rim() || c.length() > 1.1 * 2 * n * std::sin(CGAL_PI / n))
      continue;
    // it passes above or below the hole, and touches it from there
    ++bent;
    EXPECT_EQ(c.certificate().verdict, SMC::Certificate_verdict::STRICT_CONSTRICTION);
    EXPECT_GT(c.length(), 2 * n * std::sin(CGAL_PI / n));
    EXPECT_GT(c.boundary_share(), 0);
    std::size_t at_hole = 0;
    for(const Constriction::Pivot& p : c.pivots())
      at_hole += std::isinf(p.left_angle) || std::isinf(p.right_angle);
    EXPECT_GE(at_hole, 2u);
    EXPECT_LT(std::max(c.areas()[0], c.areas()[1]), 2 * std::min(c.areas()[0], c.areas()[1]));
  }
  EXPECT_EQ(bent, 2u);
}

// Small open meshes: all strict constrictions by brute force, and what is detected of them.
class Open_completeness : public testing::Test
{
protected:
  void compare(const std::string& name, const Soup& soup)
  {
    SCOPED_TRACE(name);
    const Mesh mesh = test_meshes::make_mesh(soup);
    const std::vector<Constriction> detected = detect_all(mesh);
    ASSERT_FALSE(detected.empty());
    double length = std::numeric_limits<double>::infinity();
    for(const Constriction& c : detected)
      if(!c.is_rim())
        length = std::min(length, c.length());
    const double max_length = 1.6 * length;
    const Enumeration enumeration(mesh, max_length);
    std::set<Enumeration::Key> known, found;
    for(const Constriction& c : enumeration.constrictions())
      known.insert(Enumeration::key(mesh, c));
    for(const Constriction& c : detected)
      if(c.length() < (1 - 1e-9) * max_length &&
         c.certificate().verdict == SMC::Certificate_verdict::STRICT_CONSTRICTION)
      {
        EXPECT_EQ(known.count(Enumeration::key(mesh, c)), 1u) << "of length " << c.length();
        found.insert(Enumeration::key(mesh, c));
      }
    std::vector<Constriction> enumerated;
    SMC::compute_prominences(mesh, enumeration.constrictions(), std::back_inserter(enumerated));
    std::size_t prominent = 0, missed = 0;
    for(const Constriction& c : enumerated)
      if(c.prominence() >= 0.3 && c.length() <= 1.5 * length)
      {
        ++prominent;
        missed += found.count(Enumeration::key(mesh, c)) == 0;
      }
    EXPECT_EQ(missed, 0u) << "of " << prominent;
    m_prominent += prominent;
    expect_proved(mesh, detected);
  }

  std::size_t m_prominent = 0;
};

TEST_F(Open_completeness, WhatIsDetectedIsKnownAndWhatIsProminentIsDetected)
{
  for(unsigned seed = 0; seed < 3; ++seed)
  {
    const std::string number = std::to_string(seed);
    compare("dumbbell_" + number,
            open_meshes::with_random_holes(test_meshes::dumbbell(0.05, seed, 12, 10), 1 + seed, seed));
    compare("boxes_with_tube_" + number,
            open_meshes::with_random_holes(test_meshes::jittered(test_meshes::boxes_with_tube(3), 0.1, seed), 2, seed));
    compare("square_ring_" + number,
            open_meshes::with_random_holes(test_meshes::jittered(test_meshes::square_ring(), 0.1, seed), 2, seed));
    compare("branches_" + number,
            open_meshes::with_random_holes(test_meshes::jittered(test_meshes::branches(), 0.08, seed), 2, seed));
  }
  EXPECT_GE(m_prominent, 12u);
}

template <class Point>
Point rotated(const test_meshes::Position& p)
{
  // by 3 4 5 in two planes
  const double x = (3 * p[0] - 4 * p[1]) / 5, y = (4 * p[0] + 3 * p[1]) / 5;
  return Point((5 * x - 12 * p[2]) / 13, y, (12 * x + 5 * p[2]) / 13);
}

std::vector<double> sorted_lengths(const Mesh& mesh)
{
  std::vector<double> lengths;
  for(const Constriction& c : detect_with_rims(mesh))
    lengths.push_back(c.length());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(Boundary, NeitherRotationNorNumbersMatter)
{
  const Soup soup = open_meshes::without_star(open_meshes::without_star(test_meshes::dumbbell(0.05, 3), 40), 450);
  const std::vector<double> expected = sorted_lengths(test_meshes::make_mesh(soup));
  ASSERT_FALSE(expected.empty());
  Soup turned = soup;
  for(test_meshes::Position& p : turned.points)
  {
    const auto q = rotated<test_meshes::Kernel::Point_3>(p);
    p = {{q.x(), q.y(), q.z()}};
  }
  for(const Soup& s : {turned, test_meshes::relabelled(soup, 5), test_meshes::inside_out(soup)})
  {
    const std::vector<double> lengths = sorted_lengths(test_meshes::make_mesh(s));
    for(std::size_t i = 0; i < std::min(lengths.size(), expected.size()); ++i)
      EXPECT_NEAR(lengths[i], expected[i], 1e-9 * expected[i]);
    EXPECT_EQ(lengths.size(), expected.size());
  }
}

// Holes are filled where it comes to genera and to separation, and have no area.
TEST(Boundary, HolesCountForNeitherGenusNorArea)
{
  const Soup torus = test_meshes::torus(0.1, 2, 30, 14, 0.5);
  const Mesh mesh = test_meshes::make_mesh(open_meshes::with_random_holes(torus, 3, 4));
  double area = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    area += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                         mesh.point(mesh.target(mesh.next(h)))));
  }
  const std::vector<Constriction> curves = detect_all(mesh);
  ASSERT_FALSE(curves.empty());
  std::size_t separating = 0;
  for(const Constriction& c : curves)
  {
    const std::size_t genera = c.genera()[0] + c.genera()[1];
    EXPECT_EQ(genera, c.is_separating() ? 1u : 0u);
    EXPECT_NEAR(c.areas()[0] + c.areas()[1], c.is_separating() ? area : 2 * area, 1e-9 * area);
    separating += c.is_separating();
  }
  EXPECT_GE(separating, 3u); // the rims
  EXPECT_LT(separating, curves.size());
}

// A waist between two short ends that flare: the surface alone, without what closes the ends, would be too small there.
// Filled by flat pieces the ends say the same as with lids.
TEST(Boundary, AHoleCountsAsFilledInTheIsoperimetricRatio)
{
  const int n = 24;
  const Soup tube = open_meshes::open_tube(n, {{{2, 0}}, {{1, 0.5}}, {{2, 1}}});
  Soup closed = tube;
  std::set<std::array<std::size_t, 2>> sides;
  for(const test_meshes::Triangle& t : tube.faces)
    for(std::size_t i = 0; i < 3; ++i)
      sides.insert({{t[i], t[(i + 1) % 3]}});
  for(double z : {0., 1.})
  {
    const std::size_t middle = closed.points.size();
    closed.points.push_back({{0, 0, z}});
    for(const std::array<std::size_t, 2>& s : sides)
      if(sides.count({{s[1], s[0]}}) == 0 && tube.points[s[0]][2] == z)
        closed.faces.push_back({{s[1], s[0], middle}});
  }
  const std::vector<Constriction> open_curves = detect(test_meshes::make_mesh(tube)),
                                  closed_curves = detect(test_meshes::make_mesh(closed));
  ASSERT_EQ(open_curves.size(), 1u);
  ASSERT_EQ(closed_curves.size(), 1u);
  const Constriction& c = open_curves[0];
  EXPECT_EQ(c.length(), closed_curves[0].length());
  EXPECT_NEAR(c.isoperimetric_ratio(), closed_curves[0].isoperimetric_ratio(), 1e-12);
  const double area = std::min(c.areas()[0], c.areas()[1]), lid = n * 2 * std::sin(2 * CGAL_PI / n),
               length = 2 * n * std::sin(CGAL_PI / n);
  EXPECT_NEAR(std::min(closed_curves[0].areas()[0], closed_curves[0].areas()[1]), area + lid, 1e-12);
  EXPECT_NEAR(c.isoperimetric_ratio(), length * length / (4 * CGAL_PI * (area + lid)), 1e-12);
  EXPECT_GT(length * length / (4 * CGAL_PI * area), SMC::default_maximum_isoperimetric_ratio);
}

// Whatever the holes, the policies, the seeds and the way to carry them: what comes out is proved.
TEST(Boundary, RandomHolesGiveNothingThatIsNotProved)
{
  for(unsigned seed = 0; seed < 12; ++seed)
  {
    const Soup closed = seed % 3 == 0   ? test_meshes::torus(0.2, seed, 16, 8)
                        : seed % 3 == 1 ? test_meshes::jittered(test_meshes::two_holes(), 0.15, seed)
                                        : test_meshes::dumbbell(0.1, seed, 14, 10);
    const Mesh mesh = test_meshes::make_mesh(open_meshes::with_random_holes(closed, 1 + seed % 7, seed));
    for(const SMC::Tightening_schedule schedule :
        {SMC::Tightening_schedule::UNSTRAIGHTENED, SMC::Tightening_schedule::AT_THE_END,
         SMC::Tightening_schedule::EVERY_LEVEL})
      expect_proved(mesh, detect(mesh, {true, false, schedule}));
    expect_proved(mesh, detection::detect(mesh, SMC::parameters::simplification_policies(SMC::Edge_length_policies(),
                                                                                         parameters({true}))));
  }
}

// A loop along the wide end of a frustum slides to the narrow one.
TEST(Boundary, ALoopOfTheUserIsTightenedOntoTheRim)
{
  const int n = 8;
  const Mesh mesh = test_meshes::make_mesh(open_meshes::open_tube(n, {{{1, 0}}, {{1.5, 1}}, {{2, 2}}}));
  std::vector<Mesh::Vertex_index> loop;
  for(Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) && mesh.point(mesh.target(h)).z() == 2)
    {
      for(Mesh::Halfedge_index b : mesh.halfedges_around_face(h))
        loop.push_back(mesh.target(b));
      break;
    }
  ASSERT_EQ(loop.size(), static_cast<std::size_t>(n));
  const auto tightened = SMC::tighten_closed_curve(mesh, loop);
  ASSERT_EQ(tightened.verdict, SMC::Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_TRUE(tightened.curve.is_rim());
  EXPECT_NEAR(tightened.curve.length(), 2 * n * std::sin(CGAL_PI / n), 1e-12);
}

// A small hole near a neck does not make it slide off: the sweep goes on behind the hole.
TEST(Boundary, AHoleBesideANeckLeavesItItsProminence)
{
  const Soup closed = test_meshes::dumbbell(0, 0, 24, 18);
  const std::vector<Constriction> before = detect(test_meshes::make_mesh(closed));
  ASSERT_EQ(before.size(), 1u);
  for(std::size_t ring : {14, 15, 17})
  {
    const std::vector<Constriction> after =
        detect(test_meshes::make_mesh(open_meshes::without_star(closed, 18 * ring + 3)));
    ASSERT_GE(after.size(), 1u);
    EXPECT_EQ(after[0].length(), before[0].length());
    EXPECT_GT(after[0].prominence(), 0.7 * before[0].prominence());
  }
}

// A slab with arms of one cell's width, each of which ends in a box that is open at its end: as many inlets and necks.
Soup slab_with_inlets(int inlets)
{
  const auto is_inside = [](int i, int j, int k) { return j < 3 || (j < 6 ? i % 4 == 1 && k == 1 : i % 4 != 3); };
  const Soup closed = test_meshes::voxels({{4 * inlets, 8, 3}}, is_inside);
  return open_meshes::without_faces(closed, [&closed](const test_meshes::Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&closed](std::size_t v) { return closed.points[v][1] == 8; });
  });
}

TEST(Boundary, EachInletHasItsNeck)
{
  for(int inlets : {3, 8})
  {
    const Mesh mesh = test_meshes::make_mesh(slab_with_inlets(inlets));
    const std::vector<Constriction> curves = detect(mesh);
    std::set<int> found;
    for(const Constriction& c : curves)
      if(c.length() == 4)
        found.insert(static_cast<int>(mesh.point(c.pivots()[0].vertex).x()) / 4);
    EXPECT_EQ(found.size(), static_cast<std::size_t>(inlets));
  }
}

// The boundary is jagged, and the loop around the hole cuts off its teeth: it runs along the boundary all the same.
TEST(Boundary, ALoopAroundAJaggedHoleIsARim)
{
  const Soup torus = test_meshes::torus(0.05, 1, 40, 20);
  const Soup open = open_meshes::without_faces(torus, [&torus](const test_meshes::Triangle& t) {
    const double x = torus.points[t[0]][0] + torus.points[t[1]][0] + torus.points[t[2]][0],
                 y = torus.points[t[0]][1] + torus.points[t[1]][1] + torus.points[t[2]][1],
                 z = torus.points[t[0]][2] + torus.points[t[1]][2] + torus.points[t[2]][2];
    return x / 3 > 3 && std::hypot(y / 3, z / 3) < 0.6;
  });
  const std::vector<Constriction> rims = detect_with_rims(test_meshes::make_mesh(open));
  EXPECT_EQ(std::count_if(rims.begin(), rims.end(), [](const Constriction& c) { return c.is_rim(); }), 1);
}

} // namespace test_boundary
