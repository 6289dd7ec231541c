#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# MatGeom 1.2.3 for Octave 7.3.0 (octave-matgeom 1.2.3-3, octave 7.3.0-2): intersectPlaneMesh(), polyhedronSlice(), and
# sphereMesh().
#
# Guess: the section of a torus by a plane through its axis is two circles of the length 6.21, and that of an octahedron
# by a plane through two vertices is a rhombus with four corners.
# What happens: if edges end in the plane their point in it may be "not a number": of the torus one circle has six such
# points, so that its length is not a number either, and the other, equal one has none. Where there are numbers points
# come twice, six for the rhombus. A plane turned by a little gives numbers. polyhedronSlice() gives each corner of the
# square of an octahedron twice. sphereMesh() has 32 vertices at each pole, and 64 border edges.
#
# Why it matters: the length of a section is what one compares the length of a constriction with, and planes through the
# axis or through a waist go through vertices.
. "$(dirname "$0")/lib/packages.sh"
debian octave=7.3.0-2 octave-matgeom=1.2.3-3
LD_LIBRARY_PATH+=":$(dirname "$(find "$work/root/" -name liboctinterp.so.10)"):$work/root/usr/lib"
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done
export OCTAVE_HOME="$work/root/usr" HOME="$work"

cd "$work"
python3 - << 'END'
import meshes

for body in ("octahedron", "torus"):
    points, faces = getattr(meshes, body)()
    with open(body + ".points", "w") as out:
        out.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
    with open(body + ".faces", "w") as out:
        out.writelines("%d %d %d\n" % tuple(i + 1 for i in f) for f in faces)
END
cat > sections.m << 'END'
for folder = {'geom2d', 'geom3d', 'graphs', 'meshes3d', 'polygons2d', 'utils'}
  addpath([getenv('OCTAVE_HOME') '/share/octave/packages/matgeom-1.2.3/' folder{1}]);
end
planes = {'flat', [0 0 0 1 0 0 0 1 0]; 'beside', [0 0 .1 1 0 0 0 1 0]; 'through the axis', [0 0 0 1 1 0 0 0 1];
          'turned', [0 0 0 1 1.01 0 0 0 1]};
for body = {'octahedron', 'torus'}
  v = load([body{1} '.points']);
  f = load([body{1} '.faces']);
  for i = 1:rows(planes)
    lines = intersectPlaneMesh(planes{i, 2}, v, f);
    for j = 1:numel(lines)
      q = lines{j};
      steps = sqrt(sum(diff([q; q(1, :)]).^2, 2));
      printf('%s, %s: points %d, not numbers %d, steps of length 0 %d, length %.3f\n', body{1}, planes{i, 1}, ...
             rows(q), sum(any(isnan(q), 2)), sum(steps == 0), sum(steps));
    end
  end
end
q = polyhedronSlice(load('octahedron.points'), load('octahedron.faces'), planes{1, 2});
printf('polyhedronSlice: points %d at %d places\n', rows(q), rows(unique(q, 'rows')));
[v, f] = sphereMesh([0 0 0 1]);
corners = sort([f(:, [1 2]); f(:, [2 3]); f(:, [3 4]); f(:, [4 1])], 2);
[~, ~, k] = unique(corners, 'rows');
printf('sphereMesh: vertices %d, at the poles %d, border edges %d\n', rows(v), sum(abs(v(:, 3)) == 1), ...
       sum(accumarray(k, 1) == 1));
END
verdict "$(octave-cli --no-history --quiet --norc sections.m 2> octave.log)" \
"octahedron, flat: points 4, not numbers 0, steps of length 0 0, length 5.657
octahedron, beside: points 4, not numbers 0, steps of length 0 0, length 5.091
octahedron, through the axis: points 6, not numbers 0, steps of length 0 2, length 4.899
octahedron, turned: points 6, not numbers 0, steps of length 0 2, length 4.899
torus, flat: points 48, not numbers 0, steps of length 0 24, length 18.796
torus, flat: points 48, not numbers 0, steps of length 0 0, length 6.265
torus, beside: points 48, not numbers 0, steps of length 0 0, length 18.628
torus, beside: points 48, not numbers 0, steps of length 0 0, length 6.433
torus, through the axis: points 30, not numbers 6, steps of length 0 5, length NaN
torus, through the axis: points 24, not numbers 0, steps of length 0 0, length 6.212
torus, turned: points 24, not numbers 0, steps of length 0 0, length 6.210
torus, turned: points 24, not numbers 0, steps of length 0 0, length 6.210
polyhedronSlice: points 8 at 4 places
sphereMesh: vertices 544, at the poles 64, border edges 64"
