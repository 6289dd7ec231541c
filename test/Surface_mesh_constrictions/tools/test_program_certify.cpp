// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_program_certify {

using nlohmann::json;
using program_fixture::Cubes;
using program_fixture::dumbbell;
using program_fixture::Grid_point;
using program_fixture::Program;
using program_fixture::Result;

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";

// The content of an OFF file of triangles.
struct Soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> faces;

  explicit Soup(std::istream& off)
  {
    std::string word;
    std::size_t nv = 0, nf = 0, ne = 0, n = 0;
    off >> word >> nv >> nf >> ne;
    points.resize(nv);
    for(auto& p : points)
    {
      off >> p[0] >> p[1] >> p[2];
      std::getline(off, word); // colours
    }
    faces.resize(nf);
    for(auto& f : faces)
      off >> n >> f[0] >> f[1] >> f[2];
    EXPECT_TRUE(off.good() && nf > 0);
  }

  std::string off() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "OFF\n" << points.size() << ' ' << faces.size() << " 0\n";
    for(const auto& p : points)
      out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& f : faces)
      out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
    return out.str();
  }

  std::string stl() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "solid\n";
    for(const auto& f : faces)
    {
      out << "facet normal 0 0 0\nouter loop\n";
      for(std::size_t v : f)
        out << "vertex " << points[v][0] << ' ' << points[v][1] << ' ' << points[v][2] << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid\n";
    return out.str();
  }
};

class Certify : public Program
{
protected:
  static Soup cactus_soup()
  {
    std::ifstream in(CONSTRICTIONS_MESH_DIR "/cactus.off");
    return Soup(in);
  }

  // What detect finds on a mesh.
  json curves(const std::string& mesh) const
  {
    const Result r = run("detect " + mesh + " --all --json -");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    json result = json::parse(r.out);
    EXPECT_FALSE(result.at("constrictions").empty());
    return result;
  }

  Result certify(const std::string& mesh, const json& curves) const
  {
    write("curves.json", curves.dump());
    return run("certify " + mesh + " --curves curves.json");
  }

  // Every curve gets the certificate that it was found with; what was repaired is told.
  void expect_certified(const std::string& mesh, const json& curves, const std::string& repairs = "") const
  {
    SCOPED_TRACE(mesh);
    const Result r = certify(mesh, curves);
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err, repairs.empty() ? "" : "constrictions: " + mesh + ": " + repairs + '\n');
    std::string expected;
    for(const json& c : curves.at("constrictions"))
      expected += std::to_string(c.at("id").get<int>()) + ' ' + c.at("certificate").get<std::string>() + '\n';
    EXPECT_EQ(r.out, expected);
  }

  // What others may write: a closed path of vertices of the dumbbell, and nothing but the locations.
  json path(const std::vector<Grid_point>& vertices) const
  {
    Cubes cubes = dumbbell();
    std::istringstream off(cubes.off());
    const Soup soup(off);
    json locations = json::array();
    for(const Grid_point& p : vertices)
    {
      const std::size_t v = static_cast<std::size_t>(cubes.vertex(p));
      for(std::size_t f = 0; f < soup.faces.size(); ++f)
      {
        const auto& corners = soup.faces[f];
        if(std::find(corners.begin(), corners.end(), v) == corners.end())
          continue;
        locations.push_back(
            {{"face", f}, {"barycentric", {int(corners[0] == v), int(corners[1] == v), int(corners[2] == v)}}});
        break;
      }
    }
    return {{"constrictions", {{{"locations", locations}}}}};
  }
};

// The corners of a rectangle in a plane x = const, and all grid points between them.
std::vector<Grid_point> belt(int x, int low, int high)
{
  std::vector<Grid_point> result;
  for(int i = low; i < high; ++i)
    result.push_back({x, i, low});
  for(int i = low; i < high; ++i)
    result.push_back({x, high, i});
  for(int i = high; i > low; --i)
    result.push_back({x, i, high});
  for(int i = high; i > low; --i)
    result.push_back({x, low, i});
  return result;
}

