#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# FreeFEM 4.11 (freefem++ and libfreefem++ 4.11+dfsg1-3): extract() of a surface from a mesh of tetrahedra.
#
# Guess: the surface of a mesh of tetrahedra faces outwards, and a closed surface that is filled with tetrahedra and
# taken off again is the one that it was. A mirrored mesh has positive volume, since its elements are turned over.
# What happens: the surface faces inwards: of a cube, of a part of it, and of a torus that faced outwards before it was
# filled. Mirrored by movemesh() the tetrahedra are not turned over: the integral of 1 over the cube is -1, which is
# said on the way and is no error, and then the surface that is extracted faces outwards.
#
# Why it matters: surfaces for a search for necks come from meshes of simulations. On a surface that faces inwards the
# side on which a curve chokes is the other one. "constrictions check" says "the normals point inside".
. "$(dirname "$0")/lib/packages.sh"
debian freefem++=4.11+dfsg1-3 libfreefem++=4.11+dfsg1-3
export FF_LOADPATH="$work/root/usr/lib/freefem++"

cat > "$work/extract.edp" << 'END'
load "msh3"
load "tetgen"

func real byFaces(meshS & S) {
  real sum = 0;
  for (int i = 0; i < S.nt; i++) {
    real[int] a = [S[i][0].x, S[i][0].y, S[i][0].z], b = [S[i][1].x, S[i][1].y, S[i][1].z];
    real[int] c = [S[i][2].x, S[i][2].y, S[i][2].z];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

func int report(string what, mesh3 & T) {
  meshS S = extract(T);
  cout << what << ": volume of the tetrahedra " << int3d(T)(1.) << ", of the surface " << byFaces(S)
       << ", triangles " << S.nt << endl;
  return 0;
}

mesh3 box = cube(4, 4, 4);
mesh3 half = trunc(box, x < 0.5);
mesh3 mirrored = movemesh(box, [-x, y, z]);
report("cube", box);
report("half of it", half);
report("mirrored cube", mirrored);

mesh flat = square(20, 10, [2 * pi * x, 2 * pi * y]);
meshS torus = movemesh23(flat, transfo = [(2 + cos(y)) * cos(x), (2 + cos(y)) * sin(x), sin(y)]);
cout << "torus: volume of the surface " << byFaces(torus) << ", triangles " << torus.nt << endl;
mesh3 filled = tetg(torus, switch = "pqaAYYQ");
report("torus, filled", filled);
END
cd "$work"
verdict "$(FreeFem++-nw -nw -v 0 extract.edp 2> freefem.log)" \
" Error of mesh orientation , current orientation = 1
 mesure element mesh = -1
 mesure border mesh = 6
cube: volume of the tetrahedra 1, of the surface -1, triangles 192
half of it: volume of the tetrahedra 0.5, of the surface -0.5, triangles 128
mirrored cube: volume of the tetrahedra -1, of the surface 1, triangles 192
torus: volume of the surface 36.3271, triangles 400
torus, filled: volume of the tetrahedra 36.3271, of the surface -36.3271, triangles 400"
