// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/mesh_json.h"

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>

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
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
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

// Loops that were tightened have none.
std::string prominence(const Constriction& c) { return std::isnan(c.prominence()) ? "-" : rounded(c.prominence()); }

} // namespace

std::string report_as_table(const Report& report)
{
  using std::setw;

  std::ostringstream out;
  if(!report.constrictions.empty())
    out << setw(5) << "id" << setw(14) << "length" << setw(12) << "prominence" << setw(11) << "roundness" << setw(8)
        << "pivots" << setw(12) << "separating" << setw(12) << "side" << setw(12) << "certificate" << setw(12)
        << "seed level" << '\n';
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const Constriction& c = report.constrictions[id];
    out << setw(5) << id << setw(14) << c.length() << setw(12) << prominence(c) << setw(11) << rounded(c.roundness())
        << setw(8) << c.pivots().size() << setw(12)
        << (c.is_rim()          ? "rim"
            : c.is_separating() ? "yes"
                                : "no")
        << setw(12) << side_name(c.side()) << setw(12) << name(c.certificate()) << setw(12) << c.seeds().front().level
        << '\n';
  }
  out << open_certificates(report);
  for(const std::string& remark : report.remarks)
    out << remark << '\n';

  const std::size_t n = report.constrictions.size();
  const auto& s = report.statistics;
  out << n << (n == 1 ? " constriction" : " constrictions") << " from " << s.seeds
      << (s.seeds == 1 ? " seed curve" : " seed curves") << " (" << s.degenerate << " degenerate, " << s.discarded
      << " discarded early, " << s.not_simple << " not simple, " << s.not_certified << " not certified, " << s.merged
      << " merged, " << s.not_selected << " not selected)\n";
  return out.str();
}

} // namespace constrictions
