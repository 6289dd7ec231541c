// SPDX-License-Identifier: GPL-3.0-or-later

// Simplify with a cost of one's own: where one looks for constrictions the surface is kept finer for longer.

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace SMS = CGAL::Surface_mesh_simplification;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

// The length of the edge, and ten times as much where x is positive: on the right arm of the cactus.
struct Cost_by_place
{
  template <class Profile, class OptionalPoint>
  auto operator()(const Profile& profile, const OptionalPoint& placement) const
  {
    auto cost = SMS::Edge_length_cost<SMC::Simplification_mesh>()(profile, placement);
    if(cost && profile.p0().x() > 0)
      *cost *= 10;
    return cost;
  }
};

// Called for the mesh, and for each block of a large one.
struct Policies_by_place
{
  auto operator()(SMC::Simplification_mesh&) const
  {
    return SMC::Cost_and_placement<Cost_by_place, SMS::Midpoint_placement<SMC::Simplification_mesh>>({}, {});
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

  std::vector<SMC::Constriction<Mesh>> constrictions;
  SMC::detect_constrictions(mesh, std::back_inserter(constrictions),
                            SMC::parameters::simplification_policies(Policies_by_place()));
  for(const auto& c : constrictions)
    std::cout << "length " << c.length() << ", prominence " << c.prominence() << std::endl;
  return EXIT_SUCCESS;
}
