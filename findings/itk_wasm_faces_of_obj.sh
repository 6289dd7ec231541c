#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ITK-Wasm, @itk-wasm/mesh-io 1.7.1 (npm): readMeshNode() and writeMeshNode().
#
# Guess: a mesh that is read from OBJ has the cells that it has when read from OFF, and is written as it was read.
# What happens: from OFF the cells of a torus of 48 triangles are 240 numbers of 32 bits, the greatest one the last
# vertex, 23. From OBJ they are 240 numbers of 64 bits, of which each holds two of the 32 bits, and the greatest one
# is 98784247827 = 23 * 2^32 + 19. Written to OFF or to OBJ, 24 of the 48 faces have no corner, and of the others each
# names a vertex that does not exist. Reading and writing report success. OBJ that was written from OFF is right.
#
# Why it matters: OBJ to OFF is a usual conversion before a mesh is searched for loops. Of these files a reader can
# say at best that vertex 4294967301 is unknown; one that leaves such faces out has none.
. "$(dirname "$0")/lib/packages.sh"
npm_packages @itk-wasm/mesh-io@1.7.1

cd "$work"
cat > convert.mjs << 'END'
import { readMeshNode, writeMeshNode } from '@itk-wasm/mesh-io';

const [input, ...outputs] = process.argv.slice(2);
const mesh = await readMeshNode(input);
const greatest = mesh.cells.reduce((a, b) => a > b ? a : b);
console.log(`read from ${input}: ${mesh.cells.length} numbers in a ${mesh.cells.constructor.name}, greatest ${greatest}`);
for (const output of outputs)
  await writeMeshNode(mesh, output);
process.exit(0);
END
cat > faces.py << 'END'
import subprocess
import meshes

points, faces = meshes.torus(6, 4)
meshes.write_off("torus.off", points, faces)
meshes.write_obj("torus.obj", points, faces)
for name in ("torus.off", "torus.obj"):
    subprocess.run(["node", "convert.mjs", name, "out.off", "out.obj"], check=True)
    with open("out.off") as file:
        words = [line.split() for line in file if line.strip()]
    with open("out.obj") as file:
        of_obj = [tuple(int(i) - 1 for i in line.split()[1:]) for line in file if line.startswith("f")]
    count = int(words[1][0])
    of_off = [tuple(map(int, line[1:])) for line in words[2 + count:]]
    for kind, result in (("OFF", of_off), ("OBJ", of_obj)):
        print("  written to %s: the same faces %s, without a corner %d, with a vertex that does not exist %d" % (
            kind, result == faces, result.count(()), sum(any(i >= len(points) for i in f) for f in result)))
    print("  header of OFF:", " ".join(words[1]))
END
verdict "$(/usr/bin/python3 -u faces.py)" \
"read from torus.off: 240 numbers in a Uint32Array, greatest 23
  written to OFF: the same faces True, without a corner 0, with a vertex that does not exist 0
  written to OBJ: the same faces True, without a corner 0, with a vertex that does not exist 0
  header of OFF: 24 48 0
read from torus.obj: 240 numbers in a BigInt64Array, greatest 98784247827
  written to OFF: the same faces False, without a corner 24, with a vertex that does not exist 24
  written to OBJ: the same faces False, without a corner 24, with a vertex that does not exist 24
  header of OFF: 24 48 0"