TEST_F(Certify, accepts_what_detect_has_found)
{
  expect_certified("dumbbell.off", curves("dumbbell.off"));
  for(const char* name : {"cactus.off", "elephant.off"})
  {
    const std::string mesh = "'" CONSTRICTIONS_MESH_DIR "/" + std::string(name) + "'";
    expect_certified(mesh, curves(mesh));
  }
}

TEST_F(Certify, accepts_what_tighten_has_found)
{
  Cubes cubes = dumbbell();
  write("dumbbell.off", cubes.off());
  std::string loop;
  for(const Grid_point& p : belt(4, 1, 2))
    loop += std::to_string(cubes.vertex(p)) + ' ';
  write("loops.txt", loop);
  expect_certified("dumbbell.off", json::parse(run("tighten dumbbell.off --loops loops.txt --json -").out));
}

TEST_F(Certify, proves_what_has_not_been_proved)
{
  const json plain = json::parse(run("detect " + cactus + " --all --no-certify --json -").out);
  json proved = curves(cactus);
  ASSERT_EQ(plain.at("constrictions").size(), proved.at("constrictions").size());
  const Result r = certify(cactus, plain);
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(std::count(r.out.begin(), r.out.end(), '\n'), static_cast<long>(proved.at("constrictions").size()));
}

TEST_F(Certify, faces_that_were_turned)
{
  Soup soup = cactus_soup();
  for(std::size_t f = 0; f < soup.faces.size(); f += 3)
    std::swap(soup.faces[f][1], soup.faces[f][2]);
  write("turned.off", soup.off());
  expect_certified("turned.off", curves("turned.off"), "412 faces turned round");
}

TEST_F(Certify, seams_and_stl_files)
{
  const Soup closed = cactus_soup();
  write("cactus.stl", closed.stl());
  expect_certified("cactus.stl", curves("cactus.stl"));

  // at the first pivot a face gets a vertex of its own; then the pivot is called by that
  json found = curves(cactus);
  json& pivot = found.at("constrictions").at(0).at("pivots").at(0);
  const std::size_t v = pivot.at("vertex").get<std::size_t>();
  Soup seam = closed;
  seam.points.push_back(seam.points[v]);
  const auto face = std::find_if(seam.faces.begin(), seam.faces.end(),
                                 [v](const auto& f) { return std::find(f.begin(), f.end(), v) != f.end(); });
  ASSERT_NE(face, seam.faces.end());
  *std::find(face->begin(), face->end(), v) = closed.points.size();
  write("seam.off", seam.off());
  expect_certified("seam.off", found, "1 vertex merged");
  pivot["vertex"] = closed.points.size();
  expect_certified("seam.off", found, "1 vertex merged");
}

TEST_F(Certify, numbers_and_directions_are_not_trusted)
{
  const json found = curves(cactus);
  json rounded = found, reversed = found;
  for(json& c : rounded.at("constrictions"))
    for(json& location : c.at("locations"))
      for(json& x : location.at("barycentric"))
        x = std::round(10 * x.get<double>()) / 10;
  expect_certified(cactus, rounded);

  for(json& c : reversed.at("constrictions"))
  {
    std::reverse(c.at("locations").begin(), c.at("locations").end());
    for(json& pivot : c.at("pivots"))
      pivot["point"] = c.at("locations").size() - 1 - pivot.at("point").get<std::size_t>();
  }
  expect_certified(cactus, reversed);
}

// As a tool does that writes a mesh anew: other numbers for vertices and faces, and faces that begin at another corner.
Soup numbered_anew(const Soup& soup)
{
  Soup result = soup;
  const std::size_t n = soup.points.size(), m = soup.faces.size(), step = 7919; // a prime
  for(std::size_t v = 0; v < n; ++v)
    for(std::size_t k = 0; k < 3; ++k)
      result.points[v * step % n][k] = soup.points[v][k];
  for(std::size_t f = 0; f < m; ++f)
    for(std::size_t k = 0; k < 3; ++k)
      result.faces[f * step % m][k] = soup.faces[f][(k + f) % 3] * step % n;
  return result;
}

