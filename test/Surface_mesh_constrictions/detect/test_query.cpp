// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/statistics_taker.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loops_at_location.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_query {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace params = CGAL::Surface_mesh_constrictions::parameters;
using test_meshes::Mesh;
typedef Mesh::Point Point;
typedef SMC::Constriction<Mesh> Constriction;
typedef SMC::Constriction_query<Mesh> Query;
typedef SMC::Geodesic_loop<Mesh> Loop;

// What tells one curve from another, and what a user reads of it.
struct Summary
{
  double length, prominence;
  std::vector<Mesh::Vertex_index> pivots;
  std::vector<double> parameters;
  SMC::Certificate_verdict verdict;

  explicit Summary(const Constriction& c)
    : length(c.length()), prominence(std::isnan(c.prominence()) ? -1 : c.prominence()), verdict(c.certificate().verdict)
  {
    for(const Constriction::Pivot& p : c.pivots())
      pivots.push_back(p.vertex);
    for(const Constriction::Location& l : c.locations())
      parameters.push_back(l.parameter);
  }

  friend bool operator==(const Summary& a, const Summary& b)
  {
    return a.length == b.length && a.prominence == b.prominence && a.pivots == b.pivots &&
           a.parameters == b.parameters && a.verdict == b.verdict;
  }
};

std::vector<Summary> summaries(const std::vector<Constriction>& curves)
{
  return std::vector<Summary>(curves.begin(), curves.end());
}

template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Summary> constrictions(const Query& query, const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Constriction> result;
  query.constrictions(std::back_inserter(result), np);
  return summaries(result);
}

template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Summary> near(const Query& query, const Point& location,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Constriction> result;
  query.constrictions_near(location, std::back_inserter(result), np);
  return summaries(result);
}

std::vector<Summary> near(const Mesh& mesh, const Point& location)
{
  std::vector<Constriction> result;
  SMC::detect_constrictions_near(mesh, location, std::back_inserter(result));
  return summaries(result);
}

std::vector<Loop> loops(const Query& query, const Point& location, std::size_t number)
{
  std::vector<Loop> result;
  query.geodesic_loops(location, std::back_inserter(result), params::maximum_number_of_loops(number));
  return result;
}

// A mesh for each kind: closed, with handles, with holes, and of two components.
std::vector<Mesh> meshes()
{
  return {test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1)),
          test_meshes::make_mesh(test_meshes::torus(0.1, 3)),
          test_meshes::make_mesh(open_meshes::with_random_holes(test_meshes::dumbbell(0.1, 4), 3, 1)),
          test_meshes::make_mesh(test_meshes::joined(test_meshes::boxes_with_tube(2), test_meshes::torus(0.1, 5), 30)),
          real_meshes::read("cactus.off")};
}

// Every hundredth vertex, or so, moved off the surface a little.
std::vector<Point> places(const Mesh& mesh)
{
  std::vector<Point> result;
  const std::size_t step = mesh.number_of_vertices() / 5;
  for(std::size_t v = 0; v < mesh.number_of_vertices(); v += step)
    result.push_back(mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v))) +
                     Point::R::Vector_3(0.001, -0.002, 0.0015));
  return result;
}

TEST(Query, GivesTheAnswersOfTheFunctions)
{
  for(const Mesh& mesh : meshes())
  {
    const Query query(mesh);
    EXPECT_EQ(&query.mesh(), &mesh);
    const std::vector<Constriction> detected = detection::detect(mesh);
    EXPECT_FALSE(detected.empty());
    EXPECT_EQ(constrictions(query), summaries(detected));
    for(const Point& place : places(mesh))
    {
      SCOPED_TRACE(place);
      EXPECT_EQ(near(query, place), near(mesh, place));
      std::vector<Loop> expected;
      SMC::geodesic_loops_at_location(mesh, place, std::back_inserter(expected), params::maximum_number_of_loops(3));
      const std::vector<Loop> found = loops(query, place, 3);
      ASSERT_EQ(found.size(), expected.size());
      for(std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_EQ(found[i].length, expected[i].length);
        EXPECT_EQ(found[i].locations, expected[i].locations);
        EXPECT_EQ(found[i].areas, expected[i].areas);
        EXPECT_EQ(found[i].verdict, expected[i].verdict);
        EXPECT_EQ(found[i].let_go.length(), expected[i].let_go.length());
      }
      const auto girth = query.girth(place);
      ASSERT_EQ(girth.has_value(), !expected.empty());
      if(girth)
      {
        EXPECT_EQ(girth->length, expected[0].length);
      }
    }
    for(const Constriction& c : detected)
    {
      if(c.seeds().front().level > 0)
        continue;
      const auto& loop = c.seeds().front().vertices;
      const SMC::Tightened_curve<Mesh> found = query.tighten(loop), expected = SMC::tighten_closed_curve(mesh, loop);
      EXPECT_EQ(found.verdict, expected.verdict);
      EXPECT_EQ(Summary(found.curve), Summary(expected.curve));
    }
  }
}

