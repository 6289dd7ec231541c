// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_LOCATIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_LOCATIONS_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Combinatorial_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Graph_connectivity.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// An arc of a curve that is given by its locations.
template <class Surface>
struct Located_arc : Combinatorial_arc<typename Surface::Vertex, typename Surface::Halfedge>
{
  std::size_t location; // of `from`
};

// What keeps a sequence of locations from being a curve on a surface.
enum class Location_defect
{
  NONE,
  NO_LOCATION,    // there is none
  END_NO_PIVOT,   // an end of a curve that is not closed is no pivot, or both are one location
  OFF_SURFACE,    // a location, or the way to the next one, lies in a hole
  NOT_IN_ONE_FACE // neither a face nor an edge joins a location to the next one
};

// A curve as arcs from one pivot to the next, the first one first.
template <class Surface>
struct Arcs_of_locations
{
  Location_defect defect = Location_defect::NONE;
  std::size_t location = 0;                             // that has the defect
  std::vector<Located_arc<Surface>> arcs;               // if there is no defect
  std::vector<typename Surface::Halfedge> closed_strip; // instead of arcs, what a curve without pivots crosses
};

// Reads a curve off its locations: each a pivot, or a halfedge that is crossed from its face to the opposite one. A
// curve that is not closed goes from one pivot to another. Linear, times the degrees of pivots that edges join.
template <class Surface, class LocationRange>
Arcs_of_locations<Surface> arcs_of_locations(const Surface& s, const LocationRange& locations, bool is_closed = true)
{
  typedef typename Surface::Halfedge Halfedge;
  Arcs_of_locations<Surface> result;
  const std::size_t n = locations.size(), steps = is_closed ? n : n - 1;
  const auto fails = [&result](Location_defect defect, std::size_t i) {
    result.defect = defect;
    result.location = i;
    return result;
  };
  if(n == 0)
    return fails(Location_defect::NO_LOCATION, 0);
  if(!is_closed && (n == 1 || !locations[0].is_pivot || !locations[n - 1].is_pivot))
    return fails(Location_defect::END_NO_PIVOT, n == 1 || !locations[0].is_pivot ? 0 : n - 1);

  const auto edge_between = [&s](auto from, auto to, Halfedge& h) {
    h = s.outgoing(from);
    for(const Halfedge begin = h; s.target(h) != to;)
      if((h = ccw(s, h)) == begin)
        return false;
    return true;
  };
  std::size_t first = n;
  for(std::size_t i = 0; i < steps; ++i)
  {
    const auto &p = locations[i], &q = locations[(i + 1) % n];
    for(const auto* l : {&p, &q})
      if(!l->is_pivot && (s.is_ghost(l->halfedge) || s.is_ghost(s.opposite(l->halfedge))))
        return fails(Location_defect::OFF_SURFACE, l == &p ? i : (i + 1) % n);
    bool are_joined;
    if(p.is_pivot && q.is_pivot)
    {
      Halfedge h;
      are_joined = edge_between(p.vertex, q.vertex, h);
      if(are_joined && s.is_ghost(h) && s.is_ghost(s.opposite(h)))
        return fails(Location_defect::OFF_SURFACE, i);
    }
    else if(p.is_pivot)
      are_joined = s.source(s.prev(q.halfedge)) == p.vertex;
    else
    {
      const Halfedge o = s.opposite(p.halfedge);
      are_joined = q.is_pivot ? s.source(s.prev(o)) == q.vertex : q.halfedge == s.next(o) || q.halfedge == s.prev(o);
    }
    if(!are_joined)
      return fails(Location_defect::NOT_IN_ONE_FACE, i);
    if(first == n && p.is_pivot)
      first = i;
  }
  if(first == n)
  {
    for(const auto& l : locations)
      result.closed_strip.push_back(l.halfedge);
    return result;
  }

  for(std::size_t k = 0; k < steps; ++k)
  {
    const std::size_t i = (first + k) % n;
    const auto &p = locations[i], &q = locations[(i + 1) % n];
    if(!p.is_pivot)
      result.arcs.back().crossings.push_back(p.halfedge);
    else
    {
      result.arcs.push_back({{p.vertex, p.vertex, s.outgoing(p.vertex), {}}, i});
      if(q.is_pivot)
        edge_between(p.vertex, q.vertex, result.arcs.back().along);
    }
    if(q.is_pivot)
      result.arcs.back().to = q.vertex;
  }
  return result;
}

// As above, of a curve on a user's mesh. `number` is its place in the user's sequence, for the message. Throws
// Invalid_input if the locations are no curve, or if one is not between two triangles.
template <class TriangleMesh, class LocationRange>
Arcs_of_locations<Graph_connectivity<TriangleMesh>> arcs_on_mesh(const TriangleMesh& tm, const LocationRange& locations,
                                                                 std::size_t number, bool is_closed = true)
{
  const auto fail = [number](const std::string& reason) {
    throw Invalid_input(Input_defect::INVALID_LOOP, number, "curve " + std::to_string(number) + ": " + reason);
  };
  const Graph_connectivity<TriangleMesh> s(tm);
  std::size_t i = 0;
  for(const auto& l : locations)
  {
    const auto point = [&i] { return "point " + std::to_string(i); };
    if(!l.is_pivot && !(l.parameter >= 0 && l.parameter <= 1))
      fail("the parameter of " + point() + " is not in [0, 1]");
    if(!l.is_pivot && !(s.is_triangle(l.halfedge) && s.is_triangle(s.opposite(l.halfedge))))
      fail(point() + " is not between two triangles");
    ++i;
  }
  auto result = arcs_of_locations(s, locations, is_closed);
  switch(result.defect)
  {
  case Location_defect::NONE:
    break;
  case Location_defect::NO_LOCATION:
    fail("it has no points");
    break;
  case Location_defect::END_NO_PIVOT:
    fail("it has no vertices at its ends");
    break;
  case Location_defect::OFF_SURFACE:
  case Location_defect::NOT_IN_ONE_FACE:
    fail("point " + std::to_string(result.location) + " and the next are not in one face");
    break;
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_CURVES_ARCS_OF_LOCATIONS_H
