// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_MAKE_PROGRESSIVE_MESH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_MAKE_PROGRESSIVE_MESH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

// What `make_progressive_mesh()` does with arguments of the right kind.
template <class TriangleMesh, class NamedParameters>
Progressive_mesh make_progressive_mesh_checked(const TriangleMesh& tm, const std::vector<Edge_collapse>& collapses,
                                               const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// builds the progressive mesh of a triangle mesh and of the edge collapses that were made on a copy of it.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm the mesh before the first collapse; unchanged. Vertex `i` of the progressive mesh is the `i`-th
///        one of `vertices(tm)`, face `i` the `i`-th one of `faces(tm)`.
/// \param collapses the record of a `Collapse_recording_visitor`, in these vertex numbers
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point; coordinates that are not
///                    doubles are rounded to the nearest double}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre each collapse keeps the surface a 2-manifold (the link condition), as those of `edge_collapse()` do
/// \return the progressive mesh, at its last level
/// \throws Invalid_input for a mesh that cannot be used
/// \cost linear in the size of the mesh and the number of collapses
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Progressive_mesh make_progressive_mesh(const TriangleMesh& tm, const std::vector<Edge_collapse>& collapses,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Mesh_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<TriangleMesh>() && knows_all)
    return internal::make_progressive_mesh_checked(tm, collapses, np);
  else
    return internal::no_result<Progressive_mesh>();
}

namespace internal {

template <class TriangleMesh, class NamedParameters>
Progressive_mesh make_progressive_mesh_checked(const TriangleMesh& tm, const std::vector<Edge_collapse>& collapses,
                                               const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, CGAL::get_initialized_vertex_index_map(tm, np));
  Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  pm.append_collapses(collapses, [](const Edge_collapse&) { return true; });
  return pm;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_MAKE_PROGRESSIVE_MESH_H
