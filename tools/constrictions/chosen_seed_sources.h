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
  explicit Chosen_seed_sources(bool thorough) : m_is_thorough(thorough) {}

  template <class OutputIterator>
  OutputIterator operator()(const CGAL::Surface_mesh_constrictions::Progressive_mesh& pm,
                            const CGAL::Surface_mesh_constrictions::Seed_level& level, OutputIterator out) const
  {
    return m_is_thorough ? m_thorough(pm, level, out) : m_triangles(pm, level, out);
  }

private:
  bool m_is_thorough;
  CGAL::Surface_mesh_constrictions::Thorough_seed_sources m_thorough;
  CGAL::Surface_mesh_constrictions::Non_face_triangle_seeds m_triangles;
};

/// named parameters for the seed sources and the schedule that goes with them, in front of others.
template <class NamedParameters>
auto with_seed_sources(bool thorough, const NamedParameters& np)
{
  namespace SMC = CGAL::Surface_mesh_constrictions;
  return SMC::parameters::seed_sources(
      Chosen_seed_sources(thorough),
      SMC::parameters::tightening_schedule(
          thorough ? SMC::Tightening_schedule::UNSTRAIGHTENED : SMC::Tightening_schedule::AT_THE_END, np));
}

} // namespace constrictions

#endif // CONSTRICTIONS_CHOSEN_SEED_SOURCES_H
