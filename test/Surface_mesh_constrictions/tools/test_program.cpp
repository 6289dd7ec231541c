// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_program {

namespace fs = std::filesystem;
using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Grid_point;
using program_fixture::Program;
using program_fixture::Result;
using program_fixture::tetrahedron;

std::vector<std::string> keys(const nlohmann::ordered_json& object)
{
  std::vector<std::string> result;
  for(const auto& item : object.items())
    result.push_back(item.key());
  return result;
}

TEST_F(Program, detect_prints_a_table)
{
  const Result r = run("detect dumbbell.off");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, ""); // no progress bar where no terminal is
  for(const char* word : {"id", "length", "diameter", "prominence", "roundness", "separating", "side", "certificate",
                          "object", "not strict"})
    EXPECT_NE(r.out.find(word), std::string::npos) << word;
  EXPECT_NE(r.out.find("1 constriction from"), std::string::npos) << r.out;
}

TEST_F(Program, a_verbose_table_has_also_what_belongs_to_the_search)
{
  const Result r = run("detect dumbbell.off --verbose");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, "");
  for(const char* word :
      {"id", "length", "diameter", "prominence", "roundness", "pivots", "separating", "side", "certificate",
       "seed level", "centroid", "object", "not strict", " 1.5 1.5\n", " degenerate, ", " not selected)"})
    EXPECT_NE(r.out.find(word), std::string::npos) << word << " in\n" << r.out;
  EXPECT_NE(r.out.find("1 constriction from"), std::string::npos) << r.out;
}

// Also with numbers that are written with an exponent, and more than a thousand curves.
TEST_F(Program, a_table_is_no_wider_than_a_terminal)
{
  const double huge = 123456789e30, tiny = 1.23456789e-30;
  write("large.off", dumbbell().off([=](const Grid_point& p) {
    return std::array<double, 3>{huge * p[0], huge * p[1], huge * p[2]};
  }));
  write("small.off", dumbbell().off([=](const Grid_point& p) {
    return std::array<double, 3>{tiny * p[0], tiny * p[1], tiny * p[2]};
  }));
  for(const char* arguments :
      {"dumbbell.off --all", "large.off --all", "small.off --all",
       "'" CONSTRICTIONS_MESH_DIR "/eight.off' --all --no-certify", "'" CONSTRICTIONS_MESH_DIR "/eight.off'"})
  {
    std::istringstream lines(run(std::string("detect ") + arguments).out);
    std::size_t n = 0;
    for(std::string line; std::getline(lines, line); ++n)
      EXPECT_LE(line.size(), 80u) << line;
    EXPECT_GT(n, 3u);
  }
}

// Two digital balls joined by a digital cylinder, as a segmented image gives them. The neck goes around the convex hull
// of the cylinder's outline, an octagon with sides of 5 and of twice the diagonal of a square.
Cubes digital_dumbbell()
{
  const int r = 16, length = 35;
  const auto is_inside = [=](int x, int y, int z) {
    const int from_axis = y * y + z * z, right = x - length;
    return x * x + from_axis <= r * r || right * right + from_axis <= r * r ||
           (x >= 0 && x <= length && 100 * from_axis <= 9 * r * r);
  };
  Cubes cubes;
  for(int x = -r; x <= length + r; ++x)
    for(int y = -r; y <= r; ++y)
      for(int z = -r; z <= r; ++z)
        if(is_inside(x, y, z))
          cubes.add_box({x, y, z}, {x + 1, y + 1, z + 1});
  return cubes;
}

// What curves slide to on the coarse level may not be there on the input.
TEST_F(Program, a_digital_dumbbell_has_its_neck_and_each_curve_an_end)
{
  write("digital.off", digital_dumbbell().off());
  const json found = json::parse(run("detect digital.off --no-certify --json -").out).at("constrictions");
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.size(), 3u); // not the rings of the stairs beside it
  EXPECT_NEAR(found[0].at("length").get<double>(), 20 + 8 * std::sqrt(2.), 1e-9);
  EXPECT_GT(found[0].at("prominence").get<double>(), 2);
  for(const json& c : found)
    EXPECT_NE(c.at("dominated_by").is_null(), c.at("slides_off").is_null()) << c.at("id");
}

