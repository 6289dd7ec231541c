// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/detect.h"
#include "include/displaced_curves.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/verify/Arc_verifier.h>
#include <CGAL/Surface_mesh_constrictions/internal/verify/Curve_nodes.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace test_verification {

namespace SMC = CGAL::Surface_mesh_constrictions;
using detection::detect_all_from_triangles;
using real_meshes::read;
using test_meshes::Mesh;
using test_meshes::Soup;
typedef SMC::Constriction<Mesh> Constriction;
typedef SMC::Arc_refusal Refusal;

const char* const names_of_meshes[] = {"cactus.off",    "eight.off", "elephant.off", "camel.off", "man.off",
                                       "armadillo.off", "bull.off",  "dino.off",     "homer.off", "knot2.off"};

std::vector<Mesh> small_meshes()
{
  using namespace test_meshes;
  std::vector<Mesh> result;
  for(const Soup& soup : {boxes_with_tube(1), boxes_with_tube(2), boxes_with_tube(5), square_ring(), torus(0, 0),
                          torus(0.1, 3), torus(0.1, 5), dumbbell(0, 0), dumbbell(0.1, 4), dumbbell(0.1, 7)})
    result.push_back(make_mesh(soup));
  return result;
}

// A curve through the given locations; nothing but them is looked at.
Constriction curve(std::vector<Constriction::Location> locations)
{
  Constriction::Data data;
  data.locations = std::move(locations);
  return Constriction(std::move(data));
}

Constriction::Location vertex(std::size_t v)
{
  return {true, Mesh::Vertex_index(static_cast<Mesh::size_type>(v)), Mesh::Halfedge_index(), 0};
}

Constriction::Location crossing(Mesh::Halfedge_index h, double parameter)
{
  return {false, Mesh::Vertex_index(), h, parameter};
}

// The curve along which the plane z = height cuts the mesh, by the edges that it crosses: those with one end below it.
Constriction horizontal_curve(const Mesh& mesh, double height)
{
  const auto z = [&](Mesh::Vertex_index v) { return mesh.point(v).z(); };
  const auto is_crossed = [&](Mesh::Halfedge_index h) {
    return (z(mesh.source(h)) < height) != (z(mesh.target(h)) < height);
  };
  Mesh::Halfedge_index first = *mesh.halfedges_begin();
  while(!is_crossed(first))
    ++first;
  std::vector<Constriction::Location> locations;
  Mesh::Halfedge_index h = first;
  do
  {
    const double a = z(mesh.source(h)), b = z(mesh.target(h));
    locations.push_back(crossing(h, (height - a) / (b - a)));
    const Mesh::Halfedge_index n = mesh.next(mesh.opposite(h));
    h = is_crossed(n) ? n : mesh.next(n);
  } while(h != first);
  return curve(locations);
}

void expect_all_confirmed(const Mesh& mesh, const std::string& name)
{
  const std::vector<Constriction> curves = detect_all_from_triangles(mesh);
  EXPECT_FALSE(curves.empty()) << name;
  for(const Constriction& c : curves)
  {
    const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(mesh, c);
    EXPECT_TRUE(v.is_confirmed()) << name << ": " << static_cast<int>(v.refusal) << " at " << v.refused_location;
    EXPECT_GE(v.number_of_arcs, c.pivots().size());
    EXPECT_EQ(v.number_of_refused_arcs, 0u);
    EXPECT_LE(v.greatest_excess, 1e-12) << name;
    EXPECT_LE(v.greatest_deviation, 1e-11) << name;
  }
}

TEST(Verification, ConfirmsWhatIsDetectedOnRealMeshes)
{
  for(const char* name : names_of_meshes)
    expect_all_confirmed(read(name), name);
}

TEST(Verification, ConfirmsWhatIsDetectedOnSmallMeshes)
{
  const std::vector<Mesh> meshes = small_meshes();
  for(std::size_t i = 0; i < meshes.size(); ++i)
    expect_all_confirmed(meshes[i], std::to_string(i));
}

