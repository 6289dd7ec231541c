// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include "input/mesh_file.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>

namespace test_program_handles {

namespace fs = std::filesystem;
namespace PMP = CGAL::Polygon_mesh_processing;
using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::Program;
using program_fixture::Result;

// A frame of 5 x 5 x 1 around a hole of 3 x 3: its bars are 4 long around, and the hole is 12.
std::string frame()
{
  Cubes cubes;
  cubes.add_box({0, 0, 0}, {5, 1, 1});
  cubes.add_box({0, 4, 0}, {5, 5, 1});
  cubes.add_box({0, 1, 0}, {1, 4, 1});
  cubes.add_box({4, 1, 0}, {5, 4, 1});
  return cubes.off();
}

class Handles : public Program
{
protected:
  // Runs the program, and checks what it writes into the folder `result`.
  json remove(const std::string& arguments, int exit_code = 0) const
  {
    SCOPED_TRACE(arguments);
    fs::remove_all(folder / "result");
    const Result r = run("segment " + arguments + " -o result");
    EXPECT_EQ(r.exit_code, exit_code) << r.err;
    EXPECT_EQ(r.err.empty(), exit_code == 0) << r.err;
    const json j = json::parse(content("result/handles.json"));
    EXPECT_EQ(j.at("format"), "constrictions-handles/1");
    const std::size_t n = j.at("handles").size();
    EXPECT_NE(r.out.find(std::to_string(n) + (n == 1 ? " handle removed" : " handles removed")), std::string::npos)
        << r.out;
    EXPECT_EQ(j.at("genus").get<std::size_t>() + n, j.at("mesh").at("genus").get<std::size_t>());

    std::set<std::string> found;
    for(const fs::directory_entry& entry : fs::directory_iterator(folder / "result"))
      found.insert(entry.path().filename().string());
    EXPECT_EQ(found, (std::set<std::string>{"handles.json", j.at("file").get<std::string>()}));
    double change = 0;
    for(const json& h : j.at("handles"))
      change += h.at("volume_change").get<double>();
    EXPECT_NEAR(change, j.at("volume_change").get<double>(), 1e-12);
    return j;
  }

  // Of the written mesh, as the program itself reads it.
  json checked(const json& j) const
  {
    EXPECT_EQ(run("check result/" + j.at("file").get<std::string>() + " --strict --json check.json").exit_code, 0);
    return json::parse(content("check.json")).at("mesh");
  }

  double volume(const std::string& file) const { return PMP::volume(constrictions::read_mesh_file(folder / file)); }
};

TEST_F(Handles, the_bar_of_a_frame_is_cut_or_its_hole_filled)
{
  write("frame.off", frame());
  const json cut = remove("frame.off --genus 0");
  ASSERT_EQ(cut.at("handles").size(), 1u);
  EXPECT_EQ(cut.at("handles")[0].at("side"), "object");
  EXPECT_EQ(cut.at("handles")[0].at("caps_intersect"), json({false, false}));
  EXPECT_DOUBLE_EQ(cut.at("handles")[0].at("length").get<double>(), 4);
  for(const json& area : cut.at("handles")[0].at("cap_areas"))
    EXPECT_NEAR(area.get<double>(), 1, 0.1);
  EXPECT_NEAR(cut.at("volume_change").get<double>(), -0.08, 0.02); // twice a hundredth of 4, but for the corner
  EXPECT_NEAR(volume("result/without_handles.ply"), 16 + cut.at("volume_change").get<double>(), 1e-9);
  EXPECT_EQ(checked(cut).at("genus"), 0);
  EXPECT_EQ(checked(cut).at("holes"), 0);
  EXPECT_EQ(checked(cut).at("components"), 1);

  const json filled = remove("frame.off --handles 1 --side complement --format obj");
  ASSERT_EQ(filled.at("handles").size(), 1u);
  EXPECT_EQ(filled.at("file"), "without_handles.obj");
  EXPECT_EQ(filled.at("handles")[0].at("side"), "complement");
  EXPECT_GT(filled.at("volume_change").get<double>(), 0);
  EXPECT_NEAR(volume("result/without_handles.obj"), 16 + filled.at("volume_change").get<double>(), 1e-9);
  EXPECT_EQ(checked(filled).at("genus"), 0);
}

TEST_F(Handles, of_a_mesh_of_genus_2)
{
  const std::string eight = "'" CONSTRICTIONS_MESH_DIR "/eight.off' --no-certify";
  const json one = remove(eight + " --genus 1");
  EXPECT_EQ(one.at("handles").size(), 1u);
  EXPECT_EQ(checked(one).at("genus"), 1);
  const json both = remove(eight + " --handles 2");
  EXPECT_EQ(both.at("handles").size(), 2u);
  EXPECT_EQ(both.at("handles")[0], one.at("handles")[0]); // the cheapest first
  EXPECT_EQ(checked(both).at("genus"), 0);
  EXPECT_EQ(remove(eight + " --genus 2").at("handles").size(), 0u);
}

TEST_F(Handles, what_is_not_reached_is_told)
{
  write("frame.off", frame());
  const json j = remove("frame.off --genus 0 --max-length 3", 1);
  EXPECT_EQ(j.at("target_genus"), 0);
  EXPECT_EQ(j.at("genus"), 1);
  EXPECT_NEAR(volume("result/without_handles.ply"), 16, 1e-12);
}

TEST_F(Handles, more_than_there_are_is_an_error)
{
  write("frame.off", frame());
  expect_failure(1, "segment frame.off -o . --genus 2", {"frame.off", "genus is 1", "asked for, 2"});
  expect_failure(1, "segment frame.off -o . --handles 2", {"frame.off", "genus is 1", "handles to remove, 2"});
  expect_failure(1, "segment dumbbell.off -o . --handles 1", {"genus is 0"});
}

TEST_F(Handles, wrong_usage)
{
  write("without_handles.obj", program_fixture::tetrahedron);
  for(const char* arguments :
      {"segment dumbbell.off --genus 0", "segment dumbbell.off -o . --genus -1",
       "segment dumbbell.off -o . --handles 0", "segment dumbbell.off -o . --genus 0 --handles 1",
       "segment dumbbell.off -o . --genus 0 --parts 2", "segment dumbbell.off -o . --genus 0 --max 2",
       "segment dumbbell.off -o . --handles 1 --open", "segment dumbbell.off -o . --handles 1 --min-prominence 0.1",
       "segment without_handles.obj -o . --genus 0"})
    expect_wrong_usage(arguments);
}

} // namespace test_program_handles
