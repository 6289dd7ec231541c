// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/repair_soup.h"

#include "input/clean_faces.h"
#include "input/connect_triangles.h"
#include "input/disjoint_sets.h"
#include "input/split_vertices.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/triangulate_polygon.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
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
      at_vertex[triangles.corners[3 * std::size_t(t) + i]] = t;
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

// What a soup is made.
struct Attempt
{
  Clean_faces faces;
  Triangles triangles;
  Mesh_findings findings; // but for what `split_vertices()` tells
  bool closes_seams = true;

  std::size_t border_edges() const
  {
    return static_cast<std::size_t>(std::count(triangles.opposite.begin(), triangles.opposite.end(), null_index));
  }
};

// What was found before it throws is in `found`.
Attempt attempt(const Polygon_soup& soup, double merging_distance, bool closes_seams, Mesh_findings& found)
{
  Attempt result;
  result.closes_seams = closes_seams;
  tell_of_isolated_vertices(soup, result.findings);
  result.faces = clean_faces(soup, merging_distance, closes_seams, result.findings);
  result.triangles = triangulate(soup.points, result.faces, soup, result.findings);
  try
  {
    connect_triangles(soup.points, result.triangles, result.findings);
  }
  catch(const SMC::Invalid_input&)
  {
    found = result.findings;
    throw;
  }
  return result;
}

// Throws if triangles joined wherever two of them meet in space, and no more, cannot be oriented.
void refuse_one_sided(const std::vector<Point>& points, Triangles triangles)
{
  std::map<Point, Index> vertex_at;
  for(Index& v : triangles.corners)
    v = vertex_at.emplace(points[v], v).first->second;
  Mesh_findings findings;
  connect_triangles(points, triangles, findings);
}

// As `attempt()` with seams closed; nothing if that cannot be oriented, but what is written can.
std::optional<Attempt> attempt_with_seams(const Polygon_soup& soup, double merging_distance, Mesh_findings& found)
{
  try
  {
    return attempt(soup, merging_distance, true, found);
  }
  catch(const SMC::Invalid_input& e)
  {
    if(e.defect() != SMC::Input_defect::INCONSISTENT_ORIENTATION)
      throw;
  }
  refuse_one_sided(soup.points, attempt(soup, merging_distance, false, found).triangles);
  return std::nullopt;
}

// Seams are closed if that leaves less border in the end.
Attempt best_attempt(const Polygon_soup& soup, double merging_distance, Mesh_findings& found)
{
  std::optional<Attempt> closed = attempt_with_seams(soup, merging_distance, found);
  if(closed && closed->border_edges() < closed->faces.border_edges)
    return std::move(*closed);
  if(closed && closed->findings.count(Finding::MERGED_VERTICES) == 0)
    return std::move(*closed);
  Attempt open = attempt(soup, merging_distance, false, found);
  return closed && closed->border_edges() < open.border_edges() ? std::move(*closed) : std::move(open);
}

Polygon_soup soup_of(const std::vector<Point>& points, const Split_mesh& mesh)
{
  Polygon_soup result;
  for(Index v : mesh.vertex)
    result.points.push_back(points[v]);
  for(std::size_t h = 0; h < mesh.table.halfedges.size(); ++h)
  {
    result.corners.push_back(mesh.table.halfedges[h].source);
    if(h % 3 == 2)
      result.end_face();
  }
  return result;
}

// A repair of the mesh that another one has made, told in the numbers of the file.
Attempt composed(Attempt first, const Split_mesh& mesh, const Attempt& second)
{
  Disjoint_sets same(first.faces.stand_in.size());
  for(Index v = 0; v < first.faces.stand_in.size(); ++v)
    same.unite(v, first.faces.stand_in[v]);
  for(Index v = 0; v < mesh.vertex.size(); ++v)
  {
    const Index u = mesh.vertex[second.faces.stand_in[v]], w = mesh.vertex[v];
    if(same.unite(u, w))
      first.findings.add(Finding::MERGED_VERTICES,
                         [&] { return "vertex " + std::to_string(w) + " is merged into vertex " + std::to_string(u); });
  }
  for(Index v = 0; v < first.faces.stand_in.size(); ++v)
    first.faces.stand_in[v] = same.find(v);

  Triangles triangles;
  std::vector<bool> is_left(first.triangles.size(), false);
  for(std::size_t t = 0; t < second.triangles.size(); ++t)
  {
    const Index of_first = second.triangles.face[t];
    is_left[of_first] = true;
    triangles.face.push_back(first.triangles.face[of_first]);
    triangles.is_turned.push_back(first.triangles.is_turned[of_first] != second.triangles.is_turned[t]);
    for(std::size_t i = 0; i < 3; ++i)
      triangles.corners.push_back(same.find(mesh.vertex[second.triangles.corners[3 * t + i]]));
  }
  triangles.opposite = second.triangles.opposite;
  for(std::size_t t = 0; t < is_left.size(); ++t)
    if(!is_left[t])
      first.findings.add(Finding::DUPLICATE_FACES, [&] {
        return "duplicate face: face " + std::to_string(first.triangles.face[t]) + " lies on another one";
      });
  first.triangles = std::move(triangles);
  return first;
}

} // namespace

Repaired_soup repair_soup(const Polygon_soup& soup, double merging_distance, Mesh_findings& findings)
{
  SMC::internal::check_points(SMC::internal::Corner_table(), soup.points);
  Attempt best = best_attempt(soup, merging_distance, findings);
  Split_mesh mesh;
  while(true)
  {
    findings = best.findings;
    mesh = split_vertices(soup.points.size(), best.triangles, findings);
    if(best.closes_seams && mesh.vertex.size() == soup.points.size())
      break;
    // the mesh must be the same when it is written and read again, so seams are closed as they would be then
    Mesh_findings found;
    const std::optional<Attempt> next = attempt_with_seams(soup_of(soup.points, mesh), 0, found);
    if(!next || next->border_edges() >= best.border_edges())
      break;
    best = composed(std::move(best), mesh, *next);
  }
  if(best.triangles.size() == 0)
    throw SMC::Invalid_input(SMC::Input_defect::EMPTY_MESH, 0,
                             "empty mesh: no face is left of " + std::to_string(soup.number_of_faces()) + ": " +
                                 as_words(Finding::DEGENERATE_FACES, findings.count(Finding::DEGENERATE_FACES)) + ", " +
                                 as_words(Finding::DUPLICATE_FACES, findings.count(Finding::DUPLICATE_FACES)));

  Repaired_soup result;
  for(Index v : mesh.vertex)
    result.points.push_back(soup.points[v]);
  File_numbering& numbering = result.numbering;
  numbering.vertices = soup.points.size();
  numbering.faces = soup.number_of_faces();
  set_nearby(soup, best.faces, best.triangles, numbering);
  numbering.face = best.triangles.face;
  numbering.vertex = std::move(mesh.vertex);
  numbering.stand_in = best.faces.stand_in;
  numbering.is_turned = best.triangles.is_turned;
  for(Index f : best.triangles.face)
    numbering.is_piece.push_back(soup.degree(f) != 3);
  result.table = std::move(mesh.table);
  return result;
}

} // namespace constrictions
