// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose constrictions are known in closed form, with points of exact kernels.
#include "include/detect.h"
#include "include/exact_models.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Certified_surface.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace test_certificate_models {

using namespace CGAL::Surface_mesh_constrictions;
using detection::detect;
using detection::detect_all;
using exact_models::Position;
using exact_models::Soup;

typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
typedef CGAL::Surface_mesh<Epeck::Point_3> Exact_mesh;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Cartesian_mesh;
typedef test_meshes::Mesh Mesh;

// Where the tube of boxes_with_tube() begins.
const std::vector<Position> beginning = {{{2, 1, 1}}, {{2, 2, 1}}, {{2, 2, 2}}, {{2, 1, 2}}};

// A loop of vertices is a constriction with the verdict and the band that are expected, whatever the kernel, and it is
// what a tightening of it gives.
void expect_loop(const Soup& soup, const std::vector<Position>& loop, Certificate_verdict verdict, double length,
                 double band_width)
{
  for(const Certificate& c :
      {exact_models::certify_loop<Exact_mesh>(soup, loop), exact_models::certify_loop<Mesh>(soup, loop),
       exact_models::certify_loop<Cartesian_mesh>(soup, loop)})
  {
    EXPECT_EQ(c.verdict, verdict) << c;
    EXPECT_NEAR(c.flat_band_width, band_width, 1e-12 * band_width);
  }
  const Exact_mesh mesh = test_meshes::make_graph<Exact_mesh>(soup);
  std::vector<Exact_mesh::Vertex_index> path;
  for(std::size_t v : exact_models::vertices_at(soup, loop))
    path.emplace_back(static_cast<Exact_mesh::size_type>(v));
  const auto tightened = tighten_closed_curve(mesh, path);
  ASSERT_EQ(tightened.verdict, Tightening_verdict::CLOSED_GEODESIC);
  EXPECT_EQ(tightened.curve.certificate().verdict, verdict);
  EXPECT_NEAR(tightened.curve.length(), length, 1e-12 * length);
  EXPECT_NEAR(tightened.curve.flat_band_width(), band_width, 1e-12 * band_width);
}

TEST(CertificateModels, SquareTubeBetweenBoxesIsABandThatHolds)
{
  for(int length : {1, 2, 5})
  {
    const Soup soup = test_meshes::boxes_with_tube(length);
    expect_loop(soup, beginning, Certificate_verdict::CONSTRICTION, 4, length);
    const auto found = detect(test_meshes::make_graph<Exact_mesh>(soup));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].certificate().verdict, Certificate_verdict::CONSTRICTION);
    EXPECT_NEAR(found[0].length(), 4, 4e-12);
  }
}

TEST(CertificateModels, EveryRingOfTheTubeIsInTheSameBand)
{
  const Soup soup = test_meshes::boxes_with_tube(4);
  for(double x = 2; x <= 6; ++x)
  {
    const Certificate c =
        exact_models::certify_loop<Exact_mesh>(soup, {{{x, 1, 1}}, {{x, 2, 1}}, {{x, 2, 2}}, {{x, 1, 2}}});
    EXPECT_EQ(c.verdict, Certificate_verdict::CONSTRICTION) << c;
    EXPECT_NEAR(c.flat_band_width, 4, 1e-12);
  }
}

TEST(CertificateModels, WaistOfIntegerPointsIsStrict)
{
  for(int a : {1, 2, 7})
    expect_loop(exact_models::waist(a), exact_models::ring(exact_models::square(), a, 5),
                Certificate_verdict::STRICT_CONSTRICTION, 8 * a, 0);
}

TEST(CertificateModels, PrismChainsHoldWhateverTheNumberOfSides)
{
  for(int n = 3; n <= 12; ++n)
  {
    const auto p = exact_models::polygon(n);
    double perimeter = 0;
    for(int i = 0; i < n; ++i)
      perimeter += std::hypot(p[(i + 1) % n][0] - p[i][0], p[(i + 1) % n][1] - p[i][1]);
    const Soup soup = exact_models::prism_chain(n, 400);
    for(double z : {500., 900.})
      expect_loop(soup, exact_models::ring(p, 1, z), Certificate_verdict::CONSTRICTION, perimeter, 400);
    bool is_found = false;
    for(const auto& c : detect_all(test_meshes::make_graph<Exact_mesh>(soup)))
      is_found = is_found || std::abs(c.length() - perimeter) < 1e-9 * perimeter;
    EXPECT_TRUE(is_found) << n;
  }
}

