// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the non-face triangles of the current surface: three edges that bound no face, each once (Section 4.1 of the
/// paper).
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \cost linear in the sum of squared vertex degrees
template <class OutputIterator>
OutputIterator non_face_triangles(const Progressive_mesh& pm, OutputIterator out)
{
  const auto level = pm.level();
  for(Index u = 0; u < pm.number_of_vertex_ids(); ++u)
  {
    if(!pm.is_vertex(u))
      continue;
    // u < v < w: u v is an edge, w a neighbour of v that is also one of u
    const Index begin = pm.outgoing(u);
    Index uv = begin;
    do {
      const Index v = pm.target(uv);
      if(u < v)
      {
        const Index left = pm.target(pm.next(uv)), right = pm.target(pm.next(pm.opposite(uv)));
        const Index vbegin = pm.outgoing(v);
        Index vw = vbegin;
        do {
          const Index w = pm.target(vw);
          if(v < w && w != left && w != right && pm.halfedge(u, w) != null_index)
            *out++ = Seed_curve{level, {u, v, w}, Seed_origin::NON_FACE_TRIANGLE};
          vw = pm.ccw(vw);
        } while(vw != vbegin);
      }
      uv = pm.ccw(uv);
    } while(uv != begin);
  }
  return out;
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the non-face triangles at the merged vertex that the collapse of `removed` into `kept` is about to make, but
/// for those that are there already as triangles of `kept`.
///
/// \param pm the surface before the collapse; unchanged
/// \param out an output iterator that takes `Seed_curve`, with the level after the collapse
/// \cost quadratic in the vertex degree
template <class OutputIterator>
OutputIterator non_face_triangles_of_collapse(const Progressive_mesh& pm, Index removed, Index kept, OutputIterator out)
{
  typedef boost::container::small_vector<Index, 16> Indices;
  const auto contains = [](const Indices& v, Index i) { return std::find(v.begin(), v.end(), i) != v.end(); };

  // The two vertices have two neighbours in common, the apexes of the faces at their edge (the link condition).
  const Index edge = pm.halfedge(removed, kept), back = pm.opposite(edge);
  Indices of_removed, of_kept; // other neighbours, counterclockwise
  for(Index h = pm.ccw(edge); h != edge; h = pm.ccw(h))
    of_removed.push_back(pm.target(h));
  for(Index h = pm.ccw(back); h != back; h = pm.ccw(h))
    of_kept.push_back(pm.target(h));

  for(std::size_t i = 1; i + 1 < of_removed.size(); ++i)
  {
    const Index x = of_removed[i], before = of_removed[i - 1], after = of_removed[i + 1];
    const Index begin = pm.outgoing(x);
    Index xy = begin;
    do {
      const Index y = pm.target(xy);
      // two neighbours of `removed` only see each other twice
      const bool seen_from_y = y < x && y != of_removed.front() && y != of_removed.back();
      if(y != removed && y != before && y != after &&
         (contains(of_kept, y) || (contains(of_removed, y) && !seen_from_y)))
        *out++ = Seed_curve{pm.level() + 1, {kept, x, y}, Seed_origin::NON_FACE_TRIANGLE};
      xy = pm.ccw(xy);
    } while(xy != begin);
  }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H
