// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/view_page.h"

#include "output/base64.h"
#include "output/certificates.h"
#include "output/data_block.h"
#include "output/mesh_json.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;
namespace PMP = CGAL::Polygon_mesh_processing;

// Larger surfaces are shown on a coarser level.
const std::size_t shown_faces = 100000;

// Where the page's data go in the template.
const std::string_view data_mark = "<!-- data -->";

// Coordinates relative to the centre of the bounding box, in units of half its diagonal.
class Frame
{
public:
  explicit Frame(const Mesh& mesh)
  {
    CGAL::Bbox_3 box;
    for(Mesh::Face_index f : mesh.faces()) // vertices on no face do not count
      box += PMP::face_bbox(f, mesh);
    double sum = 0;
    for(int i = 0; i < 3; ++i)
    {
      m_centre[i] = box.min(i) / 2 + box.max(i) / 2;
      const double extent = box.max(i) / 2 - box.min(i) / 2;
      sum = std::hypot(sum, extent);
    }
    m_radius = sum;
  }

  std::array<float, 3> operator()(const Mesh::Point& p) const
  {
    std::array<float, 3> result;
    for(int i = 0; i < 3; ++i)
      result[i] = static_cast<float>((p[i] - m_centre[i]) / m_radius);
    return result;
  }

  void append(const Mesh::Point& p, std::vector<float>& numbers) const
  {
    const std::array<float, 3> q = (*this)(p);
    numbers.insert(numbers.end(), q.begin(), q.end());
  }

  // In 65,535 steps from -2 to 2: a coarse level may reach beyond the box.
  void append(const Mesh::Point& p, std::vector<std::uint16_t>& numbers) const
  {
    for(float x : (*this)(p))
      numbers.push_back(static_cast<std::uint16_t>(std::lround((std::min)((std::max)((x + 2) / 4, 0.f), 1.f) * 65535)));
  }

  const std::array<double, 3>& centre() const { return m_centre; }
  double radius() const { return m_radius; }

private:
  std::array<double, 3> m_centre;
  double m_radius;
};

std::uint32_t number(std::size_t n) { return static_cast<std::uint32_t>(n); }

// The input, split along the curves.
void add_surface(const Parts& parts, const Frame& frame, Data_block& block)
{
  std::vector<float> points;
  std::vector<std::uint32_t> faces, face_parts, place(parts.mesh.num_vertices());
  std::uint32_t n = 0;
  for(Mesh::Vertex_index v : parts.mesh.vertices())
  {
    place[v] = n++;
    frame.append(parts.mesh.point(v), points);
  }
  for(Mesh::Face_index f : parts.mesh.faces())
  {
    for(Mesh::Vertex_index v : parts.mesh.vertices_around_face(parts.mesh.halfedge(f)))
      faces.push_back(place[v]);
    face_parts.push_back(number(parts.part_of_face[f]));
  }
  block.add("surface_points", points);
  block.add("surface_faces", faces);
  block.add("surface_parts", face_parts);
}

void add_levels(const Shown_levels& surface, const Parts& parts, const Frame& frame, Data_block& block)
{
  std::vector<float> points, moves;
  std::vector<std::uint32_t> faces, face_parts;
  for(const Mesh::Point& p : surface.points)
    frame.append(p, points);
  for(const Mesh::Point& p : surface.moves)
    frame.append(p, moves);
  for(const std::array<std::uint32_t, 3>& f : surface.faces)
    faces.insert(faces.end(), f.begin(), f.end());
  for(std::size_t f : surface.input_faces)
    face_parts.push_back(number(parts.part_of_input_face[f]));
  block.add("levels_points", points);
  block.add("levels_faces", faces);
  block.add("levels_parts", face_parts);
  block.add("levels_parents", surface.parents);
  block.add("levels_moves", moves);
}

// The unit normal of the surface at a point of a curve, in steps of 1/127.
void append_normal(const Mesh& mesh, const Constriction::Location& l, std::vector<std::int8_t>& numbers)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3 Vector;
  const auto of_face = [&mesh](Mesh::Halfedge_index h) { return PMP::compute_face_normal(mesh.face(h), mesh); };
  Vector n = l.is_pivot ? PMP::compute_vertex_normal(l.vertex, mesh)
                        : of_face(l.halfedge) + of_face(mesh.opposite(l.halfedge));
  const double length = std::sqrt(n.squared_length());
  n = length > 0 && std::isfinite(length) ? n / length : Vector(0, 0, 0);
  for(int i = 0; i < 3; ++i)
    numbers.push_back(static_cast<std::int8_t>(std::lround(127 * n[i])));
}

void add_curves(const Report& report, const Frame& frame, Data_block& block)
{
  std::vector<float> points;
  std::vector<std::int8_t> normals;
  std::vector<std::uint32_t> begins, pivots, pivot_begins;
  for(const Constriction& c : report.constrictions)
  {
    const std::size_t begin = points.size() / 3;
    begins.push_back(number(begin));
    pivot_begins.push_back(number(pivots.size()));
    std::vector<Mesh::Point> p;
    c.points(report.mesh, std::back_inserter(p));
    for(const Mesh::Point& x : p)
      frame.append(x, points);
    for(const Constriction::Location& l : c.locations())
      append_normal(report.mesh, l, normals);
    for(const Constriction::Pivot& pivot : c.pivots())
      pivots.push_back(number(begin + pivot.location));
  }
  begins.push_back(number(points.size() / 3));
  pivot_begins.push_back(number(pivots.size()));
  block.add("curve_points", points);
  block.add("curve_normals", normals);
  block.add("curve_begins", begins);
  block.add("pivots", pivots);
  block.add("pivot_begins", pivot_begins);
}

