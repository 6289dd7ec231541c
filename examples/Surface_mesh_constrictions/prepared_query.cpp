// SPDX-License-Identifier: GPL-3.0-or-later

// Prepare a mesh once, and ask it many times: the girth, and the nearest constriction, along an arm.

#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
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

  const SMC::Constriction_query<Mesh> query(mesh);
  for(double y : {0.1, 0.15, 0.2, 0.25})
  {
    const Kernel::Point_3 location(0.38, y, 0.02);
    if(const auto loop = query.girth(location))
      std::cout << "girth " << loop->length;
    std::vector<SMC::Constriction<Mesh>> nearest;
    query.constrictions_near(location, std::back_inserter(nearest),
                             SMC::parameters::maximum_number_of_constrictions(std::size_t(1)));
    std::cout << (nearest.empty() ? ", nothing narrow" : ", near a constriction of length ");
    if(!nearest.empty())
      std::cout << nearest[0].length();
    std::cout << std::endl;
  }

  std::vector<SMC::Constriction<Mesh>> all;
  query.constrictions(std::back_inserter(all));
  std::cout << all.size() << " constrictions" << std::endl;
  return EXIT_SUCCESS;
}
