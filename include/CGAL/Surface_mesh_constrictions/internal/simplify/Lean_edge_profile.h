// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_LEAN_EDGE_PROFILE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_LEAN_EDGE_PROFILE_H

#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_profile.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <optional>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The points of a mesh that is simplified. With this map CGAL's edge_collapse() makes lean profiles, see below.
class Lean_point_map : public Simplification_point_map
{
public:
  explicit Lean_point_map(const Simplification_point_map& map) : Simplification_point_map(map) {}
};

} // namespace internal
} // namespace Surface_mesh_constrictions

namespace Surface_mesh_simplification {

// A model of EdgeProfile that looks up its members when they are read. CGAL's own profile allocates memory for the
// triangles around the edge and for their link when it is made, and on a mesh with border goes around both ends. Of
// some thirty profiles that edge_collapse() makes for each collapse, only that of the collapsed edge needs these; the
// others are for costs that hardly ever do. Without them the simplification takes a third less time.
template <class GeomTraits>
class Edge_profile<Surface_mesh_constrictions::Simplification_mesh,
                   Surface_mesh_constrictions::internal::Lean_point_map, GeomTraits>
{
  typedef Surface_mesh_constrictions::internal::Simplification_point_map Simplification_point_map;
  typedef Edge_profile<Surface_mesh_constrictions::Simplification_mesh, Simplification_point_map, GeomTraits>
      Full_profile;

public:
  typedef Surface_mesh_constrictions::Simplification_mesh Triangle_mesh;
  typedef Triangle_mesh TM;
  typedef Surface_mesh_constrictions::internal::Lean_point_map Vertex_point_map;
  typedef Vertex_point_map VertexPointMap;
  typedef GeomTraits Geom_traits;
  typedef typename Geom_traits::FT FT;
  typedef typename Full_profile::Point Point;
  typedef typename Full_profile::Point_reference Point_reference;
  typedef typename Full_profile::GraphTraits GraphTraits;
  typedef typename Full_profile::vertex_descriptor vertex_descriptor;
  typedef typename Full_profile::halfedge_descriptor halfedge_descriptor;
  typedef typename Full_profile::edge_descriptor edge_descriptor;
  typedef typename Full_profile::face_descriptor face_descriptor;
  typedef typename Full_profile::edges_size_type edges_size_type;
  typedef typename Full_profile::vertex_descriptor_vector vertex_descriptor_vector;
  typedef typename Full_profile::halfedge_descriptor_vector halfedge_descriptor_vector;
  typedef typename Full_profile::Triangle Triangle;
  typedef typename Full_profile::Triangle_vector Triangle_vector;

  template <class VertexIndexMap, class HalfedgeIndexMap>
  Edge_profile(halfedge_descriptor h, Triangle_mesh& mesh, const Geom_traits& traits, const VertexIndexMap&,
               const Vertex_point_map& vpm, const HalfedgeIndexMap&, bool has_border)
    : m_mesh(mesh), m_vpm(vpm), m_traits(traits), m_h(h), m_v0(source(h, mesh)), m_v1(target(h, mesh)),
      m_has_border(has_border)
  {}

  halfedge_descriptor v0_v1() const { return m_h; }
  halfedge_descriptor v1_v0() const { return opposite(m_h, m_mesh); }
  vertex_descriptor v0() const { return m_v0; }
  vertex_descriptor v1() const { return m_v1; }

  halfedge_descriptor v1_vL() const { return left_face_exists() ? next(m_h, m_mesh) : GraphTraits::null_halfedge(); }
  halfedge_descriptor vL_v0() const { return left_face_exists() ? prev(m_h, m_mesh) : GraphTraits::null_halfedge(); }
  vertex_descriptor vL() const { return left_face_exists() ? target(v1_vL(), m_mesh) : GraphTraits::null_vertex(); }

  halfedge_descriptor v0_vR() const
  {
    return right_face_exists() ? next(v1_v0(), m_mesh) : GraphTraits::null_halfedge();
  }
  halfedge_descriptor vR_v1() const
  {
    return right_face_exists() ? prev(v1_v0(), m_mesh) : GraphTraits::null_halfedge();
  }
  vertex_descriptor vR() const { return right_face_exists() ? target(v0_vR(), m_mesh) : GraphTraits::null_vertex(); }

  bool is_v0_v1_a_border() const { return is_border(m_h, m_mesh); }
  bool is_v1_v0_a_border() const { return is_border(v1_v0(), m_mesh); }
  bool left_face_exists() const { return !is_v0_v1_a_border(); }
  bool right_face_exists() const { return !is_v1_v0_a_border(); }

  Point_reference p0() const { return get(m_vpm, m_v0); }
  Point_reference p1() const { return get(m_vpm, m_v1); }

  const Triangle_vector& triangles() const { return full().triangles(); }
  const vertex_descriptor_vector& link() const { return full().link(); }
  const halfedge_descriptor_vector& border_edges() const { return full().border_edges(); }

  const Triangle_mesh& surface() const { return m_mesh; }
  const Triangle_mesh& surface_mesh() const { return m_mesh; }
  const Vertex_point_map& vertex_point_map() const { return m_vpm; }
  const Geom_traits& geom_traits() const { return m_traits; }

private:
  const Full_profile& full() const
  {
    if(!m_full)
      m_full.emplace(m_h, m_mesh, m_traits, 0, m_vpm, 0, m_has_border);
    return *m_full;
  }

  Triangle_mesh& m_mesh;
  const Vertex_point_map& m_vpm;
  const Geom_traits& m_traits;
  halfedge_descriptor m_h;
  vertex_descriptor m_v0, m_v1; // they are read after the collapse, too
  bool m_has_border;
  mutable std::optional<Full_profile> m_full; // as before the collapse
};

} // namespace Surface_mesh_simplification
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_LEAN_EDGE_PROFILE_H
