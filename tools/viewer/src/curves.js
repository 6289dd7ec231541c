// SPDX-License-Identifier: GPL-3.0-or-later
// The constrictions on the surface.
import {BufferAttribute, BufferGeometry, Group, Points, PointsMaterial, Vector3} from 'three/build/three.module.js';
import {Cling} from './cling.js';
import {ClosedLine} from './lines.js';
import {light, selection, sides} from './colours.js';

// How far a simplified surface may be from the curves.
const reach = 0.02;

const none = new Vector3();

export class Curves {
  // Lines are lifted off the surface by `lift`. If the surface that is drawn is `simplified` they are put onto that.
  constructor(data, lift, simplified) {
    const {curve_normals, curve_begins} = data.arrays;
    this.data = data;
    this.lift = lift;
    this.simplified = simplified;
    this.cling = null;
    this.group = new Group();
    this.pivots = new Points(new BufferGeometry(), new PointsMaterial({size: 7, sizeAttenuation: false}));
    this.pivots.renderOrder = 4;
    this.group.add(this.pivots);
    this.lifted = data.curves.map(() => null); // made when they are first shown
    this.normals = data.curves.map((_, c) => curve_normals.subarray(3 * curve_begins[c], 3 * curve_begins[c + 1]));
    this.moves = null;
    this.lines = new Map(); // made when they are first shown
  }

  // The points through which curve c is drawn.
  points(c) {
    const {curve_points, curve_begins} = this.data.arrays;
    if (this.lifted[c])
      return this.lifted[c];
    const result = this.lifted[c] = curve_points.slice(3 * curve_begins[c], 3 * curve_begins[c + 1]);
    if (this.simplified)
      this.cling ??= new Cling(this.simplified, reach);
    for (let i = 0; i < result.length; i += 3) {
      const [x, y, z] = result.subarray(i, i + 3), n = this.normals[c].subarray(i, i + 3);
      const length = Math.hypot(...n) || 1;
      const [nx, ny, nz] = [n[0] / length, n[1] / length, n[2] / length];
      const up = this.lift + (this.cling ? this.cling.distance(x, y, z, nx, ny, nz) : 0);
      result.set([x + up * nx, y + up * ny, z + up * nz], i);
    }
    return result;
  }

  // The points of curve c that are pivots.
  pivotsOf(c) {
    const {pivots, pivot_begins, curve_begins} = this.data.arrays, points = this.points(c);
    return [...pivots.subarray(pivot_begins[c], pivot_begins[c + 1])]
      .flatMap(p => [...points.subarray(3 * (p - curve_begins[c]), 3 * (p - curve_begins[c]) + 3)]);
  }

  line(c) {
    let line = this.lines.get(c);
    if (!line) {
      this.lines.set(c, line = new ClosedLine(this.points(c)));
      this.group.add(line.group);
    }
    return line;
  }

  // Shows the curves for which `isShown(c)`, the selected one, if any, wide, and the one that the pointer is on.
  update(isShown, {selected, hovered}, scheme, width) {
    let pivots = [];
    this.data.curves.forEach((curve, c) => {
      if (!isShown(c)) {
        if (this.lines.has(c))
          this.lines.get(c).group.visible = false;
        return;
      }
      const line = this.line(c), isSelected = c === selected;
      line.group.visible = true;
      line.group.position.copy(this.moveOf(c));
      line.set({
        colour: sides[curve.side].colour,
        width: isSelected || c === hovered ? 1.8 * width : width,
        casing: isSelected ? selection : scheme.casing,
        border: isSelected ? 3 : 1,
        ghost: isSelected,
      });
      if (isSelected) {
        pivots = this.pivotsOf(c);
        this.pivots.position.copy(this.moveOf(c));
      }
    });
    this.pivots.geometry.dispose();
    this.pivots.geometry = new BufferGeometry();
    this.pivots.geometry.setAttribute('position', new BufferAttribute(new Float32Array(pivots), 3));
    this.pivots.material.color.copy(light(scheme.casing));
    this.pivots.visible = pivots.length > 0;
  }

  // How far curve c is drawn from where it is.
  moveOf(c) { return this.moves ? this.moves[c] : none; }

  // The shown curve nearest to a place on the screen, of those on the visible side of the surface, or -1.
  // `x` and `y` and the distance are in pixels. `isSeen(p)` says whether nothing is in front of a point.
  at(x, y, distance, camera, width, height, isShown, isSeen) {
    const p = new Vector3(), q = new Vector3(), n = new Vector3(), toCamera = new Vector3();
    let best = -1, least = distance;
    this.data.curves.forEach((_, c) => {
      if (!isShown(c))
        return;
      const points = this.points(c), move = this.moveOf(c);
      for (let i = 0; i < points.length; i += 3) {
        p.fromArray(points, i).add(move);
        n.fromArray(this.normals[c], i);
        if (n.dot(toCamera.subVectors(camera.position, p)) < 0)
          continue;
        q.copy(p).project(camera);
        const d = Math.hypot((q.x + 1) / 2 * width - x, (1 - q.y) / 2 * height - y);
        if (d < least && isSeen(p)) {
          least = d;
          best = c;
        }
      }
    });
    return best;
  }
}
