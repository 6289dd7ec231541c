// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_ARC_VERIFIER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_ARC_VERIFIER_H

#include <CGAL/Surface_mesh_constrictions/Shortest_path_verification.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/verify/Curve_nodes.h>
#include <CGAL/Surface_mesh_constrictions/internal/verify/Shortest_path_patch.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How far, in the unit of the patch, the path that CGAL finds may be from the arc, and, relative to its length, by how
// much the arc may be longer than CGAL's distance.
constexpr double verification_tolerance = 1e-9;

// The result of CGAL's search for one arc of a curve.
struct Arc_verdict
{
  Arc_refusal refusal;
  double excess;    // of length, relative
  double deviation; // in the unit of the patch
};

// Builds the patches of faces around the arcs of a curve and compares the arcs with the shortest paths in them.
template <class Kernel, class TriangleMesh, class VertexPointMap>
class Arc_verifier
{
  typedef Shortest_path_patch<Kernel> Patch;
  typedef typename Patch::Vertex Corner;
  typedef typename Patch::Event Event;
  typedef typename Patch::Position Position;
  typedef Curve_nodes<TriangleMesh> Nodes;
  typedef typename Nodes::Node Node;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  Arc_verifier(const TriangleMesh& tm, VertexPointMap vpm, const Nodes& nodes) : m_tm(tm), m_vpm(vpm), m_nodes(nodes) {}

  // The arc from node `first` to node `last`, between which there are only crossings, at least one, in the strip of the
  // faces that it passes. Linear in their number, plus CGAL's search.
  Arc_verdict verify_in_strip(std::size_t first, std::size_t last) const
  {
    Patch patch;
    const std::size_t begin = add_corner(patch, m_nodes[first]);
    const halfedge_descriptor entry = m_nodes[first + 1].halfedge;
    std::size_t s = add_corner(patch, source(entry, m_tm)), t = add_corner(patch, target(entry, m_tm)), end = begin;
    patch.add_face(s, t, begin);
    std::vector<std::array<std::size_t, 2>> crossed;
    for(std::size_t i = first + 1; i < last; ++i)
    {
      // the strip is its own surface: a face that it passes twice is in it twice
      crossed.push_back({{s, t}});
      const halfedge_descriptor o = opposite(m_nodes[i].halfedge, m_tm);
      end = i + 1 == last ? add_corner(patch, m_nodes[last]) : add_corner(patch, target(next(o, m_tm), m_tm));
      patch.add_face(t, s, end);
      (m_nodes[i + 1].halfedge == next(o, m_tm) ? t : s) = end;
    }
    if(!patch.build())
      return {Arc_refusal::NOT_A_PATH, 0, 0};

    std::vector<Event> arc;
    arc.push_back(corner_event(patch, begin));
    for(std::size_t i = first + 1; i < last; ++i)
    {
      const Corner a = patch.vertex(crossed[i - first - 1][0]), b = patch.vertex(crossed[i - first - 1][1]);
      arc.push_back({a, b, patch.point(a, b, m_nodes[i].parameter)});
    }
    arc.push_back(corner_event(patch, end));
    return compare(patch, arc);
  }

  // The arc from the node before to the node after the vertex at `node`, in the star of that vertex; on the boundary of
  // the mesh that is a fan, with the vertex on the boundary of the patch. Linear in the vertex's degree, plus CGAL's
  // search.
  Arc_verdict verify_in_star(std::size_t node) const
  {
    Patch patch;
    const vertex_descriptor v = m_nodes[node].vertex;
    const Node &before = m_nodes[node + m_nodes.size() - 1], &after = m_nodes[node + 1];
    const std::size_t centre = add_corner(patch, v);
    std::size_t begin = centre, end = centre;
    std::vector<std::size_t> link;
    halfedge_descriptor done = next(halfedge(v, m_tm), m_tm); // out of v
    bool is_on_boundary = false;
    for(halfedge_descriptor around : CGAL::halfedges_around_target(v, m_tm))
      if(CGAL::is_border(around, m_tm))
      {
        if(is_on_boundary) // of two holes
          return {Arc_refusal::NOT_A_PATH, 0, 0};
        is_on_boundary = true;
        done = opposite(around, m_tm);
      }
    halfedge_descriptor h = done;
    do
    {
      link.push_back(add_corner(patch, target(h, m_tm)));
      if(before.is_vertex && before.vertex == target(h, m_tm))
        begin = link.back();
      if(after.is_vertex && after.vertex == target(h, m_tm))
        end = link.back();
      if(CGAL::is_border(h, m_tm))
        break; // the last edge before the hole
      const halfedge_descriptor e = next(h, m_tm);
      const bool comes = !before.is_vertex && before.halfedge == opposite(e, m_tm);
      const bool leaves = !after.is_vertex && after.halfedge == e;
      const double from = 1 - before.parameter, to = after.parameter; // along e
      if(comes && leaves && std::abs(from - to) <= verification_tolerance)
        return {Arc_refusal::SHORTER_PATH, 1, 0}; // back where it came from
      if(comes && !(leaves && to < from))
        link.push_back(begin = add_corner(patch, before));
      if(leaves)
        link.push_back(end = add_corner(patch, after));
      if(comes && leaves && to < from)
        link.push_back(begin = add_corner(patch, before));
      h = opposite(prev(h, m_tm), m_tm);
    } while(h != done);
    if(begin == end)
      return {Arc_refusal::SHORTER_PATH, 1, 0};
    for(std::size_t i = 0; i + (is_on_boundary ? 1 : 0) < link.size(); ++i)
      patch.add_face(centre, link[i], link[(i + 1) % link.size()]);
    if(!patch.build())
      return {Arc_refusal::NOT_A_PATH, 0, 0};
    return compare(patch, {corner_event(patch, begin), corner_event(patch, centre), corner_event(patch, end)});
  }

private:
  Position position(vertex_descriptor v) const
  {
    const auto p = get(m_vpm, v);
    return {{nearest_double(p.x()), nearest_double(p.y()), nearest_double(p.z())}};
  }

