// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/mesh_as_text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

namespace constrictions {

namespace {

std::string written_extension(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

} // namespace

bool is_text_format(const std::string& file_name)
{
  const std::string extension = written_extension(file_name);
  return extension == ".off" || extension == ".obj" || extension == ".ply";
}

std::string mesh_as_text(const Mesh& mesh, const std::string& file_name)
{
  const std::string extension = written_extension(file_name);
  const bool is_obj = extension == ".obj";
  std::ostringstream out;
  out.precision(17);
  if(extension == ".off")
    out << "OFF\n" << mesh.num_vertices() << ' ' << mesh.number_of_faces() << " 0\n";
  else if(extension == ".ply")
    out << "ply\nformat ascii 1.0\nelement vertex " << mesh.num_vertices()
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.number_of_faces()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < mesh.num_vertices(); ++v)
  {
    const Point& p = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    out << (is_obj ? "v " : "") << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    out << (is_obj ? "f" : "3");
    for(Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      out << ' ' << mesh.source(h).idx() + (is_obj ? 1 : 0);
    out << '\n';
  }
  return out.str();
}

} // namespace constrictions
