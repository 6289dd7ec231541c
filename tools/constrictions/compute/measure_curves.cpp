// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/measure_constrictions.h>

#include <iterator>
#include <utility>
#include <vector>

namespace constrictions {

void measure_curves(Report& report)
{
  std::vector<Constriction> measured;
  CGAL::Surface_mesh_constrictions::measure_constrictions(report.mesh, report.constrictions,
                                                          std::back_inserter(measured));
  report.constrictions = std::move(measured);
}

} // namespace constrictions
