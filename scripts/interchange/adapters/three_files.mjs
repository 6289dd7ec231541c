// SPDX-License-Identifier: GPL-3.0-or-later
// three.js: reads a file, says what it holds, writes it in the same format: IN HELD OUT
import { readFileSync, writeFileSync } from 'node:fs';
import { DOMParser } from '@xmldom/xmldom';
import * as THREE from 'three';
import { bytes, edgesOf, save, tuples } from './held.mjs';

// What browsers have.
globalThis.self = globalThis;
globalThis.DOMParser = DOMParser;
globalThis.requestAnimationFrame = f => setTimeout(f, 0);
globalThis.ProgressEvent = class {};
globalThis.FileReader = class {
  async readAsArrayBuffer(blob) {
    this.result = await blob.arrayBuffer();
    this.onloadend();
  }
};
const [source, report, target] = process.argv.slice(2);
const kind = source.split('.').pop();
const load = async (file, name) => new (await import(`three/addons/loaders/${file}.js`))[name]();
const data = readFileSync(source);

async function read() {
  if (kind === 'obj')
    return (await load('OBJLoader', 'OBJLoader')).parse(data.toString());
  if (kind === 'ply')
    return new THREE.Mesh((await load('PLYLoader', 'PLYLoader')).parse(bytes(data)));
  if (kind === 'stl')
    return new THREE.Mesh((await load('STLLoader', 'STLLoader')).parse(bytes(data)));
  if (kind === 'vtk' || kind === 'vtp')
    return new THREE.Mesh((await load('VTKLoader', 'VTKLoader')).parse(bytes(data)));
  if (kind === 'glb')
    return (await (await load('GLTFLoader', 'GLTFLoader')).parseAsync(bytes(data), '')).scene;
  throw new Error('no reader');
}

const scene = await read();
scene.updateMatrixWorld(true);
const points = [], faces = [], edges = [], names = [], face = {}, edge = {}, point = {};
scene.traverse(object => {
  const geometry = object.geometry;
  if (!geometry)
    return;
  const position = geometry.attributes.position, first = points.length;
  if (!position)
    throw new Error('nothing read');
  points.push(...tuples(position.array, 3));
  names.push(object.name);
  const corners = geometry.index ? Array.from(geometry.index.array) : Array.from({ length: position.count }, (_, i) => i);
  const numbers = corners.map(i => first + i);
  if (object.isMesh) {
    faces.push(...tuples(numbers, 3));
    if (object.material.color && object.name)
      (face.colours ??= []).push(...tuples(numbers, 3).map(() => object.material.color.toArray()));
  } else if (object.isLineSegments)
    edges.push(...tuples(numbers, 2));
  else if (object.isLine)
    edges.push(...edgesOf(object.isLineLoop ? [...numbers, numbers[0]] : numbers));
  for (const [name, values] of Object.entries(geometry.attributes))
    if (name !== 'position' && name !== 'normal')
      (point[name] ??= []).push(...tuples(values.array, values.itemSize));
});
if (!points.length)
  throw new Error('nothing read');
save(report, { points, faces, edges, names, point, face, edge });

if (kind === 'obj') {
  const { OBJExporter } = await import('three/addons/exporters/OBJExporter.js');
  writeFileSync(target, new OBJExporter().parse(scene));
} else if (kind === 'ply') {
  const { PLYExporter } = await import('three/addons/exporters/PLYExporter.js');
  writeFileSync(target, Buffer.from(new PLYExporter().parse(scene, () => {}, { binary: true, littleEndian: true })));
} else if (kind === 'stl') {
  const { STLExporter } = await import('three/addons/exporters/STLExporter.js');
  const view = new STLExporter().parse(scene, { binary: true });
  writeFileSync(target, Buffer.from(view.buffer, view.byteOffset, view.byteLength));
} else if (kind === 'glb') {
  const { GLTFExporter } = await import('three/addons/exporters/GLTFExporter.js');
  writeFileSync(target, Buffer.from(await new GLTFExporter().parseAsync(scene, { binary: true })));
} else
  throw new Error('no writer');
