// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/mesh_file.h"

#include "input/input_file.h"
#include "input/repair_soup.h"
#include "input/text_scanner.h"
#include "input/triangle_soup.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

std::string lower_case(std::string text)
{
  for(char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool starts_with(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

// Many programs begin a binary STL with the word "solid", so the size, which follows from the number of faces, is
// asked first, and a header of text lines has no zero byte.
bool is_binary_stl(const std::string& content)
{
  const std::size_t header = 84, bytes_per_face = 50;
  if(content.size() < header)
    return false;
  std::size_t faces = 0;
  for(std::size_t i = header; i-- > header - 4;)
    faces = faces << 8 | static_cast<unsigned char>(content[i]);
  return content.size() == header + bytes_per_face * faces ||
         (starts_with(content, "solid") && content.find('\0') < header);
}

bool is_obj_keyword(std::string_view word)
{
  const std::array<std::string_view, 8> keywords = {"v", "vn", "vt", "f", "o", "g", "mtllib", "usemtl"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

Triangle_soup read_triangle_soup(const Input_file& file)
{
  const std::string extension = lower_case(std::filesystem::path(file.name).extension().string());
  Text_scanner scanner(file);
  std::string_view word;
  if(scanner.next_line())
    word = scanner.word();
  const bool ends_in_off = word.size() >= 3 && word.size() <= 8 && word.substr(word.size() - 3) == "OFF";

  if(word == "ply" && starts_with(file.content, "ply"))
    return read_ply(file);
  if(ends_in_off)
    return read_off(file);
  if(is_obj_keyword(word))
    return read_obj(file);
  if(is_binary_stl(file.content))
    return read_binary_stl(file);
  if(lower_case(std::string(word)) == "solid")
    return read_ascii_stl(file);

  // not what it should be: the reader says what it misses
  if(extension == ".off")
    return read_off(file);
  if(extension == ".obj")
    return read_obj(file);
  if(extension == ".stl")
    return read_binary_stl(file);
  if(extension == ".ply")
    file.fail("not a PLY file: it does not begin with ply");
  file.fail("neither an OFF, OBJ, PLY nor STL file");
}

using CGAL::Surface_mesh_constrictions::Input_defect;
using CGAL::Surface_mesh_constrictions::Invalid_input;
using CGAL::Surface_mesh_constrictions::internal::Corner_table;
using CGAL::Surface_mesh_constrictions::internal::make_corner_table;

// Whether an edge has more than two faces.
bool has_crowded_edge(const Triangle_soup& soup)
{
  std::map<std::pair<Index, Index>, int> faces;
  for(std::size_t i = 0; i < soup.corners.size(); ++i)
  {
    const Index u = soup.corners[i], v = soup.corners[i % 3 == 2 ? i - 2 : i + 1];
    if(++faces[{(std::min)(u, v), (std::max)(u, v)}] > 2)
      return true;
  }
  return false;
}

// Faces whose only fault is their orientation are turned, the numbers of those go to `turned`.
Corner_table connect_turning_faces(Triangle_soup& soup, bool with_border, std::vector<Index>& turned)
{
  try
  {
    return make_corner_table(soup.points.size(), soup.corners, with_border);
  }
  catch(const Invalid_input& e)
  {
    if(e.defect() != Input_defect::INCONSISTENT_ORIENTATION)
      throw;
    turned = orient_soup(soup);
    if(turned.empty() && !has_crowded_edge(soup))
      throw Invalid_input(Input_defect::INCONSISTENT_ORIENTATION, e.element(),
                          "the surface cannot be oriented, as a Moebius strip cannot: whichever faces are turned, two "
                          "run along their common edge in the same direction; one of these is face " +
                              std::to_string(e.element()));
    if(turned.empty())
      throw;
  }
  return make_corner_table(soup.points.size(), soup.corners, with_border);
}

bool has_nan(const Triangle_soup& soup)
{
  return std::any_of(soup.points.begin(), soup.points.end(), [](const Point& p) {
    return std::isnan(p.x()) || std::isnan(p.y()) || std::isnan(p.z());
  });
}

// Turns some faces once more, of which some have been turned: both ascending.
void turn(const std::vector<Index>& again, std::vector<Index>& turned)
{
  std::vector<Index> result;
  std::set_symmetric_difference(turned.begin(), turned.end(), again.begin(), again.end(), std::back_inserter(result));
  turned.swap(result);
}

// As above; and if the surface is open along seams, where vertices have been doubled, they are closed, unless what comes
// of that is no surface. Other holes stay.
Corner_table connect(Triangle_soup& soup, std::vector<Index>& turned)
{
  try
  {
    return connect_turning_faces(soup, false, turned);
  }
  catch(const Invalid_input& e)
  {
    if(e.defect() != Input_defect::NOT_CLOSED)
      throw;
  }
  Triangle_soup closed = soup;
  if(!has_nan(soup) && close_seams(closed))
    try
    {
      std::vector<Index> again;
      const Corner_table table = connect_turning_faces(closed, true, again);
      soup = std::move(closed);
      turn(again, turned);
      return table;
    }
    catch(const Invalid_input&)
    {
    }
  std::vector<Index> again;
  const Corner_table table = connect_turning_faces(soup, true, again);
  turn(again, turned);
  return table;
}

} // namespace

Mesh read_mesh_file(const std::string& name, std::vector<bool>& is_turned)
{
  using namespace CGAL::Surface_mesh_constrictions;

  Input_file file = read_input_file(name);
  const std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if(starts_with(file.content, byte_order_mark))
    file.content.erase(0, byte_order_mark.size());
  if(file.content.empty())
    file.fail("the file is empty");

  Triangle_soup soup = read_triangle_soup(file);
  std::string().swap(file.content); // before the mesh needs memory
  std::vector<Index> turned;
  const Corner_table table = connect(soup, turned);
  internal::check_points(table, soup.points);
  Mesh mesh;
  internal::mesh_from_corner_table(table, soup.points, mesh);
  is_turned.assign(mesh.number_of_faces(), false);
  for(Index f : turned)
    is_turned[f] = true;
  return mesh;
}

Mesh read_mesh_file(const std::string& name)
{
  std::vector<bool> is_turned;
  return read_mesh_file(name, is_turned);
}

} // namespace constrictions
