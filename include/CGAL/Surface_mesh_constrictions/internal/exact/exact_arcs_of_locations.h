// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_OF_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_OF_LOCATIONS_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_locations.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Flat_closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The arcs that the locations of a curve describe, or the condition that they violate.
template <class Surface>
struct Located_arcs
{
  Certificate_verdict verdict; // NOT_COMPUTED if the arcs are good; else why not
  std::size_t location;        // the one that does not fit the next one
  std::vector<Exact_arc<Surface>> arcs;
};

// Finds the closed geodesic in a strip that is crossed without pivots: its copy that runs through vertices. There is
// one if the strip unfolds to a translation, and its corners leave room for a straight line all along it. Then all
// copies have the same verdict.
template <class Surface>
Located_arcs<Surface> arcs_of_strip(Sign_prover<Surface>& prover, const std::vector<typename Surface::Halfedge>& strip)
{
  const Surface& s = prover.surface();
  Located_arcs<Surface> result = {Certificate_verdict::NOT_STRAIGHT, 0, {}};
  Flat_closed_strip<Surface> left(prover, strip, Curve_side::LEFT), right(prover, strip, Curve_side::RIGHT);
  if(left.is_degenerate() || right.is_degenerate())
    return result;

  std::vector<typename Surface::Halfedge> turn = strip;
  turn.push_back(strip.front());
  Prismatic_ties<Surface> ties(s, turn);
  const std::vector<Proved_sign> rotation = prover.signs(
      2,
      [&](const auto& arithmetic, auto& values) {
        const auto portals = unfold_turn(s, arithmetic, strip);
        const auto image = portals.back().left - portals.back().right;
        values[0] = image.x() - arithmetic.number(1);
        values[1] = image.y();
      },
      [&](std::size_t) { return ties([](const Prismatic_strip<Surface>&) { return Proved_sign::ZERO; }); });
  if(rotation[0] == Proved_sign::UNPROVED || rotation[1] == Proved_sign::UNPROVED)
    result.verdict = Certificate_verdict::TIE_NOT_PROVED;
  if(rotation[0] != Proved_sign::ZERO || rotation[1] != Proved_sign::ZERO)
    return result;

  const std::vector<std::size_t> above = left.nearest_corners(), below = right.nearest_corners();
  if(above.empty() || below.empty())
  {
    result.verdict = Certificate_verdict::TIE_NOT_PROVED;
    return result;
  }
  const std::size_t high = left.portal_of_corner(above.front()), low = right.portal_of_corner(below.front());
  const Proved_sign width = prover.sign(
      [&](const auto& arithmetic, auto& values) {
        const auto portals = unfold_turn(s, arithmetic, strip);
        values[0] = determinant(portals.back().right - portals.front().right, portals[high].left - portals[low].right);
      },
      [&] {
        return ties([&](const Prismatic_strip<Surface>& prism) {
          const Proved_sign rise =
              proved_sign(Integer(prism.height(s.target(strip[high])) - prism.height(s.source(strip[low]))));
          return prism.way_right(prism.corner(0, Curve_side::LEFT), prism.corner(strip.size(), Curve_side::LEFT)) ==
                         Proved_sign::POSITIVE
                     ? rise
                     : opposite_sign(rise);
        });
      });
  if(width != Proved_sign::POSITIVE)
  {
    result.verdict =
        width == Proved_sign::UNPROVED ? Certificate_verdict::TIE_NOT_PROVED : Certificate_verdict::NOT_STRAIGHT;
    return result;
  }
  result.verdict = Certificate_verdict::NOT_COMPUTED;
  result.arcs = right.curve_through(below);
  return result;
}

// Reads a closed curve off its locations. Linear, except for curves without pivots.
template <class Surface, class LocationRange>
Located_arcs<Surface> exact_arcs_of_locations(Sign_prover<Surface>& prover, const LocationRange& locations)
{
  Arcs_of_locations<Surface> read = arcs_of_locations(prover.surface(), locations);
  if(read.defect != Location_defect::NONE)
    return {Certificate_verdict::NOT_A_CLOSED_CURVE, read.location, {}};
  if(read.arcs.empty())
    return arcs_of_strip(prover, read.closed_strip);
  return {Certificate_verdict::NOT_COMPUTED, 0, std::move(read.arcs)};
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_EXACT_ARCS_OF_LOCATIONS_H
