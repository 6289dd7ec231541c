// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/loops_file.h"

#include "include/mesh_texts.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

namespace test_mesh_file {

using namespace mesh_texts;

std::size_t number_of_border_edges(const Mesh& mesh)
{
  std::size_t result = 0;
  for(Mesh::Halfedge_index h : mesh.halfedges())
    result += mesh.is_border(h);
  return result;
}

TEST_F(Mesh_file, every_format_gives_the_same_mesh)
{
  const Soup soup = octahedron();
  expect_mesh(soup, "a.off", off(soup));
  expect_mesh(soup, "a.obj", obj(soup));
  expect_mesh(soup, "ascii.ply", ply_header(soup, "ascii") + points_as_text(soup) + faces_as_text(soup, "3"));
  expect_mesh(soup, "little.ply", binary_ply(soup, false));
  expect_mesh(soup, "big.ply", binary_ply(soup, true));
  expect_mesh(soup, "ascii.stl", ascii_stl(soup));
  expect_mesh(soup, "binary.stl", binary_stl(soup));
}

TEST_F(Mesh_file, windows_line_ends)
{
  const Soup soup = octahedron();
  expect_mesh(soup, "a.off", with_crlf(off(soup)));
  expect_mesh(soup, "a.obj", with_crlf(obj(soup)));
  expect_mesh(soup, "a.ply", with_crlf(ply_header(soup, "ascii") + points_as_text(soup) + faces_as_text(soup, "3")));
  expect_mesh(soup, "a.stl", with_crlf(ascii_stl(soup)));
}

TEST_F(Mesh_file, format_is_told_by_content)
{
  const Soup soup = octahedron();
  expect_mesh(soup, "off", off(soup));
  expect_mesh(soup, "off.ply", off(soup));
  expect_mesh(soup, "obj.txt", obj(soup));
  expect_mesh(soup, "ply.off", binary_ply(soup, false));
  expect_mesh(soup, "ascii_stl.obj", ascii_stl(soup));
  expect_mesh(soup, "binary_stl", binary_stl(soup));
  expect_mesh(soup, "UPPER.OFF", off(soup));
  expect_mesh(soup, "mark.off", "\xEF\xBB\xBF" + off(soup));
}

TEST_F(Mesh_file, binary_stl_that_begins_with_solid)
{
  const Soup soup = octahedron();
  expect_mesh(soup, "a.stl", binary_stl(soup, "solid but binary"));
  // the size does not fit, the zero bytes of the header tell
  expect_file_error("b.stl", binary_stl(soup, "solid but binary").substr(0, 84 + 3 * 50 + 7), {"face 3 of the 8"});
}

TEST_F(Mesh_file, no_digit_is_lost)
{
  Soup soup = octahedron();
  soup.points[0][0] = 0.12345678901234567;
  soup.points[2][2] = 1e-300;
  const auto precise = [](const std::string& text) {
    return replaced(replaced(text, "1 0 0\n", "+0.12345678901234567 0 0\n"), "0 0 1.5\n", "0 0 1E-300\n");
  };
  expect_mesh(soup, "a.off", precise(off(octahedron())));
  expect_mesh(soup, "a.obj", precise(obj(octahedron())));
}

TEST_F(Mesh_file, off_with_comments_colours_and_blank_lines)
{
  const Soup soup = octahedron();
  std::string text = "# made by hand\n\nCOFF # colours\n# counts\n6 8 12 # vertices faces edges\n\n";
  for(const Position& p : soup.points)
    text += points_as_text({{p}, {}}).substr(0, points_as_text({{p}, {}}).size() - 1) + " 255 0 0 255 # red\n#\n";
  for(const Triangle& t : soup.triangles)
  {
    const std::string line = faces_as_text({{}, {t}}, "3");
    text += line.substr(0, line.size() - 1) + " 0.5 0.5 0.5\n \n";
  }
  expect_mesh(soup, "a.off", text);
  expect_mesh(soup, "one_line_header.off", replaced(off(soup), "OFF\n", "OFF "));
  expect_mesh(soup, "no_last_line_end.off", off(soup).substr(0, off(soup).size() - 1));
}

TEST_F(Mesh_file, obj_with_everything_else)
{
  const Soup soup = octahedron();
  std::string text = "# comment\nmtllib a.mtl\no thing\n" + points_as_text(soup, "v\t") + "vn 0 0 1\nvt 0 0\ns off\n";
  text += "f 1/1/1 2/1/1 3/1/1\nf 2//1 4//1\t3//1 # comment\nf -3/1 -2/1 -4/1\nusemtl red\nl 1 2\nf 5 \\\n 1 3\n";
  text += "  f 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n";
  expect_mesh(soup, "a.obj", text);
  const std::string faces_first = faces_as_text(soup, "f", 1) + points_as_text(soup, "v ");
  expect_mesh(soup, "b.obj", faces_first);
}

TEST_F(Mesh_file, ply_with_other_properties_and_elements)
{
  const Soup soup = octahedron();
  std::string text = "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty list uchar float position\n"
                     "property uchar kind\nelement vertex 6\nproperty uchar red\nproperty double z\nproperty double x\n"
                     "property double y\nelement face 8\nproperty float quality\n"
                     "property list uint16 uint32 vertex_index\nelement edge 1\nproperty int a\nend_header\n"
                     "2 0.5 0.5 7\n";
  for(const Position& p : soup.points)
  {
    std::ostringstream line;
    line << "255 " << p[2] << ' ' << p[0] << ' ' << p[1] << '\n';
    text += line.str();
  }
  expect_mesh(soup, "a.ply", text + faces_as_text(soup, "0.25 3") + "1\n");
}

TEST_F(Mesh_file, stl_merges_equal_positions_only)
{
  // -0 equals 0; the next larger double does not equal 1
  const Soup soup = octahedron();
  expect_mesh(soup, "zero.stl", replaced(ascii_stl(soup), "vertex 0 1 0", "vertex -0.0 1 -0"));
  EXPECT_EQ(
      read("near.stl", replaced(ascii_stl(soup), "vertex 1 0 0", "vertex 1.0000000000000002 0 0")).number_of_vertices(),
      7u);
}

TEST_F(Mesh_file, stl_upper_case_and_several_solids)
{
  std::string text = ascii_stl(octahedron());
  const std::size_t second = text.find("  facet", text.find("endfacet"));
  text.insert(second, "endsolid\nsolid\n");
  expect_mesh(octahedron(), "a.stl", text);
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return static_cast<char>(std::toupper(c)); });
  expect_mesh(octahedron(), "b.stl", text);
}