// Rotated, its twins differ by rounding. There are some that would each be dominated by the other.
TEST_F(Program, of_the_twins_of_a_rotated_digital_dumbbell_none_dominates_what_dominates_it)
{
  const double a = std::cos(46.), b = std::sin(46.), c = std::cos(92.), d = std::sin(92.);
  const auto rotated = [=](const Grid_point& p) {
    const double x = a * p[0] - b * p[1], y = b * p[0] + a * p[1];
    return std::array<double, 3>{x, c * y - d * p[2], d * y + c * p[2]};
  };
  write("rotated.off", digital_dumbbell().off(rotated));
  const json found = json::parse(run("detect rotated.off --json -").out).at("constrictions");
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].at("length").get<double>(), 20 + 8 * std::sqrt(2.), 1e-9);
  for(const json& c : found)
  {
    EXPECT_NE(c.at("dominated_by").is_null(), c.at("slides_off").is_null()) << c.at("id");
    if(c.at("dominated_by").is_null())
      continue;
    EXPECT_LE(found[c.at("dominated_by").get<std::size_t>()].at("length").get<double>(),
              c.at("length").get<double>() * (1 + 1e-9));
  }
}

TEST_F(Program, detect_prints_json_only)
{
  const Result r = run("detect dumbbell.off --json - --quiet");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, "");
  const nlohmann::ordered_json j = nlohmann::ordered_json::parse(r.out);
  typedef std::vector<std::string> Keys;
  EXPECT_EQ(keys(j), (Keys{"format", "mesh", "constrictions", "statistics", "seconds", "peak_rss_bytes"}));
  EXPECT_EQ(j["format"], "constrictions/1");

  const auto& mesh = j["mesh"];
  EXPECT_EQ(keys(mesh), (Keys{"file", "vertices", "faces", "triangles", "components", "genus", "holes", "border_edges",
                              "area", "repairs"}));
  EXPECT_EQ(mesh["file"], "dumbbell.off");
  EXPECT_EQ(mesh["vertices"], 116);
  EXPECT_EQ(mesh["faces"], 228);
  EXPECT_EQ(mesh["components"], 1);
  EXPECT_EQ(mesh["genus"], 0);
  EXPECT_DOUBLE_EQ(mesh["area"], 114);

  ASSERT_EQ(j["constrictions"].size(), 1u);
  const auto& c = j["constrictions"][0];
  EXPECT_EQ(
      keys(c),
      (Keys{"id",           "length",     "points", "locations",           "pivots",    "certificate", "side",
            "separating",   "areas",      "genera", "isoperimetric_ratio", "roundness", "isolation",   "prominence",
            "dominated_by", "slides_off", "rim",    "boundary_share",      "centroid",  "diameter",    "normal",
            "seed"}));
  EXPECT_EQ(c["id"], 0);
  EXPECT_DOUBLE_EQ(c["length"], 4);
  EXPECT_EQ(c["points"].size(), c["locations"].size());
  EXPECT_EQ(c["certificate"], "constriction"); // in a flat band
  EXPECT_EQ(c["side"], "object");
  EXPECT_EQ(c["separating"], true);
  EXPECT_DOUBLE_EQ(c["areas"][0].get<double>() + c["areas"][1].get<double>(), 114);
  EXPECT_EQ(c["genera"], (std::vector<int>{0, 0}));
  EXPECT_NEAR(c["roundness"].get<double>(), std::atan(1.), 1e-12); // a square
  EXPECT_DOUBLE_EQ(c["diameter"].get<double>(), 1 / std::atan(1.));
  EXPECT_NEAR(c["centroid"][1].get<double>(), 1.5, 1e-12); // the axis of the tube
  EXPECT_NEAR(c["centroid"][2].get<double>(), 1.5, 1e-12);
  EXPECT_NEAR(std::abs(c["normal"][0].get<double>()), 1, 1e-12);
  EXPECT_GT(c["prominence"].get<double>(), 1);
  EXPECT_TRUE(c["dominated_by"].is_null());
  EXPECT_EQ(keys(c["seed"]), (Keys{"level", "vertices", "origin"}));
  EXPECT_EQ(c["seed"]["origin"], "non_face_triangle");
  ASSERT_FALSE(c["pivots"].empty());
  for(const auto& pivot : c["pivots"])
  {
    EXPECT_EQ(keys(pivot), (Keys{"vertex", "point", "left_angle", "right_angle"}));
    EXPECT_LT(pivot["point"], c["points"].size());
    EXPECT_GE(pivot["left_angle"].get<double>(), 3.1415926535);
    EXPECT_GE(pivot["right_angle"].get<double>(), 3.1415926535);
  }

  const auto& statistics = j["statistics"];
  EXPECT_EQ(keys(statistics), (Keys{"collapses", "seeds", "degenerate", "discarded", "merged", "not_simple",
                                    "leaky_bands", "barriers", "not_certified", "not_selected", "corrected", "signs"}));
  EXPECT_EQ(keys(statistics["signs"]), (Keys{"interval", "multiprecision", "finite_field", "algebra", "unproved"}));
  EXPECT_GT(statistics["signs"]["algebra"], 0); // the sides of the band are parallel
  EXPECT_EQ(statistics["signs"]["unproved"], 0);
  EXPECT_EQ(statistics["not_certified"], 0);
  const auto count = [&statistics](const char* key) { return statistics[key].get<int>(); };
  EXPECT_EQ(count("seeds") + count("barriers"), count("degenerate") + count("discarded") + count("merged") +
                                                    count("not_simple") + count("not_certified") +
                                                    count("not_selected") + 1);
  EXPECT_EQ(keys(j["seconds"]), (Keys{"read", "simplify", "seeds", "refine", "tighten", "certify", "select", "total"}));
  EXPECT_GT(j["seconds"]["certify"], 0);
  EXPECT_GT(j["seconds"]["total"], j["seconds"]["simplify"]);
  EXPECT_GT(j["peak_rss_bytes"], 1000000);
}

