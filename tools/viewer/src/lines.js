// SPDX-License-Identifier: GPL-3.0-or-later
// Closed lines of a width in pixels, on a wider line of another colour, their casing.
import {Group, Vector4} from 'three/build/three.module.js';
import {Line2} from 'three/examples/jsm/lines/Line2.js';
import {LineGeometry} from 'three/examples/jsm/lines/LineGeometry.js';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {light} from './colours.js';

const viewport = new Vector4();

export class ClosedLine {
  // `points` are coordinates, the first point is not repeated
  constructor(points) {
    this.geometry = new LineGeometry();
    this.geometry.setPositions([...points, ...points.slice(0, 3)]);
    const line = (depthTest, order) => {
      const material = new LineMaterial({depthTest, transparent: !depthTest, depthWrite: depthTest});
      const result = new Line2(this.geometry, material);
      result.renderOrder = order;
      // widths are in pixels of the page, also where only a part of the canvas is drawn on; in a small one half of that
      result.onBeforeRender = renderer => {
        const {z: width, w: height} = renderer.getCurrentViewport(viewport).divideScalar(renderer.getPixelRatio());
        material.resolution.set(width, height).multiplyScalar(height < 200 ? 2 : 1);
      };
      return result;
    };
    this.ghost = line(false, 1);
    this.ghost.material.uniforms.opacity.value = 0.3;
    this.casing = line(true, 2);
    this.casing.material.depthWrite = false; // all lines are drawn over it
    this.line = line(true, 3);
    this.group = new Group();
    this.group.add(this.ghost, this.casing, this.line);
    this.ghost.visible = false;
  }

  // `border` is what the casing is wider on each side. A ghost shines through the surface.
  set({colour, width, casing, border, ghost}) {
    this.line.material.color.copy(light(colour));
    this.line.material.linewidth = width;
    this.casing.material.color.copy(light(casing));
    this.casing.material.linewidth = width + 2 * border;
    this.ghost.visible = ghost;
    this.ghost.material.color.copy(light(colour));
    this.ghost.material.linewidth = width;
  }

  dispose() {
    this.geometry.dispose();
    for (const l of [this.ghost, this.casing, this.line])
      l.material.dispose();
  }
}