TEST_F(Mesh_file, isolated_vertices_keep_the_numbers)
{
  const std::string text = replaced(replaced(off(octahedron()), "6 8 0\n", "7 8 0\n"), "3 0 1 2\n", "9 9 9\n3 0 1 2\n");
  const Mesh mesh = read("a.off", text);
  EXPECT_EQ(mesh.num_vertices(), 7u);
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_TRUE(mesh.is_removed(Mesh::Vertex_index(6)));
}

TEST_F(Mesh_file, positions_that_cannot_be_used)
{
  for(const char* value : {"nan", "inf", "-inf", "1e999"})
  {
    expect_defect(Input_defect::NON_FINITE_COORDINATE, 2, "a.off", replaced(off(octahedron()), "1.5", value),
                  {"vertex 2", "z = "});
    expect_defect(Input_defect::NON_FINITE_COORDINATE, 2, "a.obj", replaced(obj(octahedron()), "1.5", value),
                  {"vertex 2", "z = "});
  }
  Soup soup = octahedron();
  soup.points[2][2] = NAN;
  // it must not look like a hole: all corners with it are still one vertex
  for(const std::string& content : {binary_stl(soup), ascii_stl(soup), binary_ply(soup, true)})
    expect_defect(Input_defect::NON_FINITE_COORDINATE, 2, "a.mesh", content, {"vertex 2", "z = "});
}

TEST_F(Mesh_file, vertices_that_do_not_exist)
{
  const Soup soup = octahedron();
  for(const char* v : {"-1", "6", "99999999999"})
  {
    const std::string line = std::string("3 3 4 ") + v;
    expect_defect(Input_defect::INVALID_VERTEX_INDEX, 2, "a.off", replaced(off(soup), "3 3 4 2", line),
                  {"face 2", v, "of 6"});
    expect_defect(Input_defect::INVALID_VERTEX_INDEX, 2, "a.ply",
                  ply_header(soup, "ascii") + points_as_text(soup) +
                      replaced(faces_as_text(soup, "3"), "3 3 4 2", line),
                  {"face 2", v, "of 6"});
  }
  for(const char* v : {"-7", "7", "99999999999"})
    expect_defect(Input_defect::INVALID_VERTEX_INDEX, 2, "a.obj",
                  replaced(obj(soup), "f 4 5 3", std::string("f 4 5 ") + v), {"face 2"});
  expect_file_error("zero.obj", replaced(obj(soup), "f 4 5 3", "f 4 5 0"), {"line 9", "face 2", "counts from 1"});
  expect_file_error("word.obj", replaced(obj(soup), "f 4 5 3", "f 4 5 x/3"), {"line 9", "face 2", "\"x/3\""});
  expect_file_error("word.off", replaced(off(soup), "3 3 4 2", "3 3 4.5 2"), {"line 11", "face 2", "\"4.5\""});
}

