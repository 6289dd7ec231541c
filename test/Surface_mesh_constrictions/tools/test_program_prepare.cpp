// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>

// A mesh is prepared once, for several calls of the program.
namespace test_program_prepare {

using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

class Prepare : public Program
{
protected:
  // What a call reports, but for what it has used up.
  json report(const std::string& arguments) const
  {
    const Result r = run(arguments + " --json -");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    json result = json::parse(r.out);
    result.erase("seconds");
    result.erase("peak_rss_bytes");
    return result;
  }

  std::string refusal(const std::string& arguments) const
  {
    const Result r = run(arguments);
    EXPECT_EQ(r.exit_code, 1) << r.out;
    EXPECT_TRUE(r.out.empty());
    return r.err;
  }
};

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'";

TEST_F(Prepare, detect_and_girth_report_the_same_as_without)
{
  const Result prepared = run("prepare " + cactus + " -o cactus.prepared");
  EXPECT_EQ(prepared.exit_code, 0) << prepared.err;
  EXPECT_TRUE(prepared.out.empty());
  write("places.csv", "arm,0.2,0.03,0.3\n");
  for(const std::string& question :
      {"detect " + cactus, "detect " + cactus + " --all --no-certify", "detect " + cactus + " --near 0.2,0.03,0.3",
       "detect " + cactus + " --landmarks places.csv", "detect " + cactus + " --max 2 --prove-prominence",
       "girth " + cactus + " --at 0.2,0.03,0.3 --max 3", "girth " + cactus + " --landmarks places.csv --axis 0,0,1"})
    EXPECT_EQ(report(question), report(question + " --prepared cactus.prepared")) << question;
}

TEST_F(Prepare, a_file_of_another_mesh_or_none_is_refused_with_its_name)
{
  ASSERT_EQ(run("prepare dumbbell.off -o d.prepared").exit_code, 0);
  EXPECT_EQ(
      refusal("detect tetrahedron.off --prepared d.prepared").find("constrictions: d.prepared: query file, byte "), 0u);
  EXPECT_NE(refusal("girth tetrahedron.off --at 0,0,0 --prepared d.prepared").find("prepared for another mesh"),
            std::string::npos);
  EXPECT_NE(refusal("detect dumbbell.off --prepared dumbbell.off").find("not the file of a prepared mesh"),
            std::string::npos);
  EXPECT_EQ(refusal("detect dumbbell.off --prepared none"), "constrictions: none: no such file\n");
  // the repaired mesh is another one
  EXPECT_NE(refusal("detect dumbbell.off --merge 1.1 --prepared d.prepared").find("prepared for another mesh"),
            std::string::npos);
}

TEST_F(Prepare, neither_the_mesh_nor_what_was_prepared_is_overwritten)
{
  EXPECT_EQ(run("prepare dumbbell.off -o dumbbell.off").exit_code, 2);
  ASSERT_EQ(run("prepare dumbbell.off -o d.prepared").exit_code, 0);
  EXPECT_EQ(run("detect dumbbell.off --prepared d.prepared --json d.prepared").exit_code, 2);
  EXPECT_EQ(run("prepare dumbbell.off").exit_code, 2);
  EXPECT_EQ(run("detect dumbbell.off --prepared d.prepared --policy lt").exit_code, 2);
  EXPECT_EQ(run("detect dumbbell.off --prepared d.prepared --seeds triangles").exit_code, 2);
  EXPECT_EQ(run("prepare dumbbell.off -o /dev/full").exit_code, 3);
  EXPECT_EQ(run("detect dumbbell.off --prepared d.prepared").exit_code, 0);
}

} // namespace test_program_prepare
