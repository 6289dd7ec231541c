#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# three.js 0.187.0 (npm): SphereGeometry, CapsuleGeometry, LatheGeometry, mergeVertices(), STLExporter.
#
# Guess: the ready-made closed shapes are closed and without faces of area zero once corners at one place are merged.
# What happens: that holds for the sphere, whose poles are made of single triangles, and not for the capsule and for
# surfaces of revolution that begin or end on the axis: there both triangles of each quadrilateral are kept, and at each
# pole as many triangles as the shape has segments have two corners at one place, and touch as edges of more than two
# faces. mergeVertices() takes its tolerance as an absolute length, 1e-4: a sphere of radius 2e-5 becomes one vertex.
#
# Why it matters: a capsule is the first test body with a waist that one would draw. The exported STL has 24 degenerate
# faces, and a reader that does not leave them out finds no closed surface.
. "$(dirname "$0")/lib/packages.sh"
npm_packages three@0.187.0

cd "$work"
cat > shapes.mjs << 'END'
import * as THREE from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

function describe(geometry) {
  geometry.deleteAttribute('normal');
  geometry.deleteAttribute('uv');
  const index = mergeVertices(geometry).index.array, edges = new Map();
  let flat = 0;
  for (let i = 0; i < index.length; i += 3) {
    const corners = [...index.slice(i, i + 3)];
    flat += new Set(corners).size < 3;
    for (let k = 0; k < 3; ++k) {
      const edge = [corners[k], corners[(k + 1) % 3]].sort((a, b) => a - b).join();
      edges.set(edge, (edges.get(edge) || 0) + 1);
    }
  }
  const count = test => [...edges.values()].filter(test).length;
  return `V ${new Set(index).size}, F ${index.length / 3}, with two corners at one place ${flat}, ` +
    `border edges ${count(n => n === 1)}, non-manifold edges ${count(n => n > 2)}`;
}

const profile = [new THREE.Vector2(0, -1), new THREE.Vector2(1, 0), new THREE.Vector2(0, 1)];
console.log('sphere:', describe(new THREE.SphereGeometry(1, 12, 8)));
console.log('capsule:', describe(new THREE.CapsuleGeometry(1, 2, 6, 12)));
console.log('lathe:', describe(new THREE.LatheGeometry(profile, 12)));
const stl = new STLExporter().parse(new THREE.Mesh(new THREE.CapsuleGeometry(1, 2, 6, 12)), { binary: true });
console.log('capsule through STL:', describe(new STLLoader().parse(stl.buffer)));
console.log('sphere of radius 2e-5:', describe(new THREE.SphereGeometry(2e-5, 12, 8)));
END
verdict "$(node shapes.mjs)" \
"sphere: V 86, F 168, with two corners at one place 0, border edges 0, non-manifold edges 0
capsule: V 146, F 312, with two corners at one place 24, border edges 0, non-manifold edges 26
lathe: V 14, F 48, with two corners at one place 24, border edges 0, non-manifold edges 26
capsule through STL: V 146, F 312, with two corners at one place 24, border edges 0, non-manifold edges 26
sphere of radius 2e-5: V 1, F 168, with two corners at one place 168, border edges 0, non-manifold edges 1"
