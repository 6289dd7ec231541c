// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_SECOND_WITNESS_H
#define FUZZ_SECOND_WITNESS_H

#include "certificate_comparison.h"
#include "failure.h"
#include "oracle.h"

#include <CGAL/Surface_mesh_constrictions/Shortest_path_verification.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace fuzz {

// Compares what CGAL's shortest paths say of a curve with what the oracle says: they confirm a geodesic, and no curve
// that bends. They are computed with rounding, and are allowed a tolerance of 1e-9. So they are asked only where neither
// decides: on a mesh without thin faces, of a curve that crosses no edge near to its ends, and not of a slight bend.
class Second_witness
{
public:
  Second_witness(const Mesh& mesh, Tally& tally) : m_mesh(mesh), m_tally(tally), m_has_thin_face(false)
  {
    for(Mesh::Face_index f : mesh.faces())
      m_has_thin_face = m_has_thin_face || is_thin(f);
  }

  // Does nothing after the first geodesics, and after the first curves that bend.
  void compare(const Constriction& curve, const Oracle::Answer& answer)
  {
    // there is a search of CGAL's for each vertex of a curve, and for some crossings
    const std::size_t most_curves = 8, most_locations = 48;
    if(m_has_thin_face || curve.locations().size() > most_locations || crosses_beside(curve))
      return;
    const bool is_geodesic = answer.finding == Finding::STRICT || answer.finding == Finding::CONSTRICTION ||
                             answer.finding == Finding::LEAKS || answer.finding == Finding::NOT_SIMPLE;
    const bool bends = answer.finding == Finding::SMALL_ANGLE && answer.least_angle < 3.13;
    // where the curve crosses edges was computed along with its length
    const bool has_places = curve.length() > 0 || std::all_of(curve.locations().begin(), curve.locations().end(),
                                                              [](const auto& l) { return l.is_pivot; });
    if(!bends && !(is_geodesic && has_places))
      return;
    if(++m_curves[bends ? 1 : 0] > most_curves)
      return;
    ++m_tally.witnessed;
    const SMC::Shortest_path_verification verification = SMC::verify_with_shortest_paths(m_mesh, curve);
    if(verification.is_confirmed() != (verification.number_of_refused_arcs == 0 && verification.number_of_arcs > 0) ||
       verification.number_of_refused_arcs > verification.number_of_arcs ||
       verification.refused_location >= curve.locations().size())
      fail("the second witness contradicts itself");
    if(is_geodesic && !verification.is_confirmed())
      fail("the second witness refuses a geodesic, for reason " +
           std::to_string(static_cast<int>(verification.refusal)) + " at location " +
           std::to_string(verification.refused_location));
    if(bends && verification.is_confirmed())
      fail("the second witness confirms a curve with an angle of " +
           std::to_string(static_cast<double>(answer.least_angle)));
  }

private:
  static constexpr double least_share = 0.01;

  // Whether a height is a small part of the longest edge.
  bool is_thin(Mesh::Face_index f) const
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    const Mesh::Point &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h)),
                      &r = m_mesh.point(m_mesh.target(m_mesh.next(h)));
    const double longest = (std::max)({(q - p).squared_length(), (r - q).squared_length(), (p - r).squared_length()});
    const double area = std::sqrt(CGAL::cross_product(q - p, r - p).squared_length());
    return !(area >= least_share * longest && longest > 0 && std::isfinite(longest));
  }

  static bool crosses_beside(const Constriction& curve)
  {
    return std::any_of(curve.locations().begin(), curve.locations().end(), [](const auto& l) {
      return !l.is_pivot && !(l.parameter >= least_share && l.parameter <= 1 - least_share);
    });
  }

  const Mesh& m_mesh;
  Tally& m_tally;
  bool m_has_thin_face;
  std::array<std::size_t, 2> m_curves = {0, 0}; // geodesics, and curves that bend
};

} // namespace fuzz

#endif // FUZZ_SECOND_WITNESS_H
