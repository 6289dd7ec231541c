// SPDX-License-Identifier: GPL-3.0-or-later
// From where a curve is seen well.
import {Vector3} from 'three/build/three.module.js';

const candidates = 96, lookedAtClosely = 8, samples = 12;

// Directions that are spread evenly over the sphere.
export const directions = Array.from({length: candidates}, (_, i) => {
  const z = 1 - (2 * i + 1) / candidates, angle = i * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - z * z);
  return new Vector3(r * Math.cos(angle), r * Math.sin(angle), z);
});

// The vector whose direction is that of the plane that fits a closed polygon, and whose length is twice the area.
export function areaVector(points) {
  const result = new Vector3(), p = new Vector3(), q = new Vector3();
  for (let i = 0; i < points.length; i += 3) {
    p.fromArray(points, i);
    q.fromArray(points, (i + 3) % points.length);
    result.add(p.cross(q));
  }
  return result;
}

// Returns a target, a direction and a radius. Of the directions from which the curve runs along the side of the surface
// that is seen, obliquely, and which are not far from where the camera is now, the best that nothing stands in the way of.
export function viewOfCurve(points, normals, surface, camera, target, up) {
  const centre = new Vector3(), p = new Vector3(), n = new Vector3(), count = points.length / 3;
  for (let i = 0; i < points.length; i += 3)
    centre.addScaledVector(p.fromArray(points, i), 1 / count);
  let radius = 0;
  for (let i = 0; i < points.length; i += 3)
    radius = Math.max(radius, centre.distanceTo(p.fromArray(points, i)));

  const axis = areaVector(points).normalize();
  const now = camera.position.clone().sub(target).normalize();
  const facing = d => {
    let sum = 0;
    for (let i = 0; i < normals.length; i += 3)
      sum += Math.max(0, n.fromArray(normals, i).dot(d));
    return sum / 127 / count;
  };
  const rated = directions.map(d => ({
    direction: d,
    rating: facing(d) - 0.5 * Math.abs(Math.abs(axis.dot(d)) - 0.35) + 0.25 * now.dot(d) - 0.3 * Math.abs(up.dot(d)),
  })).sort((a, b) => b.rating - a.rating).slice(0, lookedAtClosely);

  const step = Math.max(1, Math.floor(count / samples));
  for (const r of rated) {
    let seen = 0, all = 0;
    for (let i = 0; i < count; i += step, ++all) {
      p.fromArray(points, 3 * i);
      const d = r.direction;
      if (n.fromArray(normals, 3 * i).dot(d) > 0 && !surface.meets(p.x, p.y, p.z, d.x, d.y, d.z, 0.01))
        ++seen;
    }
    r.rating += seen / all;
  }
  rated.sort((a, b) => b.rating - a.rating);
  return {target: centre, direction: rated[0].direction, radius};
}
