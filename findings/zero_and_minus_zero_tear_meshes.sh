#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# glTF-Transform 4.5.1 (npm), weld(), and Draco 1.5.5 (draco 1.5.5+dfsg-2), draco_encoder of STL.
#
# Guess: corners at one place become one vertex.
# What happens: both compare bit patterns, and 0 and -0 have different ones. An octahedron as a triangle soup in which
# one half was made by mirroring, with coordinates -0, falls into two halves along the plane y = 0: ten vertices instead
# of six, eight border edges. Without -0 both give the closed octahedron. The next surprise of Draco: with its 11 bits
# the middle of [-1, 1] is no step, and the coordinate 0, where the plane of symmetry was, comes back as 0.000489.
#
# Why it matters: bodies with a plane of symmetry are made by mirroring, and -0 is what a negation leaves; the cut runs
# through every neck. The reader of STL here takes 0 and -0 for one coordinate (test
# Mesh_file.stl_merges_equal_positions_only).
. "$(dirname "$0")/lib/packages.sh"
debian draco=1.5.5+dfsg-2
npm_packages @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1

cd "$work"
cat > soup.py << 'END'
import json
import subprocess
import meshes

points, faces = meshes.octahedron()
plain = [[tuple(map(float, points[i])) for i in f] for f in faces]
mirrored = [[(x, -abs(y), z) for x, y, z in t] if any(y < 0 for x, y, z in t) else t for t in plain]
for name, soup in (("plain", plain), ("mirrored", mirrored)):
    with open("soup.json", "w") as out:
        json.dump([c for t in soup for p in t for c in p], out)
    indices = json.loads(subprocess.check_output(["node", "weld.mjs"]))
    print("%s, weld():" % name, meshes.describe([tuple(indices[i:i + 3]) for i in range(0, len(indices), 3)]))
    meshes.write_stl("soup.stl", soup)
    for arguments in (["draco_encoder", "-i", "soup.stl", "-o", "soup.drc"],
                      ["draco_decoder", "-i", "soup.drc", "-o", "soup.obj"]):
        subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)
    places, triangles = meshes.read_obj("soup.obj")
    print("%s, Draco: %s" % (name, meshes.describe(triangles)))
    print("%s, Draco: coordinates %s" % (name, sorted({c for p in places for c in p})))
END
cat > weld.mjs << 'END'
import { readFileSync } from 'node:fs';
import { Document } from '@gltf-transform/core';
import { weld } from '@gltf-transform/functions';

// JSON.parse() keeps the sign of -0.
const positions = new Float32Array(JSON.parse(readFileSync('soup.json')));
const document = new Document();
const accessor = document.createAccessor().setType('VEC3').setArray(positions).setBuffer(document.createBuffer());
const primitive = document.createPrimitive().setAttribute('POSITION', accessor);
document.createMesh().addPrimitive(primitive);
await document.transform(weld());
console.log(JSON.stringify([...primitive.getIndices().getArray()]));
END
verdict "$(python3 soup.py)" \
"plain, weld(): V 6, F 8, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
plain, Draco: V 6, F 8, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
plain, Draco: coordinates [-1.0, 0.000489, 1.0]
mirrored, weld(): V 10, F 8, components 2, Euler characteristic 2, border edges 8, non-manifold edges 0
mirrored, Draco: V 10, F 8, components 2, Euler characteristic 2, border edges 8, non-manifold edges 0
mirrored, Draco: coordinates [-1.0, 0.000489, 1.0]"
