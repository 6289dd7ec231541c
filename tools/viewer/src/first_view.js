// SPDX-License-Identifier: GPL-3.0-or-later
// From where most of the prominent curves are seen.
import {Vector3} from 'three/build/three.module.js';
import {directions} from './view_of_curve.js';
import {levelSurface} from './levels.js';

const size = 96;        // of the picture in which it is found what is in front, in pixels
const tolerance = 0.04; // a coarse surface may be that far in front of a curve

// How far the surface reaches toward `d` at each pixel of a picture that is seen from there.
function depths({points, faces}, d, u, v) {
  const result = new Float32Array(size * size).fill(-Infinity), n = points.length / 3;
  const x = new Float32Array(n), y = new Float32Array(n), z = new Float32Array(n);
  for (let i = 0; i < n; ++i) {
    const a = points[3 * i], b = points[3 * i + 1], c = points[3 * i + 2];
    x[i] = (1 + a * u.x + b * u.y + c * u.z) * size / 2;
    y[i] = (1 + a * v.x + b * v.y + c * v.z) * size / 2;
    z[i] = a * d.x + b * d.y + c * d.z;
  }
  for (let f = 0; f < faces.length; f += 3) {
    const a = faces[f], b = faces[f + 1], c = faces[f + 2];
    const area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
    if (area === 0)
      continue;
    const left = Math.max(0, Math.ceil(Math.min(x[a], x[b], x[c]) - 0.5));
    const right = Math.min(size - 1, Math.floor(Math.max(x[a], x[b], x[c]) - 0.5));
    const bottom = Math.max(0, Math.ceil(Math.min(y[a], y[b], y[c]) - 0.5));
    const top = Math.min(size - 1, Math.floor(Math.max(y[a], y[b], y[c]) - 0.5));
    for (let j = bottom; j <= top; ++j)
      for (let i = left; i <= right; ++i) {
        const px = i + 0.5, py = j + 0.5;
        const s = ((px - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (py - y[a])) / area;
        const t = ((x[b] - x[a]) * (py - y[a]) - (px - x[a]) * (y[b] - y[a])) / area;
        if (s >= 0 && t >= 0 && s + t <= 1)
          result[j * size + i] = Math.max(result[j * size + i], z[a] + s * (z[b] - z[a]) + t * (z[c] - z[a]));
      }
  }
  return result;
}

// A little from above and from the right; what is flat is seen from its broad side, and what is highest along z stands.
export function usualView(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const [x, y, z] = high.map((h, i) => h - low[i]);
  if (y < 0.8 * Math.min(x, z) && z > x)
    return {direction: new Vector3(0.4, -1, 0.25), up: new Vector3(0, 0, 1)};
  if (y < 0.8 * Math.min(x, z))
    return {direction: new Vector3(0.25, 1, 0.5), up: new Vector3(0, 0, -1)};
  if (x < 0.8 * Math.min(y, z) || z > 1.2 * Math.max(x, y))
    return {direction: new Vector3(1, 0.25, 0.4), up: new Vector3(0, 1, 0)};
  return {direction: new Vector3(0.4, 0.25, 1), up: new Vector3(0, 1, 0)};
}

// The surface with no more than so many vertices, if there is such a level.
function coarseSurface(arrays, vertices) {
  const n = arrays.levels_points.length / 3;
  const collapses = Math.max(0, Math.min(n - vertices, arrays.levels_parents.length));
  const {points, faces} = levelSurface(arrays, collapses);
  return {points: points.subarray(0, 3 * (n - collapses)), faces};
}

// The steps from point to point of the curves for which `isShown(c)`: where each is, the normal of the surface there, and
// its length times the prominence of its curve, which counts up to 1.
function stepsOf({curves, arrays}, isShown) {
  const {curve_points: p, curve_normals: n, curve_begins} = arrays, result = [];
  curves.forEach(({prominence}, c) => {
    if (!isShown(c))
      return;
    const [begin, end] = [3 * curve_begins[c], 3 * curve_begins[c + 1]];
    for (let i = begin; i < end; i += 3) {
      const j = i + 3 < end ? i + 3 : begin;
      const length = Math.hypot(p[j] - p[i], p[j + 1] - p[i + 1], p[j + 2] - p[i + 2]);
      result.push({place: new Vector3().fromArray(p, i), normal: new Vector3().fromArray(n, i).normalize(),
        weight: length * Math.min(1, prominence)});
    }
  });
  return result;
}

// Returns the direction from which the most of the curves is seen for which `isShown(c)`: the length that is on the
// visible side of the surface and behind nothing, times the prominence. The `direction` of the usual view is taken unless
// another one shows clearly more, and directions along `up` are avoided. Cost: a picture of a surface of some thousand
// faces for each of 49 directions.
export function firstView(data, isShown, {direction, up}) {
  const steps = stepsOf(data, isShown), all = steps.reduce((sum, {weight}) => sum + weight, 0);
  const usual = direction.clone().normalize();
  if (all === 0)
    return usual;
  const surface = coarseSurface(data.arrays, 2500);
  let best = usual, greatest = -Infinity;
  for (const d of [usual, ...directions.filter((_, i) => i % 2 === 0)]) {
    const aside = Math.abs(d.dot(up)) < 0.99 ? up : new Vector3(up.z, up.x, up.y);
    const u = new Vector3().crossVectors(aside, d).normalize(), v = new Vector3().crossVectors(d, u);
    const front = depths(surface, d, u, v);
    let seen = 0;
    for (const {place, normal, weight} of steps) {
      if (normal.dot(d) < 0.1)
        continue;
      const i = Math.floor((1 + place.dot(u)) * size / 2), j = Math.floor((1 + place.dot(v)) * size / 2);
      if (!(front[j * size + i] > place.dot(d) + tolerance))
        seen += weight;
    }
    const rating = seen / all - 0.12 * d.dot(up) ** 2 + 0.05 * d.dot(usual);
    if (rating > greatest) {
      greatest = rating;
      best = d;
    }
  }
  return best.clone();
}
