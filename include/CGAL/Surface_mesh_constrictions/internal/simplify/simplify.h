// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Non_face_triangle_stop_predicate.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Lean_edge_profile.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify_in_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
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

// The surface with its holes open. Linear.
template <class ImportedMesh>
Partial_surface whole_surface(const ImportedMesh& imported)
{
  Partial_surface result;
  result.table = imported.table.first_ghost_face == null_index ? imported.table : without_ghosts(imported.table);
  result.points.assign(imported.points.begin(),
                       imported.points.begin() + static_cast<std::ptrdiff_t>(imported.number_of_vertices()));
  result.vertices.resize(result.points.size());
  std::iota(result.vertices.begin(), result.vertices.end(), Index(0));
  return result;
}

// Simplifies a copy of the mesh as far as CGAL's edge_collapse() goes, or to the first non-face triangle that it meets,
// and returns the record. The fine levels of a large mesh are made by passes of collapses in blocks, if the policies are
// those of Garland and Heckbert: see simplify_in_blocks(), which numbers the faces anew. O(n log n), and with blocks
// nearly linear.
//
// A surface with boundary is simplified with its holes open: a collapse keeps it a surface, with three edges at each
// hole at least, if and only if it keeps the surface a closed one whose holes are filled by ghosts.
template <class ConcurrencyTag, class ImportedMesh, class Policies, class Visitor>
Collapse_record simplify(ImportedMesh& imported, const Policies& make_policies, bool with_refused_seeds,
                         bool first_only, const Block_simplification& in_blocks, const Visitor& visitor)
{
  Collapse_record record;
  record.collapses.reserve(imported.points.size());
  Simplification_mesh copy;
  std::vector<Index> vertices;
  {
    const bool has_blocks = std::is_same<Policies, Garland_heckbert_policies>::value && !first_only &&
                            imported.number_of_faces() > in_blocks.whole_faces;
    const auto on_step = [&visitor](std::size_t done) { visitor.on_step(Detection_stage::SIMPLIFICATION, done); };
    Partial_surface surface =
        has_blocks ? simplify_in_blocks<ConcurrencyTag>(imported, in_blocks, with_refused_seeds, record, on_step)
                   : whole_surface(imported);
    mesh_from_corner_table(surface.table, surface.points, copy);
    vertices.swap(surface.vertices);
  }
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
