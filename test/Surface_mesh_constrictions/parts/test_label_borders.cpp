// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/random_labels.h"
#include "include/real_meshes.h"
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Border_arranger.h>
#include <CGAL/Surface_mesh_constrictions/split_along_label_borders.h>
#include <CGAL/Surface_mesh_constrictions/tighten_label_borders.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_label_borders {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using SMC::Certificate_verdict;
using SMC::Label_border_outcome;
using test_meshes::Mesh;
typedef test_meshes::Kernel::Point_3 Point;
typedef SMC::Label_border<Mesh, int> Border;
typedef SMC::Tightened_labels<Mesh, int> Result;

Point centre(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
}

// A mesh with labels before and after.
struct Labelled
{
  Mesh mesh;
  std::vector<int> old_labels, new_labels;
  Result result;

  // label_of(p) is the label of a face with the centre p.
  template <class LabelOf>
  Labelled(const test_meshes::Soup& soup, const LabelOf& label_of) : mesh(test_meshes::make_mesh(soup))
  {
    for(Mesh::Face_index f : mesh.faces())
      old_labels.push_back(label_of(centre(mesh, f)));
    tighten();
  }

  Labelled(const Mesh& mesh, const std::vector<int>& labels) : mesh(mesh), old_labels(labels) { tighten(); }

  void tighten()
  {
    new_labels.resize(old_labels.size());
    result = SMC::tighten_label_borders(mesh, CGAL::make_property_map(old_labels), CGAL::make_property_map(new_labels));
  }

  std::set<int> labels_left() const { return {new_labels.begin(), new_labels.end()}; }

  std::vector<Border> borders_with(Label_border_outcome outcome) const
  {
    std::vector<Border> selected;
    std::copy_if(result.borders.begin(), result.borders.end(), std::back_inserter(selected),
                 [=](const Border& b) { return b.outcome == outcome; });
    return selected;
  }

  double area_of(int label) const
  {
    double sum = 0;
    for(std::size_t p = 0; p < result.parts.size(); ++p)
      if(result.labels[p] == label)
        sum += result.parts[p].area;
    return sum;
  }
};

// Shifts a place along an axis so that a border there is ragged.
double ragged(double along, double u, double v) { return along + 0.9 * std::sin(7 * u + 5 * v); }

// The tube is between x = 2 and x = 8; its one constriction is the ring of length 4 at the end with the smaller vertex.
TEST(Label_borders, a_ragged_border_around_a_tube_becomes_a_ring)
{
  const Labelled s(test_meshes::boxes_with_tube(6),
                   [](const Point& p) { return ragged(p.x(), p.y(), p.z()) < 5 ? 10 : -3; });
  const std::vector<Border> rings = s.borders_with(Label_border_outcome::CLOSED_GEODESIC);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].labels, (std::array<int, 2>{{-3, 10}}));
  EXPECT_TRUE(rings[0].is_closed);
  EXPECT_GT(rings[0].old_length, 5);
  EXPECT_NEAR(rings[0].length, 4, 1e-12);
  EXPECT_EQ(rings[0].certificate.verdict, Certificate_verdict::CONSTRICTION);
  EXPECT_FALSE(rings[0].vanishing_label);
  for(const Border& b : s.result.borders)
    EXPECT_TRUE(b.outcome == Label_border_outcome::CLOSED_GEODESIC || b.vanishing_label);
  std::vector<Point> points;
  rings[0].points(s.mesh, std::back_inserter(points));
  const double x = points.front().x();
  EXPECT_TRUE(x == 2 || x == 8) << x;
  for(const Point& p : points)
    EXPECT_EQ(p.x(), x);
  for(Mesh::Face_index f : s.mesh.faces())
    EXPECT_EQ(s.new_labels[f], centre(s.mesh, f).x() <= x ? 10 : -3);
  // a box of 2 x 3 x 3 has area 42; where the tube begins a unit square is missing
  ASSERT_EQ(s.result.parts.size(), 2u);
  EXPECT_NEAR(s.area_of(10), x == 2 ? 41 : 41 + 24, 1e-12);
  EXPECT_NEAR(s.area_of(-3), x == 2 ? 41 + 24 : 41, 1e-12);
  EXPECT_NEAR(s.result.parts[0].volume + s.result.parts[1].volume, 18 + 18 + 6, 1e-12);
}