TEST(Query, ThresholdsMayBeChangedAfterwards)
{
  const Mesh mesh = real_meshes::read("cactus.off");
  const Query query(mesh);
  const auto expect = [&](const auto& np) {
    EXPECT_EQ(constrictions(query, np), summaries(detection::detect(mesh, np)));
  };
  expect(CGAL::parameters::default_values());
  expect(params::minimum_prominence(0.3));
  expect(params::maximum_number_of_constrictions(std::size_t(2)));
  expect(params::minimum_prominence(0.01));
  expect(params::minimum_prominence(0.01).minimum_isolation(0.0));
  expect(params::maximum_isoperimetric_ratio(0.1));
  expect(params::crossing_constrictions(true));
  expect(CGAL::parameters::default_values());
}

// The first call tells its stages, the second one only how the seeds ended.
TEST(Query, WhatWasFoundIsKept)
{
  struct Stages : SMC::Detection_visitor_base
  {
    std::size_t* number;
    explicit Stages(std::size_t& number) : number(&number) {}
    void on_stage_begin(SMC::Detection_stage, std::size_t) const { ++*number; }
  };
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1));
  const Query query(mesh);
  std::size_t stages = 0;
  const std::vector<Summary> first = constrictions(query, CGAL::parameters::visitor(Stages(stages)));
  EXPECT_EQ(stages, 4u);
  SMC::Detection_statistics statistics;
  EXPECT_EQ(constrictions(query, CGAL::parameters::visitor(statistics_taker::Statistics_taker(statistics))), first);
  EXPECT_GT(statistics.seeds, 0u);
  EXPECT_EQ(constrictions(query, CGAL::parameters::visitor(Stages(stages))), first);
  EXPECT_EQ(stages, 4u);
}

TEST(Query, ThreadsGetTheSameAnswers)
{
  const Mesh mesh = real_meshes::read("cactus.off");
  const Query query(mesh);
  const std::vector<Point> points = places(mesh);
  struct Answers
  {
    std::vector<Summary> all;
    std::vector<std::vector<Summary>> near;
    std::vector<double> girths;
  };
  const auto ask = [&](Answers& answers) {
    for(const Point& p : points)
    {
      answers.near.push_back(near(query, p));
      for(const Loop& loop : loops(query, p, 2))
        answers.girths.push_back(loop.length);
    }
    answers.all = constrictions(query);
  };
  Answers expected;
  ask(expected);
  EXPECT_FALSE(expected.all.empty());
  EXPECT_FALSE(expected.girths.empty());
  const Query other(mesh);
  Answers answers[2];
  {
    const auto ask_other = [&](Answers& a) {
      for(const Point& p : points)
      {
        a.near.push_back(near(other, p));
        for(const Loop& loop : loops(other, p, 2))
          a.girths.push_back(loop.length);
      }
      a.all = constrictions(other);
    };
    std::thread first(ask_other, std::ref(answers[0])), second(ask_other, std::ref(answers[1]));
    first.join();
    second.join();
  }
  for(const Answers& a : answers)
  {
    EXPECT_EQ(a.all, expected.all);
    EXPECT_EQ(a.near, expected.near);
    EXPECT_EQ(a.girths, expected.girths);
  }
}

TEST(Query, TakesAnyFaceGraph)
{
  typedef CGAL::Polyhedron_3<test_meshes::Kernel> Polyhedron;
  const test_meshes::Soup soup = test_meshes::boxes_with_tube(3);
  const Polyhedron mesh = test_meshes::make_graph<Polyhedron>(soup);
  const SMC::Constriction_query<Polyhedron, CGAL::Parallel_if_available_tag> query(mesh);
  std::vector<SMC::Constriction<Polyhedron>> found;
  query.constrictions(std::back_inserter(found));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].length(), 4, 1e-12);
  EXPECT_NEAR(query.girth(Point(3.5, 1.5, 1))->length, 4, 1e-12);
}

// The policies that are given make the levels, and the seed sources the seeds.
TEST(Query, TakesPoliciesAndSeedSources)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.005, 1));
  const auto np =
      params::simplification_policies(SMC::Lindstrom_turk_policies()).seed_sources(SMC::Non_face_triangle_seeds());
  const Query query(mesh, np);
  EXPECT_EQ(constrictions(query), summaries(detection::detect(mesh, np)));
}

template <class Ask>
SMC::Input_defect defect(const Ask& ask)
{
  try
  {
    ask();
  }
  catch(const SMC::Invalid_input& e)
  {
    EXPECT_GT(std::string(e.what()).size(), 10u);
    return e.defect();
  }
  ADD_FAILURE() << "no exception";
  return SMC::Input_defect::EMPTY_MESH;
}

