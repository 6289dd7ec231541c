// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/from_base64.h"
#include "include/program_fixture.h"
#include "include/test_meshes.h"

#include "output/base64.h"
#include "output/data_block.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace test_program_view {

namespace fs = std::filesystem;
using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";
const std::string eight = "'" CONSTRICTIONS_MESH_DIR "/eight.off'";

// What a page holds, as its scripts read it.
struct Page
{
  std::string html;
  json data;
  std::string block;

  explicit Page(const std::string& html)
    : html(html), data(json::parse(element("data"))), block(from_base64(element("block")))
  {}

  // the numbers of an array, all as doubles
  std::vector<double> numbers(const std::string& name) const
  {
    const json& a = data.at("arrays").at(name);
    const std::string type = a.at("type");
    const std::size_t offset = a.at("offset"), length = a.at("length");
    EXPECT_EQ(offset % 4, 0u);
    std::vector<double> result;
    for(std::size_t i = 0; i < length; ++i)
      result.push_back(type == "f32"   ? number<float>(offset, i)
                       : type == "u32" ? number<std::uint32_t>(offset, i)
                       : type == "u16" ? number<std::uint16_t>(offset, i)
                       : type == "u8"  ? number<std::uint8_t>(offset, i)
                                       : number<std::int8_t>(offset, i));
    return result;
  }

private:
  template <class Number>
  double number(std::size_t offset, std::size_t i) const
  {
    Number n;
    std::memcpy(&n, block.substr(offset + i * sizeof n, sizeof n).c_str(), sizeof n);
    return static_cast<double>(n);
  }

  std::string element(const std::string& id) const
  {
    const std::string mark = "id=\"" + id + "\">";
    const std::size_t begin = html.find(mark);
    if(begin == std::string::npos)
    {
      ADD_FAILURE() << "there is no " << id;
      return "null";
    }
    return html.substr(begin + mark.size(), html.find("</script>", begin) - begin - mark.size());
  }
};

