// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVE_HANDLES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVE_HANDLES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Removed_handle.h>
#include <CGAL/Surface_mesh_constrictions/cut_handles.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/total_genus.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Handle_removal_parameters
  : Handle_parameters::With<internal_np::target_genus_t, internal_np::certify_t, internal_np::visitor_t,
                            internal_np::simplification_policies_t, internal_np::seed_sources_t>
{};

// What `remove_handles()` does with arguments of the right kind.
template <class ConcurrencyTag, class TriangleMesh, class OutputIterator, class NamedParameters>
OutputIterator remove_handles_checked(TriangleMesh& tm, OutputIterator out, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// removes handles of a surface until it has a given genus, the cheapest first: it cuts along constrictions that do not
/// separate it, and closes both ends, see `cut_handles()`.
///
/// In a round all constrictions are searched, and the surface is cut along all that fit at once, up to the number that
/// is left to remove: the shortest first, without those that cross or touch one of these, or would make the surface
/// fall into pieces. On the surface with caps other curves are constrictions. So if the genus asked for is not reached the
/// next round searches anew, and ends when nothing fits any more. The genus reached is that of `tm` before less the
/// number of handles that have been written. It may be greater than that asked for where `maximum_curve_length` or
/// `choked_side` leave nothing, or where the only curves run along a hole or touch themselves.
///
/// \tparam ConcurrencyTag as for `detect_constrictions()`. The output is the same.
/// \tparam TriangleMesh a model of `MutableFaceGraph`, and of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam OutputIterator takes `Removed_handle<Point>`, for the points of the mesh
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, with any number of connected components. The genus is the sum
///        over these, with their holes filled. It is changed in place: see `cut_handles()`.
/// \param out what has been done, round by round, in each the shortest curve first
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadWritePropertyMap` whose value type is a 3D point of a CGAL kernel}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{target_genus}
///     \cgalParamDescription{the genus at which to stop}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
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
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether each curve is certified with exact arithmetic}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{simplification_policies}
///     \cgalParamDescription{see `detect_constrictions()`, as for the next two}
///     \cgalParamType{a model of `ConstrictionSimplificationPolicies`, or a `std::tuple` of several}
///     \cgalParamDefault{`Garland_heckbert_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{seed_sources}
///     \cgalParamDescription{where the seed curves come from}
///     \cgalParamType{a model of `ConstrictionSeedSource`}
///     \cgalParamDefault{`Default_seed_sources`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told of the progress of each round}
///     \cgalParamType{a model of `ConstrictionDetectionVisitor`; it is copied}
///     \cgalParamDefault{`Detection_visitor_base`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used
/// \throws std::invalid_argument if `target_genus` is greater than the genus of `tm`
/// \cost for each round, that of `detect_constrictions()` with `measure_prominence(false)`, and that of `cut_handles()`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator remove_handles(TriangleMesh& tm, OutputIterator out,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Handle_removal_parameters, NamedParameters>();
  if constexpr(internal::check_mutable_mesh<TriangleMesh>() && knows_all)
  {
    if constexpr(internal::check_output<OutputIterator, internal::Removed_handle_of<TriangleMesh, NamedParameters>>())
      return internal::remove_handles_checked<ConcurrencyTag>(tm, out, np);
  }
  return out;
}

namespace internal {

template <class ConcurrencyTag, class TriangleMesh, class OutputIterator, class NamedParameters>
OutputIterator remove_handles_checked(TriangleMesh& tm, OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, tm));
  const std::size_t target = choose_parameter(get_parameter(np, internal_np::target_genus), std::size_t(0));
  const std::size_t genus = total_genus(tm);
  if(target > genus)
    throw std::invalid_argument("the genus of the mesh is " + std::to_string(genus) + ", less than the " +
                                std::to_string(target) + " asked for");
  Handle_limits limits = handle_limits(np);
  limits.maximum_number = (std::min)(limits.maximum_number, genus - target);
  for(std::size_t round = 0; limits.maximum_number > 0; ++round)
  {
    std::vector<Constriction<TriangleMesh>> curves;
    detect_constrictions_checked<ConcurrencyTag>(tm, std::back_inserter(curves),
                                                 CGAL::parameters::measure_prominence(false, np));
    auto handles = cut_handles_within(tm, vpm, curves, limits, round);
    if(handles.empty())
      break;
    limits.maximum_number -= handles.size();
    for(auto& handle : handles)
      *out++ = std::move(handle);
  }
  return out;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_REMOVE_HANDLES_H
