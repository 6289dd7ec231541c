// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The commands on meshes that have to be repaired.
namespace test_program_repair {

using program_fixture::Result;
typedef nlohmann::json Json;
typedef std::array<double, 3> Position;
typedef std::vector<std::size_t> Face;

struct Polygons
{
  std::vector<Position> points;
  std::vector<Face> faces;
};

// A dumbbell of revolution with ten sides, of quadrangles, with decagons at its ends; its neck is 20 sin(pi / 10) long.
Polygons dumbbell()
{
  Polygons result;
  const double pi = std::acos(-1.);
  const std::vector<std::array<double, 2>> profile = {{{3, 0}}, {{3, 2}}, {{1, 4}}, {{3, 6}}, {{3, 8}}};
  for(const std::array<double, 2>& p : profile)
    for(int i = 0; i < 10; ++i)
      result.points.push_back({{p[0] * std::cos(pi * i / 5), p[0] * std::sin(pi * i / 5), p[1]}});
  for(std::size_t r = 0; r + 1 < profile.size(); ++r)
    for(std::size_t i = 0; i < 10; ++i)
      result.faces.push_back({10 * r + i, 10 * r + (i + 1) % 10, 10 * r + 10 + (i + 1) % 10, 10 * r + 10 + i});
  result.faces.push_back({9, 8, 7, 6, 5, 4, 3, 2, 1, 0});
  result.faces.push_back({40, 41, 42, 43, 44, 45, 46, 47, 48, 49});
  return result;
}

const double neck = 20 * std::sin(std::acos(-1.) / 10);

Polygons triangulated(const Polygons& polygons)
{
  Polygons result = {polygons.points, {}};
  for(const Face& f : polygons.faces)
    for(std::size_t i = 1; i + 1 < f.size(); ++i)
      result.faces.push_back({f[0], f[i], f[i + 1]});
  return result;
}

std::string as_obj(const Polygons& polygons)
{
  std::ostringstream out;
  out.precision(17);
  for(const Position& p : polygons.points)
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const Face& f : polygons.faces)
  {
    out << 'f';
    for(std::size_t v : f)
      out << ' ' << v + 1;
    out << '\n';
  }
  return out.str();
}

class Program_repair : public program_fixture::Program
{
protected:
  Json json_of(const std::string& arguments) const
  {
    const Result r = run(arguments);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return Json::parse(r.out);
  }

  // An outside script: puts each location where the file's own faces and vertices say, and compares with the point.
  static void expect_locations_fit(const Json& json, const Polygons& file)
  {
    for(const Json& c : json.at("constrictions"))
      for(std::size_t i = 0; i < c.at("points").size(); ++i)
      {
        const Json& location = c.at("locations")[i];
        const Face& face = file.faces.at(location.at("face").get<std::size_t>());
        EXPECT_EQ(location.contains("triangle"), face.size() != 3);
        const Face corners = location.contains("triangle") ? location.at("triangle").get<Face>() : face;
        for(std::size_t v : corners)
          EXPECT_NE(std::find(face.begin(), face.end(), v), face.end());
        for(std::size_t k = 0; k < 3; ++k)
        {
          double x = 0;
          for(std::size_t j = 0; j < 3; ++j)
            x += location.at("barycentric")[j].get<double>() * file.points.at(corners.at(j))[k];
          EXPECT_NEAR(x, c.at("points")[i][k].get<double>(), 1e-12);
        }
      }
    for(const Json& c : json.at("constrictions"))
      for(const Json& pivot : c.at("pivots"))
        for(std::size_t k = 0; k < 3; ++k)
          EXPECT_EQ(file.points.at(pivot.at("vertex").get<std::size_t>())[k],
                    c.at("points")[pivot.at("point").get<std::size_t>()][k].get<double>());
  }
};

