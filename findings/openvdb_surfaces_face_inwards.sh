#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenVDB 10.0.1 (python3-openvdb 10.0.1-2): createLevelSetFromPolygons(), convertToPolygons().
#
# Guess: a closed mesh that becomes a level set and a mesh again faces outwards as before, and if it faced inwards it
# comes back so, or is refused. A single voxel of an image becomes a body of some volume like that of the voxel.
# What happens: every result faces inwards, from meshes of either orientation, from a sphere made by OpenVDB and from
# images: a body that goes in and out is inside out. Nothing else is wrong with the surfaces: voxels that touch at an
# edge stay bodies of their own. But a lone voxel of value 1, with the surface at 1/2, gives a body of volume 1/27: a
# vertex is the mean of the crossings around it, and so no crossing lies on the surface.
#
# Why it matters: a level set is the way to a clean closed surface of a bad one. On a body inside out the side on which
# a curve chokes and the sign of a volume are wrong. "constrictions check" says "the normals point inside". And a neck
# one voxel thick comes out with a quarter of its section.
. "$(dirname "$0")/lib/packages.sh"
debian python3-openvdb=10.0.1-2

cat > "$work/level_sets.py" << 'END'
import meshes
import numpy
import pyopenvdb


def report(name, grid, level):
    points, triangles, quadrilaterals = grid.convertToPolygons(level, 0)
    points = [tuple(float(c) for c in p) for p in points]
    faces = [tuple(int(i) for i in f) for f in quadrilaterals]
    halves = [h for a, b, c, d in faces for h in ((a, b, c), (a, c, d))] + [tuple(int(i) for i in t) for t in triangles]
    print("%s: components %d, volume %.4f" % (name, meshes.components(halves), meshes.volume(points, halves)))


points, faces = meshes.torus()
print("torus: volume %.4f" % meshes.volume(points, faces))
for name, oriented in (("torus", faces), ("torus inside out", [f[::-1] for f in faces])):
    grid = pyopenvdb.FloatGrid.createLevelSetFromPolygons(
        numpy.array(points, numpy.float32), triangles=numpy.array(oriented, numpy.uint32),
        transform=pyopenvdb.createLinearTransform(voxelSize=0.1))
    report(name + ", level set", grid, 0)
report("sphere of radius 1", pyopenvdb.createLevelSetSphere(radius=1, voxelSize=0.1), 0)
for name, voxels in (("one voxel", [(2, 2, 2)]), ("two voxels that touch at an edge", [(2, 2, 2), (3, 3, 2)]),
                     ("ten voxels in a row", [(2, 2, 2 + i) for i in range(10)])):
    image = numpy.zeros((6, 6, 14), numpy.float32)
    for voxel in voxels:
        image[voxel] = 1
    grid = pyopenvdb.FloatGrid()
    grid.copyFromArray(image)
    report(name, grid, 0.5)
END
verdict "$(/usr/bin/python3 "$work/level_sets.py")" \
"torus: volume 37.2699
torus, level set: components 1, volume -37.1385
torus inside out, level set: components 1, volume -37.1385
sphere of radius 1: components 1, volume -4.1405
one voxel: components 1, volume -0.0370
two voxels that touch at an edge: components 2, volume -0.0741
ten voxels in a row: components 1, volume -2.2346"
