// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CARRY_SEEDS_TO_INPUT_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CARRY_SEEDS_TO_INPUT_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/carry_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/find_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/policies_asked_for.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/simplify.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A coarse level tells only roughly which curves will be selected: there, prominences and isoperimetric ratios may miss
// the thresholds by these factors.
constexpr double coarse_prominence_factor = 0.5;
constexpr double coarse_isoperimetric_factor = 1.2;

// How many seeds are kept of those that become equal there, if constrictions of the default prominence are selected.
// More seeds would lead to more constrictions that hardly differ, of which one is selected.
constexpr std::size_t kept_for_selection = 4;

// On a small mesh with few curves all of them are kept, so that exactly those are selected that are selected of all. More
// curves of larger meshes cost too much: each is certified, and its prominence is measured.
constexpr std::size_t most_swept_faces = 1000000;

// Parameters that carry the seeds which may lead to curves that the named parameters select.
template <class NamedParameters>
Carrying_parameters carrying_parameters(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Carrying_parameters result;
  if(choose_parameter(get_parameter(np, internal_np::all_constrictions), false))
    return result;
  const double prominence =
      choose_parameter(get_parameter(np, internal_np::minimum_prominence), default_minimum_prominence);
  const double ratio = choose_parameter(get_parameter(np, internal_np::maximum_isoperimetric_ratio),
                                        default_maximum_isoperimetric_ratio);
  if(prominence >= default_minimum_prominence)
    result.merging.kept = kept_for_selection;
  result.merging.minimum_prominence = (std::min)(prominence, default_minimum_prominence) * coarse_prominence_factor;
  result.merging.maximum_isoperimetric_ratio = ratio * coarse_isoperimetric_factor;
  result.merging.crossing = choose_parameter(get_parameter(np, internal_np::crossing_constrictions), false);
  result.merging.most_swept_faces = most_swept_faces;
  return result;
}

// Forwards the progress of the refinement to a detection visitor.
template <class Visitor>
struct Refinement_progress : public Refinement_visitor_base
{
  const Visitor& visitor;
  std::size_t levels, done = 0;

  Refinement_progress(const Visitor& visitor, std::size_t levels) : visitor(visitor), levels(levels) {}
  void on_level(std::size_t level)
  {
    if(levels - level <= done)
      return;
    done = levels - level;
    visitor.on_step(Detection_stage::REFINEMENT, done);
  }
};

// Seeds, and the curves that they have become on T^0. The refined curves know their seeds by number.
struct Seeds_on_input
{
  std::vector<Seed_curve> seeds;
  std::vector<Refined_curve> refined;
  std::size_t collapses = 0;
  bool is_complete = true; // whether these are all curves of T^0 that the seeds lead to

  // Appends the seeds that the refined curves from `first` on know by their numbers among these.
  void number_seeds(std::size_t first, std::vector<Seed_curve> added)
  {
    for(std::size_t i = first; i < refined.size(); ++i)
      for(std::size_t& s : refined[i].seeds)
        s += seeds.size();
    seeds.insert(seeds.end(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
  }
};

// Carries seeds without straightening them to T^0, which `pm` is at afterwards, as far as the named parameters may
// select what they lead to: appends them to those that have been carried.
template <class ConcurrencyTag, class NamedParameters, class Visitor>
void carry_unstraightened(Progressive_mesh& pm, std::vector<Seed_curve> seeds, const NamedParameters& np,
                          const Visitor& visitor, Seeds_on_input& all)
{
  visitor.on_stage_begin(Detection_stage::REFINEMENT, pm.number_of_collapses());
  const std::size_t first = all.refined.size();
  Refinement_progress<Visitor> progress(visitor, pm.number_of_collapses());
  const Carrying_parameters parameters = carrying_parameters(np);
  carry_seed_curves<ConcurrencyTag>(pm, seeds, parameters, std::back_inserter(all.refined), progress);
  all.is_complete = all.is_complete && pm.level_with(parameters.merging_vertices) == 0 &&
                    std::none_of(all.refined.begin() + static_cast<std::ptrdiff_t>(first), all.refined.end(),
                                 [](const Refined_curve& r) { return r.is_discarded; });
  all.number_seeds(first, std::move(seeds));
  visitor.on_stage_end(Detection_stage::REFINEMENT);
}

// Simplifies the mesh, finds seeds on the way, and carries them to T^0: appends them to those of other policies.
// Returns the surface, at level 0. Takes the connectivity and the points out of the imported mesh if `is_last`.
template <class ConcurrencyTag, class ImportedMesh, class Policies, class NamedParameters, class Visitor>
Progressive_mesh carry_seeds_to_input(ImportedMesh& imported, bool is_last, const Policies& policies,
                                      const NamedParameters& np, const Visitor& visitor, Seeds_on_input& all)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const bool first_only = choose_parameter(get_parameter(np, internal_np::first_constriction_only), false);
  const bool with_refused_seeds =
      has_seed_sources<NamedParameters> ||
      choose_parameter(get_parameter(np, internal_np::seed_detection), Seed_detection::ON_APPEARANCE) ==
          Seed_detection::ON_REFUSED_COLLAPSE;
  const Tightening_schedule schedule = choose_parameter(
      get_parameter(np, internal_np::tightening_schedule),
      has_seed_detection<NamedParameters> ? Tightening_schedule::AT_THE_END : Tightening_schedule::UNSTRAIGHTENED);

  visitor.on_stage_begin(Detection_stage::SIMPLIFICATION, imported.points.size());
  const Collapse_record record =
      simplify<ConcurrencyTag>(imported, policies, with_refused_seeds, first_only, Block_simplification(), visitor);
  visitor.on_stage_end(Detection_stage::SIMPLIFICATION);
  all.collapses += record.collapses.size();

  visitor.on_stage_begin(Detection_stage::SEEDS, record.collapses.size());
  Progressive_mesh pm = is_last ? Progressive_mesh(std::move(imported.table), std::move(imported.points))
                                : Progressive_mesh(imported.table, imported.points);
  std::vector<Seed_curve> seeds = find_seeds<ConcurrencyTag>(record, np, first_only, visitor, pm);
  visitor.on_stage_end(Detection_stage::SEEDS);

  if(schedule == Tightening_schedule::UNSTRAIGHTENED)
  {
    carry_unstraightened<ConcurrencyTag>(pm, std::move(seeds), np, visitor, all);
    return pm;
  }
  all.is_complete = false;
  visitor.on_stage_begin(Detection_stage::REFINEMENT, pm.number_of_collapses());
  const std::size_t first = all.refined.size();
  Refinement_progress<Visitor> progress(visitor, pm.number_of_collapses());
  refine_seed_curves(pm, seeds, schedule, std::back_inserter(all.refined), progress);
  all.number_seeds(first, std::move(seeds));
  visitor.on_stage_end(Detection_stage::REFINEMENT);
  return pm;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_CARRY_SEEDS_TO_INPUT_H
