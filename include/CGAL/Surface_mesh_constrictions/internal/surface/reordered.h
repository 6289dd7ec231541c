// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REORDERED_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REORDERED_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The first `number` elements of a sequence of constrictions in another order. Places of constrictions in the sequence
// are translated; for one that is left out stands the first one that is not, on the way along dominated_by(), or else
// the vertex where that ends. The areas swept on that way add up.
template <class TriangleMesh>
std::vector<Constriction<TriangleMesh>> reordered(const std::vector<Constriction<TriangleMesh>>& given,
                                                  const std::vector<std::size_t>& order, std::size_t number)
{
  number = (std::min)(number, order.size());
  std::vector<std::optional<std::size_t>> place(given.size());
  for(std::size_t i = 0; i < number; ++i)
    place[order[i]] = i;
  const auto translate = [&place](std::vector<std::size_t>& numbers) {
    std::vector<std::size_t> result;
    for(std::size_t j : numbers)
      if(place[j])
        result.push_back(*place[j]);
    numbers.swap(result);
  };

  std::vector<Constriction<TriangleMesh>> result;
  for(std::size_t i = 0; i < number; ++i)
  {
    typename Constriction<TriangleMesh>::Data data = given[order[i]].data();
    while(data.dominated_by && !place[*data.dominated_by])
    {
      const Constriction<TriangleMesh>& next = given[*data.dominated_by];
      data.isolation += next.isolation() * std::pow(next.length() / data.length, 2);
      data.slides_off = next.slides_off();
      data.dominated_by = next.dominated_by();
    }
    if(data.dominated_by)
      data.dominated_by = place[*data.dominated_by];
    translate(data.crosses);
    translate(data.crosses_oddly);
    translate(data.rivals);
    result.push_back(Constriction<TriangleMesh>(std::move(data)));
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_REORDERED_H
