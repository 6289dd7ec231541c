#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# delaunay-triangulate 1.1.6 (npm), with convex-hull 1.0.3: random points with integer coordinates below 1000.
#
# Guess: the predicates are exact, and so are the squares of the coordinates: triangles and tetrahedra fill the convex
# hull, and two tetrahedra that share a triangle are on its two sides.
# What happens: some overlap and others are missing, in each of six clouds in space, of 300 or 1000 points, and in one
# of two in the plane. There are triangles with both tetrahedra on one side, others with one tetrahedron that are not on
# the hull, and the volumes add up to more than that of the hull, by up to 0.1%, the areas by 0.4%. The hull is right:
# by exact arithmetic no point is beyond a triangle of it. There is no message.
#
# Why it matters: alpha shapes, those of the same author too, are surfaces of such tetrahedra, and have edges with four
# triangles and inner walls then. Sums of volumes, the usual check, are nearly right.
. "$(dirname "$0")/lib/packages.sh"
npm_packages delaunay-triangulate@1.1.6 convex-hull@1.0.3

cd "$work"
cat > triangulate.cjs << 'END'
const convexHull = require('convex-hull');
const triangulate = require('delaunay-triangulate');
const clouds = JSON.parse(require('fs').readFileSync('clouds.json'));
console.log(JSON.stringify(clouds.map(([name, points]) => [name, triangulate(points), convexHull(points)])));
END
cat > clouds.py << 'END'
import json
import subprocess
import meshes

state = 1


def random(n):
    global state
    state = state * 16807 % 2147483647
    return state % n


def cloud(count, sizes, accepted=lambda p: True):
    points = {}
    while len(points) < count:
        p = tuple(random(n) for n in sizes)
        if accepted(p):
            points[p] = None
    return list(points)


def in_disk(p):
    return (p[0] - 500) ** 2 + (p[1] - 500) ** 2 < 250000


def in_ring(p):
    return in_disk(p) and (p[0] - 500) ** 2 + (p[1] - 500) ** 2 > 90000


def side(p, q, r, s):
    """Six times the volume of a tetrahedron, exactly."""
    a, b, c = ([y - x for x, y in zip(p, o)] for o in (q, r, s))
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


clouds = [("square of 1000", cloud(1000, (1000, 1000))), ("flat disk of 1000", cloud(1000, (1000, 1000), in_disk)),
          ("cube of 300", cloud(300, (1000, 1000, 1000))), ("cube of 1000", cloud(1000, (1000, 1000, 1000))),
          ("slab of 300", cloud(300, (1000, 1000, 100))), ("disk of 300", cloud(300, (1000, 1000, 100), in_disk)),
          ("ring of 300", cloud(300, (1000, 1000, 400), in_ring)),
          ("ring of 1000", cloud(1000, (1000, 1000, 400), in_ring))]
with open("clouds.json", "w") as out:
    json.dump(clouds, out)
points_of = dict(clouds)
for name, cells, hull in json.loads(subprocess.check_output(["node", "triangulate.cjs"])):
    points, across = points_of[name], {}
    if len(points[0]) == 2:
        area = sum(abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
                   for p, q, r in ([points[i] for i in c] for c in cells))
        whole = abs(sum(points[a][0] * points[b][1] - points[b][0] * points[a][1] for a, b in hull))
        print("%s: triangles %d, area %.3f%% of the hull" % (name, len(cells), 100 * area / whole))
        continue
    for c in cells:
        for k in range(4):
            across.setdefault(tuple(sorted(c[:k] + c[k + 1:])), []).append(c[k])
    sides = [[side(*(points[i] for i in f), points[k]) for k in o] for f, o in across.items()]
    on_hull = {tuple(sorted(f)) for f in hull}
    beyond = sum(side(*(points[i] for i in f), p) > 0 for f in hull for p in points)
    whole = sum(side((0, 0, 0), *(points[i] for i in f)) for f in hull)
    filled = sum(abs(side(*(points[i] for i in c))) for c in cells)
    print("%s: beyond the hull %d, tetrahedra %d, volume %.3f%%, both on one side %d, one and not on the hull %d" % (
              name, beyond, len(cells), 100 * filled / whole, sum(len(s) == 2 and s[0] * s[1] > 0 for s in sides),
              sum(len(o) == 1 and f not in on_hull for f, o in across.items())))
END
verdict "$(python3 clouds.py)" \
"square of 1000: triangles 1982, area 100.368% of the hull
flat disk of 1000: triangles 1972, area 100.000% of the hull
cube of 300: beyond the hull 0, tetrahedra 1770, volume 100.083%, both on one side 9, one and not on the hull 5
cube of 1000: beyond the hull 0, tetrahedra 6330, volume 100.071%, both on one side 19, one and not on the hull 9
slab of 300: beyond the hull 0, tetrahedra 1728, volume 100.095%, both on one side 8, one and not on the hull 4
disk of 300: beyond the hull 0, tetrahedra 1681, volume 100.006%, both on one side 4, one and not on the hull 4
ring of 300: beyond the hull 0, tetrahedra 1729, volume 100.024%, both on one side 7, one and not on the hull 5
ring of 1000: beyond the hull 0, tetrahedra 6184, volume 100.010%, both on one side 24, one and not on the hull 20"
