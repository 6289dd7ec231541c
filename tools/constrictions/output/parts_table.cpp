// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/parts.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace constrictions {

std::string parts_as_table(const Parts& parts)
{
  using std::setw;

  std::ostringstream out;
  out << setw(5) << "part" << setw(14) << "area" << setw(14) << "volume" << setw(8) << "genus" << setw(12)
      << "boundaries" << '\n';
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
    out << setw(5) << p << setw(14) << parts.parts[p].area << setw(14) << parts.parts[p].volume << setw(8)
        << parts.parts[p].genus << setw(12) << parts.parts[p].boundaries << '\n';
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
  {
    const std::vector<Cap>& caps = parts.parts[p].caps;
    if(std::any_of(caps.begin(), caps.end(), [](const Cap& c) { return c.cuts_part; }))
      out << "part " << p << ": a cap cuts it\n";
    if(parts.parts[p].is_cavity)
      out << "part " << p
          << " is a cavity: it encloses a region outside of the solid, so its volume has the opposite sign\n";
  }
  for(std::size_t c = 0; c < parts.outcomes.size(); ++c)
    if(parts.outcomes[c].crossed_curve != CGAL::Surface_mesh_constrictions::Cut_outcome::none)
      out << "constriction " << c << " does not cut: it crosses constriction " << parts.outcomes[c].crossed_curve
          << '\n';
  const auto cuts =
      std::count_if(parts.outcomes.begin(), parts.outcomes.end(), [](const auto& o) { return o.is_used; });
  out << parts.parts.size() << (parts.parts.size() == 1 ? " part" : " parts") << ", cut along " << cuts << " of "
      << parts.outcomes.size() << (parts.outcomes.size() == 1 ? " constriction\n" : " constrictions\n");
  return out.str();
}

} // namespace constrictions
