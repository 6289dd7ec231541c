// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_PROGRESSIVE_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_PROGRESSIVE_MESH_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/floating_point_requirements.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/prefetch.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// An edge collapse: the vertex `removed` is merged into its neighbour `kept`, which moves to `point`.
struct Edge_collapse
{
  Index removed;                                                ///< the vertex that is merged into the other one
  Index kept;                                                   ///< the vertex that is left
  Exact_predicates_inexact_constructions_kernel::Point_3 point; ///< where `kept` is after the collapse
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A triangle mesh T^0 and a sequence of edge collapses T^0 -> T^1 -> ... -> T^n. One of these surfaces is current:
/// T^k, where k is the *level*.
///
/// The contract:
///
/// 1. *Levels.* `collapse()` goes from T^k to T^(k+1), `split()` back from T^(k+1) to T^k, and `go_to_level()` repeats
///    either. `append_collapse()` and `append_collapses()` make the sequence longer, on T^n only. All other functions
///    are const.
/// 2. *Exact restoration.* Whatever way leads to T^k, its connectivity, the halfedge `outgoing(v)` of each vertex, and
///    the positions are the same bit for bit.
/// 3. *Ids.* An id of a vertex, halfedge or face names the same element at every level. Ids are 0, 1, ... up to the
///    number of elements of T^0; a collapse creates no element. Face `f` has the halfedges `3 f`, `3 f + 1` and
///    `3 f + 2`, counterclockwise.
/// 4. *Elements that are out.* An element that a collapse has taken out keeps its id and its own pointers, and the
///    split links it in again, as in dancing links. `is_vertex()` and `is_face()` tell whether an element is in; the
///    functions of connectivity are for elements that are.
/// 5. *Closed surface.* Each hole of a mesh with boundary is closed by one more vertex, joined to the edges of the hole
///    by faces: *ghosts*, numbered after all other vertices and faces, and the same at every level. They have no area,
///    no curve enters them, and their angles are infinite.
/// 6. *What the caller sees to.* Each collapse keeps the surface a 2-manifold (the link condition), and neither moves
///    nor removes a ghost vertex. This is not checked.
/// 7. *Cost.* A level costs O(degree) to go up and O(degree) to go down. Memory: 24 bytes a face and 28 bytes a vertex
///    for T^0, 4 bytes a face and a vertex for the last level that has it, and 32 bytes a collapse.
/// 8. *Threads.* Several threads may call const functions at a time.
class Progressive_mesh
{
public:
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point; ///< of double coordinates

private:
  // While the collapse is undone, `point` is where the kept vertex will move; while it is applied, where it was.
  // The bits of `outgoing` tell which outgoing halfedges of vertices went out with the two faces.
  struct Record
  {
    Point point;
    Index halfedge;
    Index outgoing;
  };

public:
  /// The elements that a vertex split put in, or a collapse took out: the edge from `removed` to `kept` and the two
  /// faces at it. `left` is the halfedge from `removed` to `kept`, `right` its opposite; each is the first of its face.
  struct Split
  {
    Index removed; ///< a vertex
    Index kept;    ///< a vertex
    Index left;    ///< a halfedge
    Index right;   ///< a halfedge
  };

  /// \param table the connectivity of T^0
  /// \param points the position of each of its vertices
  Progressive_mesh(internal::Corner_table table, std::vector<Point> points)
    : m_table(std::move(table)), m_points(std::move(points)), m_vertex_end(m_points.size(), null_index),
      m_face_end(m_table.halfedges.size() / 3, null_index)
  {
    for(std::size_t v = 0; v < m_points.size() && v < m_table.first_ghost_vertex; ++v)
      m_number_of_vertices += m_table.outgoing[v] != null_index;
  }

  /// \name Levels
  /// @{

  /// the number k of collapses that have been applied: the current surface is T^k
  std::size_t level() const { return m_level; }

