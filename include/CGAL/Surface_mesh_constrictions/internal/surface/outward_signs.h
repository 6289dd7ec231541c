// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_OUTWARD_SIGNS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_OUTWARD_SIGNS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Surface_cycles.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A component of a surface, with its holes filled by ghosts.
struct Component_shape
{
  double volume = 0; // six times; negative if the normals point inside
  Bbox_3 box;
  bool is_closed = true; // without ghosts
};

// By the face that stands for a component.
typedef std::map<Index, Component_shape> Component_shapes;

// Volumes are seen from a vertex of the component, so that they are no rounding errors far from the origin. Linear.
inline Component_shapes component_shapes(const Progressive_mesh& pm, const Surface_cycles& cycles)
{
  Component_shapes result;
  Index component = null_index;
  Component_shape* shape = nullptr;
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
  {
    if(!pm.is_face(f))
      continue;
    if(component != cycles.component(f))
      shape = &result[component = cycles.component(f)];
    const auto &origin = pm.point(pm.source(3 * component)), &p = pm.point(pm.source(3 * f)),
               &q = pm.point(pm.source(3 * f + 1)), &r = pm.point(pm.source(3 * f + 2));
    shape->volume += dot(vector(origin, p), cross(vector(p, q), vector(p, r)));
    shape->box += p.bbox() + q.bbox() + r.bbox();
    shape->is_closed = shape->is_closed && !pm.is_ghost_face(f);
  }
  return result;
}

inline bool is_strictly_inside(const Bbox_3& inner, const Bbox_3& outer)
{
  for(int i = 0; i < 3; ++i)
    if(!((outer.min)(i) < (inner.min)(i) && (inner.max)(i) < (outer.max)(i)))
      return false;
  return true;
}

// Seen from above, whether the edge from u to v passes the half-line from p along x, upwards (1) or downwards (-1). Both
// faces of an edge get the same answer, whatever is rounded, so that a closed surface has no gap.
inline int passing(const Progressive_mesh& pm, Index u, Index v, const Vector3& p)
{
  if(v < u)
    return -passing(pm, v, u, p);
  const Vector3 a = position(pm, u) - p, b = position(pm, v) - p;
  const bool is_upwards = b.y > 0;
  if((a.y > 0) == is_upwards || (a.x * b.y - a.y * b.x > 0) != is_upwards)
    return 0;
  return is_upwards ? 1 : -1;
}

// Whether a face is above p, with its normal upwards (1) or downwards (-1). The sum over a closed surface tells how often
// it winds around p.
inline int covering(const Progressive_mesh& pm, Index f, const Vector3& p)
{
  std::array<Index, 3> v;
  for(Index i = 0; i < 3; ++i)
    v[i] = pm.source(3 * f + i);
  const int turns = passing(pm, v[0], v[1], p) + passing(pm, v[1], v[2], p) + passing(pm, v[2], v[0], p);
  if(turns == 0)
    return 0;
  const Vector3 a = position(pm, v[0]), normal = cross(position(pm, v[1]) - a, position(pm, v[2]) - a);
  return turns * dot(normal, a - p) > 0 ? turns : 0;
}

// For each component 1 if its normals point out of the solid, and else -1. By the face that stands for the component.
//
// A component by itself bounds a solid, so that its normals point inside if its volume is negative. Inside of a closed
// component it belongs to that one's solid, as a cavity, or as something in a cavity: its normals point out of the solid
// if those of the outermost surface around it do.
//
// Linear if no two components have volumes of different signs; otherwise for each face the number of components that
// have a face in its range of x.
inline std::unordered_map<Index, int> outward_signs(const Progressive_mesh& pm, const Surface_cycles& cycles)
{
  struct Place // of a component
  {
    Vector3 point;
    Index component;
    std::map<Index, int> windings; // of others around it
  };

  const Component_shapes shapes = component_shapes(pm, cycles);
  const auto sign = [](const Component_shape& s) { return s.volume >= 0 ? 1 : -1; };
  std::unordered_map<Index, int> result;
  std::vector<Place> places;
  bool are_alike = true;
  for(const auto& [f, shape] : shapes)
  {
    result[f] = sign(shape);
    are_alike = are_alike && sign(shape) == sign(shapes.begin()->second);
    const Vector3 corners =
        position(pm, pm.source(3 * f)) + position(pm, pm.source(3 * f + 1)) + position(pm, pm.source(3 * f + 2));
    places.push_back({1. / 3 * corners, f, {}});
  }
  if(are_alike)
    return result;

  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.point.x < b.point.x; });
  for(Index f = 0; f < pm.number_of_face_ids(); ++f)
  {
    if(!pm.is_face(f))
      continue;
    const Index component = cycles.component(f);
    const Component_shape& shape = shapes.at(component);
    if(!shape.is_closed)
      continue;
    const auto x = std::minmax(
        {pm.point(pm.source(3 * f)).x(), pm.point(pm.source(3 * f + 1)).x(), pm.point(pm.source(3 * f + 2)).x()});
    auto place = std::lower_bound(places.begin(), places.end(), x.first,
                                  [](const Place& p, double low) { return p.point.x < low; });
    for(; place != places.end() && place->point.x <= x.second; ++place)
      if(is_strictly_inside(shapes.at(place->component).box, shape.box))
        place->windings[component] += covering(pm, f, place->point);
  }
  for(const Place& place : places)
  {
    double volume = 0; // of the outermost
    for(const auto& [component, winding] : place.windings)
      if(winding != 0 && std::abs(shapes.at(component).volume) > volume)
      {
        volume = std::abs(shapes.at(component).volume);
        result[place.component] = sign(shapes.at(component));
      }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_OUTWARD_SIGNS_H
