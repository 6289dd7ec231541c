#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# numpy-stl 2.8.0 (python3-stl 2.9.0-2+b3), Mesh.is_closed().
#
# Guess: a mesh is closed if each edge has two triangles; at least a body without a lid is not.
# What happens: the normals of all triangles, as long as twice the areas, are added up in single precision, and the
# mesh is closed if no coordinate of the sum is 1e-4 or more. The sum is not looked at without its sign: of a cube of
# size 1 that lacks one side, three of the six are called closed, those that lack the side at x = 1, y = 1 or z = 1. A
# tube without both ends is closed, and so is one triangle that looks the right way. The bound has no relation to the
# size: a closed torus 6 long is closed, the same torus 6000 long is not, since its rounding errors are larger.
# get_mass_properties() asks this function whether its volume can be trusted.
#
# Why it matters: tubes without ends, as scanners and segmentations cut them, are where loops are searched for, and
# what lies beyond a border must be known first. The answer has nothing to do with borders, in neither direction.
. "$(dirname "$0")/lib/packages.sh"
debian python3-stl=2.9.0-2+b3

cat > "$work/closed.py" << 'END'
import meshes
import numpy
import stl.__about__
from stl.mesh import Mesh


def is_closed(points, faces):
    data = numpy.zeros(len(faces), dtype=Mesh.dtype)
    data["vectors"] = numpy.array(points)[numpy.array(faces)]
    return Mesh(data).is_closed()


print("version:", stl.__about__.__version__)
corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
sides = {"x = 0": [(0, 1, 3), (0, 3, 2)], "x = 1": [(4, 6, 7), (4, 7, 5)], "y = 0": [(0, 4, 5), (0, 5, 1)],
         "y = 1": [(2, 3, 7), (2, 7, 6)], "z = 0": [(0, 2, 6), (0, 6, 4)], "z = 1": [(1, 5, 7), (1, 7, 3)]}
for lacks in [()] + [(s,) for s in sides] + [("x = 0", "x = 1")]:
    faces = [f for name, side in sides.items() if name not in lacks for f in side]
    print("cube without", " and ".join(lacks) or "nothing", "| closed %s |" % is_closed(corners, faces),
          meshes.describe(faces))
print("one triangle | closed", is_closed(corners, [(0, 1, 3)]))
for size in (1, 1000):
    print("torus %d long | closed" % (6 * size), is_closed(*meshes.torus(scale=size)))
END
verdict "$(/usr/bin/python3 -W ignore "$work/closed.py" 2> "$work/stl.log")" \
"version: 2.8.0
cube without nothing | closed True | V 8, F 12, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
cube without x = 0 | closed False | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without x = 1 | closed True | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without y = 0 | closed False | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without y = 1 | closed True | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without z = 0 | closed False | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without z = 1 | closed True | V 8, F 10, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0
cube without x = 0 and x = 1 | closed True | V 8, F 8, components 1, Euler characteristic 0, border edges 8, non-manifold edges 0
one triangle | closed True
torus 6 long | closed True
torus 6000 long | closed False"
