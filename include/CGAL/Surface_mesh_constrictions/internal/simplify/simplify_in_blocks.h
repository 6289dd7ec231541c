// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Face_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Lean_edge_profile.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Policies_inside_block.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/mesh_from_corner_table.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/for_each.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A surface on which some collapses have been made, in numbers of its own.
struct Partial_surface
{
  typedef Progressive_mesh::Point Point;

  Corner_table table;
  std::vector<Point> points;
  std::vector<Index> vertices; // as T^0 numbers them
};

// Whether an edge of the surface has length zero. CGAL's edge_collapse() collapses such edges whatever they cost, those
// at the border of a block too. Linear.
inline bool has_edge_of_length_zero(const Corner_table& table, const std::vector<Partial_surface::Point>& points)
{
  for(Index h = 0; h < table.halfedges.size(); ++h)
    if(points[table.halfedges[h].source] == points[table.halfedges[Corner_table::next(h)].source])
      return true;
  return false;
}

// A block of faces of a surface, as a surface with border. The vertices inside come first.
struct Face_block
{
  Partial_surface surface;
  std::size_t number_of_vertices_inside = 0, number_of_edges_inside = 0;
};

// Cuts a block out of the surface. `number` has a place for each vertex of the surface; those of vertices inside the
// block are overwritten. Linear in the block, but for its border.
inline Face_block make_face_block(const Corner_table& table, const std::vector<Partial_surface::Point>& points,
                                  const std::vector<Index>& vertices, const Face_blocks& blocks, Index block,
                                  std::vector<Index>& number)
{
  Face_block result;
  Partial_surface& s = result.surface;
  const Index begin = blocks.begin(block), end = blocks.end(block);
  std::vector<Index> inside, border;
  for(Index h = 3 * begin; h < 3 * end; ++h)
  {
    const Index v = table.halfedges[h].source;
    if(blocks.block_of_vertex(v) == null_index)
      border.push_back(v);
    else
      number[v] = null_index;
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  for(Index h = 3 * begin; h < 3 * end; ++h)
  {
    const Index v = table.halfedges[h].source;
    if(blocks.block_of_vertex(v) == null_index || number[v] != null_index)
      continue;
    number[v] = static_cast<Index>(inside.size());
    inside.push_back(v);
  }
  const Index n = static_cast<Index>(inside.size());
  result.number_of_vertices_inside = n;

  s.table.outgoing.resize(n + border.size());
  s.table.halfedges.reserve(3 * (end - begin));
  for(Index h = 3 * begin; h < 3 * end; ++h)
  {
    const Index o = table.halfedges[h].opposite, v = table.halfedges[h].source;
    const Index local =
        blocks.block_of_vertex(v) != null_index
            ? number[v]
            : n + static_cast<Index>(std::lower_bound(border.begin(), border.end(), v) - border.begin());
    s.table.halfedges.push_back({local, blocks.has_face(block, o / 3) ? o - 3 * begin : null_index});
    s.table.outgoing[local] = h - 3 * begin;
  }
  for(Index h = 0; h < s.table.halfedges.size(); ++h)
    result.number_of_edges_inside += h < s.table.halfedges[h].opposite && s.table.halfedges[h].source < n &&
                                     s.table.halfedges[Corner_table::next(h)].source < n;
  s.vertices.swap(inside);
  s.vertices.insert(s.vertices.end(), border.begin(), border.end());
  for(Index& v : s.vertices)
  {
    s.points.push_back(points[v]);
    v = vertices[v];
  }
  return result;
}

// The result of the simplification of a block: collapses, and the corners of the faces that are left, in numbers of
// T^0.
struct Simplified_block
{
  Collapse_record record;
  std::vector<Index> corners;
};

// Ends the simplification of a block when no more than this many edges are left.
struct Number_of_edges_stop_predicate
{
  std::size_t edges;

  template <class FT, class Profile, class Size>
  bool operator()(const FT&, const Profile&, Size, Size current) const
  {
    return current <= edges;
  }
};

// Collapses edges inside a block until only the given share of them is left.
template <class Policies>
Simplified_block simplify_block(const Face_block& block, const Policies& make_policies, bool with_refused_seeds,
                                double share)
{
  Simplified_block result;
  Simplification_mesh mesh;
  mesh_from_corner_table(block.surface.table, block.surface.points, mesh);
  const auto names = boost::make_iterator_property_map(block.surface.vertices.begin(), get(boost::vertex_index, mesh));
  const Collapse_recording_visitor<std::decay_t<decltype(names)>> recorder(result.record, names, with_refused_seeds);
  const auto policies = make_policies(mesh);
  typedef std::decay_t<decltype(policies.get_cost())> Cost;
  typedef std::decay_t<decltype(policies.get_placement())> Placement;
  static_assert(std::is_class<Cost>::value && !std::is_final<Cost>::value,
                "the cost that simplification_policies make must be a class that can be derived from");

  const std::size_t outside = mesh.num_edges() - block.number_of_edges_inside;
  const Number_of_edges_stop_predicate stop{
      outside + static_cast<std::size_t>(share * static_cast<double>(block.number_of_edges_inside))};
  Surface_mesh_simplification::edge_collapse(
      mesh, stop,
      CGAL::parameters::get_cost(Cost_inside_block<Cost>(policies.get_cost(), block.number_of_vertices_inside))
          .get_placement(Placement_inside_block<Placement>(policies.get_placement(), block.number_of_vertices_inside))
          .vertex_point_map(Lean_point_map(get(CGAL::vertex_point, mesh)))
          .visitor(recorder));

  for(auto f : faces(mesh))
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh))
      result.corners.push_back(names[v]);
  return result;
}

