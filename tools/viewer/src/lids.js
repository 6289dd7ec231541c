// SPDX-License-Identifier: GPL-3.0-or-later
// Lids on the cuts of parts that are drawn apart or alone: each cut is filled from the centre of its curve.
import {BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, Vector3, VertexColors}
  from 'three/build/three.module.js';

export class Lids {
  constructor() {
    this.mesh = new Mesh(new BufferGeometry(), new MeshBasicMaterial({vertexColors: VertexColors, side: DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4}));
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  // `lids` are of each the points of its curve, the vector that it is moved by, and its colour.
  set(lids, brightness) {
    this.mesh.visible = lids.length > 0;
    const corners = [], colours = [], centre = new Vector3(), p = new Vector3();
    for (const {points, move, colour} of lids) {
      const n = points.length / 3;
      centre.set(0, 0, 0);
      for (let i = 0; i < n; ++i)
        centre.addScaledVector(p.fromArray(points, 3 * i), 1 / n);
      centre.add(move);
      const corner = i => p.fromArray(points, 3 * (i % n)).add(move).toArray();
      for (let i = 0; i < n; ++i) {
        corners.push(...centre.toArray(), ...corner(i), ...corner(i + 1));
        for (let j = 0; j < 3; ++j)
          colours.push(colour.r, colour.g, colour.b);
      }
    }
    this.mesh.geometry.dispose();
    const geometry = this.mesh.geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
    this.mesh.material.color.setScalar(brightness);
  }
}
