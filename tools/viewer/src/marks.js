// SPDX-License-Identifier: GPL-3.0-or-later
// In a corner of the picture: the axes of the file, and a bar with its length in the unit of the file.
import {Vector3} from 'three/build/three.module.js';
import {rounded} from './list.js';

const longest = 130, arm = 24; // pixels
export const marksSize = [210, 76];

// The greatest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that is not greater than `x`, a positive number.
export function roundLength(x) {
  const power = Math.pow(10, Math.floor(Math.log10(x)));
  const digit = [5, 2].find(d => d * power <= x) ?? 1;
  return Number((digit * power).toPrecision(1));
}

// The bar: how long it is in the file, and in pixels. `unit` is the length in the file of a unit on the page; of those
// there are `pixels` at the centre of the view.
export function scaleBar(unit, pixels) {
  const length = roundLength(longest / pixels * unit);
  return {length, width: length / unit * pixels, text: `${rounded(length)} ${length === 1 ? 'unit' : 'units'} of the file`};
}

// Draws on a 2D context, in a box of `marksSize`.
export function drawMarks(context, camera, bar, ink) {
  const [, height] = marksSize, right = new Vector3(), up = new Vector3(), towards = new Vector3();
  camera.matrixWorld.extractBasis(right, up, towards);
  const axes = ['x', 'y', 'z'].map((name, i) => ({name, x: right.getComponent(i), y: up.getComponent(i),
    z: towards.getComponent(i)})).sort((a, b) => a.z - b.z);
  context.save();
  context.font = '600 12px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
  context.strokeStyle = context.fillStyle = ink;
  context.lineCap = 'round';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const [x0, y0] = [arm + 12, height - arm - 14];
  for (const {name, x, y, z} of axes) {
    // what points away is faint
    context.globalAlpha = z < -0.1 ? 0.45 : 1;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x0 + arm * x, y0 - arm * y);
    context.stroke();
    // an axis that points at the viewer has its name beside it
    const length = Math.max(Math.hypot(x, y), 1e-6), far = arm * length + 9;
    context.fillText(name, x0 + far * x / length, y0 - far * y / length);
  }
  context.globalAlpha = 1;
  const left = 2 * arm + 30, bottom = height - 12;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(left, bottom - 6);
  context.lineTo(left, bottom);
  context.lineTo(left + bar.width, bottom);
  context.lineTo(left + bar.width, bottom - 6);
  context.stroke();
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillText(bar.text, left, bottom - 10);
  context.restore();
}

export class Marks {
  // `unit` is the length in the file of a unit on the page.
  constructor(canvas, unit) {
    this.canvas = canvas;
    this.unit = unit;
    this.text = '';
  }

  update(camera, pixels) {
    const [width, height] = marksSize, ratio = Math.min(window.devicePixelRatio || 1, 2);
    this.canvas.width = width * ratio; // clears it
    this.canvas.height = height * ratio;
    this.draw(this.canvas.getContext('2d'), ratio, camera, pixels);
    const text = `Axes of the file, and a scale: the bar is ${this.bar.text} long, at the depth of the centre of the view`;
    if (text !== this.text)
      this.canvas.setAttribute('aria-label', this.text = text);
  }

  draw(context, ratio, camera, pixels) {
    this.bar = scaleBar(this.unit, pixels);
    context.scale(ratio, ratio);
    drawMarks(context, camera, this.bar, getComputedStyle(document.body).color);
  }
}
