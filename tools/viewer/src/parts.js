// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts the surface has when only some of the curves cut, how large they are, and their colours.
import {Vector3} from 'three/build/three.module.js';

// The surface is cut along all curves; where a curve is hidden the parts on its sides are one. Returns for each part of
// the surface cut along all curves the number of the part that it belongs to.
export function joinedParts(numberOfParts, curves, isShown) {
  const parent = Array.from({length: numberOfParts}, (_, p) => p);
  const root = p => {
    while (parent[p] !== p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  curves.forEach((c, i) => {
    if (!isShown(i))
      for (const [left, right] of c.parts)
        parent[root(left)] = root(right);
  });
  return parent.map((_, p) => root(p));
}

// How many parts there are when the first k of the curves cut that are `chosen`, for each k from 0 to their number.
export function numbersOfParts(numberOfParts, curves, chosen) {
  const rank = new Array(curves.length).fill(-1);
  chosen.forEach((c, k) => rank[c] = k);
  const parent = joinedParts(numberOfParts, curves, i => rank[i] >= 0);
  const root = p => {
    while (parent[p] !== p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  const result = new Array(chosen.length + 1);
  let number = parent.filter((q, p) => q === p).length;
  result[chosen.length] = number;
  for (let k = chosen.length - 1; k >= 0; --k) {
    for (const [left, right] of curves[chosen[k]].parts)
      if (root(left) !== root(right)) {
        parent[root(left)] = root(right);
        --number;
      }
    result[k] = number;
  }
  return result;
}

// Where the parts of the surface cut along all curves are: of each the number of faces, the sum of the centres of its
// faces weighted with area, that area, and its bounding box.
export function placesOfParts(numberOfParts, {points, faces, parts}) {
  const result = Array.from({length: numberOfParts}, () => ({faces: 0, weight: 0, sum: new Vector3(),
    low: new Vector3(Infinity, Infinity, Infinity), high: new Vector3(-Infinity, -Infinity, -Infinity)}));
  const a = new Vector3(), b = new Vector3(), c = new Vector3(), u = new Vector3(), v = new Vector3();
  for (let f = 0; 3 * f < faces.length; ++f) {
    const part = result[parts[f]];
    a.fromArray(points, 3 * faces[3 * f]);
    b.fromArray(points, 3 * faces[3 * f + 1]);
    c.fromArray(points, 3 * faces[3 * f + 2]);
    part.low.min(a).min(b).min(c);
    part.high.max(a).max(b).max(c);
    const area = u.subVectors(b, a).cross(v.subVectors(c, a)).length() / 2;
    ++part.faces;
    part.weight += area;
    part.sum.addScaledVector(a.add(b).add(c), area / 3);
  }
  return result;
}

const sum = (x, y) => x === null || y === null ? null : x + y;

// The parts between the curves for which `cuts(c)`, in the order of their first pieces:
// of      for each part of the surface cut along all curves the number of the part that it belongs to
// parts   of each its `area` and `volume`, in the unit of the file; the volume is null if it has a hole. As it is drawn,
//         the number of its `faces`, its area as `weight`, its centre of mass as `centre`, and a ball that it is in, by its
//         `middle` and `radius`
// between for each curve the pairs of parts on its left and right
export function divide(data, places, cuts) {
  const joined = joinedParts(data.number_of_parts, data.curves, cuts);
  const numbers = new Map();
  const of = joined.map(root => numbers.get(root) ?? numbers.set(root, numbers.size).get(root));
  const parts = Array.from(numbers, () => ({area: 0, volume: 0, faces: 0, weight: 0, centre: new Vector3(),
    low: new Vector3(Infinity, Infinity, Infinity), high: new Vector3(-Infinity, -Infinity, -Infinity)}));
  of.forEach((n, p) => {
    const part = parts[n], {area, volume} = data.parts[p], place = places[p];
    part.area = sum(part.area, area);
    part.volume = sum(part.volume, volume);
    part.faces += place.faces;
    part.weight += place.weight;
    part.centre.add(place.sum);
    part.low.min(place.low);
    part.high.max(place.high);
  });
  for (const part of parts) {
    part.centre.divideScalar(part.weight || 1);
    part.radius = part.faces > 0 ? part.low.distanceTo(part.high) / 2 : 0;
    part.middle = part.faces > 0 ? part.low.clone().add(part.high).divideScalar(2) : new Vector3();
  }
  const between = data.curves.map((curve, c) => {
    if (!cuts(c))
      return [];
    const pairs = new Map(curve.parts.map(([left, right]) => [`${of[left]} ${of[right]}`, [of[left], of[right]]]));
    return [...pairs.values()];
  });
  return {of, parts, between};
}

// Of the given number of colours one for each part, such that neighbours differ where that can be had: the largest
// parts choose first, and of the colours that no neighbour has the one that is used least.
export function colourParts({parts, between}, numberOfColours) {
  const neighbours = parts.map(() => new Set());
  for (const [left, right] of between.flat()) {
    neighbours[left].add(right);
    neighbours[right].add(left);
  }
  const colour = new Array(parts.length).fill(-1), uses = new Array(numberOfColours).fill(0);
  for (const p of parts.map((_, p) => p).sort((p, q) => parts[q].faces - parts[p].faces || p - q)) {
    const taken = new Set([...neighbours[p]].map(q => colour[q]));
    let best = -1;
    for (let c = 0; c < numberOfColours; ++c)
      if (!taken.has(c) && (best < 0 || uses[c] < uses[best]))
        best = c;
    if (best < 0)
      best = 0;
    ++uses[best];
    colour[p] = best;
  }
  return colour;
}
