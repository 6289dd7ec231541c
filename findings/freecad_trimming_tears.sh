#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeCAD 0.20.2 (freecad-python3 0.20.2+dfsg1-4), Mesh.trimByPlane(), and fillupHoles() after it.
#
# Guess: the part of a torus that lies flat on one side of a plane is one piece with two circles as borders, and with
# the holes filled it is closed. Which side is kept makes no difference.
# What happens: the triangles that the plane cuts do not share the points they have in common with those it does not
# cut. A torus cut a little above the middle comes in three pieces with 192 border edges instead of 96, and filling the
# holes closes each piece by itself with walls inside of the body: three closed bodies, and FreeCAD calls the result
# solid. Through the middle the part below is torn and the one above is not. After removeDuplicatedPoints() it is as
# guessed: one piece, two borders.
#
# Why it matters: one trims a mesh to look at a part of it, and then counts pieces, measures borders or looks for closed
# curves. Here borders run through the middle of the part, and a check for a solid does not notice the walls.
. "$(dirname "$0")/lib/freecad.sh"

cd "$work"
cat > trim.py << 'END'
import FreeCAD
import Mesh
import meshes

points, faces = meshes.torus()
whole = [[tuple(map(float, points[i])) for i in f] for f in faces]
for height in (0.2, 0):
    for side, name in ((1, "below"), (-1, "above")):
        part = Mesh.Mesh(whole)
        part.trimByPlane(FreeCAD.Vector(0, 0, height), FreeCAD.Vector(0, 0, side))
        filled, joined = part.copy(), part.copy()
        filled.fillupHoles(1000)
        joined.removeDuplicatedPoints()
        for kind, mesh in (("trimmed", part), ("points joined", joined), ("holes filled", filled)):
            print("%s %g, %s: %s; solid %s" % (
                name, height, kind, meshes.describe([tuple(f.PointIndices) for f in mesh.Facets]), mesh.isSolid()))
END
python3 trim.py > seen.txt
verdict "$(grep Euler seen.txt)" \
"below 0.2, trimmed: V 312, F 432, components 3, Euler characteristic 0, border edges 192, non-manifold edges 0; solid False
below 0.2, points joined: V 264, F 432, components 1, Euler characteristic 0, border edges 96, non-manifold edges 0; solid False
below 0.2, holes filled: V 312, F 612, components 3, Euler characteristic 6, border edges 0, non-manifold edges 0; solid True
above 0.2, trimmed: V 264, F 336, components 3, Euler characteristic 0, border edges 192, non-manifold edges 0; solid False
above 0.2, points joined: V 216, F 336, components 1, Euler characteristic 0, border edges 96, non-manifold edges 0; solid False
above 0.2, holes filled: V 264, F 516, components 3, Euler characteristic 6, border edges 0, non-manifold edges 0; solid True
below 0, trimmed: V 192, F 288, components 2, Euler characteristic 0, border edges 96, non-manifold edges 0; solid False
below 0, points joined: V 168, F 288, components 1, Euler characteristic 0, border edges 48, non-manifold edges 0; solid False
below 0, holes filled: V 192, F 376, components 2, Euler characteristic 4, border edges 0, non-manifold edges 0; solid True
above 0, trimmed: V 168, F 288, components 1, Euler characteristic 0, border edges 48, non-manifold edges 0; solid False
above 0, points joined: V 168, F 288, components 1, Euler characteristic 0, border edges 48, non-manifold edges 0; solid False
above 0, holes filled: V 168, F 332, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; solid True"
