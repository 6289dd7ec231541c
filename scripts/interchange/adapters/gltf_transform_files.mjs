// SPDX-License-Identifier: GPL-3.0-or-later
// glTF-Transform: reads a file, says what it holds, writes it in the same format: IN HELD OUT
import { NodeIO } from '@gltf-transform/core';
import { save } from './held.mjs';

const [source, report, target] = process.argv.slice(2);
const io = new NodeIO(), document = await io.read(source);
const points = [], faces = [], names = [], face = { colours: [] };
for (const mesh of document.getRoot().listMeshes())
  for (const primitive of mesh.listPrimitives()) {
    const first = points.length, position = primitive.getAttribute('POSITION'), index = primitive.getIndices();
    for (let i = 0; i < position.getCount(); ++i)
      points.push(position.getElement(i, []));
    for (let i = 0; i < index.getCount(); i += 3) {
      faces.push([0, 1, 2].map(k => first + index.getScalar(i + k)));
      face.colours.push(primitive.getMaterial()?.getBaseColorFactor().slice(0, 3) ?? []);
    }
    names.push(mesh.getName());
  }
save(report, { points, faces, names, face });
await io.write(target, document);
