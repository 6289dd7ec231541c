// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/program_fixture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace test_program_lengths {

using nlohmann::json;
using program_fixture::Program;
using program_fixture::Result;

class Lengths : public Program
{
protected:
  std::vector<double> lengths(const std::string& arguments) const
  {
    const Result r = run("detect " + arguments + " --no-certify --json -");
    EXPECT_EQ(r.exit_code, 0) << r.err;
    const json found = json::parse(r.out);
    std::vector<double> result;
    for(const json& c : found.at("constrictions"))
      result.push_back(c.at("length"));
    return result;
  }
};

const std::string cactus = "'" CONSTRICTIONS_MESH_DIR "/cactus.off'"; // 0.599, 0.284, 0.291

TEST_F(Lengths, within_bounds)
{
  const std::vector<double> all = lengths(cactus);
  ASSERT_EQ(all.size(), 3u);
  typedef std::vector<double> Doubles;
  EXPECT_EQ(lengths(cactus + " --min-length 0.3"), (Doubles{all[0]}));
  EXPECT_EQ(lengths(cactus + " --max-length 0.3"), (Doubles{all[1], all[2]}));
  EXPECT_EQ(lengths(cactus + " --max-length 0.3 --max 1"), (Doubles{all[1]})); // --max counts those within the bounds
  EXPECT_EQ(lengths(cactus + " --min-length 0.2840 --max-length 0.3"), (Doubles{all[2]}));
  EXPECT_EQ(lengths(cactus + " --min-length 1"), Doubles());
  EXPECT_EQ(lengths(cactus + " --min-length 0 --max-length 1e300"), all);

  for(const double length : lengths(cactus + " --all --min-length 0.3 --max-length 0.6"))
  {
    EXPECT_GE(length, 0.3);
    EXPECT_LE(length, 0.6);
  }
  const std::size_t below = lengths(cactus + " --all --max-length 0.3").size(),
                    above = lengths(cactus + " --all --min-length 0.3").size();
  EXPECT_GT(below, 2u);
  EXPECT_EQ(below + above, lengths(cactus + " --all").size());
}

TEST_F(Lengths, near_a_location_the_nearest_within_bounds)
{
  const std::string near = cactus + " --near 0,0,0";
  std::vector<double> longer;
  const std::vector<double> all = lengths(near);
  std::copy_if(all.begin(), all.end(), std::back_inserter(longer), [](double length) { return length >= 0.4; });
  ASSERT_GT(longer.size(), 1u);
  ASSERT_LT(longer.size(), all.size());
  EXPECT_EQ(lengths(near + " --min-length 0.4"), longer);
  EXPECT_EQ(lengths(near + " --min-length 0.4 --max 1"), (std::vector<double>{longer[0]}));
}

TEST_F(Lengths, parts_are_cut_along_curves_within_bounds)
{
  EXPECT_EQ(run("segment " + cactus + " --max-length 0.3 -o parts").exit_code, 0);
  EXPECT_EQ(json::parse(content("parts/parts.json")).at("parts").size(), 3u);
}

TEST_F(Lengths, of_many_meshes_are_kept_with_the_results)
{
  ASSERT_EQ(run("batch dumbbell.off -o out --max-length 3 --quiet").exit_code, 0);
  EXPECT_TRUE(json::parse(content("out/results.jsonl")).at("constrictions").empty());
  expect_failure(1, "batch dumbbell.off -o out --max-length 5 --quiet", {"max-length was 3.0, not 5.0"});
}

TEST_F(Lengths, wrong_usage)
{
  for(const char* bounds :
      {"--min-length -1", "--max-length nan", "--min-length long", "--max-length", "--min-length 2 --max-length 1"})
    expect_wrong_usage(std::string("detect dumbbell.off ") + bounds);
  EXPECT_EQ(run("detect dumbbell.off --min-length 2 --max-length 1.5").err,
            "constrictions: --min-length: is greater than --max-length: no curve can be as long as that; see "
            "constrictions detect --help\n");
}

} // namespace test_program_lengths
