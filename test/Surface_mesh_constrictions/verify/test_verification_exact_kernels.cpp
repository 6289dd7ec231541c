// SPDX-License-Identifier: GPL-3.0-or-later

// The verification with kernels of exact number types. Exact square roots are within reach for patches of a few faces
// only: strips of two faces, and stars of six in which no two ways are equally long.

#include "include/detect.h"
#include "include/displaced_curves.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#ifdef CGAL_USE_CORE
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

#include <gtest/gtest.h>

#include <vector>

namespace test_verification_exact_kernels {

namespace SMC = CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;
typedef SMC::Constriction<Mesh> Constriction;
typedef displaced_curves::Displacements<Mesh> Displacements;

std::vector<Constriction> detect(const Mesh& mesh)
{
  const std::vector<Constriction> curves = detection::detect_all_from_triangles(mesh);
  EXPECT_FALSE(curves.empty());
  return curves;
}

template <class Kernel>
bool is_confirmed(const Mesh& mesh, const Constriction& c, std::size_t faces)
{
  return SMC::verify_with_shortest_paths<Kernel>(mesh, c, CGAL::parameters::maximum_number(faces)).is_confirmed();
}

TEST(Verification_exact_constructions, ConfirmsGeodesicsAndRefusesDisplacedOnes)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
  for(const test_meshes::Soup& soup :
      {test_meshes::boxes_with_tube(2), test_meshes::square_ring(), test_meshes::dumbbell(0.1, 4)})
  {
    const Mesh mesh = test_meshes::make_mesh(soup);
    for(const Constriction& c : detect(mesh))
    {
      EXPECT_TRUE(is_confirmed<Kernel>(mesh, c, 2));
      EXPECT_TRUE(is_confirmed<Kernel>(mesh, c, 8));
      const Displacements displacements(mesh, c, 3);
      for(const Constriction& d : displacements.through_neighbours())
        EXPECT_FALSE(is_confirmed<Kernel>(mesh, d, 8));
      for(const Constriction& d : displacements.around_pivots(0.1))
        EXPECT_FALSE(is_confirmed<Kernel>(mesh, d, 8));
      for(const Constriction& d : displacements.with_moved_crossings(0.1))
        EXPECT_FALSE(is_confirmed<Kernel>(mesh, d, 8));
    }
  }
}

#ifdef CGAL_USE_CORE
TEST(Verification_exact_square_roots, ConfirmsAGeodesicOverStarsAndStripsOfTwoFaces)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 4));
  for(const Constriction& c : detect(mesh))
    EXPECT_TRUE(is_confirmed<Kernel>(mesh, c, 2));
}

TEST(Verification_exact_square_roots, RefusesAGeodesicLedAroundAVertex)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
  const Mesh mesh = test_meshes::make_mesh(test_meshes::dumbbell(0.1, 4, 8, 5));
  for(const Constriction& c : detect(mesh))
    for(const Constriction& d : Displacements(mesh, c, 5).around_pivots(0.37))
      EXPECT_FALSE(is_confirmed<Kernel>(mesh, d, 2));
}
#endif

} // namespace test_verification_exact_kernels
