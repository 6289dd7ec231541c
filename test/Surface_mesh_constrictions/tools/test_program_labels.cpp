// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_program_labels {

using nlohmann::json;
using program_fixture::dumbbell;
using program_fixture::Program;
using program_fixture::Result;

class Labels : public Program
{
protected:
  // A label for each face of an OFF file of triangles, by the mean x of its corners.
  template <class LabelOf>
  std::string labels_of(const std::string& off, const LabelOf& label_of) const
  {
    std::istringstream in(off);
    std::string word;
    std::size_t vertices = 0, faces = 0, edges = 0;
    in >> word >> vertices >> faces >> edges;
    std::vector<double> x(vertices);
    for(double& value : x)
    {
      double y = 0, z = 0;
      in >> value >> y >> z;
    }
    std::ostringstream out;
    for(std::size_t f = 0; f < faces; ++f)
    {
      std::size_t n = 0, corner = 0;
      double sum = 0;
      in >> n;
      for(std::size_t i = 0; i < n; ++i)
      {
        in >> corner;
        sum += x[corner];
      }
      out << label_of(sum / static_cast<double>(n), f) << '\n';
    }
    return out.str();
  }

  json tighten(const std::string& arguments) const
  {
    const Result r = run("tighten " + arguments + " --json -");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return json::parse(r.out);
  }

  // The cubes are joined by a tube of width 1 from x = 3 to x = 5.
  const std::string mesh = dumbbell().off();
};

TEST_F(Labels, a_border_around_a_tube_becomes_a_constriction)
{
  write("labels.txt", "# by hand\n" + labels_of(mesh, [](double x, std::size_t f) {
                        return x + 0.4 * static_cast<double>(f % 2) < 4.2 ? 7 : -2;
                      }));
  const json found = tighten("dumbbell.off --labels labels.txt");
  ASSERT_EQ(found["constrictions"].size(), 1u);
  const json ring = *std::find_if(found["borders"].begin(), found["borders"].end(),
                                  [](const json& b) { return b["outcome"] == "closed_geodesic"; });
  EXPECT_EQ(ring["labels"], json({-2, 7}));
  EXPECT_TRUE(ring["closed"]);
  EXPECT_EQ(ring["constriction"], 0);
  EXPECT_EQ(ring["certificate"], "constriction");
  EXPECT_NEAR(ring["length"], 4, 1e-12);
  EXPECT_GE(ring["old_length"], 4);
  EXPECT_EQ(ring["points"].size(), ring["locations"].size());
  double area = 0;
  for(const json& part : found["label_parts"])
    area += part["area"].get<double>();
  EXPECT_NEAR(area, found["mesh"]["area"], 1e-11);
  EXPECT_EQ(found["face_labels"].size(), found["mesh"]["faces"]);
  EXPECT_EQ(std::set<json>(found["face_labels"].begin(), found["face_labels"].end()), (std::set<json>{-2, 7}));
}

