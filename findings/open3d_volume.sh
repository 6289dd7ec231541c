#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Open3D 0.16.1 (python3-open3d 0.16.1+ds-2+b4), TriangleMesh.get_volume().
#
# Guess: a volume does not depend on the place, up to the last digits of the coordinates; and since the function refuses
# a mesh that is not orientable, it turns the faces of one that is.
# What happens: tetrahedra with their tips in the origin are added up, wherever the mesh is. At 1e6, map coordinates, a
# torus of volume 37 has 607, though its coordinates are good to 1e-9; measured from a point of the mesh the same
# coordinates give 37.27. Orientability is asked for and not used: an octahedron with every second face turned over is
# called watertight and orientable, and has the volume 0.
#
# Why it matters: volumes say which side of a curve is the smaller part, what a repair changed, and whether a mesh is
# inside out. "constrictions check" said that of a small body far away, for the same reason, and measures from a vertex
# now (test Program_repair.volumes_far_from_the_origin).
. "$(dirname "$0")/lib/packages.sh"
debian python3-open3d=0.16.1+ds-2+b4

cat > "$work/volumes.py" << 'END'
import meshes
import open3d


def mesh(points, faces):
    return open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points), open3d.utility.Vector3iVector(faces))


points, faces = meshes.torus()
for shift in (0, 10000, 1000000):
    moved = [(x + shift, y + shift, z + shift) for x, y, z in points]
    about = [tuple(a - b for a, b in zip(p, moved[0])) for p in moved]
    print("torus at %d: %.3f, measured from a vertex %.3f" % (
        shift, mesh(moved, faces).get_volume(), meshes.volume(about, faces)))
points, faces = meshes.octahedron()
for name, result in (("octahedron", mesh(points, faces)),
                     ("with faces turned over", mesh(points, [f[::-1] if i % 2 else f for i, f in enumerate(faces)]))):
    print("%s: watertight %s, orientable %s, volume %.3f" % (
        name, result.is_watertight(), result.is_orientable(), result.get_volume()))
END
verdict "$(/usr/bin/python3 "$work/volumes.py")" \
"torus at 0: 37.270, measured from a vertex 37.270
torus at 10000: 37.270, measured from a vertex 37.270
torus at 1000000: 607.256, measured from a vertex 37.270
octahedron: watertight True, orientable True, volume 1.333
with faces turned over: watertight True, orientable True, volume 0.000"
