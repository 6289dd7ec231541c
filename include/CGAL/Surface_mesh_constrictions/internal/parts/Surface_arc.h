// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H

#include <CGAL/Surface_mesh_constrictions/internal/curves/Combinatorial_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_locations.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A piece of a curve on a user's mesh between two pivots. A curve without pivots is one closed arc.
template <class TriangleMesh>
struct Surface_arc : Combinatorial_arc<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                                       typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>
{
  bool is_closed = false;         // then it has no ends
  std::vector<double> parameters; // of the crossings, along the crossed halfedges

  // its pieces, each in one face or along the edge
  std::size_t number_of_strands() const { return this->crossings.size() + !is_closed; }
};

// The arcs of a curve, closed or from one pivot to another. `number` is its place in the user's sequence, for messages.
// Throws Invalid_input unless any two consecutive locations lie in one triangle. Linear, times the degrees of pivots.
template <class TriangleMesh, class LocationRange>
std::vector<Surface_arc<TriangleMesh>> surface_arcs(const TriangleMesh& tm, const LocationRange& locations,
                                                    std::size_t number, bool is_closed)
{
  auto read = arcs_on_mesh(tm, locations, number, is_closed);
  const std::size_t n = locations.size();
  std::vector<Surface_arc<TriangleMesh>> result;
  if(read.arcs.empty())
  {
    result.emplace_back();
    result.back().is_closed = true;
    result.back().crossings = std::move(read.closed_strip);
    for(const auto& l : locations)
      result.back().parameters.push_back(l.parameter);
  }
  for(auto& arc : read.arcs)
  {
    const std::size_t first = arc.location + 1;
    result.emplace_back();
    Surface_arc<TriangleMesh>& last = result.back();
    last.from = arc.from;
    last.to = arc.to;
    last.along = arc.along;
    last.crossings = std::move(arc.crossings);
    for(std::size_t i = 0; i < last.crossings.size(); ++i)
      last.parameters.push_back(locations[(first + i) % n].parameter);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_SURFACE_ARC_H