// Three sectors of a cube around its axis meet at the centres of the top and of the bottom. From one to the other it is
// 3 + 6 + 3 over the middle of a side.
TEST(Label_borders, junctions_of_three_labels_stay_and_are_joined_by_geodesics)
{
  const auto sector = [](const Point& p) {
    const double shift = p.z() > 1 && p.z() < 5 ? 0.8 * std::sin(9 * p.z()) : 0;
    const double x = p.x() - 3, y = p.y() - 3;
    if(std::abs(x) > std::abs(y)) // the borders over the sides at +x and -x
      return y + shift < 0 ? 3 : x > 0 ? 1 : 2;
    return y < 0 ? 3 : x + shift > 0 ? 1 : 2;
  };
  const Labelled s(test_meshes::box(6, 6, 6), sector);
  const std::vector<Border> arcs = s.borders_with(Label_border_outcome::GEODESIC_ARC);
  ASSERT_EQ(arcs.size(), 3u);
  std::set<std::array<int, 2>> labels;
  for(const Border& b : arcs)
  {
    labels.insert(b.labels);
    EXPECT_FALSE(b.is_closed);
    EXPECT_GT(b.old_length, 12.5);
    EXPECT_NEAR(b.length, 12, 1e-12);
    EXPECT_EQ(b.certificate.verdict, Certificate_verdict::GEODESIC_ARC);
    std::set<Point> ends;
    for(const auto& l : {b.locations.front(), b.locations.back()})
    {
      ASSERT_TRUE(l.is_pivot);
      ends.insert(s.mesh.point(l.vertex));
    }
    EXPECT_EQ(ends, (std::set<Point>{Point(3, 3, 0), Point(3, 3, 6)}));
    EXPECT_EQ(b.old_vertices.front(), b.locations.front().vertex);
    EXPECT_EQ(b.old_vertices.back(), b.locations.back().vertex);
  }
  EXPECT_EQ(labels, (std::set<std::array<int, 2>>{{{1, 2}}, {{1, 3}}, {{2, 3}}}));
  EXPECT_NEAR(s.area_of(1), 54, 1e-12);
  EXPECT_NEAR(s.area_of(2), 54, 1e-12);
  EXPECT_NEAR(s.area_of(3), 108, 1e-12);
}

TEST(Label_borders, what_shortens_to_a_point_names_the_label_that_vanishes)
{
  // patches on two sides of a convex body: one inside of the other, so that there are three borders
  const Labelled s(test_meshes::box(6, 6, 6), [](const Point& p) {
    if(p.z() > 5.99 && p.x() > 1 && p.x() < 5 && p.y() > 1 && p.y() < 5)
      return p.x() > 2 && p.x() < 4 && p.y() > 2 && p.y() < 4 ? 9 : 8;
    return p.z() < 0.01 && p.x() < 3 ? 5 : 4;
  });
  ASSERT_EQ(s.result.borders.size(), 3u);
  std::multiset<int> vanishing;
  for(const Border& b : s.result.borders)
  {
    EXPECT_EQ(b.outcome, Label_border_outcome::DEGENERATE);
    EXPECT_TRUE(b.locations.empty());
    EXPECT_EQ(b.length, 0);
    ASSERT_TRUE(b.vanishing_label);
    vanishing.insert(*b.vanishing_label);
  }
  EXPECT_EQ(vanishing, (std::multiset<int>{5, 8, 9}));
  EXPECT_EQ(s.labels_left(), std::set<int>{4});
  ASSERT_EQ(s.result.parts.size(), 1u);
  EXPECT_EQ(s.result.labels, std::vector<int>{4});
  EXPECT_NEAR(s.result.parts[0].area, 216, 1e-12);
}

TEST(Label_borders, between_borders_that_come_to_lie_on_each_other_a_label_vanishes)
{
  const Labelled s(test_meshes::boxes_with_tube(6), [](const Point& p) { return p.x() < 4 ? 1 : p.x() < 6 ? 2 : 3; });
  ASSERT_EQ(s.result.borders.size(), 2u);
  for(const Border& b : s.result.borders)
  {
    EXPECT_EQ(b.outcome, Label_border_outcome::CLOSED_GEODESIC);
    EXPECT_EQ(b.vanishing_label, 2);
  }
  EXPECT_EQ(s.labels_left(), (std::set<int>{1, 3}));
  EXPECT_EQ(s.result.parts.size(), 2u);
  EXPECT_NEAR(s.area_of(1) + s.area_of(3), 41 + 24 + 41, 1e-12);
}

