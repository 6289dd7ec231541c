// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/note_tightened.h"

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

void note_tightened(const CGAL::Surface_mesh_constrictions::Tightened_curve<Mesh>& tightened, const std::string& loop,
                    Report& report)
{
  using namespace CGAL::Surface_mesh_constrictions;

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
}

} // namespace constrictions
