// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_MEASURES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_MEASURES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Measures of a closed curve in space, which do not depend on the surface that it lies on.
struct Curve_measures
{
  double roundness; // 4 pi A / length^2, with A the length of its area vector
  Vector3 centroid; // of the curve, not of its points
  Vector3 normal;   // of length 1, along the area vector; 0 if that is as small as its rounding
};

// Linear.
inline Curve_measures curve_measures(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  // relative to a point of the curve, so that little is lost by rounding
  Vector3 twice_area = {0, 0, 0}, moment = {0, 0, 0};
  double length = 0;
  const Vector3 first = position(pm, trace.front());
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    const Vector3 a = position(pm, trace[i]) - first, b = position(pm, trace[(i + 1) % trace.size()]) - first;
    const double edge_length = norm(b - a);
    twice_area = twice_area + cross(a, b);
    moment = moment + 0.5 * edge_length * (a + b);
    length += edge_length;
  }
  const double twice_size = norm(twice_area);
  const bool has_area = twice_size > 1e-12 * length * length;
  return {length > 0 ? 2 * CGAL_PI * twice_size / (length * length) : 0,
          length > 0 ? first + 1 / length * moment : first, has_area ? 1 / twice_size * twice_area : Vector3{0, 0, 0}};
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_CURVE_MEASURES_H
