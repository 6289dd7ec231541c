// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/open_meshes.h"
#include "include/real_meshes.h"
#include "include/same_curves.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <type_traits>
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

// Many blocks, of which several are simplified at a time: the same collapses and the same refused ones, to the last bit.
TEST(Concurrency, BlocksAreSimplifiedInTheSameWayByAnyNumberOfThreads)
{
#ifdef CGAL_LINKED_WITH_TBB
  SMC::internal::Block_simplification blocks;
  blocks.whole_faces = 300;
  blocks.block_faces = blocks.rest_faces = 100;
  for(const test_meshes::Soup& soup :
      {test_meshes::chain_of_necks(0.05, 1, 120, 40),
       open_meshes::with_random_holes(test_meshes::relabelled(test_meshes::torus(0.1, 2, 60, 30), 2), 8, 2)})
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    const auto simplified = [&](const auto& tag) {
      SMC::internal::Imported_mesh<test_meshes::Mesh> imported(mesh, mesh.points(), get(boost::vertex_index, mesh));
      return SMC::internal::simplify<std::decay_t<decltype(tag)>>(imported, SMC::Garland_heckbert_policies(), true,
                                                                  false, blocks, SMC::Detection_visitor_base());
    };
    const SMC::Collapse_record expected = simplified(CGAL::Sequential_tag());
    EXPECT_GT(expected.collapses.size(), soup.points.size() / 2);
    for(std::size_t threads : {1, 2, 5})
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const SMC::Collapse_record record = simplified(CGAL::Parallel_tag());
      ASSERT_EQ(record.collapses.size(), expected.collapses.size());
      for(std::size_t i = 0; i < expected.collapses.size(); ++i)
      {
        EXPECT_EQ(record.collapses[i].removed, expected.collapses[i].removed);
        EXPECT_EQ(record.collapses[i].kept, expected.collapses[i].kept);
        EXPECT_EQ(record.collapses[i].point, expected.collapses[i].point);
      }
      ASSERT_EQ(record.refused_seeds.size(), expected.refused_seeds.size());
      for(std::size_t i = 0; i < expected.refused_seeds.size(); ++i)
      {
        EXPECT_EQ(record.refused_seeds[i].level, expected.refused_seeds[i].level);
        EXPECT_EQ(record.refused_seeds[i].vertices, expected.refused_seeds[i].vertices);
      }
    }
  }
#else
  GTEST_SKIP() << "oneTBB is not installed";
#endif
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
