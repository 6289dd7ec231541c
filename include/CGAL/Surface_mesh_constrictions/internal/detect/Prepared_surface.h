// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_PREPARED_SURFACE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_PREPARED_SURFACE_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/query_file.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Point_locator.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The levels on which loops through a location are looked for: one for seeds of constrictions, and a finer one for
// geodesic loops, to which the seeds are led first. Coarser meshes are searched as they are.
constexpr std::size_t seeding_vertices = 1000, searching_vertices = 4096;

// A level that is held, and its number.
struct Held_level
{
  std::size_t level;
  Measuring_level of;

  // Copies the current surface. Linear in T^0.
  explicit Held_level(const Progressive_mesh& pm) : level(pm.level()), of(pm) {}

  const Progressive_mesh& surface() const { return of.copy.surface(); }
};

// What simplify() calls where no seeds are looked for.
inline void append_collapses(const Collapse_record& record, Progressive_mesh& pm)
{
  pm.append_collapses(record.collapses, [](const Edge_collapse&) { return true; });
}

// What queries need of a mesh, made once: the mesh, its levels, areas, and what finds locations. All functions that
// answer are const, and may be called by several threads at a time.
template <class TriangleMesh, class VertexPointMap>
class Prepared_surface
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

  // Copies the mesh. Throws Invalid_input for one that cannot be used. Linear.
  template <class VertexIndexMap>
  Prepared_surface(const TriangleMesh& tm, VertexPointMap vpm, VertexIndexMap vim)
    : m_imported(tm, vpm, vim), m_vpm(vpm),
      m_index_of([vim](vertex_descriptor v) { return static_cast<std::size_t>(get(vim, v)); })
  {
    m_imported.rescale();
    bool is_in_order = true;
    for(Index v = 0; v < m_imported.number_of_vertices() && is_in_order; ++v)
      is_in_order = m_index_of(m_imported.vertex(v)) == v;
    for(Index v = 0; v < m_imported.number_of_vertices() && !is_in_order; ++v)
    {
      const std::size_t i = m_index_of(m_imported.vertex(v));
      if(m_number.size() <= i)
        m_number.resize(i + 1, null_index);
      m_number[i] = v;
    }
  }

  // the surface and its unit are referred to
  Prepared_surface(const Prepared_surface&) = delete;
  Prepared_surface& operator=(const Prepared_surface&) = delete;

  // Simplifies the mesh and holds levels. Calls find_seeds(record, pm), which appends the collapses to pm and may look
  // at each level. O(n log n) for n faces.
  template <class ConcurrencyTag, class Policies, class Visitor, class FindSeeds>
  void simplify(const Policies& policies, bool with_refused_seeds, const Visitor& visitor, const FindSeeds& find_seeds)
  {
    visitor.on_stage_begin(Detection_stage::SIMPLIFICATION, m_imported.points.size());
    const Collapse_record record = internal::simplify<ConcurrencyTag>(m_imported, policies, with_refused_seeds, false,
                                                                      Block_simplification(), visitor);
    visitor.on_stage_end(Detection_stage::SIMPLIFICATION);
    m_surface.emplace(std::move(m_imported.table), std::move(m_imported.points));
    const double area = surface_area(*m_surface);
    find_seeds(record, *m_surface);
    hold_levels(area);
  }

  // What a file of this mesh must agree with; before it is simplified or restored. Linear.
  Query_file_key key() const
  {
    std::vector<Index> order(m_imported.number_of_faces());
    std::iota(order.begin(), order.end(), Index(0));
    return key_of(m_imported.table, m_imported.points, order);
  }

  // Takes collapses from a record instead of simplifying the mesh, and holds the same levels. Throws
  // Invalid_query_file for a record that is not of this mesh. Linear, if degrees are bounded.
  void restore(const Query_record& record)
  {
    if(!record.order.empty())
      m_imported.reorder_faces(record.order);
    m_surface.emplace(std::move(m_imported.table), std::move(m_imported.points));
    const double area = surface_area(*m_surface);
    Collapse_checker(*m_surface).append(record);
    hold_levels(area);
  }

  // What `restore()` takes, but for the seeds, and the key. O(n log n) for n faces.
  std::pair<Query_file_key, Query_record> record() const
  {
    const TriangleMesh& tm = m_imported.mesh();
    typedef std::pair<typename Graph_traits::face_descriptor, Index> Numbered_face;
    std::vector<Numbered_face> faces_of_mesh;
    for(auto f : faces(tm))
      faces_of_mesh.emplace_back(f, static_cast<Index>(faces_of_mesh.size()));
    std::sort(faces_of_mesh.begin(), faces_of_mesh.end());
    Query_record result;
    std::vector<Index> place(faces_of_mesh.size());
    bool is_in_order = true;
    for(Index f = 0; f < m_imported.number_of_faces(); ++f)
    {
      const Numbered_face least(face(m_imported.halfedge_of(3 * f), tm), 0);
      const Index number = std::lower_bound(faces_of_mesh.begin(), faces_of_mesh.end(), least)->second;
      result.order.push_back(number);
      place[number] = f;
      is_in_order = is_in_order && number == f;
    }
    if(is_in_order)
      result.order.clear();
    result.collapses = collapses_of(*m_surface);
    return {key_of(m_surface->connectivity(), m_surface->points(), place), std::move(result)};
  }

  // Goes without levels: for one tightening, or for a mesh that is searched as it is. Linear.
  void hold_no_levels()
  {
    m_surface.emplace(std::move(m_imported.table), std::move(m_imported.points));
    finish({});
  }

  // Whether geodesic loops are looked for on a level.
  bool is_searched_on_level() const { return is_large(m_imported.number_of_vertices()); }

  const Imported_mesh<TriangleMesh>& imported() const { return m_imported; }
  const VertexPointMap& vertex_point_map() const { return m_vpm; }
  const Progressive_mesh& surface() const { return *m_surface; } // at level 0
  const Length_unit& length_unit() const { return *m_unit; }
  const Surface_sides& sides() const { return *m_sides; }
  const Point_locator& locator() const { return *m_locator; }

  // the levels to measure prominences on
  const std::deque<Measuring_level>& measuring() const { return m_measuring; }
  // the level with `seeding_vertices`, and its graph
  const Held_level& seeding() const { return *m_seeding; }
  const Edge_graph& seeding_graph() const { return *m_seeding_graph; }
  // the level with `searching_vertices`; null for a mesh that has hardly more
  const Held_level* searching() const { return m_searching ? &*m_searching : nullptr; }

  // The number of a vertex; null_index for one that is not of the mesh.
  Index number_of(vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      return null_index;
    const std::size_t i = m_index_of(v);
    if(m_number.empty())
      return i < m_imported.number_of_vertices() ? static_cast<Index>(i) : null_index;
    return i < m_number.size() ? m_number[i] : null_index;
  }

