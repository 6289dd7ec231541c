// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Opened_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Part_closer.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/intersecting_caps.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A cap with which `extract_parts()` closes a part.
template <class TriangleMesh>
struct Part_cap
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor; ///< of the mesh

  std::size_t part; ///< the place of the part in the output

  /// the cyclic sequence of the halfedges of the mesh along the border of the cap, in faces of the part
  std::vector<halfedge_descriptor> border;

  /// whether a triangle of the cap meets another triangle of the closed part in more than common vertices and edges
  bool intersects_part;
};

namespace internal {

struct Extraction_parameters : Point_parameters::With<internal_np::with_caps_t, internal_np::with_filled_holes_t,
                                                      internal_np::cap_output_iterator_t>
{};

template <class TriangleMesh, class NamedParameters>
constexpr bool check_output_of_caps()
{
  typedef internal_np::cap_output_iterator_t Tag;
  if constexpr(!CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value)
    return check_output<std::decay_t<decltype(CGAL::parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                              internal_np::cap_output_iterator))>,
                        Part_cap<TriangleMesh>>();
  else
    return true;
}

// What `extract_parts()` does with arguments of the right kind.
template <class TriangleMesh, class EdgeIsConstrainedMap, class OutputIterator, class NamedParameters>
OutputIterator extract_parts_checked(const TriangleMesh& tm, EdgeIsConstrainedMap edge_is_constrained_map,
                                     OutputIterator out, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// makes a mesh of each part into which marked edges divide a mesh, and closes the holes along them: meshes for
/// printing or simulation.
///
/// The mesh is opened along the marked edges. A vertex there is doubled, so that parts that touch themselves or others
/// become manifold, and a part on both sides of a curve, as of a torus along a meridian, gets two holes.
///
/// The caps on the two sides of a cut are the same surface: the triangles of one are those of the other, turned over.
/// So the volumes of the parts add up to that of the mesh, up to rounding. The triangles are those of
/// `CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`. If one of their sides is already an edge of the mesh,
/// they are those of a triangulation of least area without such sides, and if there is none, those of the cone to the
/// mean of the vertices. Where curves share a stretch of edges, the holes of different parts have some edges in common
/// and others not; all of these holes are closed by cones to one common point. Where a curve touches itself or another,
/// the hole is closed as several.
///
/// Holes of the mesh stay open, and so does a hole that runs partly along one of them, unless `with_filled_holes` asks
/// for closed parts. Then the holes are filled in the same ways, and the volumes of the parts add up to that of the
/// mesh with its holes filled.
///
/// A cap may intersect its part where the surface is strongly bent around a curve, or where the part reaches through
/// the curve. `cap_output_iterator` gets which caps do. The volume of a part is negative if its surface encloses a
/// region outside of the solid, as the wall of a pocket closed by a cap over its opening.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`, default constructible
/// \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` with the edges of `tm` as key type and `bool` as value
///         type
/// \tparam OutputIterator takes `TriangleMesh`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh
/// \param edge_is_constrained_map marks closed curves, as `split_along_constrictions()` does
/// \param out the parts in the order of `CGAL::Polygon_mesh_processing::connected_components()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is that of the points of `TriangleMesh`}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{with_caps}
///     \cgalParamDescription{whether holes along marked edges are filled}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{with_filled_holes}
///     \cgalParamDescription{whether the other holes are filled: holes of `tm`, and holes that run partly along one of
///                           these}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{cap_output_iterator}
///     \cgalParamDescription{takes a `Part_cap` for each cap, those of filled holes included}
///     \cgalParamType{a model of `OutputIterator`}
///     \cgalParamDefault{unset: caps are not tested for intersections}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \cost linear in the size of the mesh, plus that of triangulating the caps; with `cap_output_iterator` also that of
///       `CGAL::Polygon_mesh_processing::self_intersections()` near them
template <class TriangleMesh, class EdgeIsConstrainedMap, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator extract_parts(const TriangleMesh& tm, EdgeIsConstrainedMap edge_is_constrained_map, OutputIterator out,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Extraction_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, TriangleMesh>() && knows_all)
  {
    if constexpr(internal::check_output_of_caps<TriangleMesh, NamedParameters>())
      return internal::extract_parts_checked(tm, edge_is_constrained_map, out, np);
  }
  return out;
}

namespace internal {

template <class TriangleMesh, class EdgeIsConstrainedMap, class OutputIterator, class NamedParameters>
OutputIterator extract_parts_checked(const TriangleMesh& tm, EdgeIsConstrainedMap edge_is_constrained_map,
                                     OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  namespace PMP = Polygon_mesh_processing;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const internal::Closed_loops closed_loops = {
      choose_parameter(get_parameter(np, internal_np::with_caps), true),
      choose_parameter(get_parameter(np, internal_np::with_filled_holes), false)};

  const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), tm);
  const std::size_t n =
      PMP::connected_components(tm, component, CGAL::parameters::edge_is_constrained_map(edge_is_constrained_map));
  std::vector<std::vector<typename Graph_traits::face_descriptor>> faces_of_part(n);
  for(auto f : faces(tm))
    faces_of_part[get(component, f)].push_back(f);

  typedef std::decay_t<decltype(vpm)> Vertex_point_map;
  typedef internal::Part_closer<TriangleMesh, EdgeIsConstrainedMap, Vertex_point_map> Closer;
  std::vector<typename Closer::Opened> opened(n, {tm, edge_is_constrained_map, vpm});
  for(std::size_t p = 0; p < n; ++p)
    for(auto f : faces_of_part[p])
      opened[p].add_face(f);
  std::vector<std::vector<typename Closer::Cap>> caps_of_part(n);
  if(closed_loops.along_curves || closed_loops.along_holes)
  {
    const Closer closer(tm, edge_is_constrained_map, vpm, faces_of_part, closed_loops, opened);
    for(const typename Closer::Cap& c : closer.caps())
      caps_of_part[c.part].push_back(c);
  }

  for(std::size_t p = 0; p < n; ++p)
  {
    const auto soup = opened[p].soup();
    TriangleMesh part;
    PMP::polygon_soup_to_polygon_mesh(soup.first, soup.second, part);
    if constexpr(!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::cap_output_iterator_t>::value)
    {
      auto caps_out = get_parameter(np, internal_np::cap_output_iterator);
      typedef std::vector<typename Graph_traits::face_descriptor> Faces;
      const Faces all(faces(part).begin(), faces(part).end()); // in the order of the triangles
      std::vector<Faces> caps;
      for(const typename Closer::Cap& c : caps_of_part[p])
        caps.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(c.first_triangle),
                          all.begin() + static_cast<std::ptrdiff_t>(c.end_of_triangles));
      const std::vector<bool> intersects =
          internal::intersecting_caps(part, get(CGAL::vertex_point, static_cast<const TriangleMesh&>(part)), caps);
      for(std::size_t c = 0; c < intersects.size(); ++c)
        *caps_out++ = Part_cap<TriangleMesh>{p, caps_of_part[p][c].border, intersects[c]};
    }
    *out++ = std::move(part);
  }
  return out;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_EXTRACT_PARTS_H
