// SPDX-License-Identifier: GPL-3.0-or-later

// Cut a mesh along its constrictions and write each part as a closed mesh, ready for printing.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
namespace SMC = CGAL::Surface_mesh_constrictions;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<SMC::Constriction<Mesh>> constrictions;
  SMC::detect_constrictions(mesh, std::back_inserter(constrictions));

  auto is_constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  const std::size_t before = mesh.number_of_faces();
  SMC::split_along_constrictions(mesh, constrictions, CGAL::parameters::edge_is_constrained_map(is_constrained));
  std::cout << before << " faces, split into " << mesh.number_of_faces() << std::endl;

  std::vector<Mesh> parts;
  SMC::extract_parts(mesh, is_constrained, std::back_inserter(parts));
  for(std::size_t p = 0; p < parts.size(); ++p)
  {
    const std::string name = "part_" + std::to_string(p) + ".off";
    if(!CGAL::IO::write_polygon_mesh(name, parts[p], CGAL::parameters::stream_precision(17)))
      return EXIT_FAILURE;
    std::cout << name << ": volume " << CGAL::Polygon_mesh_processing::volume(parts[p]) << std::endl;
  }
  return EXIT_SUCCESS;
}
