#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# OpenCTM 1.0.3 (openctm-tools 1.0.3+dfsg1-2.1+b3), ctmconv with the methods RAW and MG1, both called lossless.
#
# Guess: a lossless file gives back the mesh as it was.
# What happens: the vertices are in order. MG1 sorts the triangles and begins each with its smallest vertex, to store
# differences; the set of triangles and their orientation are kept, their order is not. RAW keeps the order, too.
#
# Why it matters: results on a mesh name faces by number and points by barycentric coordinates of its three corners in
# order. After a compression that says it is lossless both are wrong, and nothing fails: numbers are in range. The
# command certify here checks that a curve lies on the mesh that it is given with (test Certify.curves_of_others).
. "$(dirname "$0")/lib/packages.sh"
debian openctm-tools=1.0.3+dfsg1-2.1+b3

cd "$work"
cat > round_trip.py << 'END'
import subprocess
import meshes

points, faces = meshes.torus()
meshes.write_off("torus.off", points, faces)
for method in ("RAW", "MG1"):
    for arguments in (["torus.off", "torus.ctm", "--method", method], ["torus.ctm", "again.off"]):
        subprocess.run(["ctmconv"] + arguments, check=True, stdout=subprocess.DEVNULL)
    new_points, new_faces = meshes.read_off("again.off")
    near = max(abs(a - b) for p, q in zip(points, new_points) for a, b in zip(p, q)) < 1e-6
    print("%s: points in order: %s; same triangles up to turning: %s; in the same order: %s" % (
        method, near, meshes.up_to_turning(faces) == meshes.up_to_turning(new_faces),
        [frozenset(f) for f in faces] == [frozenset(f) for f in new_faces]))
END
verdict "$(python3 round_trip.py)" \
"RAW: points in order: True; same triangles up to turning: True; in the same order: True
MG1: points in order: True; same triangles up to turning: True; in the same order: False"
