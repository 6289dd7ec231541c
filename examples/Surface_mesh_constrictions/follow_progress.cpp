// SPDX-License-Identifier: GPL-3.0-or-later

// Follow a detection with a visitor, and cancel it by an exception when it takes longer than a given time.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <chrono>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

struct Progress : public SMC::Detection_visitor_base
{
  std::chrono::steady_clock::time_point deadline;

  void on_stage_begin(SMC::Detection_stage stage, std::size_t steps) const
  {
    const char* const names[] = {"simplification", "seeds", "refinement", "tightening", "certification", "selection"};
    std::cout << names[static_cast<int>(stage)] << ": at most " << steps << " steps" << std::endl;
  }
  void on_step(SMC::Detection_stage, std::size_t) const
  {
    if(std::chrono::steady_clock::now() > deadline)
      throw std::runtime_error("cancelled");
  }
  void on_end(const SMC::Detection_statistics& s) const { std::cout << s.seeds << " seeds" << std::endl; }
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

  for(int seconds : {600, 0})
    try
    {
      Progress progress;
      progress.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
      std::vector<SMC::Constriction<Mesh>> constrictions;
      SMC::detect_constrictions(mesh, std::back_inserter(constrictions), CGAL::parameters::visitor(progress));
      std::cout << constrictions.size() << " constrictions" << std::endl;
    }
    catch(const std::runtime_error& e)
    {
      std::cout << e.what() << " after " << seconds << " seconds" << std::endl;
    }
  return EXIT_SUCCESS;
}
