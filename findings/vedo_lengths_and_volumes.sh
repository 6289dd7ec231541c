#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# vedo 2023.4.3 (python3-vedo 2023.4.3-1): Line.length(), Mesh.volume(), Mesh.area(), and OBJ files that it writes.
#
# Guess: the length of a closed line is that of the curve that is drawn; the volume of a closed mesh is that of the
# body, whatever polygons it has, or there is an error; OBJ has at least the digits of single precision.
# What happens: the segment that closes a line is drawn and not counted: a square of side 1 has length 3. In volumes
# and areas faces of more than three corners are left out: a cube of six squares is closed, and has volume 0 and area
# 0, and a pyramid on a square has 80% of its volume. The class of VTK that this calls gives a warning; here warnings
# are turned off. A mesh that faces inwards has the volume of one that faces outwards. OBJ has five digits: of a body
# 2 long with a neck of radius 0.01, at 1000, 946 vertices are at 610 places.
#
# Why it matters: the length of a loop around a neck is too small by its last segment, by more the coarser the loop
# is. Volumes say what a repair changed and which side of a curve is the smaller part. And in OBJ thin necks are gone.
. "$(dirname "$0")/lib/packages.sh"
debian python3-vedo=2023.4.3-1

cd "$work"
cat > volumes.py << 'END'
import meshes
import vedo


def fans(faces):
    return [(f[0], a, b) for f in faces for a, b in zip(f[1:], f[2:])]


print("version:", vedo.__version__)
cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
base = [(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (0, 0, 1)]
sides = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 3, 2, 1)]
inwards = meshes.torus()
for name, points, faces in (("cube", cube, squares), ("cube of triangles", cube, fans(squares)),
                            ("pyramid", base, sides), ("pyramid of triangles", base, fans(sides)),
                            ("torus", *inwards), ("torus, inwards", inwards[0], [f[::-1] for f in inwards[1]])):
    mesh = vedo.Mesh([points, faces])
    print("%s: closed %s, volume %.4f, area %.4f; should be %.4f" % (
        name, mesh.is_closed(), mesh.volume(), mesh.area(), meshes.volume(points, fans(faces))))
square = vedo.Line([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], closed=True)
print("closed square: cells %s, length %g" % (square.lines(), square.length()))
points, faces = meshes.dumbbell(0.01)
moved = [(x + 1000, y + 1000, z + 1000) for x, y, z in points]
vedo.Mesh([moved, faces]).write("out.obj")
written = meshes.read_obj("out.obj")[0]
print("OBJ: vertices %d, places %d, first %s" % (len(written), len(set(written)), written[1]))
END
verdict "$(/usr/bin/python3 volumes.py 2> vedo.log)" \
"version: 2023.4.3
cube: closed True, volume 0.0000, area 0.0000; should be 1.0000
cube of triangles: closed True, volume 1.0000, area 6.0000; should be 1.0000
pyramid: closed True, volume 1.0667, area 5.6569; should be 1.3333
pyramid of triangles: closed True, volume 1.3333, area 9.6569; should be 1.3333
torus: closed True, volume 37.2699, area 77.5027; should be 37.2699
torus, inwards: closed True, volume 37.2699, area 77.5027; should be -37.2699
closed square: cells [[0, 1, 2, 3, 0]], length 3
OBJ: vertices 946, places 610, first (1000.1, 1000.0, 999.03)"
