// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/carry_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/Curve_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/Distinct_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/coincidence.h>
#include <CGAL/Surface_mesh_constrictions/internal/make_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Forwards the progress of the refinement to a detection visitor.
template <class Visitor>
struct Refinement_progress
  : public Refinement_visitor_base
{
  const Visitor& visitor;
  std::size_t levels;

  Refinement_progress(const Visitor& visitor, std::size_t levels) : visitor(visitor), levels(levels) {}
  void on_level(std::size_t level)
  {
    if(level < levels)
      visitor.on_step(Detection_stage::REFINEMENT, levels - level);
  }
};

// A curve of T^0 that is going to be returned.
struct Found_curve
{
  Index curve; // of the network
  double length;
  double band_width;
  Certificate certificate;
};

// Sorts curves by length and merges those that are the same but for rounding.
inline void merge_coinciding(Curve_network& network, std::vector<Found_curve>& found)
{
  const Progressive_mesh& pm = network.surface();
  std::stable_sort(found.begin(), found.end(),
                   [](const Found_curve& a, const Found_curve& b) { return a.length < b.length; });
  const auto trace_of = [&](const Found_curve& f) { return trace(pm, arcs_of_curve(network, f.curve)); };
  std::vector<Found_curve> kept;
  for(const Found_curve& f : found)
  {
    bool is_new = true;
    for(auto it = kept.rbegin(); is_new && it != kept.rend(); ++it)
    {
      if(it->length < f.length * (1 - coincidence_tolerance))
        break;
      if(coincide(pm, trace_of(f), trace_of(*it), f.length) && coincide(pm, trace_of(*it), trace_of(f), f.length))
      {
        network.merge(f.curve, it->curve);
        is_new = false;
      }
    }
    if(is_new)
      kept.push_back(f);
  }
  found.swap(kept);
}

// Certifies curves, drops those that are no constrictions, and merges those that have become the same.
template <class Exact_settler, class Progress>
void certify_found(Curve_network& network, Exact_settler& settler, double unit, const std::vector<Refined_curve>& refined,
                   std::vector<Found_curve>& found, Detection_statistics& statistics, const Progress& on_step)
{
  Distinct_curves distinct(network);
  std::vector<Found_curve> certified;
  for(std::size_t i = 0; i < found.size(); ++i)
  {
    Found_curve f = found[i];
    f.certificate = settler.settle(network, f.curve);
    statistics.signs = statistics.signs + f.certificate.signs;
    on_step(i + 1);
    if(f.certificate.is_certified())
    {
      f.length = network.length(f.curve);
      f.band_width = f.certificate.flat_band_width / unit;
      if(distinct.insert(f.curve))
        certified.push_back(f);
      continue;
    }
    std::size_t seeds = 0;
    for(std::size_t r : network.curve(f.curve).seeds)
      seeds += refined[r].seeds.size();
    const Certificate_verdict verdict = f.certificate.verdict;
    (network.is_empty(f.curve) ? statistics.degenerate
     : verdict == Certificate_verdict::CROSSES_ITSELF || verdict == Certificate_verdict::TOUCHES_ITSELF
         ? statistics.not_simple
         : statistics.not_certified) += seeds;
    network.remove(f.curve);
  }
  statistics.corrected = settler.number_of_corrections();
  found.swap(certified);
}

// Builds the progressive mesh from a record and calls the seed source at every level, or as far as the first seed.
template <class SeedSource>
std::vector<Seed_curve> replay(const Collapse_record& record, const SeedSource& source, bool first_only,
                               Progressive_mesh& pm)
{
  Seed_level level = {0, record.collapses.size(), null_index, &record.refused_seeds};
  for(Index v = 0; v < pm.number_of_vertex_ids(); ++v)
    level.vertices += pm.is_vertex(v);
  std::vector<Seed_curve> seeds;
  source(pm, level, std::back_inserter(seeds));
  pm.reserve(record.collapses.size());
  for(const Edge_collapse& c : record.collapses)
  {
    if(first_only && !seeds.empty())
      break;
    pm.append_collapse(c);
    --level.vertices;
    level.merged = c.kept;
    source(pm, level, std::back_inserter(seeds));
  }
  if(first_only && seeds.size() > 1)
    seeds.resize(1);
  return seeds;
}

// The seeds of the source that the named parameters ask for.
template <class NamedParameters>
std::vector<Seed_curve> find_seeds(const Collapse_record& record, const NamedParameters& np, bool first_only,
                                   Progressive_mesh& pm)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::seed_sources_t>::value)
    return replay(record, get_parameter(np, internal_np::seed_sources), first_only, pm);
  else if constexpr(!is_default_parameter<NamedParameters, internal_np::seed_detection_t>::value)
    return get_parameter(np, internal_np::seed_detection) == Seed_detection::ON_APPEARANCE
               ? replay(record, Non_face_triangle_seeds(), first_only, pm)
               : replay(record, Refused_collapse_seeds(), first_only, pm);
  else
    return replay(record, Non_face_triangle_seeds(), first_only, pm);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// finds constrictions of a closed triangle mesh: simple closed curves on it whose length is locally minimal.
