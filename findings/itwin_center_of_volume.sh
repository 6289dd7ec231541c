#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# iTwin.js core-geometry 5.13.3 (npm, @itwin/core-geometry), PolyfaceQuery.computePrincipalVolumeMoments() and
# computePrincipalAreaMoments(). For both the documentation says that "origin" is the centroid.
#
# Guess: the centroid of an octahedron is its centre, whichever vertex is listed first and wherever it lies.
# What happens: so it is for the area. The centroid of the volume is the sum of the true one and of the first point of
# the mesh: an octahedron around the origin has it in one of its vertices, one around (100, 0, 0) near (200, 0, 0), and
# with the points listed from the last it is another place again. The volume is right. A mesh whose first point is (0,
# 0, 0) shows nothing, and a body with a corner at the origin is what one tries first.
#
# Why it matters: centroids of parts are what one sorts bodies, aligns meshes and measures distances by. In map
# coordinates the error is as large as the coordinates themselves.
. "$(dirname "$0")/lib/itwin.sh"

cd "$work"
cat > centers.mjs << 'END'
import { readFileSync } from 'node:fs';
import geometry from '@itwin/core-geometry';
import { polyface } from './polyface.mjs';

const { PolyfaceQuery } = geometry;
const text = ({ x, y, z }) => [x, y, z].map(c => (Math.round(1000 * c) / 1000 + 0).toFixed(3)).join(' ');
for (const [name, data] of JSON.parse(readFileSync('meshes.json'))) {
  const mesh = polyface(data);
  const volume = PolyfaceQuery.computePrincipalVolumeMoments(mesh);
  const area = PolyfaceQuery.computePrincipalAreaMoments(mesh);
  console.log(`${name}: volume ${volume.quantitySum.toFixed(3)}, centroid of the volume ${text(volume.origin)}, ` +
              `of the area ${text(area.origin)}`);
}
END
cat > centers.py << 'END'
import json
import meshes

points, faces = meshes.octahedron()
moved = [(x + 100, y, z) for x, y, z in points]
last = len(points) - 1
with open("meshes.json", "w") as out:
    json.dump([("tetrahedron, first point 0 0 0", meshes.tetrahedron()),
               ("octahedron around 0 0 0", (points, faces)),
               ("octahedron around 100 0 0", (moved, faces)),
               ("the same, points from the last", (moved[::-1], [tuple(last - i for i in f) for f in faces])),
               ("torus around 0 0 0", meshes.torus())], out)
END
python3 centers.py
verdict "$(node centers.mjs)" \
"tetrahedron, first point 0 0 0: volume 0.167, centroid of the volume 0.250 0.250 0.250, of the area 0.263 0.263 0.263
octahedron around 0 0 0: volume 1.333, centroid of the volume 1.000 0.000 0.000, of the area 0.000 0.000 0.000
octahedron around 100 0 0: volume 1.333, centroid of the volume 201.000 0.000 0.000, of the area 100.000 0.000 0.000
the same, points from the last: volume 1.333, centroid of the volume 200.000 0.000 -1.000, of the area 100.000 0.000 0.000
torus around 0 0 0: volume 37.270, centroid of the volume 3.000 0.000 0.000, of the area 0.000 0.000 0.000"
