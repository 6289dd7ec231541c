// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/colours.h"
#include "output/curve_of_report.h"
#include "output/little_endian.h"

#include <cstddef>
#include <cstdint>
#include <sstream>

namespace constrictions {

std::string report_as_ply(const Report& report)
{
  std::string vertices, edges;
  std::uint32_t n = 0;
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const Constriction& c = report.constrictions[id];
    const std::vector<Mesh::Point> points = points_of_curve(report, id);
    const std::uint32_t first = n, size = static_cast<std::uint32_t>(points.size());
    for(const Mesh::Point& p : points)
    {
      for(int i = 0; i < 3; ++i)
        append_little_endian(p[i], vertices);
      append_little_endian(n, edges);
      append_little_endian(first + (n + 1 - first) % size, edges);
      for(std::uint8_t x : side_colour(c.side()))
        append_little_endian(x, vertices);
      ++n;
    }
  }
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\ncomment constrictions of a surface, coloured by what they choke\n"
         << "element vertex " << n << "\nproperty double x\nproperty double y\nproperty double z\n"
         << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         << "element edge " << n << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  return header.str() + vertices + edges;
}

} // namespace constrictions
