// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_NEAR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_NEAR_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Near_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/given_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The named parameters of a query near a location, beside those of the mesh and its simplification.
struct Near_parameters
  : Selection_parameters::With<internal_np::visitor_t, internal_np::certify_t, internal_np::certified_only_t>
{};

template <class NamedParameters>
Near_selection near_selection(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Near_selection result;
  result.maximum_number = choose_parameter(get_parameter(np, internal_np::maximum_number_of_constrictions),
                                           (std::numeric_limits<std::size_t>::max)());
  result.minimum_prominence = choose_parameter(get_parameter(np, internal_np::minimum_prominence), 0.0);
  result.minimum_isolation = choose_parameter(get_parameter(np, internal_np::minimum_isolation), 0.0);
  result.maximum_ratio = choose_parameter(get_parameter(np, internal_np::maximum_isoperimetric_ratio),
                                          default_maximum_isoperimetric_ratio);
  result.minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_curve_length), 0.0);
  result.maximum_length =
      choose_parameter(get_parameter(np, internal_np::maximum_curve_length), std::numeric_limits<double>::infinity());
  result.all = choose_parameter(get_parameter(np, internal_np::all_constrictions), false);
  result.with_crossing = choose_parameter(get_parameter(np, internal_np::crossing_constrictions), false);
  result.with_rims = choose_parameter(get_parameter(np, internal_np::rim_constrictions), false);
  result.certifies = choose_parameter(get_parameter(np, internal_np::certify), true);
  result.certified_only = choose_parameter(get_parameter(np, internal_np::certified_only), false);
  return result;
}

// Writes the constrictions of a prepared surface around a location, the nearest first. Throws Invalid_input for a
// coordinate that is not a finite number.
template <class ConcurrencyTag, class TriangleMesh, class VertexPointMap, class Point, class OutputIterator,
          class NamedParameters>
OutputIterator write_constrictions_near(const Prepared_surface<TriangleMesh, VertexPointMap>& prepared,
                                        const Point& location, OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
  Near_search<TriangleMesh, VertexPointMap> search(prepared, given_point(prepared.imported(), location),
                                                   near_selection(np));
  const std::vector<Constriction<TriangleMesh>> result = search.template search<ConcurrencyTag>(visitor);
  visitor.on_end(search.statistics());
  return std::copy(result.begin(), result.end(), out);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_NEAR_H
