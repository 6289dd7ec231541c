// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace test_program_csv {

namespace fs = std::filesystem;
using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Grid_point;
using program_fixture::Program;
using program_fixture::Result;

typedef std::vector<std::string> Fields;

// The fields of each line, as RFC 4180 has them.
std::vector<Fields> lines_of(const std::string& csv)
{
  std::vector<Fields> result;
  bool is_quoted = false, is_new_line = true;
  for(std::size_t i = 0; i < csv.size(); ++i)
  {
    if(is_new_line)
      result.push_back({""});
    is_new_line = false;
    std::string& field = result.back().back();
    if(csv[i] == '"' && is_quoted && i + 1 < csv.size() && csv[i + 1] == '"')
      field += csv[++i];
    else if(csv[i] == '"')
      is_quoted = !is_quoted;
    else if(csv[i] == ',' && !is_quoted)
      result.back().push_back("");
    else if(csv[i] == '\n' && !is_quoted)
      is_new_line = true;
    else
      field += csv[i];
  }
  EXPECT_TRUE(is_new_line && !is_quoted);
  return result;
}

class Csv : public Program
{
protected:
  // As JSON has it, nothing for null.
  static std::string text(const json& value)
  {
    return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
  }

  // The command writes the same into both.
  std::vector<Fields> expect_as_in_json(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    const Result r = run(arguments + " --csv - --json a.json");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const std::vector<Fields> lines = lines_of(r.out);
    const json curves = json::parse(content("a.json")).at("constrictions");
    EXPECT_EQ(lines.size(), curves.size() + 1);
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      const json& c = curves[i];
      EXPECT_EQ(lines[i + 1].size(), lines[0].size());
      std::map<std::string, std::string> fields;
      for(std::size_t f = 0; f < lines[0].size(); ++f)
        fields[lines[0][f]] = lines[i + 1][f];
      std::map<std::string, std::string> expected = {{"centroid_x", text(c["centroid"][0])},
                                                     {"centroid_y", text(c["centroid"][1])},
                                                     {"centroid_z", text(c["centroid"][2])},
                                                     {"normal_x", text(c["normal"][0])},
                                                     {"normal_y", text(c["normal"][1])},
                                                     {"normal_z", text(c["normal"][2])},
                                                     {"left_area", text(c["areas"][0])},
                                                     {"right_area", text(c["areas"][1])},
                                                     {"left_genus", text(c["genera"][0])},
                                                     {"right_genus", text(c["genera"][1])},
                                                     {"pivots", std::to_string(c["pivots"].size())},
                                                     {"seed_level", text(c["seed"]["level"])},
                                                     {"seed_origin", text(c["seed"]["origin"])}};
      for(const char* member :
          {"id", "length", "diameter", "prominence", "isolation", "roundness", "isoperimetric_ratio", "separating",
           "side", "rim", "boundary_share", "dominated_by", "slides_off", "certificate"})
        expected[member] = text(c[member]);
      EXPECT_EQ(fields, expected);
    }
    return lines;
  }
};

TEST_F(Csv, has_what_the_json_has)
{
  for(const char* name : {"cactus.off", "eight.off"})
    EXPECT_GT(expect_as_in_json("detect '" CONSTRICTIONS_MESH_DIR "/" + std::string(name) + "'").size(), 3u);
  EXPECT_GT(expect_as_in_json("detect dumbbell.off --all").size(), 2u);
  EXPECT_GT(expect_as_in_json("detect dumbbell.off --near 4,1.5,1.5").size(), 1u);
  write("tube.off", "OFF\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                    "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(expect_as_in_json("detect tube.off --rims").size(), 2u); // with an infinite ratio
}

TEST_F(Csv, of_loops)
{
  Cubes cubes = dumbbell();
  write("dumbbell.off", cubes.off());
  std::ostringstream loop;
  for(const Grid_point& p : {Grid_point{4, 1, 1}, {4, 2, 1}, {4, 2, 2}, {4, 1, 2}})
    loop << cubes.vertex(p) << ' ';
  write("loops.txt", loop.str());
  const std::vector<Fields> lines = expect_as_in_json("tighten dumbbell.off --loops loops.txt");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1][1], "4.0");
}

// The reason why a curve has no certificate need not have a comma in it, but it may.
TEST_F(Csv, fields_are_quoted_where_they_must_be)
{
  const std::vector<Fields> lines = expect_as_in_json("detect dumbbell.off --no-certify");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(std::find(lines[1].begin(), lines[1].end(), "not_certified: no exact certificate has been computed"),
            lines[1].end());
}

TEST_F(Csv, nothing_found_is_a_line_of_names)
{
  const std::string csv = run("detect tetrahedron.off --csv -").out;
  EXPECT_EQ(csv.rfind("id,length,diameter,centroid_x,centroid_y,centroid_z,normal_x,normal_y,normal_z,prominence,", 0),
            0u);
  EXPECT_EQ(csv.find('\n'), csv.size() - 1);
}

TEST_F(Csv, files)
{
  write("a.csv", "old");
  const Result r = run("detect dumbbell.off --csv a.csv");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out, ""); // no table
  EXPECT_EQ(content("a.csv"), run("detect dumbbell.off --csv -").out);
  EXPECT_EQ(run("detect dumbbell.off -o results --csv results/a.csv").exit_code, 0);
  EXPECT_EQ(content("results/a.csv"), content("a.csv"));
  expect_failure(3, "detect dumbbell.off --csv dumbbell.off/a.csv", {"dumbbell.off: is not a folder"});
  expect_failure(3, "detect dumbbell.off --csv .", {"folder"});
  for(const char* arguments :
      {"detect dumbbell.off --csv dumbbell.off", "detect dumbbell.off --csv b.json --json b.json",
       "detect dumbbell.off --csv - --json -", "detect dumbbell.off --csv ''", "detect dumbbell.off --csv"})
    expect_wrong_usage(arguments);
  if(fs::exists("/dev/full"))
  {
    expect_failure(3, "detect dumbbell.off --csv /dev/full --json b.json", {"/dev/full: "});
    EXPECT_EQ(run("detect dumbbell.off --csv -", "/dev/full").exit_code, 3);
  }
}

} // namespace test_program_csv
