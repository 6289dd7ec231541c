// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Sections.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/write_distinct_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Shortest_path_tree.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Writes sections by functions on the vertices: values_of(i, values) sets those of function number i, by number in the
// graph.
template <class ConcurrencyTag, class ValuesOf, class OutputIterator>
OutputIterator write_sections(const Progressive_mesh& pm, const Edge_graph& graph, std::size_t functions,
                              const ValuesOf& values_of, std::size_t levels, OutputIterator out)
{
  const Sections made(pm, graph); // once: what it costs depends on T^0
  const auto make_finder = [&] {
    return [&, sections = made, values = std::vector<double>(graph.number_of_vertices())](std::size_t i,
                                                                                          const auto& write) mutable {
      values_of(i, values);
      sections.cut(values, levels, write);
    };
  };
  return write_distinct_loops<ConcurrencyTag>(functions, 5, make_finder, pm.level(), Seed_origin::SECTION, out);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the sections of the current surface by parallel planes, as closed paths of edges: the boundary loops of the
/// faces that lie on one side of the plane with all their vertices. Each loop is written once. Of loops of neighbouring
/// planes that follow each other along a tube, only those are written beside which the section is no longer than beside
/// their neighbours, and those of every seventh plane.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \param directions number of normals of the planes, spread evenly over a hemisphere
/// \param planes number of planes for each normal, at equal distances from one end of the surface to the other
/// \return the output iterator, past the last element that was written
/// \cost O(size of T^0) for the ids, plus O(n) for each plane, n being the faces of the current surface, plus the
///       output
template <class ConcurrencyTag = Sequential_tag, class OutputIterator>
OutputIterator plane_section_seeds(const Progressive_mesh& pm, OutputIterator out, std::size_t directions = 80,
                                   std::size_t planes = 56)
{
  const internal::Edge_graph graph(pm);
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.0));
  const auto heights = [&](std::size_t d, std::vector<double>& values) {
    // points of a Fibonacci lattice of the hemisphere
    const double z = (static_cast<double>(d) + 0.5) / static_cast<double>(directions);
    const double r = std::sqrt(1 - z * z), phi = golden_angle * static_cast<double>(d);
    for(Index v = 0; v < values.size(); ++v)
    {
      const auto& p = pm.point(graph.id(v));
      values[v] = r * std::cos(phi) * p.x() + r * std::sin(phi) * p.y() + z * p.z();
    }
  };
  return internal::write_sections<ConcurrencyTag>(pm, graph, directions, heights, planes, out);
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes sections of the current surface between pairs of its vertices, as closed paths of edges: level sets of the
/// difference between the distances along edges to two vertices, of which the middle one runs half way between them.
/// Each loop is written once. Of loops that follow each other along a tube, only those are written beside which the
/// level set is no longer than beside their neighbours, and those of every seventh level.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \param vertices number of the vertices, each as far as possible from those before it
/// \param sections number of level sets for each pair, at equal distances from the least value to the greatest
/// \return the output iterator, past the last element that was written
/// \cost O(size of T^0) for the ids, plus O(n) for each section, n being the faces of the current surface, plus the
///       output
template <class ConcurrencyTag = Sequential_tag, class OutputIterator>
OutputIterator distance_section_seeds(const Progressive_mesh& pm, OutputIterator out, std::size_t vertices = 8,
                                      std::size_t sections = 24)
{
  const internal::Edge_graph graph(pm);
  const std::size_t n = graph.number_of_vertices();
  if(n == 0)
    return out;
  internal::Shortest_path_tree tree(graph);
  std::vector<std::vector<double>> distances;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<double> nearest(n, (std::numeric_limits<double>::infinity)());
  const auto farthest = [&nearest] {
    return static_cast<Index>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
  };

  // the first vertex is an end of the surface: of those that some vertex reaches, the one that is farthest from it
  tree.grow(0);
  for(Index v = 0; v < n; ++v)
    nearest[v] = tree.is_reached(v) ? tree.distance(v) : 0;
  Index root = farthest();
  std::fill(nearest.begin(), nearest.end(), (std::numeric_limits<double>::infinity)());
  for(std::size_t i = 0; i < (std::min)(vertices, n); ++i, root = farthest())
  {
    tree.grow(root);
    distances.emplace_back(n);
    for(Index v = 0; v < n; ++v)
    {
      distances.back()[v] = tree.distance(v);
      nearest[v] = (std::min)(nearest[v], tree.distance(v));
    }
    for(std::size_t j = 0; j < i; ++j)
      pairs.emplace_back(i, j);
  }
  const auto differences = [&](std::size_t i, std::vector<double>& values) {
    const std::vector<double>&a = distances[pairs[i].first], &b = distances[pairs[i].second];
    std::transform(a.begin(), a.end(), b.begin(), values.begin(), [](double x, double y) { return x - y; });
  };
  return internal::write_sections<ConcurrencyTag>(pm, graph, pairs.size(), differences, sections, out);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H
