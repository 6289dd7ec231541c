// SPDX-License-Identifier: GPL-3.0-or-later
#include "chosen_seed_sources.h"
#include "computations.h"
#include "selection_parameters.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

#include <iterator>

namespace constrictions {

std::vector<Constriction> detect_with_edge_length(const Mesh& mesh, const Selection& selection, const Search& search,
                                                  Stage_monitor& monitor)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  namespace SMS = CGAL::Surface_mesh_simplification;

  std::vector<Constriction> result;
  const auto policies = CGAL::parameters::get_cost(SMS::Edge_length_cost<SMC::Simplification_mesh>())
                            .get_placement(SMS::Midpoint_placement<SMC::Simplification_mesh>())
                            .visitor(Monitoring_visitor(monitor));
  const auto selected = with_selection(selection, policies);
  SMC::detect_constrictions(mesh, std::back_inserter(result),
                            SMC::parameters::certify(search.certifies, with_seed_sources(search.triangles_only, selected)));
  return result;
}

} // namespace constrictions
