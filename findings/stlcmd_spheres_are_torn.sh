#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# stlcmd 1.1 (stlcmd 1.1-1): stl_sphere, stl_cone, stl_threads and others, and stl_borders, which counts border edges.
#
# Guess: the bodies that the commands make are closed, and stl_borders counts the edges that have one face.
# What happens: cube, cylinder, torus and a cone that is cut off are closed. In a sphere, a cone with a tip and a thread
# the last segment of a turn does not end where the first begins: the coordinates differ in the last digits of a float,
# for the sine of a full turn is not 0. Read by equal places the sphere of 12 segments has 34 border edges: a slit from
# the tip to the south pole, which is twelve points. stl_borders allows for that and counts 0. A mesh that stl_transform
# mirrors faces inwards.
#
# Why it matters: STL has no vertices but equal places, and the checker from the same hand says that all is well. A
# closed curve around such a body cannot cross the slit. Readers that join near places instead close it, and then what
# is thinner than their tolerance too.
. "$(dirname "$0")/lib/packages.sh"
debian stlcmd=1.1-1

cd "$work"
stl_cube -w 1 cube.stl
stl_cylinder -r 1 -h 1 -s 12 cylinder.stl
stl_torus -o 2 -i 1 -s 24 -c 12 torus.stl > torus.log
stl_cone -r 1 -t 0.5 -h 1 -s 12 "cone, cut off.stl"
stl_cone -r 1 -h 1 -s 12 cone.stl
stl_sphere -r 1 -s 12 sphere.stl
stl_threads thread.stl
stl_transform -sx -1 torus.stl "torus, mirrored.stl"
cat > bodies.py << 'END'
import struct
import subprocess
import meshes


def read(name, digits):
    data, number, faces = open(name, "rb").read(), {}, []
    for i in range(struct.unpack_from("<I", data, 80)[0]):
        c = [round(x, digits) + 0.0 for x in struct.unpack_from("<9f", data, 96 + 50 * i)]
        faces.append(tuple(number.setdefault(tuple(c[k:k + 3]), len(number)) for k in (0, 3, 6)))
    return list(number), faces


for name in ("cube", "cylinder", "torus", "torus, mirrored", "cone, cut off", "cone", "sphere", "thread"):
    points, faces = read(name + ".stl", 30)
    borders = subprocess.check_output(["stl_borders", name + ".stl"], text=True).strip()
    print("%s: %s; volume %.2f; stl_borders %s" % (
        name, meshes.describe(faces), meshes.volume(points, faces), borders))
    joined = read(name + ".stl", 4)[1]
    print("  places with four decimals:", meshes.describe([f for f in joined if len(set(f)) == 3]))
END
verdict "$(python3 bodies.py)" \
"cube: V 8, F 12, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; volume 1.00; stl_borders 0
  places with four decimals: V 8, F 12, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
cylinder: V 24, F 44, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; volume 3.00; stl_borders 0
  places with four decimals: V 24, F 44, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
torus: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; volume 6.99; stl_borders 0
  places with four decimals: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
torus, mirrored: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0; volume -6.99; stl_borders 0
  places with four decimals: V 288, F 576, components 1, Euler characteristic 0, border edges 0, non-manifold edges 0
cone, cut off: V 24, F 44, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; volume 1.75; stl_borders 0
  places with four decimals: V 24, F 44, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
cone: V 14, F 22, components 1, Euler characteristic 1, border edges 4, non-manifold edges 0; volume 1.00; stl_borders 0
  places with four decimals: V 13, F 22, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
sphere: V 78, F 120, components 1, Euler characteristic 1, border edges 34, non-manifold edges 0; volume 3.73; stl_borders 0
  places with four decimals: V 62, F 120, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0
thread: V 3222, F 6348, components 1, Euler characteristic -44, border edges 184, non-manifold edges 0; volume 960.87; stl_borders 0
  places with four decimals: V 3176, F 6348, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0"
