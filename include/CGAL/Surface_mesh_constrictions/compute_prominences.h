// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/by_length.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/crossings_of_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossed_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curves_on_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Slides.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/rivals.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A place in the hierarchy of constrictions.
struct Hierarchy_entry
{
  double prominence;
  std::optional<std::size_t> dominated_by; // place of a constriction
  Index slides_off;                        // vertex, or null_index
  bool has_end;                            // whether the curve can become shorter
};

// A curve that cannot become shorter has no barrier. How long it is when its two swept sides meet depends on where it
// lies. So that equal holes are equally prominent, all curves of nearly the same length and of one shape get the least
// of these values, but none less than its own length. `are_alike(i, j)` tells of two curves of nearly the same length
// whether they have the same shape: around a hole and around the body beside it, curves may be as long as each other by
// chance. Lengths and entries are in the same order. Quadratic in the number of curves of one length.
template <class AreAlike>
void level_endless(const std::vector<double>& lengths, const AreAlike& are_alike, std::vector<Hierarchy_entry>& entries)
{
  std::vector<Index> order = by_length(lengths);
  order.erase(std::remove_if(order.begin(), order.end(), [&](Index i) { return entries[i].has_end; }), order.end());
  std::vector<bool> is_level(entries.size(), false);
  for(std::size_t begin = 0; begin < order.size(); ++begin)
  {
    const Index first = order[begin];
    if(is_level[first])
      continue;
    std::vector<Index> equal;
    double least = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = begin; i < order.size() && lengths[order[i]] <= lengths[first] * (1 + alike_tolerance); ++i)
    {
      const Index other = order[i];
      if(is_level[other] || (other != first && !are_alike(first, other)))
        continue;
      is_level[other] = true;
      equal.push_back(other);
      least = (std::min)(least, (1 + entries[other].prominence) * lengths[other]);
    }
    for(Index i : equal)
      entries[i].prominence = prominence_of_barrier(least, lengths[i]);
  }
}

// Of two curves without an end that are at one place the longer one can become the other, though no way to it has been
// found. `isolation(i, j)` is the area between two of them, relative to the squared length of number i. Quadratic in the
// number of curves without an end.
template <class Isolation>
void lead_endless(const std::vector<double>& lengths, const Isolation& isolation, std::vector<Hierarchy_entry>& entries)
{
  std::vector<Index> shorter;
  for(Index i : by_length(lengths))
  {
    if(entries[i].has_end)
      continue;
    double least = area_of_one_place;
    for(Index j : shorter)
      if(const double area = isolation(i, j); area < least)
      {
        least = area;
        entries[i].dominated_by = j;
      }
    shorter.push_back(i);
  }
}

// Of two curves of nearly the same length and prominence that are at one place the longer one can become the other,
// though no way to it has been found: what crosses a curve, or partly runs along it, lies on no level set of the
// distance to it. `isolation(i, j)` as above. Cost: that of `isolation` for each pair of such lengths and prominences.
template <class Isolation>
void lead_twins(const std::vector<double>& lengths, const Isolation& isolation, std::vector<Hierarchy_entry>& entries)
{
  const auto comes_to = [&](std::optional<std::size_t> from, std::size_t i) {
    while(from && *from != i)
      from = entries[*from].dominated_by;
    return from.has_value();
  };
  const std::vector<Index> order = by_length(lengths);
  for(std::size_t n = 0; n < order.size(); ++n)
  {
    const Index i = order[n];
    Hierarchy_entry& e = entries[i];
    if(!e.has_end || e.prominence < negligible_prominence ||
       (e.dominated_by && isolation(i, *e.dominated_by) < area_of_one_place))
      continue;
    double least = area_of_one_place;
    for(std::size_t k = n; k > 0 && lengths[order[k - 1]] >= (1 - alike_tolerance) * lengths[i]; --k)
    {
      const Index j = order[k - 1];
      if(!are_like_twins(lengths[i], e.prominence, lengths[j], entries[j].prominence) || comes_to(j, i))
        continue;
      if(const double area = isolation(i, j); area < least)
      {
        least = area;
        e.dominated_by = j;
        e.slides_off = null_index;
      }
    }
  }
}

