#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2) with Eigen 3.4.0 (libeigen3-dev 3.4.0-4): Heat_method_3,
# estimate_geodesic_distances(), against the exact distances of Surface_mesh_shortest_path.
#
# Guess: the estimate may be off by some per cent, more so next to the source; far away it is good, and at the source it
# is zero.
# What happens: so it is on a tube of 400 rings. Where the tube has 1500 rings, 6000 vertices, every distance is
# 1.8e308, the greatest double, also that of the source to itself, in both modes, with no error. The heat that arrives
# falls with the number of edges on the way, is the double 0 in the end, and one face on which it is constant spoils all
# vertices. One face in the same distance from the source does it as well: a regular tetrahedron has no distances.
#
# Why it matters: a mesh of a million vertices is about 1000 edges wide, and distances on it are asked for where curves
# are sorted, spread or cut open. That the source is at distance zero is worth a test in one's own program. This package
# does not use the heat method.
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libeigen3-dev=3.4.0-4 libgmp-dev libmpfr-dev

cd "$work"
cat > heat.cpp << 'END'
#define CGAL_EIGEN3_ENABLED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <cstdio>
#include <fstream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;

template <class Mode>
void print(const char* name, Mesh& mesh, Mode mode)
{
  auto distance = mesh.add_property_map<Vertex, double>(name, 0).first;
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distance, Vertex(0), mode);
  std::printf(", %s %.3g to itself and %.3g", name, distance[Vertex(0)],
              distance[Vertex(mesh.number_of_vertices() - 1)]);
}

int main(int argc, char** argv)
{
  for(int i = 1; i < argc; ++i) {
    Mesh mesh;
    std::ifstream in(argv[i]);
    CGAL::IO::read_OFF(in, mesh);
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> paths(mesh);
    paths.add_source_point(Vertex(0));
    std::printf("%s: exact %.3g to the last vertex", argv[i],
                paths.shortest_distance_to_source_points(Vertex(mesh.number_of_vertices() - 1)).first);
    print("direct", mesh, CGAL::Heat_method_3::Direct());
    print("intrinsic", mesh, CGAL::Heat_method_3::Intrinsic_Delaunay());
    std::printf("\n");
  }
}
END
compile heat gmp mpfr
cat > tubes.py << 'END'
import math
import random
import meshes

random.seed(1)
for rings in (400, 1500):
    points, faces = [], []
    for i in range(rings):
        for j in range(4):
            r = 1 + 0.01 * random.uniform(-1, 1)
            points.append((r * math.cos(math.pi * j / 2), r * math.sin(math.pi * j / 2), i))
    for i in range(rings - 1):
        for j in range(4):
            a, b = 4 * i + j, 4 * i + (j + 1) % 4
            faces += [(a, b, b + 4), (a, b + 4, a + 4)]
    last = 4 * (rings - 1)
    faces += [(0, 2, 1), (0, 3, 2), (last, last + 1, last + 2), (last, last + 2, last + 3)]
    meshes.write_off("tube_%d.off" % rings, points, faces)
meshes.write_off("tetrahedron.off", [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)],
                 [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])
END
python3 tubes.py
verdict "$(./heat tube_400.off tube_1500.off tetrahedron.off)" \
"tube_400.off: exact 399 to the last vertex, direct 0 to itself and 399, intrinsic 0 to itself and 399
tube_1500.off: exact 1.5e+03 to the last vertex, direct 1.8e+308 to itself and 1.8e+308, intrinsic 1.8e+308 to itself and 1.8e+308
tetrahedron.off: exact 2.83 to the last vertex, direct 1.8e+308 to itself and 1.8e+308, intrinsic 1.8e+308 to itself and 1.8e+308"
