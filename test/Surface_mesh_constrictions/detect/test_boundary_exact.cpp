// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/same_curves.h"
#include "include/test_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_boundary_exact {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> Exact_mesh;
typedef CGAL::Polyhedron_3<test_meshes::Kernel> Polyhedron;

// On another type of graph, and with exact points, the curves of a surface with boundary are the same.
TEST(Boundary, NeitherTheKindOfPointsNorOfTheMeshMatters)
{
  const test_meshes::Soup soup =
      open_meshes::without_face(open_meshes::without_face(test_meshes::torus(0.1, 3), 40), 99);
  const auto expected = same_curves::detect(test_meshes::make_mesh(soup), CGAL::parameters::default_values());
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(same_curves::detect(test_meshes::make_graph<Exact_mesh>(soup), CGAL::parameters::default_values()),
            expected);
  EXPECT_EQ(same_curves::detect(test_meshes::make_graph<Polyhedron>(soup), CGAL::parameters::default_values()),
            expected);
}

} // namespace test_boundary_exact