// For each of some simple closed geodesics of T^0 the shorter ones that it crosses there and back. Those for which
// `is_known` is false are not listed. Linear in the mesh, plus the curves that each crosses.
inline Earlier_curves crossed_evenly(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point>>& traces,
                                     const std::vector<double>& lengths, const std::vector<bool>& is_known)
{
  Earlier_curves result(traces.size());
  Crossed_curves crossed(pm);
  std::vector<Index> known;
  for(Index i : by_length(lengths))
  {
    for(Index a : crossed.crossed_by(traces[i]))
      result[i].push_back(known[a]);
    if(!is_known[i])
      continue;
    crossed.add(traces[i]);
    known.push_back(i);
  }
  return result;
}

// Curves whose boxes are farther apart than twice this share of their length are not at one place: if the area between
// them were less than `area_of_one_place`, it would be a tube much thinner than they are.
constexpr double reach_of_one_place = 0.25;

// The box around a curve, and as much as `reach` on each side.
inline Bbox_3 surroundings_of_curve(const Progressive_mesh& pm, const std::vector<Trace_point>& trace, double reach)
{
  Bbox_3 box;
  for(const Trace_point& point : trace)
  {
    const Vector3 p = position(pm, point);
    box += Bbox_3(p.x - reach, p.y - reach, p.z - reach, p.x + reach, p.y + reach, p.z + reach);
  }
  return box;
}

// Equal holes that are meshed differently have curves around them whose roundness differs by less than this.
constexpr double greatest_difference_of_roundness = 0.02;

// Gives constrictions of T^0, of which these are the traces, their places in the hierarchy, and which of the others
// they cross.
template <class TriangleMesh>
void set_prominences(const Progressive_mesh& pm, const Surface_sides& sides,
                     const Imported_mesh<TriangleMesh>& imported, const std::vector<std::vector<Trace_point>>& traces,
                     std::vector<Hierarchy_entry> entries, std::vector<Constriction<TriangleMesh>>& constrictions)
{
  typedef typename Constriction<TriangleMesh>::Data Data;
  std::vector<Data> data;
  std::vector<Index> not_separating; // by length
  std::vector<double> lengths;
  for(const Constriction<TriangleMesh>& c : constrictions)
  {
    data.push_back(c.data());
    lengths.push_back(c.length());
  }
  level_endless(
      lengths,
      [&](std::size_t i, std::size_t j) {
        return data[i].side == data[j].side &&
               std::abs(data[i].roundness - data[j].roundness) <= greatest_difference_of_roundness;
      },
      entries);
  std::vector<double> lengths_here; // in the unit of the surface
  std::vector<Bbox_3> surroundings;
  for(const std::vector<Trace_point>& trace : traces)
  {
    lengths_here.push_back(length(pm, trace));
    surroundings.push_back(surroundings_of_curve(pm, trace, reach_of_one_place * lengths_here.back()));
  }
  std::vector<std::optional<Surface_sides::Bounds>> bounds(traces.size());
  const auto bounds_of = [&](std::size_t i) -> const Surface_sides::Bounds& {
    if(!bounds[i])
      bounds[i] = sides.bounds(traces[i]);
    return *bounds[i];
  };
  // the area that a curve must sweep to become another one, relative to its squared length
  const auto isolation_from = [&](std::size_t i, std::size_t j) {
    return data[i].homology_class != data[j].homology_class
               ? (std::numeric_limits<double>::infinity)()
               : sides.area_between(bounds_of(i), bounds_of(j)) / (lengths_here[i] * lengths_here[i]);
  };
  const auto isolation_nearby = [&](std::size_t i, std::size_t j) {
    return do_overlap(surroundings[i], surroundings[j]) ? isolation_from(i, j)
                                                        : (std::numeric_limits<double>::infinity)();
  };
  lead_endless(lengths, isolation_nearby, entries);
  lead_twins(lengths, isolation_nearby, entries);
  std::vector<bool> is_known;
  for(std::size_t i = 0; i < data.size(); ++i)
  {
    data[i].prominence = entries[i].prominence;
    data[i].dominated_by = entries[i].dominated_by;
    data[i].isolation =
        data[i].dominated_by ? isolation_from(i, *data[i].dominated_by) : (std::numeric_limits<double>::infinity)();
    data[i].slides_off.reset();
    if(entries[i].slides_off != null_index)
      data[i].slides_off = imported.vertex(entries[i].slides_off);
    is_known.push_back(entries[i].prominence >= negligible_prominence);
  }
  const Earlier_curves crossed = crossed_evenly(pm, traces, lengths, is_known);
  std::vector<std::vector<Trace_point>> their_traces;
  for(Index i : by_length(lengths))
  {
    data[i].crosses.assign(crossed[i].begin(), crossed[i].end());
    data[i].crosses_oddly.clear();
    data[i].rivals.clear();
    if(!data[i].separating && is_known[i])
    {
      not_separating.push_back(i);
      their_traces.push_back(traces[i]);
    }
  }
  const Earlier_curves odd = odd_crossings(pm, their_traces), in_faces = crossings_in_faces(pm, their_traces);
  for(std::size_t i = 0; i < odd.size(); ++i)
  {
    Data& d = data[not_separating[i]];
    for(Index j : odd[i])
      d.crosses_oddly.push_back(not_separating[j]);
    for(Index j : in_faces[i])
      if(!std::binary_search(odd[i].begin(), odd[i].end(), j) &&
         std::find(d.crosses.begin(), d.crosses.end(), not_separating[j]) == d.crosses.end())
        d.crosses.push_back(not_separating[j]);
  }
  for(std::size_t i = 0; i < data.size(); ++i)
    for(std::size_t j : data[i].crosses)
      if(are_alike(data[i].prominence, data[j].prominence) && isolation_from(i, j) >= area_of_one_place)
      {
        data[i].rivals.push_back(j);
        data[j].rivals.push_back(i);
      }
  for(std::size_t i = 0; i < data.size(); ++i)
    constrictions[i] = Constriction<TriangleMesh>(std::move(data[i]));
}

