// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/repair_fixture.h"

#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Whatever faces a file has: a mesh that the library takes becomes of it, or it is refused with a reason.
namespace test_random_soups {

using namespace repair_fixture;

// The edges of a mesh, by the vertices of the file: the directions in which its faces run along each, and how many of
// the sides are at the border.
struct File_edge
{
  std::size_t forth = 0, back = 0, border = 0;
};

typedef std::map<std::pair<std::size_t, std::size_t>, File_edge> File_edges;

File_edges file_edges(const Mesh& mesh, const constrictions::File_numbering& numbering)
{
  File_edges result;
  for(Mesh::Halfedge_index h : mesh.halfedges())
  {
    if(mesh.is_border(h))
      continue;
    const std::size_t u = numbering.vertex_of(mesh.source(h)), v = numbering.vertex_of(mesh.target(h));
    File_edge& edge = result[{(std::min)(u, v), (std::max)(u, v)}];
    ++(u < v ? edge.forth : edge.back);
    edge.border += mesh.is_border(mesh.opposite(h));
  }
  return result;
}

class Random_soups : public Repair
{
protected:
  struct Tally
  {
    int answered = 0, refused = 0;
    std::size_t cut_edges = 0;
  };

  // A soup is made a mesh that the library takes, unless it cannot be oriented or nothing is left of it, and what was
  // left out, added and cut adds up.
  void expect_answered(const std::vector<Position>& points, const Faces& faces, Tally& tally)
  {
    try
    {
      const Mesh mesh = repaired(off_of(points, faces));
      ++tally.answered;
      EXPECT_TRUE(mesh.is_valid(false));
      EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
      EXPECT_NO_THROW(CGAL::Surface_mesh_constrictions::internal::Imported_mesh<Mesh>(mesh, mesh.points(),
                                                                                      get(boost::vertex_index, mesh)));
      std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
      for(Mesh::Edge_index e : mesh.edges())
      {
        const std::uint32_t u = mesh.vertex(e, 0).idx(), v = mesh.vertex(e, 1).idx();
        EXPECT_TRUE(edges.emplace((std::min)(u, v), (std::max)(u, v)).second) << "two edges with the same ends";
        EXPECT_NE(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
      }
      // triangles: of each face that was not left out those of a polygon with its corners
      std::vector<std::size_t> pieces(faces.size(), 0);
      for(Mesh::Face_index f : mesh.faces())
        ++pieces[record.numbering.face_of(f)];
      std::size_t left_out = 0;
      for(std::size_t f = 0; f < faces.size(); ++f)
      {
        left_out += pieces[f] == 0;
        EXPECT_LE(pieces[f], faces[f].size() - 2);
      }
      EXPECT_GE(count(Finding::DUPLICATE_FACES) + count(Finding::DEGENERATE_FACES), left_out);
      // vertices: those of the file, but for those without a face, and the copies
      EXPECT_EQ(mesh.num_vertices(), points.size() + count(Finding::SPLIT_VERTICES));
      for(Mesh::Vertex_index v : mesh.vertices())
      {
        const Position& p = points[record.numbering.vertex_of(v)];
        EXPECT_EQ(mesh.point(v), constrictions::Point(p[0], p[1], p[2])) << "a vertex has moved";
      }
      std::size_t border = 0;
      for(Mesh::Halfedge_index h : mesh.halfedges())
        border += mesh.is_border(h);
      EXPECT_EQ(count(Finding::BORDER_EDGES), border);
      // edges: those that were crowded, and those of which two faces have been parted
      std::size_t split_edges = 0, cut_edges = 0;
      for(const auto& [ends, edge] : file_edges(mesh, record.numbering))
      {
        split_edges += edge.forth + edge.back > 2 || edge.forth == 2 || edge.back == 2;
        cut_edges += edge.forth == 1 && edge.back == 1 && edge.border > 0;
      }
      EXPECT_EQ(count(Finding::SPLIT_EDGES), split_edges);
      EXPECT_EQ(count(Finding::CUT_EDGES), cut_edges);
      tally.cut_edges += cut_edges;
      expect_at_rest(mesh);
    }
    catch(const Invalid_input& e)
    {
      ++tally.refused;
      expect_message(e.what(), {});
      EXPECT_TRUE(e.defect() == Input_defect::INCONSISTENT_ORIENTATION || e.defect() == Input_defect::EMPTY_MESH)
          << e.what();
    }
  }
};

// Closed bodies to which something has been done.
TEST_F(Random_soups, of_closed_bodies)
{
  const int soups = 1500;
  std::mt19937 random(24);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  Tally tally;
  for(int s = 0; s < soups; ++s)
  {
    SCOPED_TRACE(s);
    std::vector<Position> points;
    Faces faces;
    const int bodies = 1 + static_cast<int>(below(3));
    for(int b = 0; b < bodies; ++b)
    {
      const Position place = {
          {static_cast<double>(below(3)), static_cast<double>(below(3)), static_cast<double>(below(2))}};
      if(s % 3 != 0)
        add_cube(place[0], place[1], place[2], points, faces);
      else
        add_octahedron(place, points, faces);
    }
    if(below(2) == 0)
      for(std::vector<int>& f : faces)
        f.resize(3); // triangles and holes
    if(below(2) == 0)
      merge_positions(points, faces);
    for(std::size_t deeds = below(6); deeds > 0; --deeds)
    {
      const std::size_t f = below(faces.size());
      switch(below(5))
      {
      case 0:
        faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(f));
        break;
      case 1:
        faces.push_back(faces[f]);
        break;
      case 2:
        std::reverse(faces[f].begin(), faces[f].end());
        break;
      case 3: // merge two vertices
      {
        const int v = static_cast<int>(below(points.size())), w = static_cast<int>(below(points.size()));
        for(std::vector<int>& g : faces)
          std::replace(g.begin(), g.end(), v, w);
      }
      break;
      default: // glue two edges
      {
        const std::vector<int> g = faces[below(faces.size())], h = faces[below(faces.size())];
        for(int i : {0, 1})
          for(std::vector<int>& k : faces)
            std::replace(k.begin(), k.end(), g[static_cast<std::size_t>(i)], h[static_cast<std::size_t>(1 - i)]);
      }
      }
      if(faces.empty())
        break;
    }
    if(faces.empty())
      continue;
    expect_answered(points, faces, tally);
  }
  EXPECT_GT(tally.answered, soups * 95 / 100);
  EXPECT_GT(tally.refused, 0); // the soups are such that both happen
}

// Triangles on a few vertices: most edges have many of them, and sometimes no pairs help.
TEST_F(Random_soups, of_triangles)
{
  std::mt19937 random(25);
  Tally tally;
  for(int s = 0; s < 500; ++s)
  {
    SCOPED_TRACE(s);
    const int vertices = 6 + s % 4;
    std::vector<Position> points;
    for(int v = 0; v < vertices; ++v)
    {
      points.push_back({});
      for(double& x : points.back())
        x = static_cast<double>(random() % 1000) + 1000. * v;
    }
    Faces faces;
    while(faces.size() < static_cast<std::size_t>(vertices * (vertices - 2)))
    {
      std::set<int> corners;
      while(corners.size() < 3)
        corners.insert(static_cast<int>(random() % 1000) % vertices);
      faces.emplace_back(corners.begin(), corners.end());
      if(random() % 2 == 0)
        std::swap(faces.back()[0], faces.back()[1]);
    }
    expect_answered(points, faces, tally);
  }
  EXPECT_GT(tally.answered, 450);
  EXPECT_GT(tally.cut_edges, 0u);
}

} // namespace test_random_soups
