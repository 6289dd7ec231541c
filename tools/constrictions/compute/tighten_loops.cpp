// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <sstream>
#include <string>

namespace constrictions {

namespace {

// What follows a statement that there is no certificate; empty if none has been computed.
std::string reason(const CGAL::Surface_mesh_constrictions::Certificate& certificate)
{
  using CGAL::Surface_mesh_constrictions::Certificate_verdict;
  if(certificate.verdict == Certificate_verdict::NOT_COMPUTED)
    return "";
  std::ostringstream text;
  text << certificate;
  return text.str().substr(text.str().find(": "));
}

} // namespace

void tighten_loops(const Loops& loops, bool certifies, Stage_monitor& monitor, Report& report)
{
  using namespace CGAL::Surface_mesh_constrictions;

  std::size_t done = 0;
  const auto take = [&](const Tightened_curve<Mesh>& tightened) {
    const std::string loop = "loop on line " + std::to_string(loops.lines[done]);
    switch(tightened.verdict)
    {
    case Tightening_verdict::CLOSED_GEODESIC:
      report.constrictions.push_back(tightened.curve);
      report.statistics.signs = report.statistics.signs + tightened.curve.certificate().signs;
      break;
    case Tightening_verdict::DEGENERATE:
      ++report.statistics.degenerate;
      report.remarks.push_back(loop + ": degenerate, it shortens to a point");
      break;
    case Tightening_verdict::NOT_SIMPLE:
      ++report.statistics.not_simple;
      report.remarks.push_back(loop + ": not simple, it shortens to a curve that crosses or touches itself");
      break;
    case Tightening_verdict::NOT_CERTIFIED:
      ++report.statistics.not_certified;
      report.remarks.push_back(loop + ": not certified, it could not be proved to shorten to a constriction" +
                               reason(tightened.certificate));
      break;
    }
    monitor.step(++done);
  };

  report.statistics.seeds = loops.vertices.size();
  monitor.begin(Detection_stage::TIGHTENING, loops.vertices.size());
  tighten_closed_curves(report.mesh, loops.vertices, boost::make_function_output_iterator(take),
                        parameters::certify(certifies));
  monitor.end(Detection_stage::TIGHTENING);
}

} // namespace constrictions
