// SPDX-License-Identifier: GPL-3.0-or-later

// Parts between constrictions side by side with CGAL's segmentation by the shape diameter function, which has default
// parameters here: a row of a table for each mesh file that is named on the command line.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <iterator>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

class Stopwatch
{
public:
  // of the processor, since the last call
  double seconds()
  {
    const std::clock_t now = std::clock();
    const double result = static_cast<double>(now - m_begin) / CLOCKS_PER_SEC;
    m_begin = now;
    return result;
  }

private:
  std::clock_t m_begin = std::clock();
};

struct Row
{
  std::size_t parts;
  double boundary_length;
  double seconds;
};

Row cut_along_constrictions(Mesh& mesh, double& seconds_of_segmentation, double& seconds_of_split)
{
  const auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  std::vector<SMC::Constriction<Mesh>> constrictions;
  Stopwatch watch;
  SMC::detect_constrictions(mesh, std::back_inserter(constrictions));
  Row row = {0, 0, watch.seconds()};
  const SMC::Surface_parts parts = SMC::segment_by_constrictions(mesh, constrictions, patch);
  seconds_of_segmentation = watch.seconds();
  row.seconds += seconds_of_segmentation;
  row.parts = parts.parts.size();
  for(const SMC::Part_adjacency& a : parts.adjacencies)
    row.boundary_length += a.length;
  Mesh copy = mesh;
  watch.seconds();
  SMC::split_along_constrictions(copy, constrictions);
  seconds_of_split = watch.seconds();
  return row;
}

Row segment_by_shape_diameter(Mesh& mesh)
{
  const auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf", 0).first;
  const auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 0).first;
  Stopwatch watch;
  CGAL::sdf_values(mesh, sdf);
  Row row = {CGAL::segmentation_from_sdf_values(mesh, sdf, segment), 0, watch.seconds()};
  for(Mesh::Edge_index e : mesh.edges())
    if(segment[mesh.face(mesh.halfedge(e, 0))] != segment[mesh.face(mesh.halfedge(e, 1))])
      row.boundary_length += PMP::edge_length(mesh.halfedge(e), mesh);
  return row;
}

} // namespace

int main(int argc, char* argv[])
{
  std::cout << "| mesh | faces | constrictions: parts | length | seconds | of which segmentation | split "
            << "| shape diameter: parts | length | seconds |\n"
            << "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |" << std::endl;
  for(int i = 1; i < argc; ++i)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(argv[i], mesh))
    {
      std::cerr << "cannot read " << argv[i] << std::endl;
      return EXIT_FAILURE;
    }
    double segmentation = 0, split = 0;
    const Row a = cut_along_constrictions(mesh, segmentation, split), b = segment_by_shape_diameter(mesh);
    std::cout << "| " << argv[i] << " | " << mesh.number_of_faces() << " | " << a.parts << " | " << a.boundary_length
              << " | " << a.seconds << " | " << segmentation << " | " << split << " | " << b.parts << " | "
              << b.boundary_length << " | " << b.seconds << " |" << std::endl;
  }
  return EXIT_SUCCESS;
}
