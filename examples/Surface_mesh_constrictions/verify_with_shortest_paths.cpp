// SPDX-License-Identifier: GPL-3.0-or-later

// Ask CGAL's Surface_mesh_shortest_path whether the constrictions of a mesh are closed geodesics.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

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

  std::size_t confirmed = 0;
  for(const SMC::Constriction<Mesh>& c : constrictions)
  {
    const SMC::Shortest_path_verification v = SMC::verify_with_shortest_paths(mesh, c);
    std::cout << "length " << c.length() << ": " << v.number_of_arcs << " arcs, ";
    if(v.is_confirmed())
    {
      std::cout << "all of them shortest paths" << std::endl;
      ++confirmed;
    }
    else
      std::cout << v.number_of_refused_arcs << " refused, the first at location " << v.refused_location << std::endl;
  }
  return confirmed == constrictions.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
