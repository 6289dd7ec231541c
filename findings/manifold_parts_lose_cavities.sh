#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Manifold 3.5.4 (manifold-3d 3.5.4, npm): decompose(), and compose(), which by its documentation is the inverse.
#
# Guess: the parts of a body with a cavity are one part, or two that compose() puts together to the same body. A surface
# that faces inwards is an error, as it bounds no solid.
# What happens: of a ball with a cavity there are two parts, the outside with the volume 3.83 and the cavity as a body
# of the volume -0.48, which has the status "NoError". Put together they are 3.83: the cavity is gone. Their union is
# the same, and subtracting the cavity adds it, 4.31. Two bodies side by side come back as they were. A torus that faces
# inwards is taken without an error; the union of it and a cube around it is the cube, the cube without it the sum of
# both.
#
# Why it matters: parts of a mesh are taken one by one, and put together after each was looked at for its necks.
# Cavities and what lies in them are then filled, with no word; and a volume below zero is the only sign of a mesh
# inside out.
. "$(dirname "$0")/lib/manifold.sh"

cd "$work"
cat > parts.mjs << 'END'
import { readFileSync } from 'node:fs';
import Module from 'manifold-3d';

const { Manifold, Mesh } = await Module().then(m => (m.setup(), m));
const text = list => list.map(part => part.volume().toFixed(2)).join(' and ');
const cube = Manifold.cube([1, 1, 1]), sphere = Manifold.sphere(1, 16);
for (const [name, body] of [['ball with a cavity', sphere.subtract(sphere.scale(0.5))],
                            ['two cubes', cube.add(cube.translate([3, 0, 0]))]]) {
  const parts = body.decompose();
  console.log(`${name}: volume ${text([body])}, parts ${text(parts)}, status ${parts.map(p => p.status()).join(' and ')}; ` +
              `put together ${text([Manifold.compose(parts)])}, union ${text([Manifold.union(parts)])}, ` +
              `difference ${text([parts[0].subtract(parts[1])])}`);
}
const [points, faces] = JSON.parse(readFileSync('torus.json'));
const inside = faces.map(face => [...face].reverse());
const torus = new Manifold(new Mesh({
  numProp: 3, vertProperties: new Float32Array(points.flat()), triVerts: new Uint32Array(inside.flat()) }));
const around = Manifold.cube([10, 10, 10], true);
console.log(`torus inside out: volume ${text([torus])}, status ${torus.status()}; with a cube around it: ` +
            `union ${text([around.add(torus)])}, difference ${text([around.subtract(torus)])}, ` +
            `intersection ${text([around.intersect(torus)])}`);
END
verdict "$(node parts.mjs)" \
"ball with a cavity: volume 3.35, parts 3.83 and -0.48, status NoError and NoError; put together 3.83, union 3.83, difference 4.31
two cubes: volume 2.00, parts 1.00 and 1.00, status NoError and NoError; put together 2.00, union 2.00, difference 1.00
torus inside out: volume -37.27, status NoError; with a cube around it: union 1000.00, difference 1037.27, intersection -37.27"