  std::size_t add_corner(Patch& patch, vertex_descriptor v) const { return patch.add_corner(position(v)); }

  std::size_t add_corner(Patch& patch, const Node& node) const
  {
    if(node.is_vertex)
      return add_corner(patch, node.vertex);
    return patch.add_corner(position(source(node.halfedge, m_tm)), position(target(node.halfedge, m_tm)),
                            node.parameter);
  }

  static Event corner_event(const Patch& patch, std::size_t corner)
  {
    const Corner c = patch.vertex(corner);
    return {c, c, patch.point(c)};
  }

  typedef std::vector<Event> Events;

  // Compares the arc with the shortest path in the patch between its ends. It straddles one corner, or crosses edges.
  static Arc_verdict compare(Patch& patch, const Events& arc)
  {
    const typename Patch::Path path = patch.shortest_path(arc.front().source, arc.back().source);
    double length = 0;
    for(std::size_t i = 1; i < arc.size(); ++i)
      length += Patch::distance(arc[i - 1].point, arc[i].point);
    Arc_verdict verdict = {Arc_refusal::NONE, 0, 0};
    // written so that what is not a number is refused
    if(!(path.length >= 0 && length > 0))
    {
      verdict.refusal = Arc_refusal::NO_ANSWER;
      return verdict;
    }
    verdict.excess = (std::max)(0.0, (length - path.length) / length);
    const bool at_corner = arc[1].is_corner();
    if(!(length <= path.length * (1 + verification_tolerance)))
      verdict.refusal = Arc_refusal::SHORTER_PATH;
    else if(!(at_corner ? passes_at_corner(path.events, arc[1]) : crosses_same_edges(path.events, arc)))
      verdict.refusal = Arc_refusal::OTHER_FACES;
    else
    {
      verdict.deviation = at_corner ? distance_from_corner(path.events, arc[1]) : distance_from_arc(path.events, arc);
      if(!(verdict.deviation <= verification_tolerance))
        verdict.refusal = Arc_refusal::OTHER_PLACES;
    }
    return verdict;
  }

  static bool crosses_same_edges(const Events& path, const Events& arc)
  {
    if(path.size() != arc.size())
      return false;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      if(!path[i].is_on(arc[i].source, arc[i].target))
        return false;
    return true;
  }

  // Whether the path goes through the corner, or crosses nothing but edges of it: then all of it is in the faces of the
  // corner, and its distance from the corner says how far beside it it goes.
  static bool passes_at_corner(const Events& path, const Event& corner)
  {
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
      if(path[i].source != corner.source && path[i].target != corner.source)
        return false;
    return path.size() > 2;
  }

  static double distance_from_corner(const Events& path, const Event& corner)
  {
    double result = std::numeric_limits<double>::infinity();
    for(std::size_t i = 1; i < path.size(); ++i)
      result = (std::min)(result, Patch::distance(corner.point, path[i - 1].point, path[i].point));
    return result;
  }

  // The greatest distance of the path's crossings from the arc, across it: on an edge that the arc crosses at a
  // small angle, a crossing moves far along the arc for a small step beside it.
  static double distance_from_arc(const Events& path, const Events& arc)
  {
    double result = 0;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      result = (std::max)(result, (std::min)(Patch::distance(path[i].point, arc[i - 1].point, arc[i].point),
                                             Patch::distance(path[i].point, arc[i].point, arc[i + 1].point)));
    return result;
  }

  const TriangleMesh& m_tm;
  const VertexPointMap m_vpm;
  const Nodes& m_nodes;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_VERIFY_ARC_VERIFIER_H
