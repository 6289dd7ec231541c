# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts on iTwin.js begin with: packages.sh, core-geometry 5.13.3, and $work/polyface.mjs, which makes an
# IndexedPolyface of the points and faces of meshes.py.
. "$(dirname "${BASH_SOURCE[0]}")/packages.sh"
npm_packages @itwin/core-geometry@5.13.3 @itwin/core-bentley@5.13.3
cat > "$work/polyface.mjs" << 'END_OF_MODULE'
import geometry from '@itwin/core-geometry';

export function polyface([points, faces]) {
  const mesh = geometry.IndexedPolyface.create();
  for (const [x, y, z] of points)
    mesh.addPointXYZ(x, y, z);
  for (const face of faces) {
    for (const i of face)
      mesh.addPointIndex(i, true);
    mesh.terminateFacet();
  }
  return mesh;
}
END_OF_MODULE
