#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2), Curves_on_surface_topology: compute_shortest_non_contractible_cycle().
#
# Guess: on a mesh whose vertices have points, the shortest cycle that cannot be contracted is the one of least length
# along the edges: the waist of an open tube, and the circle around the thin side of a torus.
# What happens: by default every edge counts 1. On a torus with few segments one way and many the other it returns six
# edges of the length 36, with the length as weight 24 edges of 6.27. Of a tube with rings of equally many edges it
# returns one of the widest, five times as long as the waist. That every edge counts 1 is in the manual; that lengths
# are 6 times too great is not to be seen in the cycle. compute_edge_width() is the same by its name.
#
# Why it matters: this cycle is the natural first guess for a closed geodesic, and is then made tight. A start at the
# wrong one ends at another constriction; the sequence of edges looks right in both cases.
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libboost-dev libgmp-dev libmpfr-dev

cd "$work"
cat > cycles.cpp << 'END'
#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace topology = CGAL::Surface_mesh_topology;

struct Length {
  using Weight_t = double;
  const Mesh& mesh;
  double operator()(Mesh::Halfedge_index h) const
  {
    return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
};

int main(int, char* argv[])
{
  Mesh mesh;
  CGAL::IO::read_polygon_mesh(argv[1], mesh);
  topology::Curves_on_surface_topology<Mesh> curves(mesh);
  const Length length{mesh};
  const auto report = [&](const char* name, const topology::Path_on_surface<Mesh>& cycle) {
    double sum = 0;
    for (std::size_t i = 0; i < cycle.length(); ++i) {
      sum += length(cycle[i]);
    }
    std::cout << name << cycle.length() << " edges of the length " << sum;
  };
  report(": ", curves.compute_shortest_non_contractible_cycle());
  report("; by lengths ", curves.compute_shortest_non_contractible_cycle(length));
  report("; edge width ", curves.compute_edge_width());
}
END
compile cycles gmp mpfr
cat > cycles.py << 'END'
import math
import subprocess
import meshes

points, faces, n, radii = [], [], 16, (1, 0.6, 0.2, 0.6, 1)
for i, radius in enumerate(radii):
    points += [(radius * math.cos(2 * math.pi * j / n), radius * math.sin(2 * math.pi * j / n), i) for j in range(n)]
for i in range(len(radii) - 1):
    for j in range(n):
        a, b = i * n + j, i * n + (j + 1) % n
        faces += [(a, b, b + n), (a, b + n, a + n)]
for name, mesh in (("torus of 24 by 12", meshes.torus()), ("torus of 6 by 24", meshes.torus(6, 24, 5, 1)),
                   ("open tube with a waist", (points, faces))):
    meshes.write_off("mesh.off", *mesh)
    print(name + subprocess.check_output(["./cycles", "mesh.off"], text=True, stderr=subprocess.DEVNULL))
END
verdict "$(python3 cycles.py)" \
"torus of 24 by 12: 12 edges of the length 6.21166; by lengths 12 edges of the length 6.21166; edge width 12 edges of the length 6.21166
torus of 6 by 24: 6 edges of the length 36; by lengths 24 edges of the length 6.26526; edge width 6 edges of the length 36
open tube with a waist: 16 edges of the length 6.24289; by lengths 16 edges of the length 1.24858; edge width 16 edges of the length 6.24289"
