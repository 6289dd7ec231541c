#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# cannon-es 0.20.0 (npm): volume() of ConvexPolyhedron and Trimesh, beside Box and Sphere.
#
# Guess: the volume of a mesh is the one within its faces, or, as an estimate, that of a box or ball around it.
# What happens: that of ConvexPolyhedron and of Trimesh is 4/3 pi r with the radius r of a ball around the origin, and
# not with its cube. A cube of side 2 has 8 as a Box and 7.26 as a polyhedron; made ten times larger it has ten times
# the volume, and moved from the origin it has more. For bodies with r near 1 it looks like the volume of that ball, so
# that an octahedron has three times its own.
#
# Why it matters: parts on both sides of a constriction are told by their volumes, and densities are made from them.
# This one has the unit of a length.
. "$(dirname "$0")/lib/packages.sh"
npm_packages cannon-es@0.20.0

cd "$work"
cat > volumes.mjs << 'END'
import { readFileSync } from 'node:fs';
import { Box, ConvexPolyhedron, Sphere, Trimesh, Vec3 } from 'cannon-es';

for (const [name, points, faces, volume] of JSON.parse(readFileSync('meshes.json'))) {
  const polyhedron = new ConvexPolyhedron({ vertices: points.map(p => new Vec3(...p)), faces });
  const mesh = new Trimesh(points.flat(), faces.flat());
  console.log(`${name}: by the faces ${volume.toFixed(2)}, ConvexPolyhedron ${polyhedron.volume().toFixed(2)}, ` +
              `Trimesh ${mesh.volume().toFixed(2)}`);
}
console.log(`Box ${new Box(new Vec3(1, 1, 1)).volume().toFixed(2)}, Sphere ${new Sphere(2).volume().toFixed(2)}`);
END
cat > volumes.py << 'END'
import json
import meshes

points = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
faces = [f for a, b, c, d in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
         for f in ((a, b, c), (a, c, d))]
bodies = [("cube", points, faces), ("cube, ten times larger", [tuple(10 * c for c in p) for p in points], faces),
          ("cube, moved by 10", [(x + 10, y, z) for x, y, z in points], faces), ("octahedron", *meshes.octahedron())]
with open("meshes.json", "w") as out:
    json.dump([(name, p, f, meshes.volume(p, f)) for name, p, f in bodies], out)
END
python3 volumes.py
verdict "$(node volumes.mjs 2> node.log)" \
"cube: by the faces 8.00, ConvexPolyhedron 7.26, Trimesh 7.26
cube, ten times larger: by the faces 8000.00, ConvexPolyhedron 72.55, Trimesh 72.55
cube, moved by 10: by the faces 8.00, ConvexPolyhedron 46.46, Trimesh 46.46
octahedron: by the faces 1.33, ConvexPolyhedron 4.19, Trimesh 4.19
Box 8.00, Sphere 33.51"
