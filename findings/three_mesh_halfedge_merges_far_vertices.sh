#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# three-mesh-halfedge 1.0.3 (npm) with three.js 0.187.0: HalfedgeDS.setFromGeometry().
#
# Guess: vertices are joined if they are nearer to each other than the tolerance, 1e-10 unless another one is given.
# What happens: a place is looked up by its three coordinates as whole numbers of that tolerance, written one after
# the other with nothing between them. (1, 0, 10) and (10, 1, 0), 13.5 apart, give the same digits, as do (2, 0, 30)
# and (20, 3, 0). Two triangles with these corners have 5 vertices instead of 6, and an edge that is much too long.
# Two tetrahedra end with the error "Vertices v1 and v2 are not free". With the tolerance 1e-3 it is the same; moved
# by 0.5 along each axis both are right.
#
# Why it matters: whole coordinates, and corners in the plane of two axes, are what voxels and drawn bodies have. The
# joined vertex is a shortcut across the body, for any loop.
. "$(dirname "$0")/lib/packages.sh"
npm_packages three@0.187.0 three-mesh-halfedge@1.0.3

cat > "$work/halfedges.mjs" << 'END'
import { BufferGeometry, Float32BufferAttribute } from 'three';
// The package names this file for bundlers, which node does not read.
import { HalfedgeDS } from './node_modules/three-mesh-halfedge/build/index.esm.js';

const triangle = [[0, 1, 2]];
const tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

function show(name, shape, places, tolerance, shift = 0) {
  const soup = places.flatMap(place => {
    const corners = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]].map(c => c.map((x, k) => x + place[k] + shift));
    return shape.flatMap(f => f.flatMap(i => corners[i]));
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(soup, 3));
  const halfedges = new HalfedgeDS();
  let result;
  try {
    halfedges.setFromGeometry(geometry, tolerance);
    const { vertices, faces } = halfedges;
    const longest = Math.max(...halfedges.halfedges.map(h => h.vertex.position.distanceTo(h.twin.vertex.position)));
    result = `vertices ${vertices.length}, faces ${faces.length}, longest edge ${longest.toFixed(2)}`;
  } catch (error) {
    result = error.message;
  }
  console.log(`${name} at ${places.map(p => `(${p})`).join(' and ')}, moved by ${shift}: ${result}`);
}

for (const places of [[[1, 0, 10], [10, 1, 0]], [[2, 0, 30], [20, 3, 0]]]) {
  show('two triangles', triangle, places);
  show('two triangles, tolerance 1e-3,', triangle, places, 1e-3);
  show('two triangles', triangle, places, 1e-10, 0.5);
  show('two tetrahedra', tetrahedron, places);
  show('two tetrahedra', tetrahedron, places, 1e-10, 0.5);
}
END
verdict "$(cd "$work" && node halfedges.mjs)" \
"two triangles at (1,0,10) and (10,1,0), moved by 0: vertices 5, faces 2, longest edge 15.65
two triangles, tolerance 1e-3, at (1,0,10) and (10,1,0), moved by 0: vertices 5, faces 2, longest edge 15.65
two triangles at (1,0,10) and (10,1,0), moved by 0.5: vertices 6, faces 2, longest edge 4.24
two tetrahedra at (1,0,10) and (10,1,0), moved by 0: Vertices v1 and v2 are not free
two tetrahedra at (1,0,10) and (10,1,0), moved by 0.5: vertices 8, faces 8, longest edge 4.24
two triangles at (2,0,30) and (20,3,0), moved by 0: vertices 5, faces 2, longest edge 36.74
two triangles, tolerance 1e-3, at (2,0,30) and (20,3,0), moved by 0: vertices 5, faces 2, longest edge 36.74
two triangles at (2,0,30) and (20,3,0), moved by 0.5: vertices 6, faces 2, longest edge 4.24
two tetrahedra at (2,0,30) and (20,3,0), moved by 0: Vertices v1 and v2 are not free
two tetrahedra at (2,0,30) and (20,3,0), moved by 0.5: vertices 8, faces 8, longest edge 4.24"