///
/// The mesh is copied and the copy simplified by edge collapses; seed curves are noticed on the way; the collapses are
/// undone one by one and the curves carried along; on the input mesh they are tightened until they are closed
/// geodesics. Degenerate curves are dropped and equal ones merged. Of the closed geodesics that are left those are
/// selected that a person would call necks, each once: see `select_constrictions()`. This is the method of Hetroy and
/// Attali, *Detection of constrictions on closed polyhedral surfaces* (2003). The function is the composition of the
/// package's stages; see the user manual.
///
/// The same input gives the same output. `tm` is not changed.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a closed triangle mesh, any genus, any number of connected components. Faces of area zero and isolated
///        vertices are allowed, edges of length zero are not.
/// \param out the selected constrictions, the most prominent first
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point; other than double
///                    coordinates are rounded to the nearest double for the search}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
///   \cgalParamNBegin{get_cost}
///     \cgalParamDescription{the cost of an edge collapse; give `get_placement` with it}
///     \cgalParamType{a model of `GetCost` for edge profiles of `Simplification_mesh`}
///     \cgalParamDefault{`GarlandHeckbert_plane_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{get_placement}
///     \cgalParamDescription{the position of the vertex that an edge is collapsed to; give `get_cost` with it}
///     \cgalParamType{a model of `GetPlacement` for edge profiles of `Simplification_mesh`}
///     \cgalParamDefault{`GarlandHeckbert_plane_policies`}
///   \cgalParamNEnd
///   \cgalParamNBegin{seed_sources}
///     \cgalParamDescription{where the seed curves come from}
///     \cgalParamType{a seed source, see `Non_face_triangle_seeds`; several are one, `Seed_sources`}
///     \cgalParamDefault{`Non_face_triangle_seeds`; `Thorough_seed_sources` find more}
///   \cgalParamNEnd
///   \cgalParamNBegin{seed_detection}
///     \cgalParamDescription{asks for non-face triangles only, as in the paper, and when they are noticed; not looked at
///                           if `seed_sources` is given}
///     \cgalParamType{`Seed_detection`}
///     \cgalParamDefault{unset}
///   \cgalParamNEnd
///   \cgalParamNBegin{tightening_schedule}
///     \cgalParamDescription{how curves are carried to the input and where they are tightened. With other schedules
///                           than `UNSTRAIGHTENED` the cost grows faster than the number of seeds.}
///     \cgalParamType{`Tightening_schedule`}
///     \cgalParamDefault{`Tightening_schedule::UNSTRAIGHTENED` if `seed_sources` is given, else
///                       `Tightening_schedule::AT_THE_END`}
///   \cgalParamNEnd
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether each curve is certified with exact arithmetic, and corrected where rounding has led
///                           it astray. Then only curves with a certificate are returned.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{first_constriction_only}
///     \cgalParamDescription{whether to stop at the first seed curve, and follow that one only. It may degenerate: then
///                           the output is empty.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the prominence that a selected constriction has at least}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.05}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_isoperimetric_ratio}
///     \cgalParamDescription{the ratio \f$L^2/(4 \pi A)\f$ that a selected constriction has at most, if it separates}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.25}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_constrictions}
///     \cgalParamDescription{how many constrictions are selected at most}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{no limit}
///   \cgalParamNEnd
///   \cgalParamNBegin{crossing_constrictions}
///     \cgalParamDescription{whether to select also constrictions that cross a more prominent one that is selected}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{all_constrictions}
///     \cgalParamDescription{whether to select every distinct closed geodesic that was found. A user who keeps them all
///                           can select again at no cost: see `select_by_prominence()`.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{notified of the progress and of what became of the seeds}
///     \cgalParamType{a class like `Detection_visitor_base`; it is copied}
///     \cgalParamDefault{`Detection_visitor_base`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Those from `seed_detection` to `all_constrictions` are functions of
/// `CGAL::Surface_mesh_constrictions::parameters`. CGAL's list of names that can be chained is closed, so they start
/// a chain, `tightening_schedule(t).visitor(v)`, or take one as their second argument, `tightening_schedule(t,
/// CGAL::parameters::visitor(v))`.
///
/// \throws Invalid_input for a mesh that cannot be used; it says what is wrong and where
/// \cost that of the simplification, O(n log n) for n faces, plus O(n), plus for each curve and each vertex split whose
///       star it passes through, linear in the lengths of the strips between the nearest pivots, plus that of
///       `compute_prominences()`
///
/// \sa `tighten_closed_curve()`
/// \sa `select_constrictions()`
template <class TriangleMesh, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator detect_constrictions(const TriangleMesh& tm, OutputIterator out,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
  const bool has_sources = !CGAL::parameters::is_default_parameter<NamedParameters, internal_np::seed_sources_t>::value;
  const bool with_refused_seeds =
      choose_parameter(get_parameter(np, internal_np::seed_detection), Seed_detection::ON_APPEARANCE) ==
          Seed_detection::ON_REFUSED_COLLAPSE ||
      has_sources;
  const Tightening_schedule schedule = choose_parameter(get_parameter(np, internal_np::tightening_schedule),
                                                        has_sources ? Tightening_schedule::UNSTRAIGHTENED
                                                                    : Tightening_schedule::AT_THE_END);
  const bool certifies = choose_parameter(get_parameter(np, internal_np::certify), true);
  const bool first_only = choose_parameter(get_parameter(np, internal_np::first_constriction_only), false);

  Detection_statistics statistics;
  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const std::size_t expected_collapses = imported.points.size();

  visitor.on_stage_begin(Detection_stage::SIMPLIFICATION, expected_collapses);
  const Collapse_record record = internal::simplify(imported, with_refused_seeds, first_only, visitor, np);
  visitor.on_stage_end(Detection_stage::SIMPLIFICATION);

  Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  const std::vector<Seed_curve> seeds = internal::find_seeds(record, np, first_only, pm);
  statistics.collapses = record.collapses.size();
  statistics.seeds = seeds.size();

  visitor.on_stage_begin(Detection_stage::REFINEMENT, pm.number_of_collapses());
  std::vector<Refined_curve> refined;
  internal::Refinement_progress<decltype(visitor)> progress(visitor, pm.number_of_collapses());
  if(schedule == Tightening_schedule::UNSTRAIGHTENED)
    carry_seed_curves(pm, seeds, Carrying_parameters(), std::back_inserter(refined), progress);
  else
    refine_seed_curves(pm, seeds, schedule, std::back_inserter(refined), progress);
  visitor.on_stage_end(Detection_stage::REFINEMENT);

  visitor.on_stage_begin(Detection_stage::TIGHTENING, refined.size());
  internal::Curve_network network(pm, false);
  internal::Curve_settler settler(network);
  internal::Distinct_curves distinct(network);
  std::vector<internal::Found_curve> found;
  for(std::size_t i = 0; i < refined.size(); ++i)
  {
    const Index c = network.add_curve(i);
    std::vector<internal::Arc> arcs = internal::arcs_of_curve(pm, refined[i].curve);
    network.set_arcs(c, arcs);
    const Tightening_verdict verdict = settler.settle(c);
    if(verdict == Tightening_verdict::DEGENERATE)
      statistics.degenerate += refined[i].seeds.size();
    else if(verdict == Tightening_verdict::NOT_SIMPLE && !certifies)
    {
      statistics.not_simple += refined[i].seeds.size();
      network.remove(c);
    }
    else if(distinct.insert(c))
      found.push_back({c, network.length(c), settler.band_width(), Certificate()});
    visitor.on_step(Detection_stage::TIGHTENING, i + 1);
  }
  statistics.leaky_bands = settler.number_of_leaks();
  visitor.on_stage_end(Detection_stage::TIGHTENING);

  visitor.on_stage_begin(Detection_stage::CERTIFICATION, certifies ? found.size() : 0);
  if(certifies)
  {
    internal::Exact_settler<TriangleMesh, std::decay_t<decltype(vpm)> > exact_settler(pm, imported, vpm);
    internal::certify_found(network, exact_settler, imported.unit(), refined, found, statistics, [&visitor](std::size_t i) {
      visitor.on_step(Detection_stage::CERTIFICATION, i);
    });
  }
  internal::merge_coinciding(network, found);

  internal::Constriction_maker<TriangleMesh> maker(imported, pm);
  std::vector<Constriction<TriangleMesh> > constrictions, selected;
  std::vector<std::vector<internal::Trace_point> > traces;
  for(const internal::Found_curve& f : found)
  {
    std::vector<Seed_curve> its_seeds;
    for(std::size_t i : network.curve(f.curve).seeds)
      for(std::size_t s : refined[i].seeds)
        its_seeds.push_back(seeds[s]);
    statistics.merged += its_seeds.size() - 1;
    constrictions.push_back(maker.make(network, f.curve, its_seeds, f.band_width, f.certificate));
    traces.push_back(internal::trace(pm, internal::arcs_of_curve(network, f.curve)));
  }
  visitor.on_stage_end(Detection_stage::CERTIFICATION);

  visitor.on_stage_begin(Detection_stage::SELECTION, constrictions.size());
  internal::set_prominences(pm, traces, constrictions);
  select_by_prominence(constrictions, std::back_inserter(selected), np);
  statistics.not_selected = constrictions.size() - selected.size();
  visitor.on_stage_end(Detection_stage::SELECTION);

  visitor.on_end(statistics);
  return std::move(selected.begin(), selected.end(), out);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_DETECT_CONSTRICTIONS_H
