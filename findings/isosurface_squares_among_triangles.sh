#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# isosurface 1.0.0 (npm): marchingCubes(), marchingTetrahedra() and surfaceNets() of a ball.
#
# Guess: the cells are triangles that share their vertices, by all three methods, and make a closed surface.
# What happens: those of marchingTetrahedra are triangles and quadrilaterals mixed. Who takes three corners of each gets
# a ball with holes, and a fifth of its volume is missing; with all corners the volume is right. Only surfaceNets shares
# all vertices. marchingCubes shares some and marchingTetrahedra none at all, so that the surface comes in 746 and 3488
# pieces; with equal places joined it is closed by each method.
#
# Why it matters: a typed array of corners is built from such cells by taking the first three, and nothing fails. A
# surface of many pieces has no closed curve but those around a piece.
. "$(dirname "$0")/lib/packages.sh"
npm_packages isosurface@1.0.0

cd "$work"
cat > surfaces.cjs << 'END'
const methods = require('isosurface');
const ball = (x, y, z) => x * x + y * y + z * z - 1;
console.log(JSON.stringify(['marchingCubes', 'marchingTetrahedra', 'surfaceNets'].map(name =>
  [name, methods[name]([21, 21, 21], ball, [[-1.61, -1.61, -1.61], [1.61, 1.61, 1.61]])])));
END
cat > surfaces.py << 'END'
import json
import subprocess
import meshes

for name, mesh in json.loads(subprocess.check_output(["node", "surfaces.cjs"])):
    points, cells = [tuple(p) for p in mesh["positions"]], [tuple(c) for c in mesh["cells"]]
    print("%s: cells with three corners %d, with four %d; volume of three corners of each %.2f, of all %.2f" % (
        name, sum(len(c) == 3 for c in cells), sum(len(c) == 4 for c in cells),
        meshes.volume(points, [c[:3] for c in cells]),
        meshes.volume(points, [(c[0], c[i], c[i + 1]) for c in cells for i in range(1, len(c) - 1)])))
    places = {}
    joined = [places.setdefault(tuple(round(c, 9) + 0.0 for c in p), len(places)) for p in points]
    print("  as it is:", meshes.describe(cells))
    print("  places joined:", meshes.describe([tuple(joined[i] for i in c) for c in cells]))
    print("  three corners of each:", meshes.describe([tuple(joined[i] for i in c[:3]) for c in cells]))
END
verdict "$(python3 surfaces.py)" \
"marchingCubes: cells with three corners 1484, with four 0; volume of three corners of each 4.12, of all 4.12
  as it is: V 2976, F 1484, components 746, Euler characteristic 746, border edges 2976, non-manifold edges 0
  places joined: V 744, F 1484, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  three corners of each: V 744, F 1484, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
marchingTetrahedra: cells with three corners 2440, with four 1048; volume of three corners of each 3.22, of all 4.12
  as it is: V 11512, F 3488, components 3488, Euler characteristic 3488, border edges 11512, non-manifold edges 0
  places joined: V 2270, F 3488, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  three corners of each: V 2270, F 3488, components 1, Euler characteristic -960, border edges 2972, non-manifold edges 0
surfaceNets: cells with three corners 1488, with four 0; volume of three corners of each 4.06, of all 4.06
  as it is: V 746, F 1488, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  places joined: V 746, F 1488, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  three corners of each: V 746, F 1488, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0"