TEST(CertificateModels, MiddleOfTheTwistedCylinderIsStrict)
{
  expect_loop(exact_models::twisted_cylinder(), {{{2, 0, 0}}, {{0, 2, 0}}, {{-2, 0, 0}}, {{0, -2, 0}}},
              Certificate_verdict::STRICT_CONSTRICTION, 8 * std::sqrt(2.), 0);
}

TEST(CertificateModels, BeltsOfConvexPrismsLeak)
{
  for(int n = 3; n <= 12; ++n)
  {
    const auto p = exact_models::polygon(n);
    const Soup soup =
        exact_models::tube({exact_models::ring(p, 1, 0), exact_models::ring(p, 1, 200), exact_models::ring(p, 1, 500)});
    const Certificate c = exact_models::certify_loop<Exact_mesh>(soup, exact_models::ring(p, 1, 200));
    EXPECT_EQ(c.verdict, Certificate_verdict::LEAKY_BAND) << n << ": " << c;
    EXPECT_TRUE(detect_all(test_meshes::make_graph<Exact_mesh>(soup)).empty());
  }
}

// The tube of boxes_with_tube(3), its vertex (3, 1, 1) moved across the tube: the loop around the tube's beginning has
// four side angles of exactly pi on the side of the tube; the move makes one of them smaller or greater.
Soup moved_tube(double y)
{
  Soup soup = test_meshes::boxes_with_tube(3);
  for(Position& p : soup.points)
    if(p == Position{{3, 1, 1}})
      p[1] = y;
  return soup;
}

template <class AnyMesh>
std::vector<Certificate_verdict> verdicts_around_pi()
{
  const double one_less = std::nextafter(1., 0.), one_more = std::nextafter(1., 2.);
  std::vector<Certificate_verdict> result;
  for(double y : {one_less, 1., one_more})
    result.push_back(exact_models::certify_loop<AnyMesh>(moved_tube(y), beginning).verdict);
  return result;
}

TEST(CertificateModels, OneUlpAroundAnAngleOfPiGivesThreeVerdicts)
{
  const std::vector<Certificate_verdict> expected = {
      Certificate_verdict::STRICT_CONSTRICTION, Certificate_verdict::CONSTRICTION, Certificate_verdict::ANGLE_BELOW_PI};
  EXPECT_EQ(verdicts_around_pi<Mesh>(), expected);
  EXPECT_EQ(verdicts_around_pi<Exact_mesh>(), expected);
  EXPECT_EQ(verdicts_around_pi<Cartesian_mesh>(), expected);
}

TEST(CertificateModels, FloatingPointGetsTheThreeVerdictsWrong)
{
  std::vector<int> signs;
  for(double y : {std::nextafter(1., 0.), 1., std::nextafter(1., 2.)})
  {
    const Soup soup = moved_tube(y);
    const Mesh mesh = test_meshes::make_mesh(soup);
    const auto corners = exact_models::vertices_at(soup, beginning);
    // the angle at the pivot (2, 1, 1) between its neighbours on the curve, on the side of the tube
    const Mesh::Vertex_index p(static_cast<Mesh::size_type>(corners[0]));
    double angle = 0;
    for(Mesh::Halfedge_index h : halfedges_around_source(p, mesh))
    {
      const auto a = mesh.point(p), b = mesh.point(mesh.target(h)), c = mesh.point(mesh.target(mesh.next(h)));
      const auto u = b - a, v = c - a;
      if(b.x() >= 2 && c.x() >= 2 && (b.x() > 2 || c.x() > 2))
        angle += std::atan2(std::sqrt(CGAL::cross_product(u, v).squared_length()), u * v);
    }
    signs.push_back(angle > CGAL_PI ? 1 : angle < CGAL_PI ? -1 : 0);
  }
  EXPECT_NE(signs, (std::vector<int>{1, 0, -1}));
}

TEST(CertificateModels, DetectorCorrectsWhatRoundingCannotSee)
{
  for(double y : {std::nextafter(1., 0.), 1., std::nextafter(1., 2.)})
  {
    const auto found = detect_all(test_meshes::make_mesh(moved_tube(y)));
    ASSERT_FALSE(found.empty());
    for(const auto& c : found)
      EXPECT_TRUE(c.certificate().is_certified()) << c.certificate();
  }
}

