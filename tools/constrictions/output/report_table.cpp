// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/curve_of_report.h"
#include "output/mesh_json.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

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

// Why curves are not certified, a line for each.
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

std::string with_digits(int digits, double x)
{
  std::ostringstream out;
  out << std::setprecision(digits) << x;
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

// A column of the table, with what it says about one curve.
struct Column
{
  std::string heading;
  std::size_t width;
  std::string text;
};

// The columns without `is_verbose` are as wide as a terminal together: a further one belongs to those with it.
std::vector<Column> columns(const Report& report, std::size_t id, bool is_verbose)
{
  const Constriction& c = report.constrictions[id];
  const bool is_proved = !std::isnan(c.prominence_interval()[0]); // in place of the diameter, for the width
  const bool is_held = report.is_girth && !c.certificate().is_certified();
  std::vector<Column> result = {{"id", 3, std::to_string(id)},
                                {"length", 12, with_digits(6, c.length())},
                                is_proved ? Column{"at least", 10, rounded(c.prominence_interval()[0])}
                                          : Column{"diameter", 10, with_digits(4, c.diameter())},
                                {"prominence", 11, prominence(c)},
                                {"roundness", 10, rounded(c.roundness())},
                                {"separating", 11,
                                 c.is_rim()          ? "rim"
                                 : c.is_separating() ? "yes"
                                                     : "no"},
                                {"certificate", 12, is_held ? "held" : name(c.certificate())},
                                {"side", 11, side_name(c.side())}};
  if(is_verbose)
  {
    result.push_back({"pivots", 7, std::to_string(c.pivots().size())});
    result.push_back({"seed level", 11, std::to_string(c.seeds().front().level)});
    result.push_back({"  centroid", 0, "  " + as_text(c.centroid())}); // it begins at one place, not ends
  }
  return result;
}

// Each text ends where its column does. What is too long for a column takes blanks from the next one.
std::string table_line(const std::vector<Column>& columns, std::string Column::*text)
{
  std::string line;
  std::size_t end = 0;
  for(const Column& column : columns)
  {
    end += column.width;
    const std::size_t length = line.size() + (column.*text).size();
    line.append(length < end ? end - length : 0, ' ');
    line += column.*text;
  }
  return line + '\n';
}

// Which curves belong to which landmark, or why there is none; a line for each.
std::string landmarks_as_text(const Report& report)
{
  std::ostringstream out;
  for(std::size_t i = 0; i < report.landmarks.size(); ++i)
  {
    const Landmark_answer& a = report.landmarks[i];
    out << "landmark " << (a.landmark.name.empty() ? std::to_string(i) : a.landmark.name) << ':';
    for(std::size_t id : a.curves)
      out << ' ' << id;
    if(a.curves.empty())
      out << " none. " << a.hint;
    out << '\n';
  }
  return out.str();
}

} // namespace

std::string report_as_table(const Report& report, bool is_verbose)
{
  std::ostringstream out;
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
  {
    const std::vector<Column> line = columns(report, id, is_verbose);
    out << (id == 0 ? table_line(line, &Column::heading) : "") << table_line(line, &Column::text);
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
    out << sections_as_text(report) << landmarks_as_text(report) << n << (n == 1 ? " loop\n" : " loops\n");
    if(!report.hint.empty())
      out << report.hint << '\n';
    return out.str();
  }
  out << landmarks_as_text(report) << n << (n == 1 ? " constriction" : " constrictions") << " from " << s.seeds
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
