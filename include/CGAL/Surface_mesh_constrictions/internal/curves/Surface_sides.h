// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/outward_signs.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How a simple closed curve divides its connected component, with the holes filled.
struct Parting
{
  std::vector<Index> homology_class; // modulo 2, see `Surface_cycles`; the curve separates if it is empty
  std::array<double, 2> areas;       // left and right; if not separating, both that of the component
  std::array<double, 2> hole_areas;  // the same of what would fill the holes, flat

  bool is_separating() const { return homology_class.empty(); }
};

inline double isoperimetric_ratio(double length, const std::array<double, 2>& areas)
{
  return length * length / (4 * CGAL_PI * (std::min)(areas[0], areas[1]));
}

// The holes count as filled, so that a limb has the same ratio whether its end is open or closed. But if there is
// nothing except a hole on one side, the curve cuts nothing off, and the ratio is infinite.
inline double isoperimetric_ratio(double length, const Parting& parting)
{
  std::array<double, 2> areas = parting.areas;
  for(std::size_t i = 0; i < 2; ++i)
    if(areas[i] > 0)
      areas[i] += parting.hole_areas[i];
  return isoperimetric_ratio(length, areas);
}

// Whether a curve of this length separates and has a greater isoperimetric ratio.
inline bool is_too_long(double length, const Parting& parting, double maximum_isoperimetric_ratio)
{
  return parting.is_separating() && isoperimetric_ratio(length, parting) > maximum_isoperimetric_ratio;
}

// A curve along the boundary can leave nothing on one side, and sums of areas have an error of less than this share.
constexpr double empty_side_tolerance = 1e-9;

// Tells the areas, genera and homology classes on the sides of simple closed curves of a surface.
class Surface_sides
{
public:
  // Linear, but for what `outward_signs()` says.
  explicit Surface_sides(const Progressive_mesh& pm) : m_pm(pm), m_cycles(pm), m_outward(outward_signs(pm, m_cycles)) {}

  // The curve is moved to its left, to the next vertices, and the area between is measured. O(n + (n + g) log n) for n
  // points and genus g.
  Parting part(const std::vector<Trace_point>& trace) const
  {
    const std::vector<Index> path = vertices_passed(m_pm, trace);
    return part(path, area_between(m_pm, trace, path));
  }

  // The same for a closed path of vertices, consecutive ones adjacent or equal, or for a curve beside it on its right,
  // with this area between the two.
  Parting part(const std::vector<Index>& path, double between = 0) const
  {
    const Index face = m_pm.face(m_pm.outgoing(path[0]));
    const double whole = m_cycles.area_of_component(face), holes = m_cycles.hole_area_of_component(face);
    Parting result = {m_cycles.homology_class(path), {{whole, whole}}, {{holes, holes}}};
    if(!result.is_separating())
      return result;
    double left = m_cycles.area_on_left(path) + between, holes_on_left = m_cycles.hole_area_on_left(path);
    for(; left < 0; left += whole)
      holes_on_left += holes;
    for(; left > whole; left -= whole)
      holes_on_left -= holes;
    holes_on_left = (std::max)(0.0, (std::min)(holes_on_left, holes));
    if(m_pm.has_boundary() && (std::min)(left, whole - left) < empty_side_tolerance * whole)
      left = m_cycles.has_only_ghosts_on_left(path) ? 0 : whole;
    result.areas = {{left, whole - left}};
    result.hole_areas = {{holes_on_left, holes - holes_on_left}};
    return result;
  }

  // What `area_between()` needs of a simple closed curve: a face of its component, and the bounds of the paths that it
  // becomes when it is moved to the next vertices on its left and on its right.
  struct Bounds
  {
    Index face;
    std::array<std::vector<Index>, 2> of_paths;
  };

  // O(k log k) for k points.
  Bounds bounds(const std::vector<Trace_point>& trace) const
  {
    const std::vector<Index> left = vertices_passed(m_pm, trace);
    return {m_pm.face(m_pm.outgoing(left.front())),
            {{m_cycles.bounds(left), m_cycles.bounds(vertices_passed(m_pm, reversed(m_pm, trace)))}}};
  }

  // The least area that a simple closed curve must sweep to become another one of its class: the area between the two,
  // also where they cross; infinite for curves of different components. Both are moved to the next vertices, to the left
  // and to the right, and the mean is taken. Linear in the points of both.
  double area_between(const Bounds& curve, const Bounds& other) const
  {
    if(m_cycles.component(curve.face) != m_cycles.component(other.face))
      return (std::numeric_limits<double>::infinity)();
    double sum = 0;
    for(const std::vector<Index>& path : curve.of_paths)
      for(const std::vector<Index>& other_path : other.of_paths)
        sum += m_cycles.area_between(curve.face, path, other_path);
    return sum / 4;
  }

  // The same of two curves with these traces. O(k log k) for k points.
  double area_between(const std::vector<Trace_point>& trace, const std::vector<Trace_point>& other) const
  {
    return area_between(bounds(trace), bounds(other));
  }

