// SPDX-License-Identifier: GPL-3.0-or-later

// Find the constrictions of a mesh and show them in CGAL's viewer.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/draw_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<CGAL::Surface_mesh_constrictions::Constriction<Mesh>> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(constrictions));
  CGAL::draw(mesh, constrictions);
  return EXIT_SUCCESS;
}
