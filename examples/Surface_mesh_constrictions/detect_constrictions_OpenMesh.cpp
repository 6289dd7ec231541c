// SPDX-License-Identifier: GPL-3.0-or-later

// The same call on an OpenMesh mesh. OpenMesh comes before the adaptor. It reads coordinates in single precision, also
// into points of doubles, and the certificates are those of this rounded surface.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef OpenMesh::TriMesh_ArrayKernelT<> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh, filename))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(constrictions));

  for(const Constriction& c : constrictions)
    std::cout << "length " << c.length() << std::endl;
  return EXIT_SUCCESS;
}
