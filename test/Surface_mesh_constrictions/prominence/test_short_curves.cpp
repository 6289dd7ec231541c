// SPDX-License-Identifier: GPL-3.0-or-later
// Curves so short that their length, or its square, is rounded to zero.
#include "include/exact_models.h"

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace test_short_curves {

namespace SMC = CGAL::Surface_mesh_constrictions;

TEST(ShortCurves, TheSearchForTheirProminencesEnds)
{
  for(double waist : {1e-150, 1e-170, 1e-310})
  {
    const auto square = exact_models::square();
    const auto mesh = test_meshes::make_mesh(exact_models::tube(
        {exact_models::ring(square, 3, 0), exact_models::ring(square, waist, 5), exact_models::ring(square, 3, 10)}));
    std::vector<SMC::Constriction<test_meshes::Mesh>> found;
    SMC::detect_constrictions(mesh, std::back_inserter(found), CGAL::parameters::all_constrictions(true));
    for(const auto& c : found)
      EXPECT_GE(c.prominence(), 0) << waist;
  }
}

} // namespace test_short_curves
