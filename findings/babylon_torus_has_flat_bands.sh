#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Babylon.js 9.35.0 (npm, @babylonjs/core), MeshBuilder.CreateTorus(), beside CreateTorusKnot(), and TorusGeometry of
# three.js 0.187.0.
#
# Guess: vertices are there twice along the seams, where texture coordinates jump, so that the surface has borders
# there; with equal places joined it is a closed torus, as it is in three.js.
# What happens: the knot is as guessed, the torus is not. Its last row of vertices is the first one again but for the
# last digits, and there are faces between the two: a torus of 24 segments has 25 times 25 squares. By the numbers of
# its vertices it is closed, which the others are not, with Euler characteristic 0. But 98 triangles are less than 1e-15
# wide, two bands along both directions of the torus, and where near places are joined 49 edges have four faces or more.
#
# Why it matters: a torus is what one tests closed geodesics on. That it is closed as it comes invites to take the
# numbers as they are, and no triangle is degenerate by exact numbers. The mesh has a closed geodesic more than the same
# torus without the bands; whoever joins near places is told that it is no manifold.
. "$(dirname "$0")/lib/packages.sh"
npm_packages @babylonjs/core@9.35.0 three@0.187.0

cd "$work"
cat > shapes.mjs << 'END'
import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { MeshBuilder } from '@babylonjs/core/Meshes/meshBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';
import { TorusGeometry } from 'three';
import { writeFileSync } from 'node:fs';

const scene = new Scene(new NullEngine());
const meshes = {};
for (const tessellation of [24, 48]) {
  const torus = MeshBuilder.CreateTorus('torus', { diameter: 4, thickness: 2, tessellation }, scene);
  meshes[`Babylon.js, torus of ${tessellation}`] = [torus.getVerticesData('position'), torus.getIndices()];
}
const knot = MeshBuilder.CreateTorusKnot('knot', { radialSegments: 64, tubularSegments: 12 }, scene);
meshes['Babylon.js, knot'] = [knot.getVerticesData('position'), knot.getIndices()];
const other = new TorusGeometry(2, 1, 24, 24);
meshes['three.js, torus of 24'] = [other.attributes.position.array, other.index.array];
writeFileSync('meshes.json', JSON.stringify(Object.entries(meshes).map(([name, lists]) =>
  [name, ...lists.map(list => [...list])])));
END
node shapes.mjs > node.log
cat > shapes.py << 'END'
import json
import math
import meshes


def width(corners):
    a, b, c = corners
    u, v = ([q - p for p, q in zip(a, x)] for x in (b, c))
    area = math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return 2 * area / max(math.dist(p, q) for p, q in ((a, b), (b, c), (c, a)))


for name, flat, numbers in json.load(open("meshes.json")):
    points, faces = list(zip(*[iter(flat)] * 3)), list(zip(*[iter(numbers)] * 3))
    places = {}
    joined = [places.setdefault(tuple(round(c, 5) + 0.0 for c in p), len(places)) for p in points]
    print("%s: %s; less than 1e-15 wide %d" % (name, meshes.describe(faces), sum(
        width([points[i] for i in f]) < 1e-15 for f in faces)))
    print("  with places joined:", meshes.describe([tuple(joined[i] for i in f) for f in faces]))
END
verdict "$(python3 shapes.py)" \
"Babylon.js, torus of 24: V 625, F 1250, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; less than 1e-15 wide 98
  with places joined: V 576, F 1250, components 1, Euler characteristic 51, border edges 0, non-manifold edges 49
Babylon.js, torus of 48: V 2401, F 4802, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; less than 1e-15 wide 194
  with places joined: V 2304, F 4802, components 1, Euler characteristic 99, border edges 0, non-manifold edges 97
Babylon.js, knot: V 780, F 1536, components 1, Euler characteristic 0, border edges 24, non-manifold edges 0; less than 1e-15 wide 0
  with places joined: V 768, F 1536, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
three.js, torus of 24: V 625, F 1152, components 1, Euler characteristic 1, border edges 96, non-manifold edges 0; less than 1e-15 wide 0
  with places joined: V 576, F 1152, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0"
