// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/same_curves.h"

#include <CGAL/Polyhedron_3.h>

namespace test_generic_polyhedron {

TEST(Generic, PolyhedronGivesTheSameCurves)
{
  same_curves::expect_same_curves<CGAL::Polyhedron_3<test_meshes::Kernel>>();
}

} // namespace test_generic_polyhedron
