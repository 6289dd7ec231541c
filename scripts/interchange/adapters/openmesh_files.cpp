// SPDX-License-Identifier: GPL-3.0-or-later
// OpenMesh, with points of doubles: reads a file, says what it holds, writes it in the same format with 17 digits:
// IN HELD OUT
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <fstream>
#include <iostream>
#include <string>

struct Traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};
typedef OpenMesh::TriMesh_ArrayKernelT<Traits> Mesh;

int main(int, char** names)
{
  const std::string source = names[1], kind = source.substr(source.rfind('.') + 1);
  Mesh mesh;
  mesh.request_face_colors();
  OpenMesh::IO::Options options = OpenMesh::IO::Options::FaceColor;
  options += OpenMesh::IO::Options::Custom;
  if(!OpenMesh::IO::read_mesh(mesh, source, options))
  {
    std::cerr << "read_mesh() returns false\n";
    return 1;
  }
  std::ofstream held(names[2]);
  held.precision(17);
  held << "{\"points\": [";
  const char* comma = "";
  for(const auto v : mesh.vertices())
  {
    held << comma << "[" << mesh.point(v)[0] << ", " << mesh.point(v)[1] << ", " << mesh.point(v)[2] << "]";
    comma = ", ";
  }
  held << "], \"faces\": [";
  comma = "";
  for(const auto f : mesh.faces())
  {
    held << comma << "[";
    comma = "";
    for(auto v = mesh.cfv_begin(f); v != mesh.cfv_end(f); ++v)
    {
      held << comma << v->idx();
      comma = ", ";
    }
    held << "]";
  }
  held << "], \"edges\": [], \"names\": [], \"point\": {}, \"edge\": {}, \"face\": {";
  comma = "";
  if(options.face_has_color())
  {
    held << "\"colours\": [";
    for(const auto f : mesh.faces())
    {
      const Mesh::Color c = mesh.color(f);
      held << comma << "[" << int(c[0]) << ", " << int(c[1]) << ", " << int(c[2]) << "]";
      comma = ", ";
    }
    held << "]";
  }
  OpenMesh::FPropHandleT<int> patch;
  if(mesh.get_property_handle(patch, "patch"))
  {
    held << comma << "\"patch\": [";
    comma = "";
    for(const auto f : mesh.faces())
    {
      held << comma << mesh.property(patch, f);
      comma = ", ";
    }
    held << "]";
  }
  held << "}}";
  OpenMesh::IO::Options as = OpenMesh::IO::Options::Default;
  if(kind == "ply" || kind == "stl")
    as += OpenMesh::IO::Options::Binary;
  if(!OpenMesh::IO::write_mesh(mesh, names[3], as, 17))
  {
    std::cerr << "write_mesh() returns false\n";
    return 1;
  }
}
