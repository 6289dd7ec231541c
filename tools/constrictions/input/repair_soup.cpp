// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/repair_soup.h"

#include "input/clean_faces.h"
#include "input/connect_triangles.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/triangulate_polygon.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::null_index;

std::uint64_t edge_key(Index u, Index v)
{
  return static_cast<std::uint64_t>((std::min)(u, v)) << 32 | (std::max)(u, v);
}

Triangles triangulate(const std::vector<Point>& points, const Clean_faces& faces, const Polygon_soup& soup,
                      Mesh_findings& findings)
{
  Triangles result;
  std::unordered_set<std::uint64_t> edges;
  const bool has_polygons = faces.corners.size() != 3 * faces.size();
  if(has_polygons)
  {
    edges.reserve(faces.corners.size());
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(std::size_t c = faces.begins[i]; c < faces.begins[i + 1]; ++c)
        edges.insert(edge_key(faces.corners[c], faces.corners[c + 1 == faces.begins[i + 1] ? faces.begins[i] : c + 1]));
  }
  for(std::size_t i = 0; i < faces.size(); ++i)
  {
    const Index* const corners = faces.corners.data() + faces.begins[i];
    const Index f = faces.face[i];
    if(soup.degree(f) > 3)
      findings.add(Finding::TRIANGULATED, [&] {
        return "not a triangle mesh: face " + std::to_string(f) + " has " + std::to_string(soup.degree(f)) +
               " vertices";
      });
    std::vector<Point> polygon;
    for(std::size_t c = 0; c < faces.degree(i) && faces.degree(i) > 3; ++c)
      polygon.push_back(points[corners[c]]);
    if(polygon.empty())
    {
      result.corners.insert(result.corners.end(), corners, corners + 3);
      result.face.push_back(f);
      continue;
    }
    const std::vector<SMC::internal::Polygon_triangle> triangles =
        SMC::internal::triangulate_polygon(polygon, [&](std::size_t a, std::size_t b) {
          return points[corners[a]] != points[corners[b]] && edges.count(edge_key(corners[a], corners[b])) == 0;
        });
    std::size_t pieces = 0;
    for(const SMC::internal::Polygon_triangle& t : triangles)
    {
      const std::array<Index, 3> c = {{corners[t[0]], corners[t[1]], corners[t[2]]}};
      const Point &p = points[c[0]], &q = points[c[1]], &r = points[c[2]];
      if(p == q || q == r || r == p) // where the polygon comes to one place twice
        continue;
      ++pieces;
      result.corners.insert(result.corners.end(), c.begin(), c.end());
      result.face.push_back(f);
      for(std::size_t k = 0; k < 3; ++k)
        edges.insert(edge_key(c[k], c[(k + 1) % 3]));
    }
    if(pieces == 0)
      findings.add(Finding::DEGENERATE_FACES, [f] {
        return "degenerate face: face " + std::to_string(f) + " goes to and fro between two places";
      });
  }
  return result;
}

// Of a face left out a triangle at one of its corners.
void set_nearby(const Polygon_soup& soup, const Clean_faces& faces, const Triangles& triangles,
                File_numbering& numbering)
{
  std::vector<Index>& nearby = numbering.nearby;
  nearby.assign(soup.number_of_faces(), null_index);
  std::vector<Index> at_vertex(soup.points.size(), null_index);
  for(Index t = static_cast<Index>(triangles.size()); t-- > 0;)
  {
    nearby[triangles.face[t]] = t;
    for(std::size_t i = 0; i < 3; ++i)
      at_vertex[triangles.vertex[triangles.corners[3 * std::size_t(t) + i]]] = t;
  }
  for(std::size_t f = 0; f < nearby.size(); ++f)
  {
    if(nearby[f] == null_index && faces.twin[f] != null_index)
      nearby[f] = nearby[faces.twin[f]];
    for(std::size_t c = soup.begin(f); c < soup.begin(f + 1) && nearby[f] == null_index; ++c)
      nearby[f] = at_vertex[faces.stand_in[soup.corners[c]]];
  }
}

void tell_of_isolated_vertices(const Polygon_soup& soup, Mesh_findings& findings)
{
  std::vector<bool> is_used(soup.points.size(), false);
  for(Index v : soup.corners)
    is_used[v] = true;
  for(std::size_t v = 0; v < is_used.size(); ++v)
    if(!is_used[v])
      findings.add(Finding::ISOLATED_VERTICES, [v] { return "vertex " + std::to_string(v) + " is on no face"; });
}

} // namespace

Repaired_soup repair_soup(const Polygon_soup& soup, double merging_distance, Mesh_findings& findings)
{
  SMC::internal::check_points(SMC::internal::Corner_table(), soup.points);
  tell_of_isolated_vertices(soup, findings);
  const Clean_faces faces = clean_faces(soup, merging_distance, findings);
  Triangles triangles = triangulate(soup.points, faces, soup, findings);

  Repaired_soup result;
  if(triangles.size() > 0)
    result.table = connect_triangles(soup.points, triangles, findings);
  if(triangles.size() == 0)
    throw SMC::Invalid_input(SMC::Input_defect::EMPTY_MESH, 0,
                             "empty mesh: no face is left of " + std::to_string(soup.number_of_faces()) + ": " +
                                 as_words(Finding::DEGENERATE_FACES, findings.count(Finding::DEGENERATE_FACES)) + ", " +
                                 as_words(Finding::DUPLICATE_FACES, findings.count(Finding::DUPLICATE_FACES)));
  for(Index v : triangles.vertex)
    result.points.push_back(soup.points[v]);

  File_numbering& numbering = result.numbering;
  numbering.vertices = soup.points.size();
  numbering.faces = soup.number_of_faces();
  set_nearby(soup, faces, triangles, numbering);
  numbering.face = triangles.face;
  numbering.vertex = triangles.vertex;
  numbering.stand_in = faces.stand_in;
  numbering.is_turned = triangles.is_turned;
  for(Index f : triangles.face)
    numbering.is_piece.push_back(soup.degree(f) != 3);
  return result;
}

} // namespace constrictions
