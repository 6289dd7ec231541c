#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# primitive-geometry 2.11.0 (npm): tetrahedron() and icosahedron(), and cells of box() and cube().
#
# Guess: tetrahedron() is the regular one, four triangles in a sphere of the given radius around the origin; each cell
# of a mesh is three numbers.
# What happens: it is a cone over a triangle, of the height of 3/2 of the radius: the edges of the base are 1.732 of the
# radius, the others 1.803. After merging of equal places it has five vertices and six triangles, since there is one in
# the middle of the base, and none of the five is at the given radius. The icosahedron is the regular one. The cells of
# box() are four corners each, those of all others three: read as triangles the closed box becomes five triangles with
# eleven border edges, and three that are degenerate.
#
# Why it matters: the regular tetrahedron is the body of which all closed geodesics are known, and so the one that a
# program for them is tried on. On this one lengths that should be equal differ, and one thinks the program is at fault.
. "$(dirname "$0")/lib/packages.sh"
npm_packages primitive-geometry@2.11.0

cd "$work"
cat > solids.mjs << 'END'
import * as primitives from 'primitive-geometry';

const names = ['tetrahedron', 'icosahedron', 'cube', 'box'];
console.log(JSON.stringify(names.map(name => {
  const { positions, cells } = primitives[name]({ radius: 1 });
  return [name, [...positions], [...cells]];
})));
END
cat > solids.py << 'END'
import json
import math
import subprocess
import meshes


def rounded(values):
    return ", ".join("%.3f" % x for x in sorted({round(x, 3) for x in values}))


for name, positions, cells in json.loads(subprocess.check_output(["node", "solids.mjs"])):
    ids = {}
    places = [tuple(round(c, 6) + 0.0 for c in p) for p in zip(*[iter(positions)] * 3)]
    merged = [ids.setdefault(p, len(ids)) for p in places]
    points = list(ids)
    for size in (3, 4) if name == "box" else (3,):
        faces = [tuple(merged[i] for i in c) for c in zip(*[iter(cells)] * size)]
        faces = [f for f in faces if len(set(f)) == size]
        print("%s, cells of %d: %s" % (name, size, meshes.describe(faces)))
    if size == 3:
        print("  lengths of edges %s; distances from the origin %s" % (
            rounded(math.dist(points[a], points[b]) for f in faces for a, b in zip(f, f[1:] + f[:1])),
            rounded(math.hypot(*p) for p in points)))
END
verdict "$(python3 solids.py)" \
"tetrahedron, cells of 3: V 5, F 6, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  lengths of edges 1.000, 1.732, 1.803; distances from the origin 0.750, 1.250
icosahedron, cells of 3: V 12, F 20, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  lengths of edges 1.051; distances from the origin 1.000
cube, cells of 3: V 8, F 12, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
  lengths of edges 1.000, 1.414; distances from the origin 0.866
box, cells of 3: V 8, F 5, components 1, Euler characteristic 0, border edges 11, non-manifold edges 0
box, cells of 4: V 8, F 6, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0"
