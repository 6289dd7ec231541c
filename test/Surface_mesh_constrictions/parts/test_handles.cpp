// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that are cut and tunnels that are filled, until the genus is the one asked for.
#include "include/grid_torus.h"
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/sanitizers.h"
#include "include/seeded_random.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/cut_handles.h>
#include <CGAL/Surface_mesh_constrictions/remove_handles.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_handles {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
using test_meshes::make_mesh;
using test_meshes::Mesh;
using test_meshes::Soup;

typedef SMC::Constriction<Mesh> Curve;
typedef SMC::Removed_handle<Mesh::Point> Handle;

template <class Graph>
std::size_t number_of_components(const Graph& mesh)
{
  return PMP::connected_components(mesh, get(CGAL::dynamic_face_property_t<std::size_t>(), mesh));
}

// With the holes filled.
template <class Graph>
std::size_t genus(const Graph& mesh, std::size_t holes = 0)
{
  const long characteristic = static_cast<long>(std::distance(vertices(mesh).begin(), vertices(mesh).end())) -
                              static_cast<long>(std::distance(edges(mesh).begin(), edges(mesh).end())) +
                              static_cast<long>(std::distance(faces(mesh).begin(), faces(mesh).end()) + holes);
  return static_cast<std::size_t>(static_cast<long>(number_of_components(mesh)) - characteristic / 2);
}

struct Limits
{
  std::size_t genus = 0;
  std::size_t number = 1000;
  double length = std::numeric_limits<double>::infinity();
};

std::vector<Handle> removed(Mesh& mesh, const Limits& limits)
{
  std::vector<Handle> result;
  SMC::remove_handles(mesh, std::back_inserter(result),
                      SMC::parameters::target_genus(limits.genus)
                          .maximum_number_of_handles(limits.number)
                          .maximum_curve_length(limits.length)
                          .certify(false));
  return result;
}

// With those of little prominence, and those that cross others.
std::vector<Curve> many_constrictions(const Mesh& mesh)
{
  std::vector<Curve> result;
  SMC::detect_constrictions(mesh, std::back_inserter(result),
                            SMC::parameters::certify(false, SMC::parameters::crossing_constrictions(
                                                                true, SMC::parameters::minimum_prominence(0.01))));
  return result;
}

// What holds after any removal of handles of a closed surface.
template <class Graph, class Handles>
void expect_removed(const Graph& before, const Graph& after, const Handles& handles)
{
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(after));
  EXPECT_TRUE(CGAL::is_triangle_mesh(after));
  EXPECT_TRUE(CGAL::is_closed(after));
  EXPECT_EQ(genus(after) + handles.size(), genus(before));
  EXPECT_EQ(number_of_components(after), number_of_components(before));
  double change = 0;
  bool any_intersects = false;
  for(const auto& h : handles)
  {
    change += h.volume_change;
    any_intersects = any_intersects || h.caps_intersect[0] || h.caps_intersect[1];
    EXPECT_GT(h.cap_areas[0], 0);
    EXPECT_GT(h.cap_areas[1], 0);
    EXPECT_GT(h.length, 0);
    EXPECT_GE(h.points.size(), 3u);
  }
  const double volume = CGAL::to_double(PMP::volume(before));
  EXPECT_NEAR(CGAL::to_double(PMP::volume(after)), volume + change, 1e-9 * std::abs(volume));
  EXPECT_TRUE(PMP::does_self_intersect(before) || PMP::does_self_intersect(after) == any_intersects);
  EXPECT_TRUE(any_intersects || !PMP::does_bound_a_volume(before) || PMP::does_bound_a_volume(after));
}

TEST(Handles, a_torus_is_cut_at_its_thinnest_place)
{
  const Mesh torus = make_mesh(test_meshes::torus(0, 1, 30, 14, 0.3));
  Mesh mesh = torus;
  const std::vector<Handle> handles = removed(mesh, {});
  ASSERT_EQ(handles.size(), 1u);
  expect_removed(torus, mesh, handles);
  EXPECT_EQ(handles[0].side, SMC::Side::OBJECT);
  EXPECT_NEAR(handles[0].length, 2 * 14 * std::sin(CGAL_PI / 14) * 0.7, 1e-2);
  // a slice of the tube, one fiftieth of its length, or less
  const double area = 7 * std::sin(2 * CGAL_PI / 14) * 0.49;
  EXPECT_NEAR(handles[0].cap_areas[0], area, 0.01 * area);
  EXPECT_NEAR(handles[0].cap_areas[1], area, 0.01 * area);
  EXPECT_LT(handles[0].volume_change, 0);
  EXPECT_GE(handles[0].volume_change, -1.01 * 0.02 * handles[0].length * area);
}

