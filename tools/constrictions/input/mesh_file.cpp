// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/mesh_file.h"

#include "input/find_border.h"
#include "input/inflate.h"
#include "input/input_file.h"
#include "input/readers.h"
#include "input/repair_soup.h"
#include "input/text_scanner.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace constrictions {

namespace {

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

const std::size_t stl_header = 84;

// The size that follows from the number of faces in its header.
std::size_t size_of_binary_stl(const std::string& content)
{
  const std::size_t bytes_per_face = 50;
  std::size_t faces = 0;
  for(std::size_t i = stl_header; i-- > stl_header - 4;)
    faces = faces << 8 | static_cast<unsigned char>(content[i]);
  return stl_header + bytes_per_face * faces;
}

// The first 80 bytes may be anything, such as what files of other formats begin with, so the size is asked before they
// are looked at. In a text it would be gigabytes.
bool has_size_of_binary_stl(const std::string& content)
{
  return content.size() >= stl_header && content.size() == size_of_binary_stl(content);
}

bool has_facets_in_words(const std::string& content)
{
  const std::string_view word = "endfacet";
  return std::search(content.begin(), content.end(), word.begin(), word.end(),
                     [](char c, char lower) { return (c | 0x20) == lower; }) != content.end();
}

// What has another size than its header says. Many programs begin a binary STL with the word "solid", but a header of
// text lines has no zero byte.
bool is_binary_stl_of_other_size(const std::string& content, const std::string& extension)
{
  if(content.size() < stl_header)
    return false;
  const std::size_t size = size_of_binary_stl(content);
  if(extension == ".stl" && stl_header < size && size <= content.size())
    return true; // with bytes behind
  return starts_with(content, "solid") && content.find('\0') < stl_header && !has_facets_in_words(content);
}

bool is_vtk(const std::string& content) { return starts_with(lower_case(content.substr(0, 14)), "# vtk datafile"); }

bool is_xml_of_vtk(const std::string& content)
{
  const std::size_t looked_at = 4096, begin = content.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && content[begin] == '<' &&
         content.substr(0, looked_at).find("<VTKFile") != std::string::npos;
}

std::string upper_case(std::string_view text)
{
  std::string result(text);
  for(char& c : result)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

bool is_obj_keyword(std::string_view word)
{
  const std::array<std::string_view, 16> keywords = {"v", "vn", "vt", "vp", "f",      "fo",     "o", "g",
                                                     "s", "l",  "p",  "mg", "mtllib", "usemtl", "V", "call"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

// Windows writes text as UTF-16 here and there. What is not of ASCII there does not matter for a mesh.
void to_bytes(std::string& content)
{
  const bool is_little = starts_with(content, "\xFF\xFE"), is_big = starts_with(content, "\xFE\xFF");
  if(!is_little && !is_big)
    return;
  std::string result;
  for(std::size_t i = 2; i + 1 < content.size(); i += 2)
    result += content[i + (is_big ? 0 : 1)] == 0 ? content[i + (is_big ? 1 : 0)] : '?';
  content = std::move(result);
}

std::string extension_of(const std::string& name)
{
  std::filesystem::path path(name);
  if(lower_case(path.extension().string()) == ".gz")
    path = path.stem();
  return lower_case(path.extension().string());
}

// Lines of three numbers or more, and nothing else, as far as can be told from the beginning.
bool is_list_of_points(const Input_file& file)
{
  Text_scanner scanner(file);
  std::size_t lines = 0;
  for(const std::size_t looked_at = 20; lines < looked_at && scanner.next_line(); ++lines, scanner.skip_line())
  {
    double x = 0;
    for(int i = 0; i < 3; ++i)
      if(!scanner.read(x))
        return false;
  }
  return lines > 0;
}

[[noreturn]] void fail_as_point_cloud(const Input_file& file, const std::string& points)
{
  file.fail("a point cloud: " + points + ", but no faces; a surface has to be reconstructed first");
}

Polygon_soup read_format(const Input_file& file)
{
  const std::string extension = extension_of(file.name);
  if(has_size_of_binary_stl(file.content) || is_binary_stl_of_other_size(file.content, extension))
    return read_binary_stl(file);
  if(starts_with(file.content, "glTF"))
    return read_glb(file);
  if(starts_with(file.content, "PK\3\4"))
    return read_3mf(file);
  if(is_vtk(file.content))
    return read_vtk(file);
  if(is_xml_of_vtk(file.content))
    return read_vtp(file);
  Text_scanner scanner(file);
  std::string_view word;
  if(scanner.next_line())
    word = scanner.word();

  if(lower_case(word) == "ply")
    return read_ply(file);
  if(is_off_keyword(word))
    return read_off(file);
  if(is_obj_keyword(word))
    return read_obj(file);
  if(lower_case(word) == "solid" || lower_case(word) == "facet")
    return read_ascii_stl(file);

  // not what it should be: the reader says what it misses
  if(extension == ".off")
    return read_off(file);
  if(is_list_of_points(file))
    fail_as_point_cloud(file, "lines of numbers");
  if(extension == ".obj")
    return read_obj(file);
  if(extension == ".stl")
    return has_facets_in_words(file.content) ? read_ascii_stl(file) : read_binary_stl(file);
  if(extension == ".ply")
    file.fail("not a PLY file: it does not begin with ply");
  for(const auto& [name, begins] : {std::pair<const char*, const char*>(".vtk", "with the words \"# vtk DataFile\""),
                                    {".vtp", "as XML with the element VTKFile"},
                                    {".glb", "with the letters glTF"},
                                    {".3mf", "as a zip archive"}})
    if(extension == name)
      file.fail("not a " + upper_case(name + 1) + " file: it does not begin " + begins);
  if(extension == ".gltf")
    file.fail("glTF in words is not read; GLB is, which is the same in one binary file");
  file.fail("not a mesh in a format that is read: OFF, OBJ, PLY, STL, VTK, VTP, GLB and 3MF are");
}

using CGAL::Surface_mesh_constrictions::Invalid_input;
using CGAL::Surface_mesh_constrictions::null_index;
using CGAL::Surface_mesh_constrictions::internal::check_points;
using CGAL::Surface_mesh_constrictions::internal::Corner_table;
using CGAL::Surface_mesh_constrictions::internal::make_corner_table;

// Nothing if anything is to be repaired, or open.
std::optional<Corner_table> connect_as_it_is(const Polygon_soup& soup)
{
  if(!soup.is_triangular())
    return std::nullopt;
  try
  {
    Corner_table table = make_corner_table(soup.points.size(), soup.corners);
    check_points(table, soup.points);
    const bool is_closed = table.halfedges.size() == soup.corners.size() &&
                           std::none_of(table.halfedges.begin(), table.halfedges.end(),
                                        [](const Corner_table::Halfedge& h) { return h.opposite == null_index; });
    return is_closed ? std::optional<Corner_table>(std::move(table)) : std::nullopt;
  }
  catch(const Invalid_input&)
  {
    return std::nullopt;
  }
}

} // namespace

Mesh read_mesh_file(const std::string& name, const Reading& reading, File_record& record)
{
  using namespace CGAL::Surface_mesh_constrictions;

  Input_file file = name == "-" ? read_standard_input() : read_input_file(name);
  if(!has_size_of_binary_stl(file.content))
    inflate(file);
  if(!has_size_of_binary_stl(file.content))
  {
    const std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if(starts_with(file.content, byte_order_mark))
      file.content.erase(0, byte_order_mark.size());
    to_bytes(file.content);
  }
  if(file.content.empty())
    file.fail("the file is empty");

  const Polygon_soup soup = read_format(file);
  if(soup.number_of_faces() == 0 && !soup.points.empty())
    fail_as_point_cloud(file, std::to_string(soup.points.size()) + " points");
  std::string().swap(file.content); // before the mesh needs memory

  record = File_record();
  record.unit = soup.unit;
  Mesh mesh;
  if(reading.merging_distance == 0)
    if(const std::optional<Corner_table> table = connect_as_it_is(soup))
    {
      internal::mesh_from_corner_table(*table, soup.points, mesh);
      record.numbering.vertices = soup.points.size();
      record.numbering.faces = soup.number_of_faces();
      return mesh;
    }
  if(soup.number_of_faces() == 0)
    throw Invalid_input(Input_defect::EMPTY_MESH, 0, "empty mesh: it has no face");
  Repaired_soup repaired = repair_soup(soup, reading.merging_distance, record.findings);
  internal::mesh_from_corner_table(repaired.table, repaired.points, mesh);
  record.numbering = std::move(repaired.numbering);
  find_border(mesh, record.numbering, record.findings);
  if(reading.is_strict)
    refuse_repairs(record.findings);
  refuse_cracks(record.findings);
  return mesh;
}

Invalid_input with_hint(const Invalid_input& refusal, const File_record& record)
{
  const std::string hint = summary_of(record.findings);
  if(refusal.defect() != CGAL::Surface_mesh_constrictions::Input_defect::NOT_CLOSED || hint.empty() ||
     std::string_view(refusal.what()).find("--merge") != std::string_view::npos)
    return refusal;
  return Invalid_input(refusal.defect(), refusal.element(), std::string(refusal.what()) + " (" + hint + ")");
}

Mesh read_mesh_file(const std::string& name)
{
  File_record record;
  return read_mesh_file(name, Reading(), record);
}

} // namespace constrictions
