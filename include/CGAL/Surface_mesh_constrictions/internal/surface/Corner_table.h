// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Connectivity of a closed, oriented triangle mesh in two arrays. Face f has the halfedges 3f, 3f+1, 3f+2, in
// counterclockwise order; halfedge 3f+i goes from corner i of the face to corner i+1. What belongs to a halfedge lies
// side by side: on a large mesh each array that is looked up costs a cache miss.
struct Corner_table
{
  struct Halfedge
  {
    Index source, opposite;
  };

  std::vector<Halfedge> halfedges;
  std::vector<Index> outgoing; // a halfedge out of a vertex; null_index for an isolated vertex

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

inline std::string edge_name(std::size_t u, std::size_t v)
{
  return "the edge between vertices " + std::to_string(u) + " and " + std::to_string(v);
}

// Throws what is wrong with the edge of halfedge h: it has not exactly one halfedge in each direction.
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

// Connects triangles, given by three vertex indices each. Throws Invalid_input for whatever is not a closed oriented
// 2-manifold without two edges between the same vertices. Isolated vertices are allowed.
// Linear in the sum of squared vertex degrees.
inline Corner_table make_corner_table(std::size_t number_of_vertices, const std::vector<Index>& corners)
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
    do {
      ++fan;
      h = table.halfedges[Corner_table::prev(h)].opposite;
    } while(h != begin);
    if(fan != first[v + 1] - first[v])
      throw Invalid_input(Input_defect::NON_MANIFOLD_VERTEX, v,
                          "non-manifold vertex: the faces around vertex " + std::to_string(v) +
                          " form more than one fan");
  }
  return table;
}

// The same surface with its faces in another order: first face order[0], then order[1]. Linear.
inline Corner_table with_faces_in_order(const Corner_table& table, const std::vector<Index>& order)
{
  std::vector<Index> place(order.size());
  for(Index i = 0; i < order.size(); ++i)
    place[order[i]] = i;
  const auto moved = [&place](Index h) { return 3 * place[h / 3] + h % 3; };
  Corner_table result;
  result.halfedges.reserve(table.halfedges.size());
  for(Index f : order)
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      result.halfedges.push_back({table.halfedges[h].source, moved(table.halfedges[h].opposite)});
  result.outgoing.reserve(table.outgoing.size());
  for(Index h : table.outgoing)
    result.outgoing.push_back(h == null_index ? null_index : moved(h));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CORNER_TABLE_H