TEST_F(Mesh_file, surfaces_that_cannot_be_used)
{
  const Soup soup = octahedron();
  // the projective plane with six vertices: closed, and not orientable
  Soup one_sided;
  for(int i = 0; i < 6; ++i)
    one_sided.points.push_back({{static_cast<double>(i), static_cast<double>(i * i), static_cast<double>(i % 2)}});
  one_sided.triangles = {{{0, 1, 4}}, {{0, 1, 5}}, {{0, 2, 3}}, {{0, 2, 5}}, {{0, 3, 4}},
                         {{1, 2, 3}}, {{1, 2, 4}}, {{1, 3, 5}}, {{2, 4, 5}}, {{3, 4, 5}}};
  expect_defect(Input_defect::INCONSISTENT_ORIENTATION, 7, "one_sided.obj", obj(one_sided),
                {"cannot be oriented", "between vertices 3 and 5 of face 7"});
  // a Moebius strip, which is open
  Soup strip;
  for(int i = 0; i < 5; ++i)
  {
    strip.points.push_back({{static_cast<double>(i), static_cast<double>(i * i), static_cast<double>(i % 2)}});
    strip.triangles.push_back({{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + 1) % 5),
                                static_cast<std::uint32_t>((i + 2) % 5)}});
  }
  expect_defect(Input_defect::INCONSISTENT_ORIENTATION, 3, "strip.off", off(strip),
                {"cannot be oriented", "of face 3"});
  Soup empty = soup;
  empty.triangles.clear();
  expect_file_error("empty.off", off(empty), {"point cloud", "6 points"});
  expect_defect(Input_defect::EMPTY_MESH, 0, "empty.stl", "solid\nendsolid\n", {"no face"});
  expect_defect(Input_defect::EMPTY_MESH, 0, "empty_binary.stl", binary_stl(Soup()), {"no face"});
}

TEST_F(Mesh_file, faces_of_another_orientation_are_turned)
{
  const Soup soup = octahedron();
  Soup flipped = soup;
  for(std::size_t f : {1, 5})
    std::swap(flipped.triangles[f][1], flipped.triangles[f][2]);
  constrictions::File_record record;
  const Mesh mesh = constrictions::read_mesh_file(file("flipped.obj", obj(flipped)), constrictions::Reading(), record);
  const std::vector<bool>& is_turned = record.numbering.is_turned;
  ASSERT_EQ(is_turned.size(), 8u);
  EXPECT_EQ(record.findings.count(constrictions::Finding::TURNED_FACES), 2u);
  for(Mesh::Face_index f : mesh.faces())
  {
    EXPECT_EQ(is_turned[f], f.idx() == 1 || f.idx() == 5);
    Triangle expected = flipped.triangles[f];
    if(is_turned[f])
      std::swap(expected[1], expected[2]);
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(std::uint32_t v : expected)
    {
      EXPECT_EQ(mesh.source(h).idx(), v) << f;
      h = mesh.next(h);
    }
  }
}

TEST_F(Mesh_file, seams_are_closed)
{
  // vertex 6 is at the place of vertex 2, and the first two faces use it
  Soup seam = octahedron();
  seam.points.push_back(seam.points[2]);
  seam.triangles[0][2] = seam.triangles[1][2] = 6;
  const Mesh mesh = read("seam.off", off(seam));
  EXPECT_EQ(mesh.num_vertices(), 7u);
  EXPECT_EQ(mesh.number_of_vertices(), 6u);
  EXPECT_TRUE(mesh.is_removed(Mesh::Vertex_index(6)));
  EXPECT_TRUE(mesh.is_valid(false));
  // a hole stays a hole
  seam.triangles.pop_back();
  const Mesh open = read("hole.off", off(seam));
  EXPECT_EQ(open.number_of_vertices(), 6u);
  EXPECT_EQ(open.number_of_faces(), 7u);
}

