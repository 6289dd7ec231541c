// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"
#include "include/scene_texts.h"

#include "input/mesh_file.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_program_segment {

namespace fs = std::filesystem;
namespace PMP = CGAL::Polygon_mesh_processing;
using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";

// The mesh of a file of glTF 2.0 with one mesh, one primitive and one buffer.
constrictions::Mesh read_glb(const std::string& file)
{
  const auto number = [&file](std::size_t at) {
    std::uint32_t result = 0;
    std::memcpy(&result, file.data() + at, 4);
    return result;
  };
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(number(4), 2u);
  EXPECT_EQ(number(8), file.size());
  const std::size_t size = number(12), binary = 20 + size;
  EXPECT_EQ(file.substr(16, 4), "JSON");
  EXPECT_EQ(size % 4, 0u);
  EXPECT_EQ(file.substr(binary + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(binary + 8 + number(binary), file.size());
  EXPECT_EQ(number(binary) % 4, 0u);
  const json j = json::parse(file.substr(20, size));
  EXPECT_EQ(j.at("asset").at("version"), "2.0");
  EXPECT_EQ(j.at("nodes")[0].at("name").get<std::string>().rfind("part_", 0), 0u);
  EXPECT_LE(j.at("buffers")[0].at("byteLength"), number(binary));
  const json& primitive = j.at("meshes")[0].at("primitives")[0];
  const auto begin_and_count = [&](const json& index, const char* type, int component) {
    const json& accessor = j.at("accessors").at(index.get<std::size_t>());
    const json& view = j.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    EXPECT_EQ(accessor.at("type"), type);
    EXPECT_EQ(accessor.at("componentType"), component);
    return std::make_pair(binary + 8 + view.value("byteOffset", std::size_t(0)),
                          accessor.at("count").get<std::size_t>());
  };
  constrictions::Mesh mesh;
  const auto [points, n] = begin_and_count(primitive.at("attributes").at("POSITION"), "VEC3", 5126);
  const json& accessor = j.at("accessors").at(primitive.at("attributes").at("POSITION").get<std::size_t>());
  for(std::size_t i = 0; i < n; ++i)
  {
    std::array<float, 3> p;
    std::memcpy(p.data(), file.data() + points + 12 * i, 12);
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(p[axis], accessor.at("min")[axis].get<float>());
      EXPECT_LE(p[axis], accessor.at("max")[axis].get<float>());
    }
    mesh.add_vertex(constrictions::Point(p[0], p[1], p[2]));
  }
  const auto [corners, m] = begin_and_count(primitive.at("indices"), "SCALAR", 5125);
  for(std::size_t i = 0; i < m; i += 3)
    mesh.add_face(constrictions::Mesh::Vertex_index(number(corners + 4 * i)),
                  constrictions::Mesh::Vertex_index(number(corners + 4 * i + 4)),
                  constrictions::Mesh::Vertex_index(number(corners + 4 * i + 8)));
  EXPECT_EQ(mesh.number_of_faces(), m / 3);
  return mesh;
}

class Segment : public Program
{
protected:
  // Runs the program, and checks what it writes into the folder `parts` against each other.
  json segment(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    fs::remove_all(folder / "parts");
    const Result r = run("segment " + arguments + " -o parts");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_NE(r.out.find(", cut along "), std::string::npos) << r.out;
    const json j = json::parse(content("parts/parts.json"));
    EXPECT_EQ(j.at("format"), "constrictions-parts/1");
    EXPECT_EQ(j.at("face_parts").size(), j.at("mesh").at("faces"));

    std::set<fs::path> expected = {"parts/parts.json", "parts/parts.ply", "parts/parts.vtp"}, found;
    double area = 0;
    for(const json& p : j.at("parts"))
    {
      area += p.at("area").get<double>();
      EXPECT_EQ(p.at("file"), "part_" + std::to_string(p.at("id").get<int>()) + ".ply");
      expected.insert(fs::path("parts") / p.at("file").get<std::string>());
    }
    for(const fs::directory_entry& entry : fs::directory_iterator(folder / "parts"))
      found.insert(entry.path().lexically_relative(folder));
    EXPECT_EQ(found, expected);
    EXPECT_NEAR(area, j.at("mesh").at("area").get<double>(), 1e-12 * area);

    const constrictions::Mesh whole = constrictions::read_mesh_file((folder / "parts/parts.ply").string());
    EXPECT_NEAR(PMP::area(whole), area, 1e-12 * area);
    double volume = 0;
    for(const json& p : j.at("parts"))
    {
      volume += p.at("volume").get<double>();
      EXPECT_GE(p.at("caps").size(), p.at("boundaries").get<std::size_t>());
      EXPECT_EQ(p.at("cavity").get<bool>(), p.at("volume").get<double>() * PMP::volume(whole) < 0);
      for(const json& c : p.at("caps"))
      {
        EXPECT_TRUE(c.at("cuts_part").is_boolean());
        EXPECT_FALSE(c.at("curves").empty());
        for(const json& curve : c.at("curves"))
          EXPECT_TRUE(j.at("curves").at(curve.get<std::size_t>()).at("cuts").get<bool>());
      }
    }
    EXPECT_NEAR(volume, PMP::volume(whole), 1e-9 * PMP::volume(whole));
    for(const json& p : j.at("face_parts"))
      EXPECT_LT(p.get<std::size_t>(), j.at("parts").size());
    for(const json& a : j.at("adjacencies"))
    {
      EXPECT_TRUE(j.at("curves").at(a.at("curve").get<std::size_t>()).at("cuts").get<bool>());
      for(const json& p : a.at("parts"))
        EXPECT_LT(p.get<std::size_t>(), j.at("parts").size());
    }
    return j;
  }

  void expect_closed_parts(const json& j) const
  {
    for(const json& p : j.at("parts"))
    {
      // throws if it is not closed
      const constrictions::Mesh part =
          constrictions::read_mesh_file((folder / "parts" / p.at("file").get<std::string>()).string());
      EXPECT_NEAR(PMP::volume(part), p.at("volume").get<double>(), 1e-12 * p.at("area").get<double>());
      EXPECT_GE(PMP::area(part), p.at("area").get<double>() * (1 - 1e-12));
    }
  }
};

// Two cubes of volume 27, and a tube of volume 2 that belongs to one of them.
TEST_F(Segment, dumbbell)
{
  const json j = segment("dumbbell.off");
  expect_closed_parts(j);
  ASSERT_EQ(j.at("parts").size(), 2u);
  std::multiset<long> volumes, areas;
  for(const json& p : j.at("parts"))
  {
    volumes.insert(std::lround(p.at("volume").get<double>()));
    areas.insert(std::lround(p.at("area").get<double>()));
    EXPECT_EQ(p.at("genus"), 0);
    EXPECT_EQ(p.at("boundaries"), 1);
    EXPECT_EQ(p.at("cavity"), false);
    EXPECT_EQ(p.at("caps"), json::parse(R"([{"curves": [0], "cuts_part": false}])"));
  }
  EXPECT_EQ(volumes, (std::multiset<long>{27, 29}));
  EXPECT_EQ(areas, (std::multiset<long>{53, 61}));
  ASSERT_EQ(j.at("adjacencies").size(), 1u);
  EXPECT_DOUBLE_EQ(j.at("adjacencies")[0].at("length").get<double>(), 4);
  ASSERT_EQ(j.at("curves").size(), 1u);
  EXPECT_EQ(j.at("curves")[0].at("side"), "object");
  EXPECT_TRUE(j.at("curves")[0].at("crosses").is_null());
}

TEST_F(Segment, what_has_no_constriction_is_one_part)
{
  const json j = segment("tetrahedron.off");
  expect_closed_parts(j);
  EXPECT_EQ(j.at("parts").size(), 1u);
  EXPECT_EQ(j.at("face_parts"), json({0, 0, 0, 0}));
}

TEST_F(Segment, choices)
{
  EXPECT_EQ(segment("dumbbell.off --side object").at("parts").size(), 2u);
  const json j = segment("dumbbell.off --side complement");
  EXPECT_EQ(j.at("parts").size(), 1u);
  EXPECT_EQ(j.at("curves")[0].at("cuts"), false);
  EXPECT_TRUE(j.at("curves")[0].at("border_from").is_null());
  EXPECT_EQ(segment("dumbbell.off --parts 1").at("parts").size(), 1u);
  EXPECT_EQ(segment("dumbbell.off --parts 2").at("parts").size(), 2u);
  EXPECT_EQ(segment("dumbbell.off --max 0").at("curves").size(), 0u);
}

TEST_F(Segment, open_parts_have_a_border)
{
  const json j = segment("dumbbell.off --open");
  EXPECT_EQ(j.at("parts").size(), 2u);
  const auto holes = [this] {
    EXPECT_EQ(run("check parts/part_0.ply --json part.json").exit_code, 0);
    return json::parse(content("part.json")).at("mesh").at("holes");
  };
  EXPECT_EQ(holes(), 1);
  const json closed = segment("dumbbell.off");
  EXPECT_EQ(holes(), 0);
  EXPECT_EQ(j.at("parts"), closed.at("parts"));
}

TEST_F(Segment, cactus)
{
  const json j = segment(cactus);
  expect_closed_parts(j);
  EXPECT_EQ(j.at("parts").size(), 4u);
  for(std::size_t n = 1; n <= 4; ++n)
  {
    const json few = segment(cactus + " --no-certify --parts " + std::to_string(n));
    expect_closed_parts(few);
    EXPECT_EQ(few.at("parts").size(), n);
    for(std::size_t c = 0; c < j.at("curves").size(); ++c)
    {
      const json& from = j.at("curves")[c].at("border_from");
      EXPECT_EQ(few.at("curves")[c].at("border_from"), from);
      EXPECT_EQ(few.at("curves")[c].at("cuts"), !from.is_null() && from.get<std::size_t>() <= n);
    }
  }
}

// The same parts in each format, which the program reads, or a reader of our own.
TEST_F(Segment, formats)
{
  const json ply = segment(cactus);
  std::vector<double> volumes;
  for(const json& p : ply.at("parts"))
    volumes.push_back(p.at("volume"));
  for(const std::string format : {"stl", "obj", "glb"})
  {
    SCOPED_TRACE(format);
    ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --format " + format).exit_code, 0);
    const json j = json::parse(content("parts/parts.json"));
    ASSERT_EQ(j.at("parts").size(), volumes.size());
    std::set<fs::path> expected = {"parts.json", "parts.ply", "parts.vtp"}, found;
    for(std::size_t p = 0; p < volumes.size(); ++p)
    {
      const std::string file = "part_" + std::to_string(p) + '.' + format;
      EXPECT_EQ(j.at("parts")[p].at("file"), file);
      expected.insert(file);
      const constrictions::Mesh part = format == "glb"
                                           ? read_glb(content("parts/" + file))
                                           : constrictions::read_mesh_file((folder / "parts" / file).string());
      const double tolerance = format == "obj" ? 1e-12 : 1e-6;
      EXPECT_NEAR(PMP::volume(part), volumes[p], tolerance);
      EXPECT_TRUE(CGAL::is_closed(part));
    }
    for(const fs::directory_entry& entry : fs::directory_iterator(folder / "parts"))
      found.insert(entry.path().filename());
    EXPECT_EQ(found, expected);
  }
  EXPECT_EQ(content("parts/part_0.glb").substr(0, 4), "glTF");
  // the reader of the program agrees with that of the test
  EXPECT_NEAR(PMP::volume(constrictions::read_mesh_file((folder / "parts" / "part_0.glb").string())), volumes[0], 1e-6);
}

TEST_F(Segment, a_part_with_four_boundaries_has_its_genus)
{
  program_fixture::Cubes cubes;
  cubes.add_box({0, 0, 0}, {5, 5, 3});
  for(const auto& [bar, end] : std::vector<std::array<std::array<program_fixture::Grid_point, 2>, 2>>{
          {{{{{5, 2, 1}, {7, 3, 2}}}, {{{7, 1, 0}, {10, 4, 3}}}}},
          {{{{{-2, 2, 1}, {0, 3, 2}}}, {{{-5, 1, 0}, {-2, 4, 3}}}}},
          {{{{{2, 5, 1}, {3, 7, 2}}}, {{{1, 7, 0}, {4, 10, 3}}}}},
          {{{{{2, -2, 1}, {3, 0, 2}}}, {{{1, -5, 0}, {4, -2, 3}}}}}})
  {
    cubes.add_box(bar[0], bar[1]);
    cubes.add_box(end[0], end[1]);
  }
  write("star.off", cubes.off());
  const json parts = segment("star.off").at("parts");
  ASSERT_EQ(parts.size(), 5u);
  std::multiset<int> boundaries;
  for(const json& p : parts)
  {
    EXPECT_EQ(p.at("genus"), 0);
    boundaries.insert(p.at("boundaries").get<int>());
  }
  EXPECT_EQ(boundaries, (std::multiset<int>{1, 1, 1, 1, 4}));
}

// A box with a hollow in the form of two cubes and a tube.
TEST_F(Segment, the_neck_of_a_cavity_chokes_the_complement)
{
  program_fixture::Cubes cubes;
  cubes.add_box({-1, -1, -1}, {9, 4, 4});
  write("box.off", cubes.off());
  constrictions::Mesh mesh = constrictions::read_mesh_file((folder / "dumbbell.off").string());
  PMP::reverse_face_orientations(mesh);
  mesh += constrictions::read_mesh_file((folder / "box.off").string());
  std::ostringstream out;
  out << mesh;
  write("hollow.off", out.str());
  const json j = segment("hollow.off");
  ASSERT_EQ(j.at("curves").size(), 1u);
  EXPECT_EQ(j.at("curves")[0].at("side"), "complement");
  std::multiset<double> of_cavities, of_others;
  for(const json& p : j.at("parts"))
    (p.at("cavity").get<bool>() ? of_cavities : of_others).insert(p.at("volume").get<double>());
  EXPECT_EQ(of_cavities, (std::multiset<double>{-29, -27}));
  EXPECT_EQ(of_others, std::multiset<double>{250});
}

TEST_F(Segment, one_file_of_3mf_has_all_parts)
{
  if(!CONSTRICTIONS_HAS_ZIP)
  {
    EXPECT_NE(run("segment " + cactus + " -o parts --format 3mf").err.find("without libzip"), std::string::npos);
    return;
  }
  const json ply = segment(cactus);
  double volume = 0;
  for(const json& p : ply.at("parts"))
    volume += p.at("volume").get<double>();
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --format 3mf").exit_code, 0);
  std::set<std::string> found;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder / "parts"))
    found.insert(entry.path().filename().string());
  EXPECT_EQ(found, (std::set<std::string>{"parts.3mf", "parts.json", "parts.ply", "parts.vtp"}));
  const json j = json::parse(content("parts/parts.json"));
  for(const json& p : j.at("parts"))
    EXPECT_EQ(p.at("file"), "parts.3mf");
  const std::string archive = content("parts/parts.3mf");
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --format 3mf").exit_code, 0);
  EXPECT_EQ(content("parts/parts.3mf"), archive); // it bears no time
  if(CONSTRICTIONS_HAS_XML)
  {
    const constrictions::Mesh parts = constrictions::read_mesh_file((folder / "parts" / "parts.3mf").string());
    EXPECT_NEAR(PMP::volume(parts), volume, 1e-12);
  }
  // it is removed when parts have files of their own again
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "parts" / "parts.3mf"));
}

