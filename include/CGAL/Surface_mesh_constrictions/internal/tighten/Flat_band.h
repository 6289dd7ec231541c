// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_FLAT_BAND_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_FLAT_BAND_H

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_network.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/arcs_of_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/other_side.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Closed_strip.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/String_puller.h>
#include <CGAL/Surface_mesh_constrictions/internal/tighten/Tightener.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A side angle this close to pi, in radians, belongs to a flat band: the parallel copies of a closed geodesic. Their
// lengths are equal up to this share.
constexpr double flat_tolerance = 1e-9;

// The least and the greatest angle that a closed curve makes on one side.
inline std::pair<double, double> side_angle_range(const Progressive_mesh& pm, const std::vector<Arc>& curve,
                                                  Curve_side side)
{
  std::pair<double, double> range((std::numeric_limits<double>::infinity)(), 0);
  for(std::size_t i = 0; i < curve.size(); ++i)
  {
    const Side_angles a = side_angles(pm, curve[i], curve[(i + 1) % curve.size()]);
    const double angle = side == Curve_side::LEFT ? a.left : a.right;
    range.first = (std::min)(range.first, angle);
    range.second = (std::max)(range.second, angle);
  }
  return range;
}

inline bool is_flat_side(const Progressive_mesh& pm, const std::vector<Arc>& curve, Curve_side side)
{
  return side_angle_range(pm, curve, side).second <= CGAL_PI + flat_tolerance;
}

// The smallest vertex that a sequence of arcs passes through.
template <class Arcs>
Index smallest_pivot(const Arcs& arcs)
{
  Index v = null_index;
  for(const auto& a : arcs)
    v = (std::min)(v, a.from);
  return v;
}

// One end of a flat band: the parallel copy that cannot be moved further.
struct Band_end
{
  std::vector<Arc> curve;
  double width; // from the curve that the band was followed from
  bool leaks;   // the curve gets shorter beyond the end
};

// Moves a closed geodesic through the flat band on one of its sides to the end of the band. A band that closes in
// itself, around a flat torus, ends at the copy with the smallest pivot.
// Linear in the number of faces of the band times the number of vertices of total angle 2 pi in it.
inline Band_end follow_flat_band(const Progressive_mesh& pm, std::vector<Arc> curve, Curve_side side,
                                 String_puller& puller)
{
  double width = 0;
  const double length = total_length(curve);
  std::set<Index> visited;
  std::vector<Arc> smallest = curve;
  while(is_flat_side(pm, curve, side))
  {
    Strip faces;
    for(std::size_t i = 0; i < curve.size(); ++i)
    {
      faces.insert(faces.end(), curve[i].crossings.begin(), curve[i].crossings.end());
      append_fan(pm, curve[i], curve[(i + 1) % curve.size()], side, faces);
    }
    const Closed_strip strip(pm, std::move(faces));
    if(strip.is_degenerate())
      break;
    const Closed_strip::Corner end = strip.foremost_corner(side);
    std::vector<Arc> moved = strip.shortest_loop(end, puller);
    if(moved.empty() || std::abs(total_length(moved) - length) > flat_tolerance * length)
      break;
    if(!visited.insert(end.vertex).second)
    {
      curve = smallest;
      break;
    }
    width += std::abs(strip.height(end, strip.foremost_corner(other_side(side))));
    curve = std::move(moved);
    if(smallest_pivot(curve) < smallest_pivot(smallest))
      smallest = curve;
    if(side_angle_range(pm, curve, side).first < CGAL_PI - flat_tolerance)
      return Band_end{std::move(curve), width, true};
  }
  return Band_end{std::move(curve), width, false};
}

// The result of settle_flat_band().
struct Band_report
{
  double width = 0;      // of the band that holds the curve; 0 if there is none
  std::size_t leaks = 0; // bands that the curve slipped out of
};

// Replaces a tight curve in a flat band by the band's canonical copy: of the two ends that hold, the one with the
// smaller vertex. If an end leaks, the curve slips over it and is tightened again; it may degenerate.
inline Band_report settle_flat_band(Curve_network& network, Index c, Tightener& tightener)
{
  const Progressive_mesh& pm = network.surface();
  Band_report report;
  while(!network.is_empty(c))
  {
    const std::vector<Arc> curve = arcs_of_curve(network, c);
    if(!is_flat_side(pm, curve, Curve_side::LEFT) && !is_flat_side(pm, curve, Curve_side::RIGHT))
      return report;

    Band_end left = follow_flat_band(pm, curve, Curve_side::LEFT, tightener.puller());
    Band_end right = follow_flat_band(pm, curve, Curve_side::RIGHT, tightener.puller());
    if(!left.leaks && !right.leaks)
    {
      report.width = left.width + right.width;
      network.set_arcs(c, smallest_pivot(left.curve) <= smallest_pivot(right.curve) ? left.curve : right.curve);
      return report;
    }
    const double length = network.length(c);
    network.set_arcs(c, left.leaks ? left.curve : right.curve);
    tightener.enqueue_all(c);
    tightener.run();
    if(!network.is_empty(c) && network.length(c) >= length * (1 - 1e-14))
      return report; // no more than rounding made the end seem to leak
    ++report.leaks;
  }
  return report;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_TIGHTEN_FLAT_BAND_H
