// SPDX-License-Identifier: GPL-3.0-or-later
// vtk.js: reads a file, says what it holds, writes it in the same format: IN HELD OUT
import { readFileSync, writeFileSync } from 'node:fs';
import { DOMParser } from '@xmldom/xmldom';
import { bytes, edgesOf, save, tuples } from './held.mjs';

globalThis.self = globalThis;
globalThis.window ??= globalThis;
globalThis.DOMParser = DOMParser;
const [source, report, target] = process.argv.slice(2);
const kind = source.split('.').pop();
const take = async path => (await import(`@kitware/vtk.js/${path}.js`)).default;
const readers = { obj: 'IO/Misc/OBJReader', ply: 'IO/Geometry/PLYReader', stl: 'IO/Geometry/STLReader',
  vtk: 'IO/Legacy/PolyDataReader', vtp: 'IO/XML/XMLPolyDataReader' };
if (!readers[kind])
  throw new Error('no reader');
const reader = (await take(readers[kind])).newInstance();
const data = readFileSync(source);
if (kind === 'obj' || (kind === 'vtk' && !reader.parseAsArrayBuffer))
  reader.parseAsText(data.toString('latin1'));
else
  reader.parseAsArrayBuffer(bytes(data));
const surface = reader.getOutputData(0);
const count = reader.getNumberOfOutputPorts?.() ?? 1;
const points = [], faces = [], edges = [], face = {}, edge = {}, point = {};
for (let port = 0; port < count; ++port) {
  const poly = reader.getOutputData(port), first = points.length;
  points.push(...tuples(poly.getPoints().getData(), 3));
  const split = cells => {
    const result = [], values = cells.getData();
    for (let i = 0; i < values.length; i += values[i] + 1)
      result.push(Array.from(values.slice(i + 1, i + 1 + values[i]), v => first + v));
    return result;
  };
  const lines = split(poly.getLines()), polys = split(poly.getPolys());
  faces.push(...polys);
  lines.forEach(line => edges.push(...edgesOf(line)));
  for (const array of poly.getPointData().getArrays())
    (point[array.getName()] ??= []).push(...tuples(array.getData(), array.getNumberOfComponents()));
  for (const array of poly.getCellData().getArrays()) {
    const values = tuples(array.getData(), array.getNumberOfComponents());
    if (values.length !== lines.length + polys.length)
      continue;
    (face[array.getName()] ??= []).push(...values.slice(lines.length));
    const of = (edge[array.getName()] ??= []);
    lines.forEach((line, i) => of.push(...edgesOf(line).map(() => values[i])));
  }
}
if (!points.length)
  throw new Error('nothing read');
save(report, { points, faces, edges, face, edge, point });

const writers = { ply: 'IO/Geometry/PLYWriter', stl: 'IO/Geometry/STLWriter', vtp: 'IO/XML/XMLPolyDataWriter' };
if (!writers[kind])
  throw new Error('no writer');
if (kind === 'vtp') {
  const writer = (await take(writers[kind])).newInstance();
  writeFileSync(target, writer.write(surface));
} else {
  const writer = (await take(writers[kind])).newInstance();
  writer.setInputData(surface);
  const out = writer.getOutputData();
  writeFileSync(target, typeof out === 'string' ? out : Buffer.from(out.buffer ?? out));
}
