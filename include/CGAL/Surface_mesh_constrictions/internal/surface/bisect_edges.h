// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_BISECT_EDGES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_BISECT_EDGES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The same surface with more vertices, closed by ghosts if it has a boundary. Vertices keep their numbers.
struct Bisected_surface
{
  Corner_table table;
  std::vector<Point> points;
  std::vector<Index> old; // the halfedge that a halfedge is a piece of; null_index if it lies in a face
};

// Bisects edges of T^0, always the longest one, until there are so many vertices: paths along edges are about as short
// as paths on the surface then. Of a surface that has as many, nothing is changed. O(n log n).
inline Bisected_surface bisect_edges(const Progressive_mesh& pm, std::size_t vertices)
{
  Bisected_surface result;
  std::vector<Index> source, opposite;
  for(Index h = 0; h < pm.number_of_halfedge_ids() && !pm.is_ghost_face(pm.face(h)); ++h)
  {
    source.push_back(pm.source(h));
    opposite.push_back(pm.is_ghost_face(pm.face(pm.opposite(h))) ? null_index : pm.opposite(h));
    result.old.push_back(h);
  }
  for(Index v = 0; v < pm.number_of_vertex_ids() && !pm.is_ghost_vertex(v); ++v)
    result.points.push_back(pm.point(v));

  typedef std::pair<double, Index> Entry; // length and halfedge, those with the smaller number first
  const auto entry = [&](Index h) {
    return Entry(norm(vector(result.points[source[h]], result.points[source[Corner_table::next(h)]])), null_index - h);
  };
  std::priority_queue<Entry> queue;
  for(Index h = 0; h < source.size(); ++h)
    if(opposite[h] == null_index || h < opposite[h])
      queue.push(entry(h));

  // Puts w between the ends of h. A second face is added, behind w. Returns the halfedge from w on.
  const auto split_side = [&](Index h, Index w) {
    const Index n = Corner_table::next(h), added = static_cast<Index>(source.size());
    source.insert(source.end(), {w, source[n], source[Corner_table::prev(h)]});
    opposite.insert(opposite.end(), {null_index, opposite[n], n});
    result.old.insert(result.old.end(), {result.old[h], result.old[n], null_index});
    if(opposite[n] != null_index)
      opposite[opposite[n]] = added + 1;
    source[n] = w;
    opposite[n] = added + 2;
    result.old[n] = null_index;
    return added;
  };
  std::size_t n = pm.number_of_vertices();
  while(n < vertices)
  {
    const Entry longest = queue.top();
    queue.pop();
    const Index h = null_index - longest.second, o = opposite[h];
    if(entry(h).first != longest.first)
      continue; // the number means another edge by now
    const Point a = result.points[source[h]], b = result.points[source[Corner_table::next(h)]];
    const Point middle(a.x() + (b.x() - a.x()) / 2, a.y() + (b.y() - a.y()) / 2, a.z() + (b.z() - a.z()) / 2);
    if(middle == a || middle == b)
      break; // no longer told apart
    const Index w = static_cast<Index>(result.points.size());
    result.points.push_back(middle);
    ++n;
    const Index ahead = split_side(h, w);
    for(Index changed : {h, ahead, ahead + 1, ahead + 2})
      queue.push(entry(changed));
    if(o == null_index)
      continue;
    const Index behind = split_side(o, w);
    opposite[h] = behind;
    opposite[behind] = h;
    opposite[ahead] = o;
    opposite[o] = ahead;
    for(Index changed : {behind + 1, behind + 2})
      queue.push(entry(changed));
  }
  result.table = make_corner_table(result.points.size(), source, true);
  if(has_border(result.table))
    close_by_ghosts(result.table, result.points);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_BISECT_EDGES_H
