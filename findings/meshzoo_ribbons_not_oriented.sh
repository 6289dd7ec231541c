#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# meshzoo 0.9.4 (python3-meshzoo 0.9.4-1), moebius(), which makes a ribbon with any number of half twists.
#
# Guess: with one half twist the ribbon cannot be oriented, and along one seam neighbours differ. With none or two it
# can be, and is, as the tube and the spheres of the same library are.
# What happens: whatever the number of twists, a quarter of the triangles is turned against their neighbours, in a
# pattern over the whole ribbon: of 1740 inner edges 870 are run through twice in one direction. With an even number of
# twists those triangles can be turned over and the ribbon is oriented.
#
# Why it matters: ribbons are what one tests orientability and loops with. A halfedge structure refuses these or tears
# them along half of their edges, and a twofold twist, which has two borders, looks like a Moebius strip, which has one.
. "$(dirname "$0")/lib/packages.sh"
debian python3-meshzoo=0.9.4-1

cat > "$work/ribbons.py" << 'END'
import meshes
import meshzoo


def report(name, faces):
    faces = [tuple(map(int, f)) for f in faces]
    at = {}
    for number, f in enumerate(faces):
        for a, b in zip(f, f[1:] + f[:1]):
            at.setdefault(frozenset((a, b)), []).append((number, a < b))
    inner = [places for places in at.values() if len(places) == 2]
    alike = sum(p[1] == q[1] for p, q in inner)
    neighbours = {}
    for p, q in inner:
        neighbours.setdefault(p[0], []).append((q[0], p[1] == q[1]))
        neighbours.setdefault(q[0], []).append((p[0], p[1] == q[1]))
    turned, stack, orientable = {0: False}, [0], True
    while stack:
        i = stack.pop()
        for j, differ in neighbours[i]:
            if j not in turned:
                turned[j] = turned[i] != differ
                stack.append(j)
            orientable = orientable and turned[j] == (turned[i] != differ)
    print("%s: %s; inner edges %d, run through twice in one direction %d; %s" % (
        name, meshes.describe(faces), len(inner), alike,
        "orientable, if %d are turned" % sum(turned.values()) if orientable else "not orientable"))


report("tube", meshzoo.tube(length=1.0, radius=1.0, n=20)[1])
report("sphere", meshzoo.uv_sphere(num_points_per_circle=12, num_circles=7)[1])
for twists in range(4):
    report("half twists %d" % twists, meshzoo.moebius(num_twists=twists, nl=60, nw=11)[1])
END
verdict "$(python3 "$work/ribbons.py")" \
"tube: V 60, F 80, components 1, Euler characteristic 0, border edges 40, non-manifold edges 0; inner edges 100, run through twice in one direction 0; orientable, if 0 are turned
sphere: V 62, F 120, components 1, Euler characteristic 2, border edges 0, non-manifold edges 0; inner edges 180, run through twice in one direction 0; orientable, if 0 are turned
half twists 0: V 660, F 1200, components 1, Euler characteristic 0, border edges 120, non-manifold edges 0; inner edges 1740, run through twice in one direction 870; orientable, if 300 are turned
half twists 1: V 660, F 1200, components 1, Euler characteristic 0, border edges 120, non-manifold edges 0; inner edges 1740, run through twice in one direction 870; not orientable
half twists 2: V 660, F 1200, components 1, Euler characteristic 0, border edges 120, non-manifold edges 0; inner edges 1740, run through twice in one direction 870; orientable, if 300 are turned
half twists 3: V 660, F 1200, components 1, Euler characteristic 0, border edges 120, non-manifold edges 0; inner edges 1740, run through twice in one direction 870; not orientable"