// Two boxes and a tube with corners at zero, where each coordinate that is zero is moved by what move(axis) gives.
template <class Move>
Mesh tube_near_zero(const Move& move)
{
  Soup soup = test_meshes::boxes_with_tube(4);
  for(Position& p : soup.points)
  {
    p[1] -= 1;
    p[2] -= 1;
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(p[axis] == 0)
        p[axis] = move(axis);
  }
  return test_meshes::make_mesh(soup);
}

// Coordinates near 1 and subnormal ones together make exact numbers of thousands of digits.
TEST(CertificateModels, TiesAreProvedWhereCoordinatesAreSubnormal)
{
  const Position moves = {{std::numeric_limits<double>::denorm_min(), 1e-310, 2.5e-309}};
  const auto found = detect_all(tube_near_zero([&](std::size_t axis) { return moves[axis]; }));
  ASSERT_FALSE(found.empty());
  for(const auto& c : found)
    EXPECT_TRUE(c.certificate().is_certified()) << c.certificate();
  EXPECT_EQ(found[0].certificate().verdict, Certificate_verdict::CONSTRICTION) << "the sides of the tube are flat";
  EXPECT_NEAR(found[0].length(), 4, 4e-12);
  EXPECT_NEAR(found[0].flat_band_width(), 4, 4e-12);
}

TEST(CertificateModels, WhereEachCoordinateIsSubnormalInItsOwnWayTheSearchEndsAndTellsWhatStaysOpen)
{
  const std::vector<double> moves = {0, std::numeric_limits<double>::denorm_min(), 1e-310, 2.5e-309};
  unsigned state = 1;
  const auto found = detect_all(tube_near_zero([&](std::size_t) {
    state = state * 1103515245 + 12345;
    return (state >> 18) % 2 == 0 ? -moves[(state >> 16) % 4] : moves[(state >> 16) % 4];
  }));
  bool has_neck = false;
  for(const auto& c : found)
  {
    has_neck = has_neck || (c.certificate().is_certified() && std::abs(c.length() - 4) < 4e-12);
    EXPECT_TRUE(c.certificate().is_certified() || c.certificate().verdict == Certificate_verdict::TIE_NOT_PROVED)
        << c.certificate();
  }
  EXPECT_TRUE(has_neck);
}

TEST(CertificateModels, RationalPointsThatAreNoDoublesAreTakenExactly)
{
  // turned by a rational rotation: all ties stay ties, but are none after a rounding to doubles
  std::mt19937 random(3);
  Exact_mesh mesh = test_meshes::make_graph<Exact_mesh>(test_meshes::boxes_with_tube(2));
  exact_models::rotate(mesh, random, 1);
  const auto found = detect(mesh);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].certificate().verdict, Certificate_verdict::CONSTRICTION);
  EXPECT_NEAR(found[0].length(), 4, 1e-12);

  Mesh rounded;
  CGAL::copy_face_graph(mesh, rounded);
  for(const auto& f : detect_all(rounded))
    EXPECT_EQ(f.certificate().verdict, Certificate_verdict::STRICT_CONSTRICTION);
}

TEST(CertificateModels, KernelWithSquareRoots)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Root_mesh;
  const Soup soup = exact_models::waist(1);
  Root_mesh mesh = test_meshes::make_graph<Root_mesh>(soup);
  const auto loop = exact_models::vertices_at(soup, exact_models::ring(exact_models::square(), 1, 5));
  const auto curve = exact_models::curve_of_loop(mesh, loop);
  EXPECT_EQ(certify_constriction(mesh, curve).verdict, Certificate_verdict::STRICT_CONSTRICTION);

  for(auto v : vertices(mesh))
  {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(p.x() / 7, p.y() / 7, p.z() / 7);
  }
  EXPECT_EQ(certify_constriction(mesh, curve).verdict, Certificate_verdict::STRICT_CONSTRICTION);
}

