// SPDX-License-Identifier: GPL-3.0-or-later
#include "computations.h"
#include "selection_parameters.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <iterator>

namespace constrictions {

std::vector<Constriction> detect_with_garland_heckbert(const Mesh& mesh, const Selection& selection,
                                                       Stage_monitor& monitor)
{
  std::vector<Constriction> result;
  CGAL::Surface_mesh_constrictions::detect_constrictions(
      mesh, std::back_inserter(result),
      with_selection(selection, CGAL::parameters::visitor(Monitoring_visitor(monitor))));
  return result;
}

} // namespace constrictions
