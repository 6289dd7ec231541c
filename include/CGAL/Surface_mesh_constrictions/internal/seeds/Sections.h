// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SECTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SECTIONS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/canonical_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Level sets of functions on the vertices of the current surface, as closed paths of edges: the boundary loops of the
// faces none of whose vertices is above the level. Where a loop and one of the next level bound a tube between them,
// only the one is written beside which the level set is shorter, so the shortest of a tube. Where a constriction lies
// aslant in a tube that only gets wider, none of the sections may be the shortest; so every seventh level is written as
// a whole.
//
// A level that meets a hole is an open line. It is closed along the boundary of the hole, in both ways, one after the
// other: all of the hole is above the level until it has passed the highest vertex of the hole, or below from the
// lowest one on.
class Sections
{
public:
  // Makes a compact copy of the current surface, whose vertices have the numbers that they have in the graph. O(size of
  // T^0) for the ids, and linear in the size of the current surface.
  Sections(const Progressive_mesh& pm, const Edge_graph& graph)
    : m_graph(graph), m_slab_of_vertex(graph.number_of_vertices(), 0)
  {
    std::vector<Index> vertex(pm.number_of_vertex_ids(), null_index), face(pm.number_of_face_ids(), null_index), faces;
    for(Index v = 0; v < graph.number_of_vertices(); ++v)
    {
      vertex[graph.id(v)] = v;
      m_position.push_back(position(pm, graph.id(v)));
    }
    // ghosts come last
    for(Index v = 0, holes = 0; holes < pm.number_of_holes(); ++v)
      if(pm.is_ghost_vertex(v))
      {
        vertex[v] = static_cast<Index>(graph.number_of_vertices()) + holes;
        ++holes;
      }
    m_slab_of_hole.resize(pm.number_of_holes());
    for(Index f = 0; f < pm.number_of_face_ids(); ++f)
      if(pm.is_face(f))
      {
        face[f] = static_cast<Index>(faces.size());
        m_first_ghost_face += pm.is_ghost_face(f) ? 0 : 1;
        faces.push_back(f);
      }
    for(Index f : faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index opposite = pm.opposite(h);
        m_source.push_back(vertex[pm.source(h)]);
        m_opposite.push_back(3 * face[pm.face(opposite)] + opposite % 3);
      }
    m_slab.resize(faces.size());
    m_is_walked.resize(m_source.size(), 0);
    m_loop_at.resize(m_source.size(), 0);
  }

