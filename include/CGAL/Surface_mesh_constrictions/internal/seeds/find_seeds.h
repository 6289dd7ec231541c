// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_FIND_SEEDS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SEEDS_FIND_SEEDS_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <unordered_set>
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

// Removes the seeds of one level that have been found on a finer one. A triangle of three edges that is no face is found
// again whenever one of its corners is moved by a collapse. It is the same closed curve on all these levels. Yet on a
// coarse level, where curves are tightened and seeds are few, it may lead to another constriction than from a finer one,
// and none is removed.
class Repeated_triangles
{
public:
  // Removes them from those from `first` on, of a level with so many vertices. Linear in these.
  void remove(std::vector<Seed_curve>& seeds, std::size_t first, std::size_t vertices)
  {
    if(vertices < least_vertices)
      return;
    const auto begin = seeds.begin() + static_cast<std::ptrdiff_t>(first);
    seeds.erase(std::remove_if(begin, seeds.end(), [this](const Seed_curve& s) { return is_known(s); }), seeds.end());
  }

private:
  static constexpr std::size_t least_vertices = 1000;
  typedef std::array<Index, 3> Corners;

  bool is_known(const Seed_curve& s)
  {
    if(s.origin != Seed_origin::NON_FACE_TRIANGLE || s.vertices.size() != 3)
      return false;
    Corners corners = {{s.vertices[0], s.vertices[1], s.vertices[2]}};
    std::sort(corners.begin(), corners.end());
    return !m_known.insert(corners).second;
  }

  std::unordered_set<Corners, boost::hash<Corners>> m_known;
};

// Builds the progressive mesh from a record and calls the seed source at every level, or as far as the first seed.
template <class ConcurrencyTag, class SeedSource, class Visitor>
std::vector<Seed_curve> replay(const Collapse_record& record, const SeedSource& source, bool first_only,
                               const Visitor& visitor, Progressive_mesh& pm)
{
  Seed_level level = {pm.number_of_vertices(), record.collapses.size(), null_index, &record.refused_seeds,
                      std::is_convertible<ConcurrencyTag, Parallel_tag>::value};
  std::vector<Seed_curve> seeds;
  Repeated_triangles repeated;
  source(pm, level, std::back_inserter(seeds));
  repeated.remove(seeds, 0, level.vertices);
  if(first_only && !seeds.empty())
    return {seeds.front()};
  pm.append_collapses(record.collapses, [&](const Edge_collapse& c) {
    --level.vertices;
    level.merged = c.kept;
    const std::size_t before = seeds.size();
    source(pm, level, std::back_inserter(seeds));
    repeated.remove(seeds, before, level.vertices);
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
