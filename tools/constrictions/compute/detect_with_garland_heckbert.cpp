// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/detect_as_asked.h"

#include <CGAL/Named_function_parameters.h>

namespace constrictions {

std::vector<Constriction> detect_with_garland_heckbert(const Mesh& mesh, const Selection& selection,
                                                       const Search& search, Stage_monitor& monitor, Levels* levels)
{
  return detect_as_asked(mesh, selection, search, levels, CGAL::parameters::visitor(Monitoring_visitor(monitor)));
}

} // namespace constrictions
