#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# three.js 0.187.0 (npm), VTKLoader, on points of doubles.
#
# Guess: a legacy VTK file whose header says "POINTS 6 double" is read as doubles and rounded to floats, or is refused.
# What happens: as text it is so. In binary the type is not looked at: the bytes of the doubles are read as floats. An
# octahedron of size 1 comes back, as success, with six points that are up to 1.5e13 away, and with its eight triangles.
#
# Why it matters: VTK writes doubles in binary wherever its points are doubles, as those of certified curves and parts
# are. Nothing but the size of the picture tells that another surface is shown. (The loader is deprecated, which it says.)
. "$(dirname "$0")/lib/packages.sh"
npm_packages three@0.187.0

cd "$work"
cat > octahedron.py << 'END'
import struct
import meshes

points, faces = meshes.octahedron()
points = [tuple(x + 1 / 3 for x in p) for p in points]
numbers = [x for p in points for x in p]
head = "# vtk DataFile Version 4.2\noctahedron\n%s\nDATASET POLYDATA\nPOINTS 6 %s\n"
cells = [n for f in faces for n in (3,) + f]
with open("text.vtk", "w") as out:
    out.write(head % ("ASCII", "double") + " ".join(map(repr, numbers)) + "\nPOLYGONS 8 32\n" +
              "".join("3 %d %d %d\n" % f for f in faces))
for kind, code in ("float", "f"), ("double", "d"):
    with open(kind + ".vtk", "wb") as out:
        out.write((head % ("BINARY", kind)).encode() + struct.pack(">18" + code, *numbers) + b"\nPOLYGONS 8 32\n" +
                  struct.pack(">32i", *cells) + b"\n")

END
cat > read.mjs << 'END'
import { readFileSync } from 'node:fs';
import { VTKLoader } from 'three/addons/loaders/VTKLoader.js';

for (const name of ['text.vtk', 'float.vtk', 'double.vtk']) {
  const data = readFileSync(name);
  const { attributes, index } = new VTKLoader().parse(data.buffer.slice(data.byteOffset, data.byteOffset + data.length));
  const far = Math.max(...attributes.position.array.map(Math.abs));
  console.log(`${name}: ${attributes.position.count} points up to ${far.toPrecision(6)}, ${index.count / 3} triangles`);
}
END
python3 octahedron.py
verdict "$(node read.mjs 2> three.log)" "text.vtk: 6 points up to 1.33333, 8 triangles
float.vtk: 6 points up to 1.33333, 8 triangles
double.vtk: 6 points up to 1.46602e+13, 8 triangles"
