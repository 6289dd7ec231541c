// SPDX-License-Identifier: GPL-3.0-or-later
// manifold-3d: has no files of meshes of its own: reads OFF here, hands the arrays in, and writes what it hands out.
import { readFileSync, writeFileSync } from 'node:fs';
import Module from 'manifold-3d';
import { save, tuples } from './held.mjs';

const [source, report, target] = process.argv.slice(2);
const { setup, Manifold, Mesh } = await Module().then(m => (m.setup(), m));
const numbers = readFileSync(source, 'utf8').split(/\s+/).slice(1).map(Number), [n, m] = numbers;
const out = new Manifold(new Mesh({ numProp: 3, vertProperties: Float32Array.from(numbers.slice(3, 3 + 3 * n)),
  triVerts: Uint32Array.from(tuples(numbers.slice(3 + 3 * n), 4).flatMap(f => f.slice(1))) })).getMesh();
const points = tuples(out.vertProperties, 3), faces = tuples(out.triVerts, 3);
save(report, { points, faces });
writeFileSync(target, `OFF\n${points.length} ${faces.length} 0\n` + points.map(p => p.join(' ') + '\n').join('') +
  faces.map(f => '3 ' + f.join(' ') + '\n').join(''));
