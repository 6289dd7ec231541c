// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FACE_RING_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FACE_RING_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The boundary of a crossed triangle, and how the strands of curves cut it into convex pieces.
struct Face_ring
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // A corner of the triangle or a crossing on a side, counterclockwise from the first corner.
  struct Place
  {
    std::size_t side;     // that the corner comes before, or that is crossed
    std::size_t rank;     // 0 at the corner, then counted along the side
    std::size_t crossing; // none at a corner
  };

  // A strand between two places, `low` < `high`. No two chords cross, and each has other places on both sides.
  struct Chord
  {
    std::size_t low, high;
    std::size_t strand; // of the face
    bool is_ascending;  // whether the strand runs from low to high
  };

  // A side of a piece: along the boundary of the triangle from place `from` to the next, or along a chord.
  struct Piece_side
  {
    std::size_t from;
    std::size_t chord; // or none
  };

  std::vector<Place> places;
  std::vector<Chord> chords; // those that cut off more come later

  // the pieces, each the counterclockwise sequence of its sides. O(k log k) for k chords.
  std::vector<std::vector<Piece_side>> pieces() const
  {
    const std::size_t n = places.size();
    // at each place the sides of pieces that begin there, counterclockwise: by how far the other end is
    struct Side
    {
      std::size_t offset, chord;
      bool is_seen;
    };
    std::vector<std::vector<Side>> sides(n);
    for(std::size_t p = 0; p < n; ++p)
      sides[p].push_back({1, none, false});
    for(std::size_t c = 0; c < chords.size(); ++c)
    {
      sides[chords[c].low].push_back({chords[c].high - chords[c].low, c, false});
      sides[chords[c].high].push_back({n - (chords[c].high - chords[c].low), c, false});
    }
    for(std::vector<Side>& s : sides)
      std::sort(s.begin(), s.end(), [](const Side& a, const Side& b) { return a.offset < b.offset; });

    std::vector<std::vector<Piece_side>> result;
    for(std::size_t p = 0; p < n; ++p)
      for(std::size_t first = 0; first < sides[p].size(); ++first)
      {
        if(sides[p][first].is_seen)
          continue;
        result.emplace_back();
        std::size_t at = p, i = first;
        while(!sides[at][i].is_seen)
        {
          sides[at][i].is_seen = true;
          result.back().push_back({at, sides[at][i].chord});
          const std::size_t back = n - sides[at][i].offset; // seen from the other end
          at = (at + sides[at][i].offset) % n;
          i = sides[at].size();
          while(sides[at][i - 1].offset >= back)
            --i;
          --i;
        }
      }
    return result;
  }
};

// The ring of a crossed face, from the source of its halfedge `base`.
template <class TriangleMesh>
Face_ring face_ring(const Curve_arrangement<TriangleMesh>& arrangement, std::size_t face,
                    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor base)
{
  const auto& strands = arrangement.faces()[face].strands;
  std::vector<Face_ring::Place> crossed;
  std::array<std::size_t, 4> first = {{0, 0, 0, 0}}; // the number of crossings before each side
  typedef typename Curve_arrangement<TriangleMesh>::Boundary_place Boundary_place;
  std::vector<std::pair<Boundary_place, Boundary_place>> ends;
  for(const auto& s : strands)
  {
    const auto crossings = arrangement.ends(s);
    const auto places = arrangement.boundary_places(s, base);
    ends.push_back(places);
    if(crossings.first)
      crossed.push_back({places.first.side, places.first.rank, *crossings.first});
    if(crossings.second)
      crossed.push_back({places.second.side, places.second.rank, *crossings.second});
  }
  for(const Face_ring::Place& p : crossed)
    for(std::size_t side = p.side + 1; side < 4; ++side)
      ++first[side];

  Face_ring ring;
  ring.places.resize(3 + crossed.size());
  const auto index = [&first](std::size_t side, std::size_t rank) { return first[side] + side + rank; };
  for(std::size_t side = 0; side < 3; ++side)
    ring.places[index(side, 0)] = {side, 0, Face_ring::none};
  for(const Face_ring::Place& p : crossed)
    ring.places[index(p.side, p.rank)] = p;
  for(std::size_t s = 0; s < strands.size(); ++s)
  {
    const std::size_t a = index(ends[s].first.side, ends[s].first.rank),
                      b = index(ends[s].second.side, ends[s].second.rank);
    ring.chords.push_back({(std::min)(a, b), (std::max)(a, b), s, a < b});
  }
  std::sort(ring.chords.begin(), ring.chords.end(), [](const Face_ring::Chord& a, const Face_ring::Chord& b) {
    return a.high - a.low != b.high - b.low ? a.high - a.low < b.high - b.low : a.low < b.low;
  });
  return ring;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_FACE_RING_H
