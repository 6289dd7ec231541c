// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REPAIR_FIXTURE_H
#define REPAIR_FIXTURE_H

#include "include/mesh_texts.h"

#include "output/mesh_as_text.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Files whose faces are no closed triangle mesh, and what is read of them.
namespace repair_fixture {

using namespace mesh_texts;
using constrictions::File_record;
using constrictions::Finding;
using constrictions::Reading;

typedef std::vector<std::vector<int>> Faces;

inline std::string off_of(const std::vector<Position>& points, const Faces& faces)
{
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << points.size() << ' ' << faces.size() << " 0\n";
  for(const Position& p : points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const std::vector<int>& f : faces)
  {
    out << f.size();
    for(int v : f)
      out << ' ' << v;
    out << '\n';
  }
  return out.str();
}

// A unit cube at a place, with squares; vertex x + 2 y + 4 z.
inline void add_cube(double x, double y, double z, std::vector<Position>& points, Faces& faces)
{
  const int n = static_cast<int>(points.size());
  for(int v = 0; v < 8; ++v)
    points.push_back({{x + v % 2, y + v / 2 % 2, z + v / 4}});
  for(const std::vector<int>& f :
      Faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
  {
    faces.push_back(f);
    for(int& v : faces.back())
      v += n;
  }
}

inline void add_octahedron(const Position& place, std::vector<Position>& points, Faces& faces)
{
  const int n = static_cast<int>(points.size());
  const Soup soup = octahedron();
  for(const Position& p : soup.points)
    points.push_back({{place[0] + p[0], place[1] + p[1], place[2] + p[2]}});
  for(const Triangle& t : soup.triangles)
    faces.push_back({n + static_cast<int>(t[0]), n + static_cast<int>(t[1]), n + static_cast<int>(t[2])});
}

// One vertex for all at one position.
inline void merge_positions(std::vector<Position>& points, Faces& faces)
{
  std::vector<Position> merged;
  std::vector<int> number;
  for(const Position& p : points)
  {
    const auto place = std::find(merged.begin(), merged.end(), p);
    number.push_back(static_cast<int>(place - merged.begin()));
    if(place == merged.end())
      merged.push_back(p);
  }
  for(std::vector<int>& f : faces)
    for(int& v : f)
      v = number[static_cast<std::size_t>(v)];
  points = merged;
}

// Vertices of its own for each face.
inline void write_apart(std::vector<Position>& points, Faces& faces)
{
  std::vector<Position> apart;
  for(std::vector<int>& f : faces)
    for(int& v : f)
    {
      apart.push_back(points[static_cast<std::size_t>(v)]);
      v = static_cast<int>(apart.size()) - 1;
    }
  points = apart;
}

class Repair : public Mesh_file
{
protected:
  Mesh repaired(const std::string& content, const Reading& reading = Reading())
  {
    record = File_record();
    return constrictions::read_mesh_file(file("a.off", content), reading, record);
  }

  std::size_t count(Finding finding) const { return record.findings.count(finding); }

  static std::size_t components(const Mesh& mesh)
  {
    std::vector<std::size_t> component(mesh.num_faces());
    return CGAL::Polygon_mesh_processing::connected_components(mesh, CGAL::make_property_map(component));
  }

  static std::vector<Mesh::Vertex_index> vertices_of(const Mesh& mesh, Mesh::Face_index f)
  {
    std::vector<Mesh::Vertex_index> result;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result.push_back(mesh.source(h));
    return result;
  }

  // Written and read again, a mesh is the same, and nothing is repaired.
  void expect_at_rest(const Mesh& mesh) const
  {
    for(const char* name : {"again.off", "again.obj", "again.ply"})
    {
      SCOPED_TRACE(name);
      File_record again;
      const Mesh read =
          constrictions::read_mesh_file(file(name, constrictions::mesh_as_text(mesh, name)), Reading(), again);
      EXPECT_FALSE(again.findings.has_repairs()) << constrictions::summary_of(again.findings);
      for(Finding finding : {Finding::HOLES, Finding::BORDER_EDGES, Finding::T_VERTICES})
        EXPECT_EQ(again.findings.count(finding), count(finding));
      ASSERT_EQ(read.num_vertices(), mesh.num_vertices());
      ASSERT_EQ(read.num_faces(), mesh.num_faces());
      EXPECT_EQ(components(read), components(mesh));
      EXPECT_EQ(read.number_of_vertices(), mesh.number_of_vertices());
      EXPECT_EQ(read.number_of_edges(), mesh.number_of_edges());
      for(Mesh::Face_index f : mesh.faces())
        EXPECT_EQ(vertices_of(read, f), vertices_of(mesh, f));
      for(Mesh::Vertex_index v : mesh.vertices())
        EXPECT_EQ(read.point(v), mesh.point(v));
    }
  }

  // The vertices of the file that the triangle has, in its order.
  std::vector<std::size_t> corners(const Mesh& mesh, Mesh::Face_index f) const
  {
    std::vector<std::size_t> result;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result.push_back(record.numbering.vertex_of(mesh.source(h)));
    return result;
  }

  File_record record;
};

} // namespace repair_fixture

#endif // REPAIR_FIXTURE_H
