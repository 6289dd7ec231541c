// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/find_border.h"

#include "input/point_grid.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace constrictions {

namespace {

// Of the length of a border edge. Below the first vertices lie on an edge, below the second on one another.
const double on_edge = 1e-6, very_near = 1e-3;

struct Border
{
  std::vector<Mesh::Halfedge_index> edges;
  std::vector<Mesh::Vertex_index> vertices; // one at the end of each edge
};

Border holes_of(const Mesh& mesh, const File_numbering& numbering, Mesh_findings& findings)
{
  Border border;
  std::vector<bool> is_seen(mesh.num_halfedges(), false);
  for(Mesh::Halfedge_index first : mesh.halfedges())
  {
    if(!mesh.is_border(first) || is_seen[first])
      continue;
    std::size_t edges = 0;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(first))
    {
      is_seen[h] = true;
      ++edges;
      border.edges.push_back(h);
      border.vertices.push_back(mesh.target(h));
      findings.add(Finding::BORDER_EDGES, [&] {
        const Mesh::Face_index f = mesh.face(mesh.opposite(h));
        return "the edge between vertices " + std::to_string(numbering.vertex_of(mesh.source(h))) + " and " +
               std::to_string(numbering.vertex_of(mesh.target(h))) + " of face " +
               std::to_string(numbering.face_of(f)) + " has no face on its other side";
      });
    }
    findings.add(Finding::HOLES, [&] {
      return "a hole of " + std::to_string(edges) + " edges at vertex " +
             std::to_string(numbering.vertex_of(mesh.target(first)));
    });
  }
  return border;
}

void find_t_vertices(const Mesh& mesh, const Border& border, const File_numbering& numbering, Mesh_findings& findings)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
  std::vector<Box> edges, vertices;
  for(std::size_t i = 0; i < border.edges.size(); ++i)
  {
    const Point &p = mesh.point(mesh.source(border.edges[i])), &q = mesh.point(mesh.target(border.edges[i]));
    const double margin = on_edge * std::sqrt(CGAL::squared_distance(p, q));
    const CGAL::Bbox_3 box = p.bbox() + q.bbox();
    edges.emplace_back(CGAL::Bbox_3(box.xmin() - margin, box.ymin() - margin, box.zmin() - margin, box.xmax() + margin,
                                    box.ymax() + margin, box.zmax() + margin),
                       i);
    vertices.emplace_back(mesh.point(border.vertices[i]).bbox(), i);
  }
  std::vector<std::size_t> edge_of(border.vertices.size(), border.edges.size()); // the one that the vertex is on
  CGAL::box_intersection_d(edges.begin(), edges.end(), vertices.begin(), vertices.end(),
                           [&](const Box& e, const Box& v) {
                             const Mesh::Halfedge_index h = border.edges[e.info()];
                             const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                                         &x = mesh.point(border.vertices[v.info()]);
                             const double length = CGAL::squared_distance(p, q);
                             const double along = (x - p) * (q - p) / length;
                             if(along <= very_near || along >= 1 - very_near ||
                                CGAL::squared_distance(p + along * (q - p), x) > on_edge * on_edge * length)
                               return;
                             edge_of[v.info()] = (std::min)(edge_of[v.info()], e.info());
                           });
  for(std::size_t i = 0; i < edge_of.size(); ++i)
    if(edge_of[i] != border.edges.size())
      findings.add(Finding::T_VERTICES, [&] {
        const Mesh::Halfedge_index h = border.edges[edge_of[i]];
        return "vertex " + std::to_string(numbering.vertex_of(border.vertices[i])) +
               " lies on the edge between vertices " + std::to_string(numbering.vertex_of(mesh.source(h))) + " and " +
               std::to_string(numbering.vertex_of(mesh.target(h)));
      });
}

void find_near_vertices(const Mesh& mesh, const Border& border, const File_numbering& numbering,
                        Mesh_findings& findings)
{
  std::vector<double> lengths;
  for(Mesh::Halfedge_index h : border.edges)
    lengths.push_back(std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  const double distance = very_near * *median;
  if(!(distance > 0))
    return;

  Point_grid grid(distance);
  for(std::size_t i = 0; i < border.vertices.size(); ++i)
    grid.add(mesh.point(border.vertices[i]), static_cast<Index>(i));
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for(Mesh::Vertex_index v : border.vertices)
  {
    double nearest = std::numeric_limits<double>::infinity();
    Index other = 0;
    grid.for_each_near(mesh.point(v), [&](Index j) {
      const double d = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(border.vertices[j])));
      // copies of a vertex that has been split are in one place
      if(!(d > 0 && d <= distance) || mesh.halfedge(v, border.vertices[j]) != Mesh::null_halfedge())
        return;
      greatest = (std::max)(greatest, d);
      if(d < nearest)
      {
        nearest = d;
        other = j;
      }
    });
    if(nearest > distance)
      continue;
    least = (std::min)(least, nearest);
    findings.add(Finding::NEAR_VERTICES, [&] {
      return "vertex " + std::to_string(numbering.vertex_of(v)) + " lies very near to vertex " +
             std::to_string(numbering.vertex_of(border.vertices[other]));
    });
  }
  if(findings.count(Finding::NEAR_VERTICES) == 0)
    return;
  findings.nearest = least;
  findings.farthest = greatest;
  findings.merging_distance = merging_distance_for(greatest);
}

} // namespace

// With room for clusters of which only a part has been seen.
double merging_distance_for(double distance)
{
  const double unit = std::pow(10, std::floor(std::log10(distance)));
  return std::ceil(1.5 * distance / unit) * unit;
}

void find_border(const Mesh& mesh, const File_numbering& numbering, Mesh_findings& findings)
{
  const Border border = holes_of(mesh, numbering, findings);
  if(border.edges.empty())
    return;
  find_t_vertices(mesh, border, numbering, findings);
  find_near_vertices(mesh, border, numbering, findings);
}

} // namespace constrictions
