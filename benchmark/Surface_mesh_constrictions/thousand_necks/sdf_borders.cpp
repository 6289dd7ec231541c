// SPDX-License-Identifier: GPL-3.0-or-later

// Borders between the segments of CGAL's segmentation by the shape diameter function, with default parameters, as
// closed polylines. A border that ends in the boundary of the mesh is left out. Where three segments meet, the border
// of each is one curve.
//
//   sdf_borders MESH OUT.polylines.txt

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <vector>

namespace {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Segment_map;

class Border_walk
{
public:
  Border_walk(const Mesh& mesh, const Segment_map& segments) : m_mesh(mesh), m_segments(segments) {}

  // a halfedge whose face is in another segment than the face beyond, or has none beyond
  bool is_border(Mesh::Halfedge_index h) const
  {
    const Mesh::Halfedge_index opposite = m_mesh.opposite(h);
    return !m_mesh.is_border(h) &&
           (m_mesh.is_border(opposite) || m_segments[m_mesh.face(h)] != m_segments[m_mesh.face(opposite)]);
  }

  // the next one along the border of the same segment, around the target
  Mesh::Halfedge_index next(Mesh::Halfedge_index h) const
  {
    Mesh::Halfedge_index following = m_mesh.next(h);
    while(!is_border(following))
      following = m_mesh.next(m_mesh.opposite(following));
    return following;
  }

private:
  const Mesh& m_mesh;
  const Segment_map& m_segments;
};

} // namespace

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: sdf_borders MESH OUT.polylines.txt" << std::endl;
    return EXIT_FAILURE;
  }
  const auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf", 0).first;
  const Segment_map segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 0).first;
  CGAL::sdf_values(mesh, sdf);
  CGAL::segmentation_from_sdf_values(mesh, sdf, segments);

  const Border_walk walk(mesh, segments);
  std::ofstream out(argv[2]);
  out.precision(17);
  std::vector<bool> is_done(mesh.number_of_halfedges(), false);
  std::set<std::vector<Mesh::Edge_index>> written; // a border of two segments is walked along twice
  for(Mesh::Halfedge_index first : mesh.halfedges())
  {
    if(is_done[first] || !walk.is_border(first))
      continue;
    std::vector<Mesh::Halfedge_index> cycle;
    bool is_closed = true;
    Mesh::Halfedge_index h = first;
    do
    {
      is_done[h] = true;
      cycle.push_back(h);
      is_closed = is_closed && !mesh.is_border(mesh.opposite(h));
      h = walk.next(h);
    } while(h != first);
    std::vector<Mesh::Edge_index> edges;
    for(Mesh::Halfedge_index c : cycle)
      edges.push_back(mesh.edge(c));
    std::sort(edges.begin(), edges.end());
    if(!is_closed || !written.insert(edges).second)
      continue;
    out << cycle.size() + 1;
    for(Mesh::Halfedge_index c : cycle)
      out << ' ' << mesh.point(mesh.source(c));
    out << ' ' << mesh.point(mesh.source(first)) << '\n';
  }
  out.close();
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
