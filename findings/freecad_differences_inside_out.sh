#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeCAD 0.20.2 (freecad-python3 0.20.2+dfsg1-4), Mesh.unite(), intersect() and difference() of closed meshes.
#
# Guess: the three results of two octahedra that cross, and of two of which one lies within the other, are closed, face
# outwards, and have the volumes of set operations.
# What happens: where the surfaces cross, union and intersection are as guessed. The difference is closed, but faces
# inwards; FreeCAD's own Volume is positive all the same, and the mesh counts as solid. Where one body lies within the
# other, the difference is the outer one with no cavity, the intersection is empty, and the union has both surfaces, so
# that the inner part counts twice. There is no message.
#
# Why it matters: a body with a hole through it, or with a pocket, is made this way, and its necks are then looked for.
# Turned inside out, they are those of the space around it. Only the volume by the faces, with its sign, tells.
. "$(dirname "$0")/lib/freecad.sh"

cd "$work"
cat > sets.py << 'END'
import FreeCAD
import Mesh
import meshes


def octahedron(size, place):
    points, faces = meshes.octahedron()
    moved = [tuple(size * c + p for c, p in zip(q, place)) for q in points]
    return Mesh.Mesh([[moved[i] for i in f] for f in faces])


first = octahedron(1, (0, 0, 0))
for name, second in (("crossing", octahedron(1, (0.31, 0.17, 0.13))), ("nested", octahedron(0.5, (0.01, 0.02, 0.03)))):
    print("%s: volumes %.3f and %.3f" % (name, first.Volume, second.Volume))
    for operation in ("unite", "intersect", "difference"):
        result = getattr(first, operation)(second)
        points = [tuple(p.Vector) for p in result.Points]
        faces = [tuple(f.PointIndices) for f in result.Facets]
        print("%s, %s: faces %d, solid %s, Volume %.3f, by the faces %.3f" % (
            name, operation, len(faces), result.isSolid(), result.Volume, meshes.volume(points, faces)))
END
python3 sets.py > seen.txt
verdict "$(grep -E "crossing|nested" seen.txt)" \
"crossing: volumes 1.333 and 1.333
crossing, unite: faces 32, solid True, Volume 1.899, by the faces 1.899
crossing, intersect: faces 16, solid True, Volume 0.768, by the faces 0.768
crossing, difference: faces 24, solid True, Volume 0.565, by the faces -0.565
nested: volumes 1.333 and 0.167
nested, unite: faces 16, solid True, Volume 1.500, by the faces 1.500
nested, intersect: faces 0, solid True, Volume 0.000, by the faces 0.000
nested, difference: faces 8, solid True, Volume 1.333, by the faces 1.333"
