#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# three.js 0.187.0 (npm), 3MFLoader and AMFLoader, with linkedom 0.18.15 for XML.
#
# Guess: both formats state the unit of their coordinates, and both loaders scale to one unit, or neither does.
# What happens: AMFLoader scales to millimetres. 3MFLoader reads the unit and does nothing with it: a tetrahedron of the
# side 1 is 1 long in millimetres, inches and metres alike, with scale 1 and no word.
#
# Why it matters: lengths of constrictions are in the unit of the mesh. The same body from the two formats differs by a
# factor of 25.4 or 1000, and a threshold for the length of a neck finds it in one of them.
. "$(dirname "$0")/lib/packages.sh"
npm_packages three@0.187.0 linkedom@0.18.15

cd "$work"
cat > units.mjs << 'END'
import { readFileSync } from 'node:fs';
import { DOMParser } from 'linkedom';
import { Box3 } from 'three';
import { strToU8, zipSync } from 'three/addons/libs/fflate.module.js';
import { AMFLoader } from 'three/addons/loaders/AMFLoader.js';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';

globalThis.DOMParser = DOMParser;
console.log = () => {}; // AMFLoader tells its scale
const [points, faces] = JSON.parse(readFileSync('mesh.json'));
const head = '<?xml version="1.0" encoding="UTF-8"?>';

function amf(unit) {
  const vertices = points.map(([x, y, z]) =>
    `<vertex><coordinates><x>${x}</x><y>${y}</y><z>${z}</z></coordinates></vertex>`);
  const triangles = faces.map(([a, b, c]) => `<triangle><v1>${a}</v1><v2>${b}</v2><v3>${c}</v3></triangle>`);
  return strToU8(`${head}<amf unit="${unit}"><object id="0"><mesh><vertices>${vertices.join('')}</vertices>` +
                 `<volume>${triangles.join('')}</volume></mesh></object></amf>`).buffer;
}

function threeMf(unit) {
  const vertices = points.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`);
  const triangles = faces.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`);
  const packages = 'http://schemas.openxmlformats.org/package/2006';
  const microsoft = 'http://schemas.microsoft.com/3dmanufacturing';
  return zipSync({
    '[Content_Types].xml': strToU8(`${head}<Types xmlns="${packages}/content-types">` +
      `<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>` +
      `<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>`),
    '_rels/.rels': strToU8(`${head}<Relationships xmlns="${packages}/relationships">` +
      `<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="${microsoft}/2013/01/3dmodel"/></Relationships>`),
    '3D/3dmodel.model': strToU8(`${head}<model unit="${unit}" xmlns="${microsoft}/core/2015/02"><resources>` +
      `<object id="1" type="model"><mesh><vertices>${vertices.join('')}</vertices>` +
      `<triangles>${triangles.join('')}</triangles></mesh></object></resources>` +
      `<build><item objectid="1"/></build></model>`)
  }).buffer;
}

const length = group => {
  group.updateMatrixWorld(true);
  return Number(new Box3().setFromObject(group).max.x.toPrecision(6));
};
for (const unit of ['millimeter', 'inch', 'meter', 'micron'])
  process.stdout.write(`1 ${unit}: from AMF ${length(new AMFLoader().parse(amf(unit)))}, ` +
                       `from 3MF ${length(new ThreeMFLoader().parse(threeMf(unit)))}\n`);
END
python3 -c "
import json, meshes
json.dump(meshes.tetrahedron(), open('mesh.json', 'w'))"
verdict "$(node units.mjs)" \
"1 millimeter: from AMF 1, from 3MF 1
1 inch: from AMF 25.4, from 3MF 1
1 meter: from AMF 1000, from 3MF 1
1 micron: from AMF 0.001, from 3MF 1"
