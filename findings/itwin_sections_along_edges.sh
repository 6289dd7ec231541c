#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# iTwin.js core-geometry 5.13.3 (npm, @itwin/core-geometry), PolyfaceClip.sectionPolyfaceClipPlane(), which by its
# documentation returns all edges chained, and clipPolyfaceClipPlaneWithClosureFace().
#
# Guess: the section of an octahedron through its middle is one closed square, and each half is closed by a face over
# the cut, also where the plane runs along edges of the mesh.
# What happens: the square comes as twelve loose segments, each side three times. The length is three times too great,
# and nothing is chained. Neither half gets a face over the cut: both are open, without a word, so that their volumes by
# the faces are 2 and -0.67 for 0.67 each. A plane a little beside, and one through vertices but not along edges, give
# one closed line and closed halves.
#
# Why it matters: the waist of a mesh that was built symmetrically, or by turning a profile, lies on its edges. The
# length of a section there is what one compares a constriction with.
. "$(dirname "$0")/lib/itwin.sh"

cd "$work"
cat > sections.mjs << 'END'
import { readFileSync } from 'node:fs';
import geometry from '@itwin/core-geometry';
import { polyface } from './polyface.mjs';

const { ClipPlane, Point3d, PolyfaceClip, PolyfaceQuery } = geometry;
const mesh = polyface(JSON.parse(readFileSync('mesh.json')));
for (const [name, normal, height] of [['along four edges', [0, 0, 1], 2], ['beside them', [0, 0, 1], 2.001],
                                      ['through two vertices', [1, -1, 0], 2]]) {
  const plane = ClipPlane.createNormalAndPointXYZXYZ(...normal, 0, 0, height);
  const lines = PolyfaceClip.sectionPolyfaceClipPlane(mesh, plane);
  const length = lines.reduce((sum, line) => sum + line.curveLength(), 0);
  const halves = [true, false].map(inside => {
    const half = PolyfaceClip.clipPolyfaceClipPlaneWithClosureFace(mesh, plane, inside, true);
    return `${PolyfaceQuery.isPolyfaceClosedByEdgePairing(half) ? 'closed' : 'open'} with volume ` +
      PolyfaceQuery.sumTetrahedralVolumes(half, Point3d.create(0, 0, 0)).toFixed(3);
  });
  console.log(`${name}: lines ${lines.length}, closed ${lines.filter(line => line.isPhysicallyClosed).length}, ` +
              `length ${length.toFixed(3)}; halves ${halves.join(', ')}`);
}
END
python3 -c "
import json, meshes
points, faces = meshes.octahedron()
json.dump([[(x, y, z + 2) for x, y, z in points], faces], open('mesh.json', 'w'))"
verdict "$(node sections.mjs)" \
"along four edges: lines 12, closed 0, length 16.971; halves open with volume 2.000, open with volume -0.667
beside them: lines 1, closed 1, length 5.651; halves closed with volume 0.665, closed with volume 0.669
through two vertices: lines 1, closed 1, length 4.899; halves closed with volume 0.667, closed with volume 0.667"
