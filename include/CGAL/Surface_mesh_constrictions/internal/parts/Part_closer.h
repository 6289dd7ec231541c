// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_CLOSER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_CLOSER_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Opened_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/triangulate_cap.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Which loops on the borders of parts are closed.
struct Closed_loops
{
  bool along_curves, // those of marked edges only
      along_holes;   // those that are holes of the mesh, and those that run partly along one
};

// Closes all parts of a mesh that has been opened along marked edges, by caps that cancel: the volume that a cap adds
// to one part, caps of other parts take away.
//
// Where the border of a part touches itself it is divided into loops that pass each vertex once. If a loop runs along
// the same edges as a loop on their other side, both get the same triangles, turned over. Loops that share only some
// edges, as where curves share a stretch, get cones to one common point, the mean of all of their vertices: a cone over
// a sum of paths is the sum of the cones over them, and each of these paths occurs once in each direction. A hole of
// the mesh has nothing on its other side, and gets triangles of its own.
template <class TriangleMesh, class EdgeIsConstrainedMap, class VertexPointMap>
class Part_closer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

public:
  typedef Opened_mesh<TriangleMesh, EdgeIsConstrainedMap, VertexPointMap> Opened;
  typedef typename Opened::Point Point;

  struct Cap
  {
    std::size_t part;
    std::vector<halfedge_descriptor> border; // of the faces of the part, in order
    std::size_t first_triangle = 0, end_of_triangles = 0;
  };

  // Adds the caps to the parts, each of which has all of its faces. Linear in their size, plus the triangulations.
  Part_closer(const TriangleMesh& tm, EdgeIsConstrainedMap marks, VertexPointMap vpm,
              const std::vector<std::vector<typename Graph_traits::face_descriptor>>& faces_of_part,
              const Closed_loops& closed, std::vector<Opened>& parts)
    : m_tm(tm), m_marks(marks), m_vpm(vpm), m_closed(closed), m_parts(parts)
  {
    find_loops(faces_of_part);
    for(std::size_t i = 0; i < m_caps.size(); ++i)
      for(halfedge_descriptor h : m_caps[i].border)
        m_loop[h] = i;
    std::vector<std::size_t> alone;
    for(std::size_t i = 0; i < m_caps.size(); ++i)
    {
      const std::size_t twin = twin_of(i);
      if(twin == i)
        alone.push_back(i);
      else if(i < twin)
        close_with_same_triangles(i, twin);
    }
    close_alone(alone);
  }

  const std::vector<Cap>& caps() const { return m_caps; }

