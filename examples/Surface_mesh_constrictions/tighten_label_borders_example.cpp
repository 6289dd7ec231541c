// SPDX-License-Identifier: GPL-3.0-or-later

// Make the borders of a segmentation tight, here of CGAL's own by the shape diameter function.

#include <CGAL/Surface_mesh_constrictions/tighten_label_borders.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SMC = CGAL::Surface_mesh_constrictions;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto diameter = mesh.add_property_map<Mesh::Face_index, double>("f:diameter").first;
  auto label = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
  CGAL::sdf_values(mesh, diameter);
  CGAL::segmentation_from_sdf_values(mesh, diameter, label);

  const auto result = SMC::tighten_label_borders(mesh, label, label); // the new labels replace the old ones
  for(const auto& border : result.borders)
  {
    std::cout << "between " << border.labels[0] << " and " << border.labels[1] << ": length " << border.old_length;
    if(border.outcome == SMC::Label_border_outcome::DEGENERATE)
      std::cout << ", label " << *border.vanishing_label << " vanishes" << std::endl;
    else
      std::cout << " -> " << border.length << ", " << border.certificate << std::endl;
  }
  for(std::size_t p = 0; p < result.parts.size(); ++p)
    std::cout << "label " << result.labels[p] << ": area " << result.parts[p].area << std::endl;
  return EXIT_SUCCESS;
}
