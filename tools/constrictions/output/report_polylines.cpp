// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/curve_of_report.h"

#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace constrictions {

std::string report_as_polylines(const Report& report)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    std::vector<Mesh::Point> points = points_of_curve(report, id);
    points.push_back(Mesh::Point(points.front()));
    out << points.size();
    for(const Mesh::Point& p : points)
      out << ' ' << p;
    out << '\n';
  }
  if(report.labelling)
    for(const Label_border& border : report.labelling->tightened.borders)
      if(!border.is_closed && !border.locations.empty())
      {
        std::vector<Mesh::Point> points;
        border.points(report.mesh, std::back_inserter(points));
        out << points.size();
        for(const Mesh::Point& p : points)
          out << ' ' << p;
        out << '\n';
      }
  return out.str();
}

} // namespace constrictions