TEST(Handles, a_tunnel_is_filled)
{
  const Mesh torus = make_mesh(test_meshes::torus(0.1, 3));
  Mesh mesh = torus;
  std::vector<Handle> handles;
  SMC::cut_handles(mesh, many_constrictions(mesh), std::back_inserter(handles),
                   SMC::parameters::choked_side(SMC::Side::COMPLEMENT));
  ASSERT_EQ(handles.size(), 1u);
  expect_removed(torus, mesh, handles);
  EXPECT_EQ(handles[0].side, SMC::Side::COMPLEMENT);
  EXPECT_GT(handles[0].volume_change, 0);
  EXPECT_GT(handles[0].cap_areas[0], 0.8 * CGAL_PI * 4); // the inner equator has a radius of 2, about
}

TEST(Handles, side_length_and_number_limit_what_is_cut)
{
  const Mesh plate = make_mesh(test_meshes::two_holes()); // bars of 1 x 1, which are shorter than the holes of 2 x 3
  const std::vector<Curve> curves = many_constrictions(plate);
  const auto number = [&](const auto& np) {
    Mesh mesh = plate;
    std::vector<Handle> handles;
    SMC::cut_handles(mesh, curves, std::back_inserter(handles), np);
    expect_removed(plate, mesh, handles);
    for(std::size_t i = 0; i < handles.size(); ++i)
    {
      EXPECT_LE(i == 0 ? 0 : handles[i - 1].length, handles[i].length);
      EXPECT_EQ(handles[i].length, curves[handles[i].curve].length());
    }
    return handles.size();
  };
  namespace params = SMC::parameters;
  EXPECT_EQ(number(CGAL::parameters::default_values()), 2u);
  EXPECT_EQ(number(params::maximum_number_of_handles(std::size_t(1))), 1u);
  EXPECT_EQ(number(params::maximum_number_of_handles(std::size_t(0))), 0u);
  EXPECT_EQ(number(params::maximum_curve_length(4.5)), 2u);
  EXPECT_EQ(number(params::maximum_curve_length(3.5)), 0u);
  for(SMC::Side side : {SMC::Side::OBJECT, SMC::Side::COMPLEMENT, SMC::Side::MIXED})
  {
    Mesh mesh = plate;
    std::vector<Handle> handles;
    SMC::cut_handles(mesh, curves, std::back_inserter(handles), params::choked_side(side));
    expect_removed(plate, mesh, handles);
    for(const Handle& h : handles)
      EXPECT_EQ(h.side, side);
  }
}

TEST(Handles, a_genus_above_that_of_the_mesh_is_refused)
{
  const Soup soup = test_meshes::two_holes();
  Mesh mesh = make_mesh(soup);
  EXPECT_THROW(removed(mesh, {3, 1000}), std::invalid_argument);
  EXPECT_EQ(mesh.number_of_faces(), soup.faces.size());
  EXPECT_TRUE(removed(mesh, {2, 1000}).empty());
  EXPECT_TRUE(removed(mesh, {0, 0}).empty());
  EXPECT_TRUE(removed(mesh, {0, 1000, 1}).empty());
  EXPECT_EQ(mesh.number_of_faces(), soup.faces.size());
}

TEST(Handles, of_all_components)
{
  const Soup soup = test_meshes::joined(test_meshes::joined(test_meshes::torus(0.1, 1), test_meshes::box(2, 2, 2), 20),
                                        test_meshes::two_holes(), 40);
  Mesh mesh = make_mesh(soup);
  const std::vector<Handle> handles = removed(mesh, {});
  EXPECT_EQ(handles.size(), 3u);
  expect_removed(make_mesh(soup), mesh, handles);
}

