// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/parts.h"

#include "output/vtp_file.h"

namespace constrictions {

std::string mesh_as_vtp(const Mesh& mesh, const std::vector<std::size_t>& part_of_face)
{
  Vtp_file file(Vtp_file::POLYGONS);
  std::vector<std::size_t> number(mesh.num_vertices());
  std::size_t n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = n++;
    file.add_point(mesh.point(v));
  }
  std::vector<std::int32_t> patches;
  std::vector<Colour> colours;
  for(Mesh::Face_index f : mesh.faces())
  {
    std::vector<std::size_t> corners;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(number[v]);
    file.add_cell(corners);
    patches.push_back(static_cast<std::int32_t>(part_of_face[f]));
    colours.push_back(part_colour(part_of_face[f]));
  }
  file.add_cell_data("patch", patches);
  file.add_cell_data("colour", colours);
  file.show_cell_data("patch");
  return file.text();
}

} // namespace constrictions