// The points follow from the locations: faces as numbered in the file, corners in the order of the file.
TEST_F(Program, locations_are_those_of_the_file)
{
  std::istringstream off(content("dumbbell.off"));
  std::string word;
  std::size_t nv, nf, ne, n;
  off >> word >> nv >> nf >> ne;
  std::vector<std::array<double, 3>> points(nv);
  for(auto& p : points)
    off >> p[0] >> p[1] >> p[2];
  std::vector<std::array<std::size_t, 3>> faces(nf);
  for(auto& f : faces)
    off >> n >> f[0] >> f[1] >> f[2];

  const json j = json::parse(run("detect dumbbell.off --json -").out);
  for(const json& c : j.at("constrictions"))
    for(std::size_t i = 0; i < c.at("points").size(); ++i)
    {
      const json& location = c.at("locations").at(i);
      const auto& face = faces.at(location.at("face").get<std::size_t>());
      for(std::size_t axis = 0; axis < 3; ++axis)
      {
        double x = 0;
        for(std::size_t corner = 0; corner < 3; ++corner)
          x += location.at("barycentric").at(corner).get<double>() * points[face[corner]][axis];
        EXPECT_NEAR(x, c.at("points").at(i).at(axis).get<double>(), 1e-12);
      }
    }
}

TEST_F(Program, output_folder)
{
  const Result r = run("detect dumbbell.off -o deep/results");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(files(), (std::set<fs::path>{"dumbbell.off", "tetrahedron.off", "deep", "deep/results",
                                         "deep/results/constrictions.json", "deep/results/constrictions.ply",
                                         "deep/results/constrictions.obj", "deep/results/constrictions.polylines.txt",
                                         "deep/results/constrictions.vtp"}));
  const json j = json::parse(content("deep/results/constrictions.json"));
  const json& points = j.at("constrictions").at(0).at("points");

  std::istringstream polylines(content("deep/results/constrictions.polylines.txt"));
  std::size_t n = 0;
  polylines >> n;
  ASSERT_EQ(n, points.size() + 1);
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      double x;
      polylines >> x;
      EXPECT_EQ(x, points.at(i % points.size()).at(axis).get<double>());
    }
  EXPECT_TRUE(polylines.good());
  EXPECT_FALSE(polylines >> n);
}

