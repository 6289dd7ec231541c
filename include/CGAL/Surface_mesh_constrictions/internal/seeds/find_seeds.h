// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_FIND_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_FIND_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Redundant_triangles.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

template <class NamedParameters>
constexpr bool has_seed_sources =
    !CGAL::parameters::is_default_parameter<NamedParameters, internal_np::seed_sources_t>::value;

// Whether the named parameters restrict the seeds to non-face triangles, as in the paper.
template <class NamedParameters>
constexpr bool has_seed_detection =
    !has_seed_sources<NamedParameters> &&
    !CGAL::parameters::is_default_parameter<NamedParameters, internal_np::seed_detection_t>::value;

// Builds the progressive mesh from a record and calls the seed source at every level, or as far as the first seed.
template <class ConcurrencyTag, class SeedSource, class Visitor>
std::vector<Seed_curve> replay(const Collapse_record& record, const SeedSource& source, bool first_only,
                               const Visitor& visitor, Progressive_mesh& pm)
{
  Seed_level level = {pm.number_of_vertices(), record.collapses.size(), null_index, &record.refused_seeds,
                      std::is_convertible<ConcurrencyTag, Parallel_tag>::value};
  std::vector<Seed_curve> seeds;
  Redundant_triangles redundant;
  source(pm, level, std::back_inserter(seeds));
  redundant.remove(pm, level.vertices, 0, seeds);
  if(first_only && !seeds.empty())
    return {seeds.front()};
  pm.append_collapses(record.collapses, [&](const Edge_collapse& c) {
    --level.vertices;
    level.merged = c.kept;
    const std::size_t before = seeds.size();
    source(pm, level, std::back_inserter(seeds));
    redundant.remove(pm, level.vertices, before, seeds);
    visitor.on_step(Detection_stage::SEEDS, pm.level());
    return !first_only || seeds.empty();
  });
  if(first_only && seeds.size() > 1)
    seeds.resize(1);
  return seeds;
}

// The seeds of the source that the named parameters choose.
template <class ConcurrencyTag, class NamedParameters, class Visitor>
std::vector<Seed_curve> find_seeds(const Collapse_record& record, const NamedParameters& np, bool first_only,
                                   const Visitor& visitor, Progressive_mesh& pm)
{
  using CGAL::parameters::get_parameter;
  if constexpr(has_seed_sources<NamedParameters>)
    return replay<ConcurrencyTag>(record, get_parameter(np, internal_np::seed_sources), first_only, visitor, pm);
  else if constexpr(has_seed_detection<NamedParameters>)
    return get_parameter(np, internal_np::seed_detection) == Seed_detection::ON_APPEARANCE
               ? replay<ConcurrencyTag>(record, Non_face_triangle_seeds(), first_only, visitor, pm)
               : replay<ConcurrencyTag>(record, Refused_collapse_seeds(), first_only, visitor, pm);
  else
    return first_only ? replay<ConcurrencyTag>(record, Non_face_triangle_seeds(), first_only, visitor, pm)
                      : replay<ConcurrencyTag>(record, Default_seed_sources(), first_only, visitor, pm);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_FIND_SEEDS_H
