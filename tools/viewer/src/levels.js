// SPDX-License-Identifier: GPL-3.0-or-later
// The levels of the surface. The collapse i takes out the vertex with the number n - 1 - i, merges it into parents[i],
// and moves that to moves[i].

// The corners and points of the surface after `collapses` collapses: {points, faces}; O(n).
export function levelSurface({levels_points, levels_faces, levels_parents, levels_moves}, collapses) {
  if (collapses === 0)
    return {points: levels_points, faces: levels_faces};
  const n = levels_points.length / 3, left = n - collapses;
  const points = levels_points.slice();
  for (let i = 0; i < collapses; ++i)
    points.set(levels_moves.subarray(3 * i, 3 * i + 3), 3 * levels_parents[i]);

  // who stands for a vertex: parents have smaller numbers than those merged into them
  const standsFor = new Uint32Array(n);
  for (let v = 0; v < n; ++v)
    standsFor[v] = v < left ? v : standsFor[levels_parents[n - 1 - v]];
  const faces = new Uint32Array(levels_faces.length);
  let size = 0;
  for (let f = 0; f < levels_faces.length; f += 3) {
    const a = standsFor[levels_faces[f]], b = standsFor[levels_faces[f + 1]], c = standsFor[levels_faces[f + 2]];
    if (a !== b && b !== c && c !== a) {
      faces[size++] = a;
      faces[size++] = b;
      faces[size++] = c;
    }
  }
  return {points, faces: faces.subarray(0, size)};
}
