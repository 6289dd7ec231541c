// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Curves whose lengths differ by less than this share, and whose distance is less than this share of their length, are
// the same curve: it passes a vertex so closely that rounding decided on which side.
constexpr double coincidence_tolerance = 1e-8;

// Whether each point of the trace of one closed curve lies on the other one but for rounding; `length` is that of a
// curve. Quadratic; ends at the first point that does not.
inline bool coincide(const Progressive_mesh& pm, const std::vector<Trace_point>& a, const std::vector<Trace_point>& b,
                     double length)
{
  std::vector<Vector3> corners;
  for(const Trace_point& p : b)
    corners.push_back(position(pm, p));
  for(const Trace_point& p : a)
  {
    double distance = (std::numeric_limits<double>::max)();
    for(std::size_t i = 0; i < corners.size(); ++i)
      distance = (std::min)(distance,
                            distance_to_segment(position(pm, p), corners[i], corners[(i + 1) % corners.size()]));
    if(distance > coincidence_tolerance * length)
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H
