// SPDX-License-Identifier: GPL-3.0-or-later

// Uses the installed package: the waist of an hourglass with a hexagonal cross section.

#include <CGAL/Surface_mesh_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;

// A hexagon in each of the planes z = 0, 1, 2, ... with the given radii, closed by a fan at both ends.
Mesh stack_of_hexagons(const std::vector<double>& radii)
{
  const std::size_t sides = 6;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(std::size_t i = 0; i < radii.size(); ++i)
    for(std::size_t j = 0; j < sides; ++j)
    {
      const double phi = 2 * CGAL_PI * static_cast<double>(j) / sides;
      v.push_back(
          mesh.add_vertex(Kernel::Point_3(radii[i] * std::cos(phi), radii[i] * std::sin(phi), static_cast<double>(i))));
    }
  const Mesh::Vertex_index bottom = mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  const Mesh::Vertex_index top = mesh.add_vertex(Kernel::Point_3(0, 0, static_cast<double>(radii.size() - 1)));
  const std::size_t last_ring = sides * (radii.size() - 1);
  for(std::size_t j = 0; j < sides; ++j)
  {
    const std::size_t k = (j + 1) % sides;
    for(std::size_t ring = 0; ring < last_ring; ring += sides)
    {
      mesh.add_face(v[ring + j], v[ring + k], v[ring + sides + k]);
      mesh.add_face(v[ring + j], v[ring + sides + k], v[ring + sides + j]);
    }
    mesh.add_face(bottom, v[k], v[j]);
    mesh.add_face(top, v[last_ring + j], v[last_ring + k]);
  }
  return mesh;
}

int main()
{
  const Mesh mesh = stack_of_hexagons({3, 4, 1, 4, 3});
  std::vector<Constriction> constrictions;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(constrictions));

  // The regular hexagon with radius 1 has sides of length 1.
  for(const Constriction& c : constrictions)
    if(std::abs(c.length() - 6) < 1e-9)
    {
      std::cout << "found the waist" << std::endl;
      return EXIT_SUCCESS;
    }
  std::cerr << "the waist is not among the " << constrictions.size() << " constrictions found" << std::endl;
  return EXIT_FAILURE;
}
