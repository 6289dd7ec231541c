// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/curve_of_report.h"
#include "output/mesh_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>

namespace constrictions {

namespace {

const char* name(const CGAL::Surface_mesh_constrictions::Certificate& certificate)
{
  using CGAL::Surface_mesh_constrictions::Certificate_verdict;
  return certificate.verdict == Certificate_verdict::STRICT_CONSTRICTION ? "strict"
         : certificate.is_certified()                                    ? "not strict"
         : certificate.verdict == Certificate_verdict::NOT_COMPUTED      ? "none"
                                                                         : "open";
}

// Why curves have no certificate that was asked for, a line for each.
std::string open_certificates(const Report& report)
{
  using CGAL::Surface_mesh_constrictions::Certificate_verdict;
  std::ostringstream out;
  for(std::size_t id = 0; id < report.constrictions.size() && !report.is_girth; ++id)
  {
    const auto& certificate = report.constrictions[id].certificate();
    if(!certificate.is_certified() && certificate.verdict != Certificate_verdict::NOT_COMPUTED)
      out << "curve " << id << " is " << certificate << '\n';
  }
  return out.str();
}

std::string rounded(double x)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(3) << x;
  return out.str();
}

std::string short_number(double x)
{
  std::ostringstream out;
  out << std::setprecision(4) << x;
  return out.str();
}

// Three numbers with blanks between them.
std::string as_text(const std::array<double, 3>& point)
{
  std::ostringstream out;
  out << point[0] << ' ' << point[1] << ' ' << point[2];
  return out.str();
}

// Loops that were tightened have none.
std::string prominence(const Constriction& c) { return std::isnan(c.prominence()) ? "-" : rounded(c.prominence()); }

} // namespace

std::string report_as_table(const Report& report, bool is_verbose)
{
  using std::setw;

  std::ostringstream out;
  if(!report.constrictions.empty())
  {
    out << setw(3) << "id" << setw(12) << "length" << setw(10) << "diameter" << setw(11) << "prominence" << setw(10)
        << "roundness" << setw(11) << "separating" << setw(12) << "certificate" << setw(11) << "side";
    if(is_verbose)
      out << setw(7) << "pivots" << setw(11) << "seed level"
          << "  centroid";
    out << '\n';
  }
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const Constriction& c = report.constrictions[id];
    const std::string number = std::to_string(id);
    const int width = (std::max)(3, static_cast<int>(number.size()));
    out << setw(width) << number << setw(15 - width) << c.length() << setw(10) << short_number(c.diameter()) << setw(11)
        << prominence(c) << setw(10) << rounded(c.roundness()) << setw(11)
        << (c.is_rim()          ? "rim"
            : c.is_separating() ? "yes"
                                : "no")
        << setw(12) << (report.is_girth && !c.certificate().is_certified() ? "held" : name(c.certificate())) << setw(11)
        << side_name(c.side());
    if(is_verbose)
      out << setw(7) << c.pivots().size() << setw(11) << c.seeds().front().level << "  " << as_text(c.centroid());
    out << '\n';
  }
  out << open_certificates(report);
  for(const std::string& remark : report.remarks)
    out << remark << '\n';

  if(report.labelling)
  {
    out << borders_as_table(*report.labelling);
    return out.str();
  }
  const std::size_t n = report.constrictions.size();
  const auto& s = report.statistics;
  if(report.is_girth)
  {
    for(std::size_t id = 0; id < n; ++id)
      out << loop_as_text(report, id) << '\n';
    out << n << (n == 1 ? " loop\n" : " loops\n");
    if(!report.hint.empty())
      out << report.hint << '\n';
    return out.str();
  }
  out << n << (n == 1 ? " constriction" : " constrictions") << " from " << s.seeds
      << (s.seeds == 1 ? " seed curve" : " seed curves");
  if(is_verbose)
    out << " (" << s.degenerate << " degenerate, " << s.discarded << " discarded early, " << s.not_simple
        << " not simple, " << s.not_certified << " not certified, " << s.merged << " merged, " << s.not_selected
        << " not selected)";
  out << '\n';
  if(!report.hint.empty())
    out << report.hint << '\n';
  return out.str();
}

} // namespace constrictions
