#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Geomview 1.9.5 (geomview 1.9.5-4+b1), polymerge.
#
# Guess: a program that merges coincident vertices, collinear edges and coplanar faces of an OFF file leaves a round
# surface as it is, and what it does merge stays closed.
# What happens: neighbours are merged if the sine between their normals is below 0.03, and that again and again: a
# torus of 160 000 triangles, which is nowhere flat, becomes 2389 faces. They are no closed surface: there are 18357
# border edges and 1713 components, and of the volume 39.5 they enclose 3.5. A coarse torus of 576 triangles comes
# back closed. Without merging of faces and edges (-F -E) both are unharmed, but a torus 6e-6 long has no vertex left,
# since vertices nearer than 1e-5 are one, whatever the size. There is no message, and the exit code is 1 in each
# case, good or bad.
#
# Why it matters: the finer a mesh is, as one makes it to find necks well, the more of it is lost, and each piece has
# a border that was not there.
. "$(dirname "$0")/lib/packages.sh"
debian geomview=1.9.5-4+b1

cd "$work"
cat > merge.py << 'END'
import subprocess
import meshes


def show(name, points, faces):
    fans = [(f[0], a, b) for f in faces for a, b in zip(f[1:], f[2:])]
    print("%s: %s, volume %.3g" % (name, meshes.describe(faces), meshes.volume(points, fans)))


codes = set()
for around, across, size in ((24, 12, 1.0), (400, 200, 1.0), (24, 12, 1e-6)):
    points, faces = meshes.torus(around, across, scale=size)
    meshes.write_off("torus.off", points, faces)
    show("torus", points, faces)
    for options in ([], ["-F", "-E"]):
        merged = subprocess.run(["polymerge", *options, "torus.off"], capture_output=True, text=True)
        codes.add(merged.returncode)
        with open("merged.off", "w") as out:
            out.write(merged.stdout)
        show(" ".join(["polymerge"] + options), *meshes.read_off("merged.off"))
        if merged.stderr:
            print(merged.stderr)
print("exit codes:", codes)
END
verdict "$(/usr/bin/python3 merge.py)" \
"torus: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 37.3
polymerge: V 288, F 288, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 37.3
polymerge -F -E: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 37.3
torus: V 80000, F 160000, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 39.5
polymerge: V 18844, F 2389, components 1713, Euler characteristic 1713, border edges 18357, non-manifold edges 0, volume 3.46
polymerge -F -E: V 80000, F 160000, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 39.5
torus: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 3.73e-17
polymerge: V 0, F 0, components 0, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 0
polymerge -F -E: V 0, F 0, components 0, Euler characteristic 0, border edges 0, non-manifold edges 0, volume 0
exit codes: {1}"
