// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the non-face triangles of the current surface: three edges that bound no face, each once (Section 4.1 of the
/// paper). The boundary of a hole of three edges is one.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \return the output iterator, past the last element that was written
/// \cost linear in the sum of squared vertex degrees
template <class OutputIterator>
OutputIterator non_face_triangles(const Progressive_mesh& pm, OutputIterator out)
{
  const auto level = pm.level();
  for(Index u = 0; u < pm.number_of_vertex_ids(); ++u)
  {
    if(!pm.is_vertex(u) || pm.is_ghost_vertex(u))
      continue;
    // u < v < w: u v is an edge, w a neighbour of v that is also one of u
    const Index begin = pm.outgoing(u);
    Index uv = begin;
    do
    {
      const Index v = pm.target(uv);
      if(u < v && !pm.is_ghost_vertex(v))
      {
        const Index left = pm.target(pm.next(uv)), right = pm.target(pm.next(pm.opposite(uv)));
        const Index vbegin = pm.outgoing(v);
        Index vw = vbegin;
        do
        {
          const Index w = pm.target(vw);
          if(v < w && !pm.is_ghost_vertex(w) && w != left && w != right && pm.halfedge(u, w) != null_index)
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
/// writes the non-face triangles at a vertex, as at the one that a collapse has merged (Section 4.1 of the paper).
///
/// \param pm the surface; unchanged
/// \param v a vertex of it
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \return the output iterator, past the last element that was written
/// \pre `pm.is_vertex(v)`
/// \cost quadratic in the vertex degree
template <class OutputIterator>
OutputIterator non_face_triangles_at_vertex(const Progressive_mesh& pm, Index v, OutputIterator out)
{
  boost::container::small_vector<Index, 16> ring; // the neighbours, counterclockwise
  std::uint64_t bits = 0;                         // which tell of most vertices that they are none
  const auto bit = [](Index u) { return std::uint64_t(1) << (u % 64); };
  const Index begin = pm.outgoing(v);
  Index h = begin;
  do
  {
    ring.push_back(pm.target(h));
    bits |= bit(ring.back());
    h = pm.ccw(h);
  } while(h != begin);

  const std::size_t n = ring.size();
  for(std::size_t i = 0; i < n; ++i)
  {
    const Index x = ring[i], before = ring[(i + n - 1) % n], after = ring[(i + 1) % n];
    if(pm.is_ghost_vertex(x))
      continue;
    const Index xbegin = pm.outgoing(x);
    Index xy = xbegin;
    do
    {
      const Index y = pm.target(xy);
      if(x < y && !pm.is_ghost_vertex(y) && (bits & bit(y)) != 0 && y != before && y != after &&
         std::find(ring.begin(), ring.end(), y) != ring.end())
        *out++ = Seed_curve{pm.level(), {v, x, y}, Seed_origin::NON_FACE_TRIANGLE};
      xy = pm.ccw(xy);
    } while(xy != xbegin);
  }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_NON_FACE_TRIANGLES_H
