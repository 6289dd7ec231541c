// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_GRAPH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_GRAPH_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

// The functions that make Simplification_mesh a model of CGAL's MutableFaceGraph.

namespace boost {

template <>
struct graph_traits<CGAL::Surface_mesh_constrictions::Simplification_mesh>
{
private:
  typedef CGAL::Surface_mesh_constrictions::Simplification_mesh Mesh;

public:
  struct traversal_category : virtual boost::bidirectional_graph_tag,
                              virtual boost::vertex_list_graph_tag,
                              virtual boost::edge_list_graph_tag
  {};
  typedef boost::undirected_tag directed_category;
  typedef boost::disallow_parallel_edge_tag edge_parallel_category;

  typedef Mesh::Vertex_index vertex_descriptor;
  typedef Mesh::Halfedge_index halfedge_descriptor;
  typedef Mesh::Edge_index edge_descriptor;
  typedef Mesh::Face_index face_descriptor;

  typedef Mesh::Vertex_iterator vertex_iterator;
  typedef Mesh::Halfedge_iterator halfedge_iterator;
  typedef Mesh::Edge_iterator edge_iterator;
  typedef Mesh::Face_iterator face_iterator;
  typedef CGAL::In_edge_iterator<Mesh> in_edge_iterator;
  typedef CGAL::Out_edge_iterator<Mesh> out_edge_iterator;

  typedef Mesh::size_type vertices_size_type;
  typedef Mesh::size_type halfedges_size_type;
  typedef Mesh::size_type edges_size_type;
  typedef Mesh::size_type faces_size_type;
  typedef Mesh::size_type degree_size_type;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
};

template <>
struct graph_traits<const CGAL::Surface_mesh_constrictions::Simplification_mesh>
  : graph_traits<CGAL::Surface_mesh_constrictions::Simplification_mesh>
{};

} // namespace boost

namespace CGAL {
namespace Surface_mesh_constrictions {

// Graph
inline Simplification_mesh::Vertex_index source(Simplification_mesh::Edge_index e, const Simplification_mesh& m)
{
  return m.source(m.halfedge(e));
}
inline Simplification_mesh::Vertex_index target(Simplification_mesh::Edge_index e, const Simplification_mesh& m)
{
  return m.target(m.halfedge(e));
}

// HalfedgeGraph
inline Simplification_mesh::Vertex_index source(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.source(h);
}
inline Simplification_mesh::Vertex_index target(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.target(h);
}
inline Simplification_mesh::Halfedge_index next(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.next(h);
}
inline Simplification_mesh::Halfedge_index prev(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.prev(h);
}
inline Simplification_mesh::Halfedge_index opposite(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.opposite(h);
}
inline Simplification_mesh::Edge_index edge(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.edge(h);
}
inline Simplification_mesh::Halfedge_index halfedge(Simplification_mesh::Edge_index e, const Simplification_mesh& m)
{
  return m.halfedge(e);
}
inline Simplification_mesh::Halfedge_index halfedge(Simplification_mesh::Vertex_index v, const Simplification_mesh& m)
{
  return m.halfedge(v);
}
inline std::pair<Simplification_mesh::Halfedge_index, bool>
halfedge(Simplification_mesh::Vertex_index u, Simplification_mesh::Vertex_index v, const Simplification_mesh& m)
{
  for(const auto h : CGAL::halfedges_around_target(m.halfedge(v), m))
    if(m.source(h) == u)
      return {h, true};
  return {Simplification_mesh::null_halfedge(), false};
}
inline std::pair<Simplification_mesh::Edge_index, bool>
edge(Simplification_mesh::Vertex_index u, Simplification_mesh::Vertex_index v, const Simplification_mesh& m)
{
  const auto h = halfedge(u, v, m);
  return {h.second ? m.edge(h.first) : Simplification_mesh::Edge_index(), h.second};
}
inline Simplification_mesh::size_type degree(Simplification_mesh::Vertex_index v, const Simplification_mesh& m)
{
  return static_cast<Simplification_mesh::size_type>(CGAL::halfedges_around_target(m.halfedge(v), m).size());
}

// FaceGraph
inline Simplification_mesh::Face_index face(Simplification_mesh::Halfedge_index h, const Simplification_mesh& m)
{
  return m.face(h);
}
inline Simplification_mesh::Halfedge_index halfedge(Simplification_mesh::Face_index f, const Simplification_mesh& m)
{
  return m.halfedge(f);
}
inline Simplification_mesh::size_type degree(Simplification_mesh::Face_index f, const Simplification_mesh& m)
{
  return static_cast<Simplification_mesh::size_type>(CGAL::halfedges_around_face(m.halfedge(f), m).size());
}

// VertexListGraph, HalfedgeListGraph, EdgeListGraph, FaceListGraph
inline Simplification_mesh::size_type num_vertices(const Simplification_mesh& m) { return m.num_vertices(); }
inline Simplification_mesh::size_type num_halfedges(const Simplification_mesh& m) { return m.num_halfedges(); }
inline Simplification_mesh::size_type num_edges(const Simplification_mesh& m) { return m.num_edges(); }
inline Simplification_mesh::size_type num_faces(const Simplification_mesh& m) { return m.num_faces(); }
inline Iterator_range<Simplification_mesh::Vertex_iterator> vertices(const Simplification_mesh& m)
{
  return m.vertices();
}
inline Iterator_range<Simplification_mesh::Halfedge_iterator> halfedges(const Simplification_mesh& m)
{
  return m.halfedges();
}
inline Iterator_range<Simplification_mesh::Edge_iterator> edges(const Simplification_mesh& m) { return m.edges(); }
inline Iterator_range<Simplification_mesh::Face_iterator> faces(const Simplification_mesh& m) { return m.faces(); }

// MutableHalfedgeGraph
inline Simplification_mesh::Vertex_index add_vertex(Simplification_mesh& m) { return m.add_vertex(); }
inline Simplification_mesh::Edge_index add_edge(Simplification_mesh& m) { return m.edge(m.add_edge()); }
inline void remove_vertex(Simplification_mesh::Vertex_index v, Simplification_mesh& m) { m.remove_vertex(v); }
inline void remove_edge(Simplification_mesh::Edge_index e, Simplification_mesh& m) { m.remove_edge(e); }
inline void set_halfedge(Simplification_mesh::Vertex_index v, Simplification_mesh::Halfedge_index h,
                         Simplification_mesh& m)
{
  m.set_halfedge(v, h);
}
inline void set_next(Simplification_mesh::Halfedge_index h, Simplification_mesh::Halfedge_index n,
                     Simplification_mesh& m)
{
  m.set_next(h, n);
}
inline void set_target(Simplification_mesh::Halfedge_index h, Simplification_mesh::Vertex_index v,
                       Simplification_mesh& m)
{
  m.set_target(h, v);
}

// MutableFaceGraph
inline Simplification_mesh::Face_index add_face(Simplification_mesh& m) { return m.add_face(); }
inline void remove_face(Simplification_mesh::Face_index f, Simplification_mesh& m) { m.remove_face(f); }
inline void set_halfedge(Simplification_mesh::Face_index f, Simplification_mesh::Halfedge_index h,
                         Simplification_mesh& m)
{
  m.set_halfedge(f, h);
}
inline void set_face(Simplification_mesh::Halfedge_index h, Simplification_mesh::Face_index f, Simplification_mesh& m)
{
  m.set_face(h, f);
}
inline void reserve(Simplification_mesh& m, Simplification_mesh::size_type vertices,
                    Simplification_mesh::size_type edges, Simplification_mesh::size_type faces)
{
  m.reserve(vertices, edges, faces);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_GRAPH_H