TEST_F(Mesh_file, text_where_a_number_belongs)
{
  const Soup soup = octahedron();
  expect_file_error("a.off", replaced(off(soup), "0 0 1.5", "0 0 1,5"), {"line 5", "vertex 2", "\"1,5\""});
  expect_file_error("b.off", replaced(off(soup), "0 0 1.5", "0 0"), {"line 5", "vertex 2", "the line ends"});
  expect_file_error("c.off", replaced(off(soup), "6 8", "-6 8"), {"line 2", "number of vertices", "\"-6\""});
  expect_file_error("a.obj", replaced(obj(soup), "0 0 1.5", "0 zero 1.5"), {"line 3", "vertex 2", "\"zero\""});
  expect_file_error("a.stl", replaced(ascii_stl(soup), "0 0 1.5", "0 0 1.5.0"), {"line 6", "face 0", "\"1.5.0\""});
  expect_file_error("a.ply", ply_header(soup, "ascii") + replaced(points_as_text(soup), "1.5", "x"),
                    {"line 13", "vertex 2", "\"x\""});
}

TEST_F(Mesh_file, no_truncation_goes_unnoticed)
{
  const Soup soup = octahedron();
  const auto expect_errors = [&](const std::string& name, const std::string& whole, std::size_t longest) {
    for(std::size_t n = 0; n <= longest; ++n)
    {
      SCOPED_TRACE(name + ", first bytes: " + std::to_string(n));
      try
      {
        // between two elements of a text without counts nothing tells that more should follow, but the surface is open
        EXPECT_FALSE(CGAL::is_closed(read(name, whole.substr(0, n)))) << "no error";
      }
      catch(const constrictions::Input_file_error& e)
      {
        expect_message(e.what(), {name});
      }
      catch(const Invalid_input& e)
      {
        expect_message(e.what(), {});
      }
    }
  };
  // the last index, its line end, and what follows "endsolid" are not missed
  expect_errors("a.off", off(soup), off(soup).size() - 3);
  expect_errors("a.obj", obj(soup), obj(soup).size() - 3);
  const std::string ply = ply_header(soup, "ascii") + points_as_text(soup) + faces_as_text(soup, "3");
  expect_errors("a.ply", ply, ply.size() - 3);
  expect_errors("b.ply", binary_ply(soup, false), binary_ply(soup, false).size() - 1);
  expect_errors("a.stl", ascii_stl(soup), ascii_stl(soup).rfind("endfacet") + 6);
  expect_errors("b.stl", binary_stl(soup), binary_stl(soup).size() - 1);
}

TEST_F(Mesh_file, truncated_files_name_the_place)
{
  const Soup soup = octahedron();
  const std::string text = off(soup);
  expect_file_error("a.off", text.substr(0, text.find("0 0 1.5")), {"vertex 2 of the 6"});
  expect_file_error("b.off", text.substr(0, text.find("3 3 4 2")), {"face 2 of the 8"});
  expect_file_error("a.ply", ply_header(soup, "ascii") + points_as_text(soup), {"face 0 of the 8"});
  expect_file_error("b.ply", binary_ply(soup, false).substr(0, binary_ply(soup, false).size() - 14),
                    {"face 6 of the 8"});
  expect_file_error("a.stl", binary_stl(soup).substr(0, 84 + 5 * 50 + 49), {"face 5 of the 8"});
  expect_file_error("b.stl", ascii_stl(soup).substr(0, ascii_stl(soup).rfind("endfacet")), {"face 7", "endfacet"});
}

TEST_F(Mesh_file, huge_counts_are_refused_at_once)
{
  expect_file_error("a.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", {"vertex 1 of the 2000000000"});
  expect_file_error("b.off", "OFF\n99999999999999999999999 1 0\n", {"number of vertices"});
  const std::string vertices = "element vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 2000000000\nproperty list uint int vertex_indices\nend_header\n";
  expect_file_error("a.ply", "ply\nformat ascii 1.0\n" + vertices + faces + "0 0 0\n", {"vertex 1 of the 2000000000"});
  expect_file_error("b.ply", "ply\nformat binary_little_endian 1.0\n" + vertices + faces, {"vertex 0"});
  const std::string list = "element x 1\nproperty list uint int y\n";
  expect_file_error("c.ply",
                    "ply\nformat binary_little_endian 1.0\n" + list + vertices + faces + "\xFF\xFF\xFF\xFFzzzz",
                    {"x 0 of the 1"});
  expect_file_error("a.stl", std::string(80, 'x') + "\xFF\xFF\xFF\x7F", {"face 0 of the 2147483647"});
}

