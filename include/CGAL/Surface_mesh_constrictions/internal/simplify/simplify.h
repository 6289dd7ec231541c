// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Non_face_triangle_stop_predicate.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Face_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Lean_edge_profile.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify_in_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Records collapses and forwards the progress to a detection visitor.
template <class VertexIndexMap, class Visitor>
class Reporting_visitor : public Collapse_recording_visitor<VertexIndexMap>
{
  typedef Collapse_recording_visitor<VertexIndexMap> Base;

public:
  Reporting_visitor(Collapse_record& record, VertexIndexMap vim, bool with_refused_seeds, const Visitor& visitor)
    : Base(record, vim, with_refused_seeds), m_record(&record), m_visitor(&visitor)
  {}

  template <class Profile, class Vertex>
  void OnCollapsed(const Profile& profile, const Vertex& kept)
  {
    Base::OnCollapsed(profile, kept);
    m_visitor->on_step(Detection_stage::SIMPLIFICATION, m_record->collapses.size());
  }

private:
  const Collapse_record* m_record;
  const Visitor* m_visitor;
};

// Ends the simplification at the first non-face triangle, or not before it ends by itself.
struct Optional_stop_predicate
{
  bool stops;

  template <class FT, class Profile, class Size>
  bool operator()(const FT& cost, const Profile& profile, Size initial, Size current) const
  {
    return stops && Non_face_triangle_stop_predicate()(cost, profile, initial, current);
  }
};

// How a large mesh is simplified before it is simplified as a whole.
struct Block_simplification
{
  std::size_t whole_faces = 65536; // a mesh of no more faces is simplified as a whole
  std::size_t block_faces = 16384; // of a block at most, and at most of all blocks together after the last round
  double share = 0.25;             // of the edges inside a block that are left
};

// Simplifies a copy of the mesh as far as CGAL's edge_collapse() goes, or to the first non-face triangle that it meets,
// and returns the record. With blocks, a surface of many faces is first simplified in parts. Its faces are then
// numbered anew, block after block, so that neighbouring faces are near to each other in memory from here on. O(n log
// n), and with blocks nearly linear.
//
// A surface with boundary is simplified with its holes open: a collapse keeps it a surface, with three edges at each
// hole at least, if and only if it keeps the surface a closed one whose holes are filled by ghosts.
template <class ConcurrencyTag, class ImportedMesh, class Policies, class Visitor>
Collapse_record simplify(ImportedMesh& imported, const Policies& make_policies, bool with_refused_seeds,
                         bool first_only, const std::optional<Block_simplification>& in_blocks, const Visitor& visitor)
{
  Collapse_record record;
  record.collapses.reserve(imported.points.size());
  Partial_surface rest; // of the blocks; empty before the first round
  // of the surface with its holes open
  std::optional<Corner_table> open;
  std::vector<Partial_surface::Point> open_points;
  const auto open_holes = [&] {
    if(imported.table.first_ghost_face == null_index)
      return;
    open = without_ghosts(imported.table);
    open_points.assign(imported.points.begin(),
                       imported.points.begin() + static_cast<std::ptrdiff_t>(imported.number_of_vertices()));
  };
  open_holes();
  const Corner_table* table = open ? &*open : &imported.table;
  const std::vector<Partial_surface::Point>* points = open ? &open_points : &imported.points;
  std::vector<Index> vertices(points->size());
  std::iota(vertices.begin(), vertices.end(), Index(0));
  const auto on_step = [&visitor](std::size_t done) { visitor.on_step(Detection_stage::SIMPLIFICATION, done); };
  for(std::size_t faces = table->halfedges.size() / 3, faces_before = faces + 1;
      in_blocks && faces > (rest.points.empty() ? in_blocks->whole_faces : in_blocks->block_faces) &&
      faces < faces_before && !has_edge_of_length_zero(*table, *points);)
  {
    const Halved_faces halved(*table, *points, in_blocks->block_faces);
    if(rest.points.empty())
    {
      imported.reorder_faces(halved.order());
      open_holes();
    }
    else
      rest.table = with_faces_in_order(rest.table, halved.order());
    rest = simplify_blocks<ConcurrencyTag>(*table, *points, vertices, Face_blocks(*table, halved.first()),
                                           in_blocks->share, make_policies, with_refused_seeds, record, on_step);
    table = &rest.table;
    points = &rest.points;
    vertices = rest.vertices;
    faces_before = faces;
    faces = table->halfedges.size() / 3;
  }

  Simplification_mesh copy;
  mesh_from_corner_table(*table, *points, copy);
  const auto vim = boost::make_iterator_property_map(vertices.begin(), get(boost::vertex_index, copy));
  const Reporting_visitor<std::decay_t<decltype(vim)>, Visitor> recorder(record, vim, with_refused_seeds, visitor);
  const auto policies = make_policies(copy);
  Surface_mesh_simplification::edge_collapse(copy, Optional_stop_predicate{first_only},
                                             CGAL::parameters::get_cost(policies.get_cost())
                                                 .get_placement(policies.get_placement())
                                                 .vertex_point_map(Lean_point_map(get(CGAL::vertex_point, copy)))
                                                 .visitor(recorder));
  return record;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_H
