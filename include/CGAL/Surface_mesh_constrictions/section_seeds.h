// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/Sections.h>
#include <CGAL/Surface_mesh_constrictions/internal/Shortest_path_tree.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the sections of the current surface by parallel planes, as closed paths of edges: the boundary loops of the
/// faces that lie on one side of the plane with all their vertices. Each loop once; of loops of neighbouring planes
/// that follow each other along a tube only those beside which the section is no longer than beside their neighbours,
/// and those of each seventh plane.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \param directions number of normals of the planes, spread evenly over a hemisphere
/// \param planes number of planes for each normal, at equal distances from one end of the surface to the other
/// \return the output iterator, past the last element that was written
/// \cost O(size of T^0) for the ids, plus O(n) for each plane, n being the faces of the current surface, plus the
///       output
template <class OutputIterator>
OutputIterator plane_section_seeds(const Progressive_mesh& pm, OutputIterator out, std::size_t directions = 80,
                                   std::size_t planes = 56)
{
  const internal::Edge_graph graph(pm);
  internal::Sections sections(pm, graph);
  std::vector<double> heights(graph.number_of_vertices());
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.0));
  for(std::size_t d = 0; d < directions; ++d)
  {
    // points of a Fibonacci lattice of the hemisphere
    const double z = (static_cast<double>(d) + 0.5) / static_cast<double>(directions);
    const double r = std::sqrt(1 - z * z), phi = golden_angle * static_cast<double>(d);
    for(Index v = 0; v < heights.size(); ++v)
    {
      const auto& p = pm.point(graph.id(v));
      heights[v] = r * std::cos(phi) * p.x() + r * std::sin(phi) * p.y() + z * p.z();
    }
    out = sections.cut(heights, planes, out);
  }
  return out;
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes sections of the current surface between pairs of its vertices, as closed paths of edges: level sets of the
/// difference between the distances along edges to two vertices, of which the middle one runs half way between them.
/// Each loop once; of loops that follow each other along a tube only those beside which the level set is no longer than
/// beside their neighbours, and those of each seventh level.
///
/// \param pm the surface; unchanged
/// \param out an output iterator that takes `Seed_curve`, with `level` the current level
/// \param vertices number of the vertices, each as far as possible from those before it
/// \param sections number of level sets for each pair, at equal distances from the least value to the greatest
/// \return the output iterator, past the last element that was written
/// \cost O(size of T^0) for the ids, plus O(n) for each section, n being the faces of the current surface, plus the
///       output
template <class OutputIterator>
OutputIterator distance_section_seeds(const Progressive_mesh& pm, OutputIterator out, std::size_t vertices = 8,
                                      std::size_t sections = 24)
{
  const internal::Edge_graph graph(pm);
  const std::size_t n = graph.number_of_vertices();
  if(n == 0)
    return out;
  internal::Sections cutter(pm, graph);
  internal::Shortest_path_tree tree(graph);
  std::vector<std::vector<double> > distances;
  std::vector<double> nearest(n, (std::numeric_limits<double>::infinity)()), difference(n);
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
    {
      std::transform(distances[i].begin(), distances[i].end(), distances[j].begin(), difference.begin(),
                     [](double a, double b) { return a - b; });
      out = cutter.cut(difference, sections, out);
    }
  }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SECTION_SEEDS_H