// A slicer that reads inches as millimetres prints parts that are 25.4 times too small.
TEST_F(Segment, files_of_3mf_keep_the_unit_of_the_mesh)
{
  if(!CONSTRICTIONS_HAS_ZIP || !CONSTRICTIONS_HAS_XML)
    GTEST_SKIP() << "expat or libzip, with which 3MF files are read, is not installed";
  const std::string off = (folder / "dumbbell.off").string();
  write("inches.3mf", scene_texts::in_3mf(off, "inch"));
  const auto unit_of = [&](const std::string& mesh, const std::string& options, const char* file, const char* json_file,
                           const json& unit_in_json) {
    EXPECT_EQ(run("segment " + mesh + " -o parts --quiet --format 3mf" + options).exit_code, 0) << mesh;
    EXPECT_EQ(json::parse(content(fs::path("parts") / json_file)).at("mesh").value("unit", json()), unit_in_json);
    constrictions::File_record record;
    const std::string name = (folder / "parts" / file).string();
    EXPECT_NEAR(PMP::volume(constrictions::read_mesh_file(name, constrictions::Reading(), record)), 56, 1e-12);
    return record.unit;
  };
  EXPECT_EQ(unit_of("inches.3mf", "", "parts.3mf", "parts.json", "inch"), "inch");
  EXPECT_EQ(unit_of("inches.3mf", " --genus 0", "without_handles.3mf", "handles.json", "inch"), "inch");
  EXPECT_EQ(unit_of("dumbbell.off", "", "parts.3mf", "parts.json", nullptr), "millimeter");
  EXPECT_EQ(unit_of("dumbbell.off", " --genus 0", "without_handles.3mf", "handles.json", nullptr), "millimeter");

  // lengths stay as they are
  const json found = json::parse(run("detect inches.3mf --json -").out);
  EXPECT_EQ(found.at("mesh").at("unit"), "inch");
  EXPECT_EQ(found.at("constrictions").at(0).at("length"), 4);
  EXPECT_NE(run("check inches.3mf").out.find("\nunit          inch\n"), std::string::npos);
  EXPECT_EQ(run("check dumbbell.off").out.find("\nunit "), std::string::npos);
}

