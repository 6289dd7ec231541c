// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_LOCUS_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_LOCUS_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Cut_locus.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/write_distinct_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the locally shortest loops of edges through the cut locus of one vertex of the current surface.
///
/// Take the shortest paths along edges from `root` to all vertices. An edge is on the cut locus of `root` if its two
/// ends are reached through different neighbours of `root`; it closes a loop, from `root` to its one end, along it, and
/// back. Two edges of a face that are on the cut locus follow each other along it. The loop is written if none of the
/// next two edges along the cut locus, whichever way, closes a shorter one, unless it bounds a face. Edges of length
/// zero are allowed.
///
/// Up to the resolution of the edges, the loops are geodesic everywhere but at `root` and at the edge that closes them.
/// They are a source of seed curves for the question of the paper's Section 6, how to find all constrictions.
///
/// \param pm the surface; unchanged
/// \param root a vertex of it
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level; the smallest vertex of a loop
///        comes first, followed by the smaller of its two neighbours in the loop
/// \return the output iterator, past the last element that was written
/// \pre `pm.is_vertex(root)`
/// \cost O(size of T^0) for the ids, plus O(n log n) for the n vertices of the current surface, plus the output
///
/// \sa `cut_locus_seeds()`
template <class OutputIterator>
OutputIterator cut_locus_seeds_at_vertex(const Progressive_mesh& pm, Index root, OutputIterator out)
{
  CGAL_precondition(pm.is_vertex(root));
  const internal::Edge_graph graph(pm);
  internal::Cut_locus cut_locus(graph);
  cut_locus.for_each_loop(graph.number(root), [&](const std::vector<Index>& loop) {
    *out++ = Seed_curve{pm.level(), loop, Seed_origin::CUT_LOCUS};
  });
  return out;
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the loops of `cut_locus_seeds_at_vertex()` for many roots, each loop once.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \param max_roots the greatest number of roots. The roots are the vertices of the surface in the order of their ids,
///        or every second, every third vertex and so on.
/// \return the output iterator, past the last element that was written
/// \pre `max_roots > 0`
/// \cost O(size of T^0) for the ids, plus O(n log n) for each root, n being the vertices of the current surface, plus
///       the output. Meant for coarse levels.
template <class ConcurrencyTag = Sequential_tag, class OutputIterator>
OutputIterator cut_locus_seeds(const Progressive_mesh& pm, OutputIterator out,
                               std::size_t max_roots = (std::numeric_limits<std::size_t>::max)())
{
  CGAL_precondition(max_roots > 0);
  const internal::Edge_graph graph(pm);
  const std::size_t n = graph.number_of_vertices(), step = n == 0 ? 1 : (n - 1) / max_roots + 1;
  const auto make_finder = [&graph, step] {
    return [cut_locus = internal::Cut_locus(graph), step](std::size_t i, const auto& write) mutable {
      cut_locus.for_each_loop(static_cast<Index>(i * step), write);
    };
  };
  return internal::write_distinct_loops<ConcurrencyTag>((n + step - 1) / step, 16, make_finder, pm.level(),
                                                        Seed_origin::CUT_LOCUS, out);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_LOCUS_SEEDS_H
