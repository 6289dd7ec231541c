// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/split_vertices.h"

#include "input/edge_groups.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <string>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::null_index;
using CGAL::Surface_mesh_constrictions::internal::Corner_table;
using CGAL::Surface_mesh_constrictions::internal::edge_name;

// The first piece of a polygon tells of it.
void tell_of_turned_faces(const Triangles& triangles, Mesh_findings& findings)
{
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(triangles.is_turned[t] && (t == 0 || triangles.face[t - 1] != triangles.face[t] || !triangles.is_turned[t - 1]))
      findings.add(Finding::TURNED_FACES,
                   [&] { return "face " + std::to_string(triangles.face[t]) + " is turned round"; });
}

void tell_of_edges(std::size_t number_of_vertices, const Triangles& triangles, Mesh_findings& findings)
{
  typedef Edge_groups::Side Side;
  std::vector<std::size_t> begins(triangles.size() + 1);
  for(std::size_t t = 0; t < begins.size(); ++t)
    begins[t] = 3 * t;
  Edge_groups(number_of_vertices, triangles.corners, begins).for_each([&](Index u, const Side* begin, const Side* end) {
    const auto name = [&] {
      return edge_name(u, begin->to) + " of face " + std::to_string(triangles.face[begin->side / 3]);
    };
    if(end - begin > 2 || (end - begin == 2 && begin[0].is_forth == begin[1].is_forth))
      findings.add(Finding::SPLIT_EDGES,
                   [&] { return "non-manifold edge: " + name() + " has " + std::to_string(end - begin) + " faces"; });
    else if(end - begin == 2 && triangles.opposite[begin->side] == null_index)
      findings.add(Finding::CUT_EDGES, [&] { return "beside a non-manifold edge: " + name() + " is cut open"; });
  });
}

// By corner, the first one of the fan of triangles that it is in.
std::vector<Index> fans(const std::vector<Index>& opposite)
{
  std::vector<Index> result(opposite.size(), null_index);
  for(Index c = 0; c < opposite.size(); ++c)
  {
    if(result[c] != null_index)
      continue;
    result[c] = c;
    for(Index o = opposite[c]; o != null_index && result[Corner_table::next(o)] == null_index;
        o = opposite[Corner_table::next(o)])
      result[Corner_table::next(o)] = c;
    for(Index o = opposite[Corner_table::prev(c)]; o != null_index && result[o] == null_index;
        o = opposite[Corner_table::prev(o)])
      result[o] = c;
  }
  return result;
}

} // namespace

Split_mesh split_vertices(std::size_t number_of_vertices, const Triangles& triangles, Mesh_findings& findings)
{
  tell_of_turned_faces(triangles, findings);

  Split_mesh result;
  std::vector<Index>& vertex = result.vertex;
  for(Index v = 0; v < number_of_vertices; ++v)
    vertex.push_back(v);
  std::vector<bool> is_used(number_of_vertices, false);
  const std::vector<Index> fan_of = fans(triangles.opposite);
  std::vector<Index> vertex_of_fan(fan_of.size(), null_index);
  for(Index h = 0; h < fan_of.size(); ++h)
  {
    Index& name = vertex_of_fan[fan_of[h]];
    const Index v = triangles.corners[h];
    if(name == null_index && !is_used[v])
    {
      is_used[v] = true;
      name = v;
    }
    else if(name == null_index)
    {
      name = static_cast<Index>(vertex.size());
      vertex.push_back(v);
      findings.add(Finding::SPLIT_VERTICES, [v] {
        return "non-manifold vertex: the faces around vertex " + std::to_string(v) + " form more than one fan";
      });
    }
    result.table.halfedges.push_back({name, triangles.opposite[h]});
  }
  if(vertex.size() > number_of_vertices) // edges of one vertex pair differ in a copy
    tell_of_edges(number_of_vertices, triangles, findings);
  result.table.outgoing.assign(vertex.size(), null_index);
  for(Index h = 0; h < fan_of.size(); ++h)
    result.table.outgoing[result.table.halfedges[h].source] = h;
  return result;
}

} // namespace constrictions
