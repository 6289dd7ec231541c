// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/scene_texts.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <string>
#include <vector>

// Files of VTK and of scenes.
namespace test_scene_files {

using namespace scene_texts;

const bool has_xml = CONSTRICTIONS_HAS_XML, has_zip = CONSTRICTIONS_HAS_ZIP;

class Scene_files : public Mesh_file
{
protected:
  // The bounds of the x-coordinate of a mesh, and its volume.
  static std::vector<double> measures(const Mesh& mesh)
  {
    double low = 1e300, high = -1e300;
    for(Mesh::Vertex_index v : mesh.vertices())
    {
      low = (std::min)(low, mesh.point(v).x());
      high = (std::max)(high, mesh.point(v).x());
    }
    return {low, high, CGAL::Polygon_mesh_processing::volume(mesh)};
  }

  static void expect_measures(const Mesh& mesh, const std::vector<double>& expected)
  {
    const std::vector<double> found = measures(mesh);
    for(std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_DOUBLE_EQ(found[i], expected[i]) << i;
  }

  const Soup soup = octahedron();
  const double volume = 1.75 * 2 / 3; // two pyramids over a square of area 2
};

TEST_F(Scene_files, legacy_vtk)
{
  expect_mesh(soup, "ascii.vtk", ascii_vtk(soup));
  expect_mesh(soup, "crlf.vtk", with_crlf(ascii_vtk(soup)));
  expect_mesh(soup, "binary.vtk", binary_vtk(soup));
  expect_mesh(soup, "binary_5.vtk", binary_vtk_5(soup));
  expect_mesh(soup, "without_extension", binary_vtk(soup));
  // vertices and lines are not of the surface
  expect_mesh(soup, "lines.vtk",
              replaced(ascii_vtk(soup), "POLYGONS", "VERTICES 1 2\n1 0\nLINES 2 7\n2 0 1\n3 1 2 3\nPOLYGONS"));
  std::string grid = replaced(ascii_vtk(soup), "POLYDATA", "UNSTRUCTURED_GRID");
  grid = replaced(grid, "POLYGONS 8 32", "CELLS 9 35\n2 0 1");
  grid = replaced(grid, "CELL_DATA 8", "CELL_TYPES 9\n3 5 5 5 5 5 5 5 5\nCELL_DATA 9");
  expect_mesh(soup, "grid.vtk", grid);
}

TEST_F(Scene_files, strips_of_vtk)
{
  // a tetrahedron is one strip
  const std::string points = "POINTS 4 int\n0 0 0 0 1 0 1 0 0 0 0 1\n";
  const Mesh mesh = read("strip.vtk", vtk_header("ASCII") + points + "TRIANGLE_STRIPS 1 7\n6 0 1 2 3 0 1\n");
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  // polygons come first, whatever the order in the file
  const Mesh both = read("both.vtk", vtk_header("ASCII") + points + "TRIANGLE_STRIPS 1 5\n4 1 2 3 0\n" +
                                         "POLYGONS 2 8\n3 0 2 1\n3 0 1 3\n");
  EXPECT_EQ(both.number_of_faces(), 4u);
  EXPECT_EQ(both.source(both.halfedge(Mesh::Face_index(0))).idx(), 0u);
  EXPECT_EQ(both.source(both.halfedge(Mesh::Face_index(2))).idx(), 1u);
}

TEST_F(Scene_files, what_is_wrong_with_a_vtk_file_is_told)
{
  const std::string text = ascii_vtk(soup), data = binary_vtk(soup);
  expect_file_error("type.vtk", replaced(text, "POLYDATA", "RECTILINEAR_GRID"), {"line 4", "rectilinear_grid"});
  expect_file_error("encoding.vtk", replaced(text, "ASCII", "ASKII"), {"line 3", "ASCII or BINARY"});
  expect_file_error("word.vtk", replaced(text, "1.5", "1,5"), {"line 8", "\"1,5\""});
  expect_file_error("short.vtk", data.substr(0, data.size() / 2), {"the file ends", "number"});
  expect_file_error("count.vtk", replaced(text, "8 32", "7 32"), {"32 numbers are not those of 7 cells"});
  expect_file_error("many.vtk", replaced(text, "POINTS 6", "POINTS 999999999"), {"POINTS", "too short"});
  expect_file_error("keyword.vtk", replaced(text, "POLYGONS", "POLYGON"), {"unknown keyword \"polygon\""});
  expect_file_error("field.vtk", replaced(text, "POINTS 6", "FIELD f 1\nTime\x02 x\nPOINTS 6"),
                    {"line 6: \"Time?\": \"x\" is not a number"});
  expect_file_error("name.vtk", "POINTS\n", {"it does not begin with the words \"# vtk DataFile\""});
  expect_defect(Input_defect::INVALID_VERTEX_INDEX, 0, "vertex.vtk", replaced(text, "3 0 1 2", "3 0 1 6"),
                {"face 0 refers to vertex 6 of 6"});
  std::string grid = replaced(ascii_vtk(soup), "POLYDATA", "UNSTRUCTURED_GRID");
  grid = replaced(grid, "POLYGONS", "CELLS");
  expect_file_error("none.vtk", grid, {"0 CELL_TYPES for 8 CELLS"});
  expect_file_error("solid.vtk", replaced(grid, "CELL_DATA", "CELL_TYPES 8\n5 5 10 5 5 5 5 5\nCELL_DATA"),
                    {"cell 2 is of type 10"});
}

TEST_F(Scene_files, vtp_in_every_encoding)
{
  if(!has_xml)
    GTEST_SKIP() << "expat, with which VTP files are read, is not installed";
  int n = 0;
  for(const std::string format : {"ascii", "binary", "appended"})
    for(int flags = 0; flags < (format == "ascii" ? 1 : 32); ++flags)
    {
      Vtp_spelling spelling;
      spelling.format = format;
      spelling.is_raw = (flags & 1) != 0;
      spelling.is_big = (flags & 2) != 0;
      spelling.has_long_header = (flags & 4) != 0;
      spelling.is_compressed = (flags & 8) != 0;
      spelling.has_doubles = (flags & 16) != 0;
      if(spelling.is_raw && format != "appended")
        continue;
      expect_mesh(soup, format + std::to_string(flags) + ".vtp", Vtp_text(soup, spelling).text);
      ++n;
    }
  EXPECT_EQ(n, 49);
}

TEST_F(Scene_files, pieces_of_vtp_follow_each_other)
{
  if(!has_xml)
    GTEST_SKIP() << "expat, with which VTP files are read, is not installed";
  const std::string text = Vtp_text(soup, {"ascii"}).text;
  const std::size_t begin = text.find("<Piece"), end = text.find("</PolyData>");
  const std::string piece = text.substr(begin, end - begin);
  Soup far = soup;
  for(Position& p : far.points)
    p[0] += 10;
  const std::string other = Vtp_text(far, {"ascii"}).text;
  const Mesh mesh = read("two.vtp", text.substr(0, end) + other.substr(other.find("<Piece")));
  EXPECT_EQ(mesh.number_of_faces(), 16u);
  expect_measures(mesh, {-1, 11, 2 * volume});
  // the strip of a tetrahedron
  std::string strip = replaced(piece, "NumberOfStrips=\"0\"", "NumberOfStrips=\"1\"");
  strip = replaced(strip, "NumberOfPolys=\"8\"", "NumberOfPolys=\"0\"");
  strip = strip.substr(0, strip.find("<Polys>")) +
          "<Strips><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 0 1</DataArray>"
          "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">6</DataArray></Strips></Piece>";
  EXPECT_EQ(read("strip.vtp", text.substr(0, begin) + strip + text.substr(end)).number_of_faces(), 4u);
}

TEST_F(Scene_files, what_is_wrong_with_a_vtp_file_is_told)
{
  const std::string text = Vtp_text(soup, {"ascii"}).text;
  if(!has_xml)
  {
    expect_file_error("a.vtp", text, {"without expat"});
    return;
  }
  expect_file_error("grid.vtp", replaced(text, "PolyData", "UnstructuredGrid"), {"line 2", "UnstructuredGrid"});
  expect_file_error("open.vtp", text.substr(0, text.find("</Points>")), {"line"});
  expect_file_error("word.vtp", replaced(text, "1.5", "1,5"), {"\"Points\"", "\"1,5\""});
  expect_file_error("points.vtp", replaced(text, "NumberOfPoints=\"6\"", "NumberOfPoints=\"7\""),
                    {"piece 0", "18 coordinates for 7 points"});
  expect_file_error("number.vtp", replaced(text, "NumberOfPoints=\"6\"", "NumberOfPoints=\"six\""),
                    {"line 3", "\"six\""});
  expect_file_error("cells.vtp", replaced(text, "NumberOfPolys=\"8\"", "NumberOfPolys=\"9\""),
                    {"8 offsets for 9 cells"});
  expect_file_error("offsets.vtp", replaced(text, "3 6 9", "3 99 9"), {"cell 1", "99 of 24"});
  expect_file_error("back.vtp", replaced(text, "3 6 9", "3 2 9"), {"cell 1"});
  expect_defect(Input_defect::INVALID_VERTEX_INDEX, 0, "vertex.vtp", replaced(text, "0 1 2 ", "0 1 6 "),
                {"face 0 refers to vertex 6 of 6"});
  const std::string binary = Vtp_text(soup, {"binary"}).text;
  const std::size_t place = binary.find("  ", binary.find("Points\"")) + 10;
  expect_file_error("base64.vtp", std::string(binary).replace(place, 1, "!"), {"\"Points\"", "not in base64"});
  expect_file_error("type.vtp", replaced(binary, "Float32", "Float16"), {"\"Float16\""});
  Vtp_spelling spelling;
  spelling.format = "appended";
  spelling.is_raw = spelling.is_compressed = true;
  const std::string raw = Vtp_text(soup, spelling).text, mark = "<AppendedData encoding=\"raw\">\n _";
  const std::size_t data = raw.find(mark) + mark.size();
  expect_file_error("short.vtp", raw.substr(0, data + 20), {"\"Points\"", "it ends after"});
  expect_file_error("blocks.vtp", std::string(raw).replace(data + 2, 2, "\xFF\xFF"), {"\"Points\"", "blocks"});
  std::string damaged = raw;
  for(std::size_t i = 30; i < 40; ++i)
    damaged[data + i] = static_cast<char>(damaged[data + i] ^ 0x5A);
  expect_file_error("damaged.vtp", damaged, {"block", "is damaged"});
  // a size that no compression can reach
  expect_file_error("bomb.vtp", std::string(raw).replace(data + 7, 1, "\x7F"), {"is damaged"});
  expect_file_error("lz4.vtp", replaced(raw, "vtkZLib", "vtkLZ4"), {"vtkLZ4DataCompressor", "zlib"});
}

TEST_F(Scene_files, glb)
{
  expect_mesh(soup, "a.glb", glb(soup));
  expect_mesh(soup, "without_extension", glb(soup));
  // a node that is of no scene is not shown
  expect_mesh(soup, "hidden.glb", glb(soup, R"([{"mesh": 0}, {"mesh": 0}])"));
  expect_mesh(soup, "child.glb", glb(soup, R"([{"children": [1]}, {"mesh": 0}])"));
}

TEST_F(Scene_files, nodes_put_meshes_into_their_places)
{
  // scaled, then moved; and a copy that is mirrored, whose outside stays outside
  const Mesh mesh = read("two.glb", glb(soup,
                                        R"([{"children": [1, 2], "translation": [10, 0, 0], "scale": [2, 2, 2]},
                                            {"mesh": 0, "translation": [1, 0, 0]},
                                            {"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, -3,0,0,1]}])"));
  EXPECT_EQ(mesh.number_of_faces(), 16u);
  expect_measures(mesh, {2, 14, 16 * volume});
  // turned by a quarter around the z-axis: x becomes y
  const double h = std::sqrt(0.5);
  const Mesh turned = read("turned.glb", glb(soup, R"([{"mesh": 0, "rotation": [0, 0, )" + std::to_string(h) + ", " +
                                                       std::to_string(h) + R"(], "scale": [3, 1, 1]}])"));
  EXPECT_NEAR(turned.point(Mesh::Vertex_index(0)).y(), 3, 1e-5);
  EXPECT_NEAR(turned.point(Mesh::Vertex_index(1)).x(), -1, 1e-5);
  EXPECT_NEAR(measures(turned)[2], 3 * volume, 1e-4);
}

TEST_F(Scene_files, other_spellings_of_glb)
{
  const std::string points = bytes_of<float>(coordinates(soup)), of_faces = bytes_of<std::uint8_t>(corners(soup));
  // numbers in the JSON, and an accessor of bytes
  const std::string embedded =
      R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0},
          "indices": 1}]}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
          {"bufferView": 0, "byteOffset": 72, "componentType": 5121, "count": 24, "type": "SCALAR"}],
          "bufferViews": [{"buffer": 0, "byteLength": 96}],
          "buffers": [{"byteLength": 96, "uri": "data:application/octet-stream;base64,)" +
      constrictions::as_base64(points + of_faces) + "\"}]}";
  expect_mesh(soup, "embedded.glb", glb_of(embedded, ""));
  // a strip, a fan, points between other numbers, and integers that stand for numbers up to 1
  const std::string four =
      bytes_of<std::uint16_t>(std::vector<int>{0, 0, 0, 7, 0, 65535, 0, 7, 65535, 0, 0, 7, 0, 0, 65535, 7});
  const std::string quantized =
      R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"], "nodes": [{"mesh": 0}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5, "indices": 1},
          {"attributes": {"POSITION": 0}, "mode": 6, "indices": 2}]}],
          "accessors": [{"bufferView": 0, "componentType": 5123, "normalized": true, "count": 4, "type": "VEC3"},
          {"bufferView": 1, "componentType": 5121, "count": 4, "type": "SCALAR"},
          {"bufferView": 1, "byteOffset": 4, "componentType": 5121, "count": 4, "type": "SCALAR"}],
          "bufferViews": [{"buffer": 0, "byteLength": 32, "byteStride": 8},
          {"buffer": 0, "byteOffset": 32, "byteLength": 8}], "buffers": [{"byteLength": 40}]})";
  const Mesh mesh = read("quantized.glb", glb_of(quantized, four + std::string("\0\1\2\3\0\1\3\2", 8)));
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_DOUBLE_EQ(std::abs(measures(mesh)[2]), 1. / 6);
}

