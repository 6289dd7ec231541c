// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_HANDLE_CUTTER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_HANDLE_CUTTER_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Removed_handle.h>
#include <CGAL/Surface_mesh_constrictions/Split_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_beside.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Twin_caps.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/intersecting_caps.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Origin.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The distance of the two curves beside a cut from it, relative to its length.
constexpr double distance_beside_cut = 0.01;

// Cuts a mesh along curves that stay clear of each other, takes out the band between two curves beside each, and closes
// the two rims by caps. On a mesh that stays connected each cut lets the genus fall by one.
template <class TriangleMesh, class VertexPointMap>
class Handle_cutter
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  typedef std::vector<halfedge_descriptor> Cycle;

public:
  Handle_cutter(TriangleMesh& tm, VertexPointMap vpm) : m_tm(tm), m_vpm(vpm) {}

  // Records everything but the round and the place of the curve. The cost is that of `split_along_constrictions()`, of
  // triangulating the caps and of `intersecting_caps()`.
  std::vector<Removed_handle<Point>> cut(const std::vector<Constriction<TriangleMesh>>& curves)
  {
    std::vector<Removed_handle<Point>> result;
    for(const Constriction<TriangleMesh>& c : curves)
    {
      result.push_back({0, 0, {}, c.length(), c.side(), c.certificate(), {{0, 0}}, 0, {{false, false}}});
      c.points(m_tm, m_vpm, std::back_inserter(result.back().points));
    }
    const auto np = CGAL::parameters::vertex_point_map(m_vpm);
    Ancestry ancestry;
    const std::vector<Cycle> cycles =
        split_along_constrictions_checked(m_tm, curves, np.visitor(Ancestry_visitor(ancestry))).halfedges;
    const auto is_inner = [&](halfedge_descriptor h) {
      return ancestry.origin(face(h, m_tm)) == ancestry.origin(face(opposite(h, m_tm), m_tm));
    };

    std::vector<Constriction<TriangleMesh>> beside;
    std::vector<std::vector<std::size_t>> origins;
    for(std::size_t i = 0; i < cycles.size(); ++i)
      for(const Cycle& cycle : {cycles[i], turned(cycles[i])})
      {
        Curve_beside<TriangleMesh> c(m_tm, m_vpm, cycle, distance_beside_cut * result[i].length, is_inner);
        typename Constriction<TriangleMesh>::Data data;
        data.locations.swap(c.locations);
        beside.emplace_back(std::move(data));
        origins.push_back(std::move(c.origins));
      }
    const std::vector<Cycle> rims = split_along_constrictions_checked(m_tm, beside, np).halfedges;

    std::vector<std::vector<face_descriptor>> caps;
    for(std::size_t i = 0; i < cycles.size(); ++i)
    {
      Cap_polygon polygon;
      for(halfedge_descriptor h : cycles[i])
        polygon.push_back(point(h));
      const std::array<Cycle, 2> holes = {{hole_along(rims[2 * i]), hole_along(rims[2 * i + 1])}};
      result[i].volume_change = -take_out_band(holes, polygon[0]);
      std::array<Polygon_beside, 2> sides;
      for(std::size_t side = 0; side < 2; ++side)
      {
        for(halfedge_descriptor h : holes[side])
          sides[side].corners.push_back(point(h));
        sides[side].ascends = side == 1; // the halfedges of a hole run against the curve beside the cut
        sides[side].origins = origins_of_hole(origins[2 * i + side], side, polygon.size());
      }
      for(std::vector<face_descriptor>& cap : close(polygon, sides, holes))
      {
        double& area = result[i].cap_areas[caps.size() % 2];
        for(face_descriptor f : cap)
        {
          area += area_of(f);
          result[i].volume_change += volume_below(f, polygon[0]);
        }
        caps.push_back(std::move(cap));
      }
    }
    const std::vector<bool> intersects = intersecting_caps(m_tm, m_vpm, caps);
    for(std::size_t c = 0; c < caps.size(); ++c)
      result[c / 2].caps_intersect[c % 2] = intersects[c];
    return result;
  }

