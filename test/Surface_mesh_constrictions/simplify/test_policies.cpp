// SPDX-License-Identifier: GPL-3.0-or-later

// The three policies for CGAL's simplification, each used alone with edge_collapse().

#include "include/record_collapses.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Non_face_triangle_stop_predicate.h>
#include <CGAL/Surface_mesh_constrictions/Seed_preserving_placement.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace test_policies {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
using test_meshes::Mesh;

// Whether the ends of an edge have a neighbour in common that is not on one of its two faces.
bool is_on_non_face_triangle(const Mesh& mesh, Mesh::Vertex_index u, Mesh::Vertex_index v)
{
  std::set<Mesh::Vertex_index> of_u;
  for(auto w : CGAL::vertices_around_target(mesh.halfedge(u), mesh))
    of_u.insert(w);
  std::size_t common = 0;
  for(auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    common += of_u.count(w);
  return common > 2;
}

// Notes of each edge that is selected whether it is on a non-face triangle.
struct Stop_watcher : public SMS::Edge_collapse_visitor_base<Mesh>
{
  std::vector<bool>* selected;

  template <class Cost>
  void OnSelected(const SMS::Edge_profile<Mesh>& p, const Cost&, std::size_t, std::size_t)
  {
    selected->push_back(is_on_non_face_triangle(p.surface_mesh(), p.v0(), p.v1()));
  }
};

// The last edge that is selected is on a non-face triangle, no other is.
template <class Cost, class Placement>
void expect_stop_at_first_seed(Mesh& mesh, const Cost& cost, const Placement& placement)
{
  std::vector<bool> selected;
  Stop_watcher watcher;
  watcher.selected = &selected;
  const auto vertices = mesh.number_of_vertices();
  SMS::edge_collapse(mesh, SMC::Non_face_triangle_stop_predicate(),
                     CGAL::parameters::get_cost(cost).get_placement(placement).visitor(watcher));
  ASSERT_GT(selected.size(), 1u);
  EXPECT_TRUE(selected.back());
  EXPECT_EQ(std::count(selected.begin(), selected.end(), true), 1);
  EXPECT_LT(mesh.number_of_vertices(), vertices);
  EXPECT_GT(mesh.number_of_vertices(), 4u);
}

TEST(Policies, StopPredicateStopsAtTheFirstSelectedEdgeOfANonFaceTriangle)
{
  const Mesh dumbbell = test_meshes::make_mesh(test_meshes::dumbbell(0.05, 3));
  Mesh shortest_first = dumbbell, by_quadrics = dumbbell;
  expect_stop_at_first_seed(shortest_first, SMS::Edge_length_cost<Mesh>(), SMS::Midpoint_placement<Mesh>());
  const auto policies = SMC::Garland_heckbert_policies()(by_quadrics);
  expect_stop_at_first_seed(by_quadrics, policies.get_cost(), policies.get_placement());
}

// Compares the wrapper with its base on every edge that is selected.
struct Placement_watcher : public SMS::Edge_collapse_visitor_base<Mesh>
{
  std::size_t *refused, *deferred;

  template <class Cost>
  void OnSelected(const SMS::Edge_profile<Mesh>& p, const Cost&, std::size_t, std::size_t)
  {
    typedef SMS::Midpoint_placement<Mesh> Base;
    const auto wrapped = SMC::Seed_preserving_placement<Base>()(p);
    if(is_on_non_face_triangle(p.surface_mesh(), p.v0(), p.v1()))
    {
      EXPECT_FALSE(static_cast<bool>(wrapped));
      ++*refused;
    }
    else
    {
      ASSERT_TRUE(static_cast<bool>(wrapped));
      EXPECT_EQ(*wrapped, *Base()(p));
      ++*deferred;
    }
  }
};

TEST(Policies, PlacementRefusesSeedEdgesAndDefersElsewhere)
{
  Mesh mesh = test_meshes::make_mesh(test_meshes::torus(0.1, 5));
  std::size_t refused = 0, deferred = 0;
  Placement_watcher watcher;
  watcher.refused = &refused;
  watcher.deferred = &deferred;
  SMS::edge_collapse(
      mesh, [](double, const auto&, std::size_t, std::size_t) { return false; },
      CGAL::parameters::get_cost(SMS::Edge_length_cost<Mesh>())
          .get_placement(SMC::Seed_preserving_placement<SMS::Midpoint_placement<Mesh>>())
          .visitor(watcher));
  EXPECT_GT(refused, 0u);
  EXPECT_GT(deferred, 100u);
  EXPECT_TRUE(mesh.is_valid(false));
}

TEST(Policies, VisitorRecordsZeroLengthEdgesToo)
{
  // CGAL collapses those before it asks anybody
  test_meshes::Soup soup = test_meshes::box(3, 3, 3);
  soup.points[0] = soup.points[soup.faces[0][0] == 0 ? soup.faces[0][1] : soup.faces[0][0]];
  Mesh mesh = test_meshes::make_mesh(soup);
  const auto vertices = mesh.number_of_vertices();
  const SMC::Collapse_record record = record_collapses::record_collapses(mesh);
  EXPECT_EQ(record.collapses.size(), vertices - mesh.number_of_vertices());
  std::set<SMC::Index> removed;
  for(const SMC::Edge_collapse& c : record.collapses)
  {
    EXPECT_EQ(removed.count(c.kept), 0u);
    EXPECT_TRUE(removed.insert(c.removed).second);
    EXPECT_TRUE(mesh.is_removed(Mesh::Vertex_index(c.removed)));
  }
}

} // namespace test_policies
