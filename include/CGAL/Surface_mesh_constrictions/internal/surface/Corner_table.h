// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Connectivity of an oriented triangle mesh in two arrays. Face f has the halfedges 3f, 3f+1, 3f+2, in
// counterclockwise order; halfedge 3f+i goes from corner i of the face to corner i+1. The data of a halfedge is stored
// side by side: on a large mesh each array that is read costs a cache miss.
//
// A surface with boundary comes in two forms. Open, its border halfedges have no opposite. Closed by ghosts, each hole
// has one vertex more, which is joined to the edges of the hole by faces: the ghosts. They are numbered after all
// other vertices and faces. No curve enters them.
struct Corner_table
{
  struct Halfedge
  {
    Index source, opposite;
  };

  std::vector<Halfedge> halfedges;
  std::vector<Index> outgoing; // a halfedge out of a vertex; null_index for an isolated vertex
  Index first_ghost_vertex = null_index, first_ghost_face = null_index; // null_index if there is none

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

inline std::string edge_name(std::size_t u, std::size_t v)
{
  return "the edge between vertices " + std::to_string(u) + " and " + std::to_string(v);
}

// Throws an Invalid_input for the edge of halfedge h, which does not have exactly one halfedge in each direction.
inline void throw_defect_of_edge(Index h, Index u, Index v, std::size_t forth, std::size_t back)
{
  const std::size_t f = h / 3;
  if(forth + back == 1)
    throw Invalid_input(Input_defect::NOT_CLOSED, f,
                        "not closed: " + edge_name(u, v) + " of face " + std::to_string(f) +
                            " has no face on its other side");
  if(forth + back == 2)
    throw Invalid_input(Input_defect::INCONSISTENT_ORIENTATION, f,
                        "inconsistent orientation: the two faces at " + edge_name(u, v) + " (one is face " +
                            std::to_string(f) + ") run along it in the same direction");
  throw Invalid_input(Input_defect::NON_MANIFOLD_EDGE, f,
                      "non-manifold edge: " + edge_name(u, v) + " of face " + std::to_string(f) + " has " +
                          std::to_string(forth + back) + " faces");
}

// Connects triangles, given by three vertex indices each. Throws Invalid_input if the result is not an oriented
// 2-manifold without two edges between the same vertices. It has to be closed or, `with_border`, may have border edges,
// whose halfedges have no opposite. Isolated vertices are allowed.
// Linear in the sum of squared vertex degrees.
inline Corner_table make_corner_table(std::size_t number_of_vertices, const std::vector<Index>& corners,
                                      bool with_border = false)
{
  const std::size_t n = corners.size();
  if(n == 0)
    throw Invalid_input(Input_defect::EMPTY_MESH, 0, "empty mesh: it has no face");
  if(n >= null_index || number_of_vertices >= null_index)
    throw Invalid_input(Input_defect::TOO_LARGE, 0, "mesh too large: 32-bit indices name at most 1431655764 faces");

  Corner_table table;
  table.halfedges.reserve(n);
  table.outgoing.assign(number_of_vertices, null_index);

  // the halfedges out of vertex v are out[first[v]] ... out[first[v + 1] - 1]
  struct Outgoing
  {
    Index halfedge, target;
  };
  std::vector<Index> first(number_of_vertices + 1, 0);
  std::vector<Outgoing> out(n);
  for(Index h = 0; h < n; ++h)
  {
    const Index v = corners[h];
    if(v >= number_of_vertices)
      throw Invalid_input(Input_defect::INVALID_VERTEX_INDEX, h / 3,
                          "invalid vertex index: face " + std::to_string(h / 3) + " refers to vertex " +
                              std::to_string(v) + " of " + std::to_string(number_of_vertices));
    if(v == corners[Corner_table::next(h)])
      throw Invalid_input(Input_defect::ZERO_LENGTH_EDGE, h / 3,
                          "degenerate face: face " + std::to_string(h / 3) + " uses vertex " + std::to_string(v) +
                              " twice");
    table.halfedges.push_back({v, null_index});
    ++first[v + 1];
  }
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    first[v + 1] += first[v];
  {
    std::vector<Index> end(first.begin(), first.end() - 1);
    for(Index h = 0; h < n; ++h)
      out[end[corners[h]]++] = {h, corners[Corner_table::next(h)]};
  }

  for(Index h = 0; h < n; ++h)
  {
    if(table.halfedges[h].opposite != null_index)
      continue;
    const Index u = corners[h], v = corners[Corner_table::next(h)];
    std::size_t forth = 0, back = 0;
    Index o = null_index;
    for(Index i = first[u]; i < first[u + 1]; ++i)
      forth += out[i].target == v;
    for(Index i = first[v]; i < first[v + 1]; ++i)
      if(out[i].target == u)
      {
        ++back;
        o = out[i].halfedge;
      }
    if(with_border && forth == 1 && back == 0)
      continue;
    if(forth != 1 || back != 1)
      throw_defect_of_edge(h, u, v, forth, back);
    table.halfedges[h].opposite = o;
    table.halfedges[o].opposite = h;
  }

  for(std::size_t v = 0; v < number_of_vertices; ++v)
  {
    if(first[v] == first[v + 1])
      continue;
    const Index begin = table.outgoing[v] = out[first[v]].halfedge;
    std::size_t fan = 0;
    Index h = begin;
    do
    {
      ++fan;
      h = table.halfedges[Corner_table::prev(h)].opposite;
    } while(h != begin && h != null_index);
    if(h == null_index) // what is clockwise of the first one
      for(Index o = table.halfedges[begin].opposite; o != null_index;
          o = table.halfedges[Corner_table::next(o)].opposite)
        ++fan;
    if(fan != first[v + 1] - first[v])
      throw Invalid_input(Input_defect::NON_MANIFOLD_VERTEX, v,
                          "non-manifold vertex: the faces around vertex " + std::to_string(v) +
                              " form more than one fan");
  }
  return table;
}

// Whether a surface is open. Linear.
inline bool has_border(const Corner_table& table)
{
  return std::any_of(table.halfedges.begin(), table.halfedges.end(),
                     [](const Corner_table::Halfedge& h) { return h.opposite == null_index; });
}

// Closes an open surface by ghosts, in the order of the smallest border halfedges of the holes, and returns for each
// hole its vertices in cyclic order. Linear.
inline std::vector<std::vector<Index>> close_by_ghosts(Corner_table& table)
{
  std::vector<std::vector<Index>> holes;
  const Index n = static_cast<Index>(table.halfedges.size());
  table.first_ghost_vertex = static_cast<Index>(table.outgoing.size());
  table.first_ghost_face = n / 3;
  for(Index first = 0; first < n; ++first)
  {
    if(table.halfedges[first].opposite != null_index)
      continue;
    const Index ghost = static_cast<Index>(table.outgoing.size());
    const std::size_t begin = table.halfedges.size();
    std::vector<Index> hole;
    Index h = first; // from u to v, with the hole on its right
    do
    {
      const std::size_t g = table.halfedges.size();
      if(g + 3 >= null_index)
        throw Invalid_input(Input_defect::TOO_LARGE, 0, "mesh too large: 32-bit indices name at most 1431655764 faces");
      const Index u = table.halfedges[h].source, v = table.halfedges[Corner_table::next(h)].source;
      const Index from_v = static_cast<Index>(g);
      hole.push_back(v);
      table.halfedges[h].opposite = from_v;
      table.halfedges.push_back({v, h});              // v -> u
      table.halfedges.push_back({u, from_v + 5});     // u -> ghost, next to the edge to u of the face after this one
      table.halfedges.push_back({ghost, from_v - 2}); // ghost -> v
      h = Corner_table::prev(h);                      // the other border halfedge of u's fan
      while(table.halfedges[h].opposite != null_index && h != first)
        h = Corner_table::prev(table.halfedges[h].opposite);
    } while(h != first);
    table.halfedges[begin + 2].opposite = static_cast<Index>(table.halfedges.size() - 2);
    table.halfedges[table.halfedges.size() - 2].opposite = static_cast<Index>(begin + 2);
    table.outgoing.push_back(static_cast<Index>(begin + 2));
    holes.push_back(std::move(hole));
  }
  return holes;
}

// A surface that is closed by ghosts, without them. Linear.
inline Corner_table without_ghosts(const Corner_table& table)
{
  const std::size_t n = 3 * static_cast<std::size_t>(table.first_ghost_face);
  Corner_table result;
  result.halfedges.assign(table.halfedges.begin(), table.halfedges.begin() + static_cast<std::ptrdiff_t>(n));
  for(Corner_table::Halfedge& h : result.halfedges)
    if(h.opposite >= n)
      h.opposite = null_index;
  result.outgoing.assign(table.outgoing.begin(),
                         table.outgoing.begin() + static_cast<std::ptrdiff_t>(table.first_ghost_vertex));
  return result;
}

// The same surface with its faces in another order: first face order[0], then order[1]. Linear.
inline Corner_table with_faces_in_order(const Corner_table& table, const std::vector<Index>& order)
{
  std::vector<Index> place(order.size());
  for(Index i = 0; i < order.size(); ++i)
    place[order[i]] = i;
  const auto moved = [&place](Index h) { return h == null_index ? null_index : 3 * place[h / 3] + h % 3; };
  Corner_table result;
  result.halfedges.reserve(table.halfedges.size());
  for(Index f : order)
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      result.halfedges.push_back({table.halfedges[h].source, moved(table.halfedges[h].opposite)});
  result.outgoing.reserve(table.outgoing.size());
  for(Index h : table.outgoing)
    result.outgoing.push_back(moved(h));
  result.first_ghost_vertex = table.first_ghost_vertex;
  result.first_ghost_face = table.first_ghost_face;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H
