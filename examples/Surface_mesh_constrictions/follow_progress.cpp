// SPDX-License-Identifier: GPL-3.0-or-later

// Follow a detection with a visitor.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

struct Progress
  : public SMC::Detection_visitor_base
{
  void on_stage_begin(SMC::Detection_stage stage, std::size_t steps) const
  {
    const char* const names[] = {"simplification", "refinement", "tightening"};
    std::cout << names[static_cast<int>(stage)] << ", at most " << steps << " steps" << std::endl;
  }

  void on_end(const SMC::Detection_statistics& s) const
  {
    std::cout << s.seeds << " seeds: " << s.degenerate << " shortened to a point, " << s.merged
              << " led to a curve that another one had found" << std::endl;
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<SMC::Constriction<Mesh> > constrictions;
  SMC::detect_constrictions(mesh, std::back_inserter(constrictions), CGAL::parameters::visitor(Progress()));
  return EXIT_SUCCESS;
}
