#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Qhull 2020.2 (qhull-bin 2020.2-5), qconvex, and SciPy 1.10.1 (python3-scipy 1.10.1-2), spatial.ConvexHull, which is
# made with it.
#
# Guess: the facets of a hull, each with its normal that points outwards, are listed in the order that belongs to that
# normal; SciPy gives the same triangles.
# What happens: the facets of "qconvex i" fit to each other, but all face inwards, and so does the OFF file of "qconvex
# o": a cube of side 1 has the volume -1. The triangles of SciPy's "simplices" have no orientation at all, though each
# has its outward normal in "equations": of the 18 edges of the cube 14 are run through twice in one direction, and the
# signed volumes cancel out to 0. Both give the right volume when they are asked for it.
#
# Why it matters: a convex hull is compared with its body to find where that is waisted, and convex pieces are what test
# bodies are put together of. Turned by their normals the triangles are a mesh; as they are a halfedge structure refuses
# those of SciPy, and on those of Qhull outside is inside.
. "$(dirname "$0")/lib/packages.sh"
debian qhull-bin=2020.2-5 python3-scipy=1.10.1-2

cd "$work"
cat > hulls.py << 'END'
import subprocess
import meshes
from scipy.spatial import ConvexHull


def report(name, points, faces, volume):
    directed = [e for f in faces for e in zip(f, f[1:] + f[:1])]
    triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    print("%s: volume %.3f, by the faces %.3f, edges run through twice in one direction %d of %d" % (
        name, volume, meshes.volume(points, triangles) + 0, len(directed) - len(set(directed)),
        len({frozenset(e) for e in directed})))


cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
for body, points in (("cube", cube), ("torus", meshes.torus()[0])):
    hull = ConvexHull(points)
    text = "3\n%d\n" % len(points) + "".join("%r %r %r\n" % tuple(map(float, p)) for p in points)
    lines = subprocess.check_output(["qconvex", "Qt", "i"], input=text, text=True).split("\n")[1:]
    report(body + ", qconvex i", points, [tuple(map(int, line.split())) for line in lines if line], hull.volume)
    with open("hull.off", "w") as out:
        out.write("OFF\n" + subprocess.check_output(["qconvex", "o"], input=text, text=True).split("\n", 1)[1])
    report(body + ", qconvex o", *meshes.read_off("hull.off"), hull.volume)
    report(body + ", SciPy", points, [tuple(map(int, f)) for f in hull.simplices], hull.volume)
END
verdict "$(/usr/bin/python3 hulls.py)" \
"cube, qconvex i: volume 1.000, by the faces -1.000, edges run through twice in one direction 0 of 18
cube, qconvex o: volume 1.000, by the faces -1.000, edges run through twice in one direction 0 of 12
cube, SciPy: volume 1.000, by the faces 0.000, edges run through twice in one direction 14 of 18
torus, qconvex i: volume 47.345, by the faces -47.345, edges run through twice in one direction 0 of 498
torus, qconvex o: volume 47.345, by the faces -47.345, edges run through twice in one direction 0 of 312
torus, SciPy: volume 47.345, by the faces -0.075, edges run through twice in one direction 366 of 498"
