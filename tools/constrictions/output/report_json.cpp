// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include "output/certificates.h"
#include "output/mesh_json.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;
namespace SMC = CGAL::Surface_mesh_constrictions;

// of this process, so far
std::uint64_t peak_rss_bytes()
{
  rusage usage;
  if(getrusage(RUSAGE_SELF, &usage) != 0)
    return 0;
#ifdef __APPLE__
  const std::uint64_t unit = 1;
#else
  const std::uint64_t unit = 1024;
#endif
  return unit * static_cast<std::uint64_t>(usage.ru_maxrss);
}

Json points_as_json(const Constriction& c, const Mesh& mesh)
{
  std::vector<Mesh::Point> points;
  c.points(mesh, std::back_inserter(points));
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
// there, or, if it is no triangle, in that of the vertices of the piece that is given with it. Two of them are zero at
// pivots only: a crossing that rounding has moved to an end of its edge is written beside it, so that its edge can be
// told from the numbers.
Json locations_as_json(const Constriction& c, const Mesh& mesh, const File_numbering& numbering)
{
  std::vector<Constriction::Face_location> locations;
  c.face_locations(mesh, std::back_inserter(locations));
  Json result = Json::array();
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    Constriction::Face_location l = locations[i];
    Mesh::Halfedge_index h = mesh.halfedge(l.first);
    for(std::size_t corner = 0; corner < 3 && !c.locations()[i].is_pivot; ++corner, h = mesh.next(h))
      if(h == c.locations()[i].halfedge || mesh.prev(h) == c.locations()[i].halfedge)
        l.second[corner] = (std::max)(l.second[corner], (std::numeric_limits<double>::min)());
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

Json constriction_as_json(std::size_t id, const Constriction& c, const Mesh& mesh, const File_numbering& numbering)
{
  return {{"id", id},
          {"length", c.length()},
          {"points", points_as_json(c, mesh)},
          {"locations", locations_as_json(c, mesh, numbering)},
          {"pivots", pivots_as_json(c, numbering)},
          {"certificate", certificate_as_text(c.certificate())},
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
}

} // namespace

std::string report_as_json(const Report& report)
{
  Json constrictions = Json::array();
  for(const Constriction& c : report.constrictions)
    constrictions.push_back(constriction_as_json(constrictions.size(), c, report.mesh, report.file.numbering));

  const SMC::Detection_statistics& s = report.statistics;
  const Stage_seconds& t = report.seconds;
  const Json json = {{"format", "constrictions/1"},
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
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