TEST_F(Program, existing_outputs_are_replaced)
{
  write("a.json", "old");
  write("target.txt", "old");
  fs::create_symlink("target.txt", folder / "link.txt");
  EXPECT_EQ(run("detect dumbbell.off --json a.json --polylines link.txt").exit_code, 0);
  EXPECT_EQ(json::parse(content("a.json")).at("format"), "constrictions/1");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_NE(content("target.txt"), "old");
  EXPECT_EQ(files(), (std::set<fs::path>{"a.json", "dumbbell.off", "link.txt", "target.txt", "tetrahedron.off"}));
}

TEST_F(Program, no_constrictions_are_no_failure)
{
  const Result r = run("detect tetrahedron.off");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_NE(r.out.find("0 constrictions"), std::string::npos) << r.out;
  EXPECT_EQ(run("detect tetrahedron.off -o results").exit_code, 0);
  EXPECT_EQ(content("results/constrictions.polylines.txt"), "");
  EXPECT_TRUE(json::parse(content("results/constrictions.json")).at("constrictions").empty());
}

// Around the tube; twice lengthwise: along two opposite sides of the tube and around both cubes, from their faces at
// the tube over three others back to it. No seed leads to a fourth one, which runs aslant around one cube.
TEST_F(Program, policies)
{
  for(const char* policy : {"gh", "lt", "length"})
    for(bool is_certified : {true, false})
    {
      const Result r = run(std::string("detect dumbbell.off --all --json - --policy ") + policy +
                           (is_certified ? "" : " --no-certify"));
      ASSERT_EQ(r.exit_code, 0) << policy;
      const json found = json::parse(r.out).at("constrictions");
      std::vector<double> lengths;
      for(const json& c : found)
      {
        lengths.push_back(c.at("length").get<double>());
        if(is_certified)
        {
          EXPECT_EQ(c.at("certificate"), "constriction") << policy;
        }
      }
      const std::vector<double> expected = {4, 26, 26};
      ASSERT_EQ(lengths.size(), expected.size()) << policy;
      for(std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(lengths[i], expected[i], 1e-12) << policy;
    }
}

TEST_F(Program, thresholds_select)
{
  const auto lengths = [this](const std::string& options) {
    const Result r = run("detect dumbbell.off --json - " + options);
    EXPECT_EQ(r.exit_code, 0) << options;
    const json report = json::parse(r.out);
    std::vector<double> result;
    for(const json& curve : report["constrictions"])
      result.push_back(curve["length"]);
    return result;
  };
  const auto count = [&lengths](const std::string& options) { return lengths(options).size(); };
  EXPECT_EQ(count("--max 0"), 0u);
  EXPECT_EQ(count("--max 3"), 1u);
  EXPECT_EQ(count("--min-prominence 1"), 1u);
  EXPECT_EQ(count("--min-prominence 100"), 0u);
  EXPECT_EQ(count("--max-ratio 0.01"), 0u);
  EXPECT_EQ(count("--min-isolation 100"), 1u); // nothing dominates it
  const std::vector<double> all = lengths("--max-ratio 0.01 --min-prominence 100 --all");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NEAR(all[0], 4, 1e-12);
  EXPECT_NEAR(all[1], 26, 1e-12);
  EXPECT_NEAR(all[2], 26, 1e-12);
}

TEST_F(Program, caps_and_sides_are_measured_if_asked_for)
{
  const std::string curve = "detect dumbbell.off ";
  EXPECT_EQ(json::parse(run(curve + "--json -").out)["constrictions"][0].count("cap_area"), 0u);
  const json measured = json::parse(run(curve + "--measure --json -").out)["constrictions"][0];
  EXPECT_NEAR(measured.at("cap_area").get<double>(), 1, 1e-12);
  for(const json& girth : measured.at("side_girths"))
    EXPECT_GT(girth.get<double>(), 10); // around a cube of edge 3
  EXPECT_NE(run(curve + "--measure --csv -").out.find(",cap_area,left_girth,right_girth\n"), std::string::npos);
}

TEST_F(Program, an_interval_of_the_prominence_is_written_if_it_is_to_be_proved)
{
  EXPECT_EQ(json::parse(run("detect dumbbell.off --json -").out)["constrictions"][0].count("prominence_interval"), 0u);
  const Result r = run("detect dumbbell.off --prove-prominence --json -");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const json curve = json::parse(r.out)["constrictions"][0], interval = curve.at("prominence_interval");
  ASSERT_EQ(interval.size(), 2u);
  EXPECT_GT(interval[0].get<double>(), 0);
  EXPECT_LE(interval[0].get<double>(), interval[1].get<double>());
  EXPECT_GE(interval[1].get<double>(), curve["prominence"].get<double>());
  EXPECT_NE(run("detect dumbbell.off --prove-prominence").out.find("at least"), std::string::npos);
  EXPECT_NE(run("detect dumbbell.off --prove-prominence --csv -").out.find(",prominence_low,prominence_high"),
            std::string::npos);
}

// Two tubes, of width 1 and 2, between three boxes.
TEST_F(Program, near_a_location)
{
  Cubes cubes;
  cubes.add_box({0, 0, 0}, {4, 4, 4});
  cubes.add_box({4, 1, 1}, {6, 2, 2});
  cubes.add_box({6, 0, 0}, {10, 4, 4});
  cubes.add_box({10, 1, 1}, {12, 3, 3});
  cubes.add_box({12, 0, 0}, {16, 4, 4});
  write("chain.off", cubes.off());

  for(const char* policy : {"gh", "lt", "length"})
    for(const char* location : {"5,1,1.5", "11,1,1.5", "1.05e1,3,2"})
    {
      SCOPED_TRACE(location);
      const Result r = run(std::string("detect chain.off --json - --near ") + location + " --policy " + policy);
      ASSERT_EQ(r.exit_code, 0) << r.err;
      const json j = json::parse(r.out);
      ASSERT_FALSE(j.at("constrictions").empty());
      EXPECT_NEAR(j["constrictions"][0]["length"].get<double>(), location[0] == '5' ? 4 : 8, 1e-12);
      EXPECT_EQ(j["constrictions"][0]["seed"]["origin"], "cut_locus");
    }
  const json one = json::parse(run("detect chain.off --json - --near 5,1,1.5 --max 1").out);
  ASSERT_EQ(one.at("constrictions").size(), 1u);
  EXPECT_NEAR(one["constrictions"][0]["length"].get<double>(), 4, 1e-12);
  EXPECT_EQ(run("detect chain.off --near -1,2e0,-0.5 -o results").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "results" / "constrictions.json"));
}

