// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/colours.h"
#include "output/curve_of_report.h"
#include "output/vtp_file.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace constrictions {

std::string report_as_vtp(const Report& report)
{
  Vtp_file file(Vtp_file::LINES);
  std::vector<std::uint8_t> is_pivot;
  std::vector<double> lengths, prominences;
  std::vector<std::int32_t> ids, certificates, sides;
  std::vector<Colour> colours;
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const Constriction& c = report.constrictions[id];
    const std::vector<Mesh::Point> points = points_of_curve(report, id);
    const std::vector<bool> pivots = pivots_of_curve(report, id);
    std::vector<std::size_t> line(points.size());
    std::iota(line.begin(), line.end(), is_pivot.size());
    line.push_back(line.front());
    file.add_cell(line);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      file.add_point(points[i]);
      is_pivot.push_back(pivots[i] ? 1 : 0);
    }
    ids.push_back(static_cast<std::int32_t>(ids.size()));
    lengths.push_back(c.length());
    prominences.push_back(c.prominence());
    certificates.push_back(c.certificate().is_certified() ? 1 : 0);
    sides.push_back(static_cast<std::int32_t>(c.side()));
    colours.push_back(side_colour(c.side()));
  }
  file.add_point_data("is_pivot", is_pivot);
  file.add_cell_data("id", ids);
  file.add_cell_data("length", lengths);
  file.add_cell_data("prominence", prominences);
  file.add_cell_data("is_certified", certificates);
  file.add_cell_data("side", sides);
  file.add_cell_data("colour", colours);
  file.show_cell_data("prominence");
  return file.text();
}

} // namespace constrictions
