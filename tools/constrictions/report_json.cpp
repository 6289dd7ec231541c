// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;
namespace SMC = CGAL::Surface_mesh_constrictions;

const char* name(SMC::Side side)
{
  switch(side)
  {
    case SMC::Side::OBJECT: return "object";
    case SMC::Side::COMPLEMENT: return "complement";
    default: return "mixed";
  }
}

const char* name(SMC::Seed_origin origin)
{
  switch(origin)
  {
    case SMC::Seed_origin::NON_FACE_TRIANGLE: return "non_face_triangle";
    case SMC::Seed_origin::CUT_LOCUS: return "cut_locus";
    case SMC::Seed_origin::SECTION: return "section";
    default: return "user";
  }
}

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

// Vertices on no face are counted, as they have numbers, but do not belong to the surface that has a genus.
Json mesh_as_json(const std::string& file, const Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<std::size_t> component(mesh.num_faces());
  const std::size_t components =
      PMP::connected_components(mesh, CGAL::make_property_map(component));
  const std::int64_t euler_characteristic = std::int64_t(mesh.number_of_vertices()) -
                                            std::int64_t(mesh.number_of_edges()) +
                                            std::int64_t(mesh.number_of_faces());
  return {{"file", file},
          {"vertices", mesh.num_vertices()},
          {"faces", mesh.number_of_faces()},
          {"components", components},
          {"genus", std::int64_t(components) - euler_characteristic / 2},
          {"area", PMP::area(mesh)}};
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

// Barycentric coordinates are in the order of the corners in the file.
Json locations_as_json(const Constriction& c, const Mesh& mesh, const std::vector<bool>& is_turned)
{
  std::vector<Constriction::Face_location> locations;
  c.face_locations(mesh, std::back_inserter(locations));
  Json result = Json::array();
  for(Constriction::Face_location l : locations)
  {
    if(is_turned[l.first])
      std::swap(l.second[1], l.second[2]);
    result.push_back({{"face", l.first.idx()}, {"barycentric", l.second}});
  }
  return result;
}

Json pivots_as_json(const Constriction& c)
{
  Json result = Json::array();
  for(const Constriction::Pivot& p : c.pivots())
    result.push_back({{"vertex", p.vertex.idx()},
                      {"point", p.location},
                      {"left_angle", p.left_angle},
                      {"right_angle", p.right_angle}});
  return result;
}

Json seed_as_json(const Constriction::Seed& seed)
{
  Json vertices = Json::array();
  for(Mesh::Vertex_index v : seed.vertices)
    vertices.push_back(v.idx());
  return {{"level", seed.level}, {"vertices", vertices}, {"origin", name(seed.origin)}};
}

Json constriction_as_json(std::size_t id, const Constriction& c, const Mesh& mesh, const std::vector<bool>& is_turned)
{
  return {{"id", id},
          {"length", c.length()},
          {"points", points_as_json(c, mesh)},
          {"locations", locations_as_json(c, mesh, is_turned)},
          {"pivots", pivots_as_json(c)},
          {"certificate", "not_certified: no exact certificate has been computed"},
          {"side", name(c.side())},
          {"separating", c.is_separating()},
          {"areas", c.areas()},
          {"isoperimetric_ratio", c.isoperimetric_ratio()},
          {"prominence", nullptr},
          {"dominated_by", nullptr},
          {"seed", seed_as_json(c.seeds().front())}};
}

} // namespace

std::string report_as_json(const Report& report)
{
  Json constrictions = Json::array();
  for(const Constriction& c : report.constrictions)
    constrictions.push_back(constriction_as_json(constrictions.size(), c, report.mesh, report.is_turned));

  const SMC::Detection_statistics& s = report.statistics;
  const Stage_seconds& t = report.seconds;
  const Json json = {{"format", "constrictions/1"},
                     {"mesh", mesh_as_json(report.mesh_file, report.mesh)},
                     {"constrictions", constrictions},
                     {"statistics",
                      {{"collapses", s.collapses},
                       {"seeds", s.seeds},
                       {"degenerate", s.degenerate},
                       {"merged", s.merged},
                       {"not_simple", s.not_simple},
                       {"leaky_bands", s.leaky_bands}}},
                     {"seconds",
                      {{"read", t.read},
                       {"simplify", t.simplify},
                       {"refine", t.refine},
                       {"tighten", t.tighten},
                       {"certify", 0.},
                       {"total", t.total}}},
                     {"peak_rss_bytes", peak_rss_bytes()}};
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
