#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# trimesh 4.5.1 (python3-trimesh 4.5.1-3 of Debian 13): split(), slice_plane(), and process(validate=True).
#
# Guess: split() gives the bodies of a mesh with the faces that they have, those that are closed only by default; a part
# on one side of a plane has the section as its border; validation takes out what is degenerate or there twice.
# What happens: split() closes holes of three and four edges with new faces and then counts such a body as closed; one
# with a larger hole is left out without a word. Half an octahedron comes back as a closed pyramid. A torus that is
# sliced has 288 border edges instead of 96, as triangles that the plane cuts share no vertex with the others at the
# cut; merge_vertices() mends that. Validation turns a cavity over, so that the volume of 1.17 becomes 1.5.
#
# Why it matters: necks of parts are looked for one part at a time. A border is a closed curve like any other, and here
# it is closed, dropped, or three times as long; what lies around a cavity is measured on a body without one.
. "$(dirname "$0")/lib/packages.sh"
debian python3-numpy=1:1.24.2-1+deb12u1 python3-networkx=2.8.8-1 python3-lxml=4.9.2-1+b1 python3-scipy=1.10.1-2 \
  python3-shapely=1.8.5-2+b1 python3-rtree=1.0.1-1
debian_13 python3-trimesh=4.5.1-3
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done

cat > "$work/parts.py" << 'END'
import meshes
import trimesh


def join(first, second):
    return first[0] + second[0], first[1] + [tuple(i + len(first[0]) for i in f) for f in second[1]]


def made(mesh):
    return trimesh.Trimesh(*mesh, process=False)


points, faces = octahedron = meshes.octahedron()
moved = [(x + 3, y, z) for x, y, z in points]
bell = meshes.dumbbell(0.05)
bell = [(x, y, z + 5) for x, y, z in bell[0]], [f for f in bell[1] if 0 not in f]
for name, other in (("octahedron without a face", (moved, faces[1:])), ("half an octahedron", (moved, faces[4:])),
                    ("dumbbell with a hole of 16 edges", bell)):
    both = made(join(octahedron, other))
    print("octahedron and %s: faces %d and %d; split() %s, with open ones %s, without repair %s" % (
        name, len(faces), len(other[1]), *([len(part.faces) for part in both.split(**options)] for options in (
            {}, {"only_watertight": False}, {"only_watertight": False, "repair": False}))))
for height in (0, 0.1):
    part = made(meshes.torus()).slice_plane((0, 0, height), (0, 0, 1))
    print("torus sliced at %g: %s" % (height, meshes.describe(list(map(tuple, part.faces)))))
    part.merge_vertices()
    print("  vertices merged: %s" % meshes.describe(list(map(tuple, part.faces))))
hollow = made(join(octahedron, ([tuple(0.5 * c for c in p) for p in points], [f[::-1] for f in faces])))
before = hollow.volume
hollow.process(validate=True)
print("octahedron with a cavity: volume %.3f, validated %.3f" % (before, hollow.volume))
END
verdict "$(python3 "$work/parts.py" 2> "$work/parts.log")" \
"octahedron and octahedron without a face: faces 8 and 7; split() [8, 8], with open ones [8, 8], without repair [8, 7]
octahedron and half an octahedron: faces 8 and 4; split() [8, 6], with open ones [8, 6], without repair [8, 4]
octahedron and dumbbell with a hole of 16 edges: faces 8 and 1872; split() [8], with open ones [8, 1872], without repair [8, 1872]
torus sliced at 0: V 168, F 288, components 1, Euler characteristic 0, border edges 48, non-manifold edges 0
  vertices merged: V 168, F 288, components 1, Euler characteristic 0, border edges 48, non-manifold edges 0
torus sliced at 0.1: V 312, F 336, components 1, Euler characteristic 0, border edges 288, non-manifold edges 0
  vertices merged: V 216, F 336, components 1, Euler characteristic 0, border edges 96, non-manifold edges 0
octahedron with a cavity: volume 1.167, validated 1.500"
