// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that is drawn: triangles with colours, and the edges of the mesh.
import {BackSide, BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, MeshPhongMaterial, VertexColors} from 'three/build/three.module.js';
import {light} from './colours.js';

const cosineOfCrease = Math.cos(40 * Math.PI / 180);

// The normals at the corners of the faces. At a corner the normals of those faces around the vertex are added, weighted
// with area, whose planes make no crease with that of the face; none but its own if `isFlat`.
function cornerNormals(points, faces, isFlat) {
  const normals = new Float32Array(3 * faces.length), n = faces.length / 3;
  const areas = new Float32Array(3 * n), units = new Float32Array(3 * n);
  for (let f = 0; f < n; ++f) {
    const a = 3 * faces[3 * f], b = 3 * faces[3 * f + 1], c = 3 * faces[3 * f + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, l = Math.hypot(x, y, z) || 1;
    areas.set([x, y, z], 3 * f);
    units.set([x / l, y / l, z / l], 3 * f);
  }
  if (isFlat) {
    for (let i = 0; i < faces.length; ++i) {
      const f = Math.floor(i / 3);
      normals.set(units.subarray(3 * f, 3 * f + 3), 3 * i);
    }
    return normals;
  }

  const begin = new Uint32Array(points.length / 3 + 2);
  for (const v of faces)
    ++begin[v + 2];
  for (let v = 2; v < begin.length; ++v)
    begin[v] += begin[v - 1];
  const around = new Uint32Array(faces.length);
  for (let i = 0; i < faces.length; ++i)
    around[begin[faces[i] + 1]++] = Math.floor(i / 3);
  for (let i = 0; i < faces.length; ++i) {
    const f = 3 * Math.floor(i / 3), v = faces[i];
    let x = areas[f], y = areas[f + 1], z = areas[f + 2];
    for (let j = begin[v]; j < begin[v + 1]; ++j) {
      const g = 3 * around[j];
      if (g !== f && units[f] * units[g] + units[f + 1] * units[g + 1] + units[f + 2] * units[g + 2] > cosineOfCrease) {
        x += areas[g];
        y += areas[g + 1];
        z += areas[g + 2];
      }
    }
    const l = Math.hypot(x, y, z) || 1;
    normals[3 * i] = x / l;
    normals[3 * i + 1] = y / l;
    normals[3 * i + 2] = z / l;
  }
  return normals;
}

// Each edge once, with a face at it: its halfedges run in opposite directions, and on the boundary there is only one.
function edgesOf(points, faces) {
  const ends = [], facesOfEdges = [], n = points.length / 3, ascending = new Set();
  for (let f = 0; f < faces.length; f += 3)
    for (let i = 0; i < 3; ++i)
      if (faces[f + i] < faces[f + (i + 1) % 3])
        ascending.add(faces[f + i] * n + faces[f + (i + 1) % 3]);
  for (let f = 0; f < faces.length; f += 3)
    for (let i = 0; i < 3; ++i) {
      const a = faces[f + i], b = faces[f + (i + 1) % 3];
      if (a < b || !ascending.has(b * n + a)) {
        ends.push(points[3 * a], points[3 * a + 1], points[3 * a + 2], points[3 * b], points[3 * b + 1], points[3 * b + 2]);
        facesOfEdges.push(f / 3);
      }
    }
  return {ends: new Float32Array(ends), facesOfEdges};
}

// Moves each element, of which `size` numbers in a row are the corners, by the vector `moveOf(i)`. Without one it becomes
// a point, which is not drawn.
function moved(numbers, size, moveOf) {
  const result = numbers.slice();
  for (let i = 0; size * i < numbers.length; ++i) {
    const move = moveOf(i);
    for (let j = size * i; j < size * (i + 1); j += 3) {
      result[j] = move ? numbers[j] + move.x : 0;
      result[j + 1] = move ? numbers[j + 1] + move.y : 0;
      result[j + 2] = move ? numbers[j + 2] + move.z : 0;
    }
  }
  return result;
}

export class Surface {
  // Through holes the inside is seen.
  constructor(hasHoles) {
    // Dull, but shaded at each pixel; pushed back a little, so that lines on it are in front of it.
    const material = new MeshPhongMaterial({vertexColors: VertexColors, specular: 0, side: hasHoles ? DoubleSide : FrontSide,
      polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4});
    this.mesh = new Mesh(new BufferGeometry(), material);
    // What is seen through a cut of a closed surface: all of one brightness, it looks like a lid.
    this.inside = new Mesh(this.mesh.geometry, new MeshBasicMaterial({vertexColors: VertexColors, side: BackSide,
      polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4}));
    this.inside.visible = false;
    this.hasHoles = hasHoles;
    this.edges = new LineSegments(new BufferGeometry(), new LineBasicMaterial({transparent: true, opacity: 0.35}));
    this.edges.visible = false;
    this.group = new Group();
    this.group.add(this.mesh, this.inside, this.edges);
    for (const object of this.group.children)
      object.frustumCulled = false; // it is moved
    this.hasEdges = false;
    this.moveOf = null;
  }

  set({points, faces}, isFlat) {
    this.points = points;
    this.faces = faces;
    const corners = new Float32Array(3 * faces.length);
    for (let i = 0; i < faces.length; ++i) {
      const v = 3 * faces[i];
      corners[3 * i] = points[v];
      corners[3 * i + 1] = points[v + 1];
      corners[3 * i + 2] = points[v + 2];
    }
    this.mesh.geometry.dispose();
    this.corners = corners;
    this.moveOf = null;
    const geometry = this.mesh.geometry = this.inside.geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.setAttribute('normal', new BufferAttribute(cornerNormals(points, faces, isFlat), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(corners.length).fill(1), 3));
    this.hasEdges = false;
    this.showEdges(this.edges.visible);
  }

  // Moves each face by the vector `moveOf(f)`; if that is null the face is not drawn. Without `moveOf` all faces are where
  // they were.
  place(moveOf) {
    if (!moveOf && !this.moveOf)
      return;
    this.moveOf = moveOf;
    this.mesh.geometry.setAttribute('position',
      new BufferAttribute(moveOf ? moved(this.corners, 9, moveOf) : this.corners, 3));
    this.hasEdges = false;
    this.showEdges(this.edges.visible);
  }

  // Whether what is inside is seen, in colours of this brightness.
  showInside(visible, brightness) {
    this.inside.visible = visible && !this.hasHoles;
    this.inside.material.color.setScalar(brightness);
  }

  // `colourOfFace(f)` is a three.js colour.
  colour(colourOfFace) {
    const attribute = this.mesh.geometry.getAttribute('color'), numbers = attribute.array;
    for (let f = 0; 9 * f < numbers.length; ++f) {
      const {r, g, b} = colourOfFace(f);
      for (let i = 9 * f; i < 9 * f + 9; i += 3) {
        numbers[i] = r;
        numbers[i + 1] = g;
        numbers[i + 2] = b;
      }
    }
    attribute.needsUpdate = true;
  }

  showEdges(visible, colour) {
    this.edges.visible = visible;
    if (colour)
      this.edges.material.color.copy(light(colour));
    if (!visible || this.hasEdges || !this.faces)
      return;
    this.edges.geometry.dispose();
    this.edges.geometry = new BufferGeometry();
    const {ends, facesOfEdges} = edgesOf(this.points, this.faces);
    this.edges.geometry.setAttribute('position', new BufferAttribute(
      this.moveOf ? moved(ends, 6, e => this.moveOf(facesOfEdges[e])) : ends, 3));
    this.hasEdges = true;
  }

  // The face that a ray meets first, as it is drawn, and how far away: {face, distance}. `isCut(x, y, z)` says whether a
  // place has been cut away.
  at({origin: o, direction: d}, isCut) {
    const p = this.mesh.geometry.getAttribute('position').array;
    let face = -1, distance = Infinity;
    for (let a = 0; a < p.length; a += 9) {
      const ux = p[a + 3] - p[a], uy = p[a + 4] - p[a + 1], uz = p[a + 5] - p[a + 2];
      const vx = p[a + 6] - p[a], vy = p[a + 7] - p[a + 1], vz = p[a + 8] - p[a + 2];
      const px = d.y * vz - d.z * vy, py = d.z * vx - d.x * vz, pz = d.x * vy - d.y * vx;
      const determinant = ux * px + uy * py + uz * pz;
      if (determinant === 0)
        continue;
      const tx = o.x - p[a], ty = o.y - p[a + 1], tz = o.z - p[a + 2];
      const s = (tx * px + ty * py + tz * pz) / determinant;
      if (s < 0 || s > 1)
        continue;
      const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
      const t = (d.x * qx + d.y * qy + d.z * qz) / determinant;
      const away = (vx * qx + vy * qy + vz * qz) / determinant;
      if (t < 0 || s + t > 1 || away <= 0 || away >= distance)
        continue;
      if (isCut(o.x + away * d.x, o.y + away * d.y, o.z + away * d.z))
        continue;
      face = a / 9;
      distance = away;
    }
    return {face, distance};
  }

  // Whether the ray from a point meets a face, further away than `from`.
  meets(ox, oy, oz, dx, dy, dz, from) {
    const {points: p, faces} = this;
    for (let f = 0; f < faces.length; f += 3) {
      const a = 3 * faces[f], b = 3 * faces[f + 1], c = 3 * faces[f + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
      const determinant = ux * px + uy * py + uz * pz;
      if (determinant === 0)
        continue;
      const tx = ox - p[a], ty = oy - p[a + 1], tz = oz - p[a + 2];
      const s = (tx * px + ty * py + tz * pz) / determinant;
      if (s < 0 || s > 1)
        continue;
      const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
      const t = (dx * qx + dy * qy + dz * qz) / determinant;
      if (t >= 0 && s + t <= 1 && (vx * qx + vy * qy + vz * qz) / determinant > from)
        return true;
    }
    return false;
  }
}
