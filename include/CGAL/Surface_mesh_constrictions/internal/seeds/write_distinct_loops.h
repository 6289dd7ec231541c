// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_WRITE_DISTINCT_LOOPS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_WRITE_DISTINCT_LOOPS_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>

#include <CGAL/for_each.h>

#include <boost/container_hash/hash.hpp>

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Writes the loops that items give, from the first item to the last, each once, as seeds. One thread works on some
// consecutive items with a finder of its own: make_finder()(i, write) calls write(loop), a canonical closed path of
// vertex ids, for each loop of item i.
template <class ConcurrencyTag, class MakeFinder, class OutputIterator>
OutputIterator write_distinct_loops(std::size_t items, std::size_t items_of_group, const MakeFinder& make_finder,
                                    std::size_t level, Seed_origin origin, OutputIterator out)
{
  typedef std::vector<Index> Loop;
  auto groups = make_groups<std::vector<Loop>>(items, items_of_group);
  CGAL::for_each<ConcurrencyTag>(groups, [&](Group<std::vector<Loop>>& group) {
    auto find = make_finder();
    for(std::size_t i = group.begin; i < group.end; ++i)
      find(i, [&group](Loop loop) { group.result.push_back(std::move(loop)); });
    return true;
  });
  std::unordered_set<Loop, boost::hash<Loop>> known;
  for(Group<std::vector<Loop>>& group : groups)
    for(Loop& loop : group.result)
    {
      const auto [it, is_new] = known.insert(std::move(loop));
      if(is_new)
        *out++ = Seed_curve{level, *it, origin};
    }
  return out;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_WRITE_DISTINCT_LOOPS_H
