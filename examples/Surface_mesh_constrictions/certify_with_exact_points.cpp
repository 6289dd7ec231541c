// SPDX-License-Identifier: GPL-3.0-or-later

// Build a surface with rational points, two frusta joined at a square, and let exact arithmetic decide which of two
// closed paths on it is a constriction.

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <utility>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
typedef CGAL::Surface_mesh_constrictions::Certificate Certificate;

// Four points at height z, each coordinate a third of an integer: no doubles.
std::array<Mesh::Vertex_index, 4> add_square(Mesh& mesh, int side, int z)
{
  const Kernel::FT a = Kernel::FT(side) / 3;
  return {mesh.add_vertex({a, -a, z}), mesh.add_vertex({a, a, z}), mesh.add_vertex({-a, a, z}),
          mesh.add_vertex({-a, -a, z})};
}

// Whether the path of edges through the corners of a square is a constriction.
Certificate certify(const Mesh& mesh, const std::array<Mesh::Vertex_index, 4>& square)
{
  Constriction::Data data;
  for(Mesh::Vertex_index v : square)
    data.locations.push_back({true, v, Mesh::Halfedge_index(), 0});
  return CGAL::Surface_mesh_constrictions::certify_constriction(mesh, Constriction(data));
}

int main()
{
  Mesh mesh;
  const auto low = add_square(mesh, 7, 0), waist = add_square(mesh, 2, 5), high = add_square(mesh, 7, 10);
  for(int i = 0; i < 4; ++i)
    for(const auto& [a, b] : {std::make_pair(low, waist), std::make_pair(waist, high)})
    {
      mesh.add_face(a[i], a[(i + 1) % 4], b[(i + 1) % 4]);
      mesh.add_face(a[i], b[(i + 1) % 4], b[i]);
    }
  mesh.add_face(low[0], low[2], low[1]);
  mesh.add_face(low[0], low[3], low[2]);
  mesh.add_face(high[0], high[1], high[2]);
  mesh.add_face(high[0], high[2], high[3]);

  std::cout << "waist: " << certify(mesh, waist) << "\nrim: " << certify(mesh, low) << std::endl;
  return certify(mesh, waist).is_certified() && !certify(mesh, low).is_certified() ? EXIT_SUCCESS : EXIT_FAILURE;
}