TEST_F(Segment, obj_files_name_their_part)
{
  ASSERT_EQ(run("segment dumbbell.off -o parts --quiet --format obj").exit_code, 0);
  EXPECT_EQ(content("parts/part_1.obj").rfind("o part_1\nv ", 0), 0u);
}

TEST_F(Segment, an_stl_file_is_no_text)
{
  ASSERT_EQ(run("segment dumbbell.off -o parts --quiet --format stl --open").exit_code, 0);
  const std::string stl = content("parts/part_0.stl");
  EXPECT_NE(stl.substr(0, 5), "solid");
  std::uint32_t n = 0;
  std::memcpy(&n, stl.data() + 80, 4);
  EXPECT_EQ(stl.size(), 84 + 50 * std::size_t(n));
  for(std::size_t f = 0; f < n; ++f)
  {
    float normal[3];
    std::memcpy(normal, stl.data() + 84 + 50 * f, 12);
    EXPECT_EQ(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]), 1);
  }
}

// Single precision has less room for exponents, too.
TEST_F(Segment, what_does_not_fit_into_a_format_is_refused)
{
  const double huge = 1e200;
  write("huge.off", program_fixture::dumbbell().off([=](const program_fixture::Grid_point& p) {
    return std::array<double, 3>{huge * p[0], huge * p[1], huge * p[2]};
  }));
  fs::create_directory(folder / "parts");
  for(const char* format : {"stl", "glb"})
    expect_failure(3, std::string("segment huge.off -o parts --format ") + format,
                   {"parts/part_0." + std::string(format) + ": ", "too large"});
  EXPECT_EQ(run("segment huge.off -o parts --quiet --format obj").exit_code, 0);
}

