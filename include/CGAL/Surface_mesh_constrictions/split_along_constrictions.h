// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Split_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_splitter.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Cut_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Part_finder.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/arrange_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/find_nested_cuts.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Where curves run on a mesh that has been split along them.
template <class TriangleMesh>
struct Split_curves
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor; ///< of the mesh

  /// for each curve of the input the cyclic sequence of the halfedges along it, in its direction; empty if it does not
  /// cut
  std::vector<std::vector<halfedge_descriptor>> halfedges;

  std::vector<Cut_outcome> outcomes; ///< for each curve of the input whether it cuts, and if not, why
};

namespace internal {

// Marks edges in a map of the user.
template <class TriangleMesh, class EdgeIsConstrainedMap>
struct Edge_mark
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  EdgeIsConstrainedMap map;

  bool is_marked(edge_descriptor e) const { return get(map, e); }
  void mark(edge_descriptor e, bool value) { put(map, e, value); }
};

// Where the user has no map.
template <class TriangleMesh>
struct No_edge_mark
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  bool is_marked(edge_descriptor) const { return false; }
  void mark(edge_descriptor, bool) {}
};

template <class TriangleMesh, class NamedParameters>
auto edge_mark(const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  if constexpr(is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
    return No_edge_mark<TriangleMesh>();
  else
    return Edge_mark<TriangleMesh, std::decay_t<decltype(get_parameter(np, internal_np::edge_is_constrained))>>{
        get_parameter(np, internal_np::edge_is_constrained)};
}

struct Splitting_parameters : Cutting_parameters::With<internal_np::edge_is_constrained_t, internal_np::visitor_t>
{};

// What `split_along_constrictions()` does with arguments of the right kind.
template <class TriangleMesh, class ConstrictionRange, class NamedParameters>
Split_curves<TriangleMesh> split_along_constrictions_checked(TriangleMesh& tm, const ConstrictionRange& curves,
                                                             const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// splits the faces of a mesh so that closed curves run along its edges, and marks these. The parts into which
/// `segment_by_constrictions()` divides the surface are then those of
/// `CGAL::Polygon_mesh_processing::connected_components()` with the marked edges as constraints; which of the curves
/// cut is the same.
///
/// Every crossing becomes a vertex, and each piece of a crossed face is triangulated, so that its worst triangle is as
/// good as it can be. Old vertices keep their points and their descriptors. Elements that no curve touches are not
/// changed. The descriptor of a crossed face lives on as one of the faces that it is split into, and that of a crossed
/// edge as one of its pieces.
///
/// The parameter of a crossing is a double, the same for both faces at the edge. The new point is `p + t * (q - p)`,
/// constructed in the kernel of the points. With exact constructions the pieces of an edge are collinear. With points
/// of doubles the new point is rounded; the connectivity does not depend on that, since it follows from the sequence of
/// crossed halfedges alone. The order of crossings on an edge follows from where the curves part. If rounding has made
/// parameters equal, or contrary to this order, or put them to an end of the edge, the crossings are moved apart by
/// 2^-50 of the length of the edge, or as far as is needed for their points to differ. Slivers that a curve cuts off
/// are kept. Where a curve passes a vertex at a distance of about a rounding error, faces are as thin as that, and with
/// points of doubles their normals may have any direction. If an edge is too short to hold as many different points of
/// doubles as there are crossings, some coincide, and faces there have area zero.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a mesh whose faces at the curves are triangles; afterwards the curves of the range no longer fit it
/// \param curves closed curves on `tm`, of which the locations and the prominence count
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadWritePropertyMap` whose value type is a 3D point of a CGAL kernel}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index; used with
///                           `maximum_number_of_parts` only}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{the edges of the curves are set to `true`. The pieces of an edge get the value of the
///                           edge, and new edges inside faces `false`.}
///     \cgalParamType{a class model of `ReadWritePropertyMap` with the edges of `tm` as key type and `bool` as value
///                    type}
///     \cgalParamDefault{edges are not marked}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told which faces and edges are split, and into what}
///     \cgalParamType{a model of `ConstrictionSplitVisitor`; it is copied}
///     \cgalParamDefault{`Split_visitor_base<TriangleMesh>`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{see `segment_by_constrictions()`, as for the next two}
///     \cgalParamType{`double`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
///   \cgalParamNBegin{choked_side}
///     \cgalParamDescription{only curves that choke this side cut}
///     \cgalParamType{`Side`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_parts}
///     \cgalParamDescription{the greatest number of parts}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The last three are the package's own: see \ref PkgSurfaceMeshConstrictionsNamedParameters "Named Parameters".
///
/// \return for each curve the halfedges along it, whether it cuts, and if not, why
/// \throws Invalid_input for a curve that is not a closed sequence of locations on triangles of `tm`, and, with
///         `maximum_number_of_parts`, for a mesh that cannot be used; `tm` is then not changed
/// \cost linear in the number of crossed faces, if few curves cross each: for each crossing, linear in the number of
///       crossings of the same edge and of strands in the same face, plus, for each stretch on which two curves cross
///       the same edges, linear in its length. The size of the mesh does not count, unless `maximum_number_of_parts` is
///       given.
///
/// \sa `extract_parts()`
template <class TriangleMesh, class ConstrictionRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Split_curves<TriangleMesh> split_along_constrictions(TriangleMesh& tm, const ConstrictionRange& curves,
                                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Splitting_parameters, NamedParameters>();
  if constexpr(internal::check_mutable_mesh<TriangleMesh>() && knows_all)
    return internal::split_along_constrictions_checked(tm, curves, np);
  else
    return internal::no_result<Split_curves<TriangleMesh>>();
}

namespace internal {

template <class TriangleMesh, class ConstrictionRange, class NamedParameters>
Split_curves<TriangleMesh> split_along_constrictions_checked(TriangleMesh& tm, const ConstrictionRange& curves,
                                                             const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, tm));
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Split_visitor_base<TriangleMesh>());
  auto mark = internal::edge_mark<TriangleMesh>(np);

  const std::vector<Constriction<TriangleMesh>> given(curves.begin(), curves.end());
  internal::Arranged_curves<TriangleMesh> arranged = internal::arrange_chosen(tm, given, np);
  if constexpr(!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::maximum_number_of_parts_t>::value)
  {
    const internal::Imported_mesh<TriangleMesh> imported(tm, vpm, CGAL::get_initialized_vertex_index_map(tm, np));
    const internal::Cut_surface surface(imported, *arranged.arrangement);
    const internal::Part_finder finder(surface);
    internal::limit_parts(tm, given, internal::find_nested_cuts(*arranged.arrangement, finder), np, arranged);
  }
  internal::Curve_splitter splitter(tm, *arranged.arrangement, vpm, mark, visitor);
  splitter.split();

  Split_curves<TriangleMesh> result = {{}, arranged.outcomes};
  result.halfedges.resize(given.size());
  for(std::size_t c = 0; c < arranged.arrangement->number_of_curves(); ++c)
    result.halfedges[arranged.arrangement->curve_number(c)] = splitter.halfedges(c);
  return result;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_CONSTRICTIONS_H