TEST_F(Scene_files, what_is_wrong_with_a_glb_file_is_told)
{
  const std::string good = glb(soup);
  expect_file_error("short.glb", good.substr(0, 15), {"too short"});
  expect_file_error("half.glb", good.substr(0, good.size() - 40), {"ends within chunk"});
  expect_file_error("version.glb", std::string(good).replace(4, 1, "\1"), {"version 1"});
  expect_file_error("name.glb", "something", {"does not begin with the letters glTF"});
  expect_file_error("words.gltf", "{}", {"GLB"});
  expect_file_error("json.glb", glb_of("{", ""), {"JSON"});
  expect_file_error("array.glb", glb_of("[]", ""), {"not an object"});
  expect_file_error("node.glb", glb(soup, R"([{"mesh": 0}])", "[1]"), {"nodes[1]", "there is none"});
  expect_file_error("mesh.glb", glb(soup, R"([{"mesh": 3}])"), {"meshes[3]", "there is none"});
  expect_file_error("loop.glb", glb(soup, R"([{"children": [0]}])"), {"nodes[0]", "inside itself"});
  expect_file_error("matrix.glb", glb(soup, R"([{"mesh": 0, "matrix": [1, 2]}])"), {"nodes[0]", "16 numbers"});
  expect_file_error("uri.glb", glb_of(R"({"buffers": [{"byteLength": 3, "uri": "a.bin"}]})", ""),
                    {"another file", "a.bin"});
  expect_file_error("draco.glb", glb_of(R"({"extensionsRequired": ["KHR_draco_mesh_compression"]})", ""),
                    {"KHR_draco_mesh_compression"});
  std::string many = good;
  many = replaced(many, "\"count\": 24", "\"count\": 99");
  expect_file_error("many.glb", many, {"accessors[1]", "99 elements do not fit"});
  expect_defect(
      Input_defect::INVALID_VERTEX_INDEX, 0, "vertex.glb",
      std::string(good).replace(good.rfind(bytes_of<std::uint16_t>(corners(soup))), 2, std::string("\x09\0", 2)),
      {"refers to vertex 9 of 6"});
  expect_file_error("points.glb", replaced(good, "\"mode\": 1", "\"mode\": 9"), {"primitive 1", "mode is 9"});
}

