// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Shortest_path_tree.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Loops of edges through one vertex of T^0, the root, one for each kind of geodesic loop at the root: the shortest
// paths to the two ends of an edge, and the edge. On smooth surfaces, geodesic loops at a point go through the local
// minima of the distance from it along its cut locus, which are the saddles of the distance.
//
// Process the surface from far to near. The processed part begins as a region around each tip and each hole. At a
// saddle two regions become one; the loop there encloses either of them. Its persistence is how much longer the loops
// of edges further out in the lesser region are, relative to this loop; errors of paths along edges make loops of small
// persistence. Once all regions are one, a loop that joins it to itself is not contractible. These loops are a greedy
// homotopy basis (Erickson and Whittlesey 2005), and all of them are taken.
//
// Returns at most `maximum_number` loops, paths of vertex ids from the root on, which is not repeated: first those that
// join a region to itself or separate two holes, the shortest first, then the others by persistence. A path may begin
// and end with the same edges. O(n log n).
inline std::vector<std::vector<Index>> loops_at_vertex(const Progressive_mesh& pm, Index root,
                                                       std::size_t maximum_number)
{
  const double infinity = (std::numeric_limits<double>::infinity)();
  struct Loop
  {
    Index halfedge;
    double length, persistence;
  };

  const Edge_graph graph(pm);
  Shortest_path_tree tree(graph);
  tree.grow(graph.number(root));
  std::vector<double> distance(pm.number_of_vertex_ids(), infinity);
  std::vector<Index> parent(pm.number_of_vertex_ids(), null_index);
  for(Index v = 0; v < graph.number_of_vertices(); ++v)
  {
    distance[graph.id(v)] = tree.distance(v);
    if(tree.parent(v) != null_index)
      parent[graph.id(v)] = graph.id(tree.parent(v));
  }

  std::vector<Loop> loops;
  for(Index h = 0; h < pm.number_of_halfedge_ids(); ++h)
  {
    const Index u = pm.source(h), v = pm.target(h);
    if(pm.edge(h) != h || distance[u] == infinity || distance[v] == infinity || parent[u] == v || parent[v] == u)
      continue;
    loops.push_back({h, distance[u] + norm(vector(pm.point(u), pm.point(v))) + distance[v], 0});
  }
  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) { return a.length > b.length; });

  // Regions, by the face that stands for each, or by the ghost vertex of a hole; and the length of the longest loop in
  // it, which is where it begins.
  std::vector<Index> region(pm.number_of_face_ids() + pm.number_of_vertex_ids());
  std::iota(region.begin(), region.end(), Index(0));
  std::vector<double> longest(region.size(), 0);
  std::fill(longest.begin() + static_cast<std::ptrdiff_t>(pm.number_of_face_ids()), longest.end(), infinity);
  const auto region_of = [&](Index h) {
    Index r = pm.face(h);
    if(pm.is_ghost_face(r))
      for(Index i = 0; i < 3; ++i, h = pm.next(h))
        if(pm.is_ghost_vertex(pm.source(h)))
          r = static_cast<Index>(pm.number_of_face_ids()) + pm.source(h);
    while(region[r] != r)
      r = region[r] = region[region[r]];
    return r;
  };
  for(Loop& l : loops)
  {
    Index a = region_of(l.halfedge), b = region_of(pm.opposite(l.halfedge));
    if(a == b)
    {
      l.persistence = infinity;
      continue;
    }
    if(longest[a] < longest[b])
      std::swap(a, b);
    longest[a] = (std::max)(longest[a], l.length);
    l.persistence = (std::max)(longest[b], l.length) / l.length - 1;
    region[b] = a;
  }

  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return a.persistence != b.persistence ? a.persistence > b.persistence : a.length < b.length;
  });
  if(loops.size() > maximum_number)
    loops.resize(maximum_number);
  std::vector<std::vector<Index>> result;
  for(const Loop& l : loops)
  {
    std::vector<Index> path;
    for(Index v = pm.source(l.halfedge); v != null_index; v = parent[v])
      path.push_back(v);
    std::reverse(path.begin(), path.end());
    for(Index v = pm.target(l.halfedge); v != root; v = parent[v])
      path.push_back(v);
    result.push_back(std::move(path));
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_LOOPS_AT_VERTEX_H
