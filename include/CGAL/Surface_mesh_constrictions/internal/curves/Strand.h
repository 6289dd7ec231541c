// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_STRAND_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_STRAND_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A straight piece of a curve inside a face. `entry` and `exit` are places on the face's boundary, counted
// counterclockwise from 0 to 3: corner i of the face is at i, the middle of the edge after it at i + 1/2.
struct Strand
{
  Index face;
  double entry, exit;
};

// The place of a point of a curve on the boundary of a face that it is on.
inline double place_on_boundary(const Progressive_mesh& pm, Index face, const Trace_point& p)
{
  for(Index i = 0; i < 3; ++i)
  {
    const Index h = 3 * face + i;
    if(p.is_pivot() ? pm.source(h) == p.pivot : h == p.halfedge)
      return i + p.parameter;
    if(!p.is_pivot() && pm.opposite(h) == p.halfedge)
      return i + (1 - p.parameter);
  }
  return 0; // not reached: the point is on the face
}

// The point at a place on the boundary of a face.
inline Vector3 boundary_position(const Progressive_mesh& pm, Index face, double place)
{
  const double corner = std::floor(place);
  return position(pm, Trace_point{null_index, 3 * face + static_cast<Index>(corner) % 3, place - corner});
}

// The pieces of a closed curve that cross the inside of faces, in order; pieces along edges are left out.
inline std::vector<Strand> strands(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Strand> result;
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    const Trace_point &p = trace[i], &q = trace[(i + 1) % trace.size()];
    if(p.is_pivot() && q.is_pivot())
      continue;
    const Index f = p.is_pivot() ? pm.face(q.halfedge) : pm.face(pm.opposite(p.halfedge));
    result.push_back({f, place_on_boundary(pm, f, p), place_on_boundary(pm, f, q)});
  }
  return result;
}

// Whether the ends of two strands of one face alternate on its boundary: whether they cross inside the face.
inline bool alternate(const Strand& s, const Strand& t)
{
  // x strictly between a and b, counterclockwise from a
  const auto between = [](double a, double b, double x) { return a < b ? a < x && x < b : x > a || x < b; };
  return s.entry != t.entry && s.entry != t.exit && s.exit != t.entry && s.exit != t.exit &&
         between(s.entry, s.exit, t.entry) != between(s.entry, s.exit, t.exit);
}

// Whether a closed curve neither crosses nor touches itself. O(n + sum of squared numbers of strands in one face).
inline bool is_simple(const Progressive_mesh& pm, const std::vector<Trace_point>& trace)
{
  std::vector<Index> pivots;
  for(const Trace_point& p : trace)
    if(p.is_pivot())
      pivots.push_back(p.pivot);
  std::sort(pivots.begin(), pivots.end());
  if(std::adjacent_find(pivots.begin(), pivots.end()) != pivots.end())
    return false;

  std::vector<Strand> s = strands(pm, trace);
  std::sort(s.begin(), s.end(), [](const Strand& a, const Strand& b) { return a.face < b.face; });
  for(std::size_t i = 0; i < s.size(); ++i)
    for(std::size_t j = i + 1; j < s.size() && s[j].face == s[i].face; ++j)
    {
      const bool touches =
          s[i].entry == s[j].entry || s[i].entry == s[j].exit || s[i].exit == s[j].entry || s[i].exit == s[j].exit;
      if(touches)
      {
        // the two strands of one pivot share a corner
        const bool at_corner = (s[i].entry == s[j].exit && s[i].entry == std::floor(s[i].entry)) ||
                               (s[i].exit == s[j].entry && s[i].exit == std::floor(s[i].exit));
        if(!at_corner)
          return false;
        continue;
      }
      if(alternate(s[i], s[j]))
        return false;
    }
  return true;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_STRAND_H
