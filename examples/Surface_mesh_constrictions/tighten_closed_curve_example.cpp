// SPDX-License-Identifier: GPL-3.0-or-later

// Tighten a loop of mesh vertices, here the path around two neighbouring vertices, to a closed geodesic.

#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
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

  std::vector<Mesh::Vertex_index> loop;
  for(Mesh::Vertex_index v : CGAL::vertices_around_target(mesh.halfedge(*mesh.vertices_begin()), mesh))
    loop.push_back(v);

  const SMC::Tightened_curve<Mesh> result = SMC::tighten_closed_curve(mesh, loop);
  switch(result.verdict)
  {
  case SMC::Tightening_verdict::CLOSED_GEODESIC:
    std::cout << "a closed geodesic of length " << result.curve.length() << std::endl;
    break;
  case SMC::Tightening_verdict::DEGENERATE:
    std::cout << "the loop shrinks to a point" << std::endl;
    break;
  case SMC::Tightening_verdict::NOT_SIMPLE:
    std::cout << "the loop crosses itself" << std::endl;
    break;
  case SMC::Tightening_verdict::NOT_CERTIFIED:
    std::cout << "a curve that could not be proved to be a constriction" << std::endl;
    break;
  }
  return EXIT_SUCCESS;
}
