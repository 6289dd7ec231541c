// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL: reads a file, says what it holds, writes it in the same format with 17 digits: IN HELD OUT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <fstream>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int, char** names)
{
  const std::string source = names[1], kind = source.substr(source.rfind('.') + 1);
  Mesh mesh;
  // The reader of PLY for a Surface_mesh also reads properties; read_polygon_mesh() leaves them out.
  if(kind == "ply")
  {
    std::ifstream in(source, std::ios::binary);
    std::string comments;
    if(!CGAL::IO::read_PLY(in, mesh, comments))
    {
      std::cerr << "read_PLY() returns false\n";
      return 1;
    }
  }
  else if(!CGAL::IO::read_polygon_mesh(source, mesh))
  {
    std::cerr << "read_polygon_mesh() returns false\n";
    return 1;
  }
  std::ofstream held(names[2]);
  held.precision(17);
  held << "{\"points\": [";
  const char* comma = "";
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    held << comma << "[" << p.x() << ", " << p.y() << ", " << p.z() << "]";
    comma = ", ";
  }
  held << "], \"faces\": [";
  comma = "";
  for(Mesh::Face_index f : mesh.faces())
  {
    held << comma << "[";
    comma = "";
    // The halfedge of a face points to its second corner.
    for(Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.prev(mesh.halfedge(f)), mesh))
    {
      held << comma << std::size_t(v);
      comma = ", ";
    }
    held << "]";
  }
  held << "], \"edges\": [], \"names\": [], \"point\": {}, \"edge\": {}, \"face\": {";
  comma = "";
  for(const std::string& name : mesh.properties<Mesh::Face_index>())
  {
    auto write = [&](const auto& map) {
      held << comma << "\"" << name << "\": [";
      comma = "";
      for(Mesh::Face_index f : mesh.faces())
      {
        held << comma << +map[f];
        comma = ", ";
      }
      held << "]";
    };
#if CGAL_VERSION_NR >= 1060000000
    if(auto map = mesh.property_map<Mesh::Face_index, std::int32_t>(name))
      write(*map);
    else if(auto map = mesh.property_map<Mesh::Face_index, std::uint8_t>(name))
      write(*map);
    const auto colours = mesh.property_map<Mesh::Face_index, CGAL::IO::Color>(name);
    if(colours)
    {
      const auto& map = *colours;
#else
    const auto numbers = mesh.property_map<Mesh::Face_index, std::int32_t>(name);
    if(numbers.second)
      write(numbers.first);
    const auto colours = mesh.property_map<Mesh::Face_index, CGAL::IO::Color>(name);
    if(colours.second)
    {
      const auto& map = colours.first;
#endif
      held << comma << "\"" << name << "\": [";
      comma = "";
      for(Mesh::Face_index f : mesh.faces())
      {
        held << comma << "[" << +map[f].red() << ", " << +map[f].green() << ", " << +map[f].blue() << "]";
        comma = ", ";
      }
      held << "]";
    }
  }
  held << "}}";
  if(kind == "ply")
  {
    std::ofstream out(names[3], std::ios::binary);
    CGAL::IO::set_binary_mode(out);
    return CGAL::IO::write_PLY(out, mesh) ? 0 : 1;
  }
  if(!CGAL::IO::write_polygon_mesh(names[3], mesh, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "write_polygon_mesh() returns false\n";
    return 1;
  }
}
