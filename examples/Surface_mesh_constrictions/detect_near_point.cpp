// SPDX-License-Identifier: GPL-3.0-or-later

// Find the constriction around the limb that a point lies on.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
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

  // by default on an arm of the cactus
  const Kernel::Point_3 location = argc > 4
                                       ? Kernel::Point_3(std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4]))
                                       : Kernel::Point_3(0.33, 0.13, 0.02);
  std::vector<SMC::Constriction<Mesh>> nearest;
  SMC::detect_constrictions_near(mesh, location, std::back_inserter(nearest),
                                 SMC::parameters::maximum_number_of_constrictions(std::size_t(1)));
  if(nearest.empty())
    std::cout << "no constriction near " << location << std::endl;
  else
    std::cout << "length " << nearest[0].length() << ", prominence " << nearest[0].prominence() << std::endl;
  return EXIT_SUCCESS;
}
