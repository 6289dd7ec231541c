// SPDX-License-Identifier: GPL-3.0-or-later
// The constrictions on the surface.
import {BufferAttribute, BufferGeometry, Group, Points, PointsMaterial, Vector3} from 'three/build/three.module.js';
import {ClosedLine} from './lines.js';
import {light, selection, sides} from './colours.js';

export class Curves {
  // Lines are lifted off the surface by `lift`.
  constructor(data, lift) {
    const {curve_points, curve_normals, curve_begins, pivots, pivot_begins} = data.arrays;
    this.data = data;
    this.group = new Group();
    this.pivots = new Points(new BufferGeometry(), new PointsMaterial({size: 7, sizeAttenuation: false}));
    this.pivots.renderOrder = 4;
    this.group.add(this.pivots);
    const lifted = new Float32Array(curve_points.length);
    for (let i = 0; i < lifted.length; ++i)
      lifted[i] = curve_points[i] + lift * curve_normals[i] / 127;
    this.points = data.curves.map((_, c) => lifted.subarray(3 * curve_begins[c], 3 * curve_begins[c + 1]));
    this.normals = data.curves.map((_, c) => curve_normals.subarray(3 * curve_begins[c], 3 * curve_begins[c + 1]));
    this.pivotPoints = data.curves.map((_, c) =>
      Float32Array.from([...pivots.subarray(pivot_begins[c], pivot_begins[c + 1])]
        .flatMap(p => [...lifted.subarray(3 * p, 3 * p + 3)])));
    this.lines = new Map(); // made when they are first shown
  }

  line(c) {
    let line = this.lines.get(c);
    if (!line) {
      this.lines.set(c, line = new ClosedLine(this.points[c]));
      this.group.add(line.group);
    }
    return line;
  }

  // Shows the curves for which `isShown(c)`, the selected one, if any, wide.
  update(isShown, selected, scheme, width) {
    const pivots = [];
    this.data.curves.forEach((curve, c) => {
      if (!isShown(c)) {
        if (this.lines.has(c))
          this.lines.get(c).group.visible = false;
        return;
      }
      const line = this.line(c), isSelected = c === selected;
      line.group.visible = true;
      line.set({
        colour: sides[curve.side].colour,
        width: isSelected ? 1.8 * width : width,
        casing: isSelected ? selection : scheme.casing,
        border: isSelected ? 3 : 1,
        ghost: isSelected,
      });
      if (isSelected)
        pivots.push(...this.pivotPoints[c]);
    });
    this.pivots.geometry.dispose();
    this.pivots.geometry = new BufferGeometry();
    this.pivots.geometry.setAttribute('position', new BufferAttribute(new Float32Array(pivots), 3));
    this.pivots.material.color.copy(light(scheme.casing));
    this.pivots.visible = pivots.length > 0;
  }

  // The shown curve nearest to a place on the screen, of those on the visible side of the surface, or -1.
  // `x` and `y` and the distance are in pixels.
  at(x, y, distance, camera, width, height, isShown) {
    const p = new Vector3(), n = new Vector3(), toCamera = new Vector3();
    let best = -1, least = distance;
    this.points.forEach((points, c) => {
      if (!isShown(c))
        return;
      for (let i = 0; i < points.length; i += 3) {
        p.fromArray(points, i);
        n.fromArray(this.normals[c], i);
        if (n.dot(toCamera.subVectors(camera.position, p)) < 0)
          continue;
        p.project(camera);
        const d = Math.hypot((p.x + 1) / 2 * width - x, (1 - p.y) / 2 * height - y);
        if (d < least) {
          least = d;
          best = c;
        }
      }
    });
    return best;
  }
}
