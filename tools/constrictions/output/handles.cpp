// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/handles.h"

#include "output/certificates.h"
#include "output/mesh_json.h"
#include "output/parts.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>
#include <string>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;

Json points_as_json(const std::vector<Point>& points)
{
  Json result = Json::array();
  for(const Point& p : points)
    result.push_back({p.x(), p.y(), p.z()});
  return result;
}

double volume_change(const Handle_removal& removal)
{
  double sum = 0;
  for(const Removed_handle& h : removal.handles)
    sum += h.volume_change;
  return sum;
}

} // namespace

std::string without_handles_file_name(Part_format format)
{
  return "without_handles." + part_format_names()[static_cast<std::size_t>(format)];
}

std::string without_handles_as_file(const Handle_removal& removal, Part_format format, const std::string& unit)
{
  Parts parts;
  parts.parts.resize(1);
  parts.parts[0].mesh = removal.mesh;
  parts.format = format;
  parts.unit = unit;
  return part_as_file(parts, 0);
}

std::string handles_as_json(const Report& report, const Handle_removal& removal, Part_format format)
{
  Json handles = Json::array();
  for(const Removed_handle& h : removal.handles)
    handles.push_back({{"id", handles.size()},
                       {"round", h.round},
                       {"length", h.length},
                       {"points", points_as_json(h.points)},
                       {"certificate", certificate_as_text(h.certificate)},
                       {"side", side_name(h.side)},
                       {"cap_areas", h.cap_areas},
                       {"caps_intersect", h.caps_intersect},
                       {"volume_change", h.volume_change}});
  const Stage_seconds& t = report.seconds;
  const Json json = {{"format", "constrictions-handles/1"},
                     {"mesh", mesh_as_json(report.mesh_file, report.mesh, report.file)},
                     {"file", without_handles_file_name(format)},
                     {"target_genus", removal.target_genus},
                     {"genus", removal.genus()},
                     {"volume_change", volume_change(removal)},
                     {"handles", handles},
                     {"seconds",
                      {{"read", t.read},
                       {"detect", t.simplify + t.seeds + t.refine + t.tighten + t.certify + t.select},
                       {"cut", removal.seconds},
                       {"total", t.total}}}};
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string handles_as_table(const Handle_removal& removal)
{
  using std::setw;

  std::ostringstream out;
  out << setw(6) << "handle" << setw(14) << "length" << setw(12) << "side" << setw(14) << "left cap" << setw(14)
      << "right cap" << setw(16) << "volume change" << '\n';
  for(std::size_t i = 0; i < removal.handles.size(); ++i)
  {
    const Removed_handle& h = removal.handles[i];
    out << setw(6) << i << setw(14) << h.length << setw(12) << side_name(h.side) << setw(14) << h.cap_areas[0]
        << setw(14) << h.cap_areas[1] << setw(16) << h.volume_change << '\n';
  }
  for(std::size_t i = 0; i < removal.handles.size(); ++i)
    if(removal.handles[i].caps_intersect[0] || removal.handles[i].caps_intersect[1])
      out << "handle " << i << ": a cap intersects the surface\n";
  out << removal.handles.size() << (removal.handles.size() == 1 ? " handle" : " handles") << " removed, genus "
      << removal.genus() << " instead of " << removal.old_genus << '\n';
  return out.str();
}

} // namespace constrictions
