// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_SOURCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_SOURCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/shrinks_in_small_disc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_loop.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>
#include <CGAL/Surface_mesh_constrictions/section_seeds.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The level for which a model of `ConstrictionSeedSource` is called.
struct Seed_level
{
  std::size_t vertices;                         ///< number of vertices of the current surface that are not isolated
  std::size_t number_of_collapses;              ///< the level of the coarsest surface
  Index merged;                                 ///< the vertex that the last collapse kept; `null_index` on T^0
  const std::vector<Seed_curve>* refused_seeds; ///< as recorded during the simplification, sorted by level
  bool is_parallel = false;                     ///< whether the caller allows more than one thread
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes the non-face triangles when they appear (Section 4.1 of the paper).
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost quadratic in the degree of the merged vertex for each level
struct Non_face_triangle_seeds
{
  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    return level.merged == null_index ? non_face_triangles(pm, out)
                                      : non_face_triangles_at_vertex(pm, level.merged, out);
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes the non-face triangles for which the simplification refused a collapse (Sections 1 and 4.4
/// of the paper).
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost logarithmic in the number of these triangles for each level, plus the output
struct Refused_collapse_seeds
{
  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    const std::vector<Seed_curve>& seeds = *level.refused_seeds;
    auto it = std::lower_bound(seeds.begin(), seeds.end(), pm.level(),
                               [](const Seed_curve& s, std::size_t k) { return s.level < k; });
    for(; it != seeds.end() && it->level == pm.level(); ++it)
      *out++ = *it;
    return out;
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes those seeds of another source whose vertices are all saddle points of their surface: the sum
/// of the angles at each vertex is greater than 2 pi (Section 5.2 of the paper).
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \tparam SeedSource a model of `ConstrictionSeedSource`
///
/// \cost that of the other source, plus the degrees of the vertices of its seeds
template <class SeedSource>
class Saddle_seeds
{
public:
  /// \param source the source whose seeds are filtered
  explicit Saddle_seeds(SeedSource source = SeedSource()) : m_source(std::move(source)) {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    std::vector<Seed_curve> seeds;
    m_source(pm, level, std::back_inserter(seeds));
    for(const Seed_curve& s : seeds)
      if(std::all_of(s.vertices.begin(), s.vertices.end(), [&pm](Index v) { return is_saddle(pm, v); }))
        *out++ = s;
    return out;
  }

private:
  static bool is_saddle(const Progressive_mesh& pm, Index v) { return internal::total_angle(pm, v) > 2 * CGAL_PI; }

  SeedSource m_source;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes those seeds of another source that are not seen to shorten to a point. Left out is a seed of
/// which one side is a small disc with angles of at most pi along the seed, beside which there are at least pi, and whose
/// positive curvature, the angle defects of the vertices inside, adds up to less than 2 pi: the seed does not leave the
/// disc as it gets shorter, and by the theorem of Gauss and Bonnet no closed geodesic of its surface lies in there. In
/// flat and developable regions of finely meshed bodies nearly all non-face triangles are such. On a coarse level, where
/// seeds are few, a seed that shortens to a point may yet lead to a constriction of a finer one, and none is left out.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \tparam SeedSource a model of `ConstrictionSeedSource`
///
/// \cost that of the other source, plus the degrees of the vertices of its seeds
template <class SeedSource>
class Gauss_bonnet_seeds
{
public:
  /// \param source the source whose seeds are filtered
  /// \param vertices the number of vertices of the coarsest surface on which they are
  explicit Gauss_bonnet_seeds(SeedSource source = SeedSource(), std::size_t vertices = 1000)
    : m_source(std::move(source)), m_vertices(vertices)
  {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    if(level.vertices < m_vertices)
      return m_source(pm, level, out);
    std::vector<Seed_curve> seeds;
    m_source(pm, level, std::back_inserter(seeds));
    for(Seed_curve& s : seeds)
      if(!internal::shrinks_in_small_disc(pm, s.vertices, most_faces))
        *out++ = std::move(s);
    return out;
  }

private:
  static constexpr std::size_t most_faces = 32; // of a disc that is looked at

  SeedSource m_source;
  std::size_t m_vertices;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes given closed paths of edges of T^0. Vertices are numbered in the order of `vertices(tm)`.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost linear in the length of the paths
class Given_seeds
{
public:
  /// \param loops closed paths, each the cyclic sequence of its vertices, the first not repeated
  explicit Given_seeds(std::vector<std::vector<Index>> loops) : m_loops(std::move(loops)) {}

  /// writes the seeds of the level
  /// \throws Invalid_input for a loop that is not a closed path of edges
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level&, OutputIterator out) const
  {
    if(pm.level() != 0)
      return out;
    for(std::size_t i = 0; i < m_loops.size(); ++i)
    {
      internal::check_loop(pm, m_loops[i], i);
      *out++ = Seed_curve{0, m_loops[i], Seed_origin::USER};
    }
    return out;
  }

private:
  std::vector<std::vector<Index>> m_loops;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// whether a surface is the first one in the course of the simplification that has no more than the given number of
/// vertices, or the coarsest one if none has. For seed sources that look at one level only.
///
/// \param pm the surface
/// \param level the argument of the same name that the seed source got
/// \param vertices the number of vertices that are not isolated
/// \cost constant
inline bool is_level_with(const Progressive_mesh& pm, const Seed_level& level, std::size_t vertices)
{
  return level.vertices == vertices || (level.vertices < vertices && pm.level() == 0) ||
         (level.vertices > vertices && pm.level() == level.number_of_collapses);
}

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes `cut_locus_seeds()` of the surface with a given number of vertices.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost for each root O(n log n), for the given number n of vertices
class Cut_locus_seeds
{
public:
  /// \param vertices the number of vertices of the surface on which loops are searched
  /// \param max_roots see `cut_locus_seeds()`
  explicit Cut_locus_seeds(std::size_t vertices = 1000, std::size_t max_roots = 167)
    : m_vertices(vertices), m_max_roots(max_roots)
  {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    if(!is_level_with(pm, level, m_vertices))
      return out;
    return level.is_parallel ? cut_locus_seeds<Parallel_if_available_tag>(pm, out, m_max_roots)
                             : cut_locus_seeds<Sequential_tag>(pm, out, m_max_roots);
  }

private:
  std::size_t m_vertices, m_max_roots;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes `plane_section_seeds()` and `distance_section_seeds()` of the surface with a given number of
/// vertices.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost linear in the given number of vertices for each of about 5,000 sections
class Section_seeds
{
public:
  /// \param vertices the number of vertices of the surface that is cut
  explicit Section_seeds(std::size_t vertices = 1000) : m_vertices(vertices) {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    if(!is_level_with(pm, level, m_vertices))
      return out;
    return level.is_parallel ? write_sections<Parallel_if_available_tag>(pm, out)
                             : write_sections<Sequential_tag>(pm, out);
  }

private:
  template <class ConcurrencyTag, class OutputIterator>
  OutputIterator write_sections(const Progressive_mesh& pm, OutputIterator out) const
  {
    return distance_section_seeds<ConcurrencyTag>(pm, plane_section_seeds<ConcurrencyTag>(pm, out));
  }

  std::size_t m_vertices;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes the boundaries of the holes, see `boundary_seeds()`, of T^0 and of one coarse surface. There
/// are none on closed meshes.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \cost linear in the number of boundary edges of the two surfaces
class Boundary_seeds
{
public:
  /// \param vertices the number of vertices of the coarse surface
  explicit Boundary_seeds(std::size_t vertices = 1000) : m_vertices(vertices) {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    return pm.level() == 0 || is_level_with(pm, level, m_vertices) ? boundary_seeds(pm, out) : out;
  }

private:
  std::size_t m_vertices;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Seed source that writes the seeds of several other ones, one source after the other.
///
/// \cgalModels{ConstrictionSeedSource}
///
/// \tparam SeedSource models of `ConstrictionSeedSource`
///
/// \cost that of all sources together
template <class... SeedSource>
class Seed_sources
{
public:
  /// stores copies of the sources
  explicit Seed_sources(SeedSource... sources) : m_sources(std::move(sources)...) {}

  /// writes the seeds of the level
  template <class OutputIterator>
  OutputIterator operator()(const Progressive_mesh& pm, const Seed_level& level, OutputIterator out) const
  {
    std::apply([&](const SeedSource&... source) { ((out = source(pm, level, out)), ...); }, m_sources);
    return out;
  }

private:
  std::tuple<SeedSource...> m_sources;
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The default seed sources: those that together find most constrictions, as measured in the section "Which Sources
/// Find How Much" of the user manual.
///
/// \cgalModels{ConstrictionSeedSource}
struct Default_seed_sources
  : public Seed_sources<Gauss_bonnet_seeds<Non_face_triangle_seeds>, Cut_locus_seeds, Section_seeds, Boundary_seeds>
{
  /// non-face triangles that are not seen to shorten to a point, cut locus, sections and boundaries, each with its
  /// defaults
  Default_seed_sources()
    : Seed_sources(Gauss_bonnet_seeds<Non_face_triangle_seeds>(), Cut_locus_seeds(), Section_seeds(), Boundary_seeds())
  {}
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SEED_SOURCES_H
