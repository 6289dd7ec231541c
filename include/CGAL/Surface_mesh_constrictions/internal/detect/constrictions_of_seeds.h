// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_OF_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_OF_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Detected_hierarchy.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/carry_seeds_to_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/found_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_canonical.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/make_constriction.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_settler.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/accurate_trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Measuring_level.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Group.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The constrictions that seeds which have been carried to T^0, `pm`, lead to, with their prominences: those that the
// named parameters may select. `sides` is of T^0, `levels` those to measure on.
template <class ConcurrencyTag, class TriangleMesh, class VertexPointMap, class NamedParameters, class Visitor>
std::vector<Constriction<TriangleMesh>>
constrictions_of_seeds(const Imported_mesh<TriangleMesh>& imported, const Progressive_mesh& pm,
                       const std::deque<Measuring_level>& levels, const Surface_sides& sides, VertexPointMap vpm,
                       Seeds_on_input& carried, const NamedParameters& np, const Visitor& visitor,
                       Detection_statistics& statistics)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const bool certifies = choose_parameter(get_parameter(np, internal_np::certify), true);
  const bool certified_only = choose_parameter(get_parameter(np, internal_np::certified_only), false);
  const bool measures = choose_parameter(get_parameter(np, internal_np::measure_prominence), true);
  const bool selects_all = choose_parameter(get_parameter(np, internal_np::all_constrictions), false) || !measures;
  const double maximum_ratio = choose_parameter(get_parameter(np, internal_np::maximum_isoperimetric_ratio),
                                                default_maximum_isoperimetric_ratio);
  const bool with_rims = choose_parameter(get_parameter(np, internal_np::rim_constrictions), false);
  std::vector<Seed_curve>& seeds = carried.seeds;
  std::vector<Refined_curve>& refined = carried.refined;
  statistics.collapses = carried.collapses;

  visitor.on_stage_begin(Detection_stage::TIGHTENING, refined.size());
  Curve_network network(pm, false);
  std::vector<Found_curve> found =
      tighten_refined<ConcurrencyTag>(network, refined, certifies, statistics,
                                      [&visitor](std::size_t i) { visitor.on_step(Detection_stage::TIGHTENING, i); });
  if(!selects_all && !carried.is_complete) // of a complete hierarchy those that are too long are part
    statistics.not_selected += drop_too_long<ConcurrencyTag>(network, sides, maximum_ratio, with_rims, found);
  visitor.on_stage_end(Detection_stage::TIGHTENING);

  // what certifies curves and corrects them
  const auto certify = [&](std::vector<Found_curve>& curves, const auto& on_step) {
    // other numbers than the built-in ones may share what they are made of
    typedef std::decay_t<decltype(get(vpm, imported.vertex(0)).x())> Coordinate;
    typedef std::conditional_t<std::is_arithmetic<Coordinate>::value, ConcurrencyTag, Sequential_tag> Certification_tag;
    if(certifies)
      certify_found<Certification_tag>(
          network, [&] { return Exact_settler<TriangleMesh, VertexPointMap>(pm, imported, vpm); }, imported.unit(),
          !certified_only, refined, curves, statistics, on_step);
  };
  visitor.on_stage_begin(Detection_stage::CERTIFICATION, certifies ? found.size() : 0);
  certify(found, [&visitor](std::size_t i) { visitor.on_step(Detection_stage::CERTIFICATION, i); });
  visitor.on_stage_end(Detection_stage::CERTIFICATION);

  visitor.on_stage_begin(Detection_stage::SELECTION, measures ? Prominence_meter::steps_of_curve * found.size() : 0);
  Detected_hierarchy hierarchy(pm, levels, sides, network);
  std::size_t passed = 0;
  if(measures)
    passed = hierarchy.close<ConcurrencyTag>(
        found, refined, seeds, [&](std::vector<Found_curve>& curves) { certify(curves, [](std::size_t) {}); },
        [&visitor](std::size_t i) { visitor.on_step(Detection_stage::SELECTION, i); });
  statistics.barriers = static_cast<std::size_t>(std::count_if(
      seeds.begin(), seeds.end(), [](const Seed_curve& seed) { return seed.origin == Seed_origin::BARRIER; }));
  statistics.seeds = seeds.size() - statistics.barriers;
  statistics.barriers -= passed;
  const Constriction_maker<TriangleMesh> maker(imported, pm, sides);
  for(const Found_curve& f : found)
    make_canonical(network, f.curve, f.certificate);
  struct Made
  {
    std::vector<Constriction<TriangleMesh>> constrictions;
    std::vector<std::vector<Trace_point>> traces;
    std::size_t seeds = 0;
  };
  auto in_groups = make_groups<Made>(found.size(), 8);
  CGAL::for_each<ConcurrencyTag>(in_groups, [&](Group<Made>& group) {
    for(std::size_t k = group.begin; k < group.end; ++k)
    {
      const Found_curve& f = found[k];
      std::vector<Seed_curve> its_seeds;
      for(std::size_t i : network.curve(f.curve).seeds)
        for(std::size_t s : refined[i].seeds)
          its_seeds.push_back(seeds[s]);
      group.result.seeds += its_seeds.size();
      std::vector<Trace_point> points = accurate_trace(pm, arcs_of_curve(network, f.curve));
      group.result.constrictions.push_back(
          maker.make(network, f.curve, points, its_seeds, f.band_width, f.certificate));
      group.result.traces.push_back(std::move(points));
    }
    return true;
  });
  std::vector<Constriction<TriangleMesh>> constrictions;
  std::vector<std::vector<Trace_point>> traces;
  for(Group<Made>& group : in_groups)
  {
    statistics.merged += group.result.seeds - (group.end - group.begin);
    std::move(group.result.constrictions.begin(), group.result.constrictions.end(), std::back_inserter(constrictions));
    std::move(group.result.traces.begin(), group.result.traces.end(), std::back_inserter(traces));
  }
  if(measures)
    set_prominences(pm, sides, imported, traces, hierarchy.entries(found), constrictions);
  else
    std::stable_sort(constrictions.begin(), constrictions.end(),
                     [](const auto& a, const auto& b) { return a.length() < b.length(); });
  visitor.on_stage_end(Detection_stage::SELECTION);
  return constrictions;
}

// Writes those of the constrictions that the named parameters select, after telling the visitor of the statistics.
template <class TriangleMesh, class OutputIterator, class NamedParameters, class Visitor>
OutputIterator write_selected(const std::vector<Constriction<TriangleMesh>>& constrictions, OutputIterator out,
                              const NamedParameters& np, const Visitor& visitor, Detection_statistics statistics)
{
  std::vector<Constriction<TriangleMesh>> selected;
  select_by_prominence_checked(constrictions, std::back_inserter(selected), np);
  statistics.not_selected += constrictions.size() - selected.size();
  visitor.on_end(statistics);
  return std::move(selected.begin(), selected.end(), out);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CONSTRICTIONS_OF_SEEDS_H