// Simplifies blocks of a surface independently, so that each fits into the cache, and several processors can work.
// Edges at the border of a block stay as they are. Appends the collapses to the record, block by block, and returns the
// surface that is left.
template <class ConcurrencyTag, class Policies, class Progress>
Partial_surface simplify_blocks(const Corner_table& table, const std::vector<Partial_surface::Point>& points,
                                const std::vector<Index>& vertices, const Face_blocks& blocks, double share,
                                const Policies& make_policies, bool with_refused_seeds, Collapse_record& record,
                                const Progress& on_step)
{
  std::vector<Simplified_block> simplified(blocks.size());
  std::vector<Index> number(points.size());
  std::mutex mutex;
  std::size_t done = record.collapses.size();
  CGAL::for_each<ConcurrencyTag>(simplified, [&](Simplified_block& result) {
    const Index block = static_cast<Index>(&result - simplified.data());
    result = simplify_block(make_face_block(table, points, vertices, blocks, block, number), make_policies,
                            with_refused_seeds, share);
    const std::lock_guard<std::mutex> lock(mutex);
    on_step(done += result.record.collapses.size());
    return true;
  });

  Partial_surface rest;
  const std::size_t last = vertices.empty() ? 0 : *std::max_element(vertices.begin(), vertices.end());
  std::vector<Partial_surface::Point> position(last + 1);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    position[vertices[i]] = points[i];
  std::vector<Index> corners;
  for(Simplified_block& b : simplified)
  {
    for(const Edge_collapse& c : b.record.collapses)
      position[c.kept] = c.point;
    for(Seed_curve& s : b.record.refused_seeds)
    {
      s.level += record.collapses.size();
      record.refused_seeds.push_back(std::move(s));
    }
    record.collapses.insert(record.collapses.end(), b.record.collapses.begin(), b.record.collapses.end());
    corners.insert(corners.end(), b.corners.begin(), b.corners.end());
    b = Simplified_block();
  }
  number.assign(last + 1, null_index);
  for(Index& v : corners)
  {
    if(number[v] == null_index)
    {
      number[v] = static_cast<Index>(rest.vertices.size());
      rest.vertices.push_back(v);
      rest.points.push_back(position[v]);
    }
    v = number[v];
  }
  rest.table = make_corner_table(rest.vertices.size(), corners, true);
  return rest;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H
