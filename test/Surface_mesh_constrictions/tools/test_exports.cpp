// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/from_base64.h"
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_exports {

using nlohmann::json;
using program_fixture::Program;

// The numbers at the beginning of a text of bytes.
template <class Number>
std::vector<Number> numbers(const std::string& bytes)
{
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Number));
  return result;
}

// The array of that name in a file of VTK's, whose bytes come after their number.
template <class Number>
std::vector<Number> vtk_array(const std::string& file, const std::string& name)
{
  const std::size_t element = file.find(" Name=\"" + name + "\""), begin = file.find('>', element) + 1;
  if(element == std::string::npos)
  {
    ADD_FAILURE() << "there is no " << name;
    return {};
  }
  const std::string bytes = from_base64(file.substr(begin, file.find('<', begin) - begin));
  EXPECT_EQ(numbers<std::uint64_t>(bytes.substr(0, 8)), std::vector<std::uint64_t>{bytes.size() - 8});
  return numbers<Number>(bytes.substr(8));
}

class Exports : public Program
{
protected:
  json curves;

  void detect(const std::string& mesh)
  {
    ASSERT_EQ(run("detect " + mesh + " -o results").exit_code, 0);
    curves = json::parse(content("results/constrictions.json")).at("constrictions");
  }
};

TEST_F(Exports, curves_for_vtk)
{
  detect("'" CONSTRICTIONS_MESH_DIR "/eight.off'");
  ASSERT_GT(curves.size(), 3u);
  const std::string vtp = content("results/constrictions.vtp");
  const std::vector<double> points = vtk_array<double>(vtp, "Points");
  const std::vector<std::int64_t> connectivity = vtk_array<std::int64_t>(vtp, "connectivity"),
                                  offsets = vtk_array<std::int64_t>(vtp, "offsets");
  EXPECT_NE(vtp.find("NumberOfPoints=\"" + std::to_string(points.size() / 3) + "\""), std::string::npos);
  EXPECT_NE(vtp.find("NumberOfLines=\"" + std::to_string(curves.size()) + "\""), std::string::npos);
  const std::vector<std::int32_t> sides = vtk_array<std::int32_t>(vtp, "side");
  const std::vector<std::uint8_t> colours = vtk_array<std::uint8_t>(vtp, "colour"),
                                  is_pivot = vtk_array<std::uint8_t>(vtp, "is_pivot");
  ASSERT_EQ(offsets.size(), curves.size());
  ASSERT_EQ(colours.size(), 3 * curves.size());
  ASSERT_EQ(is_pivot.size(), points.size() / 3);
  std::size_t at = 0, pivots = 0, expected_pivots = 0;
  for(std::size_t c = 0; c < curves.size(); ++c)
  {
    const json& expected = curves[c].at("points");
    ASSERT_EQ(static_cast<std::size_t>(offsets[c]), at + expected.size() + 1);
    EXPECT_EQ(connectivity[at], connectivity[at + expected.size()]); // closed
    for(std::size_t i = 0; i < expected.size(); ++i, ++at)
      for(std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(points[3 * static_cast<std::size_t>(connectivity[at]) + axis], expected[i][axis].get<double>());
    ++at;
    expected_pivots += curves[c].at("pivots").size();
    const std::string side = curves[c].at("side");
    EXPECT_EQ(sides[c], side == "object" ? 0 : side == "complement" ? 1 : 2);
    EXPECT_EQ(int(colours[3 * c]), side == "object" ? 0xd5 : 0);
  }
  for(std::uint8_t p : is_pivot)
    pivots += p;
  EXPECT_EQ(pivots, expected_pivots);
  for(const char* name : {"length", "prominence"})
  {
    std::vector<double> expected;
    for(const json& c : curves)
      expected.push_back(c.at(name));
    EXPECT_EQ(vtk_array<double>(vtp, name), expected) << name;
  }
}

TEST_F(Exports, curves_as_ply)
{
  detect("dumbbell.off");
  ASSERT_EQ(curves.size(), 1u);
  const json& points = curves[0].at("points");
  const std::string ply = content("results/constrictions.ply"), number = std::to_string(points.size());
  EXPECT_NE(ply.find("element vertex " + number + "\n"), std::string::npos);
  EXPECT_NE(ply.find("element edge " + number + "\n"), std::string::npos);
  const std::string mark = "end_header\n", data = ply.substr(ply.find(mark) + mark.size());
  const std::size_t vertex = 3 * 8 + 3, edge = 2 * 4;
  ASSERT_EQ(data.size(), points.size() * (vertex + edge));
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(json(numbers<double>(data.substr(i * vertex, 24))), points[i]);
    EXPECT_EQ(data.substr(i * vertex + 24, 3), std::string("\xd5\x5e\0", 3));
    const std::string e = data.substr(points.size() * vertex + i * edge, edge);
    EXPECT_EQ(numbers<std::uint32_t>(e),
              (std::vector<std::uint32_t>{std::uint32_t(i), std::uint32_t((i + 1) % points.size())}));
  }
}

