// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_POLICIES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_POLICIES_H

#include <CGAL/Surface_mesh_constrictions/internal/simplify/Plane_quadric.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The costs and placements of CGAL's GarlandHeckbert_plane_policies, to the last bit, for a mesh of double coordinates.
// Those work on 4x4 matrices in a property map that is copied at each access; a simplification takes a quarter to a
// third less time with these.
//
// A model of GetCost and GetPlacement. Copies share the quadrics.
template <class TriangleMesh>
class Plane_quadric_policies
{
public:
  typedef Plane_quadric_policies Get_cost;
  typedef Plane_quadric_policies Get_placement;
  typedef CGAL::Tag_true Update_tag; // initialize() and update_after_collapse() are to be called

  explicit Plane_quadric_policies(TriangleMesh& mesh)
    : m_quadrics(get(CGAL::dynamic_vertex_property_t<Plane_quadric>(), mesh))
  {}

  const Get_cost& get_cost() const { return *this; }
  const Get_placement& get_placement() const { return *this; }

  // Makes the quadric of each vertex from the planes of its faces, and from planes that hold borders in place. Linear.
  template <class VertexPointMap, class GeomTraits>
  void initialize(const TriangleMesh& mesh, VertexPointMap vpm, const GeomTraits&) const
  {
    for(const auto v : vertices(mesh))
      put(m_quadrics, v, Plane_quadric());
    for(const auto f : faces(mesh))
    {
      const auto begin = halfedge(f, mesh);
      const Plane_quadric quadric = plane(unit(normal(begin, mesh, vpm)), get(vpm, target(begin, mesh)));
      for(const auto h : CGAL::halfedges_around_face(begin, mesh))
      {
        quadric_of(source(h, mesh)) += quadric;
        if(!CGAL::is_border_edge(h, mesh))
          continue;
        const Point& end = get(vpm, target(h, mesh));
        const Vector along = end - get(vpm, source(h, mesh));
        const Plane_quadric beside = border_weight * plane(unit(CGAL::cross_product(along, normal(h, mesh, vpm))), end);
        quadric_of(source(h, mesh)) += beside;
        quadric_of(target(h, mesh)) += beside;
      }
    }
  }

  template <class Profile, class Vertex>
  void update_after_collapse(const Profile& profile, const Vertex& kept) const
  {
    quadric_of(kept) = quadric_of_edge(profile);
  }

  // the cost of an edge that collapses to a point
  template <class Profile, class OptionalPoint>
  auto operator()(const Profile& profile, const OptionalPoint& placement) const
      -> decltype(Surface_mesh_simplification::Edge_length_cost<TriangleMesh>()(profile, placement))
  {
    if(!placement)
      return {};
    const Homogeneous p = homogeneous(*placement);
    return quadric_of_edge(profile)(p, p);
  }

  // the point that an edge collapses to
  template <class Profile>
  auto operator()(const Profile& profile) const
      -> decltype(Surface_mesh_simplification::Midpoint_placement<TriangleMesh>()(profile))
  {
    const Homogeneous p = quadric_of_edge(profile).best_point(homogeneous(profile.p0()), homogeneous(profile.p1()));
    return Point(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  }

private:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Plane_quadric>>::type Quadric_map;
  typedef typename boost::property_traits<
      typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type>::value_type Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;

  static constexpr double border_weight = 100;

  static Homogeneous homogeneous(const Point& p) { return {{p.x(), p.y(), p.z(), 1}}; }

  static Vector unit(const Vector& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length == 0 ? v : v / length;
  }

  static Plane_quadric plane(const Vector& normal, const Point& p)
  {
    return Plane_quadric(normal.x(), normal.y(), normal.z(), -(normal * (p - CGAL::ORIGIN)));
  }

  // the normal of the face of a halfedge, as long as the parallelogram of two edges is large
  template <class VertexPointMap>
  static Vector normal(typename Graph_traits::halfedge_descriptor h, const TriangleMesh& mesh, VertexPointMap vpm)
  {
    const Point& p = get(vpm, target(h, mesh));
    return CGAL::cross_product(get(vpm, target(next(h, mesh), mesh)) - p, get(vpm, source(h, mesh)) - p);
  }

  Plane_quadric& quadric_of(typename Graph_traits::vertex_descriptor v) const { return get(m_quadrics, v); }

  template <class Profile>
  Plane_quadric quadric_of_edge(const Profile& profile) const
  {
    Plane_quadric result = quadric_of(profile.v0());
    return result += quadric_of(profile.v1());
  }

  Quadric_map m_quadrics;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_PLANE_QUADRIC_POLICIES_H
