// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/note_loops.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;

// The locations of a loop that is held at a vertex, as vertices and crossed halfedges: a location that is no vertex is
// on the edge whose opposite corner has the coordinate 0.
std::vector<Constriction::Location> locations(const Mesh& mesh, const Geodesic_loop& loop)
{
  std::vector<Constriction::Location> result;
  for(const Geodesic_loop::Face_location& l : loop.locations)
  {
    const std::size_t opposite =
        static_cast<std::size_t>(std::find(l.second.begin(), l.second.end(), 0) - l.second.begin());
    Mesh::Halfedge_index h = mesh.halfedge(l.first);
    for(std::size_t corner = 0; corner <= opposite; ++corner)
      h = mesh.next(h);
    result.push_back({false, Mesh::null_vertex(), h, l.second[(opposite + 2) % 3]});
  }
  for(const Constriction::Pivot& p : loop.pivots)
    result[p.location] = {true, p.vertex, Mesh::null_halfedge(), 0};
  return result;
}

// What is known of a loop, as of a constriction.
Constriction as_curve(const Mesh& mesh, const Geodesic_loop& loop, bool certifies)
{
  Constriction::Data data;
  data.pivots = loop.pivots;
  data.seeds.push_back({0, {}, SMC::Seed_origin::CUT_LOCUS});
  data.length = loop.length;
  data.centroid = loop.centroid;
  data.normal = loop.normal;
  data.separating = loop.separating;
  data.areas = loop.areas;
  data.genera = loop.genera;
  data.isoperimetric_ratio = loop.isoperimetric_ratio;
  data.roundness = loop.roundness;
  data.side = loop.side;
  data.boundary_share = loop.boundary_share;
  data.rim = loop.boundary_share > 0.5;
  const bool is_at_vertex = !loop.pivots.empty() && loop.pivots.front().location == 0;
  if(certifies && loop.is_closed_geodesic && is_at_vertex)
  {
    Constriction::Data located;
    located.locations = locations(mesh, loop);
    data.certificate = SMC::certify_constriction(mesh, Constriction(located));
  }
  return Constriction(data);
}

} // namespace

void add_loops(const std::vector<Geodesic_loop>& loops, bool certifies, Report& report)
{
  for(const Geodesic_loop& loop : loops)
  {
    report.loops.push_back(loop);
    report.constrictions.push_back(as_curve(report.mesh, loop, certifies));
    report.statistics.signs = report.statistics.signs + loop.let_go.certificate().signs;
  }
}

std::string add_section(const SMC::Plane_section<Mesh>& section, bool certifies, Report& report)
{
  report.sections.push_back({section, std::nullopt});
  switch(section.kind)
  {
  case SMC::Section_kind::POINT:
    return "The plane through this place only touches the surface.";
  case SMC::Section_kind::OPEN:
    return "The section through this place ends at a boundary of the surface.";
  case SMC::Section_kind::CLOSED:
    break;
  }
  if(!section.loop)
    return "The section through this place becomes no simple loop when it is tightened; it may shrink to a point.";
  report.sections.back().curve = report.constrictions.size();
  add_loops({*section.loop}, certifies, report);
  return "";
}

} // namespace constrictions
