// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/note_tightened.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <cstddef>
#include <string>

namespace constrictions {

void tighten_loops(const Loops& loops, bool certifies, Stage_monitor& monitor, Report& report)
{
  using namespace CGAL::Surface_mesh_constrictions;

  std::size_t done = 0;
  const auto take = [&](const Tightened_curve<Mesh>& tightened) {
    note_tightened(tightened, "loop on line " + std::to_string(loops.lines[done]), report);
    monitor.step(++done);
  };

  report.statistics.seeds = loops.vertices.size();
  monitor.begin(Detection_stage::TIGHTENING, loops.vertices.size());
  tighten_closed_curves(report.mesh, loops.vertices, boost::make_function_output_iterator(take),
                        parameters::certify(certifies));
  monitor.end(Detection_stage::TIGHTENING);
}

} // namespace constrictions
