// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SLIDES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SLIDES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Surface_sides.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/rivals.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_angles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// To which other curve of a surface each curve slides. Barriers are searched at the first call for a curve. Curves are
// numbered in the order in which they are entered or found.
class Slides
{
public:
  // Linear in the size of the mesh.
  Slides(const Progressive_mesh& pm, const Surface_sides& sides)
    : m_pm(pm), m_sides(sides), m_lengths(pm), m_angles(pm), m_search(pm, m_lengths, m_angles)
  {}

  // The number of a simple closed geodesic.
  Index enter(const std::vector<Arc>& arcs) { return m_search.tightener().enter(arcs); }

  double length(Index c) { return m_search.tightener().length(c); }

  // The barrier around a curve. Cost: that of `Barrier_search::search()`, the first time.
  const Barrier& barrier(Index c)
  {
    const auto known = m_barriers.find(c);
    if(known != m_barriers.end())
      return known->second;
    const std::vector<Arc> arcs = m_search.tightener().arcs(c);
    const std::vector<Trace_point> points = trace(m_pm, arcs);
    return m_barriers
        .emplace(c, m_search.search(arcs, points, m_sides.part(points).is_separating(),
                                    (std::numeric_limits<double>::infinity)()))
        .first->second;
  }

  // The prominence of a curve. Cost: that of `barrier()`.
  double prominence(Index c) { return prominence_of_barrier(barrier(c).length, length(c)); }

  // Whether two curves are nearly as long and as prominent as each other and at one place, see `lead_twins()`. Cost:
  // that of `barrier()` of both.
  bool are_twins(Index c, Index d)
  {
    if(!are_like_twins(length(c), prominence(c), length(d), prominence(d)))
      return false;
    const std::vector<Trace_point> points = trace(m_pm, m_search.tightener().arcs(c)),
                                   others = trace(m_pm, m_search.tightener().arcs(d));
    return m_sides.part(points).homology_class == m_sides.part(others).homology_class &&
           m_sides.area_between(points, others) < area_of_one_place * length(d) * length(d);
  }

private:
  const Progressive_mesh& m_pm;
  const Surface_sides& m_sides;
  Edge_lengths m_lengths;
  Corner_angles m_angles;
  Barrier_search m_search;
  std::unordered_map<Index, Barrier> m_barriers;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_SLIDES_H