// As meshes that are compressed come back: the same numbers, but two faces of five begin at another corner.
Soup with_other_first_corners(const Soup& soup)
{
  Soup result = soup;
  for(std::size_t f = 0; f < result.faces.size(); ++f)
    if(f % 5 < 2)
      std::rotate(result.faces[f].begin(), result.faces[f].begin() + 1, result.faces[f].end());
  return result;
}

// As a tool does that keeps the faces, and numbers the vertices in another way.
Soup with_vertices_from_behind(const Soup& soup)
{
  Soup result = soup;
  std::reverse(result.points.begin(), result.points.end());
  for(auto& f : result.faces)
    for(auto& v : f)
      v = soup.points.size() - 1 - v;
  return result;
}

TEST_F(Certify, curves_are_found_on_a_mesh_that_was_numbered_anew)
{
  const auto expect_found = [this](const Soup& soup, const json& of_old_mesh,
                                   Soup (&change)(const Soup&) = numbered_anew) {
    write("anew.off", change(soup).off());
    const Result r = certify("anew.off", of_old_mesh);
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err, "constrictions: curves.json: the mesh is numbered in another way now; the curves were found by "
                     "their points\n");
    std::string expected;
    for(const json& c : of_old_mesh.at("constrictions"))
      expected += std::to_string(c.at("id").get<int>()) + ' ' + c.at("certificate").get<std::string>() + '\n';
    EXPECT_EQ(r.out, expected);
  };
  expect_found(cactus_soup(), curves(cactus));
  std::ifstream in(CONSTRICTIONS_MESH_DIR "/eight.off");
  expect_found(Soup(in), json::parse(run("detect '" CONSTRICTIONS_MESH_DIR "/eight.off' --json -").out));
  std::istringstream cubes(dumbbell().off());
  expect_found(Soup(cubes), curves("dumbbell.off"));
  expect_found(cactus_soup(), curves(cactus), with_other_first_corners);
  expect_found(cactus_soup(), curves(cactus), with_vertices_from_behind);
  // in six digits, as some tools write: points are a little beside the edges
  Soup rounded = cactus_soup();
  for(auto& p : rounded.points)
    for(double& x : p)
      x = std::round(1e6 * x) / 1e6 + 1e-7;
  expect_found(rounded, json::parse(run("detect " + cactus + " --json -").out));
}

TEST_F(Certify, curves_that_are_not_on_the_mesh_are_refused)
{
  Soup moved = numbered_anew(cactus_soup());
  for(auto& p : moved.points)
    p[0] += 0.01;
  write("moved.off", moved.off());
  write("curves.json", curves(cactus).dump());
  expect_failure(1, "certify moved.off --curves curves.json", {"curves.json: curve 0, point ", "is not on this mesh"});
  // without the points nothing can be found
  json bare = curves(cactus);
  for(json& c : bare.at("constrictions"))
    c.erase("points");
  write("bare.json", bare.dump());
  write("anew.off", numbered_anew(cactus_soup()).off());
  EXPECT_NE(run("certify anew.off --curves bare.json").exit_code, 0);
}

TEST_F(Certify, curves_of_others)
{
  json around_tube = path(belt(4, 1, 2));
  around_tube["constrictions"][0]["certificate"] = "constriction";
  around_tube["constrictions"][0]["id"] = 7;
  expect_certified("dumbbell.off", around_tube);

  const Result leaks = certify("dumbbell.off", path(belt(1, 0, 3)));
  EXPECT_EQ(leaks.exit_code, 1);
  EXPECT_EQ(leaks.out.rfind("0 not_certified: the flat band on the ", 0), 0u) << leaks.out;
  // around one square
  const Result bends = certify("dumbbell.off", path({{0, 1, 1}, {0, 2, 1}, {0, 2, 2}, {0, 1, 2}}));
  EXPECT_EQ(bends.exit_code, 1);
  EXPECT_EQ(bends.out.rfind("0 not_certified: the side angle on the ", 0), 0u) << bends.out;
}