// Every curve of `displaced` is a closed path, and refused, for one of the reasons that a path can be refused for.
// Returns how many there are.
std::size_t expect_all_refused(const Mesh& mesh, const std::vector<Constriction>& displaced, const std::string& name)
{
  for(const Constriction& c : displaced)
  {
    const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(mesh, c);
    EXPECT_TRUE(v.refusal == Refusal::SHORTER_PATH || v.refusal == Refusal::OTHER_FACES ||
                v.refusal == Refusal::OTHER_PLACES)
        << name << ": " << static_cast<int>(v.refusal);
    EXPECT_GE(v.number_of_refused_arcs, 1u);
    EXPECT_LT(v.refused_location, c.locations().size());
  }
  return displaced.size();
}

// Displaces every curve of a mesh in every way, one at every stride-th place, and returns how many curves that makes.
std::size_t expect_displacements_refused(const Mesh& mesh, std::size_t stride, const std::string& name)
{
  std::size_t number = 0;
  for(const Constriction& c : detect_all_from_triangles(mesh))
  {
    const displaced_curves::Displacements<Mesh> displacements(mesh, c, stride);
    number += expect_all_refused(mesh, displacements.through_neighbours(), name + " through a neighbour");
    for(double share : {0.5, 1e-3})
    {
      number += expect_all_refused(mesh, displacements.around_pivots(share), name + " around a pivot");
      number += expect_all_refused(mesh, displacements.with_moved_crossings(share), name + " with a moved crossing");
    }
  }
  return number;
}

TEST(Verification, RefusesDisplacedCurvesOnSmallMeshes)
{
  const std::vector<Mesh> meshes = small_meshes();
  for(std::size_t i = 0; i < meshes.size(); ++i)
    EXPECT_GE(expect_displacements_refused(meshes[i], 1, std::to_string(i)), 20u);
}

TEST(Verification, RefusesDisplacedCurvesOnRealMeshes)
{
  for(const char* name : names_of_meshes)
    EXPECT_GE(expect_displacements_refused(read(name), 7, name), 30u);
}

TEST(Verification, DoesNotDependOnTheLengthOfArcs)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 4));
  for(const Constriction& c : detect_all_from_triangles(mesh))
  {
    const displaced_curves::Displacements<Mesh> displacements(mesh, c, 1);
    for(std::size_t faces = 0; faces < 8; ++faces)
    {
      EXPECT_TRUE(SMC::verify_with_shortest_paths(mesh, c, CGAL::parameters::maximum_number(faces)).is_confirmed());
      for(const Constriction& d : displacements.with_moved_crossings(0.1))
        EXPECT_FALSE(SMC::verify_with_shortest_paths(mesh, d, CGAL::parameters::maximum_number(faces)).is_confirmed());
    }
  }
}

// Around a prism of six sides, up for three of them and down for the others: all is straight but for the two turns.
// Were these the ends of two arcs and not inside others, each arc would be a shortest path.
TEST(Verification, NoCrossingIsOnlyTheEndOfAnArc)
{
  const double height = 2;
  const Mesh mesh = test_meshes::make_mesh(test_meshes::prism(6, height));
  std::vector<Constriction::Location> locations = horizontal_curve(mesh, 0.5).locations();
  ASSERT_EQ(locations.size(), 12u);
  const auto is_vertical = [&](const Constriction::Location& l) {
    const Mesh::Point &p = mesh.point(mesh.source(l.halfedge)), &q = mesh.point(mesh.target(l.halfedge));
    return p.x() == q.x() && p.y() == q.y();
  };
  if(!is_vertical(locations[0]))
    std::rotate(locations.begin(), locations.begin() + 1, locations.end());
  const auto height_at = [](std::size_t side) { return 0.5 + 0.2 * static_cast<double>(side <= 3 ? side : 6 - side); };
  for(std::size_t i = 0; i < 12; ++i)
  {
    const Mesh::Point &p = mesh.point(mesh.source(locations[i].halfedge)),
                      &q = mesh.point(mesh.target(locations[i].halfedge));
    double z = height_at(i / 2);
    if(i % 2 == 1)
    {
      // the diagonal of a side rises from the bottom to the top, either the way the curve goes or against it
      const double from = z, to = height_at(i / 2 + 1);
      const Mesh::Halfedge_index h = locations[i - 1].halfedge; // the vertical edge before
      const Mesh::Vertex_index low =
          p.z() < q.z() ? mesh.source(locations[i].halfedge) : mesh.target(locations[i].halfedge);
      const bool rises = low == mesh.source(h) || low == mesh.target(h);
      const double u = rises ? from / (height - to + from) : (height - from) / (height + to - from);
      z = from + u * (to - from);
    }
    locations[i].parameter = (z - p.z()) / (q.z() - p.z());
  }
  for(std::size_t k = 0; k < 12; ++k)
  {
    const auto verify = [&](std::size_t faces) {
      return SMC::verify_with_shortest_paths(mesh, curve(locations), CGAL::parameters::maximum_number(faces));
    };
    EXPECT_EQ(verify(2).number_of_refused_arcs, 2u); // the ten other crossings are straight
    for(std::size_t faces = 3; faces < 14; ++faces)
      EXPECT_FALSE(verify(faces).is_confirmed());
    std::rotate(locations.begin(), locations.begin() + 1, locations.end());
  }
}

