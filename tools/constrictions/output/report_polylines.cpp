// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include <iterator>
#include <limits>
#include <sstream>

namespace constrictions {

std::string report_as_polylines(const Report& report)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  for(const Constriction& c : report.constrictions)
  {
    std::vector<Mesh::Point> points;
    c.points(report.mesh, std::back_inserter(points));
    points.push_back(Mesh::Point(points.front()));
    out << points.size();
    for(const Mesh::Point& p : points)
      out << ' ' << p;
    out << '\n';
  }
  return out.str();
}

} // namespace constrictions
