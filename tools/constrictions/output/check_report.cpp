// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/check_report.h"

#include "input/input_file.h"
#include "output/mesh_json.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;

template <class F>
void for_each_finding(const Mesh_findings& findings, F f)
{
  for(std::size_t i = 0; i < number_of_findings; ++i)
    if(findings.count(static_cast<Finding>(i)) > 0)
      f(static_cast<Finding>(i));
}

Json number_or_null(double x) { return x > 0 ? Json(x) : Json(); }

} // namespace

std::string check_as_text(const Check_report& report)
{
  std::ostringstream out;
  out << printable(report.mesh_file) << '\n';
  if(report.mesh.number_of_faces() > 0)
  {
    const Json mesh = mesh_as_json(report.mesh_file, report.mesh, report.file);
    for(const char* member : {"vertices", "faces", "triangles", "components", "genus", "holes", "border_edges", "area"})
      out << std::left << std::setw(14) << member << mesh[member] << '\n';
    if(!report.file.unit.empty())
      out << std::left << std::setw(14) << "unit" << report.file.unit << '\n';
  }
  const auto list = [&](const std::string& title, const std::vector<std::string>& places, std::size_t count) {
    out << title << '\n';
    for(const std::string& place : places)
      out << "    " << place << '\n';
    if(places.size() < count && !places.empty())
      out << "    ...\n";
  };
  const Mesh_findings& findings = report.file.findings;
  for_each_finding(findings, [&](Finding finding) {
    list(as_words(finding, findings.count(finding)), findings.places(finding), findings.count(finding));
  });
  if(findings.merging_distance > 0)
    out << "these lie " << findings.nearest << " to " << findings.farthest << " apart: --merge "
        << findings.merging_distance << " merges them\n";
  if(report.flat_triangles > 0)
    out << report.flat_triangles << (report.flat_triangles == 1 ? " triangle" : " triangles") << " without area\n";
  const Slivers& slivers = report.slivers;
  if(slivers.number > 0)
    out << slivers.number << (slivers.number == 1 ? " triangle" : " triangles") << " of almost no height\n    "
        << slivers.worst << '\n';
  if(slivers.with_near_corners > 0)
    out << slivers.with_near_corners << " of these " << (slivers.with_near_corners == 1 ? "has" : "have")
        << " two corners in nearly one place: --merge " << slivers.merging_distance << " merges them\n";
  if(report.self_intersections > 0)
    list(std::to_string(report.self_intersections) +
             (report.self_intersections == 1 ? " pair of triangles intersects" : " pairs of triangles intersect"),
         report.first_intersections, report.self_intersections);
  if(report.is_inside_out)
    out << "the normals point inside\n";
  if(report.refusal.empty())
    out << (findings.has_repairs() ? "usable, as repaired\n" : "usable\n");
  else
    out << "not usable: " << printable(report.refusal) << '\n';
  return out.str();
}

std::string check_as_json(const Check_report& report)
{
  const Mesh_findings& findings = report.file.findings;
  Json list = Json::array();
  for_each_finding(findings, [&](Finding finding) {
    list.push_back({{"kind", name_of(finding)},
                    {"count", findings.count(finding)},
                    {"is_repaired", is_repair(finding)},
                    {"first", findings.places(finding)}});
  });
  if(report.flat_triangles > 0)
    list.push_back({{"kind", "flat_triangles"},
                    {"count", report.flat_triangles},
                    {"is_repaired", false},
                    {"first", Json::array()}});
  if(report.slivers.number > 0)
    list.push_back({{"kind", "slivers"},
                    {"count", report.slivers.number},
                    {"is_repaired", false},
                    {"first", Json::array({report.slivers.worst})},
                    {"merging_distance", number_or_null(report.slivers.merging_distance)}});
  if(report.self_intersections > 0)
    list.push_back({{"kind", "self_intersections"},
                    {"count", report.self_intersections},
                    {"is_repaired", false},
                    {"first", report.first_intersections}});
  if(report.is_inside_out)
    list.push_back({{"kind", "inside_out"}, {"count", 1}, {"is_repaired", false}, {"first", Json::array()}});
  const Json mesh = report.mesh.number_of_faces() > 0
                        ? Json(mesh_as_json(report.mesh_file, report.mesh, report.file))
                        : Json({{"file", report.mesh_file}, {"repairs", repairs_as_json(findings)}});
  const Json json = {{"format", "constrictions-check/1"},
                     {"mesh", mesh},
                     {"findings", list},
                     {"merging_distance", number_or_null(findings.merging_distance)},
                     {"is_usable", report.refusal.empty()},
                     {"reason", report.refusal.empty() ? Json() : Json(report.refusal)}};
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
