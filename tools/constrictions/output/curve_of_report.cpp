// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/curve_of_report.h"

#include "output/certificates.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace constrictions {

using CGAL::Surface_mesh_constrictions::Tightening_verdict;

std::vector<Mesh::Point> points_of_curve(const Report& report, std::size_t id)
{
  std::vector<Mesh::Point> result;
  if(report.is_girth)
    report.loops[id].points(report.mesh, std::back_inserter(result));
  else
    report.constrictions[id].points(report.mesh, std::back_inserter(result));
  return result;
}

std::vector<Constriction::Face_location> locations_of_curve(const Report& report, std::size_t id)
{
  if(report.is_girth)
    return report.loops[id].locations;
  return locations_of_curve(report.mesh, report.constrictions[id]);
}

std::vector<Constriction::Face_location> locations_of_curve(const Mesh& mesh, const Constriction& c)
{
  std::vector<Constriction::Face_location> result;
  c.face_locations(mesh, std::back_inserter(result));
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    Mesh::Halfedge_index h = mesh.halfedge(result[i].first);
    for(std::size_t corner = 0; corner < 3 && !c.locations()[i].is_pivot; ++corner, h = mesh.next(h))
      if(h == c.locations()[i].halfedge || mesh.prev(h) == c.locations()[i].halfedge)
        result[i].second[corner] = (std::max)(result[i].second[corner], (std::numeric_limits<double>::min)());
  }
  return result;
}

std::vector<bool> pivots_of_curve(const Report& report, std::size_t id)
{
  const std::size_t n =
      report.is_girth ? report.loops[id].locations.size() : report.constrictions[id].locations().size();
  std::vector<bool> result(n, false);
  for(const Constriction::Pivot& p : report.constrictions[id].pivots())
    result[p.location] = true;
  return result;
}

std::string verdict_on_curve(const Report& report, std::size_t id)
{
  if(!report.is_girth)
    return certificate_as_text(report.constrictions[id].certificate());
  const Geodesic_loop& loop = report.loops[id];
  if(!loop.is_closed_geodesic)
    return std::string("not_certified: held at point 0, where the side angle on the ") +
           (loop.left_angle <= loop.right_angle ? "left" : "right") + " is less than pi";
  if(loop.pivots.empty() || loop.pivots.front().location != 0)
    return "not_certified: held at point 0, which is not a vertex";
  return certificate_as_text(report.constrictions[id].certificate());
}

const char* end_name(const Geodesic_loop& loop) { return end_name(loop.verdict); }

const char* end_name(Tightening_verdict verdict)
{
  switch(verdict)
  {
  case Tightening_verdict::CLOSED_GEODESIC:
    return "constriction";
  case Tightening_verdict::DEGENERATE:
    return "point";
  case Tightening_verdict::NOT_SIMPLE:
    return "not_simple";
  default:
    return "not_certified";
  }
}

std::string loop_as_text(const Report& report, std::size_t id)
{
  const Geodesic_loop& loop = report.loops[id];
  const Mesh::Point held = points_of_curve(report, id).front();
  std::ostringstream out;
  out << "curve " << id << " is held at " << held << ", where its angle is "
      << (std::min)(loop.left_angle, loop.right_angle);
  switch(loop.verdict)
  {
  case Tightening_verdict::CLOSED_GEODESIC:
    out << "; let go, it becomes a constriction of length " << loop.let_go.length();
    break;
  case Tightening_verdict::DEGENERATE:
    out << "; it encloses a tip: let go, it shrinks to a point";
    break;
  case Tightening_verdict::NOT_SIMPLE:
    out << "; let go, it becomes a curve that crosses or touches itself";
    break;
  case Tightening_verdict::NOT_CERTIFIED:
    out << "; let go, it could not be proved to become a constriction";
    break;
  }
  return out.str();
}

} // namespace constrictions