TEST(CertificateModels, IrrationalCoordinateIsRefusedWhereItMatters)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Root_mesh;
  const Soup soup = test_meshes::boxes_with_tube(1);
  Root_mesh mesh = test_meshes::make_graph<Root_mesh>(soup);
  const Kernel::FT root = CGAL::sqrt(Kernel::FT(2));
  for(auto v : vertices(mesh))
  {
    const Kernel::Point_3 p = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(root * p.x(), root * p.y(), root * p.z());
  }
  const auto curve = exact_models::curve_of_loop(mesh, exact_models::vertices_at(soup, beginning));
  try
  {
    certify_constriction(mesh, curve);
    FAIL() << "a tie was decided without exact coordinates";
  }
  catch(const Invalid_input& e)
  {
    EXPECT_EQ(e.defect(), Input_defect::IRRATIONAL_COORDINATE);
    EXPECT_NE(std::string(e.what()).find("irrational coordinate"), std::string::npos);
  }
}

TEST(CertificateModels, EdgeRunToAndFroIsNoConstriction)
{
  const Mesh mesh = test_meshes::make_mesh(exact_models::waist(1));
  const Mesh::Halfedge_index h = *halfedges(mesh).begin();
  const auto curve = exact_models::curve_of_loop(mesh, {mesh.source(h).idx(), mesh.target(h).idx()});
  EXPECT_EQ(certify_constriction(mesh, curve).verdict, Certificate_verdict::ANGLE_BELOW_PI);
}

// The ring of a waist, led past one of its vertices.
TEST(CertificateModels, ThePlaceIsOneOfTheLocationsWhereverTheCurveStarts)
{
  const Soup soup = exact_models::waist(1);
  const Mesh mesh = test_meshes::make_mesh(soup);
  std::vector<Mesh::Vertex_index> ring;
  for(std::size_t v : exact_models::vertices_at(soup, exact_models::ring(exact_models::square(), 1, 5)))
    ring.emplace_back(static_cast<Mesh::size_type>(v));
  typedef Constriction<Mesh>::Location Location;
  std::vector<Location> curve;
  const auto next = [&mesh](Mesh::Halfedge_index h) { return mesh.opposite(mesh.next(h)); };
  for(Mesh::Halfedge_index h = next(mesh.halfedge(ring[3], ring[0])); mesh.source(h) != ring[1]; h = next(h))
    curve.push_back({false, Mesh::Vertex_index(), mesh.opposite(h), 0.5});
  ASSERT_FALSE(curve.empty());
  const Mesh::Halfedge_index first_crossed = curve.front().halfedge;
  for(std::size_t i = 1; i < 4; ++i)
    curve.push_back({true, ring[i], Mesh::Halfedge_index(), 0});
  for(std::size_t start = 0; start < curve.size(); ++start)
  {
    Constriction<Mesh>::Data data;
    data.locations = curve;
    const Certificate c = certify_constriction(mesh, Constriction<Mesh>(data));
    EXPECT_EQ(c.verdict, Certificate_verdict::NOT_STRAIGHT) << c;
    ASSERT_LT(c.location, curve.size()) << start;
    EXPECT_EQ(curve[c.location].halfedge, first_crossed) << start;
    EXPECT_EQ(c.side, Curve_side::RIGHT);
    std::rotate(curve.begin(), curve.begin() + 1, curve.end());
  }
}

TEST(CertificateModels, PathThatSkipsAnEdgeIsNoClosedCurve)
{
  const Soup soup = exact_models::waist(1);
  auto positions = exact_models::ring(exact_models::square(), 1, 5);
  std::swap(positions[1], positions[2]);
  const Certificate c = exact_models::certify_loop<Mesh>(soup, positions);
  EXPECT_EQ(c.verdict, Certificate_verdict::NOT_A_CLOSED_CURVE);
  EXPECT_EQ(c.location, 0u);
  std::ostringstream text;
  text << c;
  EXPECT_EQ(text.str(), "not_certified: not a closed curve, point 0 does not fit the next one");
  EXPECT_EQ(certify_constriction(test_meshes::make_mesh(soup), Constriction<Mesh>()).verdict,
            Certificate_verdict::NOT_A_CLOSED_CURVE);
}

TEST(CertificateModels, RingRunTwiceTouchesItself)
{
  const Soup soup = exact_models::waist(1);
  auto positions = exact_models::ring(exact_models::square(), 1, 5);
  positions.insert(positions.end(), positions.begin(), positions.begin() + 4);
  const Certificate c = exact_models::certify_loop<Mesh>(soup, positions);
  EXPECT_EQ(c.verdict, Certificate_verdict::TOUCHES_ITSELF) << c;
  EXPECT_EQ(c.location, 0u);
  EXPECT_EQ(c.other_location, 4u);
}

