// SPDX-License-Identifier: GPL-3.0-or-later

// Find the constrictions of a mesh and print the points of the first one.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(constrictions));

  for(const Constriction& c : constrictions)
    std::cout << "length " << c.length() << ", " << c.pivots().size() << " pivots, "
              << (c.is_separating() ? "separating" : "not separating") << std::endl;

  if(!constrictions.empty())
  {
    std::vector<Point_3> points;
    constrictions.front().points(mesh, std::back_inserter(points));
    for(const Point_3& p : points)
      std::cout << p << std::endl;
  }
  return EXIT_SUCCESS;
}