TEST(Verification, NamesTheArcThatWasMoved)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 4));
  const Constriction c = detect_all_from_triangles(mesh).front();
  for(std::size_t i = 0; i < c.locations().size(); ++i)
    if(!c.locations()[i].is_pivot)
    {
      std::vector<Constriction::Location> locations = c.locations();
      locations[i].parameter = 0.9 * locations[i].parameter + 0.05;
      const SMC::Shortest_path_verification v =
          SMC::verify_with_shortest_paths(mesh, curve(locations), CGAL::parameters::maximum_number(2));
      EXPECT_FALSE(v.is_confirmed());
      // patches of two faces: the crossing before, the moved one, the one after
      EXPECT_LE(v.refused_location, i);
      EXPECT_GE(v.refused_location + 1, i);
    }
}

// Closed geodesics without a pivot, in a flat band: whether that leaks is not asked here.
TEST(Verification, ConfirmsABeltWithoutVertices)
{
  const Mesh prism = test_meshes::make_mesh(test_meshes::prism(5, 2));
  const Mesh box = test_meshes::make_mesh(test_meshes::box(3, 4, 5));
  for(std::size_t faces : {std::size_t(2), std::size_t(3), std::size_t(7), std::size_t(16), std::size_t(1000)})
  {
    const auto np = CGAL::parameters::maximum_number(faces);
    EXPECT_TRUE(SMC::verify_with_shortest_paths(prism, horizontal_curve(prism, 0.7), np).is_confirmed());
    EXPECT_TRUE(SMC::verify_with_shortest_paths(box, horizontal_curve(box, 2.3), np).is_confirmed());
  }
}

// Around a pyramid a horizontal curve bends at the edges.
TEST(Verification, RefusesABeltOfACone)
{
  const Mesh cone = test_meshes::make_mesh(test_meshes::sharp_cone());
  const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(cone, horizontal_curve(cone, 5));
  EXPECT_EQ(v.refusal, Refusal::SHORTER_PATH);
  EXPECT_EQ(v.number_of_refused_arcs, v.number_of_arcs);
  EXPECT_GT(v.greatest_excess, 1e-3);
}

// Total angle less than 2 pi: no geodesic passes, not even one that crosses edges beside the vertex by 1e-10.
TEST(Verification, RefusesACurveThroughAConvexVertex)
{
  const Mesh prism = test_meshes::make_mesh(test_meshes::prism(5, 2));
  std::vector<Constriction::Location> rim;
  for(std::size_t v : {0, 1, 4, 6, 8})
    rim.push_back(vertex(v));
  ASSERT_EQ(prism.point(Mesh::Vertex_index(0)).z(), 0);
  for(std::size_t i = 0; i < 5; ++i)
    ASSERT_TRUE(prism.halfedge(rim[i].vertex, rim[(i + 1) % 5].vertex).is_valid());
  EXPECT_EQ(SMC::verify_with_shortest_paths(prism, curve(rim)).refusal, Refusal::SHORTER_PATH);
  EXPECT_EQ(SMC::verify_with_shortest_paths(prism, horizontal_curve(prism, 1e-10)).refusal, Refusal::SHORTER_PATH);
}