TEST(Certificate, EachVerdictIsOneLineWithItsPlace)
{
  const auto text = [](Certificate_verdict verdict) {
    Certificate c;
    c.verdict = verdict;
    c.location = 3;
    c.other_location = 5;
    c.side = Curve_side::RIGHT;
    std::ostringstream out;
    out << c;
    return out.str();
  };
  EXPECT_EQ(text(Certificate_verdict::STRICT_CONSTRICTION), "strict_constriction");
  EXPECT_EQ(text(Certificate_verdict::CONSTRICTION), "constriction");
  EXPECT_EQ(text(Certificate_verdict::LEAKY_BAND), "not_certified: the flat band on the right leaks");
  EXPECT_EQ(text(Certificate_verdict::NOT_STRAIGHT),
            "not_certified: not straight, the arc through point 3 passes the edge's right end on the wrong side or "
            "through it");
  EXPECT_EQ(text(Certificate_verdict::ANGLE_BELOW_PI),
            "not_certified: the side angle on the right of point 3 is less than pi");
  EXPECT_EQ(text(Certificate_verdict::CROSSES_ITSELF),
            "not_certified: not simple, crosses itself between points 3 and 5");
  EXPECT_EQ(text(Certificate_verdict::TOUCHES_ITSELF), "not_certified: not simple, points 3 and 5 are the same vertex");
  EXPECT_EQ(text(Certificate_verdict::TIE_NOT_PROVED), "not_certified: tie not proved at point 3");
  EXPECT_EQ(text(Certificate_verdict::NOT_COMPUTED), "not_certified: no exact certificate has been computed");
}

// A curve around the tube that crosses the inside of its edges, without pivots.
Constriction<Mesh> curve_without_pivots(const Mesh& mesh, double x)
{
  typedef Constriction<Mesh> Curve;
  Curve::Data data;
  for(Mesh::Halfedge_index h : halfedges(mesh))
  {
    const auto p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
    if(!(p.x() > x && q.x() < x)) // seen along the curve, the lower end lies on its left
      continue;
    Mesh::Halfedge_index crossed = h;
    do
    {
      data.locations.push_back({false, Mesh::Vertex_index(), crossed, 0.5});
      const Mesh::Halfedge_index o = mesh.opposite(crossed), n = mesh.next(o), m = mesh.prev(o);
      crossed = mesh.point(mesh.source(n)).x() > x && mesh.point(mesh.target(n)).x() < x ? n : m;
    } while(crossed != h);
    break;
  }
  return Curve(data);
}

TEST(CertificateModels, CurveWithoutPivotsIsKnownByItsStrip)
{
  const Mesh tube = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const Certificate c = certify_constriction(tube, curve_without_pivots(tube, 3.5));
  EXPECT_EQ(c.verdict, Certificate_verdict::CONSTRICTION) << c;
  EXPECT_NEAR(c.flat_band_width, 3, 1e-12);

  const Mesh box = test_meshes::make_mesh(test_meshes::box(3, 1, 1));
  EXPECT_EQ(certify_constriction(box, curve_without_pivots(box, 1.5)).verdict, Certificate_verdict::LEAKY_BAND);

  // the strip of a frustum turns, so no closed curve in it is straight
  const Mesh frustum = test_meshes::make_mesh(exact_models::tube(
      {exact_models::ring(exact_models::square(), 3, 0), exact_models::ring(exact_models::square(), 1, 5)}));
  Mesh upright = frustum;
  for(auto v : vertices(upright))
    upright.point(v) = Mesh::Point(frustum.point(v).z(), frustum.point(v).x(), frustum.point(v).y());
  EXPECT_EQ(certify_constriction(upright, curve_without_pivots(upright, 2.5)).verdict,
            Certificate_verdict::NOT_STRAIGHT);
}

