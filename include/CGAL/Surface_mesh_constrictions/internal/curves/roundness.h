// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ROUNDNESS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ROUNDNESS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// 4 pi A / length^2 of a closed curve, with A the length of its area vector. Linear.
inline double roundness(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  Vector3 twice_area = {0, 0, 0};
  double length = 0;
  const Vector3 first = position(pm, trace.front()); // near the curve, so that little is lost by rounding
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    const Vector3 a = position(pm, trace[i]), b = position(pm, trace[(i + 1) % trace.size()]);
    twice_area = twice_area + cross(a - first, b - first);
    length += norm(b - a);
  }
  return length > 0 ? 2 * CGAL_PI * norm(twice_area) / (length * length) : 0;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ROUNDNESS_H