private:
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Near_point;

  // The faces from which pieces have been split off.
  struct Ancestry
  {
    face_descriptor split;
    std::unordered_map<face_descriptor, face_descriptor> origin_of_piece;

    face_descriptor origin(face_descriptor f) const
    {
      const auto found = origin_of_piece.find(f);
      return found == origin_of_piece.end() ? f : found->second;
    }
  };

  struct Ancestry_visitor : public Split_visitor_base<TriangleMesh>
  {
    explicit Ancestry_visitor(Ancestry& ancestry) : ancestry(&ancestry) {}

    void before_subface_creations(face_descriptor f, const TriangleMesh&) const { ancestry->split = f; }
    void after_subface_created(face_descriptor f, const TriangleMesh&) const
    {
      ancestry->origin_of_piece[f] = ancestry->split;
    }

    Ancestry* ancestry;
  };

  Near_point point(halfedge_descriptor h) const { return nearest_point(get(m_vpm, target(h, m_tm))); }

  // The same cycle in the other direction.
  Cycle turned(const Cycle& cycle) const
  {
    Cycle result;
    for(auto h = cycle.rbegin(); h != cycle.rend(); ++h)
      result.push_back(opposite(*h, m_tm));
    return result;
  }

  // The halfedges of the band along a rim, in the order in which they follow each other around the hole to be.
  Cycle hole_along(const Cycle& rim) const { return turned(rim); }

  // For each halfedge of a hole, the place in the cut of the vertex from which the edge came that its target lies on, if
  // it has one.
  static std::vector<std::size_t> origins_of_hole(const std::vector<std::size_t>& origins, std::size_t side,
                                                  std::size_t size)
  {
    std::vector<std::size_t> result;
    for(std::size_t k = 0; k < origins.size(); ++k)
    {
      // the first halfedge leads to where the last one of the rim begins
      const std::size_t o = origins[(2 * origins.size() - 2 - k) % origins.size()];
      result.push_back(side == 0 || o >= size ? o : (2 * size - 2 - o) % size);
    }
    return result;
  }

  double area_of(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, m_tm);
    const Near_point p = point(h), q = point(next(h, m_tm)), r = point(prev(h, m_tm));
    return std::sqrt(cross_product(q - p, r - p).squared_length()) / 2;
  }

  // Of the tetrahedron of a face and a point, positive if the normal points away from it.
  double volume_below(face_descriptor f, const Near_point& apex) const
  {
    const halfedge_descriptor h = halfedge(f, m_tm);
    return determinant(point(h) - apex, point(next(h, m_tm)) - apex, point(prev(h, m_tm)) - apex) / 6;
  }

  // Removes the faces between two holes to be. Returns the volume below them.
  double take_out_band(const std::array<Cycle, 2>& holes, const Near_point& apex)
  {
    std::unordered_set<halfedge_descriptor> on_border;
    std::unordered_set<vertex_descriptor> kept;
    for(const Cycle& hole : holes)
      for(halfedge_descriptor h : hole)
      {
        on_border.insert(h);
        kept.insert(target(h, m_tm));
      }
    std::vector<face_descriptor> band = {face(holes[0][0], m_tm)};
    std::unordered_set<face_descriptor> seen = {band[0]};
    std::vector<edge_descriptor> inner_edges;
    std::vector<vertex_descriptor> inner_vertices;
    double volume = 0;
    for(std::size_t i = 0; i < band.size(); ++i)
    {
      volume += volume_below(band[i], apex);
      for(halfedge_descriptor h : halfedges_around_face(halfedge(band[i], m_tm), m_tm))
      {
        if(kept.insert(target(h, m_tm)).second)
          inner_vertices.push_back(target(h, m_tm));
        if(on_border.count(h) > 0)
          continue;
        const face_descriptor beyond = face(opposite(h, m_tm), m_tm);
        if(on_border.insert(opposite(h, m_tm)).second)
          inner_edges.push_back(edge(h, m_tm));
        if(seen.insert(beyond).second)
          band.push_back(beyond);
      }
    }
    for(const Cycle& hole : holes)
      for(std::size_t k = 0; k < hole.size(); ++k)
      {
        set_face(hole[k], Graph_traits::null_face(), m_tm);
        set_next(hole[k], hole[(k + 1) % hole.size()], m_tm);
        set_halfedge(target(hole[k], m_tm), hole[k], m_tm);
      }
    for(face_descriptor f : band)
      remove_face(f, m_tm);
    for(edge_descriptor e : inner_edges)
      remove_edge(e, m_tm);
    for(vertex_descriptor v : inner_vertices)
      remove_vertex(v, m_tm);
    return volume;
  }

  // Closes the two holes beside a cut along a polygon. Returns the faces of the caps.
  std::array<std::vector<face_descriptor>, 2>
  close(const Cap_polygon& polygon, const std::array<Polygon_beside, 2>& sides, const std::array<Cycle, 2>& holes)
  {
    const Twin_caps caps(polygon, sides, [&](std::size_t side, std::size_t a, std::size_t b) {
      return halfedge(target(holes[side][a], m_tm), target(holes[side][b], m_tm), m_tm).second;
    });
    std::array<std::vector<face_descriptor>, 2> result;
    for(std::size_t side = 0; side < 2; ++side)
    {
      Euler::fill_hole(holes[side][0], m_tm);
      result[side] = caps.are_found() ? split_face(holes[side], caps.diagonals(side)) : split_as_cone(holes[side]);
    }
    return result;
  }

  // Splits the face in a hole along diagonals, those first that cut off the fewest corners.
  std::vector<face_descriptor> split_face(Cycle to, const Diagonals& diagonals)
  {
    std::vector<std::array<std::size_t, 2>> order(diagonals.begin(), diagonals.end());
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a[1] - a[0] < b[1] - b[0]; });
    std::vector<face_descriptor> result;
    for(const auto& [low, high] : order)
    {
      const halfedge_descriptor in_piece = Euler::split_face(to[high], to[low], m_tm);
      to[high] = opposite(in_piece, m_tm);
      result.push_back(face(in_piece, m_tm));
    }
    result.push_back(face(to[0], m_tm));
    return result;
  }

  // Splits the face in a hole into a cone to the mean of its corners.
  std::vector<face_descriptor> split_as_cone(const Cycle& hole)
  {
    typedef typename Kernel_traits<Point>::Kernel Kernel;
    typename Kernel::Vector_3 sum = NULL_VECTOR;
    for(halfedge_descriptor h : hole)
      sum = sum + (get(m_vpm, target(h, m_tm)) - Point(ORIGIN));
    const halfedge_descriptor to_apex = Euler::add_center_vertex(hole[0], m_tm);
    put(m_vpm, target(to_apex, m_tm), Point(ORIGIN) + sum / typename Kernel::FT(static_cast<double>(hole.size())));
    std::vector<face_descriptor> result;
    for(halfedge_descriptor h : hole)
      result.push_back(face(h, m_tm));
    return result;
  }

  TriangleMesh& m_tm;
  VertexPointMap m_vpm;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_HANDLE_CUTTER_H
