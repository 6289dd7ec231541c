// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/split_tests.h"
#include "include/test_meshes.h"

#include <gtest/gtest.h>

namespace split_tests {

typedef test_meshes::Mesh Tested_surface_mesh;
INSTANTIATE_TYPED_TEST_SUITE_P(Surface_mesh, Split, Tested_surface_mesh, );

} // namespace split_tests