TEST_F(Segment, files_of_parts_that_are_no_more_are_removed)
{
  const auto names = [this] {
    std::set<std::string> result;
    for(const fs::directory_entry& entry : fs::directory_iterator(folder / "parts"))
      result.insert(entry.path().filename().string());
    return result;
  };
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet").exit_code, 0);
  ASSERT_EQ(names().count("part_3.ply"), 1u);
  // of others, with names that are like those of parts
  write("parts/part_7.ply", "mine");
  write("parts/part_2.stl", "mine");
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --parts 2").exit_code, 0);
  const std::set<std::string> others = {"part_7.ply", "part_2.stl", "parts.json", "parts.ply", "parts.vtp"};
  std::set<std::string> expected = others;
  expected.insert({"part_0.ply", "part_1.ply"});
  EXPECT_EQ(names(), expected);
  // in another format
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --parts 2 --format obj").exit_code, 0);
  expected = others;
  expected.insert({"part_0.obj", "part_1.obj"});
  EXPECT_EQ(names(), expected);
  EXPECT_EQ(content("parts/part_7.ply") + content("parts/part_2.stl"), "minemine");

  // names of nothing else are believed, and what is already gone does not matter
  write("kept.txt", "mine");
  write("parts/parts.json", R"({"format": "constrictions-parts/1", "parts": [{"file": "../kept.txt"}, {"file": 1}, 2,
                                {"file": "part_7.ply/../../kept.txt"}, {"file": "part_9.ply"}, {"file": "parts.ply"}]})");
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet --parts 2 --format obj").exit_code, 0);
  EXPECT_EQ(names(), expected);
  EXPECT_EQ(content("kept.txt"), "mine");
  for(const char* text : {"", "[]", "{\"format\": 1}", "{\"format\": \"constrictions-parts/1\", \"parts\": 3}"})
  {
    write("parts/parts.json", text);
    EXPECT_EQ(run("segment " + cactus + " -o parts --quiet --parts 2 --format obj").exit_code, 0) << text;
  }
  EXPECT_EQ(names(), expected);
}