private:
  bool is_marked(halfedge_descriptor h) const { return get(m_marks, edge(h, m_tm)); }

  bool is_on_border(halfedge_descriptor h) const { return is_marked(h) || CGAL::is_border_edge(h, m_tm); }

  // The halfedge after h along the border of its part.
  halfedge_descriptor next_on_border(halfedge_descriptor h) const
  {
    h = next(h, m_tm);
    while(!is_on_border(h))
      h = next(opposite(h, m_tm), m_tm);
    return h;
  }

  // A curve along the whole boundary of a hole cuts nothing off there, so the loop is a hole.
  bool is_along_curves(const std::vector<halfedge_descriptor>& border) const
  {
    return std::all_of(border.begin(), border.end(), [this](halfedge_descriptor h) { return is_marked(h); }) &&
           std::any_of(border.begin(), border.end(),
                       [this](halfedge_descriptor h) { return !CGAL::is_border_edge(h, m_tm); });
  }

  void find_loops(const std::vector<std::vector<typename Graph_traits::face_descriptor>>& faces_of_part)
  {
    std::unordered_set<halfedge_descriptor> is_seen;
    for(std::size_t part = 0; part < faces_of_part.size(); ++part)
      for(auto f : faces_of_part[part])
      {
        halfedge_descriptor h = halfedge(f, m_tm);
        for(int i = 0; i < 3; ++i, h = next(h, m_tm))
        {
          if(!is_on_border(h) || is_seen.count(h) > 0)
            continue;
          std::vector<halfedge_descriptor> border;
          for(halfedge_descriptor b = h; is_seen.insert(b).second; b = next_on_border(b))
            border.push_back(b);
          if(is_along_curves(border) ? m_closed.along_curves : m_closed.along_holes)
            add_loops(part, border);
        }
      }
  }

  // Divides a border where it comes back to a vertex, unless a face of a cap would then have two corners only, as for a
  // path that runs to and fro.
  //
  // No two loops have more than one vertex of the part in common, so the caps of two have no diagonal in common: when a
  // loop is taken off, all of its vertices but the one where it closes leave `open`, and the border that passes them
  // later passes copies that are not merged with theirs. Different borders have no copy in common.
  void add_loops(std::size_t part, const std::vector<halfedge_descriptor>& border)
  {
    std::vector<std::vector<halfedge_descriptor>> loops;
    std::vector<halfedge_descriptor> open;
    std::unordered_map<vertex_descriptor, std::size_t> place; // in `open`, of the halfedge that begins at a vertex
    for(halfedge_descriptor h : border)
    {
      place[source(h, m_tm)] = open.size();
      open.push_back(h);
      const auto begin = place.find(target(h, m_tm));
      if(begin == place.end())
        continue;
      const std::size_t first = begin->second;
      loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
      for(halfedge_descriptor o : loops.back())
        place.erase(source(o, m_tm));
      open.resize(first);
    }
    if(std::any_of(loops.begin(), loops.end(), [](const auto& l) { return l.size() < 3; }))
      loops = {border};
    else
      for(const auto& l : loops)
        m_parts[part].merge(corner_at_source(part, l.front()), m_parts[part].vertex(l.back()));
    for(auto& l : loops)
    {
      m_caps.emplace_back();
      m_caps.back().part = part;
      m_caps.back().border.swap(l);
    }
  }

  // The vertex of a part at the beginning of a halfedge of its faces.
  std::size_t corner_at_source(std::size_t part, halfedge_descriptor h) { return m_parts[part].vertex(prev(h, m_tm)); }

  // The loop on the other side of a halfedge of loop i; i if that side stays open.
  std::size_t loop_across(halfedge_descriptor h, std::size_t i) const
  {
    const auto found = m_loop.find(opposite(h, m_tm));
    return found == m_loop.end() ? i : found->second;
  }

  static bool passes_each_vertex_once(const std::vector<halfedge_descriptor>& border, const TriangleMesh& tm)
  {
    std::unordered_set<vertex_descriptor> passed;
    return std::all_of(border.begin(), border.end(),
                       [&](halfedge_descriptor h) { return passed.insert(target(h, tm)).second; });
  }

  // The loop that runs along the same edges on their other side, the number itself if there is none. Loops that pass a
  // vertex twice have none.
  std::size_t twin_of(std::size_t i) const
  {
    const std::vector<halfedge_descriptor>& border = m_caps[i].border;
    const std::size_t twin = loop_across(border.front(), i);
    const bool is_common =
        std::all_of(border.begin(), border.end(), [&](halfedge_descriptor h) { return loop_across(h, i) == twin; });
    return is_common && m_caps[twin].border.size() == border.size() && passes_each_vertex_once(border, m_tm) ? twin : i;
  }

  bool is_around_one_face(halfedge_descriptor h, std::size_t size) const
  {
    return size == 3 && !is_border(h, m_tm) && is_on_border(next(h, m_tm)) && is_on_border(prev(h, m_tm));
  }

  // The triangles of a cap, by places in its border. None if none are found, and if there is a face already where the
  // only one would be.
  Cap_triangles triangles_on(const std::vector<halfedge_descriptor>& border) const
  {
    const std::size_t n = border.size();
    if(is_around_one_face(border[0], n) || is_around_one_face(opposite(border[0], m_tm), n))
      return {};
    Cap_polygon polygon;
    for(halfedge_descriptor h : border)
      polygon.push_back(nearest_point(get(m_vpm, target(h, m_tm))));
    // a diagonal that is already an edge of a part would make the part non-manifold
    return triangulate_cap(polygon, [&](std::size_t a, std::size_t b) {
      return halfedge(target(border[a], m_tm), target(border[b], m_tm), m_tm).second;
    });
  }

  void close_with_triangles(std::size_t i, const Cap_triangles& triangles)
  {
    const std::vector<halfedge_descriptor>& border = m_caps[i].border;
    Opened& part = m_parts[m_caps[i].part];
    begin_cap(i);
    for(const auto& t : triangles)
      part.add_triangle({{part.vertex(border[t[2]]), part.vertex(border[t[1]]), part.vertex(border[t[0]])}});
    end_cap(i);
  }

  void close_with_same_triangles(std::size_t i, std::size_t twin)
  {
    const std::vector<halfedge_descriptor>& border = m_caps[i].border;
    const std::size_t n = border.size();
    const auto opposite_of_next = [&](std::size_t k) { return opposite(border[(k + 1) % n], m_tm); };
    const Cap_triangles triangles = triangles_on(border);
    if(triangles.empty())
    {
      const Point apex = mean({i});
      close_with_cone(i, apex);
      close_with_cone(twin, apex);
      return;
    }
    close_with_triangles(i, triangles);
    Opened& other = m_parts[m_caps[twin].part];
    begin_cap(twin);
    for(const auto& t : triangles)
      other.add_triangle({{other.vertex(opposite_of_next(t[0])), other.vertex(opposite_of_next(t[1])),
                           other.vertex(opposite_of_next(t[2]))}});
    end_cap(twin);
  }

  // A hole gets triangles if there are any. Loops that are connected by shared edges get cones with a common apex.
  void close_alone(const std::vector<std::size_t>& loops)
  {
    std::unordered_set<std::size_t> is_seen;
    for(std::size_t first : loops)
    {
      if(!is_seen.insert(first).second)
        continue;
      std::vector<std::size_t> group = {first};
      for(std::size_t k = 0; k < group.size(); ++k)
        for(std::size_t e = 0; e < m_caps[group[k]].border.size(); ++e)
        {
          const std::size_t neighbour = loop_across(m_caps[group[k]].border[e], group[k]);
          if(is_seen.insert(neighbour).second)
            group.push_back(neighbour);
        }
      if(group.size() == 1 && close_as_hole(first))
        continue;
      const Point apex = mean(group);
      for(std::size_t i : group)
        close_with_cone(i, apex);
    }
  }

  // Returns whether the loop is a hole and has been closed.
  bool close_as_hole(std::size_t i)
  {
    const std::vector<halfedge_descriptor>& border = m_caps[i].border;
    const bool is_hole = std::all_of(border.begin(), border.end(),
                                     [this](halfedge_descriptor h) { return CGAL::is_border_edge(h, m_tm); });
    if(!is_hole || !passes_each_vertex_once(border, m_tm))
      return false;
    const Cap_triangles triangles = triangles_on(border);
    if(!triangles.empty())
      close_with_triangles(i, triangles);
    return !triangles.empty();
  }

  Point mean(const std::vector<std::size_t>& loops) const
  {
    typedef typename Kernel_traits<Point>::Kernel Kernel;
    typename Kernel::Vector_3 sum = NULL_VECTOR;
    typename Kernel::FT n = 0;
    for(std::size_t i : loops)
      for(halfedge_descriptor h : m_caps[i].border)
      {
        sum = sum + (get(m_vpm, target(h, m_tm)) - Point(ORIGIN));
        n += 1;
      }
    return Point(ORIGIN) + sum / n;
  }

  void close_with_cone(std::size_t i, const Point& apex)
  {
    Opened& part = m_parts[m_caps[i].part];
    const std::size_t centre = part.add_vertex(apex);
    begin_cap(i);
    for(halfedge_descriptor h : m_caps[i].border)
      part.add_triangle({{part.vertex(h), corner_at_source(m_caps[i].part, h), centre}});
    end_cap(i);
  }

  void begin_cap(std::size_t i) { m_caps[i].first_triangle = m_parts[m_caps[i].part].number_of_triangles(); }
  void end_cap(std::size_t i) { m_caps[i].end_of_triangles = m_parts[m_caps[i].part].number_of_triangles(); }

  const TriangleMesh& m_tm;
  EdgeIsConstrainedMap m_marks;
  VertexPointMap m_vpm;
  Closed_loops m_closed;
  std::vector<Opened>& m_parts;
  std::vector<Cap> m_caps;
  std::unordered_map<halfedge_descriptor, std::size_t> m_loop; // of a halfedge on a border
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_PART_CLOSER_H