TEST_F(Program_repair, polygons_through_all_commands)
{
  const Polygons file = dumbbell();
  write("a.obj", as_obj(file));
  const Result r = run("detect a.obj --json a.json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "constrictions: a.obj: 42 polygons triangulated\n");
  const Json json = Json::parse(content("a.json"));
  EXPECT_EQ(json.at("mesh").at("faces"), 42);
  EXPECT_EQ(json.at("mesh").at("triangles"), 96);
  EXPECT_EQ(json.at("mesh").at("repairs"), (Json{{"triangulated", 42}}));
  ASSERT_EQ(json.at("constrictions").size(), 1u);
  EXPECT_NEAR(json.at("constrictions")[0].at("length").get<double>(), neck, 1e-12);
  expect_locations_fit(json, file);

  const Result certified = run("certify a.obj --curves a.json");
  EXPECT_EQ(certified.exit_code, 0) << certified.err;
  EXPECT_EQ(certified.out, "0 strict_constriction\n");

  write("loops.txt", "20 21 22 23 24 25 26 27 28 29\n");
  EXPECT_NEAR(json_of("tighten a.obj --loops loops.txt --json -").at("constrictions")[0].at("length").get<double>(),
              neck, 1e-12);

  EXPECT_EQ(run("segment a.obj -o parts").exit_code, 0);
  const Json parts = Json::parse(content("parts/parts.json"));
  ASSERT_EQ(parts.at("face_parts").size(), 42u);
  for(std::size_t f = 0; f < 42; ++f) // faces below the neck, and the bottom, are one part
    EXPECT_EQ(parts.at("face_parts")[f] == parts.at("face_parts")[40], f < 20 || f == 40) << f;
  if(CONSTRICTIONS_HAS_VIEWER)
  {
    EXPECT_EQ(run("view a.obj -o a.html").exit_code, 0);
  }
}

TEST_F(Program_repair, a_piece_may_be_given_in_any_order)
{
  write("a.obj", as_obj(dumbbell()));
  // a detour over the quadrangles, so that there are crossings
  Json json = json_of("detect a.obj --json - --all --min-prominence 0");
  for(Json& c : json["constrictions"])
    for(Json& l : c["locations"])
      if(l.contains("triangle"))
        for(const char* member : {"triangle", "barycentric"})
          std::rotate(l[member].begin(), l[member].begin() + 1, l[member].end());
  write("turned.json", json.dump());
  EXPECT_EQ(run("certify a.obj --curves turned.json").exit_code, 0);
  for(Json& c : json["constrictions"])
    for(Json& l : c["locations"])
      l.erase("triangle");
  write("without.json", json.dump());
  expect_failure(1, "certify a.obj --curves without.json", {"\"triangle\" is missing"});
}

TEST_F(Program_repair, strict_refuses_polygons)
{
  write("a.obj", as_obj(dumbbell()));
  expect_failure(1, "detect a.obj --strict", {"a.obj: not a triangle mesh: face 0 has 4 vertices", "42 such"});
}

TEST_F(Program_repair, two_bodies_that_touch_keep_the_numbers_of_the_file)
{
  // two dumbbells that share the vertex 0, which is 50 of the second
  Polygons file = triangulated(dumbbell());
  const Polygons second = file;
  for(const Position& p : second.points)
    file.points.push_back({{6 - p[0], -p[1], p[2]}});
  for(const Face& f : second.faces)
  {
    file.faces.push_back(f);
    for(std::size_t& v : file.faces.back())
      v = v == 0 ? 0 : v + 50;
  }
  write("two.obj", as_obj(file));
  const Result r = run("detect two.obj --json two.json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "constrictions: two.obj: 1 vertex added by splitting\n");
  const Json json = Json::parse(content("two.json"));
  EXPECT_EQ(json.at("mesh").at("vertices"), 100);
  EXPECT_EQ(json.at("mesh").at("components"), 2);
  ASSERT_EQ(json.at("constrictions").size(), 2u);
  for(const Json& c : json.at("constrictions"))
    EXPECT_NEAR(c.at("length").get<double>(), neck, 1e-12);
  expect_locations_fit(json, file);
  EXPECT_EQ(run("certify two.obj --curves two.json").exit_code, 0);

  // a loop through the split vertex, on either body
  write("loops.txt", "0 1 2 3 4 5 6 7 8 9\n0 51 52 53 54 55 56 57 58 59\n");
  const Result tightened = run("tighten two.obj --loops loops.txt");
  EXPECT_EQ(tightened.exit_code, 0) << tightened.err;
}

TEST_F(Program_repair, faces_left_out)
{
  Polygons file = triangulated(dumbbell());
  file.faces.insert(file.faces.begin(), {7, 7, 8});
  file.faces.push_back(file.faces[20]);
  write("a.obj", as_obj(file));
  const Result r = run("detect a.obj --json a.json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "constrictions: a.obj: 1 duplicate face left out, 1 degenerate face left out\n");
  const Json json = Json::parse(content("a.json"));
  EXPECT_EQ(json.at("mesh").at("faces"), file.faces.size());
  EXPECT_EQ(json.at("mesh").at("repairs"), (Json{{"duplicate_faces", 1}, {"degenerate_faces", 1}}));
  expect_locations_fit(json, file);
  EXPECT_EQ(run("certify a.obj --curves a.json").exit_code, 0);
  EXPECT_EQ(run("segment a.obj -o parts --quiet").exit_code, 0);
  const Json parts = Json::parse(content("parts/parts.json")).at("face_parts");
  ASSERT_EQ(parts.size(), file.faces.size());
  EXPECT_EQ(parts.back(), parts[20]);
  EXPECT_TRUE(parts[0].is_number());
}

TEST_F(Program_repair, standard_input)
{
  write("a.obj", as_obj(triangulated(dumbbell())));
  const std::string program = "'" CONSTRICTIONS_PROGRAM "'", in_folder = "cd '" + folder.string() + "' && ";
  ASSERT_EQ(std::system((in_folder + "cat a.obj | " + program + " detect - --json out.json 2> err.txt").c_str()), 0);
  EXPECT_EQ(content("err.txt"), "");
  const Json json = Json::parse(content("out.json"));
  EXPECT_EQ(json.at("mesh").at("file"), "-");
  EXPECT_EQ(json.at("constrictions").size(), 1u);
  ASSERT_EQ(std::system((in_folder + "gzip -c a.obj | " + program + " detect - --json - > out.json").c_str()), 0);
  EXPECT_EQ(Json::parse(content("out.json")).at("constrictions"), json.at("constrictions"));
}

TEST_F(Program_repair, check_prints_everything_and_writes_the_mesh)
{
  Polygons file = dumbbell();
  file.faces.push_back(file.faces[3]);
  std::reverse(file.faces[5].begin(), file.faces[5].end());
  write("a.obj", as_obj(file));
  const Result r = run("check a.obj -o repaired.off --json a.json");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for(const char* part : {"42 polygons triangulated", "1 duplicate face left out",
                          "face 42 has the same corners as face 3", "1 face turned round", "usable, as repaired"})
    EXPECT_NE(r.out.find(part), std::string::npos) << part << " in: " << r.out;
  const Json json = Json::parse(content("a.json"));
  EXPECT_EQ(json.at("format"), "constrictions-check/1");
  EXPECT_EQ(json.at("is_usable"), true);
  std::set<std::string> kinds;
  for(const Json& finding : json.at("findings"))
    kinds.insert(finding.at("kind").get<std::string>());
  EXPECT_EQ(kinds, (std::set<std::string>{"triangulated", "duplicate_faces", "turned_faces"}));

  const Result again = run("check repaired.off");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.out.find("\nusable\n"), std::string::npos) << again.out;
  const Json found = json_of("detect repaired.off --json -");
  EXPECT_EQ(found.at("mesh").at("repairs"), Json::object());
  EXPECT_EQ(found.at("constrictions").size(), 1u);
  for(const char* name : {"b.obj", "b.ply"})
  {
    EXPECT_EQ(run("check a.obj -o " + std::string(name)).exit_code, 0);
    EXPECT_EQ(json_of("detect " + std::string(name) + " --json -").at("constrictions").size(), 1u);
  }
  expect_wrong_usage("check a.obj -o repaired.xyz");
  expect_wrong_usage("check a.obj -o a.obj");
}

// A body of a thousandth in map coordinates. Seen from the origin its volume would be rounding errors.
TEST_F(Program_repair, volumes_far_from_the_origin)
{
  Polygons file = triangulated(dumbbell());
  write("near.obj", as_obj(file));
  for(Position& p : file.points)
    for(double& c : p)
      c = 1e6 + 1e-4 * c;
  write("far.obj", as_obj(file));
  for(Face& f : file.faces)
    std::reverse(f.begin(), f.end());
  write("inside_out.obj", as_obj(file));
  EXPECT_EQ(run("check far.obj").out.find("normals point inside"), std::string::npos);
  EXPECT_NE(run("check inside_out.obj").out.find("normals point inside"), std::string::npos);

  std::vector<std::vector<double>> volumes;
  for(const char* name : {"near", "far"})
  {
    EXPECT_EQ(run("segment " + std::string(name) + ".obj -o " + name).exit_code, 0);
    volumes.emplace_back();
    const Json parts = Json::parse(content(std::string(name) + "/parts.json"));
    for(const Json& part : parts.at("parts"))
      volumes.back().push_back(part.at("volume").get<double>());
    std::sort(volumes.back().begin(), volumes.back().end());
  }
  ASSERT_EQ(volumes[0].size(), 2u);
  ASSERT_EQ(volumes[1].size(), 2u);
  for(std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(volumes[1][i] * 1e12, volumes[0][i], 1e-3 * volumes[0][i]);
}

// An octahedron with two vertices that are one but for rounding, and two triangles between them.
TEST_F(Program_repair, check_tells_of_triangles_of_almost_no_height)
{
  const auto checked = [&](const std::string& arguments) {
    const Result r = run("check " + arguments + " --json check.json");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const Json report = Json::parse(content("check.json"));
    Json slivers;
    for(const Json& finding : report.at("findings"))
      if(finding.at("kind") == "slivers")
        slivers = finding;
    return std::make_pair(r.out, slivers);
  };
  const std::string octahedron = "1 0 0\n0 1 0\n0 0 1.5\n-1 0 0\n0 -1 0\n0 0 -0.25\n";
  const std::string faces =
      "3 0 1 2\n3 1 3 2\n3 3 4 2\n3 4 6 2\n3 1 0 5\n3 3 1 5\n3 4 3 5\n3 6 4 5\n3 5 0 6\n3 0 2 6\n";
  write("needles.off", "OFF\n7 10 0\n" + octahedron + "1 -1e-15 0.5e-15\n" + faces);
  const auto [text, needles] = checked("needles.off");
  EXPECT_NE(text.find("\n2 triangles of almost no height\n    the worst is face 9, around 0.666667 "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(" 0.5, 1.03775e-15 high and 1.80278 long\n2 of these have two corners in nearly one place: "
                      "--merge 2e-15 merges them\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(needles.at("count"), 2);
  EXPECT_EQ(needles.at("is_repaired"), false);
  EXPECT_EQ(needles.at("first").size(), 1u);
  EXPECT_EQ(needles.at("first")[0].get<std::string>().rfind("the worst is face 9, ", 0), 0u) << needles;
  EXPECT_DOUBLE_EQ(needles.at("merging_distance").get<double>(), 2e-15);
  const auto [merged, none] = checked("needles.off --merge 2e-15");
  EXPECT_NE(merged.find("1 vertex merged"), std::string::npos) << merged;
  EXPECT_EQ(none, Json()) << merged;

  // a vertex beside the middle of an edge: merging does not help
  const std::string tetrahedron = "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string with_cap = "3 0 2 4\n3 2 1 4\n3 0 4 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  write("cap.off", tetrahedron + "0.5 0 -1e-15\n" + with_cap);
  const auto [words, cap] = checked("cap.off");
  EXPECT_NE(
      words.find("\n1 triangle of almost no height\n    the worst is face 2, around 0.5 0 -3.33333e-16, 1e-15 high "
                 "and 1 long\nusable\n"),
      std::string::npos)
      << words;
  EXPECT_EQ(cap.at("merging_distance"), Json());

  // what is thin, and what is flat
  write("thin.off", "OFF\n7 10 0\n" + octahedron + "1 -1e-11 0\n" + faces);
  EXPECT_EQ(checked("thin.off").second, Json());
  write("flat.off", tetrahedron + "0.5 0 0\n" + with_cap);
  EXPECT_EQ(checked("flat.off").second, Json());
}

TEST_F(Program_repair, check_of_what_cannot_be_used)
{
  write("strip.off", "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n-1 0 1\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n");
  const Result r = run("check strip.off --json -");
  EXPECT_EQ(r.exit_code, 1);
  const Json json = Json::parse(r.out);
  EXPECT_EQ(json.at("is_usable"), false);
  EXPECT_NE(json.at("reason").get<std::string>().find("cannot be oriented"), std::string::npos);
  expect_failure(1, "detect strip.off", {"cannot be oriented"});
}

TEST_F(Program_repair, merging)
{
  // a seam at a ring: the upper half has vertices of its own, a little off
  Polygons file = triangulated(dumbbell());
  for(std::size_t i = 0; i < 10; ++i)
  {
    Position p = file.points[10 + i];
    p[2] += 1e-5;
    file.points.push_back(p);
  }
  for(std::size_t f = 20; f < file.faces.size(); ++f)
    for(std::size_t& v : file.faces[f])
      if(v >= 10 && v < 20)
        v += 40;
  write("a.obj", as_obj(file));
  expect_failure(1, "detect a.obj", {"not closed", "1e-05", "--merge"});
  const Json json = json_of("detect a.obj --merge 2e-5 --json -");
  EXPECT_EQ(json.at("mesh").at("repairs"), (Json{{"merged_vertices", 10}}));
  ASSERT_EQ(json.at("constrictions").size(), 1u);
  expect_wrong_usage("detect a.obj --merge 0");
  expect_wrong_usage("detect a.obj --merge x");
}

TEST_F(Program_repair, batch_groups_failures)
{
  write("a.obj", as_obj(dumbbell()));
  write("cloud_a.off", "OFF\n2 0 0\n0 0 0\n1 1 1\n");
  write("cloud_b.off", "OFF\n1 0 0\n0 0 0\n");
  write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  const Result r = run("batch a.obj cloud_a.off cloud_b.off index.off -o out");
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_NE(r.out.find("2   a point cloud\n"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("1   invalid vertex index\n"), std::string::npos) << r.out;
  EXPECT_NE(content("out/results.jsonl").find("\"repairs\":{\"triangulated\":42}"), std::string::npos);
}

// Does one of the things to a soup that happen to meshes.
void damage(Polygons& soup, std::mt19937& random)
{
  const auto below = [&random](std::size_t n) { return random() % n; };
  const auto replace = [&soup](std::size_t from, std::size_t to) {
    for(Face& f : soup.faces)
      std::replace(f.begin(), f.end(), from, to);
  };
  const std::size_t f = below(soup.faces.size());
  switch(below(6))
  {
  case 0:
    soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
    break;
  case 1:
    soup.faces.push_back(Face(soup.faces[f]));
    break;
  case 2:
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
    break;
  case 3:
    replace(below(soup.points.size()), below(soup.points.size()));
    break;
  case 4: // two edges become one
  {
    const Face g = soup.faces[f], h = soup.faces[below(soup.faces.size())];
    replace(g[0], h[1]);
    replace(g[1], h[0]);
  }
  break;
  default:
    soup.points[below(soup.points.size())] = soup.points[below(soup.points.size())];
  }
}

TEST_F(Program_repair, what_is_found_on_random_soups_is_proved_again)
{
  std::mt19937 random(26);
  std::size_t curves = 0, repaired = 0;
  for(int s = 0; s < 30; ++s)
  {
    SCOPED_TRACE(s);
    Polygons soup = s % 2 == 0 ? dumbbell() : triangulated(dumbbell());
    for(int deeds = 1 + s % 6; deeds > 0; --deeds)
      damage(soup, random);
    write("soup.obj", as_obj(soup));
    const Result found = run("detect soup.obj --all --quiet --json curves.json");
    ASSERT_EQ(found.exit_code, 0) << found.err;
    const Json json = Json::parse(content("curves.json"));
    curves += json["constrictions"].size();
    repaired += !json["mesh"]["repairs"].empty();
    const Result proved = run("certify soup.obj --curves curves.json");
    EXPECT_EQ(proved.exit_code, 0) << proved.out << proved.err;
    const Result checked = run("check soup.obj --json report.json -o repaired.off");
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_EQ(Json::parse(content("report.json"))["mesh"]["repairs"], json["mesh"]["repairs"]);
    // nothing is left to be repaired, and the surface is the same
    ASSERT_EQ(run("detect repaired.off --strict --quiet --no-certify --json again.json").exit_code, 0);
    const Json again = Json::parse(content("again.json"))["mesh"];
    EXPECT_EQ(again["repairs"], Json::object());
    for(const char* member : {"triangles", "components", "genus", "holes", "border_edges", "area"})
      EXPECT_EQ(again[member], json["mesh"][member]) << member;
  }
  EXPECT_GT(curves, 30u);
  EXPECT_GT(repaired, 25u);
}

} // namespace test_program_repair