TEST_F(Mesh_file, ply_headers_that_cannot_be_used)
{
  const Soup soup = octahedron();
  const std::string body = points_as_text(soup) + faces_as_text(soup, "3"), header = ply_header(soup, "ascii");
  const auto expect_error = [&](const std::string& from, const std::string& to, const std::string& part) {
    expect_file_error("a.ply", replaced(header, from, to) + body, {part});
  };
  expect_error("property float z\n", "", "\"z\"");
  expect_error("property float z\n", "property list uchar float z\n", "\"z\"");
  expect_error("property float z\n", "property vec3 z\n", "\"vec3\"");
  expect_error("vertex_indices", "triangles", "vertex_indices");
  expect_error("list uchar int vertex_indices", "int vertex_indices", "vertex_indices");
  expect_error("element face", "element faces", "point cloud");
  expect_error("element face", "element trifans", "\"trifans\"");
  expect_error("element face 8", "element face many", "\"many\"");
  expect_error("format ascii 1.0\n", "", "format");
  expect_error("format ascii", "format morse", "\"morse\"");
  expect_error("end_header\n", "", "PLY header");
}

TEST_F(Mesh_file, files_that_are_no_meshes)
{
  expect_file_error("empty.off", "", {"empty"});
  expect_file_error("blank.off", "\n \n", {"OFF"});
  expect_file_error("words.off", "Dear reader\n", {"not an OFF file"});
  expect_file_error("words.obj", "Dear reader\n", {"not an OBJ file"});
  expect_file_error("words.ply", "Dear reader\n", {"not a PLY file"});
  expect_file_error("words.stl", "Dear reader\n", {"not an STL file"});
  expect_file_error("words.txt", "Dear reader\n", {"not a mesh in a format that is read"});
  expect_file_error("zeros.bin", std::string(60, '\0'), {"not a mesh in a format that is read"});
  expect_file_error("binary.off", "OFF BINARY\n\1\2\3", {"binary OFF"});
  expect_file_error("five.off", "nOFF\n5\n1 0 0\n0 0 0 1 1\n", {"5 dimensions"});
}

TEST_F(Mesh_file, files_that_cannot_be_opened)
{
  const auto message_for = [](const std::string& name) {
    try
    {
      constrictions::read_mesh_file(name);
    }
    catch(const constrictions::Input_file_error& e)
    {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  expect_message(message_for((folder / "missing.off").string()), {"missing.off", "no such file"});
  expect_message(message_for((folder / "new\nline.off").string()), {"new?line.off", "no such file"});
  expect_message(message_for(folder.string()), {"is a folder"});
  expect_message(message_for("/dev/zero"), {"is a device"});
  const std::string closed = file("closed.off", off(octahedron()));
  std::filesystem::permissions(closed, std::filesystem::perms::none);
  if(access(closed.c_str(), R_OK) != 0) // the superuser may read everything
    expect_message(message_for(closed), {"closed.off", "cannot be opened"});
}

TEST_F(Mesh_file, loops)
{
  constrictions::File_record record;
  const Mesh mesh = constrictions::read_mesh_file(file("a.off", off(octahedron())), constrictions::Reading(), record);
  const constrictions::File_numbering& numbering = record.numbering;
  const constrictions::Loops loops = constrictions::read_loops_file(
      file("loops.txt", "# equator\r\n\r\n0 1\t3 4\r\n  # other\n2 0 5 3"), mesh, numbering);
  ASSERT_EQ(loops.vertices.size(), 2u);
  EXPECT_EQ(loops.vertices[0].size(), 4u);
  EXPECT_EQ(loops.vertices[1][2], Mesh::Vertex_index(5));
  EXPECT_EQ(loops.lines, (std::vector<std::size_t>{3, 5}));

  for(const auto& [content, part] :
      std::vector<std::pair<std::string, std::string>>{{"0 1 2\n\n0 1 6\n", "line 3: vertex 6"},
                                                       {"0 -1 2\n", "line 1: \"-1\""},
                                                       {"#\n0,1,2\n", "line 2: \"0,1,2\""}})
    try
    {
      constrictions::read_loops_file(file("bad.txt", content), mesh, numbering);
      ADD_FAILURE() << "no error, but expected: " << part;
    }
    catch(const constrictions::Input_file_error& e)
    {
      expect_message(e.what(), {"bad.txt", part});
    }
}

} // namespace test_mesh_file
