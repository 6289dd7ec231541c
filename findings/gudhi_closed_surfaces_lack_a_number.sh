#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GUDHI 3.7.1 (python3-gudhi 3.7.1+dfsg-1+b1), SimplexTree.compute_persistence() and betti_numbers() of surfaces.
#
# Guess: the Betti numbers of a closed surface are 1, 2, 1 for a torus and 1, 0, 1 for a sphere; of the projective
# plane, which has one side, they are 1, 0, 0, or 1, 1, 1 as the usual coefficients are those of a bit.
# What happens: homology in the highest dimension is left out by default. A torus has "[1, 2]", an octahedron "[1, 0]",
# two octahedra "[2, 0]": the number that says that a surface is closed is not there. A sphere, the projective plane and
# a disk have the same numbers. With persistence_dim_max=True they are complete. The coefficients are those modulo 11,
# so that the twist of the projective plane does not show: that takes homology_coeff_field=2.
#
# Why it matters: the numbers tell handles and closed components before one looks for closed curves. With the defaults
# closed or not closed makes no difference, and a surface with one side looks like a disk.
. "$(dirname "$0")/lib/packages.sh"
debian python3-gudhi=3.7.1+dfsg-1+b1
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done

cat > "$work/betti.py" << 'END'
import gudhi
import meshes

octahedron = meshes.octahedron()[1]
surfaces = {
    "torus": meshes.torus()[1], "octahedron": octahedron,
    "two octahedra": octahedron + [tuple(i + 6 for i in f) for f in octahedron],
    "octahedron without a face": octahedron[1:],
    "projective plane": [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1),
                         (1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)]}
for name, faces in surfaces.items():
    tree = gudhi.SimplexTree()
    for f in faces:
        tree.insert(list(f))
    seen = []
    for options in ({}, {"persistence_dim_max": True}, {"persistence_dim_max": True, "homology_coeff_field": 2}):
        tree.compute_persistence(**options)
        seen.append(str(tree.betti_numbers()))
    print("%s: Euler characteristic %s, by default %s, to the highest dimension %s, modulo 2 %s" % (
        name, meshes.describe(faces).split("characteristic ")[1].split(",")[0], *seen))
END
verdict "$(python3 "$work/betti.py")" \
"torus: Euler characteristic 0, by default [1, 2], to the highest dimension [1, 2, 1], modulo 2 [1, 2, 1]
octahedron: Euler characteristic 2, by default [1, 0], to the highest dimension [1, 0, 1], modulo 2 [1, 0, 1]
two octahedra: Euler characteristic 4, by default [2, 0], to the highest dimension [2, 0, 2], modulo 2 [2, 0, 2]
octahedron without a face: Euler characteristic 1, by default [1, 0], to the highest dimension [1, 0, 0], modulo 2 [1, 0, 0]
projective plane: Euler characteristic 1, by default [1, 0], to the highest dimension [1, 0, 0], modulo 2 [1, 1, 1]"
