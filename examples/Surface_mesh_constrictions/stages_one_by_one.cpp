// SPDX-License-Identifier: GPL-3.0-or-later

// What detect_constrictions() is made of: simplify and record, rewind, find seeds, refine them.

#include <CGAL/Surface_mesh_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
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

  Mesh copy = mesh;
  SMC::Collapse_record record;
  const auto vim = get(boost::vertex_index, copy);
  SMS::edge_collapse(copy, SMS::Edge_length_stop_predicate<double>(1e300),
                     CGAL::parameters::get_cost(SMS::Edge_length_cost<Mesh>())
                         .get_placement(SMS::Midpoint_placement<Mesh>())
                         .visitor(SMC::Collapse_recording_visitor<decltype(vim)>(record, vim)));

  SMC::Progressive_mesh pm = SMC::make_progressive_mesh(mesh, record.collapses);
  std::cout << pm.level() << " collapses, " << record.refused_seeds.size() << " seeds" << std::endl;

  std::vector<SMC::Refined_curve> curves;
  SMC::refine_seed_curves(pm, record.refused_seeds, SMC::Tightening_schedule::EVERY_LEVEL, std::back_inserter(curves));
  for(const SMC::Refined_curve& c : curves)
    if(c.curve.nodes.empty())
      std::cout << c.seeds.size() << " seeds shortened to a point" << std::endl;
    else
      std::cout << c.seeds.size() << " seeds led to a curve of " << c.curve.nodes.size() << " nodes" << std::endl;
  return EXIT_SUCCESS;
}
