// SPDX-License-Identifier: GPL-3.0-or-later

// Find the constrictions of a mesh of polygons, and tell which of its polygons they pass through.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/triangulate_with_face_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef SMC::Constriction<Mesh> Constriction;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cross_quad.off");
  Mesh polygons;
  if(!CGAL::IO::read_polygon_mesh(filename, polygons))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Mesh triangles;
  const auto polygon_of_triangle = triangles.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:polygon").first;
  SMC::triangulate_with_face_map(polygons, triangles, polygon_of_triangle);
  std::cout << polygons.number_of_faces() << " polygons, " << triangles.number_of_faces() << " triangles" << std::endl;

  std::vector<Constriction> constrictions;
  SMC::detect_constrictions(triangles, std::back_inserter(constrictions));

  for(const Constriction& c : constrictions)
  {
    std::vector<Constriction::Face_location> locations;
    c.face_locations(triangles, std::back_inserter(locations));
    std::set<Mesh::Face_index> passed;
    for(const Constriction::Face_location& l : locations)
      passed.insert(polygon_of_triangle[l.first]);
    std::cout << "length " << c.length() << ", in the polygons";
    for(Mesh::Face_index f : passed)
      std::cout << ' ' << std::size_t(f);
    std::cout << std::endl;
  }
  return EXIT_SUCCESS;
}
