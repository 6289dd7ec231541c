#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# three.js 0.187.0 (npm), PLYLoader and OBJLoader, and loaders.gl 4.4.5 (@loaders.gl/ply, npm), PLYLoader, on polygons.
#
# Guess: a polygon with many corners is cut into triangles, and one with a dent is cut inside.
# What happens: both readers of PLY take faces of three and four corners and leave out all others, with no word: of a
# prism over a pentagon the two ends are missing, and it is an open tube. Four corners are cut by a fixed diagonal, and
# OBJLoader cuts any face into a fan around its first corner. Where the dent is at the last corner the diagonal of
# three.js runs outside of the face: one triangle covers the dent, the other is turned over, and the surface of a prism
# has an area of 22.1 instead of 14.1. loaders.gl takes the other diagonal, and is wrong where the dent is next to that
# corner.
#
# Why it matters: an open tube is another surface than a prism, and ends that are folded over lie outside of the body.
# The program here cuts each polygon inside (test Repair.polygons_that_are_not_convex_are_cut_inside).
. "$(dirname "$0")/lib/packages.sh"
npm_packages three@0.187.0 @loaders.gl/ply@4.4.5

cd "$work"
cat > polygons.py << 'END'
import json
import math
import subprocess
import meshes


def prism(outline):
    n = len(outline)
    sides = [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    return [(x, y, z) for z in (0, 1) for x, y in outline], [(0,) + tuple(range(n - 1, 0, -1)), tuple(range(n, 2 * n))] + sides


def area(points, faces):
    total = 0
    for a, b, c in ((points[i] for i in f) for f in faces):
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return total


pentagon = [(math.cos(2 * math.pi * i / 5), math.sin(2 * math.pi * i / 5)) for i in range(5)]
dented = [(-2, 2), (0, 0), (2, 2), (0, 1)]  # the dent is the last corner
for name, outline in (("pentagon", pentagon), ("dented", dented), ("dented, turned on", dented[1:] + dented[:1])):
    points, faces = prism(outline)
    meshes.write_obj("prism.obj", points, faces)
    with open("prism.ply", "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
                  "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (len(points), len(faces)))
        out.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
        out.writelines("%d %s\n" % (len(f), " ".join(map(str, f))) for f in faces)
    for reader, corners in json.loads(subprocess.check_output(["node", "read.mjs"])).items():
        number, triangles = {}, []
        for i in range(0, len(corners), 3):
            triangles.append(tuple(number.setdefault(tuple(c), len(number)) for c in corners[i:i + 3]))
        print("%s, %s: F %d, border edges %s, area %.1f" % (
            name, reader, len(triangles), meshes.describe(triangles).split("border edges ")[1].split(",")[0],
            area(list(number), triangles)))
END
cat > read.mjs << 'END'
import { readFileSync } from 'node:fs';
import { PLYLoader as OtherLoader } from '@loaders.gl/ply';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

const corners = (values, indices) => [...indices].map(i => [...values.slice(3 * i, 3 * i + 3)]);
const ply = readFileSync('prism.ply', 'utf8');
const mesh = new PLYLoader().parse(ply);
const other = await OtherLoader.parse(new TextEncoder().encode(ply).buffer, {});
const obj = new OBJLoader().parse(readFileSync('prism.obj', 'utf8')).children[0].geometry.attributes.position;
console.log(JSON.stringify({
  'three PLY': corners(mesh.attributes.position.array, mesh.index.array),
  'loaders.gl PLY': corners(other.attributes.POSITION.value, other.indices.value),
  'three OBJ': corners(obj.array, Array.from({ length: obj.count }, (_, i) => i)),
}));
END
verdict "$(python3 polygons.py)" \
"pentagon, three PLY: F 10, border edges 10, area 5.9
pentagon, loaders.gl PLY: F 10, border edges 10, area 5.9
pentagon, three OBJ: F 16, border edges 0, area 10.6
dented, three PLY: F 12, border edges 0, area 22.1
dented, loaders.gl PLY: F 12, border edges 0, area 14.1
dented, three OBJ: F 12, border edges 0, area 22.1
dented, turned on, three PLY: F 12, border edges 0, area 14.1
dented, turned on, loaders.gl PLY: F 12, border edges 0, area 22.1
dented, turned on, three OBJ: F 12, border edges 0, area 14.1"
