// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/certificates.h"
#include "output/curve_of_report.h"
#include "output/mesh_json.h"
#include "system/posix.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;
namespace SMC = CGAL::Surface_mesh_constrictions;

Json points_as_json(const std::vector<Mesh::Point>& points)
{
  Json result = Json::array();
  for(const Mesh::Point& p : points)
    result.push_back({p.x(), p.y(), p.z()});
  return result;
}

Json triangle_as_json(const Mesh& mesh, const File_numbering& numbering, Mesh::Face_index face)
{
  Json result = Json::array();
  for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(face)))
    result.push_back(numbering.vertex_of(mesh.source(h)));
  return result;
}

// Faces and vertices are called as in the file. Barycentric coordinates are in the order of the corners of the face
// there, or, if it is no triangle, in that of the vertices of the piece that is given with it.
Json locations_as_json(const std::vector<Constriction::Face_location>& locations, const Mesh& mesh,
                       const File_numbering& numbering)
{
  Json result = Json::array();
  for(Constriction::Face_location l : locations)
  {
    const bool is_piece = numbering.is_piece_of_polygon(l.first);
    if(!is_piece && numbering.is_turned_round(l.first))
      std::swap(l.second[1], l.second[2]);
    Json location = {{"face", numbering.face_of(l.first)}, {"barycentric", l.second}};
    if(is_piece)
      location["triangle"] = triangle_as_json(mesh, numbering, l.first);
    result.push_back(std::move(location));
  }
  return result;
}

// An infinite angle, that to a hole, is written as null.
Json pivots_as_json(const Constriction& c, const File_numbering& numbering)
{
  Json result = Json::array();
  for(const Constriction::Pivot& p : c.pivots())
    result.push_back({{"vertex", numbering.vertex_of(p.vertex)},
                      {"point", p.location},
                      {"left_angle", p.left_angle},
                      {"right_angle", p.right_angle}});
  return result;
}

Json seed_as_json(const Constriction::Seed& seed, const File_numbering& numbering)
{
  Json vertices = Json::array();
  for(Mesh::Vertex_index v : seed.vertices)
    vertices.push_back(numbering.vertex_of(v));
  return {{"level", seed.level}, {"vertices", vertices}, {"origin", origin_name(seed.origin)}};
}

Json signs_as_json(const SMC::Sign_statistics& signs)
{
  return {{"interval", signs.interval},
          {"multiprecision", signs.multiprecision},
          {"finite_field", signs.finite_field},
          {"algebra", signs.algebra},
          {"unproved", signs.unproved}};
}

// Where a loop of `girth` is held, and its end when it is let go.
Json held_as_json(const Geodesic_loop& loop, const File_numbering& numbering)
{
  const bool is_vertex = !loop.pivots.empty() && loop.pivots.front().location == 0;
  const bool is_constriction = loop.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC;
  return {{"point", 0},
          {"vertex", is_vertex ? Json(numbering.vertex_of(loop.pivots.front().vertex)) : Json()},
          {"left_angle", loop.left_angle}, // null if it is infinite
          {"right_angle", loop.right_angle},
          {"closed_geodesic", loop.is_closed_geodesic},
          {"let_go", end_name(loop)},
          {"let_go_length", is_constriction ? Json(loop.let_go.length()) : Json()}};
}

Json curve_as_json(const Report& report, std::size_t id)
{
  const Constriction& c = report.constrictions[id];
  const File_numbering& numbering = report.file.numbering;
  Json result = {{"id", id},
                 {"length", c.length()},
                 {"points", points_as_json(points_of_curve(report, id))},
                 {"locations", locations_as_json(locations_of_curve(report, id), report.mesh, numbering)},
                 {"pivots", pivots_as_json(c, numbering)},
                 {"certificate", verdict_on_curve(report, id)},
                 {"side", side_name(c.side())},
                 {"separating", c.is_separating()},
                 {"areas", c.areas()},
                 {"genera", c.genera()},
                 {"isoperimetric_ratio", c.isoperimetric_ratio()}, // null if it is infinite
                 {"roundness", c.roundness()},
                 {"isolation", c.isolation()},   // null if it is infinite
                 {"prominence", c.prominence()}, // null if it is not a number
                 {"dominated_by", c.dominated_by() ? Json(*c.dominated_by()) : Json()},
                 {"slides_off", c.slides_off() ? Json(numbering.vertex_of(*c.slides_off())) : Json()},
                 {"rim", c.is_rim()},
                 {"boundary_share", c.boundary_share()},
                 {"centroid", c.centroid()},
                 {"diameter", c.diameter()},
                 {"normal", c.normal()},
                 {"seed", seed_as_json(c.seeds().front(), numbering)}};
  if(!std::isnan(c.prominence_interval()[0]))
    result["prominence_interval"] = c.prominence_interval();
  if(!std::isnan(c.cap_area()))
  {
    result["cap_area"] = c.cap_area();
    result["side_girths"] = c.side_girths();
  }
  if(report.is_girth)
    result["held"] = held_as_json(report.loops[id], numbering);
  return result;
}