TEST_F(Scene_files, objects_of_3mf_are_put_into_their_places)
{
  if(!has_xml || !has_zip)
    GTEST_SKIP() << "expat or libzip, with which 3MF files are read, is not installed";
  const std::string object = object_3mf(soup, "7");
  expect_mesh(soup, "a.3mf", archive_3mf(model_3mf(object, "<item objectid=\"7\"/>")));
  expect_mesh(soup, "without_extension", archive_3mf(model_3mf(object, "<item objectid=\"7\"/>")));
  // components are scaled, then moved; one is mirrored
  const std::string group = "<object id=\"8\"><components>"
                            "<component objectid=\"7\" transform=\"2 0 0 0 2 0 0 0 2 10 0 0\"/>"
                            "<component objectid=\"7\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>";
  const Mesh mesh = read("two.3mf", archive_3mf(model_3mf(object + group, "<item objectid=\"8\" transform="
                                                                          "\"1 0 0 0 1 0 0 0 1 5 0 0\"/>")));
  EXPECT_EQ(mesh.number_of_faces(), 16u);
  expect_measures(mesh, {4, 17, 9 * volume});
  // an object in another file of the archive
  const std::string elsewhere = archive_3mf(
      model_3mf("<object id=\"1\"><components><component objectid=\"7\" p:path=\"/3D/parts/one.model\"/></components>"
                "</object>",
                "<item objectid=\"1\"/>"),
      {{"3D/parts/one.model", model_3mf(object, "")}});
  expect_mesh(soup, "elsewhere.3mf", elsewhere);
}

