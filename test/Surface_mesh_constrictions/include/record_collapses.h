// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef RECORD_COLLAPSES_H
#define RECORD_COLLAPSES_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>

namespace record_collapses {

// Simplifies a mesh as far as that goes, the shortest edge first.
inline CGAL::Surface_mesh_constrictions::Collapse_record record_collapses(test_meshes::Mesh& mesh)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  namespace SMS = CGAL::Surface_mesh_simplification;
  SMC::Collapse_record record;
  const auto vim = get(boost::vertex_index, mesh);
  SMS::edge_collapse(mesh, [](double, const auto&, std::size_t, std::size_t) { return false; },
                     CGAL::parameters::get_cost(SMS::Edge_length_cost<test_meshes::Mesh>())
                         .get_placement(SMS::Midpoint_placement<test_meshes::Mesh>())
                         .visitor(SMC::Collapse_recording_visitor<decltype(vim)>(record, vim)));
  return record;
}

} // namespace record_collapses

#endif // RECORD_COLLAPSES_H
