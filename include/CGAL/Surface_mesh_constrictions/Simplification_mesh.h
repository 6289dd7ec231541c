// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H

#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

// CGAL's edge profiles call this without including its header. Here it is found by the type of the mesh, whichever
// header comes first.
using CGAL::is_border;

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The copy of the input that is simplified, whatever the type of the input. Cost and placement policies passed to
/// `detect_constrictions()` are called with edge profiles of this mesh: models of CGAL's `EdgeProfile`, of a type of
/// this package's own, so that their `operator()` has to be a template like that of CGAL's policies. What a profile
/// tells is looked up when it is asked for: after the collapse only the vertices are what they were.
///
/// A halfedge data structure that CGAL's `edge_collapse()` is fast on: connectivity in arrays of 32-bit numbers,
/// opposite halfedges next to each other, and no properties but the points. Removed elements keep their numbers; there
/// is no garbage collection, and `num_vertices()` and the like count them.
///
/// \cgalModels{MutableFaceGraph,VertexListGraph,EdgeListGraph,HalfedgeListGraph,FaceListGraph}
class Simplification_mesh
{
public:
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point; ///< of double coordinates
  typedef Index size_type;                                              ///< counts elements

  /// The number of an element; of none, if it is made without one.
  template <class Element>
  class Descriptor
  {
  public:
    /// of no element
    Descriptor() : m_index(null_index) {}
    /// of the `i`-th element
    explicit Descriptor(Index i) : m_index(i) {}

    /// the number
    operator Index() const { return m_index; }
    /// the number
    Index idx() const { return m_index; }

    /// compares numbers
    friend bool operator==(Descriptor a, Descriptor b) { return a.m_index == b.m_index; }
    /// compares numbers
    friend bool operator!=(Descriptor a, Descriptor b) { return a.m_index != b.m_index; }
    /// compares numbers
    friend bool operator<(Descriptor a, Descriptor b) { return a.m_index < b.m_index; }
    /// for Boost's hash tables
    friend std::size_t hash_value(Descriptor d) { return d.m_index; }

  private:
    Index m_index;
  };

  typedef Descriptor<struct Vertex_element> Vertex_index;     ///< a vertex
  typedef Descriptor<struct Halfedge_element> Halfedge_index; ///< a halfedge; its opposite differs in the last bit
  typedef Descriptor<struct Face_element> Face_index;         ///< a face

  /// An edge, which knows of which of its two halfedges it was made. That does not matter in comparisons.
  class Edge_index
  {
  public:
    /// of no element
    Edge_index() {}
    /// of the `i`-th edge, made of the halfedge with twice its number
    explicit Edge_index(Index i) : m_halfedge(2 * i) {}
    /// of the edge of a halfedge
    explicit Edge_index(Halfedge_index h) : m_halfedge(h) {}

    /// the halfedge that it was made of
    Halfedge_index halfedge() const { return m_halfedge; }
    /// the number
    operator Index() const { return m_halfedge / 2; }
    /// the number
    Index idx() const { return m_halfedge / 2; }

    /// compares numbers
    friend bool operator==(Edge_index a, Edge_index b) { return a.idx() == b.idx(); }
    /// compares numbers
    friend bool operator!=(Edge_index a, Edge_index b) { return a.idx() != b.idx(); }
    /// compares numbers
    friend bool operator<(Edge_index a, Edge_index b) { return a.idx() < b.idx(); }
    /// for Boost's hash tables
    friend std::size_t hash_value(Edge_index e) { return e.idx(); }

  private:
    Halfedge_index m_halfedge;
  };

  /// Goes over the elements that are not removed, in the order of their numbers. Bidirectional.
  template <class D>
  class Iterator : public boost::iterator_facade<Iterator<D>, D, boost::bidirectional_traversal_tag, D>
  {
  public:
    /// of no mesh
    Iterator() : m_is_removed(nullptr), m_index(0) {}

  private:
    friend class Simplification_mesh;
    friend class boost::iterator_core_access;

    Iterator(const std::vector<bool>& is_removed, std::size_t i) : m_is_removed(&is_removed), m_index(i)
    {
      skip_removed();
    }

    // halfedges share the mark of their edge
    static std::size_t place_of_mark(std::size_t i) { return std::is_same<D, Halfedge_index>::value ? i / 2 : i; }

    void skip_removed()
    {
      while(place_of_mark(m_index) < m_is_removed->size() && (*m_is_removed)[place_of_mark(m_index)])
        ++m_index;
    }
    D dereference() const { return D(static_cast<Index>(m_index)); }
    bool equal(const Iterator& other) const { return m_index == other.m_index; }
    void increment()
    {
      ++m_index;
      skip_removed();
    }
    void decrement()
    {
      do
        --m_index;
      while((*m_is_removed)[place_of_mark(m_index)]);
    }

    const std::vector<bool>* m_is_removed;
    std::size_t m_index;
  };

  typedef Iterator<Vertex_index> Vertex_iterator;     ///< over vertices
  typedef Iterator<Halfedge_index> Halfedge_iterator; ///< over halfedges
  typedef Iterator<Edge_index> Edge_iterator;         ///< over edges
  typedef Iterator<Face_index> Face_iterator;         ///< over faces

  /// \name Elements
  /// @{