TEST_F(Scene_files, coordinates_of_3mf_are_in_the_unit_of_its_model)
{
  if(!has_xml || !has_zip)
    GTEST_SKIP() << "expat or libzip, with which 3MF files are read, is not installed";
  constrictions::File_record record;
  const auto measures_of = [&](const std::string& name, const std::string& content) {
    return measures(constrictions::read_mesh_file(file(name, content), constrictions::Reading(), record));
  };
  const std::string in_inches = model_3mf(object_3mf(soup, "7"), "<item objectid=\"7\"/>");
  const std::vector<double> expected = measures_of("a.off", off(soup));
  EXPECT_EQ(record.unit, "");
  EXPECT_EQ(measures_of("inch.3mf", archive_3mf(in_inches)), expected);
  EXPECT_EQ(record.unit, "inch");
  for(const char* unit : {"micron", "millimeter", "centimeter", "foot", "meter"})
  {
    EXPECT_EQ(measures_of("a.3mf", archive_3mf(replaced(in_inches, "inch", unit))), expected);
    EXPECT_EQ(record.unit, unit);
  }
  EXPECT_EQ(measures_of("none.3mf", archive_3mf(replaced(in_inches, "unit=\"inch\" ", ""))), expected);
  EXPECT_EQ(record.unit, "millimeter");

  // 254 mm are 10 inches; where the object is put is told in the unit of the model that puts it
  const std::string item =
      "<item objectid=\"7\" p:path=\"/3D/parts/one.model\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>";
  Soup large = soup;
  for(Position& p : large.points)
    for(double& x : p)
      x *= 254;
  const std::string elsewhere = replaced(model_3mf(object_3mf(large, "7"), ""), "inch", "millimeter");
  const std::vector<double> found =
      measures_of("elsewhere.3mf", archive_3mf(model_3mf("", item), {{"3D/parts/one.model", elsewhere}}));
  EXPECT_EQ(record.unit, "inch");
  EXPECT_NEAR(found[0], 5 - 10, 1e-12);
  EXPECT_NEAR(found[1], 5 + 10, 1e-12);
  EXPECT_NEAR(found[2], 1000 * volume, 1e-9);
}

