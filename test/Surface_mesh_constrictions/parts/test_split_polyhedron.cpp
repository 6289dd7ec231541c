// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/split_tests.h"
#include "include/test_meshes.h"

#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

namespace split_tests {

typedef CGAL::Polyhedron_3<test_meshes::Kernel> Tested_polyhedron;
INSTANTIATE_TYPED_TEST_SUITE_P(Polyhedron, Split, Tested_polyhedron, );

} // namespace split_tests
