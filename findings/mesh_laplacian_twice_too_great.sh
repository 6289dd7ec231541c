#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# mesh-laplacian 1.0.0 (npm): the discrete Laplacian of a triangle mesh as a sparse matrix.
#
# Guess: the matrix is the one of cotangents, divided by the areas around the vertices: applied to the coordinates of a
# unit sphere it gives vectors of length 2, twice the mean curvature, and applied to x * x on a plane it gives 2.
# What happens: it gives 4, that is twice as much: the sum of the two cotangents of an edge is not halved. And triangles
# whose area is less than 1e-8 are left out, whatever the size of the mesh: of a sphere of 1280 triangles and radius
# 0.001 a third of the entries is missing, so that the vectors are four times too long, and of one of radius 0.0005 all
# but the diagonal, which is 0. There is no message.
#
# Why it matters: mean curvature and heat flow are made from this matrix, the one for necks, the other for geodesic
# distances. Curvatures are twice the true ones, a time step is half of it, and a mesh of millimetres in metres is flat.
. "$(dirname "$0")/lib/packages.sh"
npm_packages mesh-laplacian@1.0.0 icosphere@1.0.0

cd "$work"
cat > laplacian.cjs << 'END'
const icosphere = require('icosphere');
const laplacian = require('mesh-laplacian');

function applied(matrix, values) {
  const result = values.map(() => 0);
  for (const [i, j, weight] of matrix) {
    result[i] += weight * values[j];
  }
  return result;
}

const { cells, positions } = icosphere(3);
for (const radius of [1, 0.001, 0.0005]) {
  const points = positions.map(p => p.map(x => radius * x));
  const matrix = laplacian(cells, points);
  const vectors = [0, 1, 2].map(k => applied(matrix, points.map(p => p[k])));
  const lengths = points.map((_, i) => radius * Math.hypot(...vectors.map(v => v[i])));
  const mean = lengths.reduce((sum, x) => sum + x) / lengths.length;
  console.log(`sphere of radius ${radius}: entries ${matrix.length}, radius times length of the vectors, ` +
              `mean ${mean.toFixed(2)}`);
}

const n = 10, points = [], triangles = [];
for (let i = 0; i <= n; ++i) {
  for (let j = 0; j <= n; ++j) {
    points.push([i / n, j / n, 0]);
    if (i < n && j < n) {
      const a = i * (n + 1) + j, b = a + n + 1;
      triangles.push([a, b, b + 1], [a, b + 1, a + 1]);
    }
  }
}
const values = applied(laplacian(triangles, points), points.map(p => p[0] * p[0]));
const inner = values.filter((_, k) => points[k].slice(0, 2).every(x => x > 0 && x < 1)).map(x => x.toFixed(2));
console.log(`Laplacian of x * x on a plane: ${[...new Set(inner)].join(', ')}`);
END
verdict "$(node laplacian.cjs)" \
"sphere of radius 1: entries 4482, radius times length of the vectors, mean 4.01
sphere of radius 0.001: entries 2922, radius times length of the vectors, mean 8.65
sphere of radius 0.0005: entries 642, radius times length of the vectors, mean 0.00
Laplacian of x * x on a plane: 4.00"
