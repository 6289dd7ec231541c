// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIER_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIER_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_flat_band.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Exact_simplicity.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Prismatic_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Side_angle.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/Sign_prover.h>
#include <CGAL/Surface_mesh_constrictions/internal/exact/floating_point_defect.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The signs that are known of an arc, and of the pivot where it starts.
struct Known_of_arc
{
  bool is_straight = false;
  Rounded_directions directions; // if the arc is straight
  bool has_angles = false;
  // for the left and the right side: the sign of the side angle - pi; and, if both arcs are in one face, whether the
  // side angle goes around the whole pivot
  std::array<Proved_sign, 2> beyond_pi = {{Proved_sign::UNPROVED, Proved_sign::UNPROVED}};
  std::array<bool, 2> is_whole_turn = {{false, false}};
};

// The result of examining a curve: the certificate, and the data that a correction of the curve needs.
template <class Surface>
struct Finding
{
  Certificate certificate;
  std::size_t arc = 0;        // the one that is not straight, or that starts at the pivot with an angle below pi
  bool is_whole_turn = false; // whether that angle goes around the whole pivot, if both arcs are in one face
  std::array<std::vector<Exact_arc<Surface>>, 2> band_ends; // the last copies of flat bands on the left and right

  explicit Finding(Certificate_verdict verdict, std::size_t arc = 0) : arc(arc) { certificate.verdict = verdict; }
};

// Decides the conditions of the contract in `certify_constriction.h` exactly, in their order, but for the first one,
// which `arcs_of_locations()` decides. A certifier is used only by the thread that made it: where the floating-point
// arithmetic of this thread has a defect, the verdict of each examination is this defect.
template <class Surface>
class Certifier
{
public:
  typedef Exact_arc<Surface> Arc;

  explicit Certifier(const Surface& surface)
    : m_prover(surface), m_floating_point_defect(internal::floating_point_defect())
  {}

  const Surface& surface() const { return m_prover.surface(); }
  Sign_prover<Surface>& prover() { return m_prover; }

  // NOT_COMPUTED if there is none.
  Certificate_verdict floating_point_defect() const { return m_floating_point_defect; }

  // Takes arcs that fit together. See `certify_constriction()` for the cost.
  Finding<Surface> examine(const std::vector<Arc>& arcs)
  {
    std::vector<Known_of_arc> known(arcs.size());
    return examine(arcs, known);
  }

  // As above, but decides only signs that are not yet in `known`, and adds them to it. `known` has an element for each
  // arc.
  Finding<Surface> examine(const std::vector<Arc>& arcs, std::vector<Known_of_arc>& known)
  {
    if(m_floating_point_defect != Certificate_verdict::NOT_COMPUTED)
      return Finding<Surface>(m_floating_point_defect);
    const Sign_statistics before = m_prover.statistics();
    Finding<Surface> result = find(arcs, known);
    result.certificate.signs = m_prover.statistics() - before;
    return result;
  }

  // As above, for a path that is held at its two ends. The verdict is GEODESIC_ARC if the arcs are straight, with side
  // angles of at least pi at each pivot between the ends; else it is the first condition that is violated.
  Finding<Surface> examine_path(const std::vector<Arc>& arcs, std::vector<Known_of_arc>& known)
  {
    if(m_floating_point_defect != Certificate_verdict::NOT_COMPUTED)
      return Finding<Surface>(m_floating_point_defect);
    const Sign_statistics before = m_prover.statistics();
    std::array<bool, 2> is_strict = {{false, false}};
    std::optional<Finding<Surface>> defect = find_bent_arc(arcs, known);
    if(!defect)
      defect = find_small_angle(arcs, 1, known, is_strict);
    Finding<Surface> result = defect ? *std::move(defect) : Finding<Surface>(Certificate_verdict::GEODESIC_ARC);
    result.certificate.signs = m_prover.statistics() - before;
    return result;
  }

