// SPDX-License-Identifier: GPL-3.0-or-later
// What a program holds after it has read a file, as JSON, like held.py.
import { writeFileSync } from 'node:fs';

export const tuples = (values, size) =>
  Array.from({ length: Math.floor(values.length / size) }, (_, i) => Array.from(values.slice(size * i, size * i + size)));

export const edgesOf = polyline => polyline.slice(1).map((to, i) => [polyline[i], to]);

export function save(name, { points, faces = [], edges = [], names = [], point = {}, face = {}, edge = {} }) {
  writeFileSync(name, JSON.stringify({ points, faces, edges, names, point, face, edge }));
}

// The part of a buffer that a small file has in node's pool, as a buffer of its own.
export const bytes = data => data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
