// SPDX-License-Identifier: GPL-3.0-or-later

// The policies of this package against CGAL's GarlandHeckbert_plane_policies, which need Eigen.

#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_garland_heckbert {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef SMC::Simplification_mesh Mesh;

// The edges that are collapsed and where to, in order.
struct Collapse_watcher : public SMS::Edge_collapse_visitor_base<Mesh>
{
  struct Collapse
  {
    Mesh::Vertex_index v0, v1;
    Mesh::Point point;

    bool operator==(const Collapse& other) const { return v0 == other.v0 && v1 == other.v1 && point == other.point; }
  };

  std::vector<Collapse>* collapses;

  template <class OptionalPoint>
  void OnCollapsing(const SMS::Edge_profile<Mesh>& p, const OptionalPoint& point)
  {
    collapses->push_back({p.v0(), p.v1(), *point});
  }
};

template <class Policies>
std::vector<Collapse_watcher::Collapse> collapses_of(Mesh mesh, const Policies& make_policies)
{
  std::vector<Collapse_watcher::Collapse> result;
  Collapse_watcher watcher;
  watcher.collapses = &result;
  const auto policies = make_policies(mesh);
  SMS::edge_collapse(
      mesh, [](double, const auto&, std::size_t, std::size_t) { return false; },
      CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()).visitor(watcher));
  return result;
}

// On flat places, where planes have a line in common, and along borders, too.
TEST(GarlandHeckbert, TheDefaultCollapsesTheSameEdgesToTheSamePointsAsThePlanePoliciesOfCGAL)
{
#if !defined(EIGEN_VECTORIZE_SSE2) || defined(EIGEN_VECTORIZE_AVX)
  GTEST_SKIP() << "Eigen adds up products of matrices in another order than on x86-64 without extensions";
#endif
  for(const Mesh& mesh :
      {test_meshes::make_graph<Mesh>(test_meshes::torus(0.1, 5)),
       test_meshes::make_graph<Mesh>(test_meshes::box(7, 5, 4)), test_meshes::torus_with_border<Mesh>()})
  {
    const auto ours = collapses_of(mesh, SMC::Garland_heckbert_policies());
    const auto theirs =
        collapses_of(mesh, [](Mesh& m) { return SMS::GarlandHeckbert_plane_policies<Mesh, test_meshes::Kernel>(m); });
    EXPECT_GT(ours.size(), 90u);
    EXPECT_TRUE(ours == theirs);
  }
}

} // namespace test_garland_heckbert
