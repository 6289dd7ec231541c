#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# JSCAD (npm: @jscad/modeling 2.13.0, @jscad/stl-serializer 2.1.23): booleans.union(), written as STL.
#
# Guess: the union of two balls that overlap is written as a closed surface, as that of two boxes is, and a union does
# not depend on the unit.
# What happens: the serializer puts vertices on edges where faces do not meet edge to edge, and for boxes that suffices.
# The union of two balls of 24 segments comes with 75 border edges, scattered along the seam. A bridge between two boxes
# is gone, with no word, if it is thinner than 1e-5. And unions have an absolute tolerance, 1e-5: for two balls of
# radius 1e-5 the volume comes out as 78% of what it should be, for 1e-6 the balls count as apart and are both kept
# whole, and the union of two of 1e-8 is empty.
#
# Why it matters: two balls that overlap have a neck where they meet, and that is where the surface is torn. Whoever
# draws in metres what has micrometres loses all.
. "$(dirname "$0")/lib/packages.sh"
npm_packages @jscad/modeling@2.13.0 @jscad/stl-serializer@2.1.23

cd "$work"
cat > unions.cjs << 'END'
const { booleans, measurements, primitives, transforms } = require('@jscad/modeling');
const { serialize } = require('@jscad/stl-serializer');
const { writeFileSync } = require('node:fs');

function write(name, solid) {
  const parts = serialize({ binary: true }, solid).map(part => Buffer.from(part.buffer ?? part));
  writeFileSync(name + '.stl', Buffer.concat(parts));
}

const ball = (radius, place, segments) =>
  transforms.translate(place.map(c => radius * c), primitives.sphere({ radius, segments }));
const box = (place, size) => transforms.translate(place, primitives.cuboid({ size }));
write('boxes', booleans.union(box([0, 0, 0], [2, 2, 2]), box([1, 0.5, 0.3], [2, 1, 1])));
write('balls', booleans.union(ball(1, [0, 0, 0], 24), ball(1, [1.5, 0.1, 0.05], 24)));
for (const width of [1e-4, 1e-5])
  write('bridge of ' + width, booleans.union(box([0, 0, 0], [1, 1, 1]), box([2, 0, 0], [1, 1, 1]),
                                             box([1, 0, 0], [1.5, width, width])));
const volume = radius =>
  measurements.measureVolume(booleans.union(ball(radius, [0, 0, 0], 12), ball(radius, [1.5, 0.1, 0], 12))) / radius ** 3;
for (const radius of [1e-3, 1e-5, 1e-6, 1e-8])
  console.log(`balls of radius ${radius}: volume ${(volume(radius) / volume(1)).toFixed(2)} of what it should be`);
END
cat > unions.py << 'END'
import struct
import subprocess
import meshes

volumes = subprocess.check_output(["node", "unions.cjs"], text=True)
for name in ("boxes", "balls", "bridge of 0.0001", "bridge of 0.00001"):
    data = open(name + ".stl", "rb").read()
    number, faces = {}, []
    for i in range(struct.unpack_from("<I", data, 80)[0]):
        c = struct.unpack_from("<9f", data, 96 + 50 * i)
        faces.append(tuple(number.setdefault((c[k] + 0, c[k + 1] + 0, c[k + 2] + 0), len(number)) for k in (0, 3, 6)))
    print("%s: %s" % (name, meshes.describe([f for f in faces if len(set(f)) == 3])))
print(volumes.strip())
END
verdict "$(python3 unions.py)" \
"boxes: V 25, F 46, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
balls: V 589, F 1147, components 1, Euler characteristic -22, border edges 75, non-manifold edges 0
bridge of 0.0001: V 40, F 76, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
bridge of 0.00001: V 24, F 40, components 2, Euler characteristic 4, border edges 0, non-manifold edges 0
balls of radius 0.001: volume 1.00 of what it should be
balls of radius 0.00001: volume 0.78 of what it should be
balls of radius 0.000001: volume 1.03 of what it should be
balls of radius 1e-8: volume 0.00 of what it should be"
