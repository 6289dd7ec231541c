#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Manifold 3.5.4 (manifold-3d 3.5.4, npm): a mesh put in and taken out with no operation in between; genus().
#
# Guess: new Manifold(mesh).getMesh() gives vertices and triangles in the order in which they came; genus() of two cubes
# that touch along an edge is 0, or that of the two is added up, 0 as well.
# What happens: vertices and triangles are sorted along a space-filling curve, at once; the same triangles with the same
# orientation, under other numbers. genus() is 1 - (Euler characteristic) / 2, also for several bodies: -1 for two
# cubes. The two keep a copy of the edge each, 16 vertices at 14 places: a file of it that merges places, STL, has an
# edge of four faces.
#
# Why it matters: curves given by numbers of faces or vertices, loops for "tighten", labels, belong to the mesh before.
# And "genus 0, so each curve separates" is no test on a surface with components. This package counts the genus of each
# component.
. "$(dirname "$0")/lib/manifold.sh"

cd "$work"
cat > through.mjs << 'END'
import { readFileSync } from 'node:fs';
import Module from 'manifold-3d';

const { setup, Manifold, Mesh } = await Module().then(m => (m.setup(), m));
const [points, faces] = JSON.parse(readFileSync('torus.json'));
const properties = new Float32Array(points.flat()), triangles = new Uint32Array(faces.flat());
const out = new Manifold(new Mesh({ numProp: 3, vertProperties: properties, triVerts: triangles })).getMesh();
const place = (data, i) => data.slice(3 * i, 3 * i + 3).join(' ');
const names = (data, t) => {
  const result = [];
  for (let i = 0; i < t.length; i += 3) {
    const corners = [0, 1, 2].map(k => place(data, t[i + k]));
    const first = corners.indexOf([...corners].sort()[0]);
    result.push([0, 1, 2].map(k => corners[(first + k) % 3]).join(', '));
  }
  return result;
};
const before = names(properties, triangles), after = names(out.vertProperties, out.triVerts);
const same = (a, b) => a.join() === b.join();
const set = same([...before].sort(), [...after].sort());
console.log(`triangles: the same set ${set}, in the same order ${same(before, after)}`);
console.log(`vertices in the same order: ${same([...properties], [...out.vertProperties])}`);
const cube = Manifold.cube([1, 1, 1]), two = cube.add(cube.translate([1, 1, 0])), mesh = two.getMesh();
const places = new Set();
for (let i = 0; i < mesh.vertProperties.length / 3; ++i)
  places.add(place(mesh.vertProperties, i));
console.log(`two cubes: genus ${two.genus()}, bodies ${two.decompose().length}, ` +
  `${two.numVert()} vertices at ${places.size} places, status ${two.status()}`);
END
verdict "$(node through.mjs)" "triangles: the same set true, in the same order false
vertices in the same order: false
two cubes: genus -1, bodies 2, 16 vertices at 14 places, status NoError"
