// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/path_beside_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Barrier_search.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/rivals.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A simple closed geodesic, and whether it separates its component of the surface.
struct Measured_curve
{
  std::vector<Arc> arcs;
  std::vector<Trace_point> trace;
  double length;
  bool separates;
  bool with_ties = true; // whether another curve of the same length may stand for it
  bool on_input = false; // whether the neighbourhood is searched on the input first
};

// A barrier relative to the length of its curve, less one, and the curve or point behind it.
struct Prominence
{
  double value;
  Barrier_end end;
  std::vector<Arc> arcs;   // of the shorter curve, if `end` is CURVE
  double length = 0;       // of that
  std::vector<Index> path; // of edges, that shortens to it; fewer than three vertices if none is known
  Index vertex;            // over which the curve slides off, if `end` is POINT
  std::uint64_t place = 0; // the same for all curves that are one on the level on which this one was measured, if not 0
};

// The height of a barrier relative to the length of its curve, less one; never less than 0, whatever rounding does.
inline double prominence_of_barrier(double barrier, double length)
{
  return barrier > length ? barrier / length - 1 : 0; // also where the length is rounded to zero
}

// Whether two curves of these lengths and prominences are twins, if they are at one place: see `lead_twins()`.
inline bool are_like_twins(double length, double prominence, double other_length, double other_prominence)
{
  return std::abs(length - other_length) <= alike_tolerance * (std::max)(length, other_length) &&
         are_alike(prominence, other_prominence);
}

// The prominence that follows from the barrier around the curve from which the last search started.
inline Prominence prominence_from(Barrier_search& search, const Barrier& b, double length)
{
  Prominence result = {prominence_of_barrier(b.length, length), b.end, {}, 0, {}, b.vertex};
  if(b.end == Barrier_end::CURVE)
  {
    result.arcs = search.tightener().arcs(b.curve);
    result.length = search.tightener().length(b.curve);
    result.path = path_inside(search.tightener().surface(), b.strip);
  }
  return result;
}

// The prominence of one curve, up to a greatest value.
inline Prominence prominence(Barrier_search& search, const Measured_curve& curve, double greatest)
{
  return prominence_from(
      search, search.search(curve.arcs, curve.trace, curve.separates, (1 + greatest) * curve.length, curve.with_ties),
      curve.length);
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_PROMINENCES_H
