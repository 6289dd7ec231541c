#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# vtk.js 37.4.3 (@kitware/vtk.js 37.4.3, npm), XMLPolyDataReader and XMLPolyDataWriter, PLYWriter, STLWriter.
#
# Guess: a surface that was read from VTP is the same when it is written to VTP and read again; the header of PLY says
# what is in the lines; binary STL has the floats.
# What happens: a VTP file with base64 and no compression is read correctly, and written with every coordinate one place
# further: the first x is the length in bytes that stood before the data, taken for a double, and the last z is gone.
# PLY of a surface without normals declares x y z nx ny nz, and its lines have three numbers, of six digits; only a
# reader that ends a vertex with the line, as that of vtk.js, finds the points. Binary STL has six digits as well, where
# a float needs nine.
#
# Why it matters: the VTP files of curves and parts that the program here writes are shown well by vtk.js. What is saved
# there is another surface. Its numbers are finite and its counts are right, so that no reader objects.
. "$(dirname "$0")/lib/packages.sh"
npm_packages @kitware/vtk.js@37.4.3 @xmldom/xmldom@0.9.8

cd "$work"
cat > octahedron.py << 'END'
import base64
import struct
import meshes

points, faces = meshes.octahedron()
points = [tuple(x + 1 / 3 for x in p) for p in points]


def array(kind, name, parts, code, values):
    data = struct.pack("<%d%s" % (len(values), code), *values)
    return '<DataArray type="%s" Name="%s" NumberOfComponents="%d" format="binary">%s</DataArray>' % (
        kind, name, parts, base64.b64encode(struct.pack("<Q", len(data)) + data).decode())


with open("octahedron.vtp", "w") as out:
    out.write('<?xml version="1.0"?><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
              '<PolyData><Piece NumberOfPoints="6" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" '
              'NumberOfPolys="8"><Points>%s</Points><Polys>%s%s</Polys></Piece></PolyData></VTKFile>' % (
                  array("Float64", "Points", 3, "d", [x for p in points for x in p]),
                  array("Int64", "connectivity", 1, "q", [i for f in faces for i in f]),
                  array("Int64", "offsets", 1, "q", [3 * i + 3 for i in range(8)])))
END
cat > write.mjs << 'END'
import { readFileSync } from 'node:fs';
import { DOMParser } from '@xmldom/xmldom';

globalThis.self = globalThis.window = globalThis;
globalThis.DOMParser = DOMParser;
const take = async path => (await import(`@kitware/vtk.js/IO/${path}.js`)).default.newInstance();
const say = (what, surface) => {
  const values = surface.getPoints().getData();
  console.log(`${what}: ${values.length / 3} points, ${surface.getNumberOfPolys()} triangles, the first ` +
    Array.from(values.slice(0, 3), x => x < 1e-300 ? x : x.toFixed(9)).join(' '));
};
const bytes = data => data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);

const reader = await take('XML/XMLPolyDataReader');
reader.parseAsArrayBuffer(bytes(readFileSync('octahedron.vtp')));
const surface = reader.getOutputData(0);
say('VTP as it is', surface);

const again = await take('XML/XMLPolyDataReader');
again.parseAsArrayBuffer(new TextEncoder().encode((await take('XML/XMLPolyDataWriter')).write(surface)).buffer);
say('VTP written', again.getOutputData(0));

const ply = await take('Geometry/PLYWriter');
ply.setInputData(surface);
const text = ply.getOutputData();
const lines = (typeof text === 'string' ? text : new TextDecoder().decode(text)).split('\n');
console.log('PLY declares: ' + lines.filter(l => l.startsWith('property float')).map(l => l.split(' ')[2]).join(' '));
console.log('PLY has: ' + lines[lines.findIndex(l => l.startsWith('end_header')) + 1]);
const plyReader = await take('Geometry/PLYReader');
plyReader.parseAsText(lines.join('\n'));
say('PLY read again', plyReader.getOutputData(0));

const stl = await take('Geometry/STLWriter');
stl.setInputData(surface);
const view = stl.getOutputData();
console.log('STL has: ' + new DataView(view.buffer ?? view, view.byteOffset ?? 0).getFloat32(84 + 12, true).toFixed(9) +
  `, the float is ${Math.fround(4 / 3).toFixed(9)}`);
END
python3 octahedron.py
verdict "$(node write.mjs 2>&1)" "VTP as it is: 6 points, 8 triangles, the first 1.333333333 0.333333333 0.333333333
VTP written: 6 points, 8 triangles, the first 7.1e-322 1.333333333 0.333333333
PLY declares: x y z nx ny nz
PLY has: 1.33333 0.333333 0.333333
PLY read again: 6 points, 8 triangles, the first 1.333330035 0.333332986 0.333332986
STL has: 1.333330035, the float is 1.333333373"