  /// the number n of collapses of the sequence
  std::size_t number_of_collapses() const { return m_records.size(); }

  /// the bytes that a collapse takes beyond the connectivity and positions of T^0: its record, and the last levels of
  /// the vertex and the two faces that it takes out
  static constexpr std::size_t bytes_per_collapse() { return sizeof(Record) + 3 * sizeof(Index); }

  /// appends a collapse to the sequence and applies it.
  /// \pre `level() == number_of_collapses()`, `removed` and `kept` are joined by an edge whose collapse keeps the
  /// surface a 2-manifold (the link condition)
  void append_collapse(const Edge_collapse& c)
  {
    CGAL_precondition(m_level == m_records.size());
    const Index h = halfedge(c.removed, c.kept);
    CGAL_precondition(h != null_index);
    m_records.push_back(Record{c.point, h, 0});
    m_vertex_end[c.removed] = m_face_end[face(h)] = m_face_end[face(opposite(h))] = static_cast<Index>(m_level);
    collapse();
  }

  /// appends collapses and applies them, one after the other, and calls `f(collapse)` after each. Stops when `f`
  /// returns false.
  /// \pre that of `append_collapse()`, for each
  template <class Function>
  void append_collapses(const std::vector<Edge_collapse>& collapses, const Function& f)
  {
    m_records.reserve(m_records.size() + collapses.size());
    for(std::size_t i = 0; i < collapses.size(); ++i)
    {
      prefetch_after(collapses, i);
      append_collapse(collapses[i]);
      if(!f(collapses[i]))
        return;
    }
  }

  /// goes from T^k to T^(k+1).
  /// \pre `level() < number_of_collapses()`
  Split collapse()
  {
    CGAL_precondition(m_level < m_records.size());
    Record& record = m_records[m_level++];
    const Split s = split_of(record);
    const Sides x = sides(s);

    // the faces around `removed`, but the two that go, now have a corner at `kept`
    for(Index r = x.b; r != next(s.right); r = ccw(r))
      m_table.halfedges[r].source = s.kept;

    record.outgoing = 0;
    leave(s.kept, next(s.left), x.b, 1u, record);
    leave(s.kept, s.right, x.b, 2u, record);
    leave(source(prev(s.left)), prev(s.left), x.a, 4u, record);
    leave(source(prev(s.right)), prev(s.right), x.c, 8u, record);

    glue(x.a, x.b);
    glue(x.c, x.d);
    std::swap(m_points[s.kept], record.point);
    return s;
  }

  /// goes from T^k to T^(k-1).
  /// \pre `level() > 0`
  Split split()
  {
    CGAL_precondition(m_level > 0);
    Record& record = m_records[--m_level];
    const Split s = split_of(record);
    const Sides x = sides(s);

    std::swap(m_points[s.kept], record.point);
    glue(x.d, prev(s.right));
    glue(x.c, next(s.right));
    glue(x.b, prev(s.left));
    glue(x.a, next(s.left));

    if(record.outgoing & 8u)
      m_table.outgoing[source(prev(s.right))] = prev(s.right);
    if(record.outgoing & 4u)
      m_table.outgoing[source(prev(s.left))] = prev(s.left);
    if(record.outgoing & 2u)
      m_table.outgoing[s.kept] = s.right;
    if(record.outgoing & 1u)
      m_table.outgoing[s.kept] = next(s.left);

    for(Index r = x.b; r != next(s.right); r = ccw(r))
      m_table.halfedges[r].source = s.removed;
    return s;
  }

  /// goes to T^k, one collapse or split after the other.
  /// \pre `k <= number_of_collapses()`
  void go_to_level(std::size_t k)
  {
    CGAL_precondition(k <= m_records.size());
    while(m_level < k)
      collapse();
    while(m_level > k)
      split();
  }

  /// the elements that the next `split()` will put in.
  /// \pre `level() > 0`
  Split next_split() const { return split_of(m_records[m_level - 1]); }

