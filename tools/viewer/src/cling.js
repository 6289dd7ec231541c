// SPDX-License-Identifier: GPL-3.0-or-later
// A simplified surface lies a little above or below the curves of the input. Here it is found how much, so that they can
// be drawn on it.

const slots = 1 << 17;

// Sheets of a rough surface that are not further from each other: the uppermost counts.
const fold = 0.005;

export class Cling {
  // Faces are found by the cells of a grid, as wide as `reach`, in a hash table: those of slot s are
  // entries[begin[s]], ..., entries[begin[s + 1] - 1].
  constructor({points, faces}, reach) {
    this.points = points;
    this.faces = faces;
    this.reach = reach;
    const count = new Uint32Array(slots + 1);
    for (let f = 0; f < faces.length; f += 3)
      this.forCellsOfFace(f, slot => ++count[slot + 1]);
    for (let s = 0; s < slots; ++s)
      count[s + 1] += count[s];
    this.begin = count.slice();
    this.entries = new Uint32Array(count[slots]);
    for (let f = 0; f < faces.length; f += 3)
      this.forCellsOfFace(f, slot => this.entries[count[slot]++] = f);
  }

  forCellsOfFace(f, visit) {
    const {points: p, faces} = this, a = 3 * faces[f], b = 3 * faces[f + 1], c = 3 * faces[f + 2];
    this.forCells(Math.min(p[a], p[b], p[c]), Math.min(p[a + 1], p[b + 1], p[c + 1]),
      Math.min(p[a + 2], p[b + 2], p[c + 2]), Math.max(p[a], p[b], p[c]), Math.max(p[a + 1], p[b + 1], p[c + 1]),
      Math.max(p[a + 2], p[b + 2], p[c + 2]), visit);
  }

  // Calls visit(slot) for the cells of a box.
  forCells(x0, y0, z0, x1, y1, z1, visit) {
    const cell = x => Math.floor(x / this.reach);
    for (let x = cell(x0); x <= cell(x1); ++x)
      for (let y = cell(y0); y <= cell(y1); ++y)
        for (let z = cell(z0); z <= cell(z1); ++z)
          visit((Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) & (slots - 1));
  }

  // How far from (x, y, z) along the unit vector (nx, ny, nz) the surface is that looks there, where it is nearest, or
  // above that where it is folded; 0 if it is not within reach.
  distance(x, y, z, nx, ny, nz) {
    const {points: p, faces, reach, begin, entries} = this;
    const rx = reach * Math.abs(nx), ry = reach * Math.abs(ny), rz = reach * Math.abs(nz);
    const found = [];
    this.forCells(x - rx, y - ry, z - rz, x + rx, y + ry, z + rz, slot => {
      for (let e = begin[slot]; e < begin[slot + 1]; ++e) {
        const f = entries[e], a = 3 * faces[f], b = 3 * faces[f + 1], c = 3 * faces[f + 2];
        const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
        const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
        const px = ny * vz - nz * vy, py = nz * vx - nx * vz, pz = nx * vy - ny * vx;
        const determinant = ux * px + uy * py + uz * pz;
        if (determinant >= 0) // it looks the other way
          continue;
        const tx = x - p[a], ty = y - p[a + 1], tz = z - p[a + 2];
        const s = (tx * px + ty * py + tz * pz) / determinant;
        if (s < 0 || s > 1)
          continue;
        const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
        const t = (nx * qx + ny * qy + nz * qz) / determinant;
        const d = (vx * qx + vy * qy + vz * qz) / determinant;
        if (t >= 0 && s + t <= 1 && Math.abs(d) <= reach)
          found.push(d);
      }
    });
    if (found.length === 0)
      return 0;
    found.sort((d, e) => d - e);
    let i = found.reduce((best, d, j) => Math.abs(d) < Math.abs(found[best]) ? j : best, 0);
    while (i + 1 < found.length && found[i + 1] - found[i] < fold)
      ++i;
    return found[i];
  }
}