void add_frames(const Playback& playback, const Frame& frame, Data_block& block)
{
  std::vector<std::uint16_t> points;
  std::vector<std::uint32_t> frame_begins, begins, curves;
  std::vector<std::uint8_t> are_seeds;
  for(const Playback_frame& f : playback.frames)
  {
    frame_begins.push_back(number(curves.size()));
    for(const Carried_curve& c : f.curves)
    {
      begins.push_back(number(points.size() / 3));
      curves.push_back(number(c.constriction));
      are_seeds.push_back(c.is_seed ? 1 : 0);
      for(const Mesh::Point& p : c.points)
        frame.append(p, points);
    }
  }
  frame_begins.push_back(number(curves.size()));
  begins.push_back(number(points.size() / 3));
  block.add("frame_begins", frame_begins);
  block.add("carried_curves", curves);
  block.add("carried_are_seeds", are_seeds);
  block.add("carried_begins", begins);
  block.add("carried_points", points);
}

Json curves_as_json(const Report& report, const Parts& parts)
{
  Json result = Json::array();
  for(const Constriction& c : report.constrictions)
  {
    const std::size_t id = result.size();
    Json adjacent = Json::array();
    for(const auto& a : parts.adjacencies)
      if(a.curve == id)
        adjacent.push_back(a.parts);
    result.push_back({{"length", c.length()},
                      {"diameter", c.diameter()},
                      {"centroid", c.centroid()},
                      {"prominence", c.prominence()},
                      {"dominated_by", c.dominated_by() ? Json(*c.dominated_by()) : Json()},
                      {"side", side_name(c.side())},
                      {"certificate", certificate_as_text(c.certificate())},
                      {"separating", c.is_separating()},
                      {"isoperimetric_ratio", c.isoperimetric_ratio()},
                      {"pivots", c.pivots().size()},
                      {"seeds", c.seeds().size()},
                      {"cuts", parts.outcomes[id].is_used},
                      {"border_from", parts.border_from[id] ? Json(*parts.border_from[id]) : Json()},
                      {"parts", adjacent}});
  }
  return result;
}

// The page adds up what lies between curves that it does not show: the caps on the two sides of a cut are the same
// surface, so that volumes can be added.
Json sizes_of_parts(const Parts& parts)
{
  Json result = Json::array();
  for(const Part& p : parts.parts)
    result.push_back({{"area", p.area}, {"volume", p.volume}}); // NaN becomes null
  return result;
}

Json playback_as_json(const Playback& playback)
{
  Json frames = Json::array();
  for(const Playback_frame& f : playback.frames)
    frames.push_back({{"level", f.level}, {"vertices", f.vertices}});
  return {{"collapses", playback.collapses},
          {"finest_shown_level", playback.surface.finest_level},
          {"followed", playback.number_followed},
          {"frames", frames}};
}

// JSON that stays data wherever it stands in HTML: no tag and no comment can begin or end in it.
std::string inert(const Json& json)
{
  std::string result;
  // a file name need not be UTF-8, JSON must be
  for(char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    if(c == '<')
      result += "\\u003c";
    else if(c == '>')
      result += "\\u003e";
    else if(c == '&')
      result += "\\u0026";
    else
      result += c;
  return result;
}

} // namespace

std::string view_page(const Report& report, const Parts& parts, const Playback& playback, double prominence)
{
  const std::string& page = page_template();
  const std::size_t mark = page.find(data_mark);
  if(mark == std::string::npos)
    throw std::logic_error("there is no template of the page");

  const Frame frame(report.mesh);
  const bool is_simplified = report.mesh.number_of_faces() > shown_faces;
  Data_block block;
  if(!is_simplified)
    add_surface(parts, frame, block);
  add_levels(playback.surface, parts, frame, block);
  add_curves(report, frame, block);
  add_frames(playback, frame, block);

  // where the file lies is nobody's business but the user's
  Json mesh = mesh_as_json(std::filesystem::path(report.mesh_file).filename().string(), report.mesh, report.file);
  const Json data = {{"format", "constrictions-view/1"},
                     {"mesh", mesh},
                     {"centre", frame.centre()},
                     {"radius", frame.radius()},
                     {"is_simplified", is_simplified},
                     {"number_of_parts", parts.parts.size()},
                     {"parts", sizes_of_parts(parts)},
                     {"prominence", prominence},
                     {"curves", curves_as_json(report, parts)},
                     {"playback", playback_as_json(playback)},
                     {"arrays", block.directory()}};

  std::string result = page.substr(0, mark);
  result += "<script type=\"application/json\" id=\"data\">" + inert(data) + "</script>\n";
  result += "<script type=\"application/octet-stream\" id=\"block\">" + as_base64(block.bytes()) + "</script>";
  result += page.substr(mark + data_mark.size());
  return result;
}

} // namespace constrictions
