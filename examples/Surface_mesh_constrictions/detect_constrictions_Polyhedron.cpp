// SPDX-License-Identifier: GPL-3.0-or-later

// The same call on another face graph: a Polyhedron_3.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef CGAL::Surface_mesh_constrictions::Constriction<Polyhedron> Constriction;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Polyhedron polyhedron;
  if(!CGAL::IO::read_polygon_mesh(filename, polyhedron))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(polyhedron, std::back_inserter(constrictions));

  for(const Constriction& c : constrictions)
    for(const Constriction::Pivot& pivot : c.pivots())
      std::cout << "passes through " << pivot.vertex->point() << std::endl;
  return EXIT_SUCCESS;
}