TEST(Handles, holes_of_the_mesh_stay)
{
  Mesh mesh = make_mesh(open_meshes::without_star(open_meshes::without_star(test_meshes::torus(0.2, 7), 7), 200));
  PMP::remove_isolated_vertices(mesh);
  const auto number_of_holes = [](const Mesh& m) {
    std::vector<Mesh::Halfedge_index> holes;
    PMP::extract_boundary_cycles(m, std::back_inserter(holes));
    return holes.size();
  };
  const std::size_t holes = number_of_holes(mesh);
  EXPECT_GT(holes, 1u);
  EXPECT_EQ(genus(mesh, holes), 1u);
  EXPECT_EQ(removed(mesh, {}).size(), 1u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(number_of_holes(mesh), holes);
  EXPECT_EQ(genus(mesh, holes), 0u);
}

// A plate with bores of one cell in random places, no two beside each other, moved a little.
Soup plate_with_bores(std::size_t bores, std::size_t seed)
{
  seeded_random::Random random(seed);
  std::vector<std::pair<int, int>> places;
  for(int i = 0; i < 6; ++i)
    for(int j = 0; j < 4; ++j)
      places.push_back({2 * i + 1, 2 * j + 1});
  random.shuffle(places);
  const std::set<std::pair<int, int>> taken(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(bores));
  const int thickness = 1 + random.integer(3);
  return test_meshes::jittered(test_meshes::voxels({{13, 9, thickness}},
                                                   [&](int i, int j, int) {
                                                     return taken.count({i, j}) == 0;
                                                   }),
                               0.02, static_cast<unsigned>(seed));
}

TEST(Handles, of_random_bodies_of_genus_1_to_20)
{
  for(std::size_t g = 1; g <= 20; g += 1 + g / 4)
  {
    SCOPED_TRACE(g);
    const Mesh body = make_mesh(plate_with_bores(g, g));
    ASSERT_EQ(genus(body), g);
    const std::size_t target = g / 3;
    Mesh mesh = body;
    const std::vector<Handle> handles = removed(mesh, {target});
    EXPECT_EQ(handles.size(), g - target);
    expect_removed(body, mesh, handles);
  }
}

TEST(Handles, of_real_meshes)
{
  std::vector<std::pair<const char*, std::size_t>> meshes = {{"eight.off", 2}, {"elephant.off", 3}};
  if(!sanitizers::are_on)
    meshes.push_back({"cheese.off", 133});
  for(const auto& [name, g] : meshes)
  {
    SCOPED_TRACE(name);
    const Mesh before = real_meshes::read(name);
    ASSERT_EQ(genus(before), g);
    Mesh mesh = before;
    const std::vector<Handle> handles = removed(mesh, {});
    EXPECT_EQ(handles.size(), g);
    expect_removed(before, mesh, handles);
  }
}

// Curves of the user's: along edges, around the tube, and around a square of the grid on the way, so that both
// triangles of the square are between edges of the curve.
template <class Graph>
void expect_cut_along_edges()
{
  const grid_torus::Grid_torus<Graph> torus(8, 6);
  const auto vpm = get(CGAL::vertex_point, torus.mesh);
  for(const auto& curve :
      {torus.meridian(2), torus.equator(3),
       torus.path({{{1, 0}}, {{2, 0}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{1, 3}}, {{1, 4}}, {{1, 5}}})})
  {
    auto data = curve.data();
    data.homology_class = {0};
    for(std::size_t i = 0; i < data.locations.size(); ++i)
      data.length += std::sqrt(CGAL::to_double(CGAL::squared_distance(
          get(vpm, data.locations[i].vertex), get(vpm, data.locations[(i + 1) % data.locations.size()].vertex))));
    Graph mesh = torus.mesh;
    // the copy has other descriptors
    const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> old(vertices(torus.mesh).begin(),
                                                                                  vertices(torus.mesh).end()),
        copied(vertices(mesh).begin(), vertices(mesh).end());
    for(auto& l : data.locations)
      l.vertex = copied[static_cast<std::size_t>(std::find(old.begin(), old.end(), l.vertex) - old.begin())];
    typedef typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type Point;
    std::vector<SMC::Removed_handle<Point>> handles;
    SMC::cut_handles(mesh, std::vector<SMC::Constriction<Graph>>{SMC::Constriction<Graph>(data)},
                     std::back_inserter(handles));
    ASSERT_EQ(handles.size(), 1u);
    expect_removed(torus.mesh, mesh, handles);
    EXPECT_EQ(handles[0].points.size(), data.locations.size());
  }
}

TEST(Handles, along_edges) { expect_cut_along_edges<Mesh>(); }

TEST(Handles, of_a_polyhedron)
{
  expect_cut_along_edges<CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>>();
}

TEST(Handles, a_curve_that_touches_another_or_itself_is_left_out)
{
  const grid_torus::Grid_torus<Mesh> torus(8, 6);
  const auto cut = [&](std::vector<Curve> curves) {
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      auto data = curves[i].data();
      data.length = static_cast<double>(i + 1);
      data.homology_class = {i};
      curves[i] = Curve(data);
    }
    Mesh mesh = torus.mesh;
    std::vector<Handle> handles;
    SMC::cut_handles(mesh, curves, std::back_inserter(handles));
    return handles.size();
  };
  EXPECT_EQ(cut({torus.meridian(0), torus.meridian(2)}), 2u); // as if they were of different classes
  EXPECT_EQ(cut({torus.meridian(0), torus.equator(2)}), 1u);
  EXPECT_EQ(cut({torus.meridian(0), torus.meridian(0)}), 1u);
  EXPECT_EQ(
      cut({torus.path({{{1, 0}}, {{1, 1}}, {{2, 2}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{1, 3}}, {{1, 4}}, {{1, 5}}})}),
      0u);
}

} // namespace test_handles