// Lengths that differ by less than a tolerance count as equal, so that a way along dominated_by may come back: each of
// three curves may stand for the one before. Such ways end at the first curve of the ring. Linear.
inline void break_rings(std::vector<Hierarchy_entry>& entries)
{
  std::vector<std::size_t> way_of(entries.size(), entries.size()); // the first way that passes an entry
  for(std::size_t way = 0; way < entries.size(); ++way)
    for(std::optional<std::size_t> i = way; i && (way_of[*i] == entries.size() || way_of[*i] == way);)
    {
      std::optional<std::size_t>& next = entries[*i].dominated_by;
      if(way_of[*i] == way)
        next.reset();
      way_of[*i] = way;
      i = next;
    }
}

// The hierarchy of simple closed geodesics of T^0 among each other: what is not among them is followed on to what it
// slides to.
inline std::vector<Hierarchy_entry> hierarchy(const Progressive_mesh& pm, const Surface_sides& sides,
                                              const std::vector<std::vector<Arc>>& curves)
{
  Slides slides(pm, sides);
  std::vector<Index> numbers;
  std::unordered_map<Index, std::size_t> place;
  for(const std::vector<Arc>& arcs : curves)
  {
    numbers.push_back(slides.enter(arcs));
    place.emplace(numbers.back(), numbers.size() - 1);
  }
  // the place of a curve or of its twin; none if neither is among them
  const auto place_of = [&](Index c) -> std::optional<std::size_t> {
    if(const auto it = place.find(c); it != place.end())
      return it->second;
    const auto twin =
        std::find_if(numbers.begin(), numbers.end(), [&](Index given) { return slides.are_twins(c, given); });
    return twin == numbers.end() ? std::nullopt : std::make_optional(place.at(*twin));
  };
  std::vector<Hierarchy_entry> result;
  for(std::size_t i = 0; i < numbers.size(); ++i)
  {
    const Barrier* b = &slides.barrier(numbers[i]);
    const double prominence = slides.prominence(numbers[i]);
    const bool has_end = b->end != Barrier_end::NONE;
    std::unordered_set<Index> passed; // they may form a ring, see `break_rings()`
    std::optional<std::size_t> to;
    for(; b->end == Barrier_end::CURVE && passed.insert(b->curve).second; b = &slides.barrier(b->curve))
      if((to = place_of(b->curve)) && *to != i)
        break;
    result.push_back({prominence, std::nullopt, b->vertex, has_end});
    if(b->end == Barrier_end::CURVE && to && *to != i)
      result.back().dominated_by = to;
  }
  break_rings(result);
  return result;
}