// A grid line around a box, along edges and through vertices of total angle 2 pi, given by the ends of the edges on its
// other sides; by vertices; and by vertices and points on the edges between them.
TEST(Verification, ConfirmsACurveThroughFlatVertices)
{
  const Mesh box = test_meshes::make_mesh(test_meshes::box(3, 4, 5));
  for(double height : {2.0, 2.0 + 1e-11, 3.0 - 1e-11})
    EXPECT_TRUE(SMC::verify_with_shortest_paths(box, horizontal_curve(box, height)).is_confirmed()) << height;

  std::vector<Constriction::Location> line, with_points;
  const Constriction crossings = horizontal_curve(box, 2);
  for(const Constriction::Location& l : crossings.locations())
  {
    const Mesh::Vertex_index v = l.parameter == 0 ? box.source(l.halfedge) : box.target(l.halfedge);
    ASSERT_EQ(box.point(v).z(), 2);
    if(line.empty() || (v != line.back().vertex && v != line.front().vertex))
      line.push_back(vertex(v));
  }
  ASSERT_EQ(line.size(), 14u);
  EXPECT_TRUE(SMC::verify_with_shortest_paths(box, curve(line)).is_confirmed());
  for(std::size_t i = 0; i < line.size(); ++i)
  {
    with_points.push_back(line[i]);
    with_points.push_back(crossing(box.halfedge(line[i].vertex, line[(i + 1) % line.size()].vertex), 0.3));
  }
  EXPECT_TRUE(SMC::verify_with_shortest_paths(box, curve(with_points)).is_confirmed());
}

TEST(Verification, RefusesACurveThatTurnsBack)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::tetrahedron());
  EXPECT_EQ(SMC::verify_with_shortest_paths(mesh, curve({vertex(0), vertex(1)})).refusal, Refusal::SHORTER_PATH);
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(1), Mesh::Vertex_index(2));
  const Mesh::Vertex_index a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  EXPECT_EQ(SMC::verify_with_shortest_paths(
                mesh, curve({vertex(a), crossing(h, 0.5), vertex(b), crossing(mesh.opposite(h), 0.5)}))
                .refusal,
            Refusal::SHORTER_PATH);
}

// On a flat square, from one corner to the opposite one and back, over its diagonal both times: at each corner the
// curve leaves through the edge through which it came, before or after the place where it came.
TEST(Verification, RefusesACurveThatTurnsBackBesideWhereItCame)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(2, 2, 2));
  Mesh::Halfedge_index h = *mesh.halfedges_begin();
  while(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))) != 2)
    ++h;
  const Mesh::Vertex_index a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  // from a corner to the middle of the diagonal, to a quarter of it, and from the one to the other
  const double middle = std::sqrt(0.5), quarter = std::sqrt(0.625), between = std::sqrt(0.125);
  for(double parameter : {0.25, 0.75})
  {
    const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(
        mesh, curve({vertex(a), crossing(h, 0.5), vertex(b), crossing(mesh.opposite(h), parameter)}));
    EXPECT_EQ(v.refusal, Refusal::SHORTER_PATH) << parameter;
    EXPECT_EQ(v.refused_location, 0u) << parameter;
    EXPECT_NEAR(v.greatest_excess, 1 - between / (middle + quarter), 1e-12) << parameter;
  }
}

typedef SMC::internal::Curve_nodes<Mesh> Nodes;
typedef SMC::internal::Arc_verifier<test_meshes::Kernel, Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>>
    Arc_verifier;

// Two faces whose common edge ends at a reflex corner, through which the shortest path goes. The arc goes beside that
// corner, longer by less than the tolerance: both meet three things, but not the same ones.
TEST(Verification, APathThroughACornerBesideTheArcIsInOtherFaces)
{
  const Soup soup = {{{{-1, -0.1, 0}}, {{0, 0, 0}}, {{1, -0.1, 0}}, {{0, 1, 0}}}, {{{0, 1, 3}}, {{1, 2, 3}}}};
  const Mesh mesh = test_meshes::make_mesh(soup);
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Vertex_index(1), Mesh::Vertex_index(3));
  const Nodes nodes(mesh, {vertex(0), crossing(h, 6e-9), vertex(2)}, 1e-9);
  ASSERT_EQ(nodes.size(), 3u);
  const SMC::internal::Arc_verdict verdict = Arc_verifier(mesh, mesh.points(), nodes).verify_in_strip(0, 2);
  EXPECT_EQ(verdict.refusal, Refusal::OTHER_FACES);
  EXPECT_NEAR(verdict.excess, 6e-10, 1e-10);
}

