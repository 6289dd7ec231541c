// SPDX-License-Identifier: GPL-3.0-or-later
// meshoptimizer: reads OFF here, encodes the arrays, decodes them, and writes what comes out.
import { readFileSync, writeFileSync } from 'node:fs';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import { save, tuples } from './held.mjs';

const [source, report, target] = process.argv.slice(2);
await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);
const numbers = readFileSync(source, 'utf8').split(/\s+/).slice(1).map(Number), [n, m] = numbers;
const places = new Uint8Array(Float64Array.from(numbers.slice(3, 3 + 3 * n)).buffer);
const corners = new Uint8Array(Uint32Array.from(tuples(numbers.slice(3 + 3 * n), 4).flatMap(f => f.slice(1))).buffer);
const vertices = new Uint8Array(24 * n), indices = new Uint8Array(12 * m);
MeshoptDecoder.decodeGltfBuffer(vertices, n, 24, MeshoptEncoder.encodeGltfBuffer(places, n, 24, 'ATTRIBUTES'), 'ATTRIBUTES');
MeshoptDecoder.decodeGltfBuffer(indices, 3 * m, 4, MeshoptEncoder.encodeGltfBuffer(corners, 3 * m, 4, 'TRIANGLES'), 'TRIANGLES');
const points = tuples(new Float64Array(vertices.buffer), 3), faces = tuples(new Uint32Array(indices.buffer), 3);
save(report, { points, faces });
writeFileSync(target, `OFF\n${points.length} ${faces.length} 0\n` + points.map(p => p.join(' ') + '\n').join('') +
  faces.map(f => '3 ' + f.join(' ') + '\n').join(''));
