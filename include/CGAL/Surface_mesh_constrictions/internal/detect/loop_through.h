// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOP_THROUGH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOP_THROUGH_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Closed_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Face_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Held_path_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Paths_to_finer_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/insert_points.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The locations of a user on a prepared surface, in their order. Throws Invalid_input, with the number of the location,
// for one that is not on the mesh, and if there are fewer than three.
template <class TriangleMesh, class VertexPointMap, class LocationRange>
std::vector<Surface_location> given_locations(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                              const LocationRange& locations)
{
  std::vector<Surface_location> result;
  for(const auto& location : locations)
    try
    {
      result.push_back(without_tiny_coordinates(given_location(prepared, location)));
    }
    catch(const Invalid_input& e)
    {
      throw Invalid_input(e.defect(), result.size(), e.what() + (" (location " + std::to_string(result.size()) + ")"));
    }
  if(result.size() < 3)
    throw Invalid_input(Input_defect::INVALID_LOOP, 0,
                        "a loop goes through at least 3 locations; given are " + std::to_string(result.size()));
  return result;
}

// The loop through locations of a prepared surface. Throws Invalid_input, with the number of the location, if one is
// that before it, or is on another connected component. Cost: that of `geodesic_loop_through_locations()` without that
// of preparing the mesh.
template <class TriangleMesh, class VertexPointMap>
Loop_through_locations<TriangleMesh> loop_through(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                                  const std::vector<Surface_location>& locations, bool certifies)
{
  const Surface_with_points with(prepared.surface(), locations);
  const Progressive_mesh& pm = with.surface();
  const Corner_angles angles(pm);
  Held_path_tightener<TriangleMesh, VertexPointMap> tightener(prepared.imported(), pm, prepared.vertex_point_map(),
                                                              prepared.length_unit(), angles);
  Paths_to_finer_level paths(pm);
  std::vector<Arc> loop;
  std::vector<std::size_t> first_arc; // of the way from each location on
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    const std::size_t next = (i + 1) % locations.size();
    const Index from = with.vertices()[i], to = with.vertices()[next];
    if(from == to)
      throw Invalid_input(Input_defect::INVALID_LOOP, next,
                          "location " + std::to_string(next) + " is the same as location " + std::to_string(i));
    std::vector<Index> path;
    if(!paths.append(
           from, to, [](Index) { return true; }, path))
      throw Invalid_input(Input_defect::INVALID_LOOP, next,
                          "locations " + std::to_string(i) + " and " + std::to_string(next) +
                              " are on different connected components");
    path.push_back(to);
    first_arc.push_back(loop.size());
    for(Arc& a : tightener.tighten(path))
      loop.push_back(std::move(a));
  }

  Loop_through_locations<TriangleMesh> result;
  result.length = prepared.imported().unit().restored(accurate_length(pm, loop));
  result.is_simple = is_simple(pm, trace(pm, loop));
  const Face_locations<TriangleMesh> face_locations(prepared.imported(), prepared.surface());
  std::size_t arc = 0;
  for(const Trace_point& p : accurate_trace(pm, loop))
  {
    if(!p.is_pivot())
    {
      const Surface_with_point::Piece piece = with.piece(p.halfedge);
      if(piece.old != null_index)
        result.locations.push_back(
            face_locations.crossing(piece.old, piece.begin + p.parameter * (piece.end - piece.begin)));
      continue;
    }
    const std::size_t place = result.held.size();
    if(place < first_arc.size() && first_arc[place] == arc)
      result.held.push_back(result.locations.size());
    ++arc;
    if(!with.is_inserted(p.pivot))
      result.locations.push_back(face_locations.corner(p.pivot));
    else
      for(std::size_t i = 0; i < locations.size(); ++i)
        if(with.vertices()[i] == p.pivot)
        {
          result.locations.push_back(face_locations.at(locations[i]));
          break;
        }
  }

  std::vector<Arc> arcs = arcs_without_vertices(
      pm, loop, [&with](Index h) { return with.piece(h).old; }, [&with](Index v) { return !with.is_inserted(v); },
      prepared.surface());
  Closed_path_tightener<TriangleMesh, VertexPointMap> closed(prepared.imported(), prepared.surface(),
                                                             prepared.vertex_point_map(), prepared.length_unit(),
                                                             prepared.sides(), certifies);
  result.let_go = closed.tighten(std::move(arcs), Seed_origin::USER);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_LOOP_THROUGH_H
