#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# DOLFIN 2019.2.0 of FEniCS (python3-dolfin 2019.2.0~git20230116.bd54183-2), BoundaryMesh of a mesh of tetrahedra.
#
# Guess: the boundary of a mesh of a body is a closed surface that faces outwards.
# What happens: by default the vertices of each triangle are sorted by their numbers, and what side it faces is chance:
# of a cube of 384 tetrahedra 252 of 288 edges are run through twice in one direction, and the volume by the faces is
# 0.02. With the third argument, "order", set to False they are not sorted, and the surface faces outwards.
#
# Why it matters: surfaces of simulations are taken with this class and written for other programs. Every triangle is
# there, in its place, and a viewer shows them; a halfedge structure cannot be built of them.
. "$(dirname "$0")/lib/packages.sh"
debian python3-dolfin=2019.2.0~git20230116.bd54183-2
libraries="$work/root/usr/lib/$triplet"
real=$(echo "$work"/root/usr/lib/petscdir/petsc3.18/*-real/lib)
export LD_LIBRARY_PATH+=":$real:$libraries/blas:$libraries/lapack:$libraries/openmpi/lib"
export PYTHONPATH+=":$real/python3/dist-packages:$(echo "$work"/root/usr/lib/petsc4py/petsc4py3.18/*-real/lib)"
export PKG_CONFIG_PATH="$libraries/pkgconfig:$real/pkgconfig:$work/root/usr/share/pkgconfig"
export OPAL_PREFIX="$work/root/usr" OPAL_LIBDIR="$libraries/openmpi/lib" HOME="$work"

cd "$work"
cat > boundaries.py << 'END'
import dolfin
import meshes

dolfin.set_log_level(50)
cube = dolfin.UnitCubeMesh(4, 4, 4)
box = dolfin.BoxMesh(dolfin.Point(0, 0, 0), dolfin.Point(1, 2, 3), 2, 2, 2)
for name, mesh in (("cube", cube), ("box", box)):
    for what, arguments in (("by default", ()), ("not ordered", (False,))):
        boundary = dolfin.BoundaryMesh(mesh, "exterior", *arguments)
        points = [tuple(p) for p in boundary.coordinates()]
        faces = [tuple(map(int, c)) for c in boundary.cells()]
        directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
        print("%s, %s: volume %.2f, by the faces %.2f, run through twice in one direction %d, %s" % (
            name, what, sum(c.volume() for c in dolfin.cells(mesh)), meshes.volume(points, faces),
            len(directed) - len(set(directed)), meshes.describe(faces)))
END
verdict "$(/usr/bin/python3 boundaries.py 2> dolfin.log)" \
"cube, by default: volume 1.00, by the faces 0.02, run through twice in one direction 252, V 98, F 192, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
cube, not ordered: volume 1.00, by the faces 1.00, run through twice in one direction 0, V 98, F 192, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
box, by default: volume 6.00, by the faces 0.50, run through twice in one direction 56, V 26, F 48, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
box, not ordered: volume 6.00, by the faces 6.00, run through twice in one direction 0, V 26, F 48, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0"
