// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import {it} from 'node:test';
import {Cling} from '../src/cling.js';

// The square [0, 1]^2 in the plane z = height, of two triangles that look up or down.
const square = (height, looksUp) => ({
  points: Float32Array.from([0, 0, height, 1, 0, height, 1, 1, height, 0, 1, height]),
  faces: Uint32Array.from(looksUp ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]),
});
const near = (actual, expected) => assert.ok(Math.abs(actual - expected) < 1e-6, `${actual} is not ${expected}`);

it('finds how far above or below a point the surface is', () => {
  const cling = new Cling(square(0.25, true), 0.02);
  near(cling.distance(0.3, 0.6, 0.24, 0, 0, 1), 0.01);
  near(cling.distance(0.3, 0.6, 0.26, 0, 0, 1), -0.01);
  near(cling.distance(0.3, 0.6, 0.25 - 0.012, 0.6, 0, 0.8), 0.015);
});

it('sees neither what looks the other way nor what is out of reach', () => {
  assert.equal(new Cling(square(0.25, false), 0.02).distance(0.3, 0.6, 0.24, 0, 0, 1), 0);
  const cling = new Cling(square(0.25, true), 0.02);
  assert.equal(cling.distance(0.3, 0.6, 0.22, 0, 0, 1), 0);
  assert.equal(cling.distance(1.01, 0.6, 0.25, 0, 0, 1), 0);
});

const two = (lower, upper) => {
  const low = square(lower, true), high = square(upper, true);
  return {points: Float32Array.from([...low.points, ...high.points]),
    faces: Uint32Array.from([...low.faces, ...high.faces.map(v => v + 4)])};
};

it('takes the nearest of several sheets, but the uppermost of a fold', () => {
  const cling = new Cling(two(0.25, 0.26), 0.05);
  near(cling.distance(0.3, 0.6, 0.252, 0, 0, 1), -0.002);
  near(cling.distance(0.3, 0.6, 0.258, 0, 0, 1), 0.002);
  near(new Cling(two(0.25, 0.254), 0.05).distance(0.3, 0.6, 0.251, 0, 0, 1), 0.003);
});
