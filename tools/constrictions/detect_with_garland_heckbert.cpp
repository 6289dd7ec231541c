// SPDX-License-Identifier: GPL-3.0-or-later
#include "chosen_seed_sources.h"
#include "computations.h"
#include "selection_parameters.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <iterator>

namespace constrictions {

std::vector<Constriction> detect_with_garland_heckbert(const Mesh& mesh, const Selection& selection, const Search& search,
                                                       Stage_monitor& monitor)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;

  std::vector<Constriction> result;
  const auto selected = with_selection(selection, CGAL::parameters::visitor(Monitoring_visitor(monitor)));
  SMC::detect_constrictions(mesh, std::back_inserter(result),
                            SMC::parameters::certify(search.certifies, with_seed_sources(search.triangles_only, selected)));
  return result;
}

} // namespace constrictions
