// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

namespace test_imported_mesh {

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
typedef CGAL::Surface_mesh<Exact_kernel::Point_3> Exact_mesh;

// A coordinate of which a lazy number knows six digits until it is asked for all.
TEST(Imported_mesh, LazyPointsAreComputedBeforeTheyAreRounded)
{
  typedef Exact_kernel::FT FT;
  const FT large(1e10), third = large + FT(1) / FT(3) - large;
  Exact_mesh mesh;
  CGAL::make_tetrahedron(Exact_kernel::Point_3(third, 0, 0), Exact_kernel::Point_3(0, 1, 0),
                         Exact_kernel::Point_3(0, 0, 1), Exact_kernel::Point_3(0, 0, 0), mesh);
  const SMC::internal::Imported_mesh<Exact_mesh> imported(mesh, mesh.points(), get(boost::vertex_index, mesh));
  EXPECT_EQ(imported.points[0].x(), 1 / 3.);
}

} // namespace test_imported_mesh