  // Whether a curve of straight arcs is proved not to cross or touch itself.
  bool is_simple(const std::vector<Arc>& arcs)
  {
    return Exact_simplicity<Surface>(m_prover, arcs).find().verdict == Certificate_verdict::NOT_COMPUTED;
  }

  // Decides whether arc i is straight: whether the ends of each portal lie strictly on their sides of the line from one
  // end of the arc to the other. The verdict is NOT_COMPUTED if the arc is straight, else NOT_STRAIGHT or
  // TIE_NOT_PROVED.
  Finding<Surface> examine_arc(const std::vector<Arc>& arcs, std::size_t i)
  {
    Rounded_directions directions;
    return examine_arc(arcs, i, directions);
  }

  // As above; sets the arc's directions at its ends.
  Finding<Surface> examine_arc(const std::vector<Arc>& arcs, std::size_t i, Rounded_directions& directions)
  {
    const Arc& arc = arcs[i];
    Finding<Surface> result(Certificate_verdict::NOT_COMPUTED, i);
    if(arc.is_edge())
    {
      const Planar<Interval_nt<false>> along(1, 0);
      directions = {along, along};
      return result;
    }
    const std::vector<Strip_corner> corners = strip_corners(surface(), arc.crossings);
    Prismatic_ties<Surface> ties(surface(), arc.crossings);
    const std::vector<Proved_sign> signs = m_prover.signs(
        corners.size(),
        [&](const auto& arithmetic, auto& values) {
          const auto strip = unfold(surface(), arithmetic, arc);
          if constexpr(std::is_same<std::decay_t<decltype(arithmetic)>, Interval_arithmetic<Surface>>::value)
            directions = {strip.apex, end_direction(arithmetic, strip)};
          for(std::size_t c = 0; c < corners.size(); ++c)
            if(values.wants(c))
            {
              const auto& portal = strip.portals[corners[c].portal];
              values[c] = corners[c].side == Curve_side::LEFT ? determinant(strip.apex, portal.left)
                                                              : determinant(portal.right, strip.apex);
            }
        },
        [&](std::size_t c) {
          return ties([&](const Prismatic_strip<Surface>& strip) {
            const Proved_sign turn =
                strip.turn(strip.start(), strip.end(), strip.corner(corners[c].portal, corners[c].side));
            return corners[c].side == Curve_side::LEFT ? turn : opposite_sign(turn);
          });
        });
    for(std::size_t c = 0; c < corners.size(); ++c)
      if(signs[c] != Proved_sign::POSITIVE)
      {
        result.certificate.verdict =
            signs[c] == Proved_sign::UNPROVED ? Certificate_verdict::TIE_NOT_PROVED : Certificate_verdict::NOT_STRAIGHT;
        result.certificate.location = (arc.location + 1 + corners[c].portal) % number_of_locations(arcs);
        result.certificate.side = corners[c].side;
        return result;
      }
    return result;
  }

  // Decides the side angles at the pivot where arc i starts, if they are not known.
  void examine_pivot(const std::vector<Arc>& arcs, std::size_t i, std::vector<Known_of_arc>& known)
  {
    Known_of_arc& k = known[i];
    if(k.has_angles)
      return;
    k.has_angles = true;
    for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
    {
      const std::size_t s = side == Curve_side::LEFT ? 0 : 1;
      const std::size_t before = (i + arcs.size() - 1) % arcs.size();
      const auto directions = [&known](std::size_t a) { return known[a].is_straight ? &known[a].directions : nullptr; };
      Side_angle<Surface> angle(m_prover, arcs[before], arcs[i], side, directions(before), directions(i));
      k.beyond_pi[s] = angle.sign_beyond_pi();
      k.is_whole_turn[s] = angle.is_whole_turn();
    }
  }

private:
  // The number of locations of a closed curve, whose first pivot may come after crossings of the last arc.
  static std::size_t number_of_locations(const std::vector<Arc>& arcs)
  {
    std::size_t result = arcs.size();
    for(const Arc& arc : arcs)
      result += arc.crossings.size();
    return result;
  }

