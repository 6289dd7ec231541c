// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_CUT_LOCUS_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_CUT_LOCUS_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Cut_locus.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/write_distinct_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Shortest_path_tree.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

// The default arguments of `Local_cut_locus_seeds`: how many vertices are roots.
constexpr std::size_t local_roots = 64;

// Writes the loops of a cut locus through the vertices of the graph that are nearest to one of them, each once.
template <class ConcurrencyTag, class OutputIterator>
OutputIterator write_local_loops(const Edge_graph& graph, Index center, std::size_t max_roots, std::size_t level,
                                 OutputIterator out)
{
  Shortest_path_tree tree(graph);
  tree.grow(center);
  std::vector<Index> roots;
  for(Index v = 0; v < graph.number_of_vertices(); ++v)
    if(tree.is_reached(v))
      roots.push_back(v);
  std::stable_sort(roots.begin(), roots.end(),
                   [&tree](Index u, Index v) { return tree.distance(u) < tree.distance(v); });
  if(roots.size() > max_roots)
    roots.resize(max_roots);
  const auto make_finder = [&] {
    return [&, cut_locus = Cut_locus(graph)](std::size_t i, const auto& write) mutable {
      cut_locus.for_each_loop(roots[i], write);
    };
  };
  return write_distinct_loops<ConcurrencyTag>(roots.size(), 16, make_finder, level, Seed_origin::CUT_LOCUS, out);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes the loops of `cut_locus_seeds_at_vertex()` on the surface with a given number of vertices,
/// each once. The roots are the vertex that a given vertex of T^0 has been merged into, and the vertices around it.
///
/// The vertices around are needed where the given one is the tip of a limb: the loops through a tip shrink to a point,
/// while those through vertices further down go around the limb.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost O(size of T^0) for the ids, plus for each root O(n log n), for the given number n of vertices
///
/// \sa `detect_constrictions_near()`
class Local_cut_locus_seeds
{
public:
  /// \param vertex a vertex of T^0 that is not isolated, numbered as it comes in `vertices(tm)`
  /// \param vertices the number of vertices of the surface on which loops are searched
  /// \param max_roots the greatest number of roots, which are the vertices nearest to the given one, along edges
  explicit Local_cut_locus_seeds(Index vertex, std::size_t vertices = 1000,
                                 std::size_t max_roots = internal::local_roots)
    : m_vertex(vertex), m_vertices(vertices), m_max_roots(max_roots)
  {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    if(!is_level_with(pm, level, m_vertices))
      return out;
    return level.is_parallel ? write_loops<Parallel_if_available_tag>(pm, out) : write_loops<Sequential_tag>(pm, out);
  }

private:
  template <class ConcurrencyTag, class OutputIterator>
  OutputIterator write_loops(const Progressive_mesh& pm, OutputIterator out) const
  {
    const internal::Edge_graph graph(pm);
    return internal::write_local_loops<ConcurrencyTag>(graph, graph.number(pm.representative(m_vertex)), m_max_roots,
                                                       pm.level(), out);
  }

  Index m_vertex;
  std::size_t m_vertices, m_max_roots;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_LOCAL_CUT_LOCUS_SEEDS_H
