// SPDX-License-Identifier: GPL-3.0-or-later

// What test_parameters.cpp tests, with the package's header after CGAL's.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include "include/chained_parameters.h"

namespace parameters_after_cgal {

void expect_any_order();

void expect_any_order() { chained_parameters::expect_any_order(); }

} // namespace parameters_after_cgal
