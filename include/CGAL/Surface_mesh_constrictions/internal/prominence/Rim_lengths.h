// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Edge_lengths.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How the level sets of one side of a sweep are closed on a surface with boundary. A level set that meets a hole ends
// on its boundary. It is closed along the boundary: by the part that has been swept, or by the one that neither side
// has swept, whichever is shorter. So the sweep slides over a hole as if that were filled by a flat piece, and at the
// open end of a tube it comes off when its rim has been passed.
class Rim_lengths
{
public:
  void restart() { m_holes.clear(); }

  // Adds a boundary edge, given by a halfedge, whose ends are at these distances, and which belongs to this class. The
  // first edge of a hole costs as much as the hole has edges.
  void add(const Progressive_mesh& pm, const Edge_lengths& lengths, Index h, double low, double high, std::size_t c)
  {
    Hole& hole = this->hole(pm, lengths, h);
    hole.pieces.push_back({(std::min)(low, high), (std::max)(low, high), lengths[h]});
    hole.c = c;
  }

  // Takes away a boundary edge that the other side has swept.
  void take_away(const Progressive_mesh& pm, const Edge_lengths& lengths, Index h)
  {
    hole(pm, lengths, h).total -= lengths[h];
  }

  // Calls f(class, length) for each hole that the level set at a distance is closed along. Distances must not fall from
  // call to call. Linear in the edges that the level set meets, and in the holes.
  template <class Function>
  void for_each(double distance, const Function& f)
  {
    for(auto& [ghost, hole] : m_holes)
    {
      double swept = 0;
      std::size_t end = 0;
      for(const Piece& p : hole.pieces)
        if(p.high <= distance)
          hole.passed += p.length;
        else
        {
          if(p.low < distance)
            swept += p.length * (distance - p.low) / (p.high - p.low);
          hole.pieces[end++] = p;
        }
      hole.pieces.resize(end);
      swept += hole.passed;
      const double length = (std::min)(swept, hole.total - swept);
      if(length > 0)
        f(hole.c, length);
    }
  }

private:
  struct Piece
  {
    double low, high, length;
  };

  struct Hole
  {
    double total = 0, passed = 0; // of the boundary, and of what this side has swept of it
    std::vector<Piece> pieces;    // the rest of what is known of it
    std::size_t c = 0;
  };

  // The hole at a boundary edge.
  Hole& hole(const Progressive_mesh& pm, const Edge_lengths& lengths, Index h)
  {
    if(!pm.is_ghost_face(pm.face(h)))
      h = pm.opposite(h);
    const Index ghost = pm.source(pm.prev(h));
    const auto inserted = m_holes.emplace(ghost, Hole());
    Hole& result = inserted.first->second;
    if(inserted.second)
    {
      const Index begin = pm.outgoing(ghost);
      Index g = begin;
      do
      {
        result.total += lengths[pm.next(g)];
        g = pm.ccw(g);
      } while(g != begin);
    }
    return result;
  }

  std::map<Index, Hole> m_holes; // by ghost vertex
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PROMINENCE_RIM_LENGTHS_H