TEST_F(Labels, a_label_that_vanishes_is_named_in_the_table)
{
  write("labels.txt", labels_of(mesh, [](double x, std::size_t f) { return f == 0 ? 5 : x < 4 ? 1 : 2; }));
  const Result r = run("tighten dumbbell.off --labels labels.txt");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_NE(r.out.find("degenerate"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("closed_geodesic"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("2 borders, 3 labels before, 2 after, in 2 parts\n"), std::string::npos) << r.out;
  std::istringstream lines(r.out);
  for(std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80u) << line;
}

TEST_F(Labels, new_labels_and_closed_parts_are_written)
{
  write("labels.txt", labels_of(mesh, [](double x, std::size_t f) { return f == 0 ? 5 : x < 4 ? 1 : 2; }));
  const Result r = run("tighten dumbbell.off --labels labels.txt -o result");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_TRUE(r.out.empty()) << r.out;
  const json found = json::parse(content("result/constrictions.json"));
  std::istringstream lines(content("result/labels.txt"));
  std::size_t n = 0;
  for(int label = 0; lines >> label; ++n)
    EXPECT_EQ(label, found["face_labels"].at(n));
  EXPECT_EQ(n, found["mesh"]["faces"]);
  const json parts = json::parse(content("result/parts.json"));
  ASSERT_EQ(parts["parts"].size(), 2u);
  std::set<int> labels;
  for(const json& part : parts["parts"])
  {
    labels.insert(part["label"].get<int>());
    EXPECT_EQ(content("result/" + part["file"].get<std::string>()).substr(0, 3), "ply");
    EXPECT_GT(part["volume"], 0);
  }
  EXPECT_EQ(labels, (std::set<int>{1, 2}));
  EXPECT_EQ(parts["curves"].size(), found["borders"].size());
  // what is written is tight
  const json again = tighten("dumbbell.off --labels result/labels.txt");
  EXPECT_EQ(again["face_labels"], found["face_labels"]);
}

// Squares: the label of a face of the file is that of both of its triangles.
TEST_F(Labels, are_those_of_polygons)
{
  write("tube.off", "OFF\n12 8 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n0 0 2\n1 0 2\n1 1 2\n0 1 2\n"
                    "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n4 4 5 9 8\n4 5 6 10 9\n4 6 7 11 10\n4 7 4 8 11\n");
  write("labels.txt", "1\n1\n1\n1\n2\n2\n2\n2\n");
  const json found = tighten("tube.off --labels labels.txt");
  ASSERT_EQ(found["borders"].size(), 1u);
  EXPECT_EQ(found["borders"][0]["outcome"], "closed_geodesic");
  EXPECT_NEAR(found["borders"][0]["length"], 4, 1e-12);
  EXPECT_EQ(found["face_labels"].size(), 8u);
  // two strips of squares along the tube: each border is held at the rims
  write("labels.txt", "1\n1\n2\n2\n1\n1\n2\n2\n");
  const json strips = tighten("tube.off --labels labels.txt --polylines lines.txt");
  ASSERT_EQ(strips["borders"].size(), 2u);
  for(const json& b : strips["borders"])
  {
    EXPECT_EQ(b["outcome"], "geodesic_arc");
    EXPECT_EQ(b["certificate"], "geodesic_arc");
    EXPECT_FALSE(b["closed"]);
    EXPECT_NEAR(b["length"], 2, 1e-12);
  }
  EXPECT_EQ(strips["face_labels"], json({1, 1, 2, 2, 1, 1, 2, 2}));
  EXPECT_EQ(content("lines.txt").substr(0, 2), "3 ");
}

TEST_F(Labels, mistakes_in_their_file_are_told_with_the_line)
{
  const std::string good = labels_of(mesh, [](double x, std::size_t) { return x < 4 ? 1 : 2; });
  write("labels.txt", "1\nneck\n");
  expect_failure(1, "tighten dumbbell.off --labels labels.txt", {"labels.txt: line 2: \"neck\" is not a label"});
  write("labels.txt", "1\n1.5\n");
  expect_failure(1, "tighten dumbbell.off --labels labels.txt", {"labels.txt: line 2: \"1.5\" is not a label"});
  write("labels.txt", "1\n# two\n2 3\n");
  expect_failure(1, "tighten dumbbell.off --labels labels.txt", {"labels.txt: line 3: \"3\" follows a label"});
  write("labels.txt", "1\n2\n");
  expect_failure(1, "tighten dumbbell.off --labels labels.txt", {"labels.txt: line 3: the file ends after 2 labels"});
  write("labels.txt", good + "4\n");
  expect_failure(1, "tighten dumbbell.off --labels labels.txt", {"labels.txt: line ", "more labels than faces"});
  expect_failure(1, "tighten dumbbell.off --labels missing.txt", {"missing.txt: no such file"});
}

TEST_F(Labels, are_given_instead_of_loops)
{
  write("labels.txt", "1\n");
  EXPECT_EQ(run("tighten dumbbell.off --labels labels.txt --loops labels.txt").exit_code, 2);
  EXPECT_EQ(run("tighten dumbbell.off --labels labels.txt --json labels.txt").exit_code, 2);
  EXPECT_EQ(run("tighten dumbbell.off --labels ''").exit_code, 2);
  write("result/labels.txt", "1\n");
  EXPECT_EQ(run("tighten dumbbell.off --labels result/labels.txt -o result").exit_code, 2);
}

} // namespace test_program_labels
