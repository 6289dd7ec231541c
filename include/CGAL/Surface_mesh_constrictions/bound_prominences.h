// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_BOUND_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_BOUND_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curves_on_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Lower_barrier.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A bound is looked for that is higher by this share of a curve's length than its known barrier, which may have been
// measured on a coarser level: if there is one the barrier is measured anew.
constexpr double share_beyond_barrier = 0.02;

// Gives constrictions of T^0, which are these curves there, their intervals. Linear in the mesh, plus the cost of
// `Lower_barrier::bound()` for each curve.
template <class TriangleMesh, class VertexIndexMap>
void set_prominence_intervals(const Progressive_mesh& pm, const Curves_on_copy<TriangleMesh, VertexIndexMap>& curves,
                              std::vector<Constriction<TriangleMesh>>& constrictions)
{
  const Edge_lengths lengths(pm);
  Lower_barrier lower(pm, lengths);
  std::optional<Corner_angles> angles;
  std::optional<Barrier_search> search;
  for(std::size_t i = 0; i < constrictions.size(); ++i)
  {
    typename Constriction<TriangleMesh>::Data data = constrictions[i].data();
    if(std::isnan(data.prominence))
      continue;
    const std::vector<Trace_point>& points = curves.traces[i];
    const double l = length(pm, points);
    double high = data.prominence, low = 0;
    if(!data.rim)
      low = prominence_of_barrier(lower.bound(points, l, (1 + high + share_beyond_barrier) * l), l);
    if(low > high)
    {
      if(!search)
      {
        angles.emplace(pm);
        search.emplace(pm, lengths, *angles);
      }
      const std::vector<Arc>& arcs = curves.arcs[i];
      const Barrier b =
          search->search(arcs, trace(pm, arcs), data.separating, (std::numeric_limits<double>::infinity)());
      high = (std::max)(high, prominence_of_barrier(b.length, l));
    }
    data.prominence_interval = {{(std::min)(low, high), high}};
    constrictions[i] = Constriction<TriangleMesh>(std::move(data));
  }
}

// What `bound_prominences()` does with arguments of the right kind.
template <class TriangleMesh, class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator bound_prominences_checked(const TriangleMesh& tm, const ConstrictionRange& constrictions,
                                         OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);

  std::vector<Constriction<TriangleMesh>> result(constrictions.begin(), constrictions.end());
  Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  set_prominence_intervals(pm, curves_on_copy(result, imported, vim, pm), result);
  return std::move(result.begin(), result.end(), out);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// bounds the prominence of constrictions from below, by a proof, beside the bound from above that
/// `compute_prominences()` gives.
///
/// The prominence of a curve of length *L* is \f$b/L - 1\f$, where the barrier *b* is the least length that the curve
/// must have on its way to a shorter place. The function proves of a length *c* that each way reaches it: it opens a
/// neighborhood of the curve along straight cuts, and computes exact geodesic distances from both sides of each cut.
/// Together they tell how long a curve must be that goes around once and passes a point. Points where that is *c* or
/// more enclose the curve, and within them there is no shorter one. See "A Lower Bound of the Prominence" in the user
/// manual for the theorem, its assumptions, and its proof. The curve may split on its way, as it may for
/// `compute_prominences()`, and parts may vanish, but parts that have left the neighborhood may not join the others
/// again.
///
/// The lower bound is right up to a relative error of \f$10^{-9}\f$ of *L*, which is subtracted, as distances are unfolded
/// in double precision. A curve counts as shorter if it is so by more than that. The bound is 0 for a curve that touches
/// the boundary of the mesh, or where none is found, and it cannot exceed what the curve becomes when a finger of it is
/// drawn out to the nearest point beyond the pass.
///
/// The upper bound is `Constriction::prominence()`. Of a mesh of more than 24,576 vertices `detect_constrictions()`
/// measures it on a coarser level. Where the lower bound shows that it is too small it is measured anew on the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param constrictions constrictions of `tm`, as computed on it with the same points, whose prominences are known
/// \param out the same constrictions in the same order, with `Constriction::prominence_interval()`. Where the
///        prominence is not known the interval is not either.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used, or if locations of a constriction are no curve on it
/// \cost linear in the size of the mesh; plus, for each curve, sixteen times the windows of exact geodesic distances on
///       up to six neighborhoods of some 8,000 faces at most, plus, for vertices near the curve, one such computation
///       each, a thousand at most
///
/// \sa `compute_prominences()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator bound_prominences(const TriangleMesh& tm, const ConstrictionRange& constrictions, OutputIterator out,
                                 const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Mesh_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::bound_prominences_checked(tm, constrictions, out, np);
  else
    return out;
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_BOUND_PROMINENCES_H
