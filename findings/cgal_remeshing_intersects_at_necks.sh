#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 and 6.0.1 (libcgal-dev 5.5.1-2 of Debian 12, 6.0.1-1 of Debian 13), isotropic_remeshing() of two balls on a
# thin tube, with five iterations.
#
# Guess: edges longer than the tube is thick make the tube a prism of three or four sides, but the surface stays closed,
# and does not intersect itself, as each step checks what it does: collapses for the link condition, flips and moves for
# normals, and at the end the points are projected to the input.
# What happens: with a tube of radius 0.05 it is so, the girth falls by a fifth. With one of radius 0.02 and edges of
# 0.1 or 0.2 a few pairs of triangles intersect, in both versions; with edges of 0.05 or 0.3 there are none. Nothing is
# said, and is_closed() and is_valid_polygon_mesh() hold.
#
# Why it matters: scans are remeshed before their necks are looked for, with a length that suits the whole body. The
# neck is where it is too long: there a shortest curve gets shorter by a fifth, and the surface may cross itself.
. "$(dirname "$0")/lib/cgal6.sh"
debian libcgal-dev=5.5.1-2 libeigen3-dev=3.4.0-4 libgmp-dev libmpfr-dev

cd "$work"
cat > remesh.cpp << 'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// The length of the section at height z.
double girth(const Mesh& mesh, double z)
{
  double length = 0;
  for (auto f : mesh.faces()) {
    std::vector<Point> ends;
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Point a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h));
      if ((a.z() < z) != (b.z() < z))
        ends.push_back(a + (z - a.z()) / (b.z() - a.z()) * (b - a));
    }
    if (ends.size() == 2)
      length += std::sqrt(CGAL::squared_distance(ends[0], ends[1]));
  }
  return length;
}

int main(int, char* names[])
{
  for (int i = 1; i <= 2; ++i) {
    Mesh input;
    PMP::IO::read_polygon_mesh(names[i], input);
    for (const double target : {0., 0.05, 0.1, 0.2, 0.3}) {
      Mesh mesh = input;
      if (target > 0)
        PMP::isotropic_remeshing(mesh.faces(), target, mesh, CGAL::parameters::number_of_iterations(5));
      std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
      PMP::self_intersections(mesh, std::back_inserter(pairs));
      std::printf("CGAL %s, %s, edges of %.2f: %s, girth %.2f, intersections %s\n", CGAL_VERSION_STR, names[i], target,
                  CGAL::is_closed(mesh) && CGAL::is_valid_polygon_mesh(mesh) ? "closed and valid" : "not closed",
                  girth(mesh, 0.005), pairs.empty() ? "none" : "some");
    }
  }
}
END
python3 -c '
import meshes
for r in (0.05, 0.02):
    meshes.write_off("tube_%g.off" % r, *meshes.dumbbell(r))'
compile remesh gmp mpfr
first=$(./remesh tube_0.05.off tube_0.02.off)
compile_with_cgal6 remesh gmp mpfr
verdict "$first
$(./remesh tube_0.05.off tube_0.02.off)" \
"CGAL 5.5.1, tube_0.05.off, edges of 0.00: closed and valid, girth 0.31, intersections none
CGAL 5.5.1, tube_0.05.off, edges of 0.05: closed and valid, girth 0.30, intersections none
CGAL 5.5.1, tube_0.05.off, edges of 0.10: closed and valid, girth 0.25, intersections none
CGAL 5.5.1, tube_0.05.off, edges of 0.20: closed and valid, girth 0.25, intersections none
CGAL 5.5.1, tube_0.05.off, edges of 0.30: closed and valid, girth 0.25, intersections none
CGAL 5.5.1, tube_0.02.off, edges of 0.00: closed and valid, girth 0.12, intersections none
CGAL 5.5.1, tube_0.02.off, edges of 0.05: closed and valid, girth 0.10, intersections none
CGAL 5.5.1, tube_0.02.off, edges of 0.10: closed and valid, girth 0.10, intersections some
CGAL 5.5.1, tube_0.02.off, edges of 0.20: closed and valid, girth 0.10, intersections some
CGAL 5.5.1, tube_0.02.off, edges of 0.30: closed and valid, girth 0.11, intersections none
CGAL 6.0.1, tube_0.05.off, edges of 0.00: closed and valid, girth 0.31, intersections none
CGAL 6.0.1, tube_0.05.off, edges of 0.05: closed and valid, girth 0.30, intersections none
CGAL 6.0.1, tube_0.05.off, edges of 0.10: closed and valid, girth 0.25, intersections none
CGAL 6.0.1, tube_0.05.off, edges of 0.20: closed and valid, girth 0.25, intersections none
CGAL 6.0.1, tube_0.05.off, edges of 0.30: closed and valid, girth 0.25, intersections none
CGAL 6.0.1, tube_0.02.off, edges of 0.00: closed and valid, girth 0.12, intersections none
CGAL 6.0.1, tube_0.02.off, edges of 0.05: closed and valid, girth 0.10, intersections none
CGAL 6.0.1, tube_0.02.off, edges of 0.10: closed and valid, girth 0.10, intersections some
CGAL 6.0.1, tube_0.02.off, edges of 0.20: closed and valid, girth 0.10, intersections some
CGAL 6.0.1, tube_0.02.off, edges of 0.30: closed and valid, girth 0.11, intersections none"
