// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTEN_PATHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTEN_PATHS_H

#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightening_basins.h>

#include <CGAL/for_each.h>

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The ends of a group of closed paths.
struct Ends_of_paths
{
  struct End
  {
    Closed_curve curve; // smaller than its measured arcs
    std::size_t arcs;
    std::uint64_t hash;
    std::vector<std::size_t> paths;
  };
  std::vector<End> ends;
  std::vector<std::size_t> degenerate; // paths
};

// Tightens closed paths of edges of a surface; path_of(i) is number i as a vector of vertices. Writes the resulting
// curves into a network on the same surface, each once: their seeds are the numbers of the paths. Returns the numbers
// of the paths that degenerate. Cost: for each path that of tightening it until it meets the way of another one of its
// group.
template <class ConcurrencyTag, class PathOf>
std::vector<std::size_t> tighten_paths(std::size_t number_of_paths, const PathOf& path_of, Curve_network& ends)
{
  const std::size_t group_size = 512;
  const Progressive_mesh& surface = ends.surface();
  const Length_unit unit(surface);
  const Corner_angles angles(surface);
  auto paths_in_groups = make_groups<Ends_of_paths>(number_of_paths, group_size);
  CGAL::for_each<ConcurrencyTag>(paths_in_groups, [&](Group<Ends_of_paths>& group) {
    Curve_network network(surface, false);
    Tightener tightener(network, unit, &angles);
    Tightening_basins basins(network, tightener);
    for(std::size_t i = group.begin; i < group.end; ++i)
    {
      const Index c = network.add_curve(i, path_of(i)), end = basins.tighten(c);
      if(end == null_index)
        group.result.degenerate.push_back(i);
      else if(end != c)
        network.merge(c, end);
    }
    for(Index c = 0; c < network.number_of_curve_ids(); ++c)
      if(!network.is_empty(c))
        group.result.ends.push_back({curve_of_arcs(arcs_of_curve(network, c)), network.curve(c).size,
                                     network.curve(c).hash, network.curve(c).seeds});
    return true;
  });

  std::size_t arcs = 0;
  std::unordered_set<std::uint64_t> hashes;
  for(const Group<Ends_of_paths>& group : paths_in_groups)
    for(const Ends_of_paths::End& e : group.result.ends)
      if(hashes.insert(e.hash).second)
        arcs += e.arcs;
  ends.reserve(arcs);

  std::vector<std::size_t> degenerate;
  Distinct_curves distinct(ends);
  for(Group<Ends_of_paths>& group : paths_in_groups)
  {
    degenerate.insert(degenerate.end(), group.result.degenerate.begin(), group.result.degenerate.end());
    for(Ends_of_paths::End& e : group.result.ends)
    {
      const Index c = ends.add_curve(std::move(e.paths));
      std::vector<Arc> measured = arcs_of_curve(surface, e.curve);
      ends.set_arcs(c, measured);
      distinct.insert(c);
    }
    group.result = Ends_of_paths();
  }
  return degenerate;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_TIGHTEN_PATHS_H
