// SPDX-License-Identifier: GPL-3.0-or-later
// Whichever allocation fails, std::bad_alloc reaches the caller, nothing is lost, and the mesh is as it was.
#include "include/exact_models.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <new>
#include <vector>

namespace test_allocation_failures {

// Of this thread: the allocations that are still to succeed; none fails if it is negative.
thread_local long left = -1;
thread_local long allocations = 0, alive = 0;

inline void* allocate(std::size_t size)
{
  if(left >= 0 && left-- == 0)
    throw std::bad_alloc();
  void* const result = std::malloc(size == 0 ? 1 : size);
  if(result == nullptr)
    throw std::bad_alloc();
  ++allocations;
  ++alive;
  return result;
}

inline void release(void* p) noexcept
{
  alive -= p != nullptr;
  std::free(p);
}

} // namespace test_allocation_failures

void* operator new(std::size_t size) { return test_allocation_failures::allocate(size); }
void operator delete(void* p) noexcept { test_allocation_failures::release(p); }
void operator delete(void* p, std::size_t) noexcept { test_allocation_failures::release(p); }

namespace test_allocation_failures {

using namespace CGAL::Surface_mesh_constrictions;
using test_meshes::Mesh;

// Calls a function again and again, and lets another allocation fail each time; of very many only some. is_unchanged()
// tells whether nothing has happened.
template <class Function, class IsUnchanged>
void fail_allocations(const Function& function, const IsUnchanged& is_unchanged)
{
  function(); // what is allocated once and for all
  const long before = allocations;
  function();
  const long n = allocations - before;
  ASSERT_GT(n, 0);
  const long step = std::getenv("CONSTRICTIONS_ALL_FAULTS") != nullptr ? 1 : (std::max)(1L, n / 40);
  long failed = 0, tried = 0;
  for(long i = 0; i < n; i += step, ++tried)
  {
    const long alive_before = alive;
    bool has_thrown = false;
    left = i;
    try
    {
      function();
    }
    catch(const std::bad_alloc&)
    {
      has_thrown = true;
    }
    left = -1;
    failed += has_thrown;
    ASSERT_EQ(alive, alive_before) << "allocation " << i << " of " << n;
    ASSERT_TRUE(!has_thrown || is_unchanged()) << "allocation " << i << " of " << n;
  }
  // std::stable_sort() does with less
  EXPECT_GT(failed, tried / 2);
}

bool are_equal(const Mesh& a, const Mesh& b)
{
  return a.number_of_faces() == b.number_of_faces() && a.number_of_vertices() == b.number_of_vertices() &&
         std::equal(vertices(a).begin(), vertices(a).end(), vertices(b).begin(), vertices(b).end(),
                    [&](Mesh::Vertex_index v, Mesh::Vertex_index w) { return a.point(v) == b.point(w); });
}

class AllocationFailures : public testing::Test
{
protected:
  const exact_models::Soup soup = test_meshes::boxes_with_tube(2);
  const Mesh mesh = test_meshes::make_mesh(soup), copy = mesh;
  std::vector<Constriction<Mesh>> curves;

  AllocationFailures() { detect_constrictions(mesh, std::back_inserter(curves)); }
};

TEST_F(AllocationFailures, WhileConstrictionsAreDetected)
{
  ASSERT_EQ(curves.size(), 1u);
  fail_allocations(
      [&] {
        std::vector<Constriction<Mesh>> found;
        detect_constrictions(mesh, std::back_inserter(found), CGAL::parameters::all_constrictions(true));
      },
      [&] { return are_equal(mesh, copy); });
}

TEST_F(AllocationFailures, WhileACurveIsCertifiedOrTightened)
{
  const auto is_unchanged = [&] { return are_equal(mesh, copy); };
  fail_allocations([&] { certify_constriction(mesh, curves.front()); }, is_unchanged);
  std::vector<Mesh::Vertex_index> loop;
  for(std::size_t v :
      exact_models::vertices_at(soup, {{{3, 1, 1}}, {{2, 1, 1}}, {{2, 2, 1}}, {{3, 2, 1}}, {{3, 2, 2}}, {{3, 1, 2}}}))
    loop.push_back(Mesh::Vertex_index(static_cast<std::uint32_t>(v)));
  fail_allocations([&] { tighten_closed_curve(mesh, loop); }, is_unchanged);
}

TEST_F(AllocationFailures, WhileASurfaceIsSegmented)
{
  std::vector<std::size_t> part(mesh.number_of_faces());
  fail_allocations([&] { segment_by_constrictions(mesh, curves, CGAL::make_property_map(part)); },
                   [&] { return are_equal(mesh, copy); });
}

} // namespace test_allocation_failures
