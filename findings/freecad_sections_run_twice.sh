#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeCAD 0.20.2 (freecad-python3 0.20.2+dfsg1-4), Mesh.crossSections().
#
# Guess: the section of an octahedron through its middle is a closed square with sides of the length 1.414, also where
# the plane runs along edges of the mesh.
# What happens: it is one closed line that runs around the square twice, nine points instead of five, and of twice the
# length. The two circles of a torus that lies flat are twice as long as well. A plane a little beside, and one through
# vertices but not along edges, give each line once. The parameters for the smallest distance and for joining change
# nothing.
#
# Why it matters: the length of the closed line is what one measures at a waist, and the waist of a mesh that was built
# symmetrically, or by turning a profile, lies on its edges. That the line closes is no sign that it does so once.
. "$(dirname "$0")/lib/freecad.sh"

cd "$work"
cat > sections.py << 'END'
import math
import FreeCAD
import Mesh
import meshes

for body, height, normal, where in (("octahedron", 0, (0, 0, 1), "along four edges"),
                                    ("octahedron", 0.1, (0, 0, 1), "beside them"),
                                    ("octahedron", 0, (1, -1, 0), "through two vertices"),
                                    ("torus", 0, (0, 0, 1), "along edges"), ("torus", 0.1, (0, 0, 1), "beside them")):
    points, faces = getattr(meshes, body)()
    mesh = Mesh.Mesh([[tuple(map(float, points[i])) for i in f] for f in faces])
    for parameters in ((), (1e-6, True)):
        for line in mesh.crossSections([((0, 0, height), normal)], *parameters)[0]:
            print("%s, %s%s: %d points at %d places, closed %s, length %.3f" % (
                body, where, " with parameters" if parameters else "", len(line),
                len({tuple(round(c, 4) for c in p) for p in line}), (line[0] - line[-1]).Length < 1e-6,
                sum((p - q).Length for p, q in zip(line, line[1:]))))
END
verdict "$(python3 sections.py | grep closed)" \
"octahedron, along four edges: 9 points at 4 places, closed True, length 11.314
octahedron, along four edges with parameters: 9 points at 4 places, closed True, length 11.314
octahedron, beside them: 5 points at 4 places, closed True, length 5.091
octahedron, beside them with parameters: 5 points at 4 places, closed True, length 5.091
octahedron, through two vertices: 5 points at 4 places, closed True, length 4.899
octahedron, through two vertices with parameters: 5 points at 4 places, closed True, length 4.899
torus, along edges: 49 points at 24 places, closed True, length 37.592
torus, along edges: 49 points at 24 places, closed True, length 12.531
torus, along edges with parameters: 49 points at 24 places, closed True, length 37.592
torus, along edges with parameters: 49 points at 24 places, closed True, length 12.531
torus, beside them: 49 points at 48 places, closed True, length 18.628
torus, beside them: 49 points at 48 places, closed True, length 6.433
torus, beside them with parameters: 49 points at 48 places, closed True, length 18.628
torus, beside them with parameters: 49 points at 48 places, closed True, length 6.433"
