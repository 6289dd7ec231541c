// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace test_program_girth {

using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

class Girth : public Program
{
protected:
  json girth(const std::string& arguments) const
  {
    const Result r = run("girth " + arguments + " --json -");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return json::parse(r.out);
  }
};

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";

double length(const json& points)
{
  double sum = 0;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const json &p = points[i], &q = points[(i + 1) % points.size()];
    sum += std::hypot(p[0].get<double>() - q[0].get<double>(), p[1].get<double>() - q[1].get<double>(),
                      p[2].get<double>() - q[2].get<double>());
  }
  return sum;
}

TEST_F(Girth, around_a_tube_inside_a_face)
{
  const json found = girth("dumbbell.off --at 4.25,1.5,1"); // the cubes are joined by a tube from 3 to 5
  EXPECT_EQ(found["format"], "constrictions/1");
  ASSERT_EQ(found["constrictions"].size(), 1u);
  const json c = found["constrictions"][0];
  EXPECT_NEAR(c["length"], 4, 1e-12);
  EXPECT_NEAR(length(c["points"]), 4, 1e-12);
  EXPECT_EQ(c["points"][0], json({4.25, 1.5, 1.0}));
  EXPECT_EQ(c["points"].size(), c["locations"].size());
  EXPECT_EQ(c["certificate"], "not_certified: held at point 0, which is not a vertex");
  EXPECT_TRUE(c["held"]["vertex"].is_null());
  EXPECT_TRUE(c["held"]["closed_geodesic"]);
  EXPECT_EQ(c["held"]["let_go"], "constriction");
  EXPECT_NEAR(c["held"]["let_go_length"], 4, 1e-12);
  EXPECT_NEAR(c["held"]["left_angle"], 3.14159265358979, 1e-9);
  for(const json& b : c["locations"][0]["barycentric"])
    EXPECT_GT(b, 0.1);
}