// What `compute_prominences()` does with arguments of the right kind.
template <class TriangleMesh, class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator compute_prominences_checked(const TriangleMesh& tm, const ConstrictionRange& constrictions,
                                           OutputIterator out, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// computes the prominence of each of a set of constrictions, and to which other one each slides.
///
/// As for mountain passes, the prominence of a closed geodesic says how much longer it must become before it can slide
/// to a shorter place: to a shorter constriction, of the set or not, or off over a point. It is \f$b/L - 1\f$, where
/// *L* is the length of the curve and *b* its lowest *barrier*: the greatest length on the way.
///
/// The function sweeps both sides of the curve by the level sets of the distance to it. The swept region of a side is
/// bounded by closed curves that together are homologous to the curve. Now and then the function tightens them. Before
/// the pass they do not become shorter than *L*; behind the pass they do. The barrier of the side is the greatest
/// length up to the first level behind the pass. The function always sweeps on the side whose barrier is lower so far,
/// and so nothing that is higher than the lowest barrier. Where two stretches of the curve run along each other with no
/// vertex between them, what it takes to draw them together counts, too.
///
/// This is an upper bound of the least barrier over all ways on which the curve may split into several: the curve can
/// be moved through the level sets, and tightening only shortens. The lengths are exact but for rounding, whatever the
/// error of the distances, which come from fast marching and are right to first order in the size of the faces. They
/// are sampled at 256 level sets on the first stretch of length *L*.
///
/// Behind the pass the curve ends: in a shorter constriction, `Constriction::dominated_by()`, or in a point, where it
/// `Constriction::slides_off()`. If that constriction is not in the set, the function follows it on to the one that it
/// slides to. Lengths do not grow along `Constriction::dominated_by()`, and of two curves of equal length always the
/// same one stands for both, so that the way along it ends. A curve that does not separate may have no end, because it
/// cannot become shorter; of two at one place, with hardly any area between them, the longer one slides to the other.
/// So does the longer one of any two at one place that are nearly as long and as prominent as each other, though the
/// sweep has found no way between them: they may cross, or run along each other.
/// Its prominence tells how long it is when its two swept sides meet; several such curves of the same length and shape,
/// as around equal holes, all get the least of these values.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param constrictions constrictions of `tm`, as computed on it with the same points
/// \param out the same constrictions in the same order, with `Constriction::prominence()`, `Constriction::isolation()`,
///        `Constriction::dominated_by()`, `Constriction::slides_off()`, `Constriction::crosses()`,
///        `Constriction::crosses_oddly()` and `Constriction::rivals()`
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
/// \cost linear in the size of the mesh; plus, for each curve and each curve that it slides to, O(m log m) for the m
///       faces that are swept, and the tightening of O(log m) level sets
///
/// \sa `select_constrictions()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator compute_prominences(const TriangleMesh& tm, const ConstrictionRange& constrictions, OutputIterator out,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Mesh_parameters, NamedParameters>();
  if constexpr(internal::check_mesh_and_output<TriangleMesh, OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    return internal::compute_prominences_checked(tm, constrictions, out, np);
  else
    return out;
}

namespace internal {

template <class TriangleMesh, class ConstrictionRange, class OutputIterator, class NamedParameters>
OutputIterator compute_prominences_checked(const TriangleMesh& tm, const ConstrictionRange& constrictions,
                                           OutputIterator out, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);

  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  std::vector<Constriction<TriangleMesh>> result(constrictions.begin(), constrictions.end());
  const auto curves = internal::curves_on_copy(result, imported, vim, pm);
  const internal::Surface_sides sides(pm);
  internal::set_prominences(pm, sides, imported, curves.traces, internal::hierarchy(pm, sides, curves.arcs), result);
  return std::move(result.begin(), result.end(), out);
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H
