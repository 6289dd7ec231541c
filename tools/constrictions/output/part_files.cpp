// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/input_file.h"
#include "output/colours.h"
#include "output/little_endian.h"
#include "output/mesh_as_text.h"
#include "output/parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::ordered_json Json;
typedef std::array<float, 3> Float_point;

Float_point in_single_precision(const Point& p)
{
  Float_point result;
  for(int i = 0; i < 3; ++i)
  {
    if(std::abs(p[i]) > static_cast<double>((std::numeric_limits<float>::max)()))
      throw std::range_error("the coordinates are too large for single precision, in which this format has them");
    result[static_cast<std::size_t>(i)] = static_cast<float>(p[i]);
  }
  return result;
}

// A file begins with a header of 80 bytes, which must not be "solid", as a text does.
std::string mesh_as_stl(const Mesh& mesh)
{
  std::string out = "part of a surface cut along its constrictions";
  out.resize(80, ' ');
  append_little_endian(static_cast<std::uint32_t>(mesh.number_of_faces()), out);
  for(Mesh::Face_index f : mesh.faces())
  {
    std::vector<Point> corners;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(mesh.point(v));
    const auto normal = CGAL::cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = std::sqrt(normal.squared_length());
    for(int i = 0; i < 3; ++i)
      append_little_endian(static_cast<float>(length > 0 ? normal[i] / length : 0), out);
    for(const Point& p : corners)
      for(float x : in_single_precision(p))
        append_little_endian(x, out);
    append_little_endian(std::uint16_t(0), out);
  }
  return out;
}

// Of a colour as it is shown the intensity of light.
double linear(std::uint8_t colour)
{
  const double c = colour / 255.;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Appends a chunk, whose length is a multiple of four.
void append_chunk(std::uint32_t type, std::string data, char padding, std::string& out)
{
  data.resize((data.size() + 3) / 4 * 4, padding);
  append_little_endian(static_cast<std::uint32_t>(data.size()), out);
  append_little_endian(type, out);
  out += data;
}

// glTF 2.0 in one file: a header, a chunk of JSON and one of numbers, first the points, then the corners of faces.
std::string mesh_as_glb(const Mesh& mesh, const std::string& name, const Colour& colour)
{
  const float infinity = std::numeric_limits<float>::infinity();
  Float_point low = {{infinity, infinity, infinity}}, high = {{-infinity, -infinity, -infinity}};
  std::string numbers;
  std::vector<std::uint32_t> number(mesh.num_vertices());
  std::uint32_t n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = n++;
    const Float_point p = in_single_precision(mesh.point(v));
    for(std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
      append_little_endian(p[i], numbers);
    }
  }
  const std::size_t size_of_points = numbers.size();
  for(Mesh::Face_index f : mesh.faces())
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      append_little_endian(number[v], numbers);

  const int of_floats = 5126, of_unsigned_ints = 5125, array_buffer = 34962, element_array_buffer = 34963;
  const Json json = {
      {"asset", {{"version", "2.0"}, {"generator", "constrictions"}}},
      {"scene", 0},
      {"scenes", Json::array({{{"nodes", {0}}}})},
      {"nodes", Json::array({{{"name", name}, {"mesh", 0}}})},
      {"meshes",
       Json::array(
           {{{"name", name},
             {"primitives", Json::array({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}})}}})},
      {"materials", Json::array({{{"name", name},
                                  {"pbrMetallicRoughness",
                                   {{"baseColorFactor", {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1}},
                                    {"metallicFactor", 0},
                                    {"roughnessFactor", 1}}},
                                  {"doubleSided", true}}})},
      {"accessors", Json::array({{{"bufferView", 0},
                                  {"componentType", of_floats},
                                  {"count", mesh.number_of_vertices()},
                                  {"type", "VEC3"},
                                  {"min", low},
                                  {"max", high}},
                                 {{"bufferView", 1},
                                  {"componentType", of_unsigned_ints},
                                  {"count", 3 * mesh.number_of_faces()},
                                  {"type", "SCALAR"}}})},
      {"bufferViews", Json::array({{{"buffer", 0}, {"byteLength", size_of_points}, {"target", array_buffer}},
                                   {{"buffer", 0},
                                    {"byteOffset", size_of_points},
                                    {"byteLength", numbers.size() - size_of_points},
                                    {"target", element_array_buffer}}})},
      {"buffers", Json::array({{{"byteLength", numbers.size()}}})}};

  std::string chunks;
  append_chunk(0x4e4f534a, json.dump(), ' ', chunks); // "JSON"
  append_chunk(0x004e4942, numbers, '\0', chunks);    // "BIN"
  std::string out = "glTF";
  append_little_endian(std::uint32_t(2), out);
  append_little_endian(static_cast<std::uint32_t>(12 + chunks.size()), out);
  return out + chunks;
}

} // namespace

const std::vector<std::string>& part_format_names()
{
  static const std::vector<std::string> names = {"ply", "stl", "obj", "glb", "3mf"};
  return names;
}

std::optional<Part_format> part_format(const std::string& name)
{
  const std::vector<std::string>& names = part_format_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if(found == names.end())
    return std::nullopt;
  return static_cast<Part_format>(found - names.begin());
}

std::string part_file_name(std::size_t part, Part_format format)
{
  if(format == Part_format::THREE_MF)
    return "parts.3mf";
  return "part_" + std::to_string(part) + '.' + part_format_names()[static_cast<std::size_t>(format)];
}

bool is_part_file_name(const std::string& name)
{
  static const std::regex pattern("part_[0-9]+\\.(ply|stl|obj|glb)|parts\\.3mf");
  return std::regex_match(name, pattern);
}

std::vector<std::string> part_files_of_earlier_run(const std::string& folder)
{
  const std::string name = (std::filesystem::path(folder) / "parts.json").string();
  std::error_code error;
  if(!std::filesystem::is_regular_file(name, error))
    return {};
  Json json;
  try
  {
    json = Json::parse(read_input_file(name).content, nullptr, false);
  }
  catch(const Input_file_error&)
  {
    return {}; // it is replaced, which need not be allowed, but that is told there
  }
  std::vector<std::string> result;
  if(!json.is_object() || json.value("format", Json()) != "constrictions-parts/1")
    return result;
  for(const Json& part : json.value("parts", Json::array()))
    if(part.is_object() && part.contains("file") && part["file"].is_string() &&
       is_part_file_name(part["file"].get<std::string>()))
      result.push_back(part["file"].get<std::string>());
  return result;
}

std::string part_as_file(const Parts& parts, std::size_t part)
{
  const Mesh& mesh = parts.parts[part].mesh;
  const std::string name = "part_" + std::to_string(part);
  switch(parts.format)
  {
  case Part_format::STL:
    return mesh_as_stl(mesh);
  case Part_format::OBJ:
    return "o " + name + '\n' + mesh_as_text(mesh, name + ".obj");
  case Part_format::THREE_MF:
    return parts_as_3mf(parts);
  case Part_format::GLB:
    return mesh_as_glb(mesh, name, part_colour(part));
  default:
    return mesh_as_ply(mesh, std::vector<std::size_t>(mesh.num_faces(), part));
  }
}

} // namespace constrictions
