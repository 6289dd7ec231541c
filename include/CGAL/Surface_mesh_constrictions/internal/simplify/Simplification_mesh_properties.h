// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_PROPERTIES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_PROPERTIES_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>

// The property maps of Simplification_mesh: points, numbers, and arrays for dynamic properties.

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// An lvalue property map. Like that of CGAL's Surface_mesh, that of a constant mesh writes, too.
class Simplification_point_map
{
public:
  typedef Simplification_mesh::Vertex_index key_type;
  typedef Simplification_mesh::Point value_type;
  typedef value_type& reference;
  typedef boost::lvalue_property_map_tag category;

  Simplification_point_map() : m_mesh(nullptr) {}
  explicit Simplification_point_map(const Simplification_mesh& mesh) : m_mesh(const_cast<Simplification_mesh*>(&mesh))
  {}

  reference operator[](key_type v) const { return m_mesh->point(v); }

  friend reference get(const Simplification_point_map& map, key_type v) { return map[v]; }
  friend void put(const Simplification_point_map& map, key_type v, const value_type& p) { map[v] = p; }

private:
  Simplification_mesh* m_mesh;
};

// A readable property map from elements to their numbers.
template <class Descriptor>
class Simplification_index_map
{
public:
  typedef Descriptor key_type;
  typedef Index value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  reference operator[](key_type d) const { return d; }

  friend reference get(const Simplification_index_map& map, key_type d) { return map[d]; }
};

} // namespace internal

inline internal::Simplification_point_map get(CGAL::vertex_point_t, const Simplification_mesh& mesh)
{
  return internal::Simplification_point_map(mesh);
}
inline internal::Simplification_index_map<Simplification_mesh::Vertex_index> get(boost::vertex_index_t,
                                                                                 const Simplification_mesh&)
{
  return {};
}
inline internal::Simplification_index_map<Simplification_mesh::Halfedge_index> get(boost::halfedge_index_t,
                                                                                   const Simplification_mesh&)
{
  return {};
}
inline internal::Simplification_index_map<Simplification_mesh::Edge_index> get(boost::edge_index_t,
                                                                               const Simplification_mesh&)
{
  return {};
}
inline internal::Simplification_index_map<Simplification_mesh::Face_index> get(boost::face_index_t,
                                                                               const Simplification_mesh&)
{
  return {};
}

template <class T>
CGAL::internal::Dynamic_with_index<Simplification_mesh::Vertex_index, T> get(CGAL::dynamic_vertex_property_t<T>,
                                                                             const Simplification_mesh& mesh)
{
  return {mesh.num_vertices()};
}
template <class T>
CGAL::internal::Dynamic_with_index<Simplification_mesh::Halfedge_index, T> get(CGAL::dynamic_halfedge_property_t<T>,
                                                                               const Simplification_mesh& mesh)
{
  return {mesh.num_halfedges()};
}
template <class T>
CGAL::internal::Dynamic_with_index<Simplification_mesh::Edge_index, T> get(CGAL::dynamic_edge_property_t<T>,
                                                                           const Simplification_mesh& mesh)
{
  return {mesh.num_edges()};
}
template <class T>
CGAL::internal::Dynamic_with_index<Simplification_mesh::Face_index, T> get(CGAL::dynamic_face_property_t<T>,
                                                                           const Simplification_mesh& mesh)
{
  return {mesh.num_faces()};
}

template <class Property, class Key>
decltype(auto) get(Property property, const Simplification_mesh& mesh, const Key& key)
{
  return get(get(property, mesh), key);
}
inline void put(CGAL::vertex_point_t, Simplification_mesh& mesh, Simplification_mesh::Vertex_index v,
                const Simplification_mesh::Point& p)
{
  mesh.point(v) = p;
}

} // namespace Surface_mesh_constrictions

template <>
struct graph_has_property<Surface_mesh_constrictions::Simplification_mesh, CGAL::vertex_point_t> : CGAL::Tag_true
{};
template <>
struct graph_has_property<Surface_mesh_constrictions::Simplification_mesh, boost::vertex_index_t> : CGAL::Tag_true
{};
template <>
struct graph_has_property<Surface_mesh_constrictions::Simplification_mesh, boost::halfedge_index_t> : CGAL::Tag_true
{};
template <>
struct graph_has_property<Surface_mesh_constrictions::Simplification_mesh, boost::edge_index_t> : CGAL::Tag_true
{};
template <>
struct graph_has_property<Surface_mesh_constrictions::Simplification_mesh, boost::face_index_t> : CGAL::Tag_true
{};

} // namespace CGAL

namespace boost {

template <>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, CGAL::vertex_point_t>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Simplification_point_map type;
  typedef type const_type;
};
template <>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, boost::vertex_index_t>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Simplification_index_map<
      CGAL::Surface_mesh_constrictions::Simplification_mesh::Vertex_index>
      type;
  typedef type const_type;
};
template <>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, boost::halfedge_index_t>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Simplification_index_map<
      CGAL::Surface_mesh_constrictions::Simplification_mesh::Halfedge_index>
      type;
  typedef type const_type;
};
template <>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, boost::edge_index_t>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Simplification_index_map<
      CGAL::Surface_mesh_constrictions::Simplification_mesh::Edge_index>
      type;
  typedef type const_type;
};
template <>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, boost::face_index_t>
{
  typedef CGAL::Surface_mesh_constrictions::internal::Simplification_index_map<
      CGAL::Surface_mesh_constrictions::Simplification_mesh::Face_index>
      type;
  typedef type const_type;
};
template <class T>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, CGAL::dynamic_vertex_property_t<T>>
{
  typedef CGAL::internal::Dynamic_with_index<CGAL::Surface_mesh_constrictions::Simplification_mesh::Vertex_index, T>
      type;
  typedef type const_type;
};
template <class T>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, CGAL::dynamic_halfedge_property_t<T>>
{
  typedef CGAL::internal::Dynamic_with_index<CGAL::Surface_mesh_constrictions::Simplification_mesh::Halfedge_index, T>
      type;
  typedef type const_type;
};
template <class T>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, CGAL::dynamic_edge_property_t<T>>
{
  typedef CGAL::internal::Dynamic_with_index<CGAL::Surface_mesh_constrictions::Simplification_mesh::Edge_index, T> type;
  typedef type const_type;
};
template <class T>
struct property_map<CGAL::Surface_mesh_constrictions::Simplification_mesh, CGAL::dynamic_face_property_t<T>>
{
  typedef CGAL::internal::Dynamic_with_index<CGAL::Surface_mesh_constrictions::Simplification_mesh::Face_index, T> type;
  typedef type const_type;
};

} // namespace boost

namespace std {

template <class Element>
struct hash<CGAL::Surface_mesh_constrictions::Simplification_mesh::Descriptor<Element>>
{
  std::size_t operator()(CGAL::Surface_mesh_constrictions::Simplification_mesh::Descriptor<Element> d) const
  {
    return d.idx();
  }
};

template <>
struct hash<CGAL::Surface_mesh_constrictions::Simplification_mesh::Edge_index>
{
  std::size_t operator()(CGAL::Surface_mesh_constrictions::Simplification_mesh::Edge_index e) const { return e.idx(); }
};

} // namespace std

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFICATION_MESH_PROPERTIES_H
