// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RECORD_COLLAPSES_H
#define RECORD_COLLAPSES_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace record_collapses {

// Simplifies a mesh as far as that goes.
template <class Graph, class Cost, class Placement, class PointMap>
CGAL::Surface_mesh_constrictions::Collapse_record record_collapses(Graph& graph, const Cost& cost,
                                                                   const Placement& placement, const PointMap& points)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  SMC::Collapse_record record;
  const auto vim = get(boost::vertex_index, graph);
  CGAL::Surface_mesh_simplification::edge_collapse(
      graph, [](double, const auto&, std::size_t, std::size_t) { return false; },
      CGAL::parameters::get_cost(cost).get_placement(placement).vertex_point_map(points).visitor(
          SMC::Collapse_recording_visitor<decltype(vim)>(record, vim)));
  return record;
}

// The same, the shortest edge first.
inline CGAL::Surface_mesh_constrictions::Collapse_record record_collapses(test_meshes::Mesh& mesh)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  return record_collapses(mesh, SMS::Edge_length_cost<test_meshes::Mesh>(),
                          SMS::Midpoint_placement<test_meshes::Mesh>(), get(CGAL::vertex_point, mesh));
}

// The collapses are equal to the bit.
inline void expect_same(const CGAL::Surface_mesh_constrictions::Collapse_record& a,
                        const CGAL::Surface_mesh_constrictions::Collapse_record& b)
{
  ASSERT_EQ(a.collapses.size(), b.collapses.size());
  for(std::size_t i = 0; i < a.collapses.size(); ++i)
  {
    EXPECT_EQ(a.collapses[i].removed, b.collapses[i].removed);
    EXPECT_EQ(a.collapses[i].kept, b.collapses[i].kept);
    EXPECT_EQ(a.collapses[i].point, b.collapses[i].point);
  }
}

} // namespace record_collapses

#endif // RECORD_COLLAPSES_H
