// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"
#include "compute/note_tightened.h"

#include "input/input_file.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <cstddef>
#include <string>
#include <utility>

namespace constrictions {

void tighten_through_places(const std::string& file, const Place_loops& loops, bool certifies, Stage_monitor& monitor,
                            Report& report)
{
  using namespace CGAL::Surface_mesh_constrictions;

  report.statistics.seeds = loops.places.size();
  monitor.begin(Detection_stage::TIGHTENING, loops.places.size());
  for(std::size_t i = 0; i < loops.places.size(); ++i)
  {
    const std::string line = "line " + std::to_string(loops.lines[i]);
    Held_loop held;
    held.line = loops.lines[i];
    try
    {
      held.loop = geodesic_loop_through_locations(report.mesh, loops.places[i], parameters::certify(certifies));
    }
    catch(const Invalid_input& e)
    {
      if(e.defect() != Input_defect::INVALID_LOOP && e.defect() != Input_defect::INVALID_LOCATION)
        throw;
      throw Input_file_error(file, line + ": " + e.what());
    }
    const std::string loop = "loop on " + line;
    if(held.loop.let_go.verdict == Tightening_verdict::CLOSED_GEODESIC)
      held.constriction = report.constrictions.size();
    note_tightened(held.loop.let_go, loop, report);
    report.remarks.push_back(loop + ": held at its places it is " + std::to_string(held.loop.length) + " long" +
                             (held.loop.is_simple ? "" : ", and crosses or touches itself"));
    report.held_loops.push_back(std::move(held));
    monitor.step(i + 1);
  }
  monitor.end(Detection_stage::TIGHTENING);
}

} // namespace constrictions