TEST(Label_borders, a_ring_within_one_label_vanishes_and_leaves_no_border)
{
  for(const int ring : {0, 2}) // the lesser or the greater of the labels
  {
    Labelled s(test_meshes::boxes_with_tube(6), [=](const Point& p) { return p.x() > 4 && p.x() < 6 ? ring : 1; });
    ASSERT_EQ(s.result.borders.size(), 2u);
    for(const Border& b : s.result.borders)
      EXPECT_EQ(b.vanishing_label, ring);
    EXPECT_EQ(s.labels_left(), std::set<int>{1});
    EXPECT_EQ(s.result.parts.size(), 1u);
    auto marks = s.mesh.add_property_map<Mesh::Edge_index, bool>("e:marks", false).first;
    SMC::split_along_label_borders(s.mesh, s.result.borders, CGAL::parameters::edge_is_constrained_map(marks));
    for(Mesh::Edge_index e : s.mesh.edges())
      EXPECT_FALSE(marks[e]);
  }
}

// A square tube without its ends, parted along it: two borders from rim to rim.
TEST(Label_borders, borders_are_held_where_they_end_on_a_rim)
{
  const test_meshes::Soup closed = test_meshes::box(2, 2, 4);
  const test_meshes::Soup tube = open_meshes::without_faces(closed, [&](const test_meshes::Triangle& t) {
    const double z = closed.points[t[0]][2];
    return (z == 0 || z == 4) && closed.points[t[1]][2] == z && closed.points[t[2]][2] == z;
  });
  const Labelled s(tube, [](const Point& p) {
    return p.x() + (p.z() > 1 && p.z() < 3 ? 0.9 * std::sin(9 * p.z() + p.y()) : 0) < 1 ? 1 : 2;
  });
  const std::vector<Border> arcs = s.borders_with(Label_border_outcome::GEODESIC_ARC);
  ASSERT_EQ(arcs.size(), 2u);
  for(const Border& b : arcs)
  {
    EXPECT_NEAR(b.length, 4, 1e-12);
    EXPECT_EQ(b.certificate.verdict, Certificate_verdict::GEODESIC_ARC);
  }
  EXPECT_NEAR(s.area_of(1), 16, 1e-12);
  EXPECT_NEAR(s.area_of(2), 16, 1e-12);
}

// On an open tube a border around it may come off at a rim: it is held there.
TEST(Label_borders, a_border_that_comes_to_a_rim_leaves_the_other_label_nothing)
{
  const test_meshes::Soup cone = open_meshes::without_faces(
      test_meshes::revolution_of_profile({{{1, 0}}, {{1.5, 1}}, {{2, 2}}, {{2.5, 3}}}, -0.1, 3.1, 24, 0, 1),
      [](const test_meshes::Triangle& t) {
        const std::size_t apexes =
            static_cast<std::size_t>(std::count_if(t.begin(), t.end(), [](std::size_t v) { return v >= 96; }));
        return apexes > 0;
      });
  const Labelled s(cone, [](const Point& p) { return p.z() < 1.1 ? 1 : 2; });
  ASSERT_EQ(s.result.borders.size(), 1u);
  EXPECT_EQ(s.result.borders[0].outcome, Label_border_outcome::CLOSED_GEODESIC);
  EXPECT_NEAR(s.result.borders[0].length, 48 * std::sin(CGAL_PI / 24), 1e-9);
  EXPECT_EQ(s.labels_left(), std::set<int>{2});
}

TEST(Label_borders, one_label_has_no_border)
{
  const Labelled s(test_meshes::square_ring(), [](const Point&) { return 7; });
  EXPECT_TRUE(s.result.borders.empty());
  ASSERT_EQ(s.result.parts.size(), 1u);
  EXPECT_EQ(s.result.labels, std::vector<int>{7});
  EXPECT_EQ(s.old_labels, s.new_labels);
}

