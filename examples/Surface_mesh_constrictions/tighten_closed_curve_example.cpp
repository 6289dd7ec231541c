// SPDX-License-Identifier: GPL-3.0-or-later

// Tighten a loop of the user's, a closed path of edges given by its vertices, to a constriction.

#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// usage: tighten_closed_curve_example [mesh vertex vertex vertex...]
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
  for(int i = 2; i < argc; ++i)
    loop.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(std::atol(argv[i]))));
  if(argc < 2) // around the right arm of the cactus
    for(Mesh::size_type v : {180, 527, 209, 212, 226, 227, 538, 521, 201})
      loop.push_back(Mesh::Vertex_index(v));

  const SMC::Tightened_curve<Mesh> result = SMC::tighten_closed_curve(mesh, loop);
  switch(result.verdict)
  {
  case SMC::Tightening_verdict::CLOSED_GEODESIC:
    std::cout << "a constriction of length " << result.curve.length() << ", " << result.curve.certificate()
              << std::endl;
    break;
  case SMC::Tightening_verdict::DEGENERATE:
    std::cout << "the loop shrinks to a point" << std::endl;
    break;
  case SMC::Tightening_verdict::NOT_SIMPLE:
    std::cout << "the loop ends in a curve that crosses or touches itself" << std::endl;
    break;
  case SMC::Tightening_verdict::NOT_CERTIFIED:
    std::cout << "the loop ends in a curve that could not be proved to be a constriction" << std::endl;
    break;
  }
  return EXIT_SUCCESS;
}
