// SPDX-License-Identifier: GPL-3.0-or-later

// Tell the parts of a surface between its constrictions, and which of them hang together. The mesh is not changed.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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

  // at necks only, not around the holes of handles
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  const SMC::Surface_parts result =
      SMC::segment_by_constrictions(mesh, constrictions, patch, SMC::parameters::choked_side(SMC::Side::OBJECT));

  for(std::size_t p = 0; p < result.parts.size(); ++p)
    std::cout << "part " << p << ": area " << result.parts[p].area << ", volume " << result.parts[p].volume
              << ", genus " << result.parts[p].genus << ", most of " << result.parts[p].number_of_faces << " faces"
              << std::endl;
  for(const SMC::Part_adjacency& a : result.adjacencies)
    std::cout << "parts " << a.parts[0] << " and " << a.parts[1] << " meet at constriction " << a.curve << " of length "
              << a.length << std::endl;
  return EXIT_SUCCESS;
}
