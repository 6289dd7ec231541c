#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# conway-hart 0.1.0 (npm): polyhedra by Conway's notation.
#
# Guess: all polyhedra face one way, and faces that are planar by name, as the rhombi of a rhombic triacontahedron, are
# planar.
# What happens: the Platonic solids and all that is made of them face outwards, prisms, antiprisms and pyramids, and
# what is made of them, inwards. The rhombic triacontahedron, "jD", has rhombi that are bent, one corner 0.28 away from
# the plane of the others at edges of 0.58, and so has the rhombic dodecahedron, "jC": the vertices of a dual are at the
# middles of faces, where those of two kinds are not as far out as they have to be.
#
# Why it matters: prisms with known edges are tried first, and are inside out. A bent rhombus has a ridge or a valley on
# its diagonal, depending on how it is cut in two, and closed geodesics go along the valleys.
. "$(dirname "$0")/lib/packages.sh"
npm_packages conway-hart@0.1.0

cd "$work"
cat > solids.cjs << 'END'
const polyhedron = require('conway-hart');

const names = ['T', 'C', 'O', 'I', 'D', 'tI', 'aC', 'P5', 'A5', 'Y5', 'tP5', 'dA5', 'jC', 'jD', 'oD', 'gD'];
console.error = console.log = () => {};
process.stdout.write(JSON.stringify(names.map(name => {
  const { cells, positions } = polyhedron(name);
  return [name, cells, positions];
})));
END
cat > solids.py << 'END'
import json
import math
import subprocess
import meshes


def bend(points):
    """How far a face is from the plane of its first three corners."""
    a, b, c = points[:3]
    u, v = ([q - p for p, q in zip(a, x)] for x in (b, c))
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    return max(abs(sum(x * (q - p) for x, p, q in zip(n, a, point))) for point in points) / math.hypot(*n)


for name, faces, points in json.loads(subprocess.check_output(["node", "solids.cjs"])):
    halves = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]
    edges = [math.dist(points[a], points[b]) for f in faces for a, b in zip(f, f[1:] + f[:1])]
    print("%s: faces %d, volume %.2f, edges from %.2f, faces bent by %.3f" % (
        name, len(faces), meshes.volume(points, halves), min(edges), max(bend([points[i] for i in f]) for f in faces)))
END
verdict "$(python3 solids.py)" \
"T: faces 4, volume 2.67, edges from 2.83, faces bent by 0.000
C: faces 6, volume 2.83, edges from 1.41, faces bent by 0.000
O: faces 8, volume 3.77, edges from 2.00, faces bent by 0.000
I: faces 20, volume 4.12, edges from 1.24, faces bent by 0.000
D: faces 12, volume 3.42, edges from 0.76, faces bent by 0.000
tI: faces 32, volume 2.84, edges from 0.35, faces bent by 0.000
aC: faces 14, volume 2.36, edges from 1.00, faces bent by 0.000
P5: faces 7, volume -2.67, edges from 1.02, faces bent by 0.000
A5: faces 12, volume -3.03, edges from 1.08, faces bent by 0.000
Y5: faces 6, volume -3.02, edges from 1.41, faces bent by 0.000
tP5: faces 17, volume -0.30, edges from 0.17, faces bent by 0.186
dA5: faces 10, volume -0.88, edges from 0.68, faces bent by 0.349
jC: faces 12, volume 1.13, edges from 0.71, faces bent by 0.316
jD: faces 30, volume 2.44, edges from 0.58, faces bent by 0.283
oD: faces 60, volume 2.68, edges from 0.33, faces bent by 0.029
gD: faces 60, volume 3.93, edges from 0.26, faces bent by 0.023"
