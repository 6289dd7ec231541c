// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_FRONT_START_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_FRONT_START_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Curve_crossings.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Strand.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Distance_front.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// What lies next to a curve on one of its sides, when a front starts from it.
struct Front_start
{
  // A corner of a piece of a face that the curve cuts: a vertex, or a point of the curve.
  struct Corner
  {
    Index vertex; // or null_index
    Vector3 point;
  };
  typedef std::array<Corner, 3> Piece;

  std::vector<Index> vertices; // of the faces that the curve cuts
  std::vector<Piece> pieces;   // what it cuts them into
  std::vector<Index> faces;    // at pivots, that the curve does not cut

  void clear()
  {
    vertices.clear();
    pieces.clear();
    faces.clear();
  }
};

// Cuts a face along some strands, and gives its corners their distances to them.
inline void cut_face(const Progressive_mesh& pm, const Strand* begin, const Strand* end, Distance_front& front,
                     std::array<Front_start*, 2> sides)
{
  // walking around the face, the left side follows an exit and the right side an entry
  struct End
  {
    double place;
    std::size_t side;
    const Strand* strand;
  };
  const Index f = begin->face;
  std::vector<End> ends;
  for(const Strand* s = begin; s != end; ++s)
  {
    ends.push_back({s->exit, 0, s});
    ends.push_back({s->entry, 1, s});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place < b.place; });
  for(std::size_t i = 0; i < ends.size(); ++i)
  {
    const End &from = ends[i], &to = ends[(i + 1) % ends.size()];
    const double last = i + 1 < ends.size() ? to.place : to.place + 3;
    const Front_start::Corner start = {null_index, boundary_position(pm, f, from.place)};
    Front_start::Corner previous = {null_index, boundary_position(pm, f, to.place)};
    for(int corner = static_cast<int>(std::ceil(last)) - 1; corner > from.place; --corner)
    {
      const Index v = pm.source(3 * f + static_cast<Index>(corner % 3));
      const Vector3 p = position(pm, v);
      double distance = (std::numeric_limits<double>::max)();
      for(const Strand* s : {from.strand, to.strand})
        distance = (std::min)(
            distance, distance_to_segment(p, boundary_position(pm, f, s->entry), boundary_position(pm, f, s->exit)));
      front.offer(v, distance, from.side);
      sides[from.side]->vertices.push_back(v);
      sides[from.side]->pieces.push_back({{start, {v, p}, previous}});
      previous = {v, p};
    }
  }
}

// A crossing is taken to be this share of its edge away from the ends, at least: where rounding puts it onto a vertex,
// or behind it, the vertex would be on no side of the curve, or on the wrong one.
constexpr double least_crossing_parameter = 1e-9;

// Starts a front, which has been restarted, from a curve to both sides: settles the pivots, bars the faces that the
// curve cuts, and offers distances to the vertices around. Linear in the number of these.
inline void start_front(const Progressive_mesh& pm, std::vector<Trace_point> trace, Distance_front& front,
                        Front_start& left, Front_start& right)
{
  for(Trace_point& p : trace)
    if(!p.is_pivot())
      p.parameter = (std::min)((std::max)(p.parameter, least_crossing_parameter), 1 - least_crossing_parameter);
  const std::array<Front_start*, 2> sides = {{&left, &right}};
  for(const Trace_point& p : trace)
    if(p.is_pivot())
      front.settle_source(p.pivot);
  std::vector<Strand> all = strands(pm, trace);
  std::sort(all.begin(), all.end(), [](const Strand& a, const Strand& b) { return a.face < b.face; });
  for(const Strand& s : all)
    front.bar(s.face);
  for(std::size_t i = 0; i < all.size();)
  {
    std::size_t end = i;
    while(end < all.size() && all[end].face == all[i].face)
      ++end;
    cut_face(pm, all.data() + i, all.data() + end, front, sides);
    i = end;
  }
  for(std::size_t i = 0; i < trace.size(); ++i)
  {
    if(!trace[i].is_pivot())
      continue;
    const Pivot_fan fan = pivot_fan(pm, trace, i);
    std::size_t side = 0;
    Index h = fan.out;
    do
    {
      if(h == fan.in)
        side = 1;
      const Index f = pm.face(h);
      if(!front.is_barred(f))
      {
        sides[side]->faces.push_back(f);
        front.pass_through(f, side);
      }
      h = pm.ccw(h);
    } while(h != fan.out);
  }
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_FRONT_START_H
