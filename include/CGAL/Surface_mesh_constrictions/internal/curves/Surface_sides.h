// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  // Linear.
  explicit Surface_sides(const Progressive_mesh& pm) : m_pm(pm), m_cycles(pm), m_volume(pm.number_of_face_ids(), 0)
  {
    for(Index f = 0; f < m_volume.size(); ++f)
      if(pm.is_face(f))
      {
        const Index component = m_cycles.component(f);
        const auto& origin = pm.point(pm.source(3 * component));
        m_volume[component] += dot(vector(origin, pm.point(pm.source(3 * f))), normal(f));
      }
  }

  // The curve is moved to its left, to the next vertices, and the area between is measured. O(n + (n + g) log n) for n
  // points and genus g.
  Parting part(const std::vector<Trace_point>& trace) const
  {
    const std::vector<Index> path = path_on_left(trace);
    double between = 0; // the curve and the path
    for(std::size_t i = 0; i < trace.size(); ++i)
    {
      const std::size_t j = (i + 1) % trace.size();
      const Vector3 p = position(m_pm, trace[i]), q = position(m_pm, trace[j]);
      const Vector3 u = position(m_pm, path[i]), v = position(m_pm, path[j]);
      between += norm(cross(q - p, v - p) + cross(v - p, u - p)) / 2;
    }
    return part(path, between);
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

  // The least area that a simple closed curve must sweep to become another one of its class: the area between the two,
  // also where they cross. Both are moved to the next vertices, to the left and to the right, and the mean is taken.
  // O(k log k) for k points.
  double area_between(const std::vector<Trace_point>& trace, const std::vector<Trace_point>& other) const
  {
    double sum = 0;
    const std::vector<Trace_point> back = reversed(m_pm, trace), other_back = reversed(m_pm, other);
    for(const std::vector<Trace_point>* t : {&trace, &back})
      for(const std::vector<Trace_point>* o : {&other, &other_back})
        sum += m_cycles.area_between(path_on_left(*t), path_on_left(*o));
    return sum / 4;
  }

  // The genera of the parts on the left and on the right of a geodesic; if it does not separate, both that of its
  // component cut along it. Linear in the points and the degrees of the pivots.
  std::array<std::size_t, 2> genera(const std::vector<Trace_point>& trace, bool is_separating) const
  {
    if(is_separating)
      return m_cycles.genera(crossings_beside_pivots(m_pm, trace));
    const std::size_t genus = m_cycles.genus_of_component(some_face(trace)) - 1;
    return {{genus, genus}};
  }

  // Which side of the surface a geodesic chokes: where its curvature vector points into the solid, the object. At least
  // three quarters of its turning must point to one side. The length of the curve would be a bad weight: where it
  // crosses almost flat edges, noise alone decides to which side it bends. Linear.
  Side choked_side(const std::vector<Trace_point>& trace) const
  {
    const double outward = m_volume[m_cycles.component(some_face(trace))] >= 0 ? 1 : -1; // the sign of the normals
    double inwards = 0, outwards = 0;
    const std::size_t n = trace.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const Vector3 p = position(m_pm, trace[i]), m = normal(trace[i]);
      const Vector3 a = p - position(m_pm, trace[(i + n - 1) % n]), b = position(m_pm, trace[(i + 1) % n]) - p;
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
  // The vertices next to a curve on its left.
  std::vector<Index> path_on_left(const std::vector<Trace_point>& trace) const
  {
    std::vector<Index> path;
    for(const Trace_point& p : trace)
      path.push_back(p.is_pivot() ? p.pivot : m_pm.target(p.halfedge));
    return path;
  }

  // Twice the area long.
  Vector3 normal(Index f) const
  {
    const auto& p = m_pm.point(m_pm.source(3 * f));
    return cross(vector(p, m_pm.point(m_pm.source(3 * f + 1))), vector(p, m_pm.point(m_pm.source(3 * f + 2))));
  }

  Vector3 normal(const Trace_point& p) const
  {
    Vector3 sum = {0, 0, 0};
    const auto add = [&](Index f) {
      if(m_pm.is_ghost_face(f))
        return;
      const Vector3 n = normal(f);
      const double l = norm(n);
      if(l > 0)
        sum = sum + (1 / l) * n;
    };
    if(p.is_pivot())
    {
      const Index begin = m_pm.outgoing(p.pivot);
      Index h = begin;
      do
      {
        add(m_pm.face(h));
        h = m_pm.ccw(h);
      } while(h != begin);
    }
    else
    {
      add(m_pm.face(p.halfedge));
      add(m_pm.face(m_pm.opposite(p.halfedge)));
    }
    return sum;
  }

  Index some_face(const std::vector<Trace_point>& trace) const
  {
    return m_pm.face(trace[0].is_pivot() ? m_pm.outgoing(trace[0].pivot) : trace[0].halfedge);
  }

  const Progressive_mesh& m_pm;
  Surface_cycles m_cycles;
  std::vector<double> m_volume; // six times that of a component, by the face that stands for it
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_SURFACE_SIDES_H
