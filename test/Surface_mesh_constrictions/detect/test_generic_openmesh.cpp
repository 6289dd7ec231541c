// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "include/same_curves.h"

namespace test_generic_openmesh {

struct Double_traits : public OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};

typedef OpenMesh::TriMesh_ArrayKernelT<Double_traits> Mesh;

Mesh make_open_mesh(const test_meshes::Soup& soup)
{
  Mesh mesh;
  std::vector<Mesh::VertexHandle> vertices;
  for(const test_meshes::Position& p : soup.points)
    vertices.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], p[2])));
  for(const test_meshes::Triangle& t : soup.faces)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return mesh;
}

TEST(Generic, OpenMeshGivesTheSameCurves)
{
  for(const test_meshes::Soup& soup : same_curves::soups())
  {
    const auto expected = same_curves::detect(test_meshes::make_mesh(soup), CGAL::parameters::default_values());
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(same_curves::detect(make_open_mesh(soup), CGAL::parameters::default_values()), expected);
  }
}

} // namespace test_generic_openmesh
