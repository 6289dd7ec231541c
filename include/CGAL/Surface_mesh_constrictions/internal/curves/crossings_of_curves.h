// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CROSSINGS_OF_CURVES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CROSSINGS_OF_CURVES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

typedef std::vector<std::vector<Index>> Earlier_curves; // for each of some curves, some of those before it

// For each of some closed geodesics those before it that it crosses an odd number of times. One is moved a little to
// its left, the other one to the vertices next to it: that does not change the number modulo 2.
// Linear in the size of the mesh, plus, for each pair, in the length of one of the two.
inline Earlier_curves odd_crossings(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point>>& traces)
{
  std::vector<std::vector<Index>> edges; // of the path beside each curve
  for(const std::vector<Trace_point>& t : traces)
  {
    edges.emplace_back();
    const std::vector<Index> path = vertices_passed(pm, t);
    for(std::size_t i = 0; i < path.size(); ++i)
    {
      const Index u = path[i], v = path[(i + 1) % path.size()];
      if(u != v)
        edges.back().push_back(pm.edge(pm.halfedge(u, v)));
    }
  }
  Earlier_curves result(traces.size());
  std::vector<bool> is_crossed(pm.number_of_halfedge_ids(), false); // an odd number of times, by edge
  for(std::size_t i = 0; i < traces.size(); ++i)
  {
    const std::vector<Index> crossings = crossings_beside_pivots(pm, traces[i]);
    for(Index h : crossings)
      is_crossed[pm.edge(h)] = !is_crossed[pm.edge(h)];
    for(std::size_t j = 0; j < i; ++j)
    {
      bool is_odd = false;
      for(Index e : edges[j])
        is_odd = is_odd != is_crossed[e];
      if(is_odd)
        result[i].push_back(static_cast<Index>(j));
    }
    for(Index h : crossings)
      is_crossed[pm.edge(h)] = false;
  }
  return result;
}

// For each of some closed geodesics those before it that it crosses inside a face.
// O(n log n) for n points, plus the squared number of strands in each face.
inline Earlier_curves crossings_in_faces(const Progressive_mesh& pm,
                                         const std::vector<std::vector<Trace_point>>& traces)
{
  std::vector<std::pair<Strand, Index>> all;
  for(Index i = 0; i < traces.size(); ++i)
    for(const Strand& s : strands(pm, traces[i]))
      all.emplace_back(s, i);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first.face < b.first.face; });
  Earlier_curves result(traces.size());
  for(std::size_t i = 0; i < all.size(); ++i)
    for(std::size_t j = i + 1; j < all.size() && all[j].first.face == all[i].first.face; ++j)
      if(all[i].second != all[j].second && alternate(all[i].first, all[j].first))
        result[(std::max)(all[i].second, all[j].second)].push_back((std::min)(all[i].second, all[j].second));
  for(std::vector<Index>& r : result)
  {
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CROSSINGS_OF_CURVES_H
