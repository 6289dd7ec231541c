// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/split_tests.h"
#include "include/test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace split_tests {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Tested_exact;
INSTANTIATE_TYPED_TEST_SUITE_P(Exact_surface_mesh, Split, Tested_exact, );

} // namespace split_tests
