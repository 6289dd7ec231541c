// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CHOSEN_SEED_SOURCES_H
#define CONSTRICTIONS_CHOSEN_SEED_SOURCES_H

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

namespace constrictions {

/// The seed sources that the user has chosen, known only when the program runs.
class Chosen_seed_sources
{
public:
  explicit Chosen_seed_sources(bool triangles_only) : m_triangles_only(triangles_only) {}

  template <class OutputIterator>
  OutputIterator operator()(const CGAL::Surface_mesh_constrictions::Progressive_mesh& pm,
                            const CGAL::Surface_mesh_constrictions::Seed_level& level, OutputIterator out) const
  {
    return m_triangles_only ? m_triangles(pm, level, out) : m_all(pm, level, out);
  }

private:
  bool m_triangles_only;
  CGAL::Surface_mesh_constrictions::Non_face_triangle_seeds m_triangles;
  CGAL::Surface_mesh_constrictions::Default_seed_sources m_all;
};

/// named parameters for the seed sources and the schedule that goes with them, in front of others.
template <class NamedParameters>
auto with_seed_sources(bool triangles_only, const NamedParameters& np)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  return SMC::parameters::seed_sources(
      Chosen_seed_sources(triangles_only),
      SMC::parameters::tightening_schedule(
          triangles_only ? SMC::Tightening_schedule::AT_THE_END : SMC::Tightening_schedule::UNSTRAIGHTENED, np));
}

} // namespace constrictions

#endif // CONSTRICTIONS_CHOSEN_SEED_SOURCES_H