  /// the elements that the collapse from T^k to T^(k+1) has taken out.
  /// \pre `k < level()`
  Split applied_collapse(std::size_t k) const { return split_of(m_records[k]); }

  /// @}
  /// \name Elements
  /// Ids run from 0 to the number of elements of T^0; not all are part of the current surface.
  /// @{

  /// the number of vertices of the current surface that are neither isolated nor ghosts
  std::size_t number_of_vertices() const { return m_number_of_vertices - m_level; }

  /// the coarsest level with at least `vertices` vertices; 0 if no level has as many
  std::size_t level_with(std::size_t vertices) const
  {
    return (std::min)(m_number_of_vertices > vertices ? m_number_of_vertices - vertices : 0, m_records.size());
  }

  /// the number of vertices of T^0, isolated ones and ghosts included
  std::size_t number_of_vertex_ids() const { return m_points.size(); }

  /// the number of faces of T^0, ghosts included
  std::size_t number_of_face_ids() const { return m_face_end.size(); }

  /// the number of halfedges of T^0
  std::size_t number_of_halfedge_ids() const { return m_table.halfedges.size(); }

  /// whether `v` is a vertex of the current surface that is not isolated
  bool is_vertex(Index v) const { return m_vertex_end[v] >= m_level && m_table.outgoing[v] != null_index; }
  /// whether `f` is a face of the current surface
  bool is_face(Index f) const { return m_face_end[f] >= m_level; }

  /// whether the mesh has a boundary
  bool has_boundary() const { return m_table.first_ghost_vertex != null_index; }
  /// the number of holes, each of which has one ghost vertex
  std::size_t number_of_holes() const { return has_boundary() ? m_points.size() - m_table.first_ghost_vertex : 0; }
  /// whether `v` is the ghost vertex of a hole
  bool is_ghost_vertex(Index v) const { return v >= m_table.first_ghost_vertex; }
  /// whether `f` is a face of a ghost vertex
  bool is_ghost_face(Index f) const { return f >= m_table.first_ghost_face; }

  /// the vertex of the current surface that the vertex `v` of T^0 has been merged into. Linear in the number of its
  /// merges.
  Index representative(Index v) const
  {
    while(m_vertex_end[v] < m_level)
      v = split_of(m_records[m_vertex_end[v]]).kept;
    return v;
  }

  /// the position of a vertex on the current surface
  const Point& point(Index v) const { return m_points[v]; }

  /// the positions of all vertices, those included that are out
  const std::vector<Point>& points() const { return m_points; }

  /// @}
  /// \name Connectivity
  /// Of elements of the current surface.
  /// @{

  /// the next halfedge of the same face, counterclockwise
  static Index next(Index h) { return internal::Corner_table::next(h); }

  /// the previous halfedge of the same face
  static Index prev(Index h) { return internal::Corner_table::prev(h); }

  /// the face of a halfedge
  static Index face(Index h) { return h / 3; }

  /// the other halfedge of the same edge
  Index opposite(Index h) const { return m_table.halfedges[h].opposite; }

  /// the vertex that a halfedge comes from
  Index source(Index h) const { return m_table.halfedges[h].source; }

  /// the vertex that a halfedge leads to
  Index target(Index h) const { return m_table.halfedges[next(h)].source; }

  /// the smaller halfedge of an edge, the same for both
  Index edge(Index h) const { return (std::min)(h, opposite(h)); }

  /// a halfedge out of `v`, or `null_index` if `v` is isolated
  Index outgoing(Index v) const { return m_table.outgoing[v]; }

  /// the halfedge out of `source(h)` that follows `h` counterclockwise
  Index ccw(Index h) const { return opposite(prev(h)); }

  /// the halfedge out of `source(h)` that follows `h` clockwise
  Index cw(Index h) const { return next(opposite(h)); }

  /// whether the edge of a halfedge is on the boundary: whether one of its two faces is a ghost
  bool is_on_boundary(Index h) const { return is_ghost_face(face(h)) != is_ghost_face(face(opposite(h))); }

