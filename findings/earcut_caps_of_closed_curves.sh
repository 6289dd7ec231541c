#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Earcut 3.2.4, cdt2d 1.0.0 and poly2tri 1.5.0 (npm): triangles for a closed line, as caps on the borders of a mesh.
#
# Guess: the triangles are oriented as the line is, so that a line that runs the other way gives them turned over. With
# "dim" 3 Earcut triangulates a ring in space, or its deviation() tells that it did not.
# What happens: each of them gives triangles oriented counterclockwise in the plane, whichever way the line runs. Of a
# tube whose two borders are capped, one cap faces inwards: 12 edges are run through twice in one direction, and the
# volume by the faces is 3 or 13, depending on where the tube is. Turned over by hand it is 3. With "dim" 3 Earcut looks
# at x and y only. A ring that stands upright gets no triangle at all, and deviation() is 0, as for a right answer.
#
# Why it matters: parts are cut along constrictions and closed by caps, and these are rings of any position in space.
# The caps are missing for those that stand upright, and half of the others face inwards.
. "$(dirname "$0")/lib/packages.sh"
npm_packages earcut@3.2.4 cdt2d@1.0.0 poly2tri@1.5.0

cd "$work"
cat > caps.mjs << 'END'
import { readFileSync } from 'node:fs';
import cdt2d from 'cdt2d';
import earcut, { deviation } from 'earcut';
import poly2tri from 'poly2tri';

const methods = {
  earcut: ring => earcut(ring.flat(), null, ring[0].length),
  cdt2d: ring => cdt2d(ring.map(p => p.slice(0, 2)), ring.map((_, i) => [i, (i + 1) % ring.length]),
                       { exterior: false }).flat(),
  poly2tri: ring => {
    const points = ring.map(([x, y]) => new poly2tri.Point(x, y));
    const context = new poly2tri.SweepContext([...points]).triangulate();
    return context.getTriangles().flatMap(t => t.getPoints().map(p => points.indexOf(p)));
  }
};
const rings = JSON.parse(readFileSync('rings.json'));
const caps = Object.entries(methods).map(([name, method]) => [name, rings.flat.map(method)]);
const upright = methods.earcut(rings.upright[0]);
console.log(JSON.stringify({ caps, upright: [upright, deviation(rings.upright[0].flat(), null, 3, upright)] }));
END
cat > caps.py << 'END'
import json
import math
import subprocess
import meshes

n = 12
for height in (0, 5):
    points = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), z) for z in (height, height + 1)
              for i in range(n)]
    wall = [f for i in range(n) for j in [(i + 1) % n] for f in ((i, j, j + n), (i, j + n, i + n))]
    borders = [list(range(n - 1, -1, -1)), list(range(n, 2 * n))]  # each cap is on the left of its border
    rings = [[points[i] for i in b] for b in borders]
    with open("rings.json", "w") as out:
        json.dump({"flat": rings, "upright": [[(z, x, y) for x, y, z in r] for r in rings]}, out)
    seen = json.loads(subprocess.check_output(["node", "caps.mjs"]))
    for name, caps in seen["caps"]:
        for turned in (False, True):
            faces = list(wall)
            for k, (border, cap) in enumerate(zip(borders, caps)):
                triangles = [tuple(border[i] for i in t) for t in zip(*[iter(cap)] * 3)]
                faces += [t[::-1] for t in triangles] if turned and k == 0 else triangles
            directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
            print("%s, tube from z = %d%s: triangles %s, run through twice in one direction %d, volume %.2f" % (
                name, height, ", first cap turned over" if turned else "", [len(c) // 3 for c in caps],
                len(directed) - len(set(directed)), meshes.volume(points, faces)))
print("earcut, upright ring: triangles %d, deviation %g" % (len(seen["upright"][0]) // 3, seen["upright"][1]))
END
verdict "$(python3 caps.py)" \
"earcut, tube from z = 0: triangles [10, 10], run through twice in one direction 12, volume 3.00
earcut, tube from z = 0, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
cdt2d, tube from z = 0: triangles [10, 10], run through twice in one direction 12, volume 3.00
cdt2d, tube from z = 0, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
poly2tri, tube from z = 0: triangles [10, 10], run through twice in one direction 12, volume 3.00
poly2tri, tube from z = 0, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
earcut, tube from z = 5: triangles [10, 10], run through twice in one direction 12, volume 13.00
earcut, tube from z = 5, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
cdt2d, tube from z = 5: triangles [10, 10], run through twice in one direction 12, volume 13.00
cdt2d, tube from z = 5, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
poly2tri, tube from z = 5: triangles [10, 10], run through twice in one direction 12, volume 13.00
poly2tri, tube from z = 5, first cap turned over: triangles [10, 10], run through twice in one direction 0, volume 3.00
earcut, upright ring: triangles 0, deviation 0"
