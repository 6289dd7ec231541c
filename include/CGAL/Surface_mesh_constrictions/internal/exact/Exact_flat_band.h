// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_FLAT_BAND_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_FLAT_BAND_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Flat_closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Side_angle.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The signs of angle - pi at all pivots of a closed curve, on one side. Element i is that of the pivot where arc i
// starts.
template <class Surface>
std::vector<Proved_sign> signs_beyond_pi(Sign_prover<Surface>& prover, const std::vector<Exact_arc<Surface>>& arcs,
                                         Curve_side side)
{
  std::vector<Proved_sign> result;
  for(std::size_t i = 0; i < arcs.size(); ++i)
    result.push_back(
        Side_angle<Surface>(prover, arcs[(i + arcs.size() - 1) % arcs.size()], arcs[i], side).sign_beyond_pi());
  return result;
}

// What happens at the end of a flat band.
enum class Band_outcome
{
  HOLDS,
  LEAKS,
  UNPROVED
};

template <class Surface>
struct Exact_band_end
{
  Band_outcome outcome;
  std::vector<Exact_arc<Surface>> curve; // the last copy
  double width;                          // of the band, from the given curve on
};

// Moves a closed geodesic, all of whose angles on a side are pi, through the flat band on that side to its end: the
// first copy with an angle on that side other than pi. The end leaks if such an angle is less than pi. A band that
// closes around a flat torus holds. O(copies that meet vertices) steps, each linear in the faces of the band, times the
// cost of the arithmetic.
template <class Surface>
Exact_band_end<Surface> follow_flat_band(Sign_prover<Surface>& prover, std::vector<Exact_arc<Surface>> curve,
                                         Curve_side side)
{
  typedef typename Surface::Halfedge Halfedge;
  const Surface& s = prover.surface();
  double width = 0;
  std::set<typename Surface::Vertex> visited;
  for(;;)
  {
    // the fan at a pivot whose angle is pi has at least one edge; if both arcs are in one face it goes around the whole
    // pivot
    std::vector<Halfedge> strip;
    Halfedge at_pivot = Halfedge();
    bool has_fan = false;
    for(std::size_t i = 0; i < curve.size(); ++i)
    {
      strip.insert(strip.end(), curve[i].crossings.begin(), curve[i].crossings.end());
      const std::size_t before = strip.size();
      append_fan(s, curve[i], curve[(i + 1) % curve.size()], side, true, strip);
      if(strip.size() > before)
      {
        has_fan = true;
        at_pivot = strip[before];
      }
    }
    Flat_closed_strip<Surface> band(prover, strip, side);
    if(!has_fan || band.is_degenerate())
      return {Band_outcome::UNPROVED, curve, width};
    const std::vector<std::size_t> corners = band.nearest_corners();
    if(corners.empty())
      return {Band_outcome::UNPROVED, curve, width};
    std::vector<Exact_arc<Surface>> moved = band.curve_through(corners);
    if(!visited.insert(moved.front().from).second)
      return {Band_outcome::HOLDS, curve, width};
    width += band.distance(corners.front(), at_pivot);
    curve = std::move(moved);
    const std::vector<Proved_sign> signs = signs_beyond_pi(prover, curve, side);
    if(contains(signs, Proved_sign::NEGATIVE))
      return {Band_outcome::LEAKS, curve, width};
    if(contains(signs, Proved_sign::UNPROVED))
      return {Band_outcome::UNPROVED, curve, width};
    if(contains(signs, Proved_sign::POSITIVE))
      return {Band_outcome::HOLDS, curve, width};
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_FLAT_BAND_H