// Names as labels, a mesh without indices, and the same map for both.
TEST(Label_borders, labels_are_of_any_type_with_an_order)
{
  typedef CGAL::Polyhedron_3<test_meshes::Kernel> Polyhedron;
  typedef boost::graph_traits<Polyhedron>::face_descriptor Face;
  const Polyhedron mesh = test_meshes::make_graph<Polyhedron>(test_meshes::boxes_with_tube(3));
  std::map<Face, std::string> labels;
  for(Face f : faces(mesh))
    labels[f] = halfedge(f, mesh)->vertex()->point().x() < 3.5 ? "thigh" : "calf";
  const auto map = boost::make_assoc_property_map(labels);
  const auto result = SMC::tighten_label_borders(mesh, map, map, CGAL::parameters::default_values());
  ASSERT_EQ(result.borders.size(), 1u);
  EXPECT_EQ(result.borders[0].labels, (std::array<std::string, 2>{{"calf", "thigh"}}));
  EXPECT_NEAR(result.borders[0].length, 4, 1e-12);
  EXPECT_EQ(std::set<std::string>(result.labels.begin(), result.labels.end()),
            (std::set<std::string>{"calf", "thigh"}));
}

TEST(Label_borders, without_certificates_on_demand)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::boxes_with_tube(3));
  std::vector<int> labels;
  for(Mesh::Face_index f : mesh.faces())
    labels.push_back(centre(mesh, f).x() < 3.5 ? 1 : 2);
  const auto map = CGAL::make_property_map(labels);
  const Result result = SMC::tighten_label_borders(mesh, map, map, SMC::parameters::certify(false));
  ASSERT_EQ(result.borders.size(), 1u);
  EXPECT_EQ(result.borders[0].certificate.verdict, Certificate_verdict::NOT_COMPUTED);
  EXPECT_NEAR(result.borders[0].length, 4, 1e-12);
}

// Two squares around a box that cross, as tight courses: the one that is foremost stays, and the old course of the
// other one, too, if that does not cross.
TEST(Label_borders, of_closed_borders_that_cross_the_foremost_stays)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(4, 4, 4));
  std::map<Point, Mesh::Vertex_index> at;
  for(Mesh::Vertex_index v : mesh.vertices())
    at[mesh.point(v)] = v;
  // around the box at a height, or at a place along x
  const auto square = [&](bool is_level, int place) {
    SMC::internal::Border_courses<Mesh>::Course course;
    const auto add = [&](int u, int v) {
      course.push_back({true, at.at(is_level ? Point(u, v, place) : Point(place, u, v)), Mesh::null_halfedge(), 0});
    };
    for(int i = 0; i < 4; ++i)
      add(i, 0);
    for(int i = 0; i < 4; ++i)
      add(4, i);
    for(int i = 4; i > 0; --i)
      add(i, 4);
    for(int i = 4; i > 0; --i)
      add(0, i);
    return course;
  };
  typedef SMC::internal::Border_arranger<Mesh> Arranger;
  for(const bool reverses : {false, true})
  {
    std::vector<SMC::internal::Border_courses<Mesh>> borders(3);
    borders[0] = {true, square(true, 2), 16, square(true, 3)};
    borders[1] = {true, square(false, 2), 16, square(false, 1)};
    borders[2] = {true, square(true, 1), 16, {}};
    std::size_t asked = 0;
    const Arranger arranger(mesh, borders, [&](std::vector<std::size_t>& closed) {
      ++asked;
      EXPECT_EQ(closed, (std::vector<std::size_t>{0, 1, 2}));
      if(reverses)
        closed = {1, 0, 2};
    });
    EXPECT_EQ(asked, 1u);
    EXPECT_EQ(arranger.course(0), reverses ? Arranger::Course::NONE : Arranger::Course::TIGHT);
    EXPECT_EQ(arranger.course(1), reverses ? Arranger::Course::TIGHT : Arranger::Course::NONE);
    EXPECT_EQ(arranger.course(2), reverses ? Arranger::Course::NONE : Arranger::Course::TIGHT);
    EXPECT_EQ(arranger.crossed(reverses ? 0 : 1), reverses ? 1u : 0u);
  }
  // the old course is beside the one that it crosses
  std::vector<SMC::internal::Border_courses<Mesh>> borders(2);
  borders[0] = {true, square(true, 2), 16, {}};
  borders[1] = {true, square(false, 2), 16, square(true, 3)};
  const Arranger arranger(mesh, borders, [](std::vector<std::size_t>&) {});
  EXPECT_EQ(arranger.course(1), Arranger::Course::OLD);
}

