// SPDX-License-Identifier: GPL-3.0-or-later

// Find all closed geodesics once, print which one slides to which, and select among them with different thresholds.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef SMC::Constriction<Mesh> Constriction;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Constriction> all;
  SMC::detect_constrictions(mesh, std::back_inserter(all), SMC::parameters::all_constrictions(true));
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    std::cout << i << ": length " << all[i].length() << ", prominence " << all[i].prominence();
    if(all[i].dominated_by())
      std::cout << ", slides to " << *all[i].dominated_by();
    std::cout << std::endl;
  }

  for(double threshold : {0.02, 0.05, 0.1, 0.5})
  {
    std::vector<Constriction> selected;
    SMC::select_by_prominence(all, std::back_inserter(selected), SMC::parameters::minimum_prominence(threshold));
    std::cout << selected.size() << " constrictions of prominence " << threshold << " or more" << std::endl;
  }
  return EXIT_SUCCESS;
}
