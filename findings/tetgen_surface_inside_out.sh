#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# TetGen 1.5.0 (tetgen 1.5.0-5), tetgen -p of a closed surface in OFF; the surface in the .face file.
#
# Guess: the surface comes back as it went in: the same triangles, oriented outwards, each once.
# What happens: vertices and their numbers are kept. The triangles are oriented inwards, all of them: the volume is the
# negative one. And where two triangles lie in one plane, as the two halves of each quadrilateral of a torus of
# revolution, the diagonal may be the other one, since a facet of a polyhedron is triangulated anew: numbers of faces,
# and barycentric coordinates in them, mean nothing in the new file.
#
# Why it matters: a curve that chokes the object chokes the complement after that, if a program believes the
# orientation. This package takes the sign of the volume of each component into account; the same neck comes out on the
# same side.
. "$(dirname "$0")/lib/packages.sh"
debian tetgen=1.5.0-5

cd "$work"
cat > surface.py << 'END'
import subprocess
import meshes

points, faces = meshes.torus()
meshes.write_off("torus.off", points, faces)
subprocess.run(["tetgen", "-pQ", "torus.off"], check=True, stdout=subprocess.DEVNULL)


def table(name):
    rows = [line.split() for line in open(name) if line.strip() and not line.startswith("#")]
    return rows[1:]


new_points = [tuple(map(float, row[1:4])) for row in table("torus.1.node")]
new_faces = [tuple(map(int, row[1:4])) for row in table("torus.1.face")]
print("before:", meshes.describe(faces))
print("after: ", meshes.describe(new_faces))
print("same points in the same order:", new_points == points)
print("volume before %.3f, after %.3f" % (meshes.volume(points, faces), meshes.volume(new_points, new_faces)))
old, new = ({frozenset(f) for f in fs} for fs in (faces, new_faces))
print("triangles of before that are still there: %s" % ("all" if old <= new else "not all"))
END
verdict "$(python3 surface.py)" \
"before: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
after:  V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
same points in the same order: True
volume before 37.270, after -37.270
triangles of before that are still there: not all"
