// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/curve_of_report.h"
#include "output/mesh_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

// As RFC 4180 says: what has a comma, a quotation mark or the end of a line in it is in quotation marks, and these are
// doubled.
std::string quoted_field(const std::string& text)
{
  if(text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for(char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

std::string field(const char* text) { return quoted_field(text); }
std::string field(const std::string& text) { return quoted_field(text); }
std::string field(bool value) { return value ? "true" : "false"; }
std::string field(std::size_t number) { return std::to_string(number); }

// As in the JSON file; nothing where that has null.
std::string field(double x)
{
  const std::string text = nlohmann::json(x).dump();
  return text == "null" ? "" : text;
}

template <class Number>
std::string field(const std::optional<Number>& number)
{
  return number ? field(*number) : "";
}

// The columns of a curve, each with its name.
std::vector<std::pair<const char*, std::string>> columns(std::size_t id, const Constriction& c,
                                                         const std::string& verdict, const File_numbering& numbering,
                                                         bool has_intervals, bool has_measures)
{
  std::optional<std::size_t> slides_off;
  if(c.slides_off())
    slides_off = numbering.vertex_of(*c.slides_off());
  const Constriction::Seed& seed = c.seeds().front();
  std::vector<std::pair<const char*, std::string>> result = {{"id", field(id)},
                                                             {"length", field(c.length())},
                                                             {"diameter", field(c.diameter())},
                                                             {"centroid_x", field(c.centroid()[0])},
                                                             {"centroid_y", field(c.centroid()[1])},
                                                             {"centroid_z", field(c.centroid()[2])},
                                                             {"normal_x", field(c.normal()[0])},
                                                             {"normal_y", field(c.normal()[1])},
                                                             {"normal_z", field(c.normal()[2])},
                                                             {"prominence", field(c.prominence())},
                                                             {"isolation", field(c.isolation())},
                                                             {"roundness", field(c.roundness())},
                                                             {"isoperimetric_ratio", field(c.isoperimetric_ratio())},
                                                             {"left_area", field(c.areas()[0])},
                                                             {"right_area", field(c.areas()[1])},
                                                             {"left_genus", field(c.genera()[0])},
                                                             {"right_genus", field(c.genera()[1])},
                                                             {"separating", field(c.is_separating())},
                                                             {"side", field(side_name(c.side()))},
                                                             {"rim", field(c.is_rim())},
                                                             {"boundary_share", field(c.boundary_share())},
                                                             {"dominated_by", field(c.dominated_by())},
                                                             {"slides_off", field(slides_off)},
                                                             {"pivots", field(c.pivots().size())},
                                                             {"certificate", field(verdict)},
                                                             {"seed_level", field(seed.level)},
                                                             {"seed_origin", field(origin_name(seed.origin))}};
  if(has_intervals)
  {
    result.emplace_back("prominence_low", field(c.prominence_interval()[0]));
    result.emplace_back("prominence_high", field(c.prominence_interval()[1]));
  }
  if(has_measures)
  {
    result.emplace_back("cap_area", field(c.cap_area()));
    result.emplace_back("left_girth", field(c.side_girths()[0]));
    result.emplace_back("right_girth", field(c.side_girths()[1]));
  }
  return result;
}

} // namespace

std::string report_as_csv(const Report& report)
{
  // an example of a curve has the names, also where no curve was found
  Constriction::Data example;
  example.seeds.push_back({0, {}, CGAL::Surface_mesh_constrictions::Seed_origin::USER});
  const bool has_intervals = std::any_of(report.constrictions.begin(), report.constrictions.end(),
                                         [](const Constriction& c) { return !std::isnan(c.prominence_interval()[0]); });
  const bool has_measures = std::any_of(report.constrictions.begin(), report.constrictions.end(),
                                        [](const Constriction& c) { return !std::isnan(c.cap_area()); });
  std::string out;
  const auto add_line = [&out](const auto& line, const auto& text_of) {
    for(std::size_t i = 0; i < line.size(); ++i)
      out += (i == 0 ? "" : ",") + std::string(text_of(line[i]));
    out += '\n';
  };
  // of places in a file each curve has its place
  std::vector<std::string> landmarks(report.constrictions.size());
  for(std::size_t i = 0; i < report.landmarks.size(); ++i)
    for(std::size_t id : report.landmarks[i].curves)
      landmarks[id] = report.landmarks[i].landmark.name.empty() ? std::to_string(i) : report.landmarks[i].landmark.name;
  const auto line = [&](std::size_t id, const Constriction& c, const std::string& verdict,
                        const std::string& landmark) {
    auto result = columns(id, c, verdict, report.file.numbering, has_intervals, has_measures);
    if(!report.landmarks.empty())
      result.emplace_back("landmark", field(landmark));
    return result;
  };
  add_line(line(0, Constriction(example), "", ""), [](const auto& column) { return column.first; });
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
    add_line(line(id, report.constrictions[id], verdict_on_curve(report, id), landmarks[id]),
             [](const auto& column) { return column.second; });
  return out;
}

} // namespace constrictions
