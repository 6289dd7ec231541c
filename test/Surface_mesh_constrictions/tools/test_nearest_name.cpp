// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test_nearest_name {

using constrictions::nearest_name;

TEST(Nearest_name, takes_the_fewest_changes)
{
  const std::vector<std::string> names = {"detect", "tighten", "certify", "segment", "batch", "view", "check"};
  EXPECT_EQ(nearest_name("detekt", names), "detect");
  EXPECT_EQ(nearest_name("dtect", names), "detect");
  EXPECT_EQ(nearest_name("detcet", names), "detect");
  EXPECT_EQ(nearest_name("cehck", names), "check");
  EXPECT_EQ(nearest_name("segmnet", names), "segment");
  EXPECT_EQ(nearest_name("veiw", names), "view");
  EXPECT_EQ(nearest_name("tight", names), "tighten"); // its beginning
  EXPECT_EQ(nearest_name("refine", names), "");
  EXPECT_EQ(nearest_name("bone.ply", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), names), "");
  EXPECT_EQ(nearest_name("detect", {}), "");
}

TEST(Nearest_name, dashes_do_not_count)
{
  const std::vector<std::string> names = {"-o", "-h", "--json", "--min-length", "--min-prominence", "--polylines"};
  EXPECT_EQ(nearest_name("-json", names), "--json");
  EXPECT_EQ(nearest_name("--jsno", names), "--json");
  EXPECT_EQ(nearest_name("--poly", names), "--polylines");
  EXPECT_EQ(nearest_name("--min", names), ""); // which one?
  EXPECT_EQ(nearest_name("--minprominence", names), "--min-prominence");
  EXPECT_EQ(nearest_name("-x", names), "");
  EXPECT_EQ(nearest_name("--", names), "");
}

} // namespace test_nearest_name