  // The area between a curve of a surface and the vertices next to it on its left. Linear.
  static double area_between(const Progressive_mesh& pm, const std::vector<Trace_point>& trace,
                             const std::vector<Index>& path)
  {
    double sum = 0;
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      const std::size_t j = (i + 1) % trace.size();
      const Vector3 p = position(pm, trace[i]), q = position(pm, trace[j]);
      const Vector3 u = position(pm, path[i]), v = position(pm, path[j]);
      sum += norm(cross(q - p, v - p) + cross(v - p, u - p)) / 2;
    }
    return sum;
  }

  // Whether a curve that separates has a face on the side of the lesser area, up to the faces that it crosses. Linear.
  bool is_on_lesser_side(const std::vector<Trace_point>& trace, const Parting& parting, Index face) const
  {
    const std::vector<Index> path = vertices_passed(m_pm, trace);
    return m_cycles.is_on_left(path, face) == (parting.areas[0] <= parting.areas[1]);
  }

  // The genera of the parts on the left and on the right of a geodesic; if it does not separate, both that of its
  // component cut along it. Linear in the points and the degrees of the pivots.
  std::array<std::size_t, 2> genera(const std::vector<Trace_point>& trace, bool is_separating) const
  {
    return genera_beside(crossings_beside_pivots(m_pm, trace), is_separating);
  }

  // The same for a curve that passes no vertex, of which these are the crossed halfedges.
  std::array<std::size_t, 2> genera_beside(const std::vector<Index>& crossings, bool is_separating) const
  {
    if(is_separating)
      return m_cycles.genera(crossings);
    const std::size_t genus = m_cycles.genus_of_component(m_pm.face(crossings.front())) - 1;
    return {{genus, genus}};
  }

  // Which side of the surface a geodesic chokes: where its curvature vector points into the solid, the object. At least
  // three quarters of its turning must point to one side. The length of the curve would be a bad weight: where it
  // crosses almost flat edges, noise alone decides to which side it bends. Linear.
  Side choked_side(const std::vector<Trace_point>& trace) const { return choked_side(m_pm, trace, some_face(trace)); }

  // The same for a curve of the surface `with`, which is this one with vertices more; `face` is one of its component.
  Side choked_side(const Progressive_mesh& with, const std::vector<Trace_point>& trace, Index face) const
  {
    const int outward = m_outward.at(m_cycles.component(face));
    double inwards = 0, outwards = 0;
    const std::size_t n = trace.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Vector3 p = position(with, trace[i]), m = normal(with, trace[i]);
      const Vector3 a = p - position(with, trace[(i + n - 1) % n]), b = position(with, trace[(i + 1) % n]) - p;
      const double la = norm(a), lb = norm(b), lm = norm(m);
      if(la == 0 || lb == 0 || lm == 0)
        continue;
      const double bend = outward * dot((1 / lb) * b - (1 / la) * a, m) / lm;
      (bend < 0 ? inwards : outwards) += std::abs(bend);
    }
    const double share = inwards + outwards > 0 ? inwards / (inwards + outwards) : 0.5;
    return share >= 0.75 ? Side::OBJECT : share <= 0.25 ? Side::COMPLEMENT : Side::MIXED;
  }

private:
  // A face that stands for the component that a curve is on.
  Index component(const std::vector<Trace_point>& trace) const
  {
    return m_cycles.component(m_pm.face(m_pm.outgoing(vertices_passed(m_pm, trace).front())));
  }

  // Twice the area long.
  static Vector3 normal(const Progressive_mesh& pm, Index f)
  {
    const auto& p = pm.point(pm.source(3 * f));
    return cross(vector(p, pm.point(pm.source(3 * f + 1))), vector(p, pm.point(pm.source(3 * f + 2))));
  }

  static Vector3 normal(const Progressive_mesh& pm, const Trace_point& p)
  {
    Vector3 sum = {0, 0, 0};
    const auto add = [&](Index f) {
      if(pm.is_ghost_face(f))
        return;
      const Vector3 n = normal(pm, f);
      const double l = norm(n);
      if(l > 0)
        sum = sum + (1 / l) * n;
    };
    if(p.is_pivot())
    {
      const Index begin = pm.outgoing(p.pivot);
      Index h = begin;
      do
      {
        add(pm.face(h));
        h = pm.ccw(h);
      } while(h != begin);
    }
    else
    {
      add(pm.face(p.halfedge));
      add(pm.face(pm.opposite(p.halfedge)));
    }
    return sum;
  }

  Index some_face(const std::vector<Trace_point>& trace) const
  {
    return m_pm.face(trace[0].is_pivot() ? m_pm.outgoing(trace[0].pivot) : trace[0].halfedge);
  }

  const Progressive_mesh& m_pm;
  Surface_cycles m_cycles;
  std::unordered_map<Index, int> m_outward;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H