TEST_F(Scene_files, what_is_wrong_with_a_3mf_file_is_told)
{
  if(!has_zip)
  {
    expect_file_error("a.3mf", "PK\3\4", {"without libzip"});
    return;
  }
  const std::string object = object_3mf(soup, "7"), item = "<item objectid=\"7\"/>";
  const std::string good = archive_3mf(model_3mf(object, item));
  if(!has_xml)
  {
    expect_file_error("a.3mf", good, {"without expat"});
    return;
  }
  expect_file_error("name.3mf", "something", {"does not begin as a zip archive"});
  expect_file_error("half.3mf", good.substr(0, good.size() / 2), {"zip archive"});
  expect_file_error("empty.3mf", constrictions::zip_of({{"a", "b"}}), {"_rels/.rels", "missing"});
  expect_file_error("no_model.3mf", constrictions::zip_of({{"_rels/.rels", "<a/>"}}), {"names no model"});
  expect_file_error("xml.3mf", archive_3mf("<model"), {"3D/model.model, line 1"});
  expect_file_error("root.3mf", archive_3mf("<model/>"), {"3D/model.model, line 1", "not a model of 3MF"});
  expect_file_error("unit.3mf", archive_3mf(replaced(model_3mf(object, item), "inch", "Inch")),
                    {"3D/model.model, line 2", "\"unit\" is \"Inch\"", "inch, foot or meter"});
  expect_file_error("item.3mf", archive_3mf(model_3mf(object, "<item objectid=\"9\"/>")), {"object 9", "none"});
  expect_file_error("loop.3mf",
                    archive_3mf(model_3mf("<object id=\"7\"><components><component objectid=\"7\"/></components>"
                                          "</object>",
                                          item)),
                    {"object 7", "inside itself"});
  expect_file_error("number.3mf", archive_3mf(model_3mf(replaced(object, "1.5", "1,5"), item)), {"\"z\"", "\"1,5\""});
  expect_file_error("vertex.3mf", archive_3mf(model_3mf(replaced(object, "v3=\"2\"", "v3=\"6\""), item)),
                    {"object 7", "triangle 0 refers to vertex 6 of 6"});
  expect_file_error("transform.3mf", archive_3mf(model_3mf(object, "<item objectid=\"7\" transform=\"1 2\"/>")),
                    {"line 3", "12 numbers"});
}

TEST_F(Scene_files, floats_are_taken_as_they_are)
{
  Soup tenth = soup;
  tenth.points[0][0] = 0.1;
  Soup expected = soup;
  expected.points[0][0] = static_cast<double>(0.1f);
  expect_mesh(expected, "a.glb", glb(tenth));
  expect_mesh(expected, "b.vtk", binary_vtk_5(tenth));
  expect_mesh(tenth, "c.vtk", binary_vtk(tenth)); // in doubles
}

} // namespace test_scene_files
