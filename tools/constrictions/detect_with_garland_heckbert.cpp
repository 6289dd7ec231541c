// SPDX-License-Identifier: GPL-3.0-or-later
#include "computations.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <iterator>

namespace constrictions {

std::vector<Constriction> detect_with_garland_heckbert(const Mesh& mesh, bool certifies, Stage_monitor& monitor)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;

  std::vector<Constriction> result;
  SMC::detect_constrictions(mesh, std::back_inserter(result),
                            SMC::parameters::certify(certifies).visitor(Monitoring_visitor(monitor)));
  return result;
}

} // namespace constrictions
