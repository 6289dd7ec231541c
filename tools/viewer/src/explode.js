// SPDX-License-Identifier: GPL-3.0-or-later
// Parts drawn apart. From the largest part outwards each moves away from the curve that cuts it off, with all that hangs
// on it, so that limbs come off along their axes.
import {Vector3} from 'three/build/three.module.js';

// Returns {parts, curves}: how far each part and each curve moves, as vectors. A curve stays with the part from which
// the other one was moved away. `frameOf(c)` has the `centre` and the unit `normal` of curve c.
export function movesApart({parts, between}, frameOf, distance) {
  const none = new Vector3();
  const moves = parts.map(() => null), depth = parts.map(() => 0);
  const curvesAt = parts.map(() => []);
  between.forEach((pairs, c) => {
    for (const [left, right] of pairs)
      if (left !== right) {
        curvesAt[left].push([c, right]);
        curvesAt[right].push([c, left]);
      }
  });
  const bySize = parts.map((_, p) => p).sort((p, q) => parts[q].weight - parts[p].weight || p - q);
  for (const root of bySize) {
    if (moves[root])
      continue;
    moves[root] = none;
    for (const queue = [root]; queue.length > 0;) {
      const p = queue.shift();
      for (const [c, q] of curvesAt[p]) {
        if (moves[q])
          continue;
        const {centre, normal} = frameOf(c), outwards = parts[q].centre.clone().sub(centre);
        const along = outwards.dot(normal), far = outwards.length() || 1;
        // across the curve, unless the part lies on both sides of its plane
        const direction = normal.clone().multiplyScalar(Math.sign(along)).addScaledVector(outwards, 0.5 / far);
        moves[q] = moves[p].clone().addScaledVector(direction.normalize(), distance);
        depth[q] = depth[p] + 1;
        queue.push(q);
      }
    }
  }
  const curves = between.map(pairs =>
    pairs.flat().reduce((best, p) => best === null || depth[p] < depth[best] ? p : best, null))
    .map(p => p === null ? none : moves[p]);
  return {parts: moves, curves};
}
