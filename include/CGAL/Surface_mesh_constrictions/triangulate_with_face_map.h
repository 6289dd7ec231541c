// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_TRIANGULATE_WITH_FACE_MAP_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TRIANGULATE_WITH_FACE_MAP_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/nearest_point.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/triangulate_polygon.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

// Those of copy_face_graph(), but for the one that is used here.
struct Triangulation_parameters
  : Point_parameters::With<internal_np::vertex_to_vertex_output_iterator_t, internal_np::vertex_to_vertex_map_t,
                           internal_np::halfedge_to_halfedge_output_iterator_t, internal_np::halfedge_to_halfedge_map_t>
{};

// What `triangulate_with_face_map()` does with arguments of the right kind.
template <class PolygonMesh, class TriangleMesh, class FaceMap, class NamedParameters>
void triangulate_with_face_map_checked(const PolygonMesh& pm, TriangleMesh& tm, FaceMap polygon_of_triangle,
                                       const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// copies a polygon mesh, cuts its faces into triangles, as `detect_constrictions()` needs them, and records for each
/// triangle the polygon that it is a piece of.
///
/// Polygons may be non-convex and need not be plane. Quadrangles are cut as by
/// `CGAL::Polygon_mesh_processing::triangulate_faces()`, others by a constrained Delaunay triangulation in their
/// projection, but, wherever possible, so that no diagonal joins two vertices that an edge joins already, because this
/// package refuses two edges with the same ends. No vertex is added or moved.
/// A triangle of `pm` remains one.
///
/// \tparam PolygonMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam FaceMap a model of `WritablePropertyMap` with the faces of `tm` as keys and those of `pm` as values
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param pm a polygon mesh; its vertices are copied in their order
/// \param tm an empty mesh, which gets the triangles
/// \param polygon_of_triangle gets for each face of `tm` the face of `pm` that it is a piece of
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `pm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, pm)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throws nothing of its own
/// \cost linear in the size of the mesh, with a logarithmic factor for polygons of many corners; cubic in the number of
///       corners of a polygon that crosses itself in its projection
///
/// \sa `detect_constrictions()`
template <class PolygonMesh, class TriangleMesh, class FaceMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void triangulate_with_face_map(const PolygonMesh& pm, TriangleMesh& tm, FaceMap polygon_of_triangle,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Triangulation_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<PolygonMesh>() && internal::check_mutable_mesh<TriangleMesh>() && knows_all)
    internal::triangulate_with_face_map_checked(pm, tm, polygon_of_triangle, np);
}

namespace internal {

template <class PolygonMesh, class TriangleMesh, class FaceMap, class NamedParameters>
void triangulate_with_face_map_checked(const PolygonMesh& pm, TriangleMesh& tm, FaceMap polygon_of_triangle,
                                       const NamedParameters& np)
{
  typedef boost::graph_traits<PolygonMesh> Polygon_graph;
  typedef boost::graph_traits<TriangleMesh> Triangle_graph;
  typedef typename Polygon_graph::face_descriptor Polygon;
  typedef typename Triangle_graph::face_descriptor Face;
  typedef typename Triangle_graph::halfedge_descriptor Halfedge;

  std::vector<std::pair<Polygon, Face>> copies;
  CGAL::copy_face_graph(pm, tm, np.face_to_face_output_iterator(std::back_inserter(copies)));
  const auto vpm = get(CGAL::vertex_point, tm);
  for(const std::pair<Polygon, Face>& copy : copies)
  {
    put(polygon_of_triangle, copy.second, copy.first);
    std::vector<Halfedge> corners; // of each corner the halfedge into it
    for(Halfedge h : halfedges_around_face(halfedge(copy.second, tm), tm))
      corners.push_back(h);
    const std::size_t n = corners.size();
    if(n <= 3)
      continue;
    std::vector<internal::Polygon_point> points;
    for(Halfedge h : corners)
      points.push_back(internal::nearest_point(get(vpm, target(h, tm))));
    const std::vector<internal::Polygon_triangle> triangles =
        internal::triangulate_polygon(points, [&](std::size_t i, std::size_t j) {
          return !halfedge(target(corners[i], tm), target(corners[j], tm), tm).second;
        });

    // an ear, a triangle with two sides on the border of what is left, is cut off until a triangle is left
    std::vector<bool> is_done(triangles.size(), false), is_left(n, true);
    std::size_t left = n;
    while(left > 3)
    {
      const auto next_left = [&](std::size_t i) {
        do
          i = (i + 1) % n;
        while(!is_left[i]);
        return i;
      };
      const std::size_t before = left;
      for(std::size_t t = 0; t < triangles.size() && left > 3; ++t)
        for(std::size_t k = 0; k < 3 && !is_done[t]; ++k)
        {
          const std::size_t a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
          if(next_left(a) != b || next_left(b) != c)
            continue;
          // split_face(h1, h2) joins the targets of its halfedges; what h1 ran into is behind the new edge
          const Halfedge cut = CGAL::Euler::split_face(corners[a], corners[c], tm);
          const Halfedge ear = face(cut, tm) == face(corners[b], tm) ? cut : opposite(cut, tm);
          put(polygon_of_triangle, face(ear, tm), copy.first);
          const Halfedge rest = opposite(ear, tm);
          put(polygon_of_triangle, face(rest, tm), copy.first);
          corners[c] = rest; // runs into c along the new edge
          is_left[b] = false;
          is_done[t] = true;
          --left;
        }
      if(left == before)
        break;
    }
  }
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_TRIANGULATE_WITH_FACE_MAP_H