  // Calls write(loop), a canonical closed path of vertex ids, for the loops of the given number of levels, at equal
  // distances from the least value to the greatest. Values are given by number in the graph; those that are not finite
  // are above all levels. O(faces), plus the loops.
  template <class Write>
  void cut(const std::vector<double>& values, std::size_t levels, const Write& write)
  {
    cut(values, levels, true, write);
    if(!m_slab_of_hole.empty())
      cut(values, levels, false, write);
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  static constexpr Index sample_distance = 7; // in levels

  template <class Write>
  void cut(const std::vector<double>& values, std::size_t levels, bool holes_are_above, const Write& write)
  {
    if(!make_slabs(values, levels, holes_are_above))
      return;
    m_loops.clear();
    std::size_t below = 0; // the first loop of the level before
    for(Index i = 0; i < levels; ++i)
    {
      const std::size_t first = m_loops.size();
      ++m_stamp;
      for(Index h : m_boundary[i])
        if(m_is_walked[h] != m_stamp)
          walk(h, i, values);
      drop_longer(i, below, first);
      below = first;
    }
    for(const Loop& loop : m_loops)
    {
      if(!(loop.is_shortest || loop.is_sample) || loop.halfedges.size() < 3)
        continue;
      std::vector<Index> path;
      for(Index h : loop.halfedges)
        path.push_back(m_graph.id(m_source[h]));
      make_canonical(path);
      write(std::move(path));
    }
  }

  struct Loop
  {
    std::vector<Index> halfedges; // with a face below the level on the left
    double length;                // of the level set beside it: a loop of edges zigzags
    bool is_shortest;
    bool is_sample;
  };

  // Distributes the faces to the slabs, each up to a level and not further, the last one above all levels, and the
  // halfedges between faces of different slabs to the levels. False for a function that is constant.
  bool make_slabs(const std::vector<double>& values, std::size_t levels, bool holes_are_above)
  {
    double least = infinity, greatest = -infinity;
    for(double value : values)
      if(std::isfinite(value))
      {
        least = (std::min)(least, value);
        greatest = (std::max)(greatest, value);
      }
    if(!(least < greatest))
      return false;

    const double step = (greatest - least) / static_cast<double>(levels);
    m_value.resize(levels);
    for(std::size_t i = 0; i < levels; ++i)
      m_value[i] = least + (greatest - least) * ((static_cast<double>(i) + 0.5) / static_cast<double>(levels));
    m_faces_of_slab.resize(levels + 1);
    m_boundary.resize(levels);
    for(std::vector<Index>& faces : m_faces_of_slab)
      faces.clear();
    for(std::vector<Index>& halfedges : m_boundary)
      halfedges.clear();
    for(Index v = 0; v < values.size(); ++v)
    {
      Index i = static_cast<Index>(levels);
      if(std::isfinite(values[v]))
      {
        const double position = (values[v] - least) / step - 0.5;
        i = position <= 0 ? 0 : (std::min)(static_cast<Index>(position), i);
        while(i < levels && m_value[i] < values[v])
          ++i;
      }
      m_slab_of_vertex[v] = i;
    }
    if(!m_slab_of_hole.empty())
      place_holes(levels, holes_are_above);
    for(Index f = 0; f < m_slab.size(); ++f)
    {
      if(is_ghost(f))
        m_slab[f] = m_slab_of_hole[hole(f)];
      else
        m_slab[f] = (std::max)({m_slab_of_vertex[m_source[3 * f]], m_slab_of_vertex[m_source[3 * f + 1]],
                                m_slab_of_vertex[m_source[3 * f + 2]]});
      m_faces_of_slab[m_slab[f]].push_back(f);
    }
    for(Index h = 0; h < m_source.size(); ++h)
      for(Index i = m_slab[h / 3]; i < m_slab[face_across(h)]; ++i)
        m_boundary[i].push_back(h);
    return true;
  }

  bool is_ghost(Index f) const { return f >= m_first_ghost_face; }

  // the number of the hole that a ghost face belongs to
  Index hole(Index f) const
  {
    const Index n = static_cast<Index>(m_graph.number_of_vertices());
    return (std::max)({m_source[3 * f], m_source[3 * f + 1], m_source[3 * f + 2]}) - n;
  }

  // Puts each hole as a whole into the slab of its highest vertex, or of its lowest one.
  void place_holes(std::size_t levels, bool holes_are_above)
  {
    const Index n = static_cast<Index>(m_graph.number_of_vertices());
    std::fill(m_slab_of_hole.begin(), m_slab_of_hole.end(), holes_are_above ? 0 : static_cast<Index>(levels));
    for(Index f = m_first_ghost_face; f < m_slab.size(); ++f)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(m_source[h] < n)
        {
          Index& slab = m_slab_of_hole[hole(f)];
          const Index at_vertex = m_slab_of_vertex[m_source[h]];
          slab = holes_are_above ? (std::max)(slab, at_vertex) : (std::min)(slab, at_vertex);
        }
  }

  Index target(Index h) const { return m_source[Corner_table::next(h)]; }
  Index ccw(Index h) const { return m_opposite[Corner_table::prev(h)]; }
  Index face_across(Index h) const { return m_opposite[h] / 3; }

  // Follows the boundary of the faces below a level, which lie on its left, once around, along the boundary of one
  // and the same fan of faces at each vertex, and the level set on its right.
  void walk(Index begin, Index level, const std::vector<double>& values)
  {
    m_loops.push_back({{}, 0, true, level % sample_distance == sample_distance / 2});
    Loop& loop = m_loops.back();
    m_level_set.clear();
    Index h = begin;
    do
    {
      m_is_walked[h] = m_stamp;
      loop.halfedges.push_back(h);
      // the edges on the right at the end of h, counterclockwise; the first one leads above the level
      for(Index up = ccw(m_opposite[h]); m_slab[up / 3] > level; up = ccw(up))
        if(target(up) < m_slab_of_vertex.size() && m_slab_of_vertex[target(up)] > level)
          m_level_set.push_back(point_of_level(up, level, values));
      if(is_ghost(h / 3) || is_ghost(face_across(h))) // along the boundary of a hole
        m_level_set.push_back(m_position[target(h)]);
      h = Corner_table::next(h);
      while(m_slab[face_across(h)] <= level)
        h = Corner_table::next(m_opposite[h]);
    } while(h != begin);
    for(std::size_t i = 0; i < m_level_set.size(); ++i)
      loop.length += norm(m_level_set[(i + 1) % m_level_set.size()] - m_level_set[i]);
  }

  // Where a function has the value of a level on an edge that leads from no more to more; at a hole the edge may be
  // above the level as a whole.
  Vector3 point_of_level(Index h, Index level, const std::vector<double>& values) const
  {
    const Index u = m_source[h], v = target(h);
    const double value = m_value[level];
    if(m_slab_of_vertex[u] > level)
      return m_position[u];
    const double t = std::isfinite(values[v]) ? (value - values[u]) / (values[v] - values[u]) : 0;
    return m_position[u] + t * (m_position[v] - m_position[u]);
  }

  // Where a loop of a level and one of the level before bound a part of the slab between them, and no third one does,
  // drops the longer. Those of the level before are [below, first), those of the level are the rest.
  void drop_longer(Index level, std::size_t below, std::size_t first)
  {
    const Index offset = static_cast<Index>(m_slab.size()); // of loops behind faces
    const Index size = offset + static_cast<Index>(m_loops.size() - below);
    if(m_parent.size() < size)
    {
      m_parent.resize(size);
      m_rank.resize(size);
    }
    // not the pointers themselves: what Boost has for them is found only if it is included before the sets
    const boost::typed_identity_property_map<Index> itself;
    const auto rank = boost::make_iterator_property_map(m_rank.data(), itself);
    const auto parent = boost::make_iterator_property_map(m_parent.data(), itself);
    boost::disjoint_sets<std::decay_t<decltype(rank)>, std::decay_t<decltype(parent)>> parts(rank, parent);
    const auto number = [&](std::size_t loop) { return offset + static_cast<Index>(loop - below); };
    for(Index f : m_faces_of_slab[level])
      parts.make_set(f);
    for(std::size_t k = below; k < m_loops.size(); ++k)
      parts.make_set(number(k));
    for(Index f : m_faces_of_slab[level])
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(face_across(h) < f && m_slab[face_across(h)] == level)
          parts.union_set(f, face_across(h));
    for(std::size_t k = below; k < first; ++k)
      for(Index h : m_loops[k].halfedges)
      {
        m_loop_at[h] = number(k);
        if(m_slab[face_across(h)] == level)
          parts.union_set(number(k), face_across(h));
      }
    for(std::size_t k = first; k < m_loops.size(); ++k)
      for(Index h : m_loops[k].halfedges) // where the slab is no wider than the edge, both loops run along it
        parts.union_set(number(k), m_slab[h / 3] == level ? h / 3 : m_loop_at[h]);

    m_loops_of_parts.clear();
    for(std::size_t k = below; k < m_loops.size(); ++k)
      m_loops_of_parts.emplace_back(parts.find_set(number(k)), k);
    std::sort(m_loops_of_parts.begin(), m_loops_of_parts.end());
    for(auto it = m_loops_of_parts.begin(), end = it; it != m_loops_of_parts.end(); it = end)
    {
      end = std::find_if(it, m_loops_of_parts.end(), [it](const auto& p) { return p.first != it->first; });
      if(end - it != 2 || it->second >= first || it[1].second < first)
        continue;
      Loop &a = m_loops[it->second], &b = m_loops[it[1].second];
      a.is_shortest = a.is_shortest && a.length <= b.length;
      b.is_shortest = b.is_shortest && b.length <= a.length;
    }
  }

  const Edge_graph& m_graph;
  std::vector<Index> m_source, m_opposite; // of halfedges, three for each face
  std::vector<Vector3> m_position;         // of vertices
  std::vector<double> m_value;             // of levels
  std::vector<Index> m_slab_of_vertex;     // that in which it is or whose upper level it is on
  std::vector<Index> m_slab;               // of faces
  std::vector<Index> m_slab_of_hole;       // of the ghosts of a hole
  Index m_first_ghost_face = 0;            // the number of faces that are no ghosts
  std::vector<std::vector<Index>> m_faces_of_slab;
  std::vector<std::vector<Index>> m_boundary; // of a level: halfedges of faces not above it, next to faces that are
  std::vector<Loop> m_loops;                  // from the lowest level to the highest
  std::vector<Vector3> m_level_set;
  std::vector<std::size_t> m_is_walked; // of halfedges: the stamp of the last walk along them
  std::size_t m_stamp = 0;              // of a level
  std::vector<Index> m_parent;          // the parts of a slab as disjoint sets of faces and loops
  std::vector<Index> m_loop_at;         // of halfedges
  std::vector<std::uint8_t> m_rank;
  std::vector<std::pair<Index, std::size_t>> m_loops_of_parts;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_SECTIONS_H
