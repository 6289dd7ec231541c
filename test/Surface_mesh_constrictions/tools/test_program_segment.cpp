// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include "input/mesh_file.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace test_program_segment {

namespace fs = std::filesystem;
namespace PMP = CGAL::Polygon_mesh_processing;
using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";

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
  }
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
  for(const char* name : {"parts.ply", "parts.vtp", "part_0.ply", "part_12.ply"})
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
