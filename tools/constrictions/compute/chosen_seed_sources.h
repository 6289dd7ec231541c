// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CHOSEN_SEED_SOURCES_H
#define CONSTRICTIONS_CHOSEN_SEED_SOURCES_H

#include "compute/levels.h"

#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>

namespace constrictions {

/// The seed sources that the user has chosen, known only when the program runs. If `levels` is not null it gets a copy
/// of the surface with all its levels: a source is the one that is shown them all.
class Chosen_seed_sources
{
public:
  Chosen_seed_sources(bool triangles_only, Levels* levels) : m_triangles_only(triangles_only), m_levels(levels) {}

  template <class OutputIterator>
  OutputIterator operator()(const CGAL::Surface_mesh_constrictions::Progressive_mesh& pm,
                            const CGAL::Surface_mesh_constrictions::Seed_level& level, OutputIterator out) const
  {
    if(m_levels != nullptr && pm.level() == level.number_of_collapses)
      *m_levels = pm;
    return m_triangles_only ? m_triangles(pm, level, out) : m_all(pm, level, out);
  }

private:
  bool m_triangles_only;
  Levels* m_levels;
  CGAL::Surface_mesh_constrictions::Non_face_triangle_seeds m_triangles;
  CGAL::Surface_mesh_constrictions::Default_seed_sources m_all;
};

/// named parameters for the seed sources and the schedule that goes with them, in front of others.
template <class NamedParameters>
auto with_seed_sources(bool triangles_only, Levels* levels, const NamedParameters& np)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  return SMC::parameters::seed_sources(
      Chosen_seed_sources(triangles_only, levels),
      SMC::parameters::tightening_schedule(
          triangles_only ? SMC::Tightening_schedule::AT_THE_END : SMC::Tightening_schedule::UNSTRAIGHTENED, np));
}

} // namespace constrictions

#endif // CONSTRICTIONS_CHOSEN_SEED_SOURCES_H
