// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_BRANCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_BRANCH_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A curve that the plane through a vertex cuts out of the surface: from the vertex back to it, or to the boundary.
struct Section_branch
{
  std::vector<Trace_point> crossings;
  double length;
  bool is_closed;
};

// The curves that begin at a vertex, of the section with the plane through it. Vertices in the plane count as above it
// if `plane_is_above`, else as below it. So a curve crosses edges only, and is a level set that branches or ends only
// at the vertex and at the boundary. Each closed curve comes once. Linear in the degree of the vertex and the number of
// faces that are crossed.
inline std::vector<Section_branch> section_branches(const Progressive_mesh& pm, Index vertex, const Vector3& normal,
                                                    bool plane_is_above)
{
  const Vector3 origin = position(pm, vertex);
  const auto height = [&](Index v) { return dot(normal, position(pm, v) - origin); };
  const auto is_above = [&](Index v) {
    const double h = height(v);
    return h > 0 || (h == 0 && plane_is_above);
  };
  const auto crossing = [&](Index h) {
    const double a = height(pm.source(h)), b = height(pm.target(h));
    return Trace_point{null_index, h, (std::min)((std::max)(a / (a - b), 0.), 1.)};
  };
  std::vector<Section_branch> result;
  std::vector<Index> arrivals; // halfedges, in faces of the vertex, over which closed curves come back
  const Index begin = pm.outgoing(vertex);
  Index spoke = begin;
  do
  {
    Index h = Progressive_mesh::next(spoke);
    const bool is_ghost = pm.is_ghost_face(pm.face(spoke));
    spoke = pm.ccw(spoke);
    if(is_ghost || is_above(pm.source(h)) == is_above(pm.target(h)) ||
       std::find(arrivals.begin(), arrivals.end(), h) != arrivals.end())
      continue;
    Section_branch branch = {{crossing(h)}, 0, false};
    for(;;)
    {
      const Index o = pm.opposite(h), apex = pm.source(pm.prev(o));
      if(pm.is_ghost_face(pm.face(o)))
        break;
      if(apex == vertex)
      {
        branch.is_closed = true;
        arrivals.push_back(o);
        break;
      }
      h = is_above(apex) == is_above(pm.source(o)) ? Progressive_mesh::next(o) : pm.prev(o);
      branch.crossings.push_back(crossing(h));
    }
    Vector3 from = origin;
    for(const Trace_point& p : branch.crossings)
    {
      branch.length += norm(position(pm, p) - from);
      from = position(pm, p);
    }
    if(branch.is_closed)
      branch.length += norm(origin - from);
    result.push_back(std::move(branch));
  } while(spoke != begin);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_SECTION_BRANCH_H
