// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/detect_as_asked.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

namespace constrictions {

std::vector<Constriction> detect_with_lindstrom_turk(const Mesh& mesh, const Selection& selection, const Search& search,
                                                     Stage_monitor& monitor, Levels* levels)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;

  const auto policies = SMC::parameters::simplification_policies(
      SMC::Lindstrom_turk_policies(), CGAL::parameters::visitor(Monitoring_visitor(monitor)));
  return detect_as_asked(mesh, selection, search, levels, policies);
}

} // namespace constrictions
