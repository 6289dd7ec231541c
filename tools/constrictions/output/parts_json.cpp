// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/parts.h"

#include "output/certificates.h"
#include "output/mesh_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;

Json caps_as_json(const Part& part)
{
  Json result = Json::array();
  for(const Cap& c : part.caps)
    result.push_back({{"curves", c.curves}, {"cuts_part", c.cuts_part}});
  return result;
}

// By face of the file. A face that was left out is in the part of a face beside it.
Json face_parts_as_json(const File_numbering& numbering, const Parts& parts)
{
  if(numbering.face.empty())
    return parts.part_of_input_face;
  std::vector<std::map<std::size_t, double>> areas(numbering.faces);
  for(std::size_t t = 0; t < numbering.face.size(); ++t)
    for(const auto& [part, area] : parts.area_of_input_face[t])
      areas[numbering.face[t]][part] += area;
  Json result = Json::array();
  for(std::size_t f = 0; f < numbering.faces; ++f)
  {
    const Index t = numbering.triangle_at(f);
    if(!areas[f].empty())
      result.push_back(std::max_element(areas[f].begin(), areas[f].end(), [](const auto& a, const auto& b) {
                         return a.second < b.second;
                       })->first);
    else
      result.push_back(t == CGAL::Surface_mesh_constrictions::null_index ? Json() : Json(parts.part_of_input_face[t]));
  }
  return result;
}

} // namespace

std::string parts_as_json(const Report& report, const Parts& parts)
{
  Json part_list = Json::array(), adjacencies = Json::array(), curves = Json::array();
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
  {
    part_list.push_back({{"id", p},
                         {"file", part_file_name(p, parts.format)},
                         {"area", parts.parts[p].area},
                         {"volume", parts.parts[p].volume},
                         {"genus", parts.parts[p].genus},
                         {"boundaries", parts.parts[p].boundaries},
                         {"cavity", parts.parts[p].is_cavity},
                         {"caps", caps_as_json(parts.parts[p])}});
    if(!parts.labels.empty())
      part_list.back()["label"] = parts.labels[p];
  }
  for(const auto& a : parts.adjacencies)
    adjacencies.push_back({{"curve", a.curve}, {"parts", a.parts}, {"length", a.length}});
  for(std::size_t c = 0; c < parts.outcomes.size(); ++c)
  {
    const Constriction curve =
        report.labelling ? curve_of_border(report.labelling->tightened.borders[c]) : report.constrictions[c];
    const auto& outcome = parts.outcomes[c];
    const bool crosses = outcome.crossed_curve != CGAL::Surface_mesh_constrictions::Cut_outcome::none;
    curves.push_back({{"id", c},
                      {"length", curve.length()},
                      {"certificate", certificate_as_text(curve.certificate())},
                      {"side", side_name(curve.side())},
                      {"separating", curve.is_separating()},
                      {"prominence", curve.prominence()},
                      {"cuts", outcome.is_used},
                      {"crosses", crosses ? Json(outcome.crossed_curve) : Json()},
                      {"border_from", parts.border_from[c] ? Json(*parts.border_from[c]) : Json()}});
  }
  const Stage_seconds& t = report.seconds;
  const Json json = {{"format", "constrictions-parts/1"},
                     {"mesh", mesh_as_json(report.mesh_file, report.mesh, report.file)},
                     {"parts", part_list},
                     {"adjacencies", adjacencies},
                     {"curves", curves},
                     {"face_parts", face_parts_as_json(report.file.numbering, parts)},
                     {"seconds",
                      {{"read", t.read},
                       {"detect", t.simplify + t.seeds + t.refine + t.tighten + t.certify + t.select},
                       {"cut", parts.seconds},
                       {"total", t.total}}}};
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
