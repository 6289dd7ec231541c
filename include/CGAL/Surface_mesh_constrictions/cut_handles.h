// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_HANDLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_HANDLES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Removed_handle.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Handle_cutter.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/choose_handles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Handle_parameters : Point_parameters::With<internal_np::maximum_number_of_handles_t,
                                                  internal_np::maximum_curve_length_t, internal_np::choked_side_t>
{};

template <class TriangleMesh, class NamedParameters>
using Removed_handle_of = Removed_handle<
    typename boost::property_traits<typename GetVertexPointMap<TriangleMesh, NamedParameters>::type>::value_type>;

template <class NamedParameters>
Handle_limits handle_limits(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  Handle_limits result;
  result.maximum_number =
      choose_parameter(get_parameter(np, internal_np::maximum_number_of_handles), result.maximum_number);
  result.maximum_length = choose_parameter(get_parameter(np, internal_np::maximum_curve_length), result.maximum_length);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::choked_side_t>::value)
    result.side = get_parameter(np, internal_np::choked_side);
  return result;
}

// Cuts along those of the curves that fit. Returns what has been done, with this number as the round.
template <class TriangleMesh, class VertexPointMap>
std::vector<Removed_handle<typename boost::property_traits<VertexPointMap>::value_type>>
cut_handles_within(TriangleMesh& tm, VertexPointMap vpm, const std::vector<Constriction<TriangleMesh>>& curves,
                   const Handle_limits& limits, std::size_t round)
{
  const std::vector<std::size_t> chosen = choose_handles(tm, curves, limits);
  if(chosen.empty())
    return {};
  std::vector<Constriction<TriangleMesh>> cuts;
  for(std::size_t i : chosen)
    cuts.push_back(curves[i]);
  auto result = Handle_cutter<TriangleMesh, VertexPointMap>(tm, vpm).cut(cuts);
  for(std::size_t i = 0; i < chosen.size(); ++i)
  {
    result[i].round = round;
    result[i].curve = chosen[i];
  }
  return result;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// cuts a mesh along curves that do not separate it and closes both ends, so that the genus falls by one for each curve
/// that is cut along, and the surface falls into no more pieces.
///
/// Cutting a handle that chokes the object takes a slice out of it; cutting around the hole of a handle, where the
/// complement is choked, fills this tunnel by a slice. The slice lies between two curves beside the given one, on its
/// two sides, at a distance of a hundredth of its length, or less, so that the next vertex on that side is at least
/// three times as far. The part of the surface between them is removed, and each of them is closed by a cap. The two caps have the
/// same triangles, but for the surplus corners of one, so that they do not intersect each other although they are
/// close. They are triangulated as by `extract_parts()`, or are cones if there is no such triangulation.
///
/// Of the curves those that do not separate are taken by their length, the shortest first. A curve is left out if it
/// crosses or touches one that has been taken, itself, or a hole of the mesh, or if the surface would fall into pieces.
/// So a meridian is taken of a torus, and neither its parallel copies nor the equator, which is no closed curve any
/// more once the meridian is cut.
///
/// The mesh is changed in place: elements that no cut touches keep their descriptors, and removed ones are marked as
/// such in meshes that have garbage. Curves of the range no longer fit it. Holes of the mesh stay.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Removed_handle<Point>`, for the points of the mesh
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param curves closed curves on `tm`, found by one call of `detect_constrictions()`
/// \param out what has been done, the shortest curve first
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadWritePropertyMap` whose value type is a 3D point of a CGAL kernel}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_handles}
///     \cgalParamDescription{the greatest number of handles that are removed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_curve_length}
///     \cgalParamDescription{the greatest length of a curve that is cut along, in the unit of the mesh's coordinates}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{choked_side}
///     \cgalParamDescription{only curves that choke this side are cut along: with `Side::OBJECT` handles are cut, with
///                           `Side::COMPLEMENT` tunnels are filled}
///     \cgalParamType{`Side`}
///     \cgalParamDefault{unset: any curve}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The last three are the package's own: see \ref PkgSurfaceMeshConstrictionsNamedParameters "Named Parameters".
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a curve that is not a closed sequence of locations on triangles of `tm`; `tm` is then not
///         changed
/// \cost for the choice, O(n g^2) for n curves and genus g, and what `split_along_constrictions()` costs for all of
///       them; for the cuts, that of triangulating the caps, and of
///       `CGAL::Polygon_mesh_processing::self_intersections()` near them; and linear in the size of the mesh
///
/// \sa `remove_handles()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator cut_handles(TriangleMesh& tm, const ConstrictionRange& curves, OutputIterator out,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Handle_parameters, NamedParameters>();
  if constexpr(internal::check_mutable_mesh<TriangleMesh>() && knows_all)
  {
    if constexpr(internal::check_output<OutputIterator, internal::Removed_handle_of<TriangleMesh, NamedParameters>>())
    {
      using CGAL::parameters::choose_parameter;
      using CGAL::parameters::get_parameter;
      const auto vpm =
          choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, tm));
      const std::vector<Constriction<TriangleMesh>> given(curves.begin(), curves.end());
      for(auto& handle : internal::cut_handles_within(tm, vpm, given, internal::handle_limits(np), 0))
        *out++ = std::move(handle);
    }
  }
  return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CUT_HANDLES_H