TEST_F(Program, no_certificates)
{
  const json j = json::parse(run("detect dumbbell.off --no-certify --json -").out);
  ASSERT_EQ(j.at("constrictions").size(), 1u);
  EXPECT_EQ(j.at("constrictions").at(0).at("certificate"), "not_certified: no exact certificate has been computed");
  for(const auto& signs : j.at("statistics").at("signs").items())
    EXPECT_EQ(signs.value(), 0) << signs.key();
  EXPECT_NE(run("detect dumbbell.off --no-certify").out.find(" none "), std::string::npos);
}

TEST_F(Program, tighten)
{
  Cubes cubes = dumbbell();
  const std::string off = cubes.off();
  write("dumbbell.off", off);
  std::ostringstream loops;
  loops << "# around the tube, and a face\n";
  for(const Grid_point& p : {Grid_point{4, 1, 1}, {4, 2, 1}, {4, 2, 2}, {4, 1, 2}})
    loops << cubes.vertex(p) << ' ';
  loops << "\n\n";
  for(const Grid_point& p : {Grid_point{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}})
    loops << cubes.vertex(p) << ' ';
  write("loops.txt", loops.str());

  const Result table = run("tighten dumbbell.off --loops loops.txt");
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_EQ(table.err, "");
  EXPECT_NE(table.out.find("loop on line 4: degenerate"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("1 constriction from 2 seed curves"), std::string::npos) << table.out;

  const json j = json::parse(run("tighten dumbbell.off --loops loops.txt --json -").out);
  ASSERT_EQ(j.at("constrictions").size(), 1u);
  const json& c = j.at("constrictions").at(0);
  EXPECT_DOUBLE_EQ(c.at("length").get<double>(), 4);
  EXPECT_EQ(c.at("certificate"), "constriction");
  EXPECT_EQ(c.at("seed").at("level"), 0);
  EXPECT_EQ(c.at("seed").at("origin"), "user");
  EXPECT_EQ(c.at("seed").at("vertices").size(), 4u);
  EXPECT_EQ(j.at("statistics").at("seeds"), 2);
  EXPECT_EQ(j.at("statistics").at("degenerate"), 1);
  EXPECT_EQ(j.at("statistics").at("collapses"), 0);
  EXPECT_GT(j.at("statistics").at("signs").at("interval"), 0);

  const json plain = json::parse(run("tighten dumbbell.off --loops loops.txt --no-certify --json -").out);
  EXPECT_EQ(plain.at("constrictions").at(0).at("certificate"), "not_certified: no exact certificate has been computed");
}

TEST_F(Program, unusable_loops)
{
  const auto expect_error = [this](const std::string& loops, const std::string& line) {
    write("loops.txt", loops);
    expect_failure(1, "tighten dumbbell.off --loops loops.txt", {"loops.txt: " + line});
  };
  expect_error("# none\n0 1 one\n", "line 2: ");
  expect_error("# none\n\n0 1 1000\n", "line 3: ");
  expect_error("# no edges\n0 100 50\n", "line 2: ");
  expect_failure(1, "tighten dumbbell.off --loops missing.txt", {"missing.txt: no such file"});
  expect_failure(1, "tighten missing.off --loops loops.txt", {"missing.off: no such file"});
}

// The sides of a cube: a band that the two square rims bound.
TEST_F(Program, surfaces_with_boundary)
{
  write("tube.off", "OFF\n8 8 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                    "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  const auto found = [this](const std::string& options) {
    const Result r = run("detect tube.off --json - " + options);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return nlohmann::json::parse(r.out);
  };
  const nlohmann::json usual = found("");
  EXPECT_EQ(usual["mesh"]["holes"], 2);
  EXPECT_EQ(usual["mesh"]["genus"], 0);
  EXPECT_EQ(usual["constrictions"].size(), 0u);
  for(const char* options : {"--rims", "--all"})
  {
    const nlohmann::json j = found(options);
    ASSERT_EQ(j["constrictions"].size(), 1u);
    const nlohmann::json& c = j["constrictions"][0];
    EXPECT_EQ(c["rim"], true);
    EXPECT_EQ(c["boundary_share"], 1);
    EXPECT_EQ(c["length"], 4);
    EXPECT_TRUE(c["isoperimetric_ratio"].is_null()); // infinite
    for(const nlohmann::json& pivot : c["pivots"])
      EXPECT_NE(pivot["left_angle"].is_null(), pivot["right_angle"].is_null()) << "the hole is on one side";
  }
  // what detect writes certify reads
  write("rims.json", run("detect tube.off --rims --json -").out);
  EXPECT_EQ(run("certify tube.off --curves rims.json").exit_code, 0);
  EXPECT_EQ(run("segment tube.off -o parts --quiet").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(content("parts/parts.json"))["parts"][0]["boundaries"], 2);
}

TEST_F(Program, unusable_meshes)
{
  write("touching.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  write("nan.off", std::string(tetrahedron).replace(std::string(tetrahedron).find("0 1 0"), 5, "0 n 0"));
  write("infinite.off", std::string(tetrahedron).replace(std::string(tetrahedron).find("0 1 0"), 5, "0 inf 0"));
  write("flat.off", std::string(tetrahedron).replace(std::string(tetrahedron).find("0 1 0"), 5, "1 0 0"));
  write("empty.off", "");
  expect_failure(1, "detect nan.off", {"nan.off: ", "line 5", "vertex 2"});
  expect_failure(1, "detect infinite.off", {"infinite.off: ", "vertex 2", "inf"});
  expect_failure(1, "detect flat.off", {"flat.off: ", "no face is left of 4", "2 degenerate faces"});
  expect_failure(1, "detect flat.off --strict", {"flat.off: "});
  expect_failure(1, "detect empty.off", {"empty.off: "});
  expect_failure(1, "detect missing.off --json a.json", {"missing.off: "});
  expect_failure(1, "detect .", {"folder"});
  expect_failure(1, "detect infinite.off --json a.json --polylines a.txt", {"infinite.off: "});
}

TEST_F(Program, wrong_usage)
{
  expect_wrong_usage("");
  expect_wrong_usage("detect");
  expect_wrong_usage("detekt dumbbell.off");
  expect_wrong_usage("detect dumbbell.off tetrahedron.off");
  expect_wrong_usage("detect dumbbell.off --unknown");
  expect_wrong_usage("detect dumbbell.off --policy best");
  expect_wrong_usage("detect dumbbell.off --policy 0");
  expect_wrong_usage("detect dumbbell.off --json");
  expect_wrong_usage("detect dumbbell.off --json ''");
  expect_wrong_usage("detect dumbbell.off -o ''");
  expect_wrong_usage("tighten dumbbell.off");
  expect_wrong_usage("tighten dumbbell.off --loops ''");
  expect_wrong_usage("detect dumbbell.off --max -1");
  expect_wrong_usage("detect dumbbell.off --min-prominence high");
  expect_wrong_usage("detect dumbbell.off --min-prominence -0.1");
  expect_wrong_usage("detect dumbbell.off --max-ratio nan");
  expect_wrong_usage("certify dumbbell.off");
  for(const char* location :
      {"1,2", "a,b,c", "1,2,3,4", "1,,3", "1,2,", "'1;2;3'", "''", "1,2,nan", "inf,2,3", "1e999,2,3"})
    expect_wrong_usage(std::string("detect dumbbell.off --near ") + location);
  EXPECT_EQ(run("detect dumbbell.off --near 1,2").err.rfind("constrictions: --near: give three numbers", 0), 0u);
  expect_wrong_usage("detect dumbbell.off --near 1 2 3");
  expect_wrong_usage("detect dumbbell.off --near 1,2,3 --seeds triangles");
  // nothing is overwritten by mistake
  expect_wrong_usage("detect dumbbell.off --json dumbbell.off");
  expect_wrong_usage("detect dumbbell.off --json a.txt --polylines ./a.txt");
  expect_wrong_usage("detect dumbbell.off -o . --polylines constrictions.json");
  write("constrictions.ply", dumbbell().off());
  expect_wrong_usage("detect constrictions.ply -o .");
}

TEST_F(Program, help_and_version)
{
  for(const char* arguments :
      {"--help", "detect --help", "girth --help", "tighten --help", "certify --help", "--version"})
  {
    const Result r = run(arguments);
    EXPECT_EQ(r.exit_code, 0) << arguments;
    EXPECT_EQ(r.err, "") << arguments;
    EXPECT_NE(r.out, "") << arguments;
  }
  const std::string help = run("--help").out;
  for(const char* word : {"detect", "girth", "tighten", "certify", "Examples", "Exit codes"})
    EXPECT_NE(help.find(word), std::string::npos) << word;
}

TEST_F(Program, folders_are_made_for_every_output)
{
  EXPECT_EQ(run("detect dumbbell.off --json a/b/c.json --csv a/d/e.csv --polylines f/g.txt").exit_code, 0);
  EXPECT_EQ(run("check dumbbell.off -o h/i.ply").exit_code, 0);
  EXPECT_EQ(run("segment dumbbell.off --quiet -o j/k").exit_code, 0);
  for(const char* name : {"a/b/c.json", "a/d/e.csv", "f/g.txt", "h/i.ply", "j/k/parts.json"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  // none is left behind where something else fails
  expect_failure(3, "detect dumbbell.off --json l/m/n.json --csv dumbbell.off/a.csv",
                 {"dumbbell.off: is not a folder"});
}

TEST_F(Program, unwritable_outputs)
{
  write("file", "");
  expect_failure(3, "detect dumbbell.off --json file/a.json", {"file: is not a folder"});
  expect_failure(3, "detect dumbbell.off -o file", {"file: "});
  expect_failure(3, "detect dumbbell.off -o file/folder", {"file/folder: "});
  expect_failure(3, "detect dumbbell.off --polylines .", {"folder"});
  if(!fs::exists("/dev/full"))
    return;
  expect_failure(3, "detect dumbbell.off --json /dev/full", {"/dev/full: "});
  expect_failure(3, "detect dumbbell.off --json /dev/full --polylines a.txt", {"/dev/full: "});
  EXPECT_EQ(run("detect dumbbell.off", "/dev/full").exit_code, 3);
  EXPECT_EQ(run("detect dumbbell.off --json -", "/dev/full").exit_code, 3);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

} // namespace test_program