TEST_F(Segment, what_fails_removes_nothing)
{
  ASSERT_EQ(run("segment " + cactus + " -o parts --quiet").exit_code, 0);
  fs::create_directory(folder / "parts/part_0.stl");
  const std::set<fs::path> before = files();
  EXPECT_EQ(run("segment " + cactus + " -o parts --quiet --format stl").exit_code, 3);
  EXPECT_EQ(files(), before);
}

TEST_F(Segment, quiet)
{
  const Result r = run("segment dumbbell.off -o parts --quiet");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out + r.err, "");
}

TEST_F(Segment, wrong_usage)
{
  for(const char* arguments :
      {"segment dumbbell.off", "segment -o parts", "segment dumbbell.off -o parts --parts 0",
       "segment dumbbell.off -o parts --side mixed", "segment dumbbell.off -o parts --json parts.json"})
    expect_wrong_usage(arguments);
  expect_wrong_usage("segment dumbbell.off -o parts --format dae");
  for(const char* name : {"parts.ply", "parts.vtp", "part_0.ply", "part_12.ply", "part_3.stl", "part_4.obj"})
  {
    write(name, program_fixture::tetrahedron);
    expect_wrong_usage(std::string("segment ") + name + " -o .");
  }
  EXPECT_EQ(run("segment part_0.ply -o parts").exit_code, 0);
}

TEST_F(Segment, what_cannot_be_read_or_written)
{
  expect_failure(1, "segment missing.off -o parts", {"missing.off"});
  write("file", "");
  expect_failure(3, "segment dumbbell.off -o file", {"file"});
  fs::create_directory(folder / "taken");
  fs::create_directory(folder / "taken" / "parts.ply");
  expect_failure(3, "segment dumbbell.off -o taken", {"parts.ply", "is a folder"});
}

} // namespace test_program_segment