double area(const std::vector<double>& points, const std::vector<double>& faces)
{
  double sum = 0;
  for(std::size_t f = 0; f < faces.size(); f += 3)
  {
    std::array<double, 3> u, v;
    for(std::size_t i = 0; i < 3; ++i)
    {
      const auto coordinate = [&](std::size_t corner) {
        return points.at(3 * static_cast<std::size_t>(faces[f + corner]) + i);
      };
      u[i] = coordinate(1) - coordinate(0);
      v[i] = coordinate(2) - coordinate(0);
    }
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

double volume(const std::vector<double>& points, const std::vector<double>& faces)
{
  double sum = 0;
  for(std::size_t f = 0; f < faces.size(); f += 3)
  {
    const auto x = [&](std::size_t corner, std::size_t i) {
      return points.at(3 * static_cast<std::size_t>(faces[f + corner]) + i);
    };
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum += x(0, i) * (x(1, j) * x(2, k) - x(1, k) * x(2, j)) / 6;
    }
  }
  return sum;
}

double length(const std::vector<double>& points, std::size_t begin, std::size_t end)
{
  double sum = 0;
  for(std::size_t i = begin; i < end; ++i)
  {
    const std::size_t p = 3 * i, q = 3 * (i + 1 < end ? i + 1 : begin);
    sum += std::hypot(points[p] - points[q], points[p + 1] - points[q + 1], points[p + 2] - points[q + 2]);
  }
  return sum;
}

TEST(Data_block, base64)
{
  using constrictions::as_base64;
  EXPECT_EQ(as_base64(""), "");
  EXPECT_EQ(as_base64("f"), "Zg==");
  EXPECT_EQ(as_base64("fo"), "Zm8=");
  EXPECT_EQ(as_base64("foo"), "Zm9v");
  EXPECT_EQ(as_base64("foob"), "Zm9vYg==");
  EXPECT_EQ(as_base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(as_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(as_base64(std::string("\x00\xff\xfe", 3)), "AP/+");
}

TEST(Data_block, arrays)
{
  constrictions::Data_block block;
  block.add("bytes", std::vector<std::int8_t>{-1, 2, 3});
  block.add("small", std::vector<std::uint32_t>{1, 65535});
  block.add("large", std::vector<std::uint32_t>{65536});
  block.add("float", std::vector<float>{1});
  EXPECT_EQ(json(block.directory()), json::parse(R"({"bytes": {"type": "i8", "offset": 0, "length": 3},
                                                     "small": {"type": "u16", "offset": 4, "length": 2},
                                                     "large": {"type": "u32", "offset": 8, "length": 1},
                                                     "float": {"type": "f32", "offset": 12, "length": 1}})"));
  EXPECT_EQ(block.bytes(), std::string("\xff\x02\x03\0\x01\0\xff\xff\0\0\x01\0\0\0\x80\x3f", 16));
}

#if CONSTRICTIONS_HAS_VIEWER

class View : public Program
{
protected:
  Page view(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    const Result r = run("view " + arguments + " -o page.html");
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.out + r.err, "");
    const Page page(content("page.html"));
    EXPECT_EQ(page.data.at("format"), "constrictions-view/1");
    expect_consistent(page);
    return page;
  }

  // The arrays of a surface that is not simplified, the curves and the playback fit together.
  void expect_consistent(const Page& page) const
  {
    const json& mesh = page.data.at("mesh");
    const double radius = page.data.at("radius");
    const double whole = mesh.at("area").get<double>() / (radius * radius);
    ASSERT_FALSE(page.data.at("is_simplified").get<bool>());
    const std::vector<double> faces = page.numbers("surface_faces"), parts = page.numbers("surface_parts");
    EXPECT_NEAR(area(page.numbers("surface_points"), faces), whole, 1e-5 * whole);
    EXPECT_EQ(parts.size(), faces.size() / 3);
    EXPECT_EQ(*std::max_element(parts.begin(), parts.end()) + 1, page.data.at("number_of_parts"));
    expect_consistent_sizes(page);

    const std::vector<double> points = page.numbers("curve_points"), begins = page.numbers("curve_begins");
    const json& curves = page.data.at("curves");
    ASSERT_EQ(begins.size(), curves.size() + 1);
    EXPECT_EQ(begins.back(), points.size() / 3);
    EXPECT_EQ(page.numbers("curve_normals").size(), points.size());
    for(std::size_t c = 0; c < curves.size(); ++c)
    {
      const double expected = curves[c].at("length").get<double>() / radius;
      EXPECT_NEAR(length(points, static_cast<std::size_t>(begins[c]), static_cast<std::size_t>(begins[c + 1])),
                  expected, 1e-5 * expected);
    }

    expect_consistent_levels(page, whole);
  }

  // Each part has the area that its faces have, and the volumes add up to that of the mesh.
  void expect_consistent_sizes(const Page& page) const
  {
    const double radius = page.data.at("radius");
    const std::vector<double> points = page.numbers("surface_points"), faces = page.numbers("surface_faces"),
                              part_of_face = page.numbers("surface_parts");
    const json& parts = page.data.at("parts");
    ASSERT_EQ(parts.size(), page.data.at("number_of_parts"));
    double sum = 0;
    for(std::size_t p = 0; p < parts.size(); ++p)
    {
      std::vector<double> own;
      for(std::size_t f = 0; f < part_of_face.size(); ++f)
        if(part_of_face[f] == static_cast<double>(p))
          own.insert(own.end(), {faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]});
      const double expected = area(points, own) * radius * radius;
      EXPECT_NEAR(parts[p].at("area").get<double>(), expected, 1e-4 * expected);
      sum += parts[p].at("volume").get<double>();
    }
    const double expected = volume(points, faces) * radius * radius * radius;
    EXPECT_NEAR(sum, expected, 1e-4 * std::abs(expected));
  }

  void expect_consistent_levels(const Page& page, double whole) const
  {
    const std::vector<double> points = page.numbers("levels_points"), parents = page.numbers("levels_parents");
    const json& playback = page.data.at("playback");
    EXPECT_EQ(playback.at("finest_shown_level"), 0);
    EXPECT_EQ(parents.size(), playback.at("collapses"));
    EXPECT_EQ(page.numbers("levels_moves").size(), 3 * parents.size());
    EXPECT_NEAR(area(points, page.numbers("levels_faces")), whole, 1e-5 * whole);
    for(std::size_t i = 0; i < parents.size(); ++i)
      EXPECT_LT(parents[i], static_cast<double>(points.size() / 3 - 1 - i));

    const json& frames = playback.at("frames");
    const std::vector<double> frame_begins = page.numbers("frame_begins"), curves = page.numbers("carried_curves"),
                              begins = page.numbers("carried_begins"), seeds = page.numbers("carried_are_seeds");
    ASSERT_EQ(frame_begins.size(), frames.size() + 1);
    EXPECT_EQ(begins.size(), curves.size() + 1);
    EXPECT_EQ(begins.back(), page.numbers("carried_points").size() / 3);
    EXPECT_EQ(frames.front().at("level"), playback.at("collapses"));
    EXPECT_EQ(frames.back().at("level"), 0);
    for(std::size_t f = 1; f < frames.size(); ++f)
      EXPECT_LT(frames[f].at("level"), frames[f - 1].at("level"));
    // a curve appears once, and as a seed
    std::vector<bool> is_known(page.data.at("curves").size(), false);
    for(std::size_t i = 0; i < curves.size(); ++i)
    {
      const std::size_t c = static_cast<std::size_t>(curves[i]);
      EXPECT_EQ(seeds[i] != 0, !is_known.at(c));
      is_known.at(c) = true;
    }
  }
};

TEST_F(View, holds_what_detect_finds)
{
  for(const std::string& arguments :
      {cactus, cactus + " --policy length", cactus + " --seeds triangles --max 2", eight, std::string("dumbbell.off")})
  {
    const Page page = view(arguments);
    const json expected = json::parse(run("detect " + arguments + " --min-prominence 0.01 --json - --quiet").out);
    const json& curves = page.data.at("curves");
    ASSERT_EQ(curves.size(), expected.at("constrictions").size());
    EXPECT_FALSE(curves.empty());
    for(std::size_t c = 0; c < curves.size(); ++c)
      for(const char* key :
          {"length", "diameter", "centroid", "prominence", "dominated_by", "side", "certificate", "separating"})
        EXPECT_EQ(curves[c].at(key), expected.at("constrictions")[c].at(key)) << key << " of " << c;
    EXPECT_EQ(page.data.at("prominence"), 0.05);
  }
}

TEST_F(View, thresholds)
{
  EXPECT_EQ(view(cactus + " --min-prominence 0.3").data.at("prominence"), 0.3);
  EXPECT_EQ(view(cactus + " --min-prominence 0.3").data.at("curves"), view(cactus).data.at("curves"));
  const Page all = view(cactus + " --all");
  EXPECT_EQ(all.data.at("prominence"), 0.05);
  EXPECT_GT(all.data.at("curves").size(), view(cactus).data.at("curves").size());
  EXPECT_EQ(view(cactus + " --max 0").data.at("curves").size(), 0u);
}

TEST_F(View, every_constriction_of_the_cactus_is_reached_by_a_seed)
{
  const Page page = view(cactus);
  const std::vector<double> begins = page.numbers("frame_begins"), curves = page.numbers("carried_curves");
  std::vector<double> last(curves.begin() + static_cast<std::ptrdiff_t>(begins[begins.size() - 2]), curves.end());
  std::sort(last.begin(), last.end());
  for(std::size_t c = 0; c < 3; ++c)
    EXPECT_TRUE(std::binary_search(last.begin(), last.end(), static_cast<double>(c))) << c;
}

TEST_F(View, same_input_same_page) { EXPECT_EQ(view(cactus).html, view(cactus).html); }

TEST_F(View, coordinates_may_be_large_or_small)
{
  for(const std::string exponent : {"e200", "e-200"})
  {
    std::string off = content("dumbbell.off"), scaled;
    std::size_t line = 0;
    for(std::size_t begin = 0; begin < off.size(); ++line)
    {
      const std::size_t end = off.find('\n', begin);
      std::string text = off.substr(begin, end - begin);
      // three numbers are a point
      if(line > 1 && std::count(text.begin(), text.end(), ' ') == 2)
      {
        for(std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + exponent.size() + 1))
          text.insert(at, exponent);
        text += exponent;
      }
      scaled += text + '\n';
      begin = end + 1;
    }
    write("scaled.off", scaled);
    const Result r = run("view scaled.off -o scaled.html");
    ASSERT_EQ(r.exit_code, 0) << r.err;
    const Page page(content("scaled.html")), plain = view("dumbbell.off");
    EXPECT_EQ(page.numbers("surface_points").size(), plain.numbers("surface_points").size());
    // vertices are numbered as they are taken out, in which rounding has a say
    std::vector<double> p = page.numbers("levels_points"), q = plain.numbers("levels_points");
    ASSERT_EQ(p.size(), q.size());
    std::sort(p.begin(), p.end());
    std::sort(q.begin(), q.end());
    for(std::size_t i = 0; i < p.size(); ++i)
      EXPECT_NEAR(p[i], q[i], 1e-6);
  }
}

