// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CHOOSE_HANDLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CHOOSE_HANDLES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Homology_basis.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Which handles are removed.
struct Handle_limits
{
  std::size_t maximum_number = (std::numeric_limits<std::size_t>::max)();
  double maximum_length = std::numeric_limits<double>::infinity();
  std::optional<Side> side;
};

// Whether a curve passes a vertex that it, or another one, has passed, or one on a hole.
template <class TriangleMesh>
bool touches(const TriangleMesh& tm, const Constriction<TriangleMesh>& curve,
             std::unordered_set<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> passed)
{
  for(const auto& l : curve.locations())
  {
    if(!l.is_pivot)
      continue;
    if(!passed.insert(l.vertex).second)
      return true;
    for(auto h : halfedges_around_target(halfedge(l.vertex, tm), tm))
      if(face(h, tm) == boost::graph_traits<TriangleMesh>::null_face())
        return true;
  }
  return false;
}

// The places of the curves to cut along, by length, so that the surface stays connected: a curve is left out if its
// class is the sum of those of curves before it, and if it crosses or touches one of them, itself, or a hole.
// O(n (g^2 + l)) for n curves, genus g and l pivots of chosen curves, plus the cost of `Curve_arrangement::insert()`.
template <class TriangleMesh>
std::vector<std::size_t> choose_handles(const TriangleMesh& tm, const std::vector<Constriction<TriangleMesh>>& curves,
                                        const Handle_limits& limits)
{
  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < curves.size(); ++i)
    if(!curves[i].is_separating() && curves[i].length() <= limits.maximum_length &&
       (!limits.side || curves[i].side() == *limits.side))
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return curves[i].length() < curves[j].length(); });

  std::vector<std::size_t> result;
  Homology_basis basis;
  Curve_arrangement<TriangleMesh> arrangement(tm);
  std::unordered_set<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> passed;
  for(std::size_t i : order)
  {
    if(result.size() == limits.maximum_number)
      break;
    Homology_basis::Reduced reduced = basis.reduce(curves[i].homology_class());
    if(reduced.is_sum() || touches(tm, curves[i], passed) || arrangement.insert(curves[i], i))
      continue;
    basis.add(std::move(reduced), i);
    for(const auto& l : curves[i].locations())
      if(l.is_pivot)
        passed.insert(l.vertex);
    result.push_back(i);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CHOOSE_HANDLES_H
