// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/json_schema.h"
#include "include/program_fixture.h"
#include "include/scene_texts.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace test_schemas {

using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Grid_point;
using program_fixture::Program;
using program_fixture::Result;

const std::string meshes = CONSTRICTIONS_MESH_DIR "/";

std::string schema_file(const std::string& format)
{
  std::string name = format; // such as constrictions/1
  name[name.find('/')] = '-';
  return CONSTRICTIONS_SCHEMA_DIR "/" + name + ".schema.json";
}

json schema(const std::string& format) { return json::parse(std::ifstream(schema_file(format))); }

class Schemas : public Program
{
protected:
  // What the program writes, by format.
  std::map<std::string, std::vector<json>> outputs;

  void take(const json& output) { outputs[output.at("format")].push_back(output); }

  void take_printed(const std::string& arguments)
  {
    const Result r = run(arguments);
    EXPECT_LE(r.exit_code, 1) << arguments << ": " << r.err;
    std::istringstream lines(r.out);
    std::size_t n = 0;
    for(std::string line; std::getline(lines, line); ++n)
      take(json::parse(line));
    EXPECT_GT(n, 0u) << arguments;
  }

  void make_outputs()
  {
    // what has polygons, holes, defects, no constriction, and what cannot be used
    write("tube.off", "OFF\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                      "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    write("twice.off", "OFF\n7 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n9 9 9\n-1 0 0\n0 -1 0\n"
                       "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 3 2\n");
    write("cap.off", "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5 0 -1e-15\n"
                     "3 0 2 4\n3 2 1 4\n3 0 4 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    write("nothing.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n");
    Cubes cubes = dumbbell();
    write("dumbbell.off", cubes.off());
    std::ostringstream loop;
    for(const Grid_point& p : {Grid_point{4, 1, 1}, {4, 2, 1}, {4, 2, 2}, {4, 1, 2}})
      loop << cubes.vertex(p) << ' ';
    write("loops.txt", loop.str());
    // borders that are closed, of which some are degenerate, and some that are held: at junctions, and at rims
    std::string labels = "3\n";
    for(int f = 1; f < 228; ++f)
      labels += f % 5 == 0 ? "2\n" : "1\n";
    write("labels.txt", labels);
    write("sides.txt", "1\n1\n-2\n-2\n");
    write("landmarks.csv", "name,x,y,z\ntube,4.2,1.5,1\ncorner,0,0,0\n");
    write("places.txt", "4.2,1,1.5 4.2,2,1.5 4.2,1.5,2\n0,0,0 1,0,0.5 0,1,0.5\n");

    for(const char* arguments : {"detect dumbbell.off --json -",
                                 "detect dumbbell.off --all --no-certify --json -",
                                 "detect tetrahedron.off --json -",
                                 "detect tube.off --rims --json -",
                                 "detect twice.off --json -",
                                 "detect dumbbell.off --near 4,1.5,1.5 --json -",
                                 "girth dumbbell.off --at 4.2,1.5,1 --json -",
                                 "girth dumbbell.off --at 4,1,1 --json -",
                                 "girth tube.off --at 0,0,0.5 --json -",
                                 "girth tetrahedron.off --at 1,0,0 --json -",
                                 "tighten dumbbell.off --loops loops.txt --json -",
                                 "girth dumbbell.off --landmarks landmarks.csv --json -",
                                 "girth dumbbell.off --landmarks landmarks.csv --axis 1,0,0 --json -",
                                 "girth tube.off --at 0,0,0.5 --axis 1,0,0 --json -",
                                 "detect dumbbell.off --landmarks landmarks.csv --json -",
                                 "tighten dumbbell.off --through places.txt --json -",
                                 "tighten dumbbell.off --labels labels.txt --json -",
                                 "tighten tube.off --labels sides.txt --json -",
                                 "check dumbbell.off --json -",
                                 "check tube.off --json -",
                                 "check twice.off --json -",
                                 "check nothing.off --json -",
                                 "check cap.off --json -",
                                 "batch dumbbell.off nothing.off missing.off"})
      take_printed(arguments);
    for(const char* name : {"cactus.off", "eight.off", "homer.off"})
      take_printed("detect '" + meshes + name + "' --json -");
    take_printed("detect '" + meshes + "eight.off' --all --json -");
    take_printed("girth '" + meshes + "cactus.off' --at 0.02,0.2,-0.1 --max 3 --json -");
    write("curves.json", outputs["constrictions/1"].front().dump());
    take_printed("certify dumbbell.off --curves curves.json --json -");
    json open = outputs["constrictions/1"].front();
    open["constrictions"][0].erase("pivots");
    json& face = open["constrictions"][0]["locations"][0]["face"];
    face = (face.get<int>() + 100) % 228; // far away
    write("curves.json", open.dump());
    take_printed("certify dumbbell.off --curves curves.json --json -");
    for(const char* arguments :
        {"dumbbell.off", "tube.off --rims", "'" CONSTRICTIONS_MESH_DIR "/eight.off' --format stl"})
    {
      EXPECT_EQ(run(std::string("segment -o parts --quiet ") + arguments).exit_code, 0) << arguments;
      take(json::parse(content("parts/parts.json")));
    }
    for(const char* arguments : {"dumbbell.off --genus 0", "'" CONSTRICTIONS_MESH_DIR "/eight.off' --handles 1"})
    {
      EXPECT_EQ(run(std::string("segment -o handles --quiet ") + arguments).exit_code, 0) << arguments;
      take(json::parse(content("handles/handles.json")));
    }
    EXPECT_EQ(run("tighten tube.off --labels sides.txt -o labelled").exit_code, 0);
    take(json::parse(content("labelled/parts.json")));
    if(CONSTRICTIONS_HAS_ZIP && CONSTRICTIONS_HAS_XML)
    {
      write("feet.3mf", scene_texts::in_3mf((folder / "dumbbell.off").string(), "foot"));
      for(const char* arguments : {"detect feet.3mf --json -", "check feet.3mf --json -", "batch feet.3mf"})
        take_printed(arguments);
      EXPECT_EQ(run("segment feet.3mf -o feet --quiet").exit_code, 0);
      take(json::parse(content("feet/parts.json")));
      EXPECT_EQ(run("segment feet.3mf --genus 0 -o feet --quiet").exit_code, 0);
      take(json::parse(content("feet/handles.json")));
    }
  }
};

TEST_F(Schemas, describe_all_that_is_written)
{
  make_outputs();
  for(const char* format : {"constrictions/1", "constrictions-batch/1", "constrictions-certificates/1",
                            "constrictions-check/1", "constrictions-handles/1", "constrictions-parts/1"})
    EXPECT_GT(outputs[format].size(), 1u) << format;
  EXPECT_EQ(outputs.size(), 6u);
  for(const auto& [format, values] : outputs)
    for(const json& value : values)
      for(const std::string& error : json_schema::errors(schema(format), value))
        ADD_FAILURE() << format << ' ' << value["mesh"] << ": " << error;
}

// A validator that is not ours, which also looks whether the schemas are schemas. The test before this one checks the
// outputs without it, so the project does not depend on its package.
TEST_F(Schemas, are_understood_by_jsonschema)
{
  if(std::system("/usr/bin/python3 -c 'import jsonschema' 2> /dev/null") != 0)
    GTEST_SKIP() << "the package python3-jsonschema is not installed";
  make_outputs();
  write("validate.py", "import json, jsonschema, sys\n"
                       "schema = json.load(open(sys.argv[1]))\n"
                       "validator = jsonschema.validators.validator_for(schema)\n"
                       "validator.check_schema(schema)\n"
                       "for value in json.load(open(sys.argv[2])):\n"
                       "    validator(schema).validate(value)\n"
                       "    optional = ['file_bytes', 'borders', 'label_parts', 'face_labels', 'landmarks',\n"
                       "                'held_loops', 'sections']\n"
                       "    for name in [name for name in value if name not in optional]:\n"
                       "        less = {k: v for k, v in value.items() if k != name}\n"
                       "        assert not validator(schema).is_valid(less), name\n");
  for(const auto& [format, values] : outputs)
  {
    write("values.json", json(values).dump());
    EXPECT_EQ(std::system(("cd '" + folder.string() + "' && /usr/bin/python3 validate.py '" + schema_file(format) +
                           "' values.json")
                              .c_str()),
              0)
        << format;
  }
}

TEST_F(Schemas, what_is_wrong_is_noticed)
{
  const json good = json::parse(run("detect dumbbell.off --json -").out), s = schema("constrictions/1");
  ASSERT_EQ(json_schema::errors(s, good), std::vector<std::string>());
  const auto expect_error = [&](const char* pointer, const json& value) {
    json wrong = good;
    wrong[json::json_pointer(pointer)] = value;
    EXPECT_EQ(json_schema::errors(s, wrong).size(), 1u) << pointer;
  };
  expect_error("/format", "constrictions/2");
  expect_error("/new", 1);
  expect_error("/mesh/vertices", -1);
  expect_error("/mesh/vertices", 1.5);
  expect_error("/constrictions/0/length", nullptr);
  expect_error("/constrictions/0/length", 0);
  expect_error("/constrictions/0/certificate", "not_certified");
  expect_error("/constrictions/0/side", "inside");
  expect_error("/constrictions/0/centroid", {1, 2});
  expect_error("/constrictions/0/pivots/0/left_angle", "wide");
  expect_error("/statistics/signs/algebra", "many");
  json wrong = good;
  wrong["constrictions"][0].erase("normal");
  EXPECT_EQ(json_schema::errors(s, wrong), std::vector<std::string>{"/constrictions/0: lacks \"normal\""});
}

} // namespace test_schemas
