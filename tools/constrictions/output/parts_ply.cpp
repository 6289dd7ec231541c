// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/parts.h"

#include "output/colours.h"
#include "output/little_endian.h"

#include <cstdint>
#include <sstream>

namespace constrictions {

std::string mesh_as_ply(const Mesh& mesh, const std::vector<std::size_t>& part_of_face)
{
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\ncomment parts of a surface cut along its constrictions\n"
         << "element vertex " << mesh.number_of_vertices()
         << "\nproperty double x\nproperty double y\nproperty double z\n"
         << "element face " << mesh.number_of_faces()
         << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
         << "property int patch\nend_header\n";
  std::string out = header.str();

  std::vector<std::uint32_t> number(mesh.num_vertices());
  std::uint32_t n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = n++;
    for(int i = 0; i < 3; ++i)
      append_little_endian(mesh.point(v)[i], out);
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    append_little_endian(std::uint8_t(3), out);
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      append_little_endian(number[v], out);
    for(std::uint8_t c : part_colour(part_of_face[f]))
      append_little_endian(c, out);
    append_little_endian(static_cast<std::uint32_t>(part_of_face[f]), out);
  }
  return out;
}

} // namespace constrictions