private:
  // `place[f]` is the face here that is number f of the mesh.
  Query_file_key key_of(const Corner_table& table, const std::vector<Point>& points,
                        const std::vector<Index>& place) const
  {
    Fnv_hash hash;
    hash.add(bits_of(m_imported.unit().restored(1.0)), 8);
    for(std::size_t v = 0; v < m_imported.number_of_vertices(); ++v)
      for(int i = 0; i < 3; ++i)
        hash.add(bits_of(points[v][i]), 8);
    for(Index f : place)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        hash.add(table.halfedges[h].source, 4);
    return {hash.value(), m_imported.number_of_vertices(), m_imported.number_of_faces(), 0};
  }

  static bool is_large(std::size_t vertices) { return vertices > 4 * searching_vertices; }

  // The surface is at its last level. `area` is that of T^0.
  void hold_levels(double area)
  {
    Progressive_mesh& pm = *m_surface;
    pm.go_to_level(pm.level_with(seeding_vertices));
    m_seeding.emplace(pm);
    m_seeding_graph.emplace(m_seeding->surface());
    if(is_searched_on_level())
    {
      pm.go_to_level(pm.level_with(searching_vertices));
      m_searching.emplace(pm);
    }
    m_measuring = measuring_levels(pm, area);
    finish(clusters());
  }

  // By vertex, the one of the finest level that is not too large that it has been merged into.
  std::vector<Index> clusters() const
  {
    const Level_copy& copy = (m_searching ? *m_searching : *m_seeding).of.copy;
    std::vector<Index> result(m_imported.number_of_vertices(), null_index);
    for(Index v = 0; v < result.size(); ++v)
      if(m_surface->outgoing(v) != null_index)
        result[v] = copy.vertex(v);
    return result;
  }

  void finish(std::vector<Index> clusters)
  {
    const Progressive_mesh& pm = *m_surface;
    if(clusters.empty())
      for(Index v = 0; v < m_imported.number_of_vertices(); ++v)
        clusters.push_back(pm.outgoing(v) == null_index ? null_index : 0);
    Index number = 0;
    for(Index c : clusters)
      number = c == null_index ? number : (std::max)(number, c + 1);
    m_unit.emplace(pm);
    m_sides.emplace(pm);
    m_locator.emplace(pm, clusters, number);
  }

  Imported_mesh<TriangleMesh> m_imported;
  const VertexPointMap m_vpm;
  const std::function<std::size_t(vertex_descriptor)> m_index_of;
  std::vector<Index> m_number; // of a vertex, by its index; empty if they are the same
  std::optional<Progressive_mesh> m_surface;
  std::optional<Length_unit> m_unit;
  std::optional<Surface_sides> m_sides;
  std::optional<Point_locator> m_locator;
  std::deque<Measuring_level> m_measuring;
  std::optional<Held_level> m_seeding, m_searching;
  std::optional<Edge_graph> m_seeding_graph;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_PREPARED_SURFACE_H