// The star of vertex 0, 2e-5 above the line between its neighbours 1 and 3; the neighbour 2, half as far above it, is
// in the way of the straight line, so the shortest path runs along the border of the star and not past its centre.
TEST(Verification, APathAlongTheBorderOfAStarIsInOtherFaces)
{
  const double height = 2e-5;
  const Mesh mesh =
      test_meshes::make_mesh({{{{0, height, 0}}, {{-1, 0, 0}}, {{0, height / 2, 0}}, {{1, 0, 0}}, {{0, 1, 0}}},
                              {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{0, 4, 1}}}});
  const Nodes nodes(mesh, {vertex(1), vertex(0), vertex(3)}, 1e-9);
  const SMC::internal::Arc_verdict verdict = Arc_verifier(mesh, mesh.points(), nodes).verify_in_star(1);
  EXPECT_EQ(verdict.refusal, Refusal::OTHER_FACES);
  EXPECT_NEAR(verdict.excess, 3. / 8 * height * height, 1e-12);
}

TEST(Verification, TellsWhatIsNotAClosedPath)
{
  const Mesh mesh = test_meshes::make_mesh(test_meshes::box(2, 2, 2));
  const Mesh::Halfedge_index h = *mesh.halfedges_begin();
  const std::vector<Constriction> curves = {Constriction(),
                                            curve({vertex(0)}),
                                            curve({vertex(0), vertex(mesh.number_of_vertices() - 1)}),
                                            curve({crossing(h, 0.5)}),
                                            curve({crossing(h, 0.5), crossing(h, 0.25)}),
                                            curve({crossing(h, 0.5), crossing(mesh.next(h), 0.5)}),
                                            curve({crossing(h, 0.5), vertex(mesh.source(h))})};
  for(const Constriction& c : curves)
  {
    const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(mesh, c);
    EXPECT_EQ(v.refusal, Refusal::NOT_A_PATH);
    EXPECT_FALSE(v.is_confirmed());
    EXPECT_EQ(v.number_of_arcs, 0u);
  }
}

TEST(Verification, DoesNotDependOnUnitAndOrigin)
{
  for(double unit : {1e-300, 1e-20, 1e20, 1e300})
    for(double shift : {0.0, 1e5})
    {
      Soup soup = test_meshes::dumbbell(0.1, 4);
      for(test_meshes::Position& p : soup.points)
        for(double& x : p)
          x = unit * (x + shift);
      expect_all_confirmed(test_meshes::make_mesh(soup), std::to_string(unit));
    }
}

TEST(Verification, TakesPointsFromTheVertexPointMap)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 4));
  const std::vector<Constriction> curves = detect_all_from_triangles(mesh);
  auto squeezed = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:squeezed").first;
  for(Mesh::Vertex_index v : mesh.vertices())
    squeezed[v] = Mesh::Point(mesh.point(v).x(), mesh.point(v).y() / 2, mesh.point(v).z());
  for(const Constriction& c : curves)
  {
    EXPECT_TRUE(SMC::verify_with_shortest_paths(mesh, c).is_confirmed());
    EXPECT_FALSE(SMC::verify_with_shortest_paths(mesh, c, CGAL::parameters::vertex_point_map(squeezed)).is_confirmed());
  }
}

TEST(Verification, TakesAPolyhedron)
{
  typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel> Polyhedron;
  const auto mesh = test_meshes::make_graph<Polyhedron>(test_meshes::torus(0.1, 3));
  const auto curves = detect_all_from_triangles(mesh);
  EXPECT_FALSE(curves.empty());
  for(const auto& c : curves)
    EXPECT_TRUE(SMC::verify_with_shortest_paths(mesh, c).is_confirmed());
}

} // namespace test_verification