  /// a halfedge out of `v` that lies in a ghost face and on the boundary, so that the hole is on its left; `null_index`
  /// if `v` is not on the boundary. Linear in the degree of `v` on surfaces with boundary.
  Index along_hole(Index v) const
  {
    const Index begin = has_boundary() ? outgoing(v) : null_index;
    for(Index h = begin; h != null_index;)
    {
      if(is_ghost_face(face(h)) && !is_ghost_face(face(opposite(h))))
        return h;
      h = ccw(h);
      if(h == begin)
        break;
    }
    return null_index;
  }

  /// the connectivity of all elements, those included that are out
  const internal::Corner_table& connectivity() const { return m_table; }

  /// the halfedge from `u` to `v`, or `null_index`. Linear in the degree of `u`.
  Index halfedge(Index u, Index v) const
  {
    const Index begin = outgoing(u);
    Index h = begin;
    do
    {
      if(target(h) == v)
        return h;
      h = ccw(h);
    } while(h != begin);
    return null_index;
  }

  /// @}

private:
  // The outer sides of the four edges of the two faces: a faces next(left), b faces prev(left), c faces next(right)
  // and d faces prev(right).
  struct Sides
  {
    Index a, b, c, d;
  };

  // Fetches what the collapses soon after number i are going to touch: on a large mesh most of the time is spent
  // waiting for it. Each step needs what the one before it has fetched for the same collapse some collapses ago.
  void prefetch_after(const std::vector<Edge_collapse>& collapses, std::size_t i) const
  {
    const std::size_t ahead = 8;
    if(i + 3 * ahead < collapses.size())
    {
      const Edge_collapse& c = collapses[i + 3 * ahead];
      internal::prefetch(m_points[c.kept]);
      internal::prefetch(m_vertex_end[c.removed]);
      internal::prefetch(m_table.outgoing[c.removed]);
      internal::prefetch(m_table.outgoing[c.kept]);
    }
    if(i + 2 * ahead < collapses.size())
    {
      const Edge_collapse& c = collapses[i + 2 * ahead];
      internal::prefetch(m_face_end[face(outgoing(c.removed))]);
      internal::prefetch(m_table.halfedges[outgoing(c.removed)]);
      internal::prefetch(m_table.halfedges[outgoing(c.kept)]);
    }
    if(i + ahead < collapses.size())
    {
      const Edge_collapse& c = collapses[i + ahead];
      internal::prefetch(m_table.halfedges[opposite(outgoing(c.removed))]);
      internal::prefetch(m_table.halfedges[ccw(outgoing(c.removed))]);
    }
  }

  Split split_of(const Record& r) const
  {
    const Index right = opposite(r.halfedge);
    return Split{source(r.halfedge), source(right), r.halfedge, right};
  }

  Sides sides(const Split& s) const
  {
    return Sides{opposite(next(s.left)), opposite(prev(s.left)), opposite(next(s.right)), opposite(prev(s.right))};
  }

  void glue(Index h, Index o)
  {
    m_table.halfedges[h].opposite = o;
    m_table.halfedges[o].opposite = h;
  }

  // If the outgoing halfedge of v is the one that leaves, takes `instead` and notes it.
  void leave(Index v, Index leaving, Index instead, Index bit, Record& record)
  {
    if(m_table.outgoing[v] != leaving)
      return;
    m_table.outgoing[v] = instead;
    record.outgoing |= bit;
  }

  internal::Corner_table m_table;
  std::vector<Point> m_points;
  std::vector<Record> m_records;
  std::vector<Index> m_vertex_end;      // the last level that has the vertex, null_index if all have
  std::vector<Index> m_face_end;        // the last level that has the face, null_index if all have
  std::size_t m_number_of_vertices = 0; // of T^0
  std::size_t m_level = 0;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_PROGRESSIVE_MESH_H