// The tube is as wide all along it: the loop is one of its constrictions, as far as the exact arithmetic is asked.
TEST_F(Girth, at_a_vertex_of_a_constriction_it_is_that_and_certified)
{
  const json found = girth("dumbbell.off --at 4,1,1");
  ASSERT_EQ(found["constrictions"].size(), 1u);
  const json c = found["constrictions"][0];
  EXPECT_EQ(c["certificate"], "constriction");
  EXPECT_EQ(c["held"]["vertex"], c["pivots"][0]["vertex"]);
  write("girth.json", found.dump());
  const Result r = run("certify dumbbell.off --curves girth.json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "0 constriction\n");
  EXPECT_EQ(girth("dumbbell.off --at 4,1,1 --no-certify")["constrictions"][0]["certificate"],
            "not_certified: no exact certificate has been computed");
}

TEST_F(Girth, where_nothing_is_narrow_it_says_that_it_is_held)
{
  const json found = girth(cactus + " --at 0.02,0.2,-0.1");
  ASSERT_EQ(found["constrictions"].size(), 1u);
  const json c = found["constrictions"][0];
  const bool is_left = c["held"]["left_angle"] < c["held"]["right_angle"];
  EXPECT_EQ(c["certificate"], std::string("not_certified: held at point 0, where the side angle on the ") +
                                  (is_left ? "left" : "right") + " is less than pi");
  EXPECT_FALSE(c["held"]["closed_geodesic"]);
  EXPECT_EQ(c["held"]["let_go"], "constriction");
  EXPECT_LT(c["held"]["let_go_length"], c["length"]);
}

TEST_F(Girth, the_next_ones_and_the_angle)
{
  const std::string hand = "'" CONSTRICTIONS_MESH_DIR "/hand.off' --at 0.396,0.00885,-0.0863";
  const json few = girth(hand + " --min-angle 0 --max 4")["constrictions"];
  ASSERT_EQ(few.size(), 4u);
  for(std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(few[i]["id"], i);
    EXPECT_LE(few[i == 0 ? 0 : i - 1]["length"], few[i]["length"]);
  }
  const json wide = girth(hand + " --min-angle 1")["constrictions"];
  ASSERT_EQ(wide.size(), 1u);
  const json& held = wide[0]["held"];
  EXPECT_GE(std::min(held["left_angle"].get<double>(), held["right_angle"].get<double>()), 1);
  EXPECT_GT(wide[0]["length"], few[0]["length"]);
}

TEST_F(Girth, the_other_outputs)
{
  const Result table = run("girth dumbbell.off --at 4.25,1.5,1");
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_NE(table.out.find("held"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("curve 0 is held at 4.25 1.5 1, where its angle is 3.14159; let go, it becomes a "
                           "constriction of length 4\n1 loop\n"),
            std::string::npos)
      << table.out;

  const Result csv = run("girth dumbbell.off --at 4.25,1.5,1 --csv -");
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 2);
  EXPECT_NE(csv.out.find("\"not_certified: held at point 0, which is not a vertex\""), std::string::npos) << csv.out;

  EXPECT_EQ(run("girth dumbbell.off --at 4.25,1.5,1 -o out --polylines lines.txt").exit_code, 0);
  EXPECT_EQ(content("lines.txt"), content("out/constrictions.polylines.txt"));
  std::istringstream line(content("lines.txt"));
  std::size_t n = 0;
  double x = 0, y = 0, z = 0;
  line >> n >> x >> y >> z;
  EXPECT_EQ(n, json::parse(content("out/constrictions.json"))["constrictions"][0]["points"].size() + 1);
  EXPECT_EQ(x, 4.25);
  EXPECT_EQ(y, 1.5);
  EXPECT_EQ(z, 1);
  EXPECT_NE(content("out/constrictions.ply").find("element vertex " + std::to_string(n - 1)), std::string::npos);
  EXPECT_NE(content("out/constrictions.vtp").find("is_pivot"), std::string::npos);
}

TEST_F(Girth, where_there_is_none_it_says_so)
{
  write("plate.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  EXPECT_TRUE(girth("plate.off --at 0.5,0.25,0")["constrictions"].empty());
  const Result r = run("girth plate.off --at 0.5,0.25,0");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out, "0 loops\nNo closed curve through this place holds: there is no handle, and no limb that is steep "
                   "enough.\n");
}

TEST_F(Girth, where_all_are_folded_it_says_so)
{
  const std::string hand = "girth '" CONSTRICTIONS_MESH_DIR "/hand.off' --at 0.396,0.00885,-0.0863";
  EXPECT_EQ(
      run(hand + " --min-angle 3.1").out.find("0 loops\nThe closed curves through this place that hold are folded"),
      0u);
  EXPECT_NE(run(hand + " --min-angle 0").out.find("\n1 loop\n"), std::string::npos);
}

// As at each place alone; the CSV file has a column for the places.
TEST_F(Girth, at_many_places)
{
  write("landmarks.csv", "name,x,y,z\n# a comment\n\"tube, left\",4.25,1.5,1\r\n\n 4.5 , 1.5 , 1\ncorner,0,0,0\n");
  const Result bad_name = run("girth dumbbell.off --landmarks landmarks.csv --json -");
  EXPECT_EQ(bad_name.exit_code, 1) << bad_name.err; // a comma in a name makes five fields
  write("landmarks.csv", "name,x,y,z\n# a comment\ntube,4.25,1.5,1\r\n\n 4.5 , 1.5 , 1\ncorner,0,0,0\n");
  const json found = girth("dumbbell.off --landmarks landmarks.csv");
  const json& places = found["landmarks"];
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0]["name"], "tube");
  EXPECT_EQ(places[1]["name"], "");
  EXPECT_EQ(places[1]["location"], json({4.5, 1.5, 1}));
  for(std::size_t i = 0; i < 2; ++i)
  {
    ASSERT_EQ(places[i]["constrictions"], json({i}));
    const json alone = girth(std::string("dumbbell.off --at ") + (i == 0 ? "4.25" : "4.5") + ",1.5,1");
    json expected = alone["constrictions"][0];
    expected["id"] = i;
    EXPECT_EQ(found["constrictions"][i], expected);
    EXPECT_EQ(places[i]["hint"], "");
  }
  EXPECT_EQ(places[2]["constrictions"].empty(), places[2]["hint"] != "");

  const Result csv = run("girth dumbbell.off --landmarks landmarks.csv --csv -");
  EXPECT_NE(csv.out.find(",landmark\n"), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find(",tube\n"), std::string::npos) << csv.out;
  EXPECT_NE(run("girth dumbbell.off --landmarks landmarks.csv").out.find("landmark tube: 0\nlandmark 1: 1\n"),
            std::string::npos);

  const json near = json::parse(run("detect dumbbell.off --landmarks landmarks.csv --json -").out);
  ASSERT_EQ(near["landmarks"].size(), 3u);
  EXPECT_EQ(near["landmarks"][0]["constrictions"], json::array({0}));
  EXPECT_NEAR(near["constrictions"][0]["length"], 4, 1e-12);

  write("none.csv", "x,y,z\n");
  EXPECT_EQ(run("girth dumbbell.off --landmarks none.csv").exit_code, 1);
  write("wrong.csv", "1,2,3\n1,2\n");
  const Result wrong = run("girth dumbbell.off --landmarks wrong.csv");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("line 2"), std::string::npos) << wrong.err;
  EXPECT_EQ(run("girth dumbbell.off --landmarks landmarks.csv --at 1,2,3").exit_code, 2);
}

