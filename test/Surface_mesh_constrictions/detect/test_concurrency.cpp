// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/real_meshes.h"
#include "include/same_curves.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
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
  expect_same_with_threads(real_meshes::read("elephant.off"), 300, SMC::parameters::all_constrictions(true));
}

TEST(Concurrency, AVisitorIsCalledByOneThreadAtATimeAndItsStepsGrow)
{
  struct Visitor : public SMC::Detection_visitor_base
  {
    struct Record
    {
      std::size_t steps = 0, last = 0;
      bool is_sorted = true;
      std::atomic<int> inside = 0;
      std::atomic<bool> is_alone = true;
    };
    Record* record;

    void on_stage_begin(SMC::Detection_stage, std::size_t) const { record->last = 0; }
    void on_step(SMC::Detection_stage, std::size_t done) const
    {
      if(++record->inside > 1)
        record->is_alone = false;
      ++record->steps;
      record->is_sorted = record->is_sorted && record->last <= done;
      record->last = done;
      --record->inside;
    }
  };
  Visitor::Record record;
  Visitor visitor;
  visitor.record = &record;
  const test_meshes::Mesh mesh = test_meshes::make_mesh(test_meshes::chain_of_necks(0.002, 1, 400, 90));
  same_curves::detect<CGAL::Parallel_if_available_tag>(mesh, CGAL::parameters::visitor(visitor));
  EXPECT_GT(record.steps, 0u);
  EXPECT_TRUE(record.is_sorted);
  EXPECT_TRUE(record.is_alone);
}

} // namespace test_concurrency
