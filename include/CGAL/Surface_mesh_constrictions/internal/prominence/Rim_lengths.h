// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Lengths along rims that close the boundary of a swept region on a surface whose holes are closed by ghosts. Where the
// boundary meets a hole it goes on along the rim of the hole: along the part that has been swept, or along the rest,
// whichever is shorter. So the sweep slides over a hole as if that were filled by a flat piece, and at the open end of
// a tube it comes off when it has passed the rim.
class Rim_lengths
{
public:
  Rim_lengths(const Progressive_mesh& pm, const Edge_lengths& lengths) : m_pm(pm), m_lengths(lengths) {}

  void restart() { m_holes.clear(); }

  // Adds an edge of a rim, given by a halfedge, whose ends are at these distances. The first edge of a hole costs as
  // much as the hole has edges.
  void add(Index h, double from, double to)
  {
    if(!m_pm.is_ghost_face(m_pm.face(h)))
      h = m_pm.opposite(h);
    Hole& hole = m_holes[m_pm.source(m_pm.prev(h))];
    if(hole.total == 0)
      hole.total = length_of_rim(m_pm.source(m_pm.prev(h)));
    hole.pieces.push_back({(std::min)(from, to), (std::max)(from, to), m_lengths[h]});
  }

  // The length along rims at a distance. Linear in the edges that have been added.
  double length(double distance) const
  {
    double sum = 0;
    for(const auto& [ghost, hole] : m_holes)
    {
      const double swept = hole.swept(distance);
      sum += (std::min)(swept, hole.total - swept);
    }
    return sum;
  }

  // Whether more than half of the rim of a ghost's hole has been swept at a distance.
  bool is_passed(Index ghost, double distance) const
  {
    const auto hole = m_holes.find(ghost);
    return hole != m_holes.end() && hole->second.swept(distance) > hole->second.total / 2;
  }

private:
  struct Piece
  {
    double low, high, length;
  };

  struct Hole
  {
    double total = 0;          // the length of its rim
    std::vector<Piece> pieces; // what is known of it

    double swept(double distance) const
    {
      double sum = 0;
      for(const Piece& p : pieces)
        sum += p.high <= distance ? p.length : p.low < distance ? p.length * (distance - p.low) / (p.high - p.low) : 0;
      return (std::min)(sum, total);
    }
  };

  double length_of_rim(Index ghost) const
  {
    double sum = 0;
    const Index begin = m_pm.outgoing(ghost);
    Index g = begin;
    do
    {
      sum += m_lengths[m_pm.next(g)];
      g = m_pm.ccw(g);
    } while(g != begin);
    return sum;
  }

  const Progressive_mesh& m_pm;
  const Edge_lengths& m_lengths;
  std::map<Index, Hole> m_holes; // by ghost vertex
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H