// Notes which face each face of the split mesh comes from.
struct Ancestry : public SMC::Split_visitor_base<Mesh>
{
  std::map<Mesh::Face_index, Mesh::Face_index>* old_face;
  Mesh::Face_index* split;
  void before_subface_creations(Mesh::Face_index f, const Mesh&) const { *split = f; }
  void after_subface_created(Mesh::Face_index f, const Mesh&) const { (*old_face)[f] = *split; }
};

// Everything that holds for any labels on a closed mesh.
void expect_consistent(const Labelled& s)
{
  const double area = PMP::area(s.mesh), volume = PMP::volume(s.mesh);
  double sum = 0;
  std::size_t number_of_faces = 0;
  for(const SMC::Surface_part& p : s.result.parts)
  {
    sum += p.area;
    number_of_faces += p.number_of_faces;
  }
  EXPECT_NEAR(sum, area, 1e-11 * area);
  EXPECT_EQ(number_of_faces, s.mesh.num_faces());

  for(const Border& b : s.result.borders)
  {
    EXPECT_LT(b.labels[0], b.labels[1]);
    EXPECT_LE(b.length, b.old_length * (1 + 1e-12));
    switch(b.outcome)
    {
    case Label_border_outcome::CLOSED_GEODESIC:
      EXPECT_TRUE(b.is_closed);
      EXPECT_TRUE(SMC::certify_constriction(s.mesh, b.curve).is_certified());
      break;
    case Label_border_outcome::GEODESIC_ARC:
      EXPECT_FALSE(b.is_closed);
      EXPECT_EQ(b.certificate.verdict, Certificate_verdict::GEODESIC_ARC) << b.certificate;
      EXPECT_EQ(b.locations.front().vertex, b.old_vertices.front());
      EXPECT_EQ(b.locations.back().vertex, b.old_vertices.back());
      break;
    case Label_border_outcome::DEGENERATE:
      EXPECT_TRUE(b.vanishing_label == b.labels[0] || b.vanishing_label == b.labels[1]);
      EXPECT_TRUE(b.locations.empty());
      break;
    case Label_border_outcome::CROSSING:
      EXPECT_TRUE(b.crossed_border);
      break;
    default:
      break;
    }
  }

  Mesh split = s.mesh;
  auto marks = split.add_property_map<Mesh::Edge_index, bool>("e:marks", false).first;
  std::map<Mesh::Face_index, Mesh::Face_index> old_face;
  for(Mesh::Face_index f : s.mesh.faces())
    old_face[f] = f;
  Mesh::Face_index current;
  Ancestry ancestry;
  ancestry.old_face = &old_face;
  ancestry.split = &current;
  const SMC::Split_curves<Mesh> curves = SMC::split_along_label_borders(
      split, s.result.borders, CGAL::parameters::edge_is_constrained_map(marks).visitor(ancestry));
  for(std::size_t i = 0; i < s.result.borders.size(); ++i) // none cross
    EXPECT_EQ(curves.outcomes[i].is_used, !s.result.borders[i].locations.empty());

  std::vector<Mesh> parts;
  SMC::extract_parts(split, marks, std::back_inserter(parts));
  EXPECT_EQ(parts.size(), s.result.parts.size());
  double sum_of_volumes = 0;
  for(const Mesh& part : parts)
  {
    EXPECT_TRUE(CGAL::is_closed(part));
    sum_of_volumes += PMP::volume(part);
  }
  EXPECT_NEAR(sum_of_volumes, volume, 1e-11 * std::pow(area, 1.5));

  // Pieces of faces whose label has changed hang together with an old border. The label of a piece is that of most of
  // its part.
  std::vector<std::size_t> part_of_face(split.num_faces());
  const std::size_t n = PMP::connected_components(split, CGAL::make_property_map(part_of_face),
                                                  CGAL::parameters::edge_is_constrained_map(marks));
  std::vector<std::map<int, double>> shares(n);
  for(Mesh::Face_index f : split.faces())
    shares[part_of_face[f]][s.new_labels[old_face.at(f)]] += PMP::face_area(f, split);
  const auto new_label = [&](Mesh::Face_index f) {
    const std::map<int, double>& share = shares[part_of_face[f]];
    return std::max_element(share.begin(), share.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  };
  std::set<Mesh::Face_index> changed;
  for(Mesh::Face_index f : split.faces())
    if(new_label(f) != s.old_labels[old_face.at(f)])
      changed.insert(f);
  while(!changed.empty())
  {
    std::vector<Mesh::Face_index> stack = {*changed.begin()};
    changed.erase(changed.begin());
    bool is_at_border = false;
    while(!stack.empty())
    {
      const Mesh::Face_index f = stack.back();
      stack.pop_back();
      for(auto h : CGAL::halfedges_around_face(split.halfedge(f), split))
      {
        const Mesh::Face_index g = split.face(split.opposite(h));
        is_at_border = is_at_border || s.old_labels[old_face.at(g)] != s.old_labels[old_face.at(f)];
        if(changed.erase(g) != 0)
          stack.push_back(g);
      }
    }
    EXPECT_TRUE(is_at_border);
  }
}

TEST(Label_borders, random_ragged_labels_on_real_meshes)
{
  std::size_t geodesics = 0, arcs = 0, degenerate = 0, others = 0;
  for(const char* name : {"cactus.off", "hand.off", "eight.off", "elephant.off", "couplingdown.off", "bull.off",
                          "camel.off", "homer.off", "cow.off", "knot1.off"})
  {
    const Mesh mesh = real_meshes::read(name);
    for(const int number : {2, 5, 12})
    {
      SCOPED_TRACE(std::string(name) + ", labels: " + std::to_string(number));
      seeded_random::Random random(static_cast<std::size_t>(number));
      const Labelled s(mesh, random_labels::ragged_voronoi(mesh, number, random));
      expect_consistent(s);
      for(const Border& b : s.result.borders)
        ++(b.outcome == Label_border_outcome::CLOSED_GEODESIC ? geodesics
           : b.outcome == Label_border_outcome::GEODESIC_ARC  ? arcs
           : b.outcome == Label_border_outcome::DEGENERATE    ? degenerate
                                                              : others);
    }
  }
  EXPECT_GT(geodesics, 20u);
  EXPECT_GT(arcs, 200u);
  EXPECT_GT(degenerate, 200u);
  EXPECT_LT(others, 10u);
}

// What a user has: the borders of CGAL's segmentation are ragged.
TEST(Label_borders, of_a_segmentation_by_shape_diameter_get_shorter_and_do_not_cross)
{
  for(const char* name : {"elephant.off", "cactus.off", "camel.off"})
  {
    SCOPED_TRACE(name);
    const Mesh mesh = real_meshes::read(name);
    std::vector<double> diameters(mesh.num_faces());
    CGAL::sdf_values(mesh, CGAL::make_property_map(diameters));
    std::vector<std::size_t> segments(mesh.num_faces());
    CGAL::segmentation_from_sdf_values(mesh, CGAL::make_property_map(diameters), CGAL::make_property_map(segments));
    const Labelled s(mesh, {segments.begin(), segments.end()});
    EXPECT_FALSE(s.result.borders.empty());
    expect_consistent(s);
    double before = 0, after = 0;
    for(const Border& b : s.result.borders)
    {
      EXPECT_NE(b.outcome, Label_border_outcome::CROSSING);
      before += b.old_length;
      after += b.length;
    }
    EXPECT_LT(after, 0.9 * before);
  }
}

TEST(Label_borders, random_labels_on_a_mesh_with_holes)
{
  const Mesh mesh = real_meshes::read("elephant-with-holes.off");
  const double area = PMP::area(mesh);
  for(std::size_t seed = 0; seed < 5; ++seed)
  {
    seeded_random::Random random(seed);
    const Labelled s(mesh, random_labels::ragged_voronoi(mesh, 6, random));
    double sum = 0;
    for(const SMC::Surface_part& p : s.result.parts)
      sum += p.area;
    EXPECT_NEAR(sum, area, 1e-11 * area);
    for(const Border& b : s.result.borders)
      EXPECT_LE(b.length, b.old_length * (1 + 1e-12));
  }
}

} // namespace test_label_borders
