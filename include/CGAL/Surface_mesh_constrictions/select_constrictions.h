// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SELECT_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SELECT_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/composed_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/ranks_before.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/remove_beside_others.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/rivals.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/reordered.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The default least prominence of a selected constriction.
constexpr double default_minimum_prominence = 0.05;

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The default least isolation of a selected constriction, see `Constriction::isolation()`: two curves around a tube
/// count as one place if they are nearer to each other than half of its diameter.
constexpr double default_minimum_isolation = internal::area_of_one_place; // 0.15

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The default greatest isoperimetric ratio of a selected constriction that separates.
constexpr double default_maximum_isoperimetric_ratio = 0.25;

namespace internal {

struct Selection_parameters
  : Known_parameters<internal_np::minimum_prominence_t, internal_np::minimum_isolation_t,
                     internal_np::maximum_isoperimetric_ratio_t, internal_np::minimum_curve_length_t,
                     internal_np::maximum_curve_length_t, internal_np::maximum_number_of_constrictions_t,
                     internal_np::crossing_constrictions_t, internal_np::rim_constrictions_t,
                     internal_np::all_constrictions_t>
{};

struct Selection_on_mesh_parameters
  : Selection_parameters::With<internal_np::vertex_point_t, internal_np::vertex_index_t>
{};

// What `select_by_prominence()` does with arguments of the right kind.
template <class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator select_by_prominence_checked(const ConstrictionRange& constrictions, OutputIterator out,
                                            const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// selects constrictions by their prominence, which must be known: those that a person would call necks, each once. The
/// selected ones are ranked by prominence times roundness, see `Constriction::roundness()`. So of two that hold as
/// firmly the one comes first that goes straight around one limb.
///
/// A constriction of small prominence hardly gets longer while it slides to a shorter place. The first selected
/// constriction on the way along `Constriction::dominated_by()` represents it. So all thresholds can be changed later,
/// at the cost of sorting.
///
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param constrictions as written by `compute_prominences()`, by this function, or by `detect_constrictions()`
/// \param out the selected ones, those that rank highest first, those of the same rank in their former order.
///        `Constriction::dominated_by()` is the place in this sequence of the representative.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the least prominence of a selected constriction}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.05}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_isolation}
///     \cgalParamDescription{the least isolation of a selected constriction, see `Constriction::isolation()`: the area
///                           that it must sweep to become the next selected one along
///                           `Constriction::dominated_by()` that is no less prominent, relative to its squared length.
///                           That one stands for those that lie nearer to it.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.15}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_isoperimetric_ratio}
///     \cgalParamDescription{the greatest ratio \f$L^2/(4 \pi A)\f$ of a selected constriction that separates, where
///                           *L* is its length and *A* the smaller of its two areas. The ratio is 1/2 for the equator
///                           of a sphere, and 1/4 for the rim of a cylinder with a half sphere at its end that sticks
///                           out as far as it is wide.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.25}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_curve_length}
///     \cgalParamDescription{the least length of a constriction, in the unit of the mesh's coordinates. The bounds of
///                           the length are applied last: constrictions are selected without them, also with
///                           `all_constrictions`, and those out of bounds are then left out. So no curve is selected
///                           because a curve that it crosses or lies beside is out of bounds.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_curve_length}
///     \cgalParamDescription{the greatest length, as above}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_constrictions}
///     \cgalParamDescription{the greatest number of constrictions: those are selected that rank highest among those
///                           whose length is within the bounds}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{crossing_constrictions}
///     \cgalParamDescription{whether to select also constrictions that cross a more prominent selected one there and
///                           back, see `Constriction::crosses()`; that have a rival which could be selected instead,
///                           see `Constriction::rivals()`; that cross four shorter ones of a prominence of 0.3 or more,
///                           or sixteen of any prominence; or that are composed of shorter ones: modulo 2 their
///                           homology class is the sum of the classes of shorter ones, one of which they cross}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{rim_constrictions}
///     \cgalParamDescription{whether to select also rims, see `Constriction::is_rim()`, whatever their prominence and
///                           isoperimetric ratio}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{all_constrictions}
///     \cgalParamDescription{whether to select all, whatever their prominence, isoperimetric ratio and crossings; only
///                           the bounds of the length and of the number still hold}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \cost O(n g^2 + n log n) for n constrictions and genus g, plus the lengths of the ways along
///       `Constriction::dominated_by()` and of `Constriction::crosses()`
template <class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator select_by_prominence(const ConstrictionRange& constrictions, OutputIterator out,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Selection_parameters, NamedParameters>();
  if constexpr(internal::check_output<OutputIterator, std::decay_t<decltype(*constrictions.begin())>>() && knows_all)
    return internal::select_by_prominence_checked(constrictions, out, np);
  else
    return out;
}

namespace internal {

template <class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator select_by_prominence_checked(const ConstrictionRange& constrictions, OutputIterator out,
                                            const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename std::iterator_traits<decltype(constrictions.begin())>::value_type Result;

  const double minimum_prominence =
      choose_parameter(get_parameter(np, internal_np::minimum_prominence), default_minimum_prominence);
  const double minimum_isolation =
      choose_parameter(get_parameter(np, internal_np::minimum_isolation), default_minimum_isolation);
  const double maximum_ratio = choose_parameter(get_parameter(np, internal_np::maximum_isoperimetric_ratio),
                                                default_maximum_isoperimetric_ratio);
  const double minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_curve_length), 0.0);
  const double maximum_length =
      choose_parameter(get_parameter(np, internal_np::maximum_curve_length), std::numeric_limits<double>::infinity());
  const std::size_t maximum_number = choose_parameter(get_parameter(np, internal_np::maximum_number_of_constrictions),
                                                      (std::numeric_limits<std::size_t>::max)());
  const bool with_crossing = choose_parameter(get_parameter(np, internal_np::crossing_constrictions), false);
  const bool all = choose_parameter(get_parameter(np, internal_np::all_constrictions), false) ||
                   !choose_parameter(get_parameter(np, internal_np::measure_prominence), true);
  const bool with_rims = choose_parameter(get_parameter(np, internal_np::rim_constrictions), false);

  const std::vector<Result> given(constrictions.begin(), constrictions.end());
  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < given.size(); ++i)
    if(all || (given[i].is_rim() && with_rims) ||
       (!given[i].is_rim() && given[i].prominence() >= minimum_prominence &&
        (!given[i].is_separating() || given[i].isoperimetric_ratio() <= maximum_ratio)))
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&given](std::size_t i, std::size_t j) { return given[i].prominence() > given[j].prominence(); });
  if(!all && !with_crossing)
  {
    std::vector<bool> is_left_out = internal::family_constrictions(given, order);
    const auto leave_out = [&] {
      order.erase(std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return is_left_out[i]; }),
                  order.end());
    };
    leave_out();
    is_left_out = internal::composed_constrictions(given, order);
    leave_out();
  }

  std::vector<std::size_t> selected = order;
  if(!all && !with_crossing)
  {
    std::vector<std::vector<std::size_t>> crossing(given.size());
    for(std::size_t i = 0; i < given.size(); ++i)
      for(std::size_t j : given[i].crosses())
      {
        crossing[i].push_back(j);
        crossing[j].push_back(i);
      }
    selected = internal::without_crossing_ones(given, order, crossing);
  }
  std::vector<bool> is_selected(given.size(), false);
  for(std::size_t i : selected)
    is_selected[i] = true;
  if(!all)
    internal::remove_beside_others(given, is_selected, minimum_isolation, with_rims, selected);
  std::stable_sort(selected.begin(), selected.end(),
                   [&given](std::size_t i, std::size_t j) { return internal::ranks_before(given[i], given[j]); });
  selected.erase(std::remove_if(selected.begin(), selected.end(),
                                [&](std::size_t i) {
                                  return given[i].length() < minimum_length || given[i].length() > maximum_length;
                                }),
                 selected.end());
  selected.resize((std::min)(selected.size(), maximum_number));
  for(const Result& c : internal::reordered(given, selected, selected.size()))
    *out++ = c;
  return out;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// computes prominences and selects by them: `compute_prominences()` and then `select_by_prominence()`.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param constrictions constrictions of `tm`, as computed on it with the same points
/// \param out the selected ones, those that rank highest first
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" of the two functions
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used
/// \cost that of `compute_prominences()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator select_constrictions(const TriangleMesh& tm, const ConstrictionRange& constrictions, OutputIterator out,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Selection_on_mesh_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
  {
    std::vector<Constriction<TriangleMesh>> all;
    internal::compute_prominences_checked(tm, constrictions, std::back_inserter(all), np);
    return internal::select_by_prominence_checked(all, out, np);
  }
  else
    return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SELECT_CONSTRICTIONS_H
