// SPDX-License-Identifier: GPL-3.0-or-later
#include "computations.h"
#include "detect_as_asked.h"

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

namespace constrictions {

std::vector<Constriction> detect_with_edge_length(const Mesh& mesh, const Selection& selection, const Search& search,
                                                  Stage_monitor& monitor, Levels* levels)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  namespace SMS = CGAL::Surface_mesh_simplification;

  const auto policies = CGAL::parameters::get_cost(SMS::Edge_length_cost<SMC::Simplification_mesh>())
                            .get_placement(SMS::Midpoint_placement<SMC::Simplification_mesh>())
                            .visitor(Monitoring_visitor(monitor));
  return detect_as_asked(mesh, selection, search, levels, policies);
}

} // namespace constrictions