Json border_as_json(const Report& report, std::size_t id)
{
  const Label_border& b = report.labelling->tightened.borders[id];
  const std::size_t constriction = report.labelling->constriction[id];
  const Constriction curve = curve_of_border(b);
  std::vector<Mesh::Point> points;
  b.points(report.mesh, std::back_inserter(points));
  Json old_vertices = Json::array();
  for(Mesh::Vertex_index v : b.old_vertices)
    old_vertices.push_back(report.file.numbering.vertex_of(v));
  return {{"id", id},
          {"labels", b.labels},
          {"closed", b.is_closed},
          {"outcome", outcome_name(b.outcome)},
          {"certificate", certificate_as_text(b.certificate)},
          {"constriction", constriction != Labelling::none ? Json(constriction) : Json()},
          {"crosses", b.crossed_border ? Json(*b.crossed_border) : Json()},
          {"prominence", b.prominence}, // null if it is not a number
          {"vanishing_label", b.vanishing_label ? Json(*b.vanishing_label) : Json()},
          {"old_length", b.old_length},
          {"length", b.length},
          {"old_vertices", old_vertices},
          {"points", points_as_json(points)},
          {"locations", locations_as_json(locations_of_curve(report.mesh, curve), report.mesh, report.file.numbering)}};
}

Json landmarks_as_json(const Report& report)
{
  Json result = Json::array();
  for(const Landmark_answer& a : report.landmarks)
    result.push_back(
        {{"name", a.landmark.name}, {"location", a.landmark.location}, {"constrictions", a.curves}, {"hint", a.hint}});
  return result;
}

Json held_loops_as_json(const Report& report)
{
  Json result = Json::array();
  for(const Held_loop& h : report.held_loops)
  {
    std::vector<Mesh::Point> points;
    h.loop.points(report.mesh, std::back_inserter(points));
    result.push_back({{"line", h.line},
                      {"length", h.loop.length},
                      {"simple", h.loop.is_simple},
                      {"points", points_as_json(points)},
                      {"locations", locations_as_json(h.loop.locations, report.mesh, report.file.numbering)},
                      {"held", h.loop.held},
                      {"let_go", end_name(h.loop.let_go.verdict)},
                      {"constriction", h.constriction ? Json(*h.constriction) : Json()}});
  }
  return result;
}

Json sections_as_json(const Report& report)
{
  Json result = Json::array();
  for(const Section_answer& a : report.sections)
  {
    std::vector<Mesh::Point> points;
    a.section.points(report.mesh, std::back_inserter(points));
    result.push_back({{"kind", section_name(a.section.kind)},
                      {"length", a.section.length},
                      {"curves", a.section.number_of_curves},
                      {"points", points_as_json(points)},
                      {"locations", locations_as_json(a.section.locations, report.mesh, report.file.numbering)},
                      {"constriction", a.curve ? Json(*a.curve) : Json()}});
  }
  return result;
}

// The borders, the parts between them, and the labels of the faces of the file.
void add_labelling(const Report& report, Json& json)
{
  const auto& tightened = report.labelling->tightened;
  Json borders = Json::array(), parts = Json::array(), labels = Json::array();
  for(std::size_t id = 0; id < tightened.borders.size(); ++id)
    borders.push_back(border_as_json(report, id));
  for(std::size_t p = 0; p < tightened.parts.size(); ++p)
    parts.push_back({{"label", tightened.labels[p]}, {"area", tightened.parts[p].area}});
  for(const std::optional<Label>& l : labels_of_file(report.mesh, report.file.numbering, *report.labelling))
    labels.push_back(l ? Json(*l) : Json());
  json["borders"] = std::move(borders);
  json["label_parts"] = std::move(parts);
  json["face_labels"] = std::move(labels);
}

} // namespace

std::string report_as_json(const Report& report)
{
  Json constrictions = Json::array();
  for(std::size_t id = 0; id < report.constrictions.size(); ++id)
    constrictions.push_back(curve_as_json(report, id));

  const SMC::Detection_statistics& s = report.statistics;
  const Stage_seconds& t = report.seconds;
  Json json = {{"format", "constrictions/1"},
               {"mesh", mesh_as_json(report.mesh_file, report.mesh, report.file)},
               {"constrictions", constrictions},
               {"statistics",
                {{"collapses", s.collapses},
                 {"seeds", s.seeds},
                 {"degenerate", s.degenerate},
                 {"discarded", s.discarded},
                 {"merged", s.merged},
                 {"not_simple", s.not_simple},
                 {"leaky_bands", s.leaky_bands},
                 {"barriers", s.barriers},
                 {"not_certified", s.not_certified},
                 {"not_selected", s.not_selected},
                 {"corrected", s.corrected},
                 {"signs", signs_as_json(s.signs)}}},
               {"seconds",
                {{"read", t.read},
                 {"simplify", t.simplify},
                 {"seeds", t.seeds},
                 {"refine", t.refine},
                 {"tighten", t.tighten},
                 {"certify", t.certify},
                 {"select", t.select},
                 {"total", t.total}}},
               {"peak_rss_bytes", peak_rss_bytes()}};
  if(report.labelling)
    add_labelling(report, json);
  if(!report.landmarks.empty())
    json["landmarks"] = landmarks_as_json(report);
  if(!report.held_loops.empty())
    json["held_loops"] = held_loops_as_json(report);
  if(!report.sections.empty())
    json["sections"] = sections_as_json(report);
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