// More faces than are simplified as a whole, in an order far from that along the surface. The neck is in the middle of
// the z axis, and the frame of a page around the middle of the mesh.
TEST_F(View, parts_of_a_large_mesh_are_where_they_are_on_its_levels)
{
  const test_meshes::Soup dumbbell = test_meshes::relabelled(test_meshes::dumbbell(0, 1, 300, 120), 1);
  std::string off =
      "OFF\n" + std::to_string(dumbbell.points.size()) + ' ' + std::to_string(dumbbell.faces.size()) + " 0\n";
  for(const auto& p : dumbbell.points)
    off += std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  for(const auto& f : dumbbell.faces)
    off += "3 " + std::to_string(f[0]) + ' ' + std::to_string(f[1]) + ' ' + std::to_string(f[2]) + '\n';
  write("large.off", off);
  const Page page = view("large.off");
  ASSERT_EQ(page.data.at("number_of_parts"), 2);
  const std::vector<double> points = page.numbers("levels_points"), faces = page.numbers("levels_faces"),
                            parts = page.numbers("levels_parts");
  std::set<double> below, above;
  for(std::size_t f = 0; f < parts.size(); ++f)
  {
    double z = 0;
    for(std::size_t i = 0; i < 3; ++i)
      z += points[3 * static_cast<std::size_t>(faces[3 * f + i]) + 2] / 3;
    if(std::abs(z) > 0.05)
      (z < 0 ? below : above).insert(parts[f]);
  }
  EXPECT_EQ(below.size(), 1u);
  EXPECT_EQ(above.size(), 1u);
  EXPECT_NE(below, above);
}