TEST_F(Certify, a_crossing_on_another_edge_is_refused)
{
  json moved = curves(cactus);
  json& curve = moved.at("constrictions").at(2);
  std::vector<bool> is_pivot(curve.at("locations").size(), false);
  for(const json& pivot : curve.at("pivots"))
    is_pivot[pivot.at("point").get<std::size_t>()] = true;
  std::size_t i = 1;
  while(is_pivot.at(i) || is_pivot.at(i - 1))
    ++i;
  const Soup soup = cactus_soup();
  const json& location = curve.at("locations").at(i);
  // a face far away
  curve.at("locations")[i]["face"] =
      (location.at("face").get<std::size_t>() + soup.faces.size() / 2) % soup.faces.size();

  const Result r = certify(cactus, moved);
  EXPECT_EQ(r.exit_code, 1);
  std::istringstream lines(r.out);
  std::string line;
  for(std::size_t id = 0; id < moved.at("constrictions").size(); ++id)
  {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line, id == 2 ? "2 not_certified: not a closed curve, point " + std::to_string(i - 1) +
                                  " does not fit the next one"
                            : std::to_string(id) + " strict_constriction");
  }
  EXPECT_FALSE(std::getline(lines, line));
  EXPECT_EQ(r.err, "constrictions: curves.json: 1 of " + std::to_string(moved.at("constrictions").size()) +
                       " curves not certified\n");
}

TEST_F(Certify, verdicts_as_json)
{
  const json found = json::parse(run("detect dumbbell.off --json - --quiet").out);
  write("curves.json", found.dump());
  const Result r = run("certify dumbbell.off --curves curves.json --json - --quiet");
  EXPECT_EQ(r.exit_code, 0);
  const json j = json::parse(r.out);
  EXPECT_EQ(j.at("format"), "constrictions-certificates/1");
  EXPECT_EQ(j.at("mesh"), (json{{"file", "dumbbell.off"}, {"vertices", 116}, {"faces", 228}}));
  ASSERT_EQ(j.at("certificates").size(), 1u);
  EXPECT_EQ(j.at("certificates")[0].at("id"), 0);
  EXPECT_EQ(j.at("certificates")[0].at("verdict"), "constriction");
  EXPECT_DOUBLE_EQ(j.at("certificates")[0].at("length").get<double>(), 4);

  const Result to_file = run("certify dumbbell.off --curves curves.json --json verdicts.json");
  EXPECT_EQ(to_file.exit_code, 0);
  EXPECT_EQ(to_file.out, "0 constriction\n");
  EXPECT_EQ(json::parse(content("verdicts.json")), j);
  expect_failure(3, "certify dumbbell.off --curves curves.json --json curves.json/a.json",
                 {"curves.json: is not a folder"});
}

TEST_F(Certify, no_curves_are_no_failure)
{
  const Result r = certify("tetrahedron.off", json::parse(run("detect tetrahedron.off --json -").out));
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err, "");
}

