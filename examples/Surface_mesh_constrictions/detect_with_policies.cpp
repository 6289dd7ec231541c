// SPDX-License-Identifier: GPL-3.0-or-later

// Another simplification finds other seed curves: Lindstrom-Turk instead of Garland-Heckbert.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;

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
  SMC::detect_constrictions(mesh, std::back_inserter(constrictions),
                            CGAL::parameters::get_cost(SMS::LindstromTurk_cost<SMC::Simplification_mesh>())
                                .get_placement(SMS::LindstromTurk_placement<SMC::Simplification_mesh>()));

  for(const SMC::Constriction<Mesh>& c : constrictions)
    std::cout << "length " << c.length() << ", prominence " << c.prominence() << std::endl;
  return EXIT_SUCCESS;
}
