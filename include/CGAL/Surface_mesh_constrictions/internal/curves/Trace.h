// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TRACE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TRACE_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/unfolding.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A point of a closed curve: a pivot, or a point of a crossed halfedge at source + parameter (target - source).
struct Trace_point
{
  Index pivot;    // or null_index
  Index halfedge; // crossed from its face to the opposite one; or null_index
  double parameter;

  bool is_pivot() const { return pivot != null_index; }
};

// Appends the points of an arc but for its end.
inline void append_trace(const Progressive_mesh& pm, const Arc& arc, std::vector<Trace_point>& trace)
{
  trace.push_back({arc.from, null_index, 0});
  if(arc.is_edge())
    return;
  std::vector<Portal> portals;
  Vector2 end = {0, 0};
  Portal portal = portal_from_apex(pm, arc.crossings.front());
  for(std::size_t i = 0;; ++i)
  {
    portals.push_back(portal);
    end = unfold_apex(pm, arc.crossings[i], portal);
    if(i + 1 == arc.crossings.size())
      break;
    portal = next_portal(pm, arc.crossings[i], portal, end, arc.crossings[i + 1]);
  }
  for(std::size_t i = 0; i < portals.size(); ++i)
  {
    const double d = cross(end, portals[i].left - portals[i].right);
    const double t = d == 0 ? 0.5 : -cross(end, portals[i].right) / d;
    trace.push_back({null_index, arc.crossings[i], (std::min)((std::max)(t, 0.0), 1.0)});
  }
}

// The points of a closed curve in order, the first not repeated. Linear.
inline std::vector<Trace_point> trace(const Progressive_mesh& pm, const std::vector<Arc>& curve)
{
  std::vector<Trace_point> result;
  for(const Arc& a : curve)
    append_trace(pm, a, result);
  return result;
}

// The same closed curve in the other direction. Linear.
inline std::vector<Trace_point> reversed(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Trace_point> result;
  for(auto p = trace.rbegin(); p != trace.rend(); ++p)
    result.push_back(p->is_pivot() ? *p : Trace_point{null_index, pm.opposite(p->halfedge), 1 - p->parameter});
  return result;
}

inline Vector3 position(const Progressive_mesh& pm, const Trace_point& p)
{
  if(p.is_pivot())
    return position(pm, p.pivot);
  const Index u = pm.source(p.halfedge), v = pm.target(p.halfedge);
  return position(pm, u) + p.parameter * vector(pm.point(u), pm.point(v));
}

// Linear.
inline double length(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  double sum = 0;
  for(std::size_t i = 0; i < trace.size(); ++i)
    sum += norm(position(pm, trace[(i + 1) % trace.size()]) - position(pm, trace[i]));
  return sum;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_TRACE_H