TEST_F(Certify, unusable_curves)
{
  const json found = curves("dumbbell.off");
  const auto expect_error = [&](const std::string& text, const std::string& message) {
    write("curves.json", text);
    expect_failure(1, "certify dumbbell.off --curves curves.json", {"curves.json: " + message});
  };
  // the file after a change to its first curve
  const auto expect_curve_error = [&](const std::function<void(json&)>& change, const std::string& message) {
    json changed = found;
    change(changed.at("constrictions").at(0));
    expect_error(changed.dump(), message);
  };
  const auto expect_point_error = [&](const json& face, const json& barycentric, const std::string& message) {
    expect_curve_error(
        [&](json& c) {
          c.erase("pivots");
          c["locations"][1] = {{"face", face}, {"barycentric", barycentric}};
        },
        "curve 0, point 1: " + message);
  };

  expect_failure(1, "certify dumbbell.off --curves missing.json", {"missing.json: no such file"});
  expect_failure(1, "certify missing.off --curves missing.json", {"missing.off: no such file"});
  expect_error("", "not JSON: ");
  expect_error("{\"constrictions\": [}", "not JSON: wrong at byte 20");
  expect_error("[1e999]", "not JSON: ");
  expect_error("[]", "not a JSON object");
  expect_error("{}", "\"constrictions\" is missing");
  expect_error("{\"constrictions\": 3}", "\"constrictions\" is not an array");
  expect_error("{\"constrictions\": [{\"locations\": [1]}, 3]}", "curve 0, point 0: \"face\" is missing");
  expect_error("{\"constrictions\": [3]}", "curve at place 0: not a JSON object");
  expect_error("{\"format\": \"constrictions/2\"}", "the format is not \"constrictions/1\"");
  expect_error(curves(cactus).dump(), "the curves are of a mesh with 1236 faces, this one has 228");

  expect_curve_error([](json& c) { c["id"] = "neck"; }, "curve at place 0: \"id\" is not a number");
  expect_curve_error([](json& c) { c.erase("locations"); }, "curve 0: \"locations\" is missing");
  expect_curve_error([](json& c) { c["locations"] = json::array(); }, "curve 0: it has no locations");
  expect_curve_error([](json& c) { c["pivots"] = 1; }, "curve 0: \"pivots\" is not an array");
  expect_curve_error([](json& c) { c["pivots"][0] = 1; }, "curve 0: \"vertex\" is missing");
  expect_curve_error([](json& c) { c["pivots"][0]["vertex"] = -1; }, "curve 0: \"vertex\" is not a number counted");
  expect_curve_error([](json& c) { c["pivots"][0]["point"] = 99; }, "curve 0: pivot at point 99, which does not exist");
  expect_curve_error([](json& c) { c["pivots"][0]["vertex"] = 116; },
                     "curve 0: pivot at point 0: vertex 116 does not exist: the mesh has 116 vertices");
  expect_curve_error([](json& c) { c["pivots"][0]["vertex"] = (c["pivots"][0]["vertex"].get<int>() + 1) % 116; },
                     "curve 0, point 0: the pivot is vertex ");

  const json middle = {0.5, 0.25, 0.25}, corner = {1, 0, 0};
  expect_point_error(228, corner, "face 228 does not exist: the mesh has 228 faces");
  expect_point_error(1.5, corner, "\"face\" is not a number counted from 0");
  expect_point_error(0, middle, "no coordinate of \"barycentric\" is zero");
  expect_point_error(0, {1, 0}, "\"barycentric\" is not three numbers");
  expect_point_error(0, {1, 0, "0"}, "\"barycentric\" is not three numbers");
  expect_point_error(0, {0, 0, 0}, "\"barycentric\" is not a point of a face");
  expect_point_error(0, {0, -1, 2}, "\"barycentric\" is not a point of a face");
}

TEST_F(Certify, wrong_usage)
{
  write("curves.json", "{\"constrictions\": []}");
  EXPECT_EQ(run("certify dumbbell.off --curves curves.json").exit_code, 0);
  expect_wrong_usage("certify --curves curves.json");
  expect_wrong_usage("certify dumbbell.off --curves ''");
  expect_wrong_usage("certify dumbbell.off --curves curves.json --polylines a.txt");
  expect_wrong_usage("certify dumbbell.off --curves curves.json --json curves.json");
  expect_wrong_usage("certify dumbbell.off --curves curves.json --json dumbbell.off");
  expect_wrong_usage("detect dumbbell.off --curves curves.json");
}

} // namespace test_program_certify
