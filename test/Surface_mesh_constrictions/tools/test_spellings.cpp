// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/mesh_texts.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The ways in which programs write the same mesh.
namespace test_spellings {

using namespace mesh_texts;

typedef std::vector<std::pair<std::string, std::string>> Files; // names and contents

std::string changed_case(std::string text, int (*change)(int))
{
  std::transform(text.begin(), text.end(), text.begin(), [change](char c) { return static_cast<char>(change(c)); });
  return text;
}

std::string all_replaced(const std::string& text, const std::string& from, const std::string& to)
{
  std::string result;
  std::size_t begin = 0;
  for(std::size_t place = text.find(from); place != std::string::npos; place = text.find(from, begin))
  {
    result += text.substr(begin, place - begin) + to;
    begin = place + from.size();
  }
  return result + text.substr(begin);
}

// with a new end for each line
std::string with_line_ends(const std::string& text, const std::string& end) { return all_replaced(text, "\n", end); }

// with something put before each line
std::string indented(const std::string& text, const std::string& by)
{
  return by + all_replaced(text.substr(0, text.size() - 1), "\n", "\n" + by) + "\n";
}

std::string utf16(const std::string& text, bool is_big)
{
  std::string result = is_big ? "\xFE\xFF" : "\xFF\xFE";
  for(char c : text)
    result += is_big ? std::string(1, '\0') + c : c + std::string(1, '\0');
  return result;
}

std::string gzipped(const std::string& text)
{
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string result(deflateBound(&stream, static_cast<uLong>(text.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(&result[0]);
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

std::string ascii_ply(const Soup& soup)
{
  return ply_header(soup, "ascii") + points_as_text(soup) + faces_as_text(soup, "3");
}

// Line by line, with `f` of the element's number behind it.
std::string with_tails(const std::string& lines, const std::function<std::string(std::size_t)>& f)
{
  std::istringstream in(lines);
  std::string result, line;
  for(std::size_t i = 0; std::getline(in, line); ++i)
    result += line + f(i) + "\n";
  return result;
}

std::string with_tails(const std::string& lines, const std::string& tail)
{
  return with_tails(lines, [&tail](std::size_t) { return tail; });
}

std::string counts(const Soup& soup)
{
  return std::to_string(soup.points.size()) + ' ' + std::to_string(soup.triangles.size()) + " 0\n";
}

std::string binary_off(const Soup& soup, bool big_endian, int more_numbers = 0, bool has_colours = true,
                       const std::string& keyword = "OFF BINARY\n", bool has_colour_counts = true)
{
  std::string result = keyword;
  for(std::size_t n : {soup.points.size(), soup.triangles.size(), std::size_t(0)})
    result += bytes(static_cast<std::int32_t>(n), big_endian);
  for(const Position& p : soup.points)
  {
    for(double x : p)
      result += bytes(static_cast<float>(x), big_endian);
    for(int i = 0; i < more_numbers; ++i)
      result += bytes(0.5f, big_endian);
  }
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
  {
    result += bytes(std::int32_t(3), big_endian);
    for(std::uint32_t v : soup.triangles[f])
      result += bytes(v, big_endian);
    if(!has_colour_counts)
      continue;
    const std::int32_t colours = has_colours ? static_cast<std::int32_t>(f % 4) : 0;
    result += bytes(colours, big_endian);
    for(std::int32_t i = 0; i < colours; ++i)
      result += bytes(1.f, big_endian);
  }
  return result;
}

// what can be done to any text of lines
void add_texts(const std::string& name, const std::string& text, Files& files)
{
  const std::size_t dot = name.find('.');
  const auto add = [&](const std::string& how, const std::string& content) {
    files.emplace_back(name.substr(0, dot) + "_" + how + name.substr(dot), content);
  };
  add("plain", text);
  add("crlf", with_line_ends(text, "\r\n"));
  add("cr", with_line_ends(text, "\r"));
  add("no_last_line_end", text.substr(0, text.size() - 1));
  add("ctrl_z", text + "\x1A");
  add("byte_order_mark", "\xEF\xBB\xBF" + text);
  add("utf16_little", utf16(text, false));
  add("utf16_big", utf16(text, true));
  add("blank_lines_behind", text + "\n \n\t\n");
  files.emplace_back(name + ".gz", gzipped(text));
  files.emplace_back("gzipped_" + name, gzipped(text));
  files.emplace_back("two_pieces_" + name + ".gz",
                     gzipped(text.substr(0, text.size() / 2)) + gzipped(text.substr(text.size() / 2)));
  files.emplace_back(name.substr(0, dot) + "_" + name.substr(dot + 1) + "_without_extension", text);
}

Files off_files()
{
  const Soup soup = octahedron();
  const std::string points = points_as_text(soup), faces = faces_as_text(soup, "3"), text = off(soup);
  const std::string head = "\n" + counts(soup);
  Files files;
  add_texts("a.off", text, files);
  const auto add = [&files](const std::string& name, const std::string& content) {
    files.emplace_back(name + ".off", content);
  };
  add("lower_case", "off" + head + points + faces);
  add("mixed_case", "Off" + head + points + faces);
  add("blanks_before", "   \t OFF" + head + points + faces);
  add("lines_before", "\n\n# comment\n\nOFF" + head + points + faces);
  add("blank_behind", "OFF  " + head + points + faces);
  add("one_line_header", "OFF " + counts(soup) + points + faces);
  add("no_keyword", counts(soup) + points + faces);
  add("two_counts", "OFF\n6 8\n" + points + faces);
  add("counts_on_lines", "OFF\n6\n8\n0\n" + points + faces);
  add("one_number_a_line", all_replaced("OFF" + head + points + faces, " ", "\n"));
  add("all_on_one_line", all_replaced(text, "\n", " ") + "\n");
  add("two_vertices_a_line", "OFF" + head + with_tails(all_replaced(points, "\n", " "), "") + faces);
  add("faces_on_one_line", "OFF" + head + points + all_replaced(faces, "\n", " ") + "\n");
  add("tabs", all_replaced(text, " ", "\t"));
  add("commas",
      all_replaced(all_replaced(points_as_text(soup), " ", ", "), "\n", "\n").insert(0, "OFF" + head) + faces);
  add("indented", "OFF" + head + indented(points + faces, "  "));
  add("comments", "OFF # shape\n# by hand" + head + with_tails(points, " # vertex") + "# faces\n" + faces);
  add("exponents", "OFF" + head + all_replaced(points, "1.5", "+1.5E+00") + faces);
  add("fortran", "OFF" + head + all_replaced(points, "1.5", "0.15D+01") + faces);
  add("short_numbers", "OFF" + head + all_replaced(all_replaced(points, "-0.25", "-.25"), "1.5", "1.50") + faces);
  add("whole_numbers_with_points", "OFF" + head + points + all_replaced(faces, "3 0 1 2", "3.0 0. 1.0 2.00"));
  add("face_colours", "OFF" + head + points + with_tails(faces, " 255 0 0"));
  add("face_colours_sometimes", "OFF" + head + points + with_tails(faces, [](std::size_t i) {
                                  return i % 2 == 0 ? std::string(" 0.5 0.5 0.5 1") : std::string();
                                }));
  add("coff", "COFF" + head + with_tails(points, " 255 0 0 255") + faces);
  add("coff_lower", "coff" + head + with_tails(points, " 1 0 0") + faces);
  add("noff", "NOFF" + head + with_tails(points, " 0 0 1") + faces);
  add("cnoff", "CNOFF" + head + with_tails(points, " 0 0 1 1 1 1 1") + faces);
  add("stoff", "STOFF" + head + with_tails(points, " 0.5 0.5") + faces);
  add("stcnoff", "STCNOFF" + head + with_tails(points, " 0 0 1 1 1 1 1 0 0") + faces);
  add("ncoff", "NCOFF" + head + with_tails(points, " 0 0 1 1 1 1 1") + faces);
  add("nstoff_in_words", all_replaced("NSTOFF" + head + with_tails(points, " 0 0 1 0 0") + faces, " ", "\n"));
  add("comments_behind_numbers", "OFF#shape" + head + with_tails(points, "#vertex") + with_tails(faces, "#face"));
  add("4off", "4OFF" + head + with_tails(points, " 1") + faces);
  add("4off_scaled", "4OFF" + head + "2 0 0 2\n0 -1 0 -1\n0 0 3 2\n-4 0 0 4\n0 -1 0 1\n0 0 -0.5 2\n" + faces);
  add("noff_of_three", "nOFF 3" + head + points + faces);
  add("noff_in_words", all_replaced("NOFF" + head + with_tails(points, " 0 0 1") + faces, " ", "\n"));
  add("binary", binary_off(soup, true));
  add("binary_little", binary_off(soup, false));
  add("binary_no_colours", binary_off(soup, true, 0, false));
  add("binary_lower", binary_off(soup, true, 0, true, "off binary\n"));
  add("binary_nothing_of_colours", binary_off(soup, true, 0, false, "OFF BINARY\n", false));
  add("binary_noff", binary_off(soup, true, 3, true, "NOFF BINARY\n"));
  add("binary_coff", binary_off(soup, true, 4, true, "COFF BINARY\n"));
  add("binary_crlf", binary_off(soup, true, 0, true, "OFF BINARY\r\n"));
  files.emplace_back("binary.off.gz", gzipped(binary_off(soup, true)));
  return files;
}

Files obj_files()
{
  const Soup soup = octahedron();
  const std::string points = points_as_text(soup, "v "), faces = faces_as_text(soup, "f", 1), text = obj(soup);
  Files files;
  add_texts("a.obj", text, files);
  const auto add = [&files](const std::string& name, const std::string& content) {
    files.emplace_back(name + ".obj", content);
  };
  std::string slashes, normals, both, negative, continued, broken;
  for(const Triangle& t : soup.triangles)
  {
    slashes += "f", normals += "f", both += "f", negative += "f", continued += "f", broken += "f";
    for(std::uint32_t v : t)
    {
      const std::string n = std::to_string(v + 1);
      slashes += ' ' + n + "/1";
      normals += ' ' + n + "//1";
      both += ' ' + n + "/1/1";
      negative += ' ' + std::to_string(static_cast<int>(v) - 6);
      continued += " \\\n" + n;
      broken += ' ' + n + "\\\n";
    }
    for(std::string* s : {&slashes, &normals, &both, &negative, &continued, &broken})
      *s += '\n';
  }
  add("textures", points + "vt 0 0\n" + slashes);
  add("normals", points + "vn 0 0 1\n" + normals);
  add("textures_and_normals", points + "vt 0 0\nvn 0 0 1\n" + both);
  add("negative", points + negative);
  add("continued", points + continued);
  add("broken_words", points + broken);
  add("colours", with_tails(points, " 0.5 0.5 0.5") + faces);
  add("weights", with_tails(points, " 1.0") + faces);
  add("faces_first", faces + points);
  add("groups", "mtllib a.mtl\no thing\n" + points + "g all\nusemtl red\ns 1\n" + faces);
  add("smoothing_first", "s off\n" + text);
  add("lines_and_points", points + faces + "l 1 2\np 3\n");
  add("capitals", changed_case(text, std::toupper));
  add("tabs", all_replaced(text, " ", "\t"));
  add("two_blanks", all_replaced(text, " ", "  "));
  add("blank_behind", with_tails(text, " "));
  add("comments", "# by hand\n" + with_tails(points, " # vertex") + faces);
  add("comments_behind_numbers", with_tails(points, "# vertex") + with_tails(faces, "#face"));
  add("old_faces", points + faces_as_text(soup, "fo", 1));
  add("indented", indented(text, "  "));
  return files;
}

Files ply_files()
{
  const Soup soup = octahedron();
  const std::string points = points_as_text(soup), faces = faces_as_text(soup, "3"), text = ascii_ply(soup);
  const std::string header = ply_header(soup, "ascii");
  Files files;
  add_texts("a.ply", text, files);
  const auto add = [&files](const std::string& name, const std::string& content) {
    files.emplace_back(name + ".ply", content);
  };
  add("one_number_a_line", header + all_replaced(points + faces, " ", "\n"));
  add("all_on_one_line", header + all_replaced(points + faces, "\n", " ") + "\n");
  add("more_numbers", header + with_tails(points, " 1 2 3") + faces);
  add("vertex_index", replaced(text, "vertex_indices", "vertex_index"));
  add("doubles", all_replaced(text, "property float ", "property double "));
  add("sized_types", replaced(replaced(all_replaced(text, "float", "float32"), "uchar", "uint8"), "int ", "int32 "));
  add("little", binary_ply(soup, false));
  add("big", binary_ply(soup, true));
  const std::string body = binary_ply(soup, false).substr(ply_header(soup, "binary_little_endian").size());
  add("little_crlf", with_crlf(ply_header(soup, "binary_little_endian")) + body);
  add("little_cr", with_line_ends(ply_header(soup, "binary_little_endian"), "\r") + body);
  add("bytes_behind", binary_ply(soup, false) + "xyz");
  files.emplace_back("little.ply.gz", gzipped(binary_ply(soup, false)));
  const std::string vertex_bytes = body.substr(0, soup.points.size() * 12);
  const auto binary_faces = [&](auto index) {
    std::string result;
    for(const Triangle& t : soup.triangles)
    {
      result += '\3';
      for(std::uint32_t v : t)
        result += bytes(static_cast<decltype(index)>(v));
    }
    return result;
  };
  const auto with_type = [&](const std::string& type) {
    return replaced(ply_header(soup, "binary_little_endian"), "uchar int ", "uchar " + type + " ");
  };
  add("short", with_type("short") + vertex_bytes + binary_faces(std::int16_t()));
  add("ushort", with_type("ushort") + vertex_bytes + binary_faces(std::uint16_t()));
  add("uchar", with_type("uchar") + vertex_bytes + binary_faces(std::uint8_t()));
  add("uint", with_type("uint") + vertex_bytes + binary_faces(std::uint32_t()));
  add("long", with_type("int64") + vertex_bytes + binary_faces(std::int64_t()));
  add("ulong", with_type("ulong") + vertex_bytes + binary_faces(std::uint64_t()));
  add("capitals", changed_case(header, std::toupper) + points + faces);
  add("mixed_case", replaced(all_replaced(text, "property float ", "Property Float "), "format ascii", "FORMAT ASCII"));
  add("lines_before", "\n \n" + text);
  add("indented", indented(text, "  "));
  add("comments", replaced(text, "element face", "comment a\nobj_info b\nelement face"));
  // of the strips 0 1 2 5 ... only what makes the octahedron: each triangle as a strip of its own
  std::string strips = "31";
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
  {
    for(std::uint32_t v : soup.triangles[f])
      strips += ' ' + std::to_string(v);
    strips += f + 1 < soup.triangles.size() ? " -1" : "\n";
  }
  add("tristrips", replaced(header, "element face 8\nproperty list uchar", "element tristrips 1\nproperty list int") +
                       points + strips);
  return files;
}

Files stl_files()
{
  const Soup soup = octahedron();
  const std::string text = ascii_stl(soup);
  Files files;
  add_texts("a.stl", text, files);
  const auto add = [&files](const std::string& name, const std::string& content) {
    files.emplace_back(name + ".stl", content);
  };
  const std::string end = "endsolid facet of a name\n";
  add("capitals", changed_case(text, std::toupper));
  add("words_behind_endfacet", all_replaced(text, "endfacet", "endfacet 1 2"));
  add("words_behind_endloop", all_replaced(text, "endloop", "endloop x"));
  add("words_behind_outer_loop", all_replaced(text, "outer loop", "outer loop 7"));
  add("words_behind_vertex", with_tails(text, " "));
  add("colour_lines", all_replaced(text, "  facet", "color 0.5 0.5 0.5\n  facet"));
  add("no_endsolid", replaced(text, end, ""));
  add("bare_endsolid", replaced(text, end, "endsolid\n"));
  add("no_name", replaced(replaced(text, "solid facet of a name", "solid"), end, "endsolid\n"));
  add("no_solid", text.substr(text.find('\n') + 1));
  add("no_indentation", all_replaced(all_replaced(text, "  ", ""), "  ", ""));
  add("one_line", all_replaced(replaced(replaced(text, "solid facet of a name", "solid"), end, "endsolid"), "\n", " "));
  add("one_number_a_line",
      all_replaced(all_replaced(replaced(replaced(text, "solid facet of a name", "solid"), end, "endsolid"), "vertex ",
                                "vertex\n"),
                   " ", "\n"));
  add("tabs", all_replaced(text, "  ", "\t"));
  add("exponents", all_replaced(text, "1.5", "1.500000e+00"));
  std::string two_solids = text;
  two_solids.insert(two_solids.find("  facet", two_solids.find("endfacet")), "endsolid a\nsolid b\n");
  add("two_solids", two_solids);
  add("binary", binary_stl(soup));
  add("binary_solid", binary_stl(soup, "solid but binary"));
  add("binary_bytes_behind", binary_stl(soup) + "xy");
  add("binary_off_and_bytes_behind", binary_stl(soup, "OFF file of a program") + "xy");
  // the first 80 bytes may be those with which another kind of file begins
  int titles = 0;
  for(const char* title :
      {"OFF file of a program", "v 1.0", "o body", "g body", "s 1", "ply to STL", "ply\nformat", "COFF\n8 6 12\n",
       "STOFF", "solid of text\nfacet\nendfacet", "12 20 30", "# by hand", "\xEF\xBB\xBF_body", "\xFF\xFE_b_o_d_y",
       "\xFE\xFF_b_o_d_y", "\x1F\x8B\x08_packed", "\n\n\n"})
  {
    const std::string content = binary_stl(soup, title);
    add("binary_title_" + std::to_string(++titles), content);
    files.emplace_back("binary_title_" + std::to_string(titles) + "_without_extension", content);
  }
  add("comment_of_another_kind_before", "// by hand\n" + text);
  add("zero_bytes_in_name", replaced(text, "solid facet of a name", "solid facet" + std::string(2, '\0')));
  add("binary_number_0", binary_stl(soup).replace(80, 4, std::string(4, '\0')));
  add("binary_number_unknown", binary_stl(soup).replace(80, 4, "\xFF\xFF\xFF\xFF"));
  files.emplace_back("binary.stl.gz", gzipped(binary_stl(soup)));
  return files;
}

// Each is read as the octahedron, all vertices and faces in their order.
class Spellings : public Mesh_file
{
protected:
  void expect_octahedron(const Files& files) const
  {
    for(const auto& [name, content] : files)
      expect_mesh(octahedron(), name, content);
  }
};

TEST_F(Spellings, of_off) { expect_octahedron(off_files()); }
TEST_F(Spellings, of_obj) { expect_octahedron(obj_files()); }
TEST_F(Spellings, of_ply) { expect_octahedron(ply_files()); }
TEST_F(Spellings, of_stl) { expect_octahedron(stl_files()); }

TEST_F(Spellings, are_more_than_120)
{
  std::map<std::string, int> names;
  for(const Files& files : {off_files(), obj_files(), ply_files(), stl_files()})
    for(const auto& file : files)
      EXPECT_EQ(++names[file.first], 1) << file.first;
  EXPECT_GE(names.size(), 120u);
}

TEST_F(Spellings, small_numbers_below_zero_go_on_in_ply)
{
  // 40,000 vertices, of which the last face names one as -25536
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 40000\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 4\nproperty list uchar short vertex_indices\nend_header\n";
  for(int v = 0; v < 40000; ++v)
    for(int i = 0; i < 3; ++i)
      text += bytes(v == 39999 - i ? 1.f : 0.f);
  for(const std::array<int, 3>& t :
      {std::array<int, 3>{0, 39998, 39999}, {0, 39999, 39997}, {0, 39997, 39998}, {39999, 39998, 39997}})
  {
    text += '\3';
    for(int v : t)
      text += bytes(static_cast<std::int16_t>(v));
  }
  const Mesh mesh = read("a.ply", text);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_EQ(mesh.number_of_vertices(), 4u);
}

TEST_F(Spellings, tristrips_turn_every_other_triangle)
{
  // a tetrahedron is one strip: 0 1 2 3 0 1
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                           "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                           "0 0 0\n0 1 0\n1 0 0\n0 0 1\n6 0 1 2 3 0 1\n";
  constrictions::File_record record;
  const Mesh mesh = constrictions::read_mesh_file(file("a.ply", text), constrictions::Reading(), record);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_FALSE(record.findings.has_repairs()) << constrictions::summary_of(record.findings);
}

TEST_F(Spellings, point_clouds_are_told)
{
  const Soup soup = octahedron();
  const std::string points = points_as_text(soup);
  expect_file_error("a.off", "OFF\n6 0 0\n" + points, {"point cloud", "6 points"});
  expect_file_error("a.obj", points_as_text(soup, "v "), {"point cloud", "6 points"});
  const std::string header = ply_header(soup, "ascii");
  expect_file_error("a.ply", header.substr(0, header.find("element face")) + "end_header\n" + points,
                    {"point cloud", "6 points"});
  expect_file_error("b.ply", replaced(header, "face 8", "face 0") + points, {"point cloud", "6 points"});
  expect_file_error("a.xyz", points, {"point cloud"});
  expect_file_error("a.txt", with_tails(points, " 0 0 1"), {"point cloud"});
}

TEST_F(Spellings, damaged_gzip_files)
{
  std::string packed = gzipped(off(octahedron()));
  expect_file_error("short.off.gz", packed.substr(0, packed.size() / 2), {"ends too early"});
  packed[packed.size() / 2] = static_cast<char>(packed[packed.size() / 2] ^ 0x55);
  packed[packed.size() / 2 + 1] = static_cast<char>(packed[packed.size() / 2 + 1] ^ 0x55);
  expect_file_error("damaged.off.gz", packed, {"damaged.off.gz"});
  expect_file_error("nothing.off.gz", gzipped(""), {"empty"});
}

TEST_F(Spellings, refused_with_a_reason)
{
  const Soup soup = octahedron();
  expect_file_error("a.off", "5OFF\n" + counts(soup) + points_as_text(soup), {"OFF"});
  expect_file_error("b.off", "nOFF\n5\n" + counts(soup) + points_as_text(soup), {"5 dimensions"});
  expect_file_error("decimal_comma.off", replaced(off(soup), "1.5", "1,5"), {"line 5", "\"1,5\""});
  expect_file_error("more_than_announced.stl", binary_stl(soup).replace(80, 1, "\5"), {"announces 5 faces", "of 8"});
  expect_file_error("half.stl", ascii_stl(soup).substr(0, ascii_stl(soup).rfind("endloop")), {"face 7", "endfacet"});
}

} // namespace test_spellings
