#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# alpha-shape 1.0.0 with convex-hull 1.0.3 (npm): surfaces of clouds of points.
#
# Guess: a larger alpha lets larger tetrahedra in, and the largest gives the convex hull, oriented as that of
# convex-hull, which is by the same author.
# What happens: it is the other way: a tetrahedron is in if its circumradius is below 1 / alpha, so that 0 gives nearly
# the hull, and a cloud ten times as large needs a tenth of alpha. Alpha 1 gives a ring, and for the larger cloud
# nothing. The surface faces inwards, its volume is negative, while the hull faces outwards.
#
# Why it matters: the ring is what one wants of these points, a closed surface with two kinds of loops, and it comes
# inside out. The side on which a curve chokes is the other one then.
. "$(dirname "$0")/lib/packages.sh"
npm_packages alpha-shape@1.0.0 convex-hull@1.0.3

cd "$work"
cat > shapes.cjs << 'END'
const alphaShape = require('alpha-shape');
const convexHull = require('convex-hull');

const points = [];
for (let i = 1; i <= 300; ++i) {  // in a ring around the z-axis
  const a = i * 2.399, r = 2 + 0.6 * Math.sin(i * i), z = 0.6 * Math.cos(7 * i);
  points.push([r * Math.cos(a), r * Math.sin(a), z].map(x => Math.round(1e6 * x) / 1e6));
}
const shapes = [['convex-hull', convexHull(points)]];
for (const alpha of [0, 0.001, 0.01, 0.1, 0.5, 1]) {
  shapes.push([`alpha ${alpha}`, alphaShape(alpha, points)]);
}
const larger = points.map(p => p.map(x => 10 * x));
for (const alpha of [1, 0.1]) {
  shapes.push([`alpha ${alpha}, ten times as large`, alphaShape(alpha, larger)]);
}
console.log(JSON.stringify({ points, shapes }));
END
cat > shapes.py << 'END'
import json
import subprocess
import meshes

seen = json.loads(subprocess.check_output(["node", "shapes.cjs"]))
for name, faces in seen["shapes"]:
    print("%s: %s, volume %.2f" % (name, meshes.describe(faces), meshes.volume(seen["points"], faces)))
END
verdict "$(python3 shapes.py)" \
"convex-hull: V 82, F 160, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, volume 23.66
alpha 0: V 77, F 150, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, volume -23.60
alpha 0.001: V 83, F 166, components 1, Euler characteristic 3, border edges 0, non-manifold edges 3, volume -23.60
alpha 0.01: V 91, F 178, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, volume -23.62
alpha 0.1: V 108, F 212, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, volume -23.41
alpha 0.5: V 141, F 278, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0, volume -22.69
alpha 1: V 194, F 388, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume -15.19
alpha 1, ten times as large: V 0, F 0, components 0, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 0.00
alpha 0.1, ten times as large: V 194, F 388, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume -15.19"