// The curve at the height of a vertex that has no other pivot.
Constriction<Mesh> loop_at_height_of(const Mesh& mesh, std::size_t vertex, bool is_clockwise)
{
  const Mesh::Vertex_index v(static_cast<Mesh::size_type>(vertex));
  const internal::Graph_surface<Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>> surface(mesh, mesh.points());
  Constriction<Mesh>::Data data;
  data.locations.push_back({true, v, Mesh::Halfedge_index(), 0});
  for(Mesh::Halfedge_index h : exact_models::crossings_at_height_of(
          surface, v, [&mesh](Mesh::Vertex_index w) { return mesh.point(w).z(); }, is_clockwise))
    data.locations.push_back({false, Mesh::Vertex_index(), h, 0.5});
  return Constriction<Mesh>(data);
}

TEST(CertificateModels, LoopThroughOneVertexOfAPrismIsInABandOrSlipsToTheNarrowerEnd)
{
  for(int n = 3; n <= 8; ++n)
    for(bool is_clockwise : {false, true})
    {
      const auto certify = [&](double factor) {
        const Soup soup = exact_models::prism_with_one_vertex(n, factor);
        const Mesh mesh = test_meshes::make_mesh(soup);
        const std::size_t vertex = exact_models::vertex_at_height(soup, 650);
        return certify_constriction(mesh, loop_at_height_of(mesh, vertex, is_clockwise));
      };
      const Certificate straight = certify(1);
      EXPECT_EQ(straight.verdict, Certificate_verdict::CONSTRICTION) << n << ": " << straight;
      EXPECT_NEAR(straight.flat_band_width, 400, 1e-9);
      EXPECT_EQ(straight.signs.unproved, 0u);
      for(double difference : {1e-3, std::ldexp(1., -40), -std::ldexp(1., -40), -1e-3})
      {
        const Certificate c = certify(1 + difference);
        EXPECT_EQ(c.verdict, Certificate_verdict::ANGLE_BELOW_PI) << n << ": " << c;
        EXPECT_EQ(c.side, (difference > 0) == is_clockwise ? Curve_side::LEFT : Curve_side::RIGHT);
        EXPECT_EQ(c.location, 0u);
      }
    }
}

// The side angles at the one vertex are pi by a product of more than a hundred corners, of faces with many different
// square roots. Equal angles of opposite orientation, half a turn apart, cancel; few are left.
TEST(CertificateModels, LoopWhoseTurnsCancelIsProvedStraightWhateverTheNumberOfSides)
{
  for(int m : {4, 14, 16})
    for(bool is_clockwise : {false, true})
    {
      const Soup soup = exact_models::tube_that_turns_to_and_fro(m);
      const Mesh mesh = test_meshes::make_mesh(soup);
      const Certificate c =
          certify_constriction(mesh, loop_at_height_of(mesh, exact_models::vertex_at_height(soup, 650), is_clockwise));
      EXPECT_EQ(c.verdict, Certificate_verdict::CONSTRICTION) << m << ": " << c;
      EXPECT_EQ(c.signs.unproved, 0u) << m;
    }
}

// A face beside a curve is missing: on that side nothing but the hole changes, where the angle is infinite.
TEST(CertificateModels, ABorderBesideACurveIsAnObstacle)
{
  Mesh mesh = test_meshes::make_mesh(exact_models::waist(1));
  const auto loop = exact_models::vertices_at(exact_models::waist(1), exact_models::ring(exact_models::square(), 1, 5));
  const auto curve = exact_models::curve_of_loop(mesh, loop);
  Mesh opened = mesh;
  CGAL::Euler::remove_face(opened.halfedge(Mesh::Vertex_index(static_cast<Mesh::size_type>(loop[0]))), opened);
  EXPECT_EQ(certify_constriction(opened, curve).verdict, Certificate_verdict::STRICT_CONSTRICTION);
}

// A curve that crosses the boundary leaves the surface.
TEST(CertificateModels, ACurveThroughAHoleIsNone)
{
  Mesh mesh = test_meshes::make_mesh(exact_models::waist(1));
  const auto h = mesh.halfedge(Mesh::Vertex_index(0));
  Constriction<Mesh>::Data data;
  for(const auto& crossed : {h, mesh.opposite(mesh.prev(h)), mesh.opposite(mesh.next(h))})
    data.locations.push_back({false, Mesh::null_vertex(), crossed, 0.5});
  Mesh opened = mesh;
  CGAL::Euler::remove_face(h, opened);
  EXPECT_EQ(certify_constriction(opened, Constriction<Mesh>(data)).verdict, Certificate_verdict::NOT_A_CLOSED_CURVE);
}

} // namespace test_certificate_models
