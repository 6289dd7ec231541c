// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/same_curves.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test_concurrency {

namespace SMC = CGAL::Surface_mesh_constrictions;

// Expects the curves of one thread from several.
template <class NamedParameters>
void expect_same_with_threads(const test_meshes::Mesh& mesh, std::size_t at_least, const NamedParameters& np)
{
#ifdef CGAL_LINKED_WITH_TBB
  const std::vector<same_curves::Summary> expected = same_curves::detect<CGAL::Sequential_tag>(mesh, np);
  EXPECT_GE(expected.size(), at_least);
  for(std::size_t threads : {1, 2, 5})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(same_curves::detect<CGAL::Parallel_tag>(mesh, np) == expected) << threads << " threads";
  }
#else
  (void)mesh;
  (void)at_least;
  (void)np;
  GTEST_SKIP() << "oneTBB is not installed";
#endif
}

TEST(Concurrency, ALargeMeshGivesTheSameWithAnyNumberOfThreads)
{
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.002, 1, 400, 90));
  ASSERT_GT(mesh.number_of_faces(), 65536u);
  expect_same_with_threads(mesh, 4, CGAL::parameters::default_values());
}

TEST(Concurrency, ManyCurvesAreTheSameWithAnyNumberOfThreads)
{
  test_meshes::Mesh mesh;
  ASSERT_TRUE(CGAL::IO::read_polygon_mesh(std::string(CONSTRICTIONS_MESH_DIR) + "/elephant.off", mesh));
  expect_same_with_threads(mesh, 300, SMC::parameters::all_constrictions(true));
}

TEST(Concurrency, AVisitorIsCalledByOneThreadAtATimeAndItsStepsGrow)
{
  struct Visitor
    : public SMC::Detection_visitor_base
  {
    std::size_t* last;
    bool* is_sorted;

    void on_stage_begin(SMC::Detection_stage, std::size_t) const { *last = 0; }
    void on_step(SMC::Detection_stage, std::size_t done) const
    {
      *is_sorted = *is_sorted && *last <= done;
      *last = done;
    }
  };
  std::size_t last = 0;
  bool is_sorted = true;
  Visitor visitor;
  visitor.last = &last;
  visitor.is_sorted = &is_sorted;
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.002, 1, 400, 90));
  same_curves::detect<CGAL::Parallel_if_available_tag>(mesh, CGAL::parameters::visitor(visitor));
  EXPECT_TRUE(is_sorted);
}

} // namespace test_concurrency