  /// how many vertices there are, removed ones included
  size_type num_vertices() const { return static_cast<size_type>(m_vertices.size()); }
  /// how many halfedges there are, removed ones included
  size_type num_halfedges() const { return static_cast<size_type>(m_halfedges.size()); }
  /// how many edges there are, removed ones included
  size_type num_edges() const { return static_cast<size_type>(m_halfedges.size() / 2); }
  /// how many faces there are, removed ones included
  size_type num_faces() const { return static_cast<size_type>(m_faces.size()); }

  /// the vertices that are not removed
  Iterator_range<Vertex_iterator> vertices() const { return range<Vertex_index>(m_removed_vertices, num_vertices()); }
  /// the halfedges that are not removed
  Iterator_range<Halfedge_iterator> halfedges() const
  {
    return range<Halfedge_index>(m_removed_edges, num_halfedges());
  }
  /// the edges that are not removed
  Iterator_range<Edge_iterator> edges() const { return range<Edge_index>(m_removed_edges, num_edges()); }
  /// the faces that are not removed
  Iterator_range<Face_iterator> faces() const { return range<Face_index>(m_removed_faces, num_faces()); }

  /// where a vertex is
  const Point& point(Vertex_index v) const { return m_points[v]; }
  /// where a vertex is
  Point& point(Vertex_index v) { return m_points[v]; }

  /// @}
  /// \name Connectivity
  /// @{

  /// no halfedge
  static Halfedge_index null_halfedge() { return Halfedge_index(); }
  /// a halfedge into a vertex
  Halfedge_index halfedge(Vertex_index v) const { return m_vertices[v]; }
  /// a halfedge of a face
  Halfedge_index halfedge(Face_index f) const { return m_faces[f]; }
  /// the halfedge that the descriptor of an edge was made of
  Halfedge_index halfedge(Edge_index e) const { return e.halfedge(); }
  /// the halfedge after this one in its face, or along the border
  Halfedge_index next(Halfedge_index h) const { return m_halfedges[h].next; }
  /// the halfedge before this one in its face, or along the border
  Halfedge_index prev(Halfedge_index h) const { return m_halfedges[h].prev; }
  /// the other halfedge of the edge
  Halfedge_index opposite(Halfedge_index h) const { return Halfedge_index(h ^ 1u); }
  /// the edge of a halfedge
  Edge_index edge(Halfedge_index h) const { return Edge_index(h); }
  /// the face on the left of a halfedge, or none
  Face_index face(Halfedge_index h) const { return m_halfedges[h].face; }
  /// where a halfedge starts
  Vertex_index source(Halfedge_index h) const { return target(opposite(h)); }
  /// where a halfedge ends
  Vertex_index target(Halfedge_index h) const { return m_halfedges[h].target; }

  /// @}
  /// \name Modifiers
  /// @{

  /// makes room for as many vertices, edges and faces in all
  void reserve(size_type vertices, size_type edges, size_type faces)
  {
    m_vertices.reserve(vertices);
    m_points.reserve(vertices);
    m_halfedges.reserve(2 * static_cast<std::size_t>(edges));
    m_faces.reserve(faces);
  }

  /// adds a vertex without a halfedge
  Vertex_index add_vertex(const Point& p = Point())
  {
    m_vertices.emplace_back();
    m_points.push_back(p);
    m_removed_vertices.push_back(false);
    return Vertex_index(num_vertices() - 1);
  }
  /// adds an edge without connections, and returns its first halfedge
  Halfedge_index add_edge()
  {
    m_halfedges.resize(m_halfedges.size() + 2);
    m_removed_edges.push_back(false);
    return Halfedge_index(num_halfedges() - 2);
  }
  /// adds a face without a halfedge
  Face_index add_face()
  {
    m_faces.emplace_back();
    m_removed_faces.push_back(false);
    return Face_index(num_faces() - 1);
  }

  /// marks a vertex as removed
  void remove_vertex(Vertex_index v) { m_removed_vertices[v] = true; }
  /// marks an edge as removed
  void remove_edge(Edge_index e) { m_removed_edges[e] = true; }
  /// marks a face as removed
  void remove_face(Face_index f) { m_removed_faces[f] = true; }

  /// sets the halfedge of a vertex
  void set_halfedge(Vertex_index v, Halfedge_index h) { m_vertices[v] = h; }
  /// sets the halfedge of a face
  void set_halfedge(Face_index f, Halfedge_index h) { m_faces[f] = h; }
  /// sets the next halfedge of `h`, and the previous one of `n`
  void set_next(Halfedge_index h, Halfedge_index n)
  {
    m_halfedges[h].next = n;
    m_halfedges[n].prev = h;
  }
  /// sets the face of a halfedge
  void set_face(Halfedge_index h, Face_index f) { m_halfedges[h].face = f; }
  /// sets where a halfedge ends
  void set_target(Halfedge_index h, Vertex_index v) { m_halfedges[h].target = v; }

  /// @}

private:
  struct Halfedge
  {
    Halfedge_index next, prev;
    Vertex_index target;
    Face_index face;
  };

  template <class D>
  static Iterator_range<Iterator<D>> range(const std::vector<bool>& is_removed, std::size_t n)
  {
    return make_range(Iterator<D>(is_removed, 0), Iterator<D>(is_removed, n));
  }

  std::vector<Halfedge> m_halfedges;
  std::vector<Halfedge_index> m_vertices, m_faces;
  std::vector<Point> m_points;
  std::vector<bool> m_removed_vertices, m_removed_edges, m_removed_faces;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

// what makes it a face graph
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Simplification_mesh_graph.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Simplification_mesh_properties.h>

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SIMPLIFICATION_MESH_H
