// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/curve_of_report.h"

#include <cstddef>
#include <limits>
#include <sstream>
#include <vector>

namespace constrictions {

std::string report_as_obj(const Report& report)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# constrictions of a surface, an object each\n";
  std::size_t first = 1; // as OBJ counts
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const std::vector<Mesh::Point> points = points_of_curve(report, id);
    out << "o constriction_" << id << '\n';
    for(const Mesh::Point& p : points)
      out << "v " << p << '\n';
    // a line for each step: of longer ones Blender 3.4 reads the first step only
    for(std::size_t i = 0; i < points.size(); ++i)
      out << "l " << first + i << ' ' << first + (i + 1) % points.size() << '\n';
    first += points.size();
  }
  return out.str();
}

} // namespace constrictions
