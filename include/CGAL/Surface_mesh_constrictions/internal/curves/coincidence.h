// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Curves whose lengths differ by less than this share, and whose distance is less than this share of their length, are
// the same curve: it passes a vertex so closely that rounding decided on which side.
constexpr double coincidence_tolerance = 1e-8;

// The corners of a closed curve in space.
class Curve_shape
{
public:
  // Linear.
  Curve_shape(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
  {
    m_corners.reserve(trace.size());
    for(const Trace_point& p : trace)
    {
      m_corners.push_back(position(pm, p));
      m_box += Bbox_3(m_corners.back().x, m_corners.back().y, m_corners.back().z, m_corners.back().x,
                      m_corners.back().y, m_corners.back().z);
    }
  }

  const Bbox_3& box() const { return m_box; }

  // Whether each corner lies within a distance of another curve. Quadratic; ends at the first one that does not.
  bool lies_on(const Curve_shape& other, double tolerance) const
  {
    for(const Vector3& p : m_corners)
    {
      double distance = (std::numeric_limits<double>::max)();
      for(std::size_t i = 0; i < other.m_corners.size(); ++i)
        distance = (std::min)(
            distance, distance_to_segment(p, other.m_corners[i], other.m_corners[(i + 1) % other.m_corners.size()]));
      if(distance > tolerance)
        return false;
    }
    return true;
  }

private:
  std::vector<Vector3> m_corners;
  Bbox_3 m_box;
};

// Whether two closed curves are the same but for rounding; `length` is that of one. Constant if their boxes differ, as
// those of most curves do, else quadratic.
inline bool coincide(const Curve_shape& a, const Curve_shape& b, double length)
{
  const double tolerance = coincidence_tolerance * length;
  for(int i = 0; i < 3; ++i)
    if(std::abs(a.box().min(i) - b.box().min(i)) > tolerance || std::abs(a.box().max(i) - b.box().max(i)) > tolerance)
      return false;
  return a.lies_on(b, tolerance) && b.lies_on(a, tolerance);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_COINCIDENCE_H
