// SPDX-License-Identifier: GPL-3.0-or-later

// Real meshes split along the constrictions that are selected, and along all.

#include "include/parts_check.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace test_split_real_meshes {

namespace SMC = CGAL::Surface_mesh_constrictions;
using parts_check::expect_parts;
using test_meshes::Mesh;

void expect_parts_of_file(const std::string& name, std::size_t number_of_parts)
{
  Mesh mesh = real_meshes::read(name);
  std::vector<SMC::Constriction<Mesh>> selected, all;
  SMC::detect_constrictions(mesh, std::back_inserter(selected), SMC::parameters::certify(false));
  SMC::detect_constrictions(mesh, std::back_inserter(all),
                            SMC::parameters::certify(false, SMC::parameters::all_constrictions(true)));
  Mesh copy = mesh;
  EXPECT_EQ(expect_parts(copy, selected).number_of_parts, number_of_parts);
  expect_parts(mesh, all);
}

TEST(Split_real_meshes, Cactus) { expect_parts_of_file("cactus.off", 4); }

// The loops through its two holes and the one around both: the front and the back, two pairs of pants.
TEST(Split_real_meshes, Eight) { expect_parts_of_file("eight.off", 2); }

} // namespace test_split_real_meshes