TEST_F(View, a_name_stays_text)
{
  const std::string name = "<script>alert(1)<!-- & '\xff.off";
  fs::create_directory(folder / "secret");
  write("secret/" + name, content("dumbbell.off"));
  const Result r = run("view \"secret/" + name + "\" -o page.html");
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const Page page(content("page.html"));
  EXPECT_EQ(page.html.find("alert(1)<"), std::string::npos);
  EXPECT_EQ(page.html.find("secret"), std::string::npos);
  EXPECT_EQ(page.data.at("mesh").at("file"), "<script>alert(1)<!-- & '\xEF\xBF\xBD.off");
  // those of the data, of the block, and of the page
  std::size_t scripts = 0;
  for(std::size_t at = page.html.find("</script"); at != std::string::npos; at = page.html.find("</script", at + 1))
    ++scripts;
  EXPECT_EQ(scripts, 3u);
}

TEST_F(View, needs_nothing_but_itself)
{
  const Page page = view("tetrahedron.off");
  EXPECT_EQ(page.data.at("curves").size(), 0u);
  for(const char* reference : {" src=\"", "@import", "url(http", "import("})
    EXPECT_EQ(page.html.find(reference), std::string::npos) << reference;
}

TEST_F(View, wrong_usage)
{
  for(const char* arguments :
      {"view dumbbell.off", "view -o page.html", "view dumbbell.off -o dumbbell.off",
       "view dumbbell.off -o page.html --json x.json", "view dumbbell.off -o page.html --policy x"})
    expect_wrong_usage(arguments);
}

TEST_F(View, what_cannot_be_read_or_written)
{
  expect_failure(1, "view missing.off -o page.html", {"missing.off"});
  write("no_folder", "");
  expect_failure(3, "view dumbbell.off -o no_folder/page.html", {"no_folder", "is not a folder"});
  fs::create_directory(folder / "taken");
  expect_failure(3, "view dumbbell.off -o taken", {"taken", "is a folder"});
}

#else

TEST_F(Program, view_says_that_it_was_left_out)
{
  expect_failure(2, "view dumbbell.off -o page.html", {"without the viewer"});
}

#endif

} // namespace test_program_view