  // What is wrong with the first arc that is not straight.
  std::optional<Finding<Surface>> find_bent_arc(const std::vector<Arc>& arcs, std::vector<Known_of_arc>& known)
  {
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      if(known[i].is_straight)
        continue;
      const Finding<Surface> f = examine_arc(arcs, i, known[i].directions);
      if(f.certificate.verdict != Certificate_verdict::NOT_COMPUTED)
        return f;
      known[i].is_straight = true;
    }
    return std::nullopt;
  }

  // The first side angle that is not proved to be at least pi, at the pivots where the arcs from number `first` on
  // start. `is_strict` tells on which sides an angle is proved to be greater than pi.
  std::optional<Finding<Surface>> find_small_angle(const std::vector<Arc>& arcs, std::size_t first,
                                                   std::vector<Known_of_arc>& known, std::array<bool, 2>& is_strict)
  {
    for(std::size_t i = first; i < arcs.size(); ++i)
    {
      examine_pivot(arcs, i, known);
      for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
      {
        const std::size_t s = side == Curve_side::LEFT ? 0 : 1;
        const Proved_sign sign = known[i].beyond_pi[s];
        if(sign == Proved_sign::POSITIVE)
          is_strict[s] = true;
        if(sign == Proved_sign::NEGATIVE || sign == Proved_sign::UNPROVED)
        {
          Finding<Surface> result(sign == Proved_sign::NEGATIVE ? Certificate_verdict::ANGLE_BELOW_PI
                                                                : Certificate_verdict::TIE_NOT_PROVED,
                                  i);
          result.certificate.location = arcs[i].location;
          result.certificate.side = side;
          result.is_whole_turn = known[i].is_whole_turn[s];
          return result;
        }
      }
    }
    return std::nullopt;
  }

  Finding<Surface> find(const std::vector<Arc>& arcs, std::vector<Known_of_arc>& known)
  {
    if(std::optional<Finding<Surface>> bent = find_bent_arc(arcs, known))
      return *std::move(bent);
    std::array<bool, 2> is_strict = {{false, false}};
    if(std::optional<Finding<Surface>> sharp = find_small_angle(arcs, 0, known, is_strict))
      return *std::move(sharp);

    const auto meeting = Exact_simplicity<Surface>(m_prover, arcs).find();
    if(meeting.verdict != Certificate_verdict::NOT_COMPUTED)
    {
      Finding<Surface> result(meeting.verdict);
      result.certificate.location = meeting.location;
      result.certificate.other_location = meeting.other_location;
      return result;
    }

    if(is_strict[0] && is_strict[1])
      return Finding<Surface>(Certificate_verdict::STRICT_CONSTRICTION);
    Finding<Surface> result(Certificate_verdict::CONSTRICTION);
    for(Curve_side side : {Curve_side::LEFT, Curve_side::RIGHT})
    {
      if(is_strict[side == Curve_side::LEFT ? 0 : 1])
        continue;
      Exact_band_end<Surface> end = follow_flat_band(m_prover, arcs, side);
      result.certificate.flat_band_width += end.width;
      result.band_ends[side == Curve_side::LEFT ? 0 : 1] = std::move(end.curve);
      if(end.outcome == Band_outcome::HOLDS)
        continue;
      result.certificate.verdict =
          end.outcome == Band_outcome::LEAKS ? Certificate_verdict::LEAKY_BAND : Certificate_verdict::TIE_NOT_PROVED;
      result.certificate.location = arcs.front().location;
      result.certificate.side = side;
      return result;
    }
    return result;
  }

  Sign_prover<Surface> m_prover;
  Certificate_verdict m_floating_point_defect;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_EXACT_CERTIFIER_H
