#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2) and 6.0.1 (6.0.1-1 of Debian 13): sdf_values() and segmentation_from_sdf_values().
#
# Guess: two balls on a thin tube are three segments, with the default parameters too: the diameter is 0.56 within the
# balls and 0.19 or 0.04 within the tube. More clusters can only give more: the manual says that many of them make a
# detailed segmentation of many segments.
# What happens: two clusters give the three segments, and so do three. With four, with five, which is the default, and
# with eight the whole body is one segment, also if each vertex is moved at random by up to 1% of its distance from the
# axis. The diameters themselves are right.
#
# Why it matters: this is the segmentation at hand in the library for which this package is made, a dumbbell is the
# first thing one tries it on, and its neck is as thin as a neck can be. Whoever compares parts cut at constrictions
# with it should give the number of clusters, and see that more of them are worse.
. "$(dirname "$0")/lib/cgal6.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cd "$work"
cat > segments.cpp << 'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <cstdio>
#include <fstream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char** argv)
{
  for(int i = 1; i < argc; ++i) {
    Mesh mesh;
    std::ifstream in(argv[i]);
    CGAL::IO::read_OFF(in, mesh);
    auto diameters = mesh.add_property_map<Mesh::Face_index, double>("f:diameter", 0).first;
    auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment", 0).first;
    const auto range = CGAL::sdf_values(mesh, diameters);
    std::printf("%s: diameters from %.2f to %.2f; segments", argv[i], range.first, range.second);
    for(std::size_t clusters : {2, 3, 4, 8})
      std::printf(" with %zu clusters %zu,", clusters,
                  CGAL::segmentation_from_sdf_values(mesh, diameters, segments, clusters));
    std::printf(" by default %zu\n", CGAL::segmentation_from_sdf_values(mesh, diameters, segments));
  }
}
END
cat > bodies.py << 'END'
import random
import meshes

random.seed(3)
for radius in (0.1, 0.02):
    points, faces = meshes.dumbbell(radius)
    meshes.write_off("tube_%g.off" % radius, points, faces)
    moved = [(s * x, s * y, z) for x, y, z in points for s in [1 + 0.01 * random.uniform(-1, 1)]]
    meshes.write_off("tube_%g_moved.off" % radius, moved, faces)
END
python3 bodies.py
compile segments gmp mpfr
mv segments segments_5.5.1
compile_with_cgal6 segments gmp mpfr
mv segments segments_6.0.1
for version in 5.5.1 6.0.1; do
  "./segments_$version" tube_*.off | sed "s/^/CGAL $version, /"
done > seen.txt
verdict "$(cat seen.txt)" \
"CGAL 5.5.1, tube_0.02.off: diameters from 0.04 to 0.56; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 5.5.1, tube_0.02_moved.off: diameters from 0.04 to 0.57; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 5.5.1, tube_0.1.off: diameters from 0.19 to 0.58; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 5.5.1, tube_0.1_moved.off: diameters from 0.19 to 0.59; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 6.0.1, tube_0.02.off: diameters from 0.04 to 0.56; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 6.0.1, tube_0.02_moved.off: diameters from 0.04 to 0.57; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 6.0.1, tube_0.1.off: diameters from 0.19 to 0.58; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1
CGAL 6.0.1, tube_0.1_moved.off: diameters from 0.19 to 0.59; segments with 2 clusters 3, with 3 clusters 3, with 4 clusters 1, with 8 clusters 1, by default 1"
