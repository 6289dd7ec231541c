#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Open3D 0.16.1 (python3-open3d 0.16.1+ds-2+b4): TriangleMesh.is_self_intersecting(), is_watertight(), get_volume().
#
# Guess: triangles that are apart are not reported, or only if they are within rounding, 1e-16 of the size.
# What happens: two balls on a tube, 2 long, are fine with a tube of radius 0.001. With one of radius 0.0001 pairs of
# long thin triangles on neighbouring sides of the tube are said to cross. Exact arithmetic finds a plane between the
# two triangles of each pair. A hundred thousand times as large the same body has such pairs too: it is the shape, not
# the size. Then the mesh counts as not watertight, and its volume is refused.
#
# Why it matters: a thin neck of long thin triangles is what this package looks for, and what a check of meshes before
# it would throw away. CGAL's does_self_intersect() with a kernel of exact predicates decides without an error.
. "$(dirname "$0")/lib/packages.sh"
debian python3-open3d=0.16.1+ds-2+b4

cat > "$work/necks.py" << 'END'
from fractions import Fraction
import meshes
import open3d


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def apart(first, second):
    """Whether an exactly computed plane lies between two triangles: normals, and cross products of their edges."""
    edges = [[minus(t[k], t[k - 1]) for k in range(3)] for t in (first, second)]
    for normal in [cross(e[0], e[1]) for e in edges] + [cross(a, b) for a in edges[0] for b in edges[1]]:
        sides = [[sum(x * y for x, y in zip(normal, p)) for p in t] for t in (first, second)]
        if max(sides[0]) < min(sides[1]) or max(sides[1]) < min(sides[0]):
            return True
    return False


for neck, size in ((0.001, 1), (0.0001, 1), (0.0001, 100000)):
    points, faces = meshes.dumbbell(neck)
    points = [tuple(size * c for c in p) for p in points]
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points), open3d.utility.Vector3iVector(faces))
    pairs = [[[[Fraction(c) for c in points[i]] for i in faces[f]] for f in pair]
             for pair in mesh.get_self_intersecting_triangles()]
    print("radius %g, size %d: crossing %s, pairs %d, of these apart %d, watertight %s" % (
        neck, size, mesh.is_self_intersecting(), len(pairs), sum(apart(*p) for p in pairs), mesh.is_watertight()))
    try:
        print("volume %.4f" % (mesh.get_volume() / size ** 3))
    except RuntimeError as error:
        print("no volume:", str(error).split("GetVolume()")[-1].split(":")[-1].strip(" \n\033[0;m"))
END
verdict "$(/usr/bin/python3 "$work/necks.py")" \
"radius 0.001, size 1: crossing False, pairs 0, of these apart 0, watertight True
volume 0.3473
radius 0.0001, size 1: crossing True, pairs 11, of these apart 11, watertight False
no volume: The mesh is not watertight, and the volume cannot be computed.
radius 0.0001, size 100000: crossing True, pairs 11, of these apart 11, watertight False
no volume: The mesh is not watertight, and the volume cannot be computed."
