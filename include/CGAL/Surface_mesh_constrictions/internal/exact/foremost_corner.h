// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FOREMOST_CORNER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FOREMOST_CORNER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Flat_closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Planar.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A choice that need not be proved is tried with so many precisions of intervals. If it stays open, the numbers are
// taken to be equal.
constexpr int precisions_of_a_choice = 4;

// 1 if the unfolding of a cyclic strip rotates to the left along one turn, so that the centre of the rotation is on the
// left, -1 if it rotates to the right, 0 if it is a translation as far as can be told. The rotation is by less than a
// right angle.
template <class Surface>
int rotation_sign(Sign_prover<Surface>& prover, const std::vector<typename Surface::Halfedge>& strip)
{
  int sign = 0, tries = 0;
  prover.decide_by_intervals([&](const auto& arithmetic) {
    const auto portals = unfold_turn(prover.surface(), arithmetic, strip);
    sign = arithmetic.certain_sign((portals.back().left - portals.back().right).y());
    return sign != 0 || ++tries == precisions_of_a_choice;
  });
  return sign;
}

// The portal of a cyclic strip whose end on the given side reaches furthest into the strip. The centre of the rotation
// is on this side. One turn moves a point the further, the further the point is from the centre; so this is the end
// that one turn moves furthest. If there is no rotation, it is the end that lies furthest towards the other side,
// across the direction of the turn. Linear at each precision of intervals that is needed.
template <class Surface>
std::size_t foremost_portal(Sign_prover<Surface>& prover, const std::vector<typename Surface::Halfedge>& strip,
                            Curve_side side, bool rotates)
{
  const std::size_t n = strip.size();
  std::vector<typename Surface::Halfedge> turns = strip;
  if(rotates)
    turns.insert(turns.end(), strip.begin(), strip.end());
  std::size_t best = 0;
  int tries = 0;
  std::vector<bool> is_left_behind(n, false);
  prover.decide_by_intervals([&](const auto& arithmetic) {
    typedef typename std::decay_t<decltype(arithmetic)>::NT NT;
    const auto portals = unfold_turn(prover.surface(), arithmetic, turns);
    const auto turn = portals.back().right - portals.front().right;
    std::vector<NT> reach;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Planar<NT>& p = portals[i].end(side);
      if(rotates)
      {
        const Planar<NT> step = portals[i + n].end(side) - p;
        reach.push_back(relative(step, step).x());
      }
      else
        reach.push_back(side == Curve_side::LEFT ? determinant(p, turn) : determinant(turn, p));
    }
    const auto is_open = [&](std::size_t i) {
      return !is_left_behind[i] &&
             corner_vertex(prover.surface(), strip[i], side) != corner_vertex(prover.surface(), strip[best], side);
    };
    for(std::size_t i = 0; i < n; ++i)
      if(is_open(i) && arithmetic.certain_sign(reach[i] - reach[best]) > 0)
        best = i;
    bool is_decided = true;
    for(std::size_t i = 0; i < n; ++i)
      if(is_open(i))
      {
        is_left_behind[i] = arithmetic.certain_sign(reach[best] - reach[i]) > 0;
        is_decided = is_decided && is_left_behind[i];
      }
    return is_decided || ++tries == precisions_of_a_choice;
  });
  return best;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_FOREMOST_CORNER_H
