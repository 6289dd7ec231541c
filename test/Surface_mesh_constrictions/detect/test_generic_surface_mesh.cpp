// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/same_curves.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

namespace test_generic_surface_mesh {

TEST(Generic, SurfaceMeshOfSimpleCartesianPointsGivesTheSameCurves)
{
  same_curves::expect_same_curves<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>();
}

TEST(Generic, SurfaceMeshOfExactPointsGivesTheSameCurves)
{
  same_curves::expect_same_curves<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>();
}

TEST(Generic, AVertexPointMapOfTheUserIsUsed)
{
  for(const test_meshes::Soup& soup : same_curves::soups())
  {
    const test_meshes::Mesh mesh = test_meshes::make_mesh(soup);
    test_meshes::Mesh flat = mesh; // all points the same: of no use
    for(auto v : flat.vertices())
      flat.point(v) = CGAL::ORIGIN;
    std::map<test_meshes::Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_3> points;
    for(auto v : mesh.vertices())
      points[v] = CGAL::Simple_cartesian<double>::Point_3(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    const boost::associative_property_map<decltype(points)> vpm(points);
    EXPECT_EQ(same_curves::detect(flat, CGAL::parameters::vertex_point_map(vpm)),
              same_curves::detect(mesh, CGAL::parameters::default_values()));
  }
}

TEST(Generic, GarbageInASurfaceMeshDoesNotMatter)
{
  const test_meshes::Soup soup = test_meshes::torus(0.1, 3);
  test_meshes::Mesh mesh;
  const auto garbage = mesh.add_vertex(CGAL::ORIGIN);
  for(const test_meshes::Position& p : soup.points)
    mesh.add_vertex(test_meshes::Mesh::Point(p[0], p[1], p[2]));
  typedef test_meshes::Mesh::Vertex_index Vertex;
  for(const test_meshes::Triangle& t : soup.faces)
    mesh.add_face(Vertex(static_cast<CGAL::SM_Vertex_index::size_type>(t[0] + 1)),
                  Vertex(static_cast<CGAL::SM_Vertex_index::size_type>(t[1] + 1)),
                  Vertex(static_cast<CGAL::SM_Vertex_index::size_type>(t[2] + 1)));
  mesh.remove_vertex(garbage);
  EXPECT_EQ(same_curves::detect(mesh, CGAL::parameters::default_values()),
            same_curves::detect(test_meshes::make_mesh(soup), CGAL::parameters::default_values()));
}

} // namespace test_generic_surface_mesh