TEST_F(Exports, curves_as_lines_of_obj)
{
  detect("'" CONSTRICTIONS_MESH_DIR "/cactus.off'");
  ASSERT_EQ(curves.size(), 3u);
  typedef std::pair<std::size_t, std::size_t> Step;
  std::istringstream lines(content("results/constrictions.obj"));
  std::size_t number_of_curves = 0, number_of_points = 0, first = 1;
  std::vector<json> points;
  std::vector<Step> steps;
  // of a curve that has been read
  const auto expect_closed_line = [&] {
    if(number_of_curves == 0)
      return;
    EXPECT_EQ(json(points), curves.at(number_of_curves - 1).at("points"));
    std::vector<Step> expected;
    for(std::size_t i = first; i <= number_of_points; ++i)
      expected.emplace_back(i, i < number_of_points ? i + 1 : first);
    EXPECT_EQ(steps, expected);
    first = number_of_points + 1;
    points.clear();
    steps.clear();
  };
  for(std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string keyword, rest;
    words >> keyword;
    if(keyword == "o")
    {
      expect_closed_line();
      EXPECT_EQ(line, "o constriction_" + std::to_string(number_of_curves++));
    }
    else if(keyword == "v")
    {
      std::vector<double> p(3);
      words >> p[0] >> p[1] >> p[2];
      points.push_back(json(p));
      ++number_of_points;
    }
    else if(keyword == "l")
    {
      Step step;
      words >> step.first >> step.second;
      EXPECT_FALSE(words >> rest) << "Blender 3.4 reads the first two points of a line only";
      steps.push_back(step);
    }
  }
  expect_closed_line();
  EXPECT_EQ(number_of_curves, 3u);
}

TEST_F(Exports, vtk_shows_an_array_at_first)
{
  detect("dumbbell.off");
  EXPECT_NE(content("results/constrictions.vtp").find("<CellData Scalars=\"prominence\">"), std::string::npos);
  ASSERT_EQ(run("segment dumbbell.off -o parts --quiet").exit_code, 0);
  EXPECT_NE(content("parts/parts.vtp").find("<CellData Scalars=\"patch\">"), std::string::npos);
}

TEST_F(Exports, no_curves)
{
  detect("tetrahedron.off");
  EXPECT_NE(content("results/constrictions.vtp").find("NumberOfPoints=\"0\""), std::string::npos);
  EXPECT_NE(content("results/constrictions.ply").find("element edge 0\n"), std::string::npos);
}

TEST_F(Exports, parts_for_vtk)
{
  ASSERT_EQ(run("segment dumbbell.off -o parts --quiet").exit_code, 0);
  const std::string vtp = content("parts/parts.vtp"), ply = content("parts/parts.ply");
  const std::vector<std::int32_t> patches = vtk_array<std::int32_t>(vtp, "patch");
  const std::vector<std::int64_t> offsets = vtk_array<std::int64_t>(vtp, "offsets");
  EXPECT_NE(ply.find("element face " + std::to_string(patches.size()) + "\n"), std::string::npos);
  ASSERT_EQ(offsets.size(), patches.size());
  for(std::size_t f = 0; f < offsets.size(); ++f)
    EXPECT_EQ(offsets[f], static_cast<std::int64_t>(3 * (f + 1)));
  // the file of the parts ends with the corners, the colour and the part of each face
  const std::vector<std::int64_t> corners = vtk_array<std::int64_t>(vtp, "connectivity");
  const std::vector<std::uint8_t> colours = vtk_array<std::uint8_t>(vtp, "colour");
  const std::size_t size = 1 + 3 * 4 + 3 + 4;
  for(std::size_t f = 0; f < patches.size(); ++f)
  {
    const std::string face = ply.substr(ply.size() - (patches.size() - f) * size, size);
    const std::vector<std::uint32_t> expected = numbers<std::uint32_t>(face.substr(1, 12));
    EXPECT_EQ(std::vector<std::int64_t>(corners.begin() + static_cast<std::ptrdiff_t>(3 * f),
                                        corners.begin() + static_cast<std::ptrdiff_t>(3 * f + 3)),
              std::vector<std::int64_t>(expected.begin(), expected.end()));
    EXPECT_EQ(numbers<std::uint8_t>(face.substr(13, 3)),
              std::vector<std::uint8_t>(colours.begin() + static_cast<std::ptrdiff_t>(3 * f),
                                        colours.begin() + static_cast<std::ptrdiff_t>(3 * f + 3)));
    EXPECT_EQ(numbers<std::int32_t>(face.substr(16)), std::vector<std::int32_t>{patches[f]});
  }
}

} // namespace test_exports