// Along the tube, aslant, and where the plane touches the surface.
TEST_F(Girth, along_an_axis_it_is_that_of_a_plane_section)
{
  const json found = girth("dumbbell.off --at 4.25,1.5,1 --axis 1,0,1"); // 2 of 4 sides are longer by sqrt(2)
  ASSERT_EQ(found["sections"].size(), 1u);
  const json section = found["sections"][0];
  EXPECT_EQ(section["kind"], "closed");
  EXPECT_EQ(section["curves"], 1);
  EXPECT_NEAR(section["length"], 2 + 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(length(section["points"]), section["length"], 1e-12);
  EXPECT_EQ(section["points"].size(), section["locations"].size());
  ASSERT_EQ(section["constriction"], 0);
  EXPECT_NEAR(found["constrictions"][0]["length"], 4, 1e-12);
  EXPECT_EQ(found["constrictions"][0]["held"]["let_go"], "constriction");

  const json touching = girth("dumbbell.off --at 0,1.5,1.5 --axis 1,0,0");
  EXPECT_EQ(touching["sections"][0]["kind"], "point");
  EXPECT_TRUE(touching["sections"][0]["constriction"].is_null());
  EXPECT_TRUE(touching["constrictions"].empty());
  const Result r = run("girth dumbbell.off --at 0,1.5,1.5 --axis 1,0,0");
  EXPECT_NE(r.out.find("section 0: none\n"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("only touches the surface"), std::string::npos) << r.out;

  write("landmarks.csv", "tube,4.25,1.5,1\nend,0,1.5,1.5\n");
  const json both = girth("dumbbell.off --landmarks landmarks.csv --axis 1,0,0");
  ASSERT_EQ(both["sections"].size(), 2u);
  EXPECT_NEAR(both["sections"][0]["length"], 4, 1e-12);
  EXPECT_EQ(both["sections"][1]["kind"], "point");
  EXPECT_EQ(both["landmarks"][0]["constrictions"], json::array({0}));
  EXPECT_EQ(both["landmarks"][1]["hint"], "The plane through this place only touches the surface.");
}

TEST_F(Girth, loops_through_places)
{
  write("places.txt", "# around the tube\n4.2,1,1.5 4,1.5,1 3.8,2,1.5 4,1.5,2\n");
  const json found = json::parse(run("tighten dumbbell.off --through places.txt --json -").out);
  ASSERT_EQ(found["held_loops"].size(), 1u);
  const json& held = found["held_loops"][0];
  EXPECT_EQ(held["line"], 2);
  EXPECT_GT(held["length"], 4);
  EXPECT_NEAR(length(held["points"]), held["length"], 1e-12);
  EXPECT_EQ(held["held"].size(), 4u);
  EXPECT_TRUE(held["simple"]);
  EXPECT_EQ(held["let_go"], "constriction");
  ASSERT_EQ(held["constriction"], 0);
  EXPECT_NEAR(found["constrictions"][0]["length"], 4, 1e-12);

  write("few.txt", "4,1,1 4.2,1,1.5\n");
  const Result few = run("tighten dumbbell.off --through few.txt");
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_NE(few.err.find("line 1: a loop goes through at least 3 locations; given are 2"), std::string::npos)
      << few.err;
  write("wrong.txt", "4,1,1 x 3\n");
  EXPECT_EQ(run("tighten dumbbell.off --through wrong.txt").exit_code, 1);
  EXPECT_EQ(run("tighten dumbbell.off --through places.txt --loops places.txt").exit_code, 2);
}

TEST_F(Girth, wrong_usage)
{
  for(const char* arguments : {"girth dumbbell.off", "girth dumbbell.off --at 1,2", "girth dumbbell.off --at 1,2,nan",
                               "girth dumbbell.off --at 1,2,3 --max 0", "girth dumbbell.off --at 1,2,3 --min-angle -1",
                               "girth dumbbell.off --at 1,2,3 --axis 0,0,0", "girth dumbbell.off --at 1,2,3 --axis 1,0",
                               "girth dumbbell.off --at 1,2,3 --axis 1,0,0 --max 2"})
    EXPECT_EQ(run(arguments).exit_code, 2) << arguments;
  EXPECT_EQ(run("girth missing.off --at 1,2,3").exit_code, 1);
  const Result help = run("girth --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("--at"), std::string::npos);
}

} // namespace test_program_girth