TEST(Query, BadLocationsAndLoopsAreToldApart)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(9, 9, 9)), removed = mesh.add_vertex(Point(9, 9, 8));
  mesh.remove_vertex(removed);
  const Query query(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Constriction> curves;
  EXPECT_EQ(defect([&] { query.constrictions_near(Point(0, nan, 0), std::back_inserter(curves)); }),
            SMC::Input_defect::NON_FINITE_COORDINATE);
  EXPECT_EQ(defect([&] { query.girth(Point(nan, 0, 0)); }), SMC::Input_defect::NON_FINITE_COORDINATE);
  for(const Mesh::Vertex_index v : {isolated, removed, Mesh::null_vertex(), Mesh::Vertex_index(1000000)})
  {
    EXPECT_EQ(defect([&] { query.girth(v); }), SMC::Input_defect::INVALID_LOCATION);
    EXPECT_EQ(defect([&] {
                query.tighten(std::vector<Mesh::Vertex_index>{v, Mesh::Vertex_index(0), Mesh::Vertex_index(1)});
              }),
              SMC::Input_defect::INVALID_LOOP);
    EXPECT_EQ(defect([&] {
                query.loop_through(std::vector<Mesh::Vertex_index>{Mesh::Vertex_index(0), Mesh::Vertex_index(1), v});
              }),
              SMC::Input_defect::INVALID_LOCATION);
  }
  EXPECT_EQ(defect([&] {
              query.girth(Loop::Face_location(Mesh::Face_index(1000000), {{1, 0, 0}}));
            }),
            SMC::Input_defect::INVALID_LOCATION);
  EXPECT_EQ(defect([&] { const Query empty((Mesh())); }), SMC::Input_defect::EMPTY_MESH);
}

// On a mesh that is large enough, loops are looked for on a level: around each prism of a refined body they are as long
// as the prism, and areas and genera are those of the surface with the location put in.
TEST(Query, GirthsOfALargeMeshAreFoundWithItsLevels)
{
  const int cells = 16; // of each unit
  const Mesh mesh = test_meshes::make_mesh(test_meshes::branches(cells));
  ASSERT_GT(mesh.number_of_vertices(), 4 * SMC::internal::searching_vertices);
  const Query query(mesh);
  std::size_t with_girth = 0;
  for(const Point& place : places(mesh))
  {
    const auto girth = query.girth(place);
    if(!girth)
      continue;
    ++with_girth;
    std::vector<Point> points;
    girth->points(mesh, std::back_inserter(points));
    double length = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      length += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
    EXPECT_NEAR(length, girth->length, 1e-9 * length);
    EXPECT_NEAR(girth->areas[0] + girth->areas[1],
                CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh)) * (girth->separating ? 1 : 2), 1e-6);
  }
  EXPECT_GT(with_girth, 0u);
}

// Around a long prism the girth is its perimeter wherever the ends are further away than that.
TEST(Query, GirthsOfALargePrismAreItsPerimeter)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(16, 16, 280));
  ASSERT_GT(mesh.number_of_vertices(), 4 * SMC::internal::searching_vertices);
  const Query query(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> height(70, 210), along(0, 16);
  for(int i = 0; i < 20; ++i)
  {
    const Point place = i % 2 == 0 ? Point(16, along(random), height(random))
                                   : Point(std::floor(along(random)), 0, std::floor(height(random)));
    SCOPED_TRACE(place);
    const auto girth = query.girth(place);
    ASSERT_TRUE(girth);
    EXPECT_NEAR(girth->length, 64, 1e-9);
  }
}

// The loops that are found with levels are not longer than those of the search on the whole mesh. Where paths that lead
// away from the vertex are narrow, as on a scan, a loop of a level is led around it on the right side.
TEST(Query, GirthsOfALargeMeshAreThoseOfTheSearchOnAllOfIt)
{
  namespace internal = SMC::internal;
  const Mesh mesh = real_meshes::read("man.off");
  ASSERT_GT(mesh.number_of_vertices(), 4 * internal::searching_vertices);
  const Query query(mesh);
  const auto vpm = get(CGAL::vertex_point, mesh);
  internal::Prepared_surface<Mesh, std::decay_t<decltype(vpm)>> whole(
      mesh, vpm, CGAL::get_initialized_vertex_index_map(mesh, CGAL::parameters::default_values()));
  whole.hold_no_levels();
  std::mt19937 random(1);
  for(int i = 0; i < 6; ++i)
  {
    const SMC::Index v = static_cast<SMC::Index>(random() % mesh.number_of_vertices());
    SCOPED_TRACE(v);
    const auto expected = internal::held_loops(whole.surface(), v, internal::least_loop_angle, whole.length_unit());
    const auto girth = query.girth(Mesh::Vertex_index(v));
    ASSERT_EQ(girth.has_value(), !expected.empty());
    if(girth)
    {
      const double length = whole.imported().unit().restored(internal::total_length(expected[0]));
      EXPECT_LE(girth->length, length * (1 + 1e-9));
    }
  }
}

} // namespace test_query
