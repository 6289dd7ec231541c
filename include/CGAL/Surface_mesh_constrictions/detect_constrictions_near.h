// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Local_boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/Local_cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Query_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/reordered.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Forwards to a detection visitor all but the statistics, which it keeps.
template <class Visitor>
struct Statistics_keeper
{
  const Visitor& visitor;
  Detection_statistics& statistics;

  void on_stage_begin(Detection_stage stage, std::size_t steps) const { visitor.on_stage_begin(stage, steps); }
  void on_step(Detection_stage stage, std::size_t done) const { visitor.on_step(stage, done); }
  void on_stage_end(Detection_stage stage) const { visitor.on_stage_end(stage); }
  void on_end(const Detection_statistics& s) const { statistics = s; }
};

// What `detect_constrictions_near()` does with arguments of the right kind.
template <class ConcurrencyTag, class TriangleMesh, class Point, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_near_checked(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                                 const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds the constrictions near a location: "the loop around this arm".
///
/// It is `detect_constrictions()` with other seeds: the loops of `Local_cut_locus_seeds` at the vertex of `tm` that is
/// nearest to `location`; and, on a mesh with holes, the boundaries of the three nearest holes, `Local_boundary_seeds`.
/// The constrictions that the seeds lead to are written in ascending order of \f$d (1 + d/L) + L/10\f$, where \f$L\f$
/// is the length of the curve and \f$d\f$ its distance in space from the location, less the width of its flat band. So
/// the nearest comes first; of two that are about as near the shorter one; and late one whose distance is several times
/// its length.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm: `Sequential_tag`, `Parallel_tag` or
///         `Parallel_if_available_tag`. The output is the same.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Point a 3D point, of any kernel
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, as for `detect_constrictions()`
/// \param location a point on the surface or near it
/// \param out the constrictions, the nearest first. The places that `Constriction::dominated_by()` and
///        `Constriction::crosses()` name are those in this sequence. Prominences are measured among the constrictions
///        that these seeds lead to.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
///        `detect_constrictions()` but for `seed_sources`, `seed_detection` and `first_constriction_only`, with these
///        differences:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the least prominence of a constriction}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: around a tube that does not widen all constrictions have a small prominence, and the caller
///                       wants one of them}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_isolation}
///     \cgalParamDescription{the least isolation of a constriction among those of no less prominence}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_constrictions}
///     \cgalParamDescription{the greatest number of constrictions; the nearest are written}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last constriction
/// \throws Invalid_input as `detect_constrictions()`, and for a location with a coordinate that is not a finite number
/// \throws exceptions of the visitor; then nothing has been written
/// \cost that of `detect_constrictions()` with the seeds of 64 roots: hardly more than that of the simplification
///
/// \sa `detect_constrictions()`
/// \sa `Local_cut_locus_seeds`
/// \sa `Local_boundary_seeds`
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class Point, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator detect_constrictions_near(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                         const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Detection_near_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::detect_constrictions_near_checked<ConcurrencyTag>(tm, location, out, np);
  else
    return out;
}

namespace internal {

template <class ConcurrencyTag, class TriangleMesh, class Point, class OutputIterator, class NamedParameters>
OutputIterator detect_constrictions_near_checked(const TriangleMesh& tm, const Point& location, OutputIterator out,
                                                 const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
  const std::size_t no_limit = (std::numeric_limits<std::size_t>::max)();
  const std::size_t maximum_number =
      choose_parameter(get_parameter(np, internal_np::maximum_number_of_constrictions), no_limit);
  const double minimum_prominence = choose_parameter(get_parameter(np, internal_np::minimum_prominence), 0.0);
  const double minimum_isolation = choose_parameter(get_parameter(np, internal_np::minimum_isolation), 0.0);
  const bool proves_prominence = choose_parameter(get_parameter(np, internal_np::prove_prominence), false);

  const internal::Query_location<TriangleMesh, std::decay_t<decltype(vpm)>> query(tm, vpm, location);
  const Index nearest = query.nearest_vertex();
  typedef internal::Statistics_keeper<std::decay_t<decltype(visitor)>> Keeper;
  Detection_statistics statistics;
  const Named_function_parameters<Keeper, internal_np::visitor_t, NamedParameters> kept(Keeper{visitor, statistics},
                                                                                        np);
  const auto selection = parameters::minimum_prominence(
      minimum_prominence,
      parameters::minimum_isolation(minimum_isolation, parameters::maximum_number_of_constrictions(
                                                           no_limit, parameters::prove_prominence(false, kept))));
  std::vector<Constriction<TriangleMesh>> found;
  detect_constrictions_checked<ConcurrencyTag>(
      tm, std::back_inserter(found),
      parameters::seed_sources(Seed_sources(Local_cut_locus_seeds(nearest), Local_boundary_seeds(nearest)),
                               parameters::first_constriction_only(false, selection)));

  std::vector<double> nearness;
  for(const Constriction<TriangleMesh>& c : found)
  {
    const double distance = (std::max)(0.0, query.distance(c) - c.flat_band_width());
    nearness.push_back(distance * (1 + distance / c.length()) + c.length() / 10);
  }
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&nearness](std::size_t i, std::size_t j) { return nearness[i] < nearness[j]; });
  const std::vector<Constriction<TriangleMesh>> result = internal::reordered(found, order, maximum_number);

  statistics.not_selected += found.size() - result.size();
  visitor.on_end(statistics);
  if(proves_prominence)
    return bound_prominences_checked(tm, result, out, np);
  return std::copy(result.begin(), result.end(), out);
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_NEAR_H
